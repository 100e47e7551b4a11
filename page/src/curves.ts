// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn: cubic curves that know where they are on the shape and in the domain, and how
// they become a path, at any s (blend.ts) and any magnification.
import { Barycentric, segment } from "./bernstein";
import { Blend, Mix } from "./blend";

/** A path, such as a canvas context. */
export interface Pen {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  bezierCurveTo(ax: number, ay: number, bx: number, by: number, x: number, y: number): void;
}

/** From the normalised plane to pixels: (ox + scale x, oy - scale y), seen in 0 … width, 0 … height. */
export interface View {
  ox: number;
  oy: number;
  scale: number;
  width: number;
  height: number;
}

/** Numbers of a cubic: its control points on the shape and in the domain. */
const kStride = 16;
/** Parts of a curve of degree above 3; each is a cubic of the same ends and end derivatives. */
const kParts = 4;
/** A curve this close to its chord, in pixels, is drawn straight. */
const kFlat = 0.15;
/** Longer curves are halved before the canvas, which has single precision, sees them. */
const kLongest = 8000;

export class CurveBuilder {
  private data: number[] = [];
  private readonly net: Float64Array;
  private readonly raised: [Float64Array, Float64Array];

  constructor(private readonly blend: Blend) {
    const n = blend.model.degree;
    this.net = new Float64Array(2 * blend.model.netSize);
    this.raised = [new Float64Array(2 * n + 2), new Float64Array(2 * n + 2)];
  }

  /** Appends the straight segment of triangle t and its image. */
  add(t: number, from: Barycentric, to: Barycentric): void {
    const n = this.blend.model.degree, [shape, domain] = this.raised;
    this.blend.netAt(t, 1, this.net);
    segment(n, this.net, from, to, shape);
    this.blend.netAt(t, 0, this.net);
    segment(n, this.net, from, to, domain);
    const parts = n > 3 ? kParts : 1;
    for (let part = 0; part < parts; ++part) {
      pushCubic(this.data, shape, n, part / parts, (part + 1) / parts);
      pushCubic(this.data, domain, n, part / parts, (part + 1) / parts);
    }
  }

  take(): Float64Array {
    const out = Float64Array.from(this.data);
    this.data = [];
    return out;
  }
}

function pushCubic(data: number[], p: Float64Array, n: number, from: number, to: number): void {
  if (n === 3) {
    for (let k = 0; k < 8; ++k) data.push(p[k]);
    return;
  }
  // Exact below degree 3, else Hermite's.
  const third = (to - from) / 3, a = curvePoint(p, n, from), b = curvePoint(p, n, to);
  data.push(a.x, a.y, a.x + third * a.dx, a.y + third * a.dy);
  data.push(b.x - third * b.dx, b.y - third * b.dy, b.x, b.y);
}

function curvePoint(poles: Float64Array, n: number, at: number): { x: number; y: number; dx: number; dy: number } {
  const p = poles.slice();
  if (at === 1) return { x: p[2 * n], y: p[2 * n + 1], dx: n * (p[2 * n] - p[2 * n - 2]), dy: n * (p[2 * n + 1] - p[2 * n - 1]) };
  for (let degree = n; degree > 1; --degree)
    for (let k = 0; k < 2 * degree; ++k) p[k] += at * (p[k + 2] - p[k]);
  const dx = p[2] - p[0], dy = p[3] - p[1];
  return { x: p[0] + at * dx, y: p[1] + at * dy, dx: n * dx, dy: n * dy };
}

/** What becomes of curves outside of the view. */
export const enum Outside { left, chords }

/**
 * Adds the curves to a path. Those that follow one another are joined; with `Outside.chords` (for
 * filling) none is left out.
 */
