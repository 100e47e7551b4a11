// SPDX-License-Identifier: GPL-3.0-or-later
// What the page derives from a result: edges and their kinds, C1 deviations, g(t), boundary loops.
import { Barycentric, JacobianBounds, Local, evaluateNet, netIndex } from "./bernstein";
import { Model } from "./data";

export const enum EdgeKind { smooth, boundary, feature, relaxed }

export interface Edge {
  a: number;
  b: number;
  /** The triangles left of a -> b and of b -> a (-1: none), and their corners where the edge starts. */
  triangle: [number, number];
  corner: [number, number];
  kind: EdgeKind;
  /** Largest d_ei from both sides, relative to the extent; 0 on the boundary. */
  deviation: number;
}

export interface Mesh {
  edges: Edge[];
  /** By triangle. */
  distortion: Float64Array;
  deviation: Float64Array;
  /** Largest d_ei over the edges where C1 is asked. */
  largestDeviation: number;
  /** Least coefficient of det J, both planes scaled to extent 1. */
  leastDet: number;
  largestDistortion: number;
  /** Edges where C1 is asked. */
  c1Edges: number;
  interiorEdges: number;
  /** The boundary, loop after loop. */
  loops: Side[][];
}

/** The control points of triangle t into `out` (2 netSize numbers), in the input's units. */
export function netOf(model: Model, t: number, out: Float64Array): void {
  const { netSize, nets, points } = model;
  for (let k = 0; k < netSize; ++k) {
    const id = nets[t * netSize + k];
    out[2 * k] = points[2 * id];
    out[2 * k + 1] = points[2 * id + 1];
  }
}

/** u, v of the corners of triangle t. */
export function cornersOf(model: Model, t: number): number[] {
  const out: number[] = [];
  for (let k = 0; k < 3; ++k) {
    const v = model.triangles[3 * t + k];
    out.push(model.domain[2 * v], model.domain[2 * v + 1]);
  }
  return out;
}

/** The net index of the point with exponents (n - second - third, second, third) at corners k, k+1, k+2. */
export function turnedIndex(n: number, k: number, second: number, third: number): number {
  const first = n - second - third;
  if (k === 0) return netIndex(n, second, third);
  return k === 1 ? netIndex(n, first, second) : netIndex(n, third, first);
}

/** Barycentric coordinates with 1 at corner k. */
export function cornerPlace(k: number): Barycentric {
  return [k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0];
}

/** A place on both sides, with the map's Jacobian d(x, y)/d(u, v) there. */
export interface Sample {
  triangle: number;
  at: Barycentric;
  x: number;
  y: number;
  u: number;
  v: number;
  /** dx/du, dy/du, dx/dv, dy/dv. */
  jacobian: [number, number, number, number];
  det: number;
  /** |J|² / det J, Frobenius norm. */
  distortion: number;
}

export function sample(model: Model, triangle: number, at: Barycentric): Sample {
  const net = new Float64Array(2 * model.netSize), c = cornersOf(model, triangle);
  netOf(model, triangle, net);
  const p: Local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
  evaluateNet(model.degree, net, at[0], at[1], at[2], p);
  const su = c[2] - c[0], sv = c[3] - c[1], tu = c[4] - c[0], tv = c[5] - c[1];
  const area = su * tv - sv * tu;
  const jacobian: Sample["jacobian"] = [
    (p.xs * tv - p.xt * sv) / area, (p.ys * tv - p.yt * sv) / area,
    (p.xt * su - p.xs * tu) / area, (p.yt * su - p.ys * tu) / area,
  ];
  const [a, b, d, e] = jacobian;
  const det = a * e - b * d;
  return {
    triangle, at, x: p.x, y: p.y,
    u: at[0] * c[0] + at[1] * c[2] + at[2] * c[4],
    v: at[0] * c[1] + at[1] * c[3] + at[2] * c[5],
    jacobian, det, distortion: (a * a + b * b + d * d + e * e) / det,
  };
}

/** The largest d_ei of an interior edge from both sides, in the shape's units (docs/format.md). */
export function edgeDeviation(model: Model, edge: Edge): number {
  const { degree: n, domain, points, nets, netSize, triangles } = model;
  const far = (s: 0 | 1) => triangles[3 * edge.triangle[s] + ((edge.corner[s] + 2) % 3)];
  const cross = (o: number, p: number, q: number) =>
    (domain[2 * p] - domain[2 * o]) * (domain[2 * q + 1] - domain[2 * o + 1]) -
    (domain[2 * p + 1] - domain[2 * o + 1]) * (domain[2 * q] - domain[2 * o]);
  const v2 = far(0), v3 = far(1), area = cross(edge.a, edge.b, v2);
  const g0 = cross(v3, edge.b, v2) / area, g2 = cross(edge.a, edge.b, v3) / area;
  const id = (s: 0 | 1, second: number, third: number) =>
    nets[edge.triangle[s] * netSize + turnedIndex(n, edge.corner[s], second, third)];
  let largest = 0;
  for (let i = 0; i < n; ++i) {
    // g1 = 1 - g0 - g2: differences from p_0(i+1), which are small, instead of positions.
    const origin = id(0, i + 1, 0), p = id(0, i, 0), q = id(0, i, 1), r = id(1, n - 1 - i, 1);
    const d = (axis: number) => {
      const o = points[2 * origin + axis];
      return points[2 * r + axis] - o - g0 * (points[2 * p + axis] - o) - g2 * (points[2 * q + axis] - o);
    };
    largest = Math.max(largest, Math.hypot(d(0), d(1)));
  }
  return Math.max(largest, largest / Math.abs(g2));
}

