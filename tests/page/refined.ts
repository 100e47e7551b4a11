// SPDX-License-Identifier: GPL-3.0-or-later
// refined.js RESULT.c1.json CUTS OUT.c1.json: the same map on a mesh with every triangle cut into
// CUTS². What is said of it is not measured anew: for pictures and times of large results only.
import { Barycentric, subNet } from "../../page/src/bernstein";
import { Model, makeModel } from "../../page/src/data";
import { cornersOf, netOf } from "../../page/src/mesh";

interface Files {
  readFileSync(path: string, encoding: string): string;
  writeFileSync(path: string, text: string): void;
}
declare function require(name: "node:fs"): Files;
declare const process: { argv: string[] };

/** Numbers points by what they are made of: corners of the old triangle, with whole weights. */
class Numbering {
  private readonly ids = new Map<string, number>();
  readonly points: number[][] = [];

  id(corners: number[], weights: number[], triangle: number, x: number, y: number): number {
    const parts = weights.map((weight, k) => [corners[k], weight]).filter(([, weight]) => weight > 0).sort((a, b) => a[0] - b[0]);
    // Inside of a triangle nothing is shared with others, which may have the same corners' numbers.
    const key = (parts.length === 3 ? `${triangle} ` : "") + parts.join(" ");
    let found = this.ids.get(key);
    if (found === undefined) {
      found = this.points.length;
      this.ids.set(key, found);
      this.points.push([x, y]);
    }
    return found;
  }
}

type Weights = [number, number, number];

function pieces(cuts: number): [Weights, Weights, Weights][] {
  const out: [Weights, Weights, Weights][] = [], at = (i: number, j: number): Weights => [cuts - i - j, i, j];
  for (let j = 0; j < cuts; ++j)
    for (let i = 0; i < cuts - j; ++i) {
      out.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
      if (i + j < cuts - 1) out.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return out;
}

function refine(model: Model, cuts: number): { vertices: number[][]; triangles: number[][]; points: number[][]; nets: number[][] } {
  const n = model.degree, vertices = new Numbering(), controls = new Numbering();
  const net = new Float64Array(2 * model.netSize), part = new Float64Array(2 * model.netSize);
  const triangles: number[][] = [], nets: number[][] = [];
  for (let t = 0; t < model.triangleCount; ++t) {
    netOf(model, t, net);
    const ids = Array.from(model.triangles.slice(3 * t, 3 * t + 3)), c = cornersOf(model, t);
    for (const corners of pieces(cuts)) {
      const places = corners.map((w) => w.map((x) => x / cuts) as unknown as Barycentric), row: number[] = [];
      triangles.push(corners.map((w, k) => {
        const p = places[k];
        return vertices.id(ids, w, t, p[0] * c[0] + p[1] * c[2] + p[2] * c[4], p[0] * c[1] + p[1] * c[3] + p[2] * c[5]);
      }));
      subNet(n, net, places, part);
      let k = 0;
      for (let j = 0; j <= n; ++j)
        for (let i = 0; i <= n - j; ++i, ++k) {
          const weights = [0, 1, 2].map((m) => (n - i - j) * corners[0][m] + i * corners[1][m] + j * corners[2][m]);
          row.push(controls.id(ids, weights, t, part[2 * k], part[2 * k + 1]));
        }
      nets.push(row);
    }
  }
  return { vertices: vertices.points, triangles, points: controls.points, nets };
}

const [from, cuts, to] = process.argv.slice(2), files = require("node:fs");
const raw = JSON.parse(files.readFileSync(from, "utf8"));
const fine = refine(makeModel("", raw), Number(cuts));
files.writeFileSync(to, JSON.stringify({
  ...raw,
  domain_vertices: fine.vertices, triangles: fine.triangles, control_points: fine.points,
  triangle_control_points: fine.nets, boundary_edges: [], feature_edges: [], boundary_vertices: [],
  exceptional_vertices: [], relaxed_edges: [],
}));
