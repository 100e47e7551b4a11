// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours of the triangles mean.
import { Palette, Scale, kSteps, mixScale } from "./colour";
import { Colouring, Painter } from "./paint";
import { byId, element, powerOfTen, readable } from "./text";

/** Values at the ticks of a scale: its ends and the powers of ten between, or the middle. */
export function ticks(scale: Scale): number[] {
  const out = [scale.low], decades = Math.log10(scale.high / scale.low), every = Math.max(1, Math.ceil(decades / 4));
  for (let k = Math.floor(Math.log10(scale.low)) + 1; 10 ** k < scale.high; ++k) {
    const share = Math.log(10 ** k / scale.low) / Math.log(scale.high / scale.low);
    if (k % every === 0 && share > 0.15 && share < 0.78) out.push(10 ** k);
  }
  if (out.length === 1) out.push(Math.sqrt(scale.low * scale.high));
  return [...out, scale.high];
}

const kTitles = {
  distortion: "g of the triangle, from 2 (similarity)",
  deviation: "largest d_ei of the triangle's edges, relative to the extent",
};

export function showLegend(painter: Painter, colouring: Colouring, palette: Palette): void {
  const legend = byId("legend");
  legend.hidden = colouring === "none";
  if (colouring === "none") return;
  const scale = painter.scales[colouring], bar = element("div", "", { class: "bar" });
  const steps = Array.from({ length: kSteps }, (_, k) => mixScale(palette.scale, k / (kSteps - 1)));
  bar.style.background = `linear-gradient(to right, ${steps.map((c, k) => `${c} ${(100 * k) / kSteps}% ${(100 * (k + 1)) / kSteps}%`).join(", ")})`;
  const labels = element("div", "", { class: "ticks" });
  for (const value of ticks(scale)) {
    // Deviations are read by their power of ten.
    if (colouring === "deviation" && Math.abs(Math.log10(value) % 1) > 1e-6) continue;
    const label = element("span", colouring === "deviation" ? powerOfTen(value) : readable(value, 3));
    label.style.left = `${(100 * Math.log(value / scale.low)) / Math.log(scale.high / scale.low)}%`;
    labels.append(label);
  }
  legend.replaceChildren(bar, labels, element("p", kTitles[colouring]));
}
