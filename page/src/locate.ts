// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of the map at s: which triangle covers a point, and at which place. A grid of
// bounding boxes finds candidates, Newton's method the place.
import { Barycentric, Local, evaluateNet } from "./bernstein";
import { Blend } from "./blend";

export interface Place {
  triangle: number;
  at: Barycentric;
}

/** How far outside of a triangle a place may be by rounding. */
const kOutside = 1e-9;
/** Largest distance from the point, of an extent of 1, to be accepted. */
const kResidue = 1e-11;

export class Locator {
  private readonly boxes: Float64Array;
  private readonly starts: Int32Array;
  private readonly items: Int32Array;
  private readonly columns: number;
  private readonly rows: number;
  private readonly low: [number, number] = [Infinity, Infinity];
  private readonly high: [number, number] = [-Infinity, -Infinity];
  private readonly net: Float64Array;
  private readonly local: Local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };

  constructor(private readonly blend: Blend, readonly s: number) {
    const count = blend.model.triangleCount;
    this.net = new Float64Array(2 * blend.model.netSize);
    this.boxes = new Float64Array(4 * count);
    for (let t = 0; t < count; ++t) this.addBox(t);
    const side = Math.max(1, Math.ceil(Math.sqrt(2 * count)));
    this.columns = this.rows = Math.min(side, 512);
    this.starts = new Int32Array(this.columns * this.rows + 1);
    this.eachCell((_, cell) => ++this.starts[cell + 1]);
    for (let k = 0; k < this.columns * this.rows; ++k) this.starts[k + 1] += this.starts[k];
    this.items = new Int32Array(this.starts[this.columns * this.rows]);
    const next = this.starts.slice();
    this.eachCell((t, cell) => (this.items[next[cell]++] = t));
  }

  /** The place at (x, y) of the normalised plane; null if no triangle covers it. */
  find(x: number, y: number): Place | null {
    if (!(x >= this.low[0] && x <= this.high[0] && y >= this.low[1] && y <= this.high[1])) return null;
    const cell = this.row(y) * this.columns + this.column(x), b = this.boxes;
    for (let k = this.starts[cell]; k < this.starts[cell + 1]; ++k) {
      const t = this.items[k];
      if (x < b[4 * t] || y < b[4 * t + 1] || x > b[4 * t + 2] || y > b[4 * t + 3]) continue;
      const at = this.invert(t, x, y);
      if (at) return { triangle: t, at };
    }
    return null;
  }

  /** The place of triangle t at (x, y), or null if there is none. */
  invert(t: number, x: number, y: number): Barycentric | null {
    this.blend.netAt(t, this.s, this.net);
    for (const [s0, t0] of this.startsNear(x, y)) {
      const at = this.newton(x, y, s0, t0);
      if (at) return at;
    }
    return null;
  }

  // Lattice places, the nearest first: Newton's method from all of them before the answer is no
  // would be slow where boxes overlap, and a regular triangle needs one of the nearest.
  private startsNear(x: number, y: number): [number, number][] {
    const n = this.blend.model.degree, cuts = 4, places: [number, number, number][] = [];
    for (let j = 0; j <= cuts; ++j)
      for (let i = 0; i <= cuts - j; ++i) {
        const s0 = i / cuts, t0 = j / cuts;
        evaluateNet(n, this.net, 1 - s0 - t0, s0, t0, this.local);
        places.push([Math.hypot(this.local.x - x, this.local.y - y), s0, t0]);
      }
    places.sort((p, q) => p[0] - q[0]);
    return places.slice(0, 4).map(([, s0, t0]) => [s0, t0]);
  }

  private newton(x: number, y: number, s: number, t: number): Barycentric | null {
    const n = this.blend.model.degree, p = this.local;
    evaluateNet(n, this.net, 1 - s - t, s, t, p);
    let residue = Math.hypot(p.x - x, p.y - y);
    for (let k = 0; k < 40 && residue > 0; ++k) {
      const det = p.xs * p.yt - p.ys * p.xt;
      if (det === 0) break;
      const rx = x - p.x, ry = y - p.y;
      const ds = (rx * p.yt - ry * p.xt) / det, dt = (p.xs * ry - p.ys * rx) / det;
      let step = 1, better = false;
      for (; step > 1e-3 && !better; step /= 2) {
        evaluateNet(n, this.net, 1 - s - t - step * (ds + dt), s + step * ds, t + step * dt, p);
        const next = Math.hypot(p.x - x, p.y - y);
        if (!(next < residue)) continue;
        better = true;
        s += step * ds;
        t += step * dt;
        residue = next;
      }
      if (!better) break;
      if (s < -1 || t < -1 || s + t > 2) return null;
    }
    const inside = s >= -kOutside && t >= -kOutside && s + t <= 1 + kOutside;
    return inside && residue <= kResidue ? [1 - s - t, s, t] : null;
  }

  private addBox(t: number): void {
    this.blend.netAt(t, this.s, this.net);
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < this.net.length; k += 2)
      for (let axis = 0; axis < 2; ++axis) {
        box[axis] = Math.min(box[axis], this.net[k + axis]);
        box[2 + axis] = Math.max(box[2 + axis], this.net[k + axis]);
      }
    for (let axis = 0; axis < 2; ++axis) {
      this.low[axis] = Math.min(this.low[axis], box[axis]);
      this.high[axis] = Math.max(this.high[axis], box[2 + axis]);
    }
    this.boxes.set(box, 4 * t);
  }

  private column(x: number): number {
    const at = ((x - this.low[0]) / (this.high[0] - this.low[0] || 1)) * this.columns;
    return Math.min(this.columns - 1, Math.max(0, Math.floor(at)));
  }
  private row(y: number): number {
    const at = ((y - this.low[1]) / (this.high[1] - this.low[1] || 1)) * this.rows;
    return Math.min(this.rows - 1, Math.max(0, Math.floor(at)));
  }

  private eachCell(visit: (t: number, cell: number) => void): void {
    const b = this.boxes;
    for (let t = 0; 4 * t < b.length; ++t)
      for (let row = this.row(b[4 * t + 1]); row <= this.row(b[4 * t + 3]); ++row)
        for (let column = this.column(b[4 * t]); column <= this.column(b[4 * t + 2]); ++column)
          visit(t, row * this.columns + column);
  }

  /** low x, low y, high x, high y of the control points of each triangle. */
  get boundingBoxes(): Float64Array {
    return this.boxes;
  }
}
