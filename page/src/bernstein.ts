// SPDX-License-Identifier: GPL-3.0-or-later
// Bezier triangles of any degree n. A net is a flat array x, y, x, y, … of its (n+1)(n+2)/2 control
// points in the order for j: for i: p_ij (docs/format.md); a place in a triangle is given by its
// barycentric coordinates at the corners p_00, p_n0, p_0n.

export type Barycentric = readonly [number, number, number];

/** Where p_ij stands in a net of degree n. */
export function netIndex(n: number, i: number, j: number): number {
  return j * (n + 1) - (j * (j - 1)) / 2 + i;
}

/** One step of de Casteljau's algorithm, from degree n to n - 1, in place. */
function step(n: number, net: Float64Array, l0: number, l1: number, l2: number): void {
  let to = 0, row = 0;
  for (let j = 0; j < n; ++j) {
    const above = row + n + 1 - j;  // p_0(j+1)
    for (let i = 0; i < n - j; ++i) {
      const p = 2 * (row + i), q = 2 * (above + i);
      net[to] = l0 * net[p] + l1 * net[p + 2] + l2 * net[q];
      net[to + 1] = l0 * net[p + 1] + l1 * net[p + 3] + l2 * net[q + 1];
      to += 2;
    }
    row = above;
  }
}

const kHighestDegree = 32;
const scratch = new Float64Array((kHighestDegree + 1) * (kHighestDegree + 2));

/** Value and derivatives at a place, s and t being the coordinates at p_n0 and p_0n. */
export interface Local {
  x: number;
  y: number;
  xs: number;
  ys: number;
  xt: number;
  yt: number;
}

/** Writes the value of the net and its derivatives at (l0, l1, l2) to `out`. */
export function evaluateNet(n: number, net: Float64Array, l0: number, l1: number, l2: number,
                            out: Local): void {
  scratch.set(net);
  for (let degree = n; degree > 1; --degree) step(degree, scratch, l0, l1, l2);
  const [ax, ay, bx, by, cx, cy] = scratch;
  out.x = l0 * ax + l1 * bx + l2 * cx;
  out.y = l0 * ay + l1 * by + l2 * cy;
  out.xs = n * (bx - ax);
  out.ys = n * (by - ay);
  out.xt = n * (cx - ax);
  out.yt = n * (cy - ay);
}

/**
 * Control points (n + 1, as x, y, …) of the image of the straight segment from `from` to `to`: the
 * blossom at n - k times `from` and k times `to`.
 */
export function segment(n: number, net: Float64Array, from: Barycentric, to: Barycentric,
                        out: Float64Array): void {
  for (let k = 0; k <= n; ++k) {
    scratch.set(net);
    for (let degree = n; degree > 0; --degree) {
      const [l0, l1, l2] = degree > k ? from : to;
      step(degree, scratch, l0, l1, l2);
    }
    out[2 * k] = scratch[0];
    out[2 * k + 1] = scratch[1];
  }
}

/** The net of the part of the triangle with these three places as corners. */
export function subNet(n: number, net: Float64Array, places: readonly Barycentric[], out: Float64Array): void {
  let to = 0;
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n - j; ++i) {
      scratch.set(net);
      for (let degree = n; degree > 0; --degree) {
        const [l0, l1, l2] = degree <= j ? places[2] : degree <= i + j ? places[1] : places[0];
        step(degree, scratch, l0, l1, l2);
      }
      out[to++] = scratch[0];
      out[to++] = scratch[1];
    }
}

function factorial(k: number): number {
  return k < 2 ? 1 : k * factorial(k - 1);
}
function multinomial(n: number, i: number, j: number): number {
  return factorial(n) / (factorial(i) * factorial(j) * factorial(n - i - j));
}

/** Entries (a, b, c, w): coefficient c of the product of two polynomials of degree m gains w f_a g_b. */
export interface ProductTable {
  a: Int32Array;
  b: Int32Array;
  c: Int32Array;
  weight: Float64Array;
  size: number;
}

export function productTable(m: number): ProductTable {
  const a: number[] = [], b: number[] = [], c: number[] = [], weight: number[] = [];
  for (let j = 0; j <= m; ++j)
    for (let i = 0; i <= m - j; ++i)
      for (let l = 0; l <= m; ++l)
        for (let k = 0; k <= m - l; ++k) {
          a.push(netIndex(m, i, j));
          b.push(netIndex(m, k, l));
          c.push(netIndex(2 * m, i + k, j + l));
          weight.push((multinomial(m, i, j) * multinomial(m, k, l)) / multinomial(2 * m, i + k, j + l));
        }
  return {
    a: Int32Array.from(a),
    b: Int32Array.from(b),
    c: Int32Array.from(c),
    weight: Float64Array.from(weight),
    size: ((2 * m + 1) * (2 * m + 2)) / 2,
  };
}

/** Of a triangle: the least Bernstein coefficient of det J, and g(t) (eq. 4.5; infinite if not regular). */
export interface Bounds {
  leastDet: number;
  g: number;
}

/** Corners of a domain triangle: u, v of a, b, c. */
export type Corners = ArrayLike<number>;

/** Reusable: the coefficients of det J and |J|² of triangles of degree n. */
export class JacobianBounds {
  private readonly table: ProductTable;
  private readonly columns: Float64Array;
  private readonly det: Float64Array;
  private readonly norm: Float64Array;

  constructor(private readonly n: number) {
    this.table = productTable(n - 1);
    this.columns = new Float64Array(2 * n * (n + 1));
    this.det = new Float64Array(this.table.size);
    this.norm = new Float64Array(this.table.size);
  }

  of(net: Float64Array, corners: Corners): Bounds {
    this.fillColumns(net, corners);
    const { a, b, c, weight } = this.table, { columns, det, norm } = this;
    det.fill(0);
    norm.fill(0);
    for (let k = 0; k < a.length; ++k) {
      const p = 4 * a[k], q = 4 * b[k];
      det[c[k]] += weight[k] * (columns[p] * columns[q + 3] - columns[p + 1] * columns[q + 2]);
      norm[c[k]] += weight[k] * (columns[p] * columns[q] + columns[p + 1] * columns[q + 1] +
                                 columns[p + 2] * columns[q + 2] + columns[p + 3] * columns[q + 3]);
    }
    let least = Infinity, largest = -Infinity;
    for (let k = 0; k < det.length; ++k) {
      least = Math.min(least, det[k]);
      largest = Math.max(largest, norm[k]);
    }
    return { leastDet: least, g: least > 0 ? largest / least : Infinity };
  }

  // The Bernstein coefficients of J's columns d/du and d/dv: J = M D^-1, M = n [a_ij, b_ij].
  private fillColumns(net: Float64Array, corners: Corners): void {
    const n = this.n;
    const px = corners[2] - corners[0], py = corners[3] - corners[1];
    const qx = corners[4] - corners[0], qy = corners[5] - corners[1];
    const scale = n / (px * qy - py * qx);
    let to = 0;
    for (let j = 0; j < n; ++j)
      for (let i = 0; i < n - j; ++i) {
        const p = 2 * netIndex(n, i, j), q = 2 * netIndex(n, i + 1, j), r = 2 * netIndex(n, i, j + 1);
        const ax = net[q] - net[p], ay = net[q + 1] - net[p + 1];
        const bx = net[r] - net[p], by = net[r + 1] - net[p + 1];
        this.columns[to++] = scale * (ax * qy - bx * py);
        this.columns[to++] = scale * (ay * qy - by * py);
        this.columns[to++] = scale * (bx * px - ax * qx);
        this.columns[to++] = scale * (by * px - ay * qx);
      }
  }
}
