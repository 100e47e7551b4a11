// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the page, as the style sheet has them, and the scale that fills triangles.

export interface Palette {
  paper: string;
  ink: string;
  mesh: string;
  u: string;
  v: string;
  checker: string;
  net: string;
  exceptional: string;
  feature: string;
  relaxed: string;
  hover: string;
  halo: string;
  scale: string[];
}

const kNames = ["paper", "ink", "mesh", "u", "v", "checker", "net", "exceptional", "feature", "relaxed", "hover", "halo"] as const;

/** Reads the custom properties --paper, …, --scale (a list) of the document. */
export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const value = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const palette = { scale: value("scale").split(/\s+/) } as Palette;
  for (const name of kNames) palette[name] = value(name);
  return palette;
}

export const kSteps = 24;

/** The colour at `share` of 0 … 1 of a list of #rrggbb. */
export function mixScale(stops: string[], share: number): string {
  const at = Math.min(1, Math.max(0, share)) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
  const channel = (stop: string, c: number) => parseInt(stop.slice(1 + 2 * c, 3 + 2 * c), 16);
  const mixed = [0, 1, 2].map((c) => Math.round(channel(stops[k], c) + (at - k) * (channel(stops[k + 1], c) - channel(stops[k], c))));
  return `rgb(${mixed.join(",")})`;
}

/** Values to steps 0 … kSteps - 1 by logarithm. */
export interface Scale {
  low: number;
  high: number;
}

export function stepOf(scale: Scale, value: number): number {
  if (!(value > scale.low)) return 0;
  if (!(value < scale.high)) return kSteps - 1;
  return Math.floor((kSteps * Math.log(value / scale.low)) / Math.log(scale.high / scale.low));
}

/** From 2, the least possible, to the largest finite g. */
export function distortionScale(values: Float64Array): Scale {
  let high = 2;
  for (const g of values) if (Number.isFinite(g) && g > high) high = g;
  return { low: 2, high: Math.max(high, 2.5) };
}

/** From 1e-17 or the least value that is not zero to the largest, over whole powers of ten. */
export function deviationScale(values: Float64Array): Scale {
  let low = Infinity, high = 0;
  for (const d of values) {
    if (d > 0) low = Math.min(low, d);
    high = Math.max(high, d);
  }
  if (high === 0) return { low: 1e-17, high: 1e-16 };
  const floor = 10 ** Math.floor(Math.log10(Math.max(low, 1e-17))), top = 10 ** Math.ceil(Math.log10(high));
  return { low: floor, high: Math.max(top, 10 * floor) };
}
