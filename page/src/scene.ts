// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of each layer, made when they are first wanted.
import { Barycentric, netIndex, subNet } from "./bernstein";
import { Blend } from "./blend";
import { CurveBuilder, View } from "./curves";
import { Model } from "./data";
import { Grid, Part, Piece, checkerPieces, gridOf, isoPieces, lineCount, quarters, wholeTriangle } from "./lines";
import { EdgeKind, Mesh, Side, cornerPlace, outline } from "./mesh";

/** Lines in one part at most, before it is cut to see which quarters are visible. */
const kLinesPerPart = 8;
/** Parts drawn at most; more would be a grey area anyhow. */
const kMostParts = 6000;

export class Scene {
  readonly blend: Blend;
  private readonly builder: CurveBuilder;
  private readonly made = new Map<string, Float64Array>();
  private readonly corner: Int32Array;
  private readonly net: Float64Array;
  private readonly part: Float64Array;

  constructor(readonly model: Model, readonly mesh: Mesh) {
    this.blend = new Blend(model);
    this.builder = new CurveBuilder(this.blend);
    this.net = new Float64Array(2 * model.netSize);
    this.part = new Float64Array(2 * model.netSize);
    this.corner = new Int32Array(model.vertexCount).fill(-1);
    model.triangles.forEach((v, k) => (this.corner[v] = k));
  }

  /** Where a vertex is, normalised. */
  vertexAt(vertex: number, s: number): [number, number] {
    const k = this.corner[vertex] % 3, t = (this.corner[vertex] - k) / 3, n = this.model.degree;
    this.blend.netAt(t, s, this.net);
    const at = 2 * netIndex(n, k === 1 ? n : 0, k === 2 ? n : 0);
    return [this.net[at], this.net[at + 1]];
  }

  /** A triangle at the vertex and its corner there. */
  cornerAt(vertex: number): [number, Barycentric] {
    const k = this.corner[vertex] % 3;
    return [(this.corner[vertex] - k) / 3, cornerPlace(k)];
  }

  boundary(): Float64Array {
    return this.keep("boundary", () => this.addSides(this.mesh.loops));
  }

  edges(kind: EdgeKind): Float64Array {
    return this.keep(`edges ${kind}`, () =>
      this.mesh.edges.forEach((e) => {
        if (e.kind === kind) this.addSide(e.triangle[0], e.corner[0]);
      }));
  }

  triangle(t: number): Float64Array {
    const places = [0, 1, 2].map(cornerPlace);
    return this.keep(`triangle ${t}`, () =>
      places.forEach((p, k) => this.builder.add(t, p, places[(k + 1) % 3])));
  }

  /** The images of straight pieces. */
  curvesOf(pieces: Piece[]): Float64Array {
    for (const p of pieces) this.builder.add(p.triangle, p.from, p.to);
    return this.builder.take();
  }

  /** The outline of the triangles for which `inside` holds. */
  outline(key: string, inside: (triangle: number) => boolean): Float64Array {
    return this.keep(key, () => this.addSides(outline(this.mesh.edges, inside)));
  }

  iso(level: number, axis: number, s: number, view: View): Float64Array {
    const grid = gridOf(this.model, level);
    const add = (part: Part) => isoPieces(part, grid, axis).forEach((p) => this.builder.add(p.triangle, p.from, p.to));
    return this.gridLayer(`iso ${axis}`, level, grid, s, view, add);
  }

  checker(level: number, s: number, view: View): Float64Array {
    const grid = gridOf(this.model, level);
    const add = (part: Part) => checkerPieces(this.model, part, grid).forEach((p) => this.addLoop(part.triangle, p));
    return this.gridLayer("checker", level, grid, s, view, add);
  }

  // At level 0 everything, once; finer grids in the visible parts only.
  private gridLayer(name: string, level: number, grid: Grid, s: number, view: View, add: (part: Part) => void): Float64Array {
    if (level === 0)
      return this.keep(name, () => {
        for (let t = 0; t < this.model.triangleCount; ++t) add(wholeTriangle(this.model, t));
      });
    for (const part of this.visibleParts(grid, s, view)) add(part);
    return this.builder.take();
  }

  private visibleParts(grid: Grid, s: number, view: View): Part[] {
    const out: Part[] = [], pending: Part[] = [];
    for (let t = 0; t < this.model.triangleCount; ++t)
      if (this.sizeOnScreen(t, s, view) > 0) pending.push(wholeTriangle(this.model, t));
    while (pending.length && out.length < kMostParts) {
      const part = pending.pop() as Part;
      if (!this.isVisible(part, s, view)) continue;
      if (lineCount(part, grid) <= kLinesPerPart) out.push(part);
      else pending.push(...quarters(part));
    }
    return out;
  }

  /** Pixels of the larger side of the triangle's box; 0 if it is out of view. */
  sizeOnScreen(t: number, s: number, view: View): number {
    this.blend.netAt(t, s, this.net);
    return boxSize(this.net, view);
  }

  private isVisible(part: Part, s: number, view: View): boolean {
    this.blend.netAt(part.triangle, s, this.net);
    subNet(this.model.degree, this.net, part.places, this.part);
    return boxSize(this.part, view) > 0;
  }

  private addSide(triangle: number, corner: number): void {
    this.builder.add(triangle, cornerPlace(corner), cornerPlace((corner + 1) % 3));
  }

  private addSides(loops: Side[][]): void {
    for (const loop of loops) for (const side of loop) this.addSide(side.triangle, side.corner);
  }

  private addLoop(t: number, places: readonly Barycentric[]): void {
    places.forEach((p, k) => this.builder.add(t, p, places[(k + 1) % places.length]));
  }

  private keep(key: string, add: () => void): Float64Array {
    let curves = this.made.get(key);
    if (!curves) {
      add();
      curves = this.builder.take();
      this.made.set(key, curves);
    }
    return curves;
  }
}

function boxSize(points: Float64Array, view: View): number {
  let lowX = Infinity, lowY = Infinity, highX = -Infinity, highY = -Infinity;
  for (let k = 0; k < points.length; k += 2) {
    const x = view.ox + view.scale * points[k], y = view.oy - view.scale * points[k + 1];
    if (x < lowX) lowX = x;
    if (x > highX) highX = x;
    if (y < lowY) lowY = y;
    if (y > highY) highY = y;
  }
  if (highX < 0 || highY < 0 || lowX > view.width || lowY > view.height) return 0;
  return Math.max(highX - lowX, highY - lowY, 1e-9);
}
