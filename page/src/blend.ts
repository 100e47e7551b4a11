// SPDX-License-Identifier: GPL-3.0-or-later
// Both planes in one normalised frame: centre 0, extent 1. At s = 1 a triangle is the shape's, at
// s = 0 the domain's linear map raised to degree n; between, its control points are interpolated
// linearly, in a frame that turns: a domain may lie turned against its shape, and without that
// everything would shrink to nothing half way.
import { Barycentric, Local, evaluateNet } from "./bernstein";
import { Frame, Model } from "./data";

export function toUnit(frame: Frame, x: number, y: number): [number, number] {
  return [(x - frame.x) / frame.extent, (y - frame.y) / frame.extent];
}

export function fromUnit(frame: Frame, x: number, y: number): [number, number] {
  return [frame.x + x * frame.extent, frame.y + y * frame.extent];
}

/** A point at s is the complex number a S + b D, S on the shape and D in the domain. */
export interface Mix {
  ar: number;
  ai: number;
  br: number;
  bi: number;
}

export class Blend {
  /** Radians by which the domain is to be turned to lie as the shape does. */
  readonly turn: number;
  /** Sides of the bounding boxes at s = 1 and 0. */
  readonly shapeSize: [number, number];
  readonly domainSize: [number, number];
  private readonly points: Float64Array;
  private readonly domain: Float64Array;
  private readonly lattice: Float64Array;
  private readonly net: Float64Array;
  /** x, y of the vertices on the shape. */
  private readonly places: Float64Array;
  private last: { s: number; mix: Mix } = { s: 1, mix: { ar: 1, ai: 0, br: 0, bi: 0 } };

  constructor(readonly model: Model) {
    const n = model.degree;
    this.points = normalised(model.shapeFrame, model.points);
    this.domain = normalised(model.domainFrame, model.domain);
    this.shapeSize = [model.shapeFrame.width, model.shapeFrame.height];
    this.domainSize = [model.domainFrame.width, model.domainFrame.height];
    this.net = new Float64Array(2 * model.netSize);
    this.places = this.shapePlaces();
    this.turn = this.bestTurn();
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
    const cx = domain[c], cy = domain[c + 1], { ar, ai, br, bi } = this.mix(s);
    for (let k = 0; k < netSize; ++k) {
      const id = 2 * nets[t * netSize + k];
      const l0 = lattice[3 * k], l1 = lattice[3 * k + 1], l2 = lattice[3 * k + 2];
      const x = points[id], y = points[id + 1];
      const u = l0 * ax + l1 * bx + l2 * cx, v = l0 * ay + l1 * by + l2 * cy;
      out[2 * k] = ar * x - ai * y + br * u - bi * v;
      out[2 * k + 1] = ai * x + ar * y + bi * u + br * v;
    }
  }

  /** Where a place of triangle t is at s, with its derivatives along the sides. */
  evaluate(t: number, s: number, at: Barycentric, out: Local): void {
    this.netAt(t, s, this.net);
    evaluateNet(this.model.degree, this.net, at[0], at[1], at[2], out);
  }

  /** (1 - s) of the domain, turned by s turn, and s of the shape, turned back by (1 - s) turn. */
  mix(s: number): Mix {
    if (this.last.s !== s) {
      const a = (s - 1) * this.turn, b = s * this.turn;
      const mix = { ar: s * Math.cos(a), ai: s * Math.sin(a), br: (1 - s) * Math.cos(b), bi: (1 - s) * Math.sin(b) };
      this.last = { s, mix };
    }
    return this.last.mix;
  }

  /** The sides of a box around everything at s: between those of domain and shape, or more. */
  sizeAt(s: number): [number, number] {
    const size: [number, number] = [0, 1].map((k) => s * this.shapeSize[k] + (1 - s) * this.domainSize[k]) as [number, number];
    if (s === 0 || s === 1) return size;
    const { ar, ai, br, bi } = this.mix(s), { places, domain } = this;
    for (let k = 0; k < places.length; k += 2) {
      const x = ar * places[k] - ai * places[k + 1] + br * domain[k] - bi * domain[k + 1];
      const y = ai * places[k] + ar * places[k + 1] + bi * domain[k] + br * domain[k + 1];
      size[0] = Math.max(size[0], 2 * Math.abs(x));
      size[1] = Math.max(size[1], 2 * Math.abs(y));
    }
    return size;
  }

  private shapePlaces(): Float64Array {
    const { triangles, nets, netSize, degree, vertexCount } = this.model, out = new Float64Array(2 * vertexCount);
    const corner = [0, degree, netSize - 1];
    triangles.forEach((v, k) => {
      const id = nets[Math.floor(k / 3) * netSize + corner[k % 3]];
      out[2 * v] = this.points[2 * id];
      out[2 * v + 1] = this.points[2 * id + 1];
    });
    return out;
  }

  // Least squares over the vertices: the argument of the sum of conj(D) S, both about their means.
  private bestTurn(): number {
    const { places, domain } = this, count = Math.max(1, domain.length / 2), mean = [0, 0, 0, 0];
    for (let k = 0; k < domain.length; k += 2)
      [places[k], places[k + 1], domain[k], domain[k + 1]].forEach((x, c) => (mean[c] += x / count));
    let real = 0, imaginary = 0;
    for (let k = 0; k < domain.length; k += 2) {
      const x = places[k] - mean[0], y = places[k + 1] - mean[1], u = domain[k] - mean[2], v = domain[k + 1] - mean[3];
      real += u * x + v * y;
      imaginary += u * y - v * x;
    }
    return Math.atan2(imaginary, real);
  }
}

function normalised(frame: Frame, points: Float64Array): Float64Array {
  const out = new Float64Array(points.length);
  for (let k = 0; k < points.length; k += 2) [out[k], out[k + 1]] = toUnit(frame, points[k], points[k + 1]);
  return out;
}
