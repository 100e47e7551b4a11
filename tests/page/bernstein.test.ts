// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { Barycentric, JacobianBounds, Local, evaluateNet, netIndex, segment, subNet } from "../../page/src/bernstein";
import { jacobianOf, kBent, near, netOfPolynomial, random, randomPlace, valueOf } from "./fixture";

const kCorners: [number, number][] = [[0.1, 0.2], [1.3, -0.1], [0.4, 0.9]];
const local: Local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
const domainAt = (at: Barycentric) => [0, 1].map((k) => at[0] * kCorners[0][k] + at[1] * kCorners[1][k] + at[2] * kCorners[2][k]);

test("net indices run for j: for i", () => {
  for (const n of [1, 3, 7]) {
    let k = 0;
    for (let j = 0; j <= n; ++j) for (let i = 0; i <= n - j; ++i) assert.equal(netIndex(n, i, j), k++);
    assert.equal(k, ((n + 1) * (n + 2)) / 2);
  }
});

test("a net evaluates to its polynomial", () => {
  const draw = random(3);
  for (const n of [3, 4, 7, 15]) {
    const net = netOfPolynomial(n, kBent, kCorners);
    for (let k = 0; k < 20; ++k) {
      const at = randomPlace(draw), [u, v] = domainAt(at), [x, y] = valueOf(kBent, u, v);
      evaluateNet(n, net, ...at, local);
      near(local.x, x, 1e-12);
      near(local.y, y, 1e-12);
    }
  }
});

test("Bernstein polynomials sum to one, inside and outside", () => {
  for (const n of [1, 2, 3, 9]) {
    const net = new Float64Array((n + 1) * (n + 2)).fill(1);
    for (const at of [[0.2, 0.3, 0.5], [1.5, -0.2, -0.3]] as Barycentric[]) {
      evaluateNet(n, net, ...at, local);
      near(local.x, 1, 1e-12);
      near(local.xs, 0, 1e-12);
    }
  }
});

test("one control point gives its Bernstein polynomial", () => {
  const n = 4, at: Barycentric = [0.2, 0.5, 0.3], factorial = [1, 1, 2, 6, 24];
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n - j; ++i) {
      const net = new Float64Array((n + 1) * (n + 2));
      net[2 * netIndex(n, i, j)] = 1;
      evaluateNet(n, net, ...at, local);
      const count = factorial[n] / (factorial[i] * factorial[j] * factorial[n - i - j]);
      near(local.x, count * at[0] ** (n - i - j) * at[1] ** i * at[2] ** j, 1e-15);
    }
});

test("derivatives agree with differences", () => {
  const draw = random(5), h = 1e-5;
  for (const n of [1, 2, 3, 5]) {
    const net = Float64Array.from({ length: (n + 1) * (n + 2) }, draw);
    for (let k = 0; k < 10; ++k) {
      const [, s, t] = randomPlace(draw), p = { ...local }, q = { ...local };
      evaluateNet(n, net, 1 - s - t, s, t, local);
      evaluateNet(n, net, 1 - s - t - h, s + h, t, p);
      evaluateNet(n, net, 1 - s - t + h, s - h, t, q);
      near(local.xs, (p.x - q.x) / (2 * h), 1e-8);
      near(local.ys, (p.y - q.y) / (2 * h), 1e-8);
      evaluateNet(n, net, 1 - s - t - h, s, t + h, p);
      evaluateNet(n, net, 1 - s - t + h, s, t - h, q);
      near(local.xt, (p.x - q.x) / (2 * h), 1e-8);
      near(local.yt, (p.y - q.y) / (2 * h), 1e-8);
    }
  }
});

test("segments and parts are the same polynomial", () => {
  const draw = random(7);
  for (const n of [3, 4, 6]) {
    const net = netOfPolynomial(n, kBent, kCorners), poles = new Float64Array(2 * n + 2), part = new Float64Array(net.length);
    const [p, q, r] = [randomPlace(draw), randomPlace(draw), randomPlace(draw)];
    segment(n, net, p, q, poles);
    subNet(n, net, [p, q, r], part);
    for (const [a, b, c] of [[0.3, 0.7, 0], [0.2, 0.3, 0.5], [0, 0, 1]]) {
      const at = [0, 1, 2].map((k) => a * p[k] + b * q[k] + c * r[k]) as unknown as Barycentric, direct = { ...local };
      evaluateNet(n, net, ...at, direct);
      evaluateNet(n, part, a, b, c, local);
      near(local.x, direct.x, 1e-12);
      near(local.y, direct.y, 1e-12);
      if (c > 0) continue;
      const curve = poles.slice();
      for (let degree = n; degree > 0; --degree)
        for (let k = 0; k < 2 * degree; ++k) curve[k] += b * (curve[k + 2] - curve[k]);
      near(curve[0], direct.x, 1e-12);
      near(curve[1], direct.y, 1e-12);
    }
  }
});

test("g and least det of affine maps in closed form", () => {
  // Singular values 3 and 2: |J|^2 / det J = (9 + 4) / 6.
  const affine = [{ p: 1, q: 0, x: 3, y: 0 }, { p: 0, q: 1, x: 0, y: 2 }];
  for (const n of [1, 3, 5]) {
    const { g, leastDet } = new JacobianBounds(n).of(netOfPolynomial(n, affine, kCorners), kCorners.flat());
    near(g, 13 / 6, 1e-12);
    near(leastDet, 6, 1e-12);
  }
});

test("the coefficients of det J and |J|^2 bound them, and meet them at the corners", () => {
  const draw = random(11), n = 3, net = netOfPolynomial(n, kBent, kCorners);
  const { g, leastDet } = new JacobianBounds(n).of(net, kCorners.flat());
  let least = Infinity, worst = 0;
  for (let k = 0; k < 2000; ++k) {
    const [u, v] = domainAt(randomPlace(draw)), [a, b, c, d] = jacobianOf(kBent, u, v), det = a * d - b * c;
    least = Math.min(least, det);
    worst = Math.max(worst, (a * a + b * b + c * c + d * d) / det);
  }
  assert.ok(leastDet <= least && leastDet > 0.5 * least, `${leastDet} ${least}`);
  assert.ok(g >= worst && g < 2 * worst, `${g} ${worst}`);
});

test("a fold has no finite g", () => {
  const fold = [{ p: 2, q: 0, x: 1, y: 0 }, { p: 0, q: 1, x: 0, y: 1 }];
  const corners: [number, number][] = [[-1, 0], [1, 0], [0, 1]];
  const { g, leastDet } = new JacobianBounds(3).of(netOfPolynomial(3, fold, corners), corners.flat());
  assert.equal(g, Infinity);
  near(leastDet, -2, 1e-12);  // det J = 2u
});
