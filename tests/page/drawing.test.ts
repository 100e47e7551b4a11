// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { Barycentric, evaluateNet } from "../../page/src/bernstein";
import { Blend } from "../../page/src/blend";
import { Camera } from "../../page/src/camera";
import { deviationScale, distortionScale, kSteps, mixScale, stepOf } from "../../page/src/colour";
import { CurveBuilder, Outside, Pen, View, trace } from "../../page/src/curves";
import { ticks } from "../../page/src/legend";
import { checkerPieces, gridOf, isoPieces, quarters, wholeLine, wholeTriangle } from "../../page/src/lines";
import { buildMesh } from "../../page/src/mesh";
import { Scene } from "../../page/src/scene";
import { claims } from "../../page/src/table";
import { compact, readable } from "../../page/src/text";
import { kBent, near, random, squareModel } from "./fixture";

/** Notes the points along a path, some on each curve. */
class Notes implements Pen {
  points: [number, number][] = [];
  moves = 0;
  moveTo(x: number, y: number): void {
    ++this.moves;
    this.points.push([x, y]);
  }
  lineTo(x: number, y: number): void {
    const [ax, ay] = this.points[this.points.length - 1];
    for (let k = 1; k <= 16; ++k) this.points.push([ax + (k / 16) * (x - ax), ay + (k / 16) * (y - ay)]);
  }
  bezierCurveTo(bx: number, by: number, cx: number, cy: number, x: number, y: number): void {
    const [ax, ay] = this.points[this.points.length - 1];
    for (let k = 1; k <= 16; ++k) {
      const t = k / 16, r = 1 - t, w = [r * r * r, 3 * r * r * t, 3 * r * t * t, t * t * t];
      this.points.push([w[0] * ax + w[1] * bx + w[2] * cx + w[3] * x, w[0] * ay + w[1] * by + w[2] * cy + w[3] * y]);
    }
  }
}

function area(polygon: readonly Barycentric[]): number {
  let sum = 0;
  polygon.forEach((p, k) => {
    const q = polygon[(k + 1) % polygon.length];
    sum += p[1] * q[2] - p[2] * q[1];
  });
  return sum;  // of the unit triangle, doubled: 1 for all of it
}

test("what is drawn is on the map, at every magnification", () => {
  for (const n of [3, 5]) {
    const model = squareModel(n, kBent, 2), blend = new Blend(model), builder = new CurveBuilder(blend);
    const from: Barycentric = [0.1, 0.2, 0.7], to: Barycentric = [0.6, 0.4, 0], net = new Float64Array(2 * model.netSize);
    builder.add(1, from, to);
    const curves = builder.take(), p = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    for (const s of [1, 0.3, 0])
      for (const scale of [10, 400, 3e6]) {
        blend.netAt(1, s, net);
        evaluateNet(n, net, 0.35, 0.3, 0.35, p);
        const view: View = { ox: 200 - scale * p.x, oy: 200 + scale * p.y, scale, width: 400, height: 400 }, pen = new Notes();
        trace(pen, curves, blend.mix(s), view, Outside.left);
        assert.ok(pen.points.length > 1);
        // The drawn points on the screen against many points of the exact image.
        const exact: [number, number][] = [];
        const span = Math.min(1, 4800 / scale);
        for (let k = -6000; k <= 6000; ++k) {
          const m = 0.5 + (k / 12000) * span, at = [0, 1, 2].map((c) => from[c] + m * (to[c] - from[c]));
          evaluateNet(n, net, at[0], at[1], at[2], p);
          exact.push([view.ox + scale * p.x, view.oy - scale * p.y]);
        }
        // n > 3 is drawn with Hermite's cubics: off by a fraction of the size of the curve.
        const tolerance = n === 3 ? 0.3 : 0.3 + 2e-5 * scale;
        let compared = 0;
        for (const [x, y] of pen.points) {
          if (x < 0 || y < 0 || x > 400 || y > 400) continue;
          ++compared;
          near(Math.min(...exact.map(([ex, ey]) => Math.hypot(x - ex, y - ey))), 0, tolerance, `n ${n} s ${s} scale ${scale}`);
        }
        assert.ok(compared > 0);
      }
  }
});

test("curves out of view are left out, and kept for filling", () => {
  const model = squareModel(3, kBent, 2), scene = new Scene(model, buildMesh(model));
  const view: View = { ox: 5000, oy: 100, scale: 100, width: 200, height: 200 };
  for (const [outside, moves] of [[Outside.left, 0], [Outside.chords, 1]]) {
    const pen = new Notes();
    trace(pen, scene.boundary(), scene.blend.mix(1), view, outside);
    assert.equal(pen.moves, moves);  // the loop is one path
  }
});

test("pieces of a line lie on it, and together are all of it", () => {
  const model = squareModel(3, kBent, 5);
  for (const axis of [0, 1])
    for (const value of [0.07, 0.5, 0.81]) {
      let length = 0;
      for (const piece of wholeLine(model, axis, value)) {
        const { corners } = wholeTriangle(model, piece.triangle);
        const coordinate = (p: Barycentric, a: number) => p[0] * corners[a] + p[1] * corners[2 + a] + p[2] * corners[4 + a];
        near(coordinate(piece.from, axis), value, 1e-14);
        near(coordinate(piece.to, axis), value, 1e-14);
        length += Math.abs(coordinate(piece.to, 1 - axis) - coordinate(piece.from, 1 - axis));
      }
      near(length, 1, 1e-12);
    }
});

test("a line through vertices is drawn once", () => {
  const model = squareModel(3, kBent, 4);
  for (let t = 0; t < model.triangleCount; ++t)
    for (const piece of wholeLine(model, 0, model.domain[2 * model.triangles[3 * t]]))
      assert.ok(piece.from.every(Number.isFinite) && piece.to.every(Number.isFinite));
});

