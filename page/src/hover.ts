// SPDX-License-Identifier: GPL-3.0-or-later
// The point under the pointer on both sides: its triangle, the images of its horizontal and vertical
// line, and the ellipse that the Jacobian makes of a circle.
import { Blend } from "./blend";
import { Palette } from "./colour";
import { Outside, View, trace } from "./curves";
import { wholeLine } from "./lines";
import { Sample, sample } from "./mesh";
import { Place } from "./locate";
import { Scene } from "./scene";

export interface Hover {
  sample: Sample;
  outline: Float64Array;
  /** Through the point: along v (u = constant), and along u. */
  lines: [Float64Array, Float64Array];
}

export function hoverAt(scene: Scene, place: Place): Hover {
  const point = sample(scene.model, place.triangle, place.at);
  return {
    sample: point,
    outline: scene.triangle(place.triangle),
    lines: [
      scene.curvesOf(wholeLine(scene.model, 0, point.u)),
      scene.curvesOf(wholeLine(scene.model, 1, point.v)),
    ],
  };
}

/** Of the circle in the domain, and of the ellipse of the same area, in pixels. */
const kRadius = 26;
const kLongestAxis = 96;

/** d/du, d/dv of the normalised map at s, scaled so that a unit circle becomes an ellipse in pixels. */
export function ellipseAxes(blend: Blend, point: Sample, s: number): [number, number, number, number] {
  const { model } = blend, { ar, ai, br, bi } = blend.mix(s);
  const [a, b, c, d] = point.jacobian.map((x) => (x * model.domainFrame.extent) / model.shapeFrame.extent);
  const m = [ar * a - ai * b + br, ai * a + ar * b + bi, ar * c - ai * d - bi, ai * c + ar * d + br];
  const det = m[0] * m[3] - m[1] * m[2];
  // The longer half axis: the largest singular value.
  const norm = m.reduce((sum, x) => sum + x * x, 0);
  const longest = Math.sqrt((norm + Math.sqrt(Math.max(0, norm * norm - 4 * det * det))) / 2);
  const factor = Math.min(det > 0 ? kRadius / Math.sqrt(det) : Infinity, kLongestAxis / longest);
  return m.map((x) => x * factor) as [number, number, number, number];
}

export function paintHover(c: CanvasRenderingContext2D, scene: Scene, hover: Hover, view: View, s: number,
                           palette: Palette): void {
  const { blend } = scene, { triangle, at } = hover.sample;
  c.lineJoin = "round";
  c.beginPath();
  trace(c, hover.outline, blend.mix(s), view, Outside.chords);
  c.globalAlpha = 0.14;
  c.fillStyle = palette.hover;
  c.fill();
  c.globalAlpha = 1;
  c.strokeStyle = palette.hover;
  c.lineWidth = 1.5;
  c.stroke();
  hover.lines.forEach((curves, axis) => strokeOver(c, palette.halo, axis === 0 ? palette.u : palette.v, 2, () =>
    trace(c, curves, blend.mix(s), view, Outside.left)));
  const local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
  blend.evaluate(triangle, s, at, local);
  const x = view.ox + view.scale * local.x, y = view.oy - view.scale * local.y;
  paintEllipse(c, x, y, ellipseAxes(blend, hover.sample, s), palette);
  c.beginPath();
  c.arc(x, y, 4, 0, 2 * Math.PI);
  c.fillStyle = palette.hover;
  c.strokeStyle = palette.halo;
  c.lineWidth = 1.5;
  c.fill();
  c.stroke();
}

function strokeOver(c: CanvasRenderingContext2D, halo: string, colour: string, width: number, path: () => void): void {
  c.beginPath();
  path();
  c.strokeStyle = halo;
  c.lineWidth = width + 2;
  c.stroke();
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.stroke();
}

function paintEllipse(c: CanvasRenderingContext2D, x: number, y: number, m: [number, number, number, number],
                      palette: Palette): void {
  const steps = 72;
  strokeOver(c, palette.halo, palette.hover, 1.5, () => {
    for (let k = 0; k <= steps; ++k) {
      const p = Math.cos((2 * Math.PI * k) / steps), q = Math.sin((2 * Math.PI * k) / steps);
      const px = x + m[0] * p + m[2] * q, py = y - m[1] * p - m[3] * q;
      if (k === 0) c.moveTo(px, py);
      else c.lineTo(px, py);
    }
  });
}