export function trace(pen: Pen, curves: Float64Array, mix: Mix, view: View, outside: Outside): void {
  const { ox, oy, scale } = view, { ar, ai, br, bi } = mix;
  let endX = NaN, endY = NaN;
  for (let k = 0; k < curves.length; k += kStride) {
    const ax = ox + scale * (ar * curves[k] - ai * curves[k + 1] + br * curves[k + 8] - bi * curves[k + 9]);
    const ay = oy - scale * (ai * curves[k] + ar * curves[k + 1] + bi * curves[k + 8] + br * curves[k + 9]);
    const bx = ox + scale * (ar * curves[k + 2] - ai * curves[k + 3] + br * curves[k + 10] - bi * curves[k + 11]);
    const by = oy - scale * (ai * curves[k + 2] + ar * curves[k + 3] + bi * curves[k + 10] + br * curves[k + 11]);
    const cx = ox + scale * (ar * curves[k + 4] - ai * curves[k + 5] + br * curves[k + 12] - bi * curves[k + 13]);
    const cy = oy - scale * (ai * curves[k + 4] + ar * curves[k + 5] + bi * curves[k + 12] + br * curves[k + 13]);
    const dx = ox + scale * (ar * curves[k + 6] - ai * curves[k + 7] + br * curves[k + 14] - bi * curves[k + 15]);
    const dy = oy - scale * (ai * curves[k + 6] + ar * curves[k + 7] + bi * curves[k + 14] + br * curves[k + 15]);
    const hidden = isHidden(view, ax, ay, bx, by, cx, cy, dx, dy);
    if (hidden && outside === Outside.left) {
      endX = NaN;
      continue;
    }
    if (ax !== endX || ay !== endY) pen.moveTo(ax, ay);
    emit(pen, view, ax, ay, bx, by, cx, cy, dx, dy, 0);
    endX = dx;
    endY = dy;
  }
}

const kMargin = 8;

function isHidden(view: View, ax: number, ay: number, bx: number, by: number, cx: number, cy: number,
                  dx: number, dy: number): boolean {
  const w = view.width + kMargin, h = view.height + kMargin, l = -kMargin;
  return (ax < l && bx < l && cx < l && dx < l) || (ax > w && bx > w && cx > w && dx > w) ||
         (ay < l && by < l && cy < l && dy < l) || (ay > h && by > h && cy > h && dy > h);
}

function emit(pen: Pen, view: View, ax: number, ay: number, bx: number, by: number, cx: number, cy: number,
              dx: number, dy: number, depth: number): void {
  const ux = dx - ax, uy = dy - ay;
  // Control points off the thirds of the chord bound the distance of the curve from it.
  const off = Math.max(Math.abs(3 * (bx - ax) - ux), Math.abs(3 * (by - ay) - uy),
                       Math.abs(3 * (cx - ax) - 2 * ux), Math.abs(3 * (cy - ay) - 2 * uy));
  const long = Math.abs(ux) + Math.abs(uy) > kLongest || off > 3 * kLongest;
  if (long && isHidden(view, ax, ay, bx, by, cx, cy, dx, dy)) return pen.lineTo(dx, dy);
  if (long && depth < 24) {
    const abx = (ax + bx) / 2, aby = (ay + by) / 2, bcx = (bx + cx) / 2, bcy = (by + cy) / 2;
    const cdx = (cx + dx) / 2, cdy = (cy + dy) / 2, abcx = (abx + bcx) / 2, abcy = (aby + bcy) / 2;
    const bcdx = (bcx + cdx) / 2, bcdy = (bcy + cdy) / 2, mx = (abcx + bcdx) / 2, my = (abcy + bcdy) / 2;
    emit(pen, view, ax, ay, abx, aby, abcx, abcy, mx, my, depth + 1);
    return emit(pen, view, mx, my, bcdx, bcdy, cdx, cdy, dx, dy, depth + 1);
  }
  if (off < 3 * kFlat) pen.lineTo(dx, dy);
  else pen.bezierCurveTo(bx, by, cx, cy, dx, dy);
}
