// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and touch on a view: hover, drag, wheel, pinch, tap.
import { Page } from "./page";
import { Pane } from "./pane";

/** A pointer that moved less, in pixels, has clicked. */
const kClick = 4;

interface Held {
  x: number;
  y: number;
  startX: number;
  startY: number;
}

export class PointerControl {
  private readonly held = new Map<number, Held>();
  private dragged = false;
  private pinched = false;

  constructor(private readonly page: Page, private readonly pane: Pane) {
    const { top } = pane;
    top.addEventListener("pointerdown", (e) => this.down(e));
    top.addEventListener("pointermove", (e) => this.move(e));
    top.addEventListener("pointerup", (e) => this.up(e, true));
    top.addEventListener("pointercancel", (e) => this.up(e, false));
    top.addEventListener("pointerleave", () => this.leave());
    top.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
  }

  private place(e: MouseEvent): [number, number] {
    const box = this.pane.top.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }

  private down(e: PointerEvent): void {
    if (e.button !== 0) return;
    const [x, y] = this.place(e);
    this.page.active = this.pane.side;
    this.held.set(e.pointerId, { x, y, startX: x, startY: y });
    this.pane.top.setPointerCapture(e.pointerId);
    if (this.held.size === 1) this.dragged = this.pinched = false;
    else this.pinched = true;
  }

  private move(e: PointerEvent): void {
    const [x, y] = this.place(e), held = this.held.get(e.pointerId);
    if (!held) {
      this.page.active = this.pane.side;
      if (e.pointerType !== "touch" && !this.page.pinned) this.page.point(this.pane.side, x, y);
      return;
    }
    if (this.held.size === 2) return this.pinch(e.pointerId, x, y);
    if (!this.dragged && Math.hypot(x - held.startX, y - held.startY) < kClick) return;
    this.dragged = true;
    this.pane.stack.dataset.dragging = "true";
    this.pane.camera.pan(x - held.x, y - held.y);
    held.x = x;
    held.y = y;
    this.page.moved(this.pane.side);
  }

  // Two fingers: their middle is dragged, their distance magnifies.
  private pinch(id: number, x: number, y: number): void {
    const moved = this.held.get(id), other = [...this.held].find(([key]) => key !== id)?.[1];
    if (!moved || !other) return;
    const before = Math.hypot(moved.x - other.x, moved.y - other.y), after = Math.hypot(x - other.x, y - other.y);
    const { camera } = this.pane;
    camera.pan((x - moved.x) / 2, (y - moved.y) / 2);
    if (before > 1 && after > 1) camera.zoomAt(after / before, (x + other.x) / 2, (y + other.y) / 2);
    moved.x = x;
    moved.y = y;
    this.page.moved(this.pane.side);
  }

  private up(e: PointerEvent, finished: boolean): void {
    if (!this.held.delete(e.pointerId)) return;
    delete this.pane.stack.dataset.dragging;
    // A finger that is left after a pinch goes on from where it is.
    if (this.held.size > 0) this.dragged = true;
    else if (finished && !this.dragged && !this.pinched) this.click(e);
  }

  private click(e: PointerEvent): void {
    const [x, y] = this.place(e), { page } = this;
    const unpin = page.pinned && e.pointerType !== "touch";
    page.pinned = false;
    page.point(this.pane.side, x, y);
    page.pinned = !unpin && page.hover !== null;
    page.onHover(page.hover);
  }

  private leave(): void {
    if (!this.page.pinned && this.held.size === 0) this.page.show(null);
  }

  private wheel(e: WheelEvent): void {
    e.preventDefault();
    const [x, y] = this.place(e), lines = e.deltaMode === 1 ? 16 : e.deltaMode === 2 ? 400 : 1;
    // A pinch on a trackpad comes as a wheel with the control key, in small steps.
    const speed = e.ctrlKey ? 0.01 : 0.0016;
    this.page.active = this.pane.side;
    this.pane.camera.zoomAt(Math.exp(-Math.max(-400, Math.min(400, e.deltaY * lines)) * speed), x, y);
    this.page.moved(this.pane.side);
    if (!this.page.pinned) this.page.point(this.pane.side, x, y);
  }
}
