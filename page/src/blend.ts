// SPDX-License-Identifier: GPL-3.0-or-later
// Both planes in one normalised frame: centre 0, extent 1. At s = 1 a triangle is the shape's, at
// s = 0 the domain's linear map raised to degree n; between, its control points are interpolated.
import { Barycentric, Local, evaluateNet } from "./bernstein";
import { Frame, Model } from "./data";

export function toUnit(frame: Frame, x: number, y: number): [number, number] {
  return [(x - frame.x) / frame.extent, (y - frame.y) / frame.extent];
}

export function fromUnit(frame: Frame, x: number, y: number): [number, number] {
  return [frame.x + x * frame.extent, frame.y + y * frame.extent];
}

export class Blend {
  /** Sides of the bounding boxes at s = 1 and 0. */
  readonly shapeSize: [number, number];
  readonly domainSize: [number, number];
  private readonly points: Float64Array;
  private readonly domain: Float64Array;
  private readonly lattice: Float64Array;
  private readonly net: Float64Array;

  constructor(readonly model: Model) {
    const n = model.degree;
    this.points = normalised(model.shapeFrame, model.points);
    this.domain = normalised(model.domainFrame, model.domain);
    this.shapeSize = [model.shapeFrame.width, model.shapeFrame.height];
    this.domainSize = [model.domainFrame.width, model.domainFrame.height];
    this.net = new Float64Array(2 * model.netSize);
    const lattice: number[] = [];
    for (let j = 0; j <= n; ++j)
      for (let i = 0; i <= n - j; ++i) lattice.push((n - i - j) / n, i / n, j / n);
    this.lattice = Float64Array.from(lattice);
  }

  /** The normalised control points of triangle t at s. */
  netAt(t: number, s: number, out: Float64Array): void {
    const { netSize, nets, triangles } = this.model, { points, domain, lattice } = this;
    const a = 2 * triangles[3 * t], b = 2 * triangles[3 * t + 1], c = 2 * triangles[3 * t + 2];
    const ax = domain[a], ay = domain[a + 1], bx = domain[b], by = domain[b + 1];
    const cx = domain[c], cy = domain[c + 1], r = 1 - s;
    for (let k = 0; k < netSize; ++k) {
      const id = 2 * nets[t * netSize + k];
      const l0 = lattice[3 * k], l1 = lattice[3 * k + 1], l2 = lattice[3 * k + 2];
      out[2 * k] = s * points[id] + r * (l0 * ax + l1 * bx + l2 * cx);
      out[2 * k + 1] = s * points[id + 1] + r * (l0 * ay + l1 * by + l2 * cy);
    }
  }

  /** Where a place of triangle t is at s, with its derivatives along the sides. */
  evaluate(t: number, s: number, at: Barycentric, out: Local): void {
    this.netAt(t, s, this.net);
    evaluateNet(this.model.degree, this.net, at[0], at[1], at[2], out);
  }

  /** The size of the bounding box between those of domain and shape. */
  sizeAt(s: number): [number, number] {
    return [
      s * this.shapeSize[0] + (1 - s) * this.domainSize[0],
      s * this.shapeSize[1] + (1 - s) * this.domainSize[1],
    ];
  }
}

function normalised(frame: Frame, points: Float64Array): Float64Array {
  const out = new Float64Array(points.length);
  for (let k = 0; k < points.length; k += 2) [out[k], out[k + 1]] = toUnit(frame, points[k], points[k + 1]);
  return out;
}