function collectEdges(model: Model): { edges: Edge[]; index: Map<number, number> } {
  const edges: Edge[] = [], index = new Map<number, number>();
  for (let t = 0; t < model.triangleCount; ++t)
    for (let k = 0; k < 3; ++k) {
      const a = model.triangles[3 * t + k], b = model.triangles[3 * t + ((k + 1) % 3)];
      const key = Math.min(a, b) * model.vertexCount + Math.max(a, b), known = index.get(key);
      if (known === undefined) {
        index.set(key, edges.length);
        edges.push({ a, b, triangle: [t, -1], corner: [k, -1], kind: EdgeKind.boundary, deviation: 0 });
      } else {
        edges[known].triangle[1] = t;
        edges[known].corner[1] = k;
        edges[known].kind = EdgeKind.smooth;
      }
    }
  return { edges, index };
}

/** A side of a triangle, from its corner to the next, the triangle on its left. */
export interface Side {
  triangle: number;
  corner: number;
  a: number;
  b: number;
}

/** Sides in closed runs, each beginning where the one before it ends. */
export function loopsOf(sides: Side[]): Side[][] {
  const from = new Map<number, Side[]>();
  for (const side of sides) {
    const known = from.get(side.a);
    if (known) known.push(side);
    else from.set(side.a, [side]);
  }
  const loops: Side[][] = [], used = new Set<Side>();
  for (const start of sides) {
    const loop: Side[] = [];
    for (let side: Side | undefined = start; side && !used.has(side);) {
      used.add(side);
      loop.push(side);
      side = from.get(side.b)?.find((next) => !used.has(next));
    }
    if (loop.length) loops.push(loop);
  }
  return loops;
}

/** The sides between triangles for which `inside` holds and others, or the outside. */
export function outline(edges: Edge[], inside: (triangle: number) => boolean): Side[][] {
  const sides: Side[] = [];
  for (const { a, b, triangle, corner } of edges) {
    const left = inside(triangle[0]), right = triangle[1] >= 0 && inside(triangle[1]);
    if (left && !right) sides.push({ triangle: triangle[0], corner: corner[0], a, b });
    if (right && !left) sides.push({ triangle: triangle[1], corner: corner[1], a: b, b: a });
  }
  return loopsOf(sides);
}

export function buildMesh(model: Model): Mesh {
  const { edges, index } = collectEdges(model);
  const mark = (a: number, b: number, kind: EdgeKind) => {
    const found = index.get(Math.min(a, b) * model.vertexCount + Math.max(a, b));
    if (found !== undefined && edges[found].kind !== EdgeKind.boundary) edges[found].kind = kind;
  };
  for (const [a, b] of model.relaxed) mark(a, b, EdgeKind.relaxed);
  for (const e of model.features) mark(e.a, e.b, EdgeKind.feature);
  const deviation = new Float64Array(model.triangleCount), distortion = new Float64Array(model.triangleCount);
  const net = new Float64Array(2 * model.netSize), bounds = new JacobianBounds(model.degree);
  const mesh: Mesh = {
    edges, distortion, deviation, largestDeviation: 0, leastDet: Infinity, largestDistortion: 2,
    c1Edges: 0, interiorEdges: 0, loops: outline(edges, () => true),
  };
  for (const edge of edges) {
    if (edge.triangle[1] < 0) continue;
    edge.deviation = edgeDeviation(model, edge) / model.extent;
    for (const t of edge.triangle) deviation[t] = Math.max(deviation[t], edge.deviation);
    ++mesh.interiorEdges;
    if (edge.kind !== EdgeKind.smooth) continue;
    ++mesh.c1Edges;
    mesh.largestDeviation = Math.max(mesh.largestDeviation, edge.deviation);
  }
  for (let t = 0; t < model.triangleCount; ++t) {
    netOf(model, t, net);
    const { leastDet, g } = bounds.of(net, cornersOf(model, t));
    distortion[t] = g;
    mesh.leastDet = Math.min(mesh.leastDet, leastDet * (model.domainFrame.extent / model.extent) ** 2);
    mesh.largestDistortion = Math.max(mesh.largestDistortion, g);
  }
  return mesh;
}
