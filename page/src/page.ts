// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page and what changes it. Every change asks for a frame; a frame draws what
// changed.
import { Palette, readPalette } from "./colour";
import { Hover, hoverAt } from "./hover";
import { Locator, Place } from "./locate";
import { Layers, Painter } from "./paint";
import { Pane, Side } from "./pane";
import { Scene } from "./scene";

/** Pictures that are too slow to follow a movement are drawn when it has rested so long. */
const kRest = 140;

export class Page {
  readonly panes: Record<Side, Pane>;
  readonly painter: Painter;
  readonly layers: Layers = {
    iso: true, checker: false, mesh: true, nets: false, exceptional: true, relaxed: true, features: true,
    colour: "none",
  };
  linked = true;
  hover: Hover | null = null;
  /** A pinned point stays while the pointer moves. */
  pinned = false;
  active: Side = "shape";
  onHover: (hover: Hover | null) => void = () => undefined;
  onChange: () => void = () => undefined;
  private palette: Palette;
  private readonly locators = new Map<Side, Locator>();
  private frame = 0;
  private moving = 0;

  constructor(readonly scene: Scene, stacks: Record<Side, HTMLElement>) {
    this.painter = new Painter(scene);
    this.panes = {
      shape: new Pane("shape", stacks.shape, scene, this.painter),
      domain: new Pane("domain", stacks.domain, scene, this.painter),
    };
    for (const pane of Object.values(this.panes)) pane.camera.size = scene.blend.sizeAt(pane.s);
    this.palette = readPalette();
  }

  get all(): Pane[] {
    return [this.panes.shape, this.panes.domain];
  }

  /** Everything is drawn anew in the next frame. */
  redraw(): void {
    for (const pane of this.all) pane.stale = true;
    this.ask();
  }

  repaletted(): void {
    this.palette = readPalette();
    this.redraw();
  }

  resized(): void {
    for (const pane of this.all) pane.resize();
    this.ask();
  }

  /** Draws at once; a browser shows it with its next frame. */
  drawNow(): void {
    for (const pane of this.all) {
      if (pane.stale) pane.drawBase(this.layers, this.palette, this.moving !== 0);
      pane.drawTop(this.hover, this.palette);
    }
  }

  private ask(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.drawNow();
      this.onChange();
    });
  }

  /** A camera was moved: the other follows if they are linked. */
  moved(side: Side): void {
    this.panes[side].stale = true;
    if (this.linked) this.follow(side);
    if (this.moving) clearTimeout(this.moving);
    this.moving = window.setTimeout(() => {
      this.moving = 0;
      if (this.all.some((pane) => pane.stale)) this.redraw();
    }, kRest);
    this.ask();
  }

  // The other view has the same magnification and shows the same place: at magnification 1 it shows
  // everything, and the larger it gets, the nearer is the image of the centre to the centre.
  private follow(side: Side): void {
    const from = this.panes[side].camera, other: Side = side === "shape" ? "domain" : "shape";
    const to = this.panes[other].camera, image = this.imageOf(side, from.x, from.y);
    const share = Math.max(0, 1 - 1 / from.zoom ** 2);
    to.zoom = from.zoom;
    if (image) to.moveTo(share * image[0], share * image[1]);
    this.panes[other].stale = true;
  }

  // Of a point on one side the same on the other; outside, of the nearest vertex.
  private imageOf(side: Side, x: number, y: number): [number, number] | null {
    const other: Side = side === "shape" ? "domain" : "shape", { blend } = this.scene;
    const place = this.locator(side).find(x, y) ?? this.nearest(side, x, y);
    if (!place) return null;
    const local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    blend.evaluate(place.triangle, this.panes[other].s, place.at, local);
    return [local.x, local.y];
  }

  private nearest(side: Side, x: number, y: number): Place | null {
    let best: Place | null = null, least = Infinity;
    const s = this.panes[side].s;
    for (const loop of this.scene.mesh.loops)
      for (const edge of loop) {
        const [px, py] = this.scene.vertexAt(edge.a, s), far = Math.hypot(px - x, py - y);
        if (far >= least) continue;
        least = far;
        const [triangle, at] = this.scene.cornerAt(edge.a);
        best = { triangle, at };
      }
    return best;
  }

  locator(side: Side): Locator {
    let found = this.locators.get(side);
    if (!found || found.s !== this.panes[side].s) {
      found = new Locator(this.scene.blend, this.panes[side].s);
      this.locators.set(side, found);
    }
    return found;
  }

  /** The point under a pixel of a view becomes the one that is shown. */
  point(side: Side, px: number, py: number): void {
    const [x, y] = this.panes[side].camera.toPlane(px, py);
    this.show(this.locator(side).find(x, y));
  }

  show(place: Place | null): void {
    if (!place && !this.hover) return;
    this.hover = place ? hoverAt(this.scene, place) : null;
    this.onHover(this.hover);
    this.ask();
  }

  fit(): void {
    for (const pane of this.all) pane.camera.fit();
    this.redraw();
  }

  /** Shows a place in the middle of both views. */
  goTo(place: Place, zoom: number): void {
    const local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    for (const pane of this.all) {
      this.scene.blend.evaluate(place.triangle, pane.s, place.at, local);
      pane.camera.zoom = zoom;
      pane.camera.moveTo(local.x, local.y);
    }
    this.pinned = true;
    this.show(place);
    this.redraw();
  }

  /** The shape's view shows what is between domain (0) and shape (1). */
  morph(s: number): void {
    const pane = this.panes.shape;
    pane.s = s;
    pane.camera.size = this.scene.blend.sizeAt(s);
    pane.stale = true;
    this.ask();
  }

  setLayer<K extends keyof Layers>(name: K, value: Layers[K]): void {
    this.layers[name] = value;
    this.redraw();
  }
}
