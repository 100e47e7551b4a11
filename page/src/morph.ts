// SPDX-License-Identifier: GPL-3.0-or-later
// The slider between domain and shape, and its animation.
import { Page } from "./page";

const kDuration = 2200;

export class Morph {
  private running = 0;

  constructor(private readonly page: Page, private readonly slider: HTMLInputElement,
              private readonly button: HTMLButtonElement) {
    slider.addEventListener("input", () => {
      this.stop();
      this.set(Number(slider.value));
    });
    button.addEventListener("click", () => this.toggle());
  }

  set(s: number): void {
    this.slider.value = String(s);
    this.slider.setAttribute("aria-valuetext", s === 1 ? "shape" : s === 0 ? "domain" : `${Math.round(100 * s)} % shape`);
    this.page.morph(s);
  }

  /** Runs to the farther end, or stops. Who prefers less motion gets the end at once. */
  toggle(): void {
    if (this.running) return this.stop();
    const from = Number(this.slider.value), to = from > 0.5 ? 0 : 1;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return this.set(to);
    const duration = kDuration * Math.abs(to - from);
    let start = 0;
    const step = (now: number) => {
      start = start || now;
      const share = Math.min(1, (now - start) / duration), eased = share * share * (3 - 2 * share);
      this.set(share === 1 ? to : from + eased * (to - from));
      if (share === 1) this.stop();
      else this.running = requestAnimationFrame(step);
    };
    this.running = requestAnimationFrame(step);
    this.label(true);
  }

  private stop(): void {
    cancelAnimationFrame(this.running);
    this.running = 0;
    this.label(false);
  }

  private label(running: boolean): void {
    this.button.setAttribute("aria-label", running ? "Stop" : "Animate between domain and shape");
    this.button.dataset.running = String(running);
  }
}
