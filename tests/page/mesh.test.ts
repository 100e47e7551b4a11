// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { Blend, toUnit } from "../../page/src/blend";
import { ellipseAxes } from "../../page/src/hover";
import { Locator } from "../../page/src/locate";
import { EdgeKind, buildMesh, cornersOf, edgeDeviation, outline, sample, turnedIndex } from "../../page/src/mesh";
import { Barycentric, Local, netIndex } from "../../page/src/bernstein";
import { jacobianOf, kBent, near, random, randomPlace, squareModel, valueOf } from "./fixture";

const kNowhere: Local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };

test("a sample is the map and its Jacobian", () => {
  const model = squareModel(3, kBent, 4), draw = random(2);
  for (let t = 0; t < model.triangleCount; ++t) {
    const p = sample(model, t, randomPlace(draw)), [x, y] = valueOf(kBent, p.u, p.v), j = jacobianOf(kBent, p.u, p.v);
    near(p.x, x, 1e-12);
    near(p.y, y, 1e-12);
    j.forEach((value, k) => near(p.jacobian[k], value, 1e-10));
    near(p.det, j[0] * j[3] - j[1] * j[2], 1e-9);
  }
});

test("the Jacobian agrees with differences of the map", () => {
  const model = squareModel(5, kBent, 2), at: Barycentric = [0.3, 0.3, 0.4], h = 1e-6;
  const p = sample(model, 3, at), a = sample(model, 3, [0.3 - h, 0.3 + h, 0.4]), b = sample(model, 3, [0.3 + h, 0.3 - h, 0.4]);
  near(a.x - b.x, p.jacobian[0] * (a.u - b.u) + p.jacobian[2] * (a.v - b.v), 1e-12);
  near(a.y - b.y, p.jacobian[1] * (a.u - b.u) + p.jacobian[3] * (a.v - b.v), 1e-12);
});

test("locating inverts the map, on the shape, in the domain and between", () => {
  for (const n of [3, 4]) {
    const model = squareModel(n, kBent, 6, 9), blend = new Blend(model), draw = random(4);
    for (const s of [1, 0.5, 0]) {
      const locator = new Locator(blend, s), p: Local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
      for (let t = 0; t < model.triangleCount; ++t) {
        const at = randomPlace(draw);
        blend.evaluate(t, s, at, p);
        const found = locator.find(p.x, p.y);
        assert.ok(found);
        assert.equal(found.triangle, t);
        at.forEach((value, k) => near(found.at[k], value, 1e-9));
      }
    }
  }
});

test("points on vertices and edges are found, points outside are not", () => {
  const model = squareModel(3, kBent, 3), blend = new Blend(model), locator = new Locator(blend, 1);
  for (let v = 0; v < model.vertexCount; ++v) {
    const [x, y] = valueOf(kBent, model.domain[2 * v], model.domain[2 * v + 1]);
    assert.ok(locator.find(...toUnit(model.shapeFrame, x, y)), `vertex ${v}`);
  }
  for (const [u, v] of [[-0.02, 0.5], [0.5, 1.02], [1.02, 0.3], [0.4, -0.02], [9, 9]]) {
    const [x, y] = valueOf(kBent, u, v);
    assert.equal(locator.find(...toUnit(model.shapeFrame, x, y)), null);
  }
  assert.equal(locator.find(NaN, 0), null);
});

test("turned indices name the same control points from every corner", () => {
  for (const n of [3, 4])
    for (let j = 0; j <= n; ++j)
      for (let i = 0; i <= n - j; ++i) {
        const exponents = [n - i - j, i, j], expected = netIndex(n, i, j);
        for (let k = 0; k < 3; ++k)
          assert.equal(turnedIndex(n, k, exponents[(k + 1) % 3], exponents[(k + 2) % 3]), expected);
      }
});

test("one polynomial is C1 everywhere; a moved control point is off by its move", () => {
  const model = squareModel(3, kBent, 3), mesh = buildMesh(model);
  assert.ok(mesh.largestDeviation < 1e-14, String(mesh.largestDeviation));
  assert.equal(mesh.c1Edges, mesh.interiorEdges);
  const edge = mesh.edges.find((e) => e.kind === EdgeKind.smooth);
  assert.ok(edge);
  const id = model.nets[edge.triangle[1] * model.netSize + turnedIndex(3, edge.corner[1], 1, 1)];
  model.points[2 * id] += 0.003;
  model.points[2 * id + 1] -= 0.004;
  // Seen from the other side it is divided by |g2|, the ratio of the heights over the edge.
  const height = (s: 0 | 1) => {
    const far = model.triangles[3 * edge.triangle[s] + ((edge.corner[s] + 2) % 3)], d = model.domain;
    return Math.abs((d[2 * edge.b] - d[2 * edge.a]) * (d[2 * far + 1] - d[2 * edge.a + 1]) -
                    (d[2 * edge.b + 1] - d[2 * edge.a + 1]) * (d[2 * far] - d[2 * edge.a]));
  };
  near(edgeDeviation(model, edge), 0.005 * Math.max(1, height(0) / height(1)), 1e-12);
});

