// SPDX-License-Identifier: GPL-3.0-or-later
// What a view shows: a centre in the normalised plane and a magnification, 1 being all of it.
import { View } from "./curves";

export const kLargestZoom = 20000;
const kSmallestZoom = 0.5;
const kMargin = 22;

export class Camera {
  x = 0;
  y = 0;
  zoom = 1;
  /** Of the canvas, in CSS pixels. */
  width = 1;
  height = 1;
  /** Sides of the box that is shown at magnification 1. */
  size: [number, number] = [1, 1];

  /** Pixels per unit. */
  get scale(): number {
    const margin = Math.min(kMargin, this.width / 16);
    const fit = Math.min((this.width - 2 * margin) / Math.max(this.size[0], 1e-9),
                         (this.height - 2 * margin) / Math.max(this.size[1], 1e-9));
    return Math.max(fit, 1) * this.zoom;
  }

  view(): View {
    const scale = this.scale;
    return {
      ox: this.width / 2 - scale * this.x,
      oy: this.height / 2 + scale * this.y,
      scale,
      width: this.width,
      height: this.height,
    };
  }

  toScreen(x: number, y: number): [number, number] {
    const v = this.view();
    return [v.ox + v.scale * x, v.oy - v.scale * y];
  }

  toPlane(px: number, py: number): [number, number] {
    const v = this.view();
    return [(px - v.ox) / v.scale, (v.oy - py) / v.scale];
  }

  pan(dx: number, dy: number): void {
    this.moveTo(this.x - dx / this.scale, this.y + dy / this.scale);
  }

  /** Magnifies by `factor`; what is at the pixel (px, py) stays there. */
  zoomAt(factor: number, px: number, py: number): void {
    const [x, y] = this.toPlane(px, py);
    this.zoom = Math.min(kLargestZoom, Math.max(kSmallestZoom, this.zoom * factor));
    const scale = this.scale;
    this.moveTo(x - (px - this.width / 2) / scale, y + (py - this.height / 2) / scale);
  }

  fit(): void {
    this.x = this.y = 0;
    this.zoom = 1;
  }

  /** The centre never leaves the box, so that nobody gets lost. */
  moveTo(x: number, y: number): void {
    const [w, h] = this.size;
    this.x = Math.min(w / 2, Math.max(-w / 2, x));
    this.y = Math.min(h / 2, Math.max(-h / 2, y));
  }

  copyOf(): { x: number; y: number; zoom: number } {
    return { x: this.x, y: this.y, zoom: this.zoom };
  }
}
