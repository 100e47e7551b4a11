// SPDX-License-Identifier: GPL-3.0-or-later
// One of the two views: two canvases one over the other, the mesh below and the point above.
import { Camera } from "./camera";
import { Palette } from "./colour";
import { Hover, paintHover } from "./hover";
import { Layers, Painter } from "./paint";
import { Scene } from "./scene";

export type Side = "shape" | "domain";

/** A full picture that takes longer than this is not drawn in every frame of a movement. */
const kSlow = 45;

export class Pane {
  readonly camera = new Camera();
  /** 1: the shape, 0: the domain. */
  s: number;
  /** Milliseconds from the start of the last full picture to the next frame. */
  cost = 0;
  stale = true;
  private readonly base: HTMLCanvasElement;
  readonly top: HTMLCanvasElement;
  private readonly snapshot = document.createElement("canvas");
  private snapshotCamera = { x: 0, y: 0, zoom: 1, scale: 1, s: -1, width: 0, height: 0 };

  constructor(readonly side: Side, readonly stack: HTMLElement, private readonly scene: Scene,
              private readonly painter: Painter) {
    const [base, top] = stack.querySelectorAll("canvas");
    this.base = base;
    this.top = top;
    this.s = side === "shape" ? 1 : 0;
  }

  /** Fits the canvases to their place on the page; whether that changed. */
  resize(): boolean {
    const width = this.stack.clientWidth, height = this.stack.clientHeight;
    const ratio = Math.min(window.devicePixelRatio || 1, 2.5);
    const w = Math.round(width * ratio), h = Math.round(height * ratio);
    if (this.base.width === w && this.base.height === h && this.camera.width === width) return false;
    for (const canvas of [this.base, this.top, this.snapshot]) {
      canvas.width = w;
      canvas.height = h;
    }
    this.camera.width = Math.max(width, 1);
    this.camera.height = Math.max(height, 1);
    this.stale = true;
    return true;
  }

  get ratio(): number {
    return this.base.width / this.camera.width;
  }

  /** Draws the mesh. While `moving` a slow picture is moved as it was instead. */
  drawBase(layers: Layers, palette: Palette, moving: boolean): void {
    this.camera.size = this.scene.blend.sizeAt(this.s);
    const c = this.base.getContext("2d") as CanvasRenderingContext2D;
    if (moving && this.cost > kSlow && this.moveSnapshot(c)) return;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.camera.width, this.camera.height);
    const start = performance.now();
    this.painter.paint(c, this.camera.view(), this.s, layers, this.camera.zoom, palette);
    this.stale = false;
    requestAnimationFrame(() => (this.cost = performance.now() - start));
    this.keepSnapshot();
  }

  drawTop(hover: Hover | null, palette: Palette): void {
    const c = this.top.getContext("2d") as CanvasRenderingContext2D;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.camera.width, this.camera.height);
    if (hover) paintHover(c, this.scene, hover, this.camera.view(), this.s, palette);
  }

  private keepSnapshot(): void {
    if (this.cost <= kSlow) return;
    const c = this.snapshot.getContext("2d") as CanvasRenderingContext2D;
    c.clearRect(0, 0, this.snapshot.width, this.snapshot.height);
    c.drawImage(this.base, 0, 0);
    const { width, height, scale } = this.camera;
    this.snapshotCamera = { ...this.camera.copyOf(), scale, s: this.s, width, height };
  }

  private moveSnapshot(c: CanvasRenderingContext2D): boolean {
    const from = this.snapshotCamera, to = this.camera;
    if (from.s !== this.s || from.width !== to.width || from.height !== to.height) return false;
    const factor = to.scale / from.scale, r = this.ratio;
    const [left, top] = to.toScreen(from.x - from.width / 2 / from.scale, from.y + from.height / 2 / from.scale);
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.base.width, this.base.height);
    c.drawImage(this.snapshot, left * r, top * r, this.base.width * factor, this.base.height * factor);
    this.stale = true;
    return true;
  }
}
