// SPDX-License-Identifier: GPL-3.0-or-later
// The result as the page holds it: flat arrays of numbers, made from the JSON of docs/format.md.

/** A domain edge on an input curve: from a to b, over t0 -> t1 of the curve. */
export interface CurveEdge {
  a: number;
  b: number;
  curve: number;
}

export type Plain = boolean | number | string | null;
/** What the file states, read as it comes: the table shows it and computes nothing with it. */
export interface Spread {
  median: number | null;
  p99: number | null;
  max: number | null;
}
export interface Metrics {
  d_ei?: Spread;
  gradient_angle_deg?: Spread;
  gradient_magnitude?: Spread;
  mips_bound_max?: number | null;
  min_det_coefficient?: number | null;
  conformance_max?: number | null;
  exceptional?: number;
  exceptional_minimum?: number;
  surplus?: number;
  flatness_ratio?: number | null;
  domain_overlaps?: boolean;
  triangles?: number;
  seconds?: Record<string, number | null>;
}

/** The larger side of a bounding box, and its middle. */
export interface Frame {
  x: number;
  y: number;
  extent: number;
  /** Sides of the box over the extent: 1 and at most 1. */
  width: number;
  height: number;
}

export interface Model {
  name: string;
  degree: number;
  /** Control points of a triangle: (n+1)(n+2)/2. */
  netSize: number;
  vertexCount: number;
  triangleCount: number;
  /** u, v of each domain vertex. */
  domain: Float64Array;
  /** Three vertices of each triangle, counter-clockwise. */
  triangles: Int32Array;
  /** x, y of each control point, in the input's units. */
  points: Float64Array;
  /** netSize control points of each triangle: for j: for i: p_ij. */
  nets: Int32Array;
  boundary: CurveEdge[];
  features: CurveEdge[];
  exceptional: Int32Array;
  relaxed: [number, number][];
  corners: number;
  curveCount: number;
  /** Larger side of the bounding box of all poles of the input's curves: what d_ei is relative to. */
  extent: number;
  parameters: [string, Plain][];
  metrics: Metrics;
  shapeFrame: Frame;
  domainFrame: Frame;
}

interface RawResult {
  degree: number;
  domain_vertices: number[][];
  triangles: number[][];
  control_points: number[][];
  triangle_control_points: number[][];
  curves: { poles: number[][] }[];
  boundary_edges: number[][];
  feature_edges: number[][];
  boundary_vertices: [number, string][];
  exceptional_vertices: number[];
  relaxed_edges: [number, number][];
  parameters: Record<string, Plain>;
  metrics: Metrics;
}

function flat(rows: number[][], width: number, into: Float64Array | Int32Array): void {
  rows.forEach((row, r) => {
    for (let k = 0; k < width; ++k) into[r * width + k] = row[k];
  });
}

/** The bounding box of `count` points x, y. */
export function frameOf(points: ArrayLike<number>, count: number): Frame {
  let lowX = Infinity, lowY = Infinity, highX = -Infinity, highY = -Infinity;
  for (let k = 0; k < count; ++k) {
    lowX = Math.min(lowX, points[2 * k]);
    highX = Math.max(highX, points[2 * k]);
    lowY = Math.min(lowY, points[2 * k + 1]);
    highY = Math.max(highY, points[2 * k + 1]);
  }
  if (!(highX >= lowX)) return { x: 0, y: 0, extent: 1, width: 1, height: 1 };
  const extent = Math.max(highX - lowX, highY - lowY) || 1;
  return {
    x: lowX + (highX - lowX) / 2,
    y: lowY + (highY - lowY) / 2,
    extent,
    width: (highX - lowX) / extent,
    height: (highY - lowY) / extent,
  };
}

function curveEdges(rows: number[][]): CurveEdge[] {
  return rows.map(([a, b, curve]) => ({ a, b, curve }));
}

/** Throws if the text is no JSON; what the program wrote has sound ids. */
export function parseModel(text: string): Model {
  const raw = JSON.parse(text) as { name: string; result: RawResult };
  return makeModel(raw.name, raw.result);
}

export function makeModel(name: string, r: RawResult): Model {
  const n = r.degree, netSize = ((n + 1) * (n + 2)) / 2;
  const domain = new Float64Array(2 * r.domain_vertices.length);
  const triangles = new Int32Array(3 * r.triangles.length);
  const points = new Float64Array(2 * r.control_points.length);
  const nets = new Int32Array(netSize * r.triangles.length);
  flat(r.domain_vertices, 2, domain);
  flat(r.triangles, 3, triangles);
  flat(r.control_points, 2, points);
  flat(r.triangle_control_points, netSize, nets);
  const poles: number[] = [];
  for (const curve of r.curves) for (const p of curve.poles) poles.push(p[0], p[1]);
  const shapeFrame = frameOf(points, points.length / 2);
  return {
    name,
    degree: n,
    netSize,
    vertexCount: r.domain_vertices.length,
    triangleCount: r.triangles.length,
    domain,
    triangles,
    points,
    nets,
    boundary: curveEdges(r.boundary_edges),
    features: curveEdges(r.feature_edges),
    exceptional: Int32Array.from(r.exceptional_vertices),
    relaxed: r.relaxed_edges,
    corners: r.boundary_vertices.filter(([, kind]) => kind === "corner").length,
    curveCount: r.curves.length,
    extent: poles.length ? frameOf(poles, poles.length / 2).extent : shapeFrame.extent,
    parameters: Object.entries(r.parameters),
    metrics: r.metrics,
    shapeFrame,
    domainFrame: frameOf(domain, r.domain_vertices.length),
  };
}