test("each level's lines are among the next level's", () => {
  const model = squareModel(3, kBent, 2);
  for (let level = 0; level < 4; ++level) {
    const coarse = gridOf(model, level), fine = gridOf(model, level + 1);
    near(coarse.spacing / fine.spacing, 3, 1e-12);
    near(coarse.u, fine.u, 0);
  }
  // 24 lines across, half a spacing from the sides.
  const grid = gridOf(model, 0), lines = new Set<number>();
  for (let t = 0; t < model.triangleCount; ++t)
    for (const p of isoPieces(wholeTriangle(model, t), grid, 0)) {
      const c = wholeTriangle(model, t).corners;
      lines.add(Math.round((p.from[0] * c[0] + p.from[1] * c[2] + p.from[2] * c[4] - grid.u) / grid.spacing));
    }
  assert.deepEqual([...lines].sort((a, b) => a - b), Array.from({ length: 24 }, (_, k) => k));
});

test("the two colours of the checkerboard fill a triangle", () => {
  const model = squareModel(3, kBent, 3);
  for (let t = 0; t < model.triangleCount; ++t)
    for (const level of [0, 1]) {
      const grid = gridOf(model, level), part = wholeTriangle(model, t), other = { ...grid, u: grid.u + grid.spacing };
      const total = (g: typeof grid) => checkerPieces(model, part, g).reduce((sum, p) => sum + area(p), 0);
      near(total(grid) + total(other), 1, 1e-11);
      const inParts = quarters(part).reduce((sum, q) => sum + checkerPieces(model, q, grid).reduce((s, p) => s + area(p), 0), 0);
      near(inParts, total(grid), 1e-11);
    }
});

test("a finer grid in view is the same grid", () => {
  const model = squareModel(3, kBent, 2), scene = new Scene(model, buildMesh(model));
  const view: View = { ox: -2000, oy: 3000, scale: 9000, width: 300, height: 300 };
  const pen = new Notes(), grid = gridOf(model, 3);
  trace(pen, scene.iso(3, 0, 0, view), scene.blend.mix(0), view, Outside.left);
  const seen = new Set<number>();
  for (const [px] of pen.points) {
    const u = model.domainFrame.x + ((px - view.ox) / view.scale) * model.domainFrame.extent;
    const k = (u - grid.u) / grid.spacing;
    near(k, Math.round(k), 1e-6);
    if (px >= 0 && px <= 300) seen.add(Math.round(k));
  }
  near(seen.size, 300 / (9000 * grid.spacing), 1);
});

test("the camera keeps what is under the pointer", () => {
  const camera = new Camera(), draw = random(8);
  Object.assign(camera, { width: 640, height: 480, size: [1, 0.7] });
  for (let k = 0; k < 50; ++k) {
    const px = 100 + 400 * draw(), py = 100 + 250 * draw(), before = camera.toPlane(px, py);
    near(camera.toScreen(...before)[0], px, 1e-9);
    const { x, y } = camera;
    camera.zoomAt(1 + draw(), px, py);
    // Unless the centre met the edge of the box.
    if (Math.abs(camera.x) < 0.5 && Math.abs(camera.y) < 0.35 && camera.zoom < 20000)
      camera.toPlane(px, py).forEach((value, axis) => near(value, before[axis], 1e-9));
    if (k % 7 === 0) Object.assign(camera, { x: x / 2, y: y / 2, zoom: 1 });
  }
  camera.fit();
  const corner = camera.toScreen(-0.5, 0.35);
  assert.ok(corner[0] >= 0 && corner[1] >= 0);
});

test("scales and their ticks", () => {
  const scale = distortionScale(Float64Array.from([2, 5, 40, Infinity]));
  assert.deepEqual([scale.low, scale.high], [2, 40]);
  assert.equal(stepOf(scale, 2), 0);
  assert.equal(stepOf(scale, Infinity), kSteps - 1);
  assert.equal(stepOf(scale, NaN), 0);
  near(stepOf(scale, Math.sqrt(80)), kSteps / 2, 1);
  for (const values of [[0, 0], [0, 3e-16, 2e-15], [1e-3], [5]]) {
    const s = deviationScale(Float64Array.from(values));
    assert.ok(s.low > 0 && s.high >= Math.max(...values) && s.high > s.low);
    const t = ticks(s);
    for (let k = 1; k < t.length; ++k) assert.ok(t[k] > t[k - 1]);
  }
  assert.equal(mixScale(["#000000", "#ffffff"], 0.5), "rgb(128,128,128)");
});

test("numbers to read", () => {
  assert.equal(readable(0), "0");
  assert.equal(readable(19.7654), "19.77");
  assert.equal(readable(-736.21), "\u2212736.2");
  assert.equal(readable(1.5e-12, 3), "1.5\u202f\u00d7\u202f10\u207b\u00b9\u00b2");
  assert.equal(readable(null), "\u221e");
  assert.equal(readable(undefined), "\u2013");
  assert.equal(compact(-1.26e-12), "\u22121.3e\u221212");
  assert.equal(compact(0.5), "0.500");
});

test("a claim that does not hold says so", () => {
  const model = squareModel(3, kBent, 2);
  model.metrics = { d_ei: { median: 0, p99: 0, max: 1e-9 }, conformance_max: 0, surplus: 2, domain_overlaps: true };
  assert.deepEqual(claims(model, buildMesh(model)).map((c) => c.holds), [true, false, true, false, false]);
  model.parameters.push(["c1_bound", 1e-6]);
  model.metrics.surplus = 0;
  model.metrics.domain_overlaps = false;
  assert.ok(claims(model, buildMesh(model)).every((c) => c.holds));
});