test("edges, kinds and loops of a square", () => {
  const model = squareModel(3, kBent, 4);
  model.relaxed.push([0, 6]);
  model.features.push({ a: 6, b: 12, curve: 0 });
  const mesh = buildMesh(model), count = (kind: EdgeKind) => mesh.edges.filter((e) => e.kind === kind).length;
  assert.equal(mesh.edges.length, 3 * 16 + 2 * 4);  // Euler: V - E + T = 1
  assert.equal(count(EdgeKind.boundary), 16);
  assert.equal(count(EdgeKind.relaxed), 1);
  assert.equal(count(EdgeKind.feature), 1);
  assert.equal(mesh.interiorEdges - mesh.c1Edges, 2);
  assert.equal(mesh.loops.length, 1);
  mesh.loops[0].forEach((e, k) => assert.equal(e.b, mesh.loops[0][(k + 1) % 16].a));
});

test("outlines close, and bound what they should", () => {
  const model = squareModel(3, kBent, 6), { edges } = buildMesh(model), draw = random(6);
  for (let round = 0; round < 20; ++round) {
    const chosen = new Set<number>();
    for (let t = 0; t < model.triangleCount; ++t) if (draw() < 0.5) chosen.add(t);
    let doubled = 0;
    for (const loop of outline(edges, (t) => chosen.has(t)))
      loop.forEach((side, k) => {
        assert.equal(side.b, loop[(k + 1) % loop.length].a);
        assert.ok(chosen.has(side.triangle));
        const [au, av, bu, bv] = [side.a, side.b].flatMap((v) => [model.domain[2 * v], model.domain[2 * v + 1]]);
        doubled += au * bv - av * bu;
      });
    let expected = 0;
    for (const t of chosen) {
      const [au, av, bu, bv, cu, cv] = cornersOf(model, t);
      expected += (bu - au) * (cv - av) - (bv - av) * (cu - au);
    }
    near(doubled, expected, 1e-12);
  }
});

test("the ellipse has the circle's area and is the image of the circle", () => {
  const model = squareModel(3, kBent, 3), p = sample(model, 4, [0.2, 0.3, 0.5]);
  const blend = new Blend(model);
  ellipseAxes(blend, p, 0).forEach((value, k) => near(value, [26, 0, 0, 26][k], 0));
  const [a, b, c, d] = ellipseAxes(blend, p, 1);
  near(a * d - b * c, 26 * 26, 1e-9);
  p.jacobian.forEach((value, k) => near([a, b, c, d][k] / a, value / p.jacobian[0], 1e-12));
  // Between, it is the derivative of what is drawn.
  const h = 1e-5, q = { ...kNowhere }, r = { ...kNowhere };
  blend.evaluate(4, 0.4, [0.2 - h, 0.3 + h, 0.5], q);
  blend.evaluate(4, 0.4, [0.2 + h, 0.3 - h, 0.5], r);
  const [mu, nu, mv, nv] = ellipseAxes(blend, p, 0.4), c4 = cornersOf(model, 4), du = c4[2] - c4[0], dv = c4[3] - c4[1];
  const [ex, ey] = [mu * du + mv * dv, nu * du + nv * dv];
  near((ex * (q.y - r.y) - ey * (q.x - r.x)) / Math.hypot(ex, ey) / Math.hypot(q.x - r.x, q.y - r.y), 0, 1e-7);
});

test("a domain that is turned turns back on the way", () => {
  const turned = (angle: number) => new Blend(squareModel(3, [
    { p: 1, q: 0, x: Math.cos(angle), y: Math.sin(angle) }, { p: 0, q: 1, x: -Math.sin(angle), y: Math.cos(angle) }], 3));
  for (const angle of [0.3, 2, -3, 3.1]) {
    const blend = turned(angle), p = { ...kNowhere };
    near(Math.cos(blend.turn - angle), 1, 1e-12);
    // A rotation stays a similarity: nothing is folded, and triangles keep their shape.
    for (const s of [0, 0.25, 0.5, 0.75, 1]) {
      blend.evaluate(5, s, [0.2, 0.3, 0.5], p);
      const c = cornersOf(blend.model, 5), side = (k: number) => Math.hypot(c[k] - c[0], c[k + 1] - c[1]);
      near(Math.hypot(p.xs, p.ys) / Math.hypot(p.xt, p.yt), side(2) / side(4), 1e-12);
      assert.ok(p.xs * p.yt - p.ys * p.xt > 0.1 * side(2) * side(4) * 0.1);
    }
  }
});

test("between, control points are interpolated linearly, but for a turn", () => {
  const blend = new Blend(squareModel(3, kBent, 2)), size = 2 * blend.model.netSize;
  const [d, m, e] = [0, 0.3, 1].map((s) => {
    const net = new Float64Array(size);
    blend.netAt(3, s, net);
    return net;
  });
  const rotated = (x: number, y: number, angle: number) =>
    [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
  for (let k = 0; k < size; k += 2) {
    const shape = rotated(e[k], e[k + 1], -blend.turn);
    const between = rotated(0.7 * d[k] + 0.3 * shape[0], 0.7 * d[k + 1] + 0.3 * shape[1], 0.3 * blend.turn);
    near(m[k], between[0], 1e-14);
    near(m[k + 1], between[1], 1e-14);
  }
});
