// SPDX-License-Identifier: GPL-3.0-or-later
// Iso-curves and checkerboard: lines and squares of the domain, cut at the triangles.
import { Barycentric } from "./bernstein";
import { Model } from "./data";
import { cornersOf } from "./mesh";

/** A straight piece inside a triangle. */
export interface Piece {
  triangle: number;
  from: Barycentric;
  to: Barycentric;
}

/** Evenly spaced lines u = origin.u + k spacing, v = origin.v + k spacing, for all integers k. */
export interface Grid {
  u: number;
  v: number;
  spacing: number;
}

const kLines = 24;

/**
 * The grid of `level`: at level 0 there are 24 lines over the domain's longer side, half a spacing
 * away from it; each level has three times as many, among them those of the level before.
 */
export function gridOf(model: Model, level: number): Grid {
  const f = model.domainFrame, first = f.extent / kLines;
  return {
    u: f.x - (f.width * f.extent) / 2 + first / 2,
    v: f.y - (f.height * f.extent) / 2 + first / 2,
    spacing: first / 3 ** level,
  };
}

function mix(p: Barycentric, q: Barycentric, at: number): Barycentric {
  return [p[0] + at * (q[0] - p[0]), p[1] + at * (q[1] - p[1]), p[2] + at * (q[2] - p[2])];
}

/** A straight part of a triangle: three places, and u, v there. */
export interface Part {
  triangle: number;
  places: readonly [Barycentric, Barycentric, Barycentric];
  corners: number[];
}

export function wholeTriangle(model: Model, t: number): Part {
  return { triangle: t, places: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], corners: cornersOf(model, t) };
}

/** The four halves of a part. */
export function quarters(part: Part): Part[] {
  const [p, q, r] = part.places, [pu, pv, qu, qv, ru, rv] = part.corners;
  const pq = mix(p, q, 0.5), qr = mix(q, r, 0.5), rp = mix(r, p, 0.5);
  const half = (a: number, b: number) => (a + b) / 2, triangle = part.triangle;
  const pqc = [half(pu, qu), half(pv, qv)], qrc = [half(qu, ru), half(qv, rv)], rpc = [half(ru, pu), half(rv, pv)];
  return [
    { triangle, places: [p, pq, rp], corners: [pu, pv, ...pqc, ...rpc] },
    { triangle, places: [pq, q, qr], corners: [...pqc, qu, qv, ...qrc] },
    { triangle, places: [rp, qr, r], corners: [...rpc, ...qrc, ru, rv] },
    { triangle, places: [pq, qr, rp], corners: [...pqc, ...qrc, ...rpc] },
  ];
}

/** How many lines of the grid cross a part, at most. */
export function lineCount(part: Part, grid: Grid): number {
  const [a, b, c, d, e, f] = part.corners;
  const side = Math.max(Math.max(a, c, e) - Math.min(a, c, e), Math.max(b, d, f) - Math.min(b, d, f));
  return side / grid.spacing;
}

/** The part of the line u = value (axis 0) or v = value (axis 1) in a part of a triangle. */
export function chord(part: Part, axis: number, value: number): [Barycentric, Barycentric] | null {
  const ends: Barycentric[] = [], { corners, places } = part;
  for (let k = 0; k < 3; ++k) {
    const next = (k + 1) % 3, a = corners[2 * k + axis] - value, b = corners[2 * next + axis] - value;
    // A corner on the line belongs to the upper side, so each line enters and leaves once.
    if (a < 0 !== b < 0) ends.push(mix(places[k], places[next], a / (a - b)));
  }
  return ends.length === 2 ? [ends[0], ends[1]] : null;
}

/** All parts of the line u = value or v = value in the domain. */
export function wholeLine(model: Model, axis: number, value: number): Piece[] {
  const pieces: Piece[] = [], { triangles, domain } = model;
  for (let t = 0; t < model.triangleCount; ++t) {
    let above = 0;
    for (let k = 0; k < 3; ++k) above += domain[2 * triangles[3 * t + k] + axis] < value ? 0 : 1;
    if (above === 0 || above === 3) continue;
    const ends = chord(wholeTriangle(model, t), axis, value);
    if (ends) pieces.push({ triangle: t, from: ends[0], to: ends[1] });
  }
  return pieces;
}

/** The pieces of the grid's lines of one axis in a part. */
export function isoPieces(part: Part, grid: Grid, axis: number): Piece[] {
  const c = part.corners, origin = axis === 0 ? grid.u : grid.v, pieces: Piece[] = [];
  const low = Math.min(c[axis], c[2 + axis], c[4 + axis]), high = Math.max(c[axis], c[2 + axis], c[4 + axis]);
  const last = Math.floor((high - origin) / grid.spacing);
  for (let k = Math.ceil((low - origin) / grid.spacing); k <= last; ++k) {
    const ends = chord(part, axis, origin + k * grid.spacing);
    if (ends) pieces.push({ triangle: part.triangle, from: ends[0], to: ends[1] });
  }
  return pieces;
}

type Polygon = readonly Barycentric[];

/** The part of a convex polygon where a linear function, given by its values at the corners, is >= 0. */
function clip(polygon: Polygon, f: Barycentric): Polygon {
  const out: Barycentric[] = [], value = (p: Barycentric) => f[0] * p[0] + f[1] * p[1] + f[2] * p[2];
  polygon.forEach((p, k) => {
    const q = polygon[(k + 1) % polygon.length], a = value(p), b = value(q);
    if (a >= 0) out.push(p);
    if (a >= 0 !== b >= 0) out.push(mix(p, q, a / (a - b)));
  });
  return out;
}

/** A part cut by every second square of the grid. */
export function checkerPieces(model: Model, part: Part, grid: Grid): Polygon[] {
  const c = cornersOf(model, part.triangle), p = part.corners, h = grid.spacing, out: Polygon[] = [];
  const cell = (x: number, origin: number) => Math.floor((x - origin) / h);
  // Where u (v) is above or below the line k.
  const above = (axis: number, k: number, sign: number): Barycentric => {
    const x = (axis === 0 ? grid.u : grid.v) + k * h;
    return [sign * (c[axis] - x), sign * (c[2 + axis] - x), sign * (c[4 + axis] - x)];
  };
  const lastU = cell(Math.max(p[0], p[2], p[4]), grid.u), lastV = cell(Math.max(p[1], p[3], p[5]), grid.v);
  for (let i = cell(Math.min(p[0], p[2], p[4]), grid.u); i <= lastU; ++i) {
    const column = clip(clip(part.places, above(0, i, 1)), above(0, i + 1, -1));
    if (column.length < 3) continue;
    for (let j = cell(Math.min(p[1], p[3], p[5]), grid.v); j <= lastV; ++j) {
      if ((i + j) % 2 !== 0) continue;
      const square = clip(clip(column, above(1, j, 1)), above(1, j + 1, -1));
      if (square.length >= 3) out.push(square);
    }
  }
  return out;
}
