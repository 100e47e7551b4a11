// SPDX-License-Identifier: GPL-3.0-or-later
// Results made by hand: a polynomial map over a triangulation, its control points by blossoming.
import assert from "node:assert/strict";
import { Barycentric } from "../../page/src/bernstein";
import { Model, makeModel } from "../../page/src/data";

/** The same numbers on every machine. */
export function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Terms c u^p v^q of x and of y. */
export type Polynomial = { p: number; q: number; x: number; y: number }[];

export function valueOf(map: Polynomial, u: number, v: number): [number, number] {
  let x = 0, y = 0;
  for (const t of map) {
    x += t.x * u ** t.p * v ** t.q;
    y += t.y * u ** t.p * v ** t.q;
  }
  return [x, y];
}

/** dx/du, dy/du, dx/dv, dy/dv. */
export function jacobianOf(map: Polynomial, u: number, v: number): [number, number, number, number] {
  const out: [number, number, number, number] = [0, 0, 0, 0];
  for (const t of map) {
    const du = t.p ? t.p * u ** (t.p - 1) * v ** t.q : 0, dv = t.q ? t.q * u ** t.p * v ** (t.q - 1) : 0;
    out[0] += t.x * du;
    out[1] += t.y * du;
    out[2] += t.x * dv;
    out[3] += t.y * dv;
  }
  return out;
}

function factorial(k: number): number {
  return k < 2 ? 1 : k * factorial(k - 1);
}

// The blossom of u^p v^q at n points: the coefficient of U^p V^q in the product of (1 + U u_i + V v_i)
// over n! / (p! q! (n-p-q)!).
function blossom(map: Polynomial, at: [number, number][]): [number, number] {
  const n = at.length;
  let product = new Map<string, number>([["0 0", 1]]);
  for (const [u, v] of at) {
    const next = new Map<string, number>();
    const add = (p: number, q: number, c: number) => next.set(`${p} ${q}`, (next.get(`${p} ${q}`) ?? 0) + c);
    product.forEach((c, key) => {
      const [p, q] = key.split(" ").map(Number);
      add(p, q, c);
      add(p + 1, q, c * u);
      add(p, q + 1, c * v);
    });
    product = next;
  }
  let x = 0, y = 0;
  for (const t of map) {
    assert.ok(t.p + t.q <= n);
    const c = ((product.get(`${t.p} ${t.q}`) ?? 0) * factorial(t.p) * factorial(t.q) * factorial(n - t.p - t.q)) / factorial(n);
    x += t.x * c;
    y += t.y * c;
  }
  return [x, y];
}

/** A net of degree n over one triangle. */
export function netOfPolynomial(n: number, map: Polynomial, corners: [number, number][]): Float64Array {
  const out: number[] = [];
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n - j; ++i) {
      const at = [...Array(n - i - j).fill(corners[0]), ...Array(i).fill(corners[1]), ...Array(j).fill(corners[2])];
      out.push(...blossom(map, at));
    }
  return Float64Array.from(out);
}

/** The map over a triangulation; control points are shared as in a result. */
export function polynomialModel(n: number, map: Polynomial, vertices: [number, number][],
                                triangles: [number, number, number][]): Model {
  const points: number[][] = [], ids = new Map<string, number>(), nets: number[][] = [];
  for (const corners of triangles) {
    const net = netOfPolynomial(n, map, corners.map((v) => vertices[v])), row: number[] = [];
    let k = 0;
    for (let j = 0; j <= n; ++j)
      for (let i = 0; i <= n - j; ++i, ++k) {
        const key = [n - i - j, i, j].map((weight, c) => [corners[c], weight]).filter(([, weight]) => weight > 0)
          .sort((a, b) => a[0] - b[0]).join(" ");
        if (!ids.has(key)) {
          ids.set(key, points.length);
          points.push([net[2 * k], net[2 * k + 1]]);
        }
        row.push(ids.get(key) as number);
      }
    nets.push(row);
  }
  return makeModel("fixture", {
    degree: n, domain_vertices: vertices, triangles, control_points: points, triangle_control_points: nets,
    curves: [], boundary_edges: [], feature_edges: [], boundary_vertices: [], exceptional_vertices: [],
    relaxed_edges: [], parameters: {}, metrics: {},
  });
}

/** A square of `cuts` by `cuts` cells with its inner vertices moved a little, each cell two triangles. */
export function squareModel(n: number, map: Polynomial, cuts: number, seed = 1): Model {
  const draw = random(seed), vertices: [number, number][] = [], triangles: [number, number, number][] = [];
  for (let j = 0; j <= cuts; ++j)
    for (let i = 0; i <= cuts; ++i) {
      const inner = i > 0 && j > 0 && i < cuts && j < cuts ? 0.4 : 0;
      vertices.push([(i + inner * (draw() - 0.5)) / cuts, (j + inner * (draw() - 0.5)) / cuts]);
    }
  for (let j = 0; j < cuts; ++j)
    for (let i = 0; i < cuts; ++i) {
      const a = j * (cuts + 1) + i, b = a + 1, c = b + cuts + 1, d = a + cuts + 1;
      triangles.push([a, b, c], [a, c, d]);
    }
  return polynomialModel(n, map, vertices, triangles);
}

/** Bends the unit square; det J > 0 on it. */
export const kBent: Polynomial = [
  { p: 1, q: 0, x: 3, y: 0.4 }, { p: 0, q: 1, x: -0.5, y: 2 }, { p: 2, q: 0, x: 0.3, y: 0.5 },
  { p: 1, q: 1, x: 0.2, y: -0.3 }, { p: 1, q: 2, x: 0.25, y: 0.2 }, { p: 0, q: 3, x: -0.4, y: 0.1 },
  { p: 0, q: 0, x: 7, y: -4 },
];

export function randomPlace(draw: () => number): Barycentric {
  let s = draw(), t = draw();
  if (s + t > 1) [s, t] = [1 - s, 1 - t];
  return [1 - s - t, s, t];
}

export function near(actual: number, expected: number, tolerance: number, what = ""): void {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual} is not ${expected} to ${tolerance}`);
}
