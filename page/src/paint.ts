// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the layers of one view.
import { netIndex } from "./bernstein";
import { Palette, Scale, deviationScale, distortionScale, kSteps, mixScale, stepOf } from "./colour";
import { Outside, View, trace } from "./curves";
import { EdgeKind } from "./mesh";
import { Scene } from "./scene";

export type Colouring = "none" | "distortion" | "deviation";
export interface Layers {
  iso: boolean;
  checker: boolean;
  mesh: boolean;
  nets: boolean;
  exceptional: boolean;
  relaxed: boolean;
  features: boolean;
  colour: Colouring;
}
export type LayerName = Exclude<keyof Layers, "colour">;

/** Control nets of triangles smaller than this, in pixels, would be a blot. */
const kNetSize = 36;

export class Painter {
  readonly scales: Record<Exclude<Colouring, "none">, Scale>;
  private readonly net: Float64Array;

  constructor(private readonly scene: Scene) {
    const { distortion, deviation } = scene.mesh;
    this.scales = { distortion: distortionScale(distortion), deviation: deviationScale(deviation) };
    this.net = new Float64Array(2 * scene.model.netSize);
  }

  /** Level of the grid at a magnification: lines stay about as dense on the screen. */
  static levelAt(zoom: number): number {
    return Math.max(0, Math.floor(Math.log(zoom * 1.0001) / Math.log(3)));
  }

  paint(c: CanvasRenderingContext2D, view: View, s: number, layers: Layers, zoom: number, palette: Palette): void {
    const level = Painter.levelAt(zoom), stroke = this.stroker(c, view, s);
    c.lineCap = "butt";
    c.lineJoin = "round";
    if (layers.colour === "none") this.fill(c, view, s, this.scene.boundary(), palette.paper);
    else this.colour(c, view, s, layers.colour, layers.mesh, palette);
    if (layers.checker) this.fill(c, view, s, this.scene.checker(level, s, view), palette.checker);
    if (layers.iso) {
      stroke(this.scene.iso(level, 0, s, view), palette.u, 0.9);
      stroke(this.scene.iso(level, 1, s, view), palette.v, 0.9);
    }
    if (layers.mesh) {
      c.globalAlpha = this.meshAlpha(view);
      stroke(this.scene.edges(EdgeKind.smooth), palette.mesh, 0.8);
      c.globalAlpha = 1;
    }
    if (layers.relaxed) stroke(this.scene.edges(EdgeKind.relaxed), palette.relaxed, 1.6, [5, 3]);
    if (layers.features) stroke(this.scene.edges(EdgeKind.feature), palette.feature, 1.8);
    stroke(this.scene.boundary(), palette.ink, 1.5);
    if (layers.nets) this.nets(c, view, s, palette);
    if (layers.exceptional) this.exceptional(c, view, s, palette);
  }

  private stroker(c: CanvasRenderingContext2D, view: View, s: number) {
    return (curves: Float64Array, colour: string, width: number, dash: number[] = []) => {
      if (!curves.length) return;
      c.beginPath();
      trace(c, curves, this.scene.blend.mix(s), view, Outside.left);
      c.strokeStyle = colour;
      c.lineWidth = width;
      c.setLineDash(dash);
      c.stroke();
      c.setLineDash([]);
    };
  }

  private fill(c: CanvasRenderingContext2D, view: View, s: number, curves: Float64Array, colour: string): void {
    c.beginPath();
    trace(c, curves, this.scene.blend.mix(s), view, Outside.chords);
    c.fillStyle = colour;
    c.fill();
  }

  // One path per colour. Where two colours both cover a pixel in part what is below would show: that
  // is the middle colour, under a line of the mesh or, without it, of the triangle's own colour.
  private colour(c: CanvasRenderingContext2D, view: View, s: number, by: "distortion" | "deviation", meshAbove: boolean,
                 palette: Palette): void {
    const values = this.scene.mesh[by], scale = this.scales[by];
    this.fill(c, view, s, this.scene.boundary(), mixScale(palette.scale, 0.5));
    for (let step = 0; step < kSteps; ++step) {
      const curves = this.scene.outline(`${by} ${step}`, (t) => stepOf(scale, values[t]) === step);
      if (!curves.length) continue;
      this.fill(c, view, s, curves, mixScale(palette.scale, step / (kSteps - 1)));
      if (meshAbove) continue;
      c.strokeStyle = c.fillStyle;
      c.lineWidth = 0.6;
      c.stroke();
    }
  }

  // Where triangles are a few pixels wide their edges would cover everything.
  private meshAlpha(view: View): number {
    const { model } = this.scene, size = view.scale / Math.sqrt(Math.max(1, model.triangleCount));
    return Math.min(1, Math.max(0.15, size / 14));
  }

  private nets(c: CanvasRenderingContext2D, view: View, s: number, palette: Palette): void {
    const { scene, net } = this, n = scene.model.degree;
    const x = (i: number, j: number) => view.ox + view.scale * net[2 * netIndex(n, i, j)];
    const y = (i: number, j: number) => view.oy - view.scale * net[2 * netIndex(n, i, j) + 1];
    const dots = new Path2D();
    c.beginPath();
    for (let t = 0; t < scene.model.triangleCount; ++t) {
      if (scene.sizeOnScreen(t, s, view) < kNetSize) continue;
      scene.blend.netAt(t, s, net);
      for (let k = 0; k <= n; ++k) {
        for (let m = 0; m <= n - k; ++m) {
          const at = (i: number, j: number) => (m === 0 ? c.moveTo(x(i, j), y(i, j)) : c.lineTo(x(i, j), y(i, j)));
          if (k < n) at(m, k);
          dots.moveTo(x(m, k) + 2, y(m, k));
          dots.arc(x(m, k), y(m, k), 2, 0, 2 * Math.PI);
        }
        for (let m = 0; m <= n - k && k < n; ++m)
          if (m === 0) c.moveTo(x(k, 0), y(k, 0));
          else c.lineTo(x(k, m), y(k, m));
        for (let m = 0; m <= k && k > 0; ++m)
          if (m === 0) c.moveTo(x(k, 0), y(k, 0));
          else c.lineTo(x(k - m, m), y(k - m, m));
      }
    }
    c.strokeStyle = c.fillStyle = palette.net;
    c.lineWidth = 0.8;
    c.stroke();
    c.fill(dots);
  }

  private exceptional(c: CanvasRenderingContext2D, view: View, s: number, palette: Palette): void {
    const vertices = this.scene.model.exceptional;
    const radius = vertices.length > 400 ? 2.2 : 4;
    c.beginPath();
    for (const v of vertices) {
      const [px, py] = this.scene.vertexAt(v, s), x = view.ox + view.scale * px, y = view.oy - view.scale * py;
      if (x < -9 || y < -9 || x > view.width + 9 || y > view.height + 9) continue;
      c.moveTo(x + radius, y);
      c.arc(x, y, radius, 0, 2 * Math.PI);
    }
    c.fillStyle = palette.exceptional;
    c.strokeStyle = palette.halo;
    c.lineWidth = 1.5;
    c.fill();
    c.stroke();
  }
}
