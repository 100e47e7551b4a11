// SPDX-License-Identifier: GPL-3.0-or-later
// Keys, as the help lists them.
import { LayerName } from "./paint";
import { Page } from "./page";

const kPan = 60;
const kPoint = 6;
const kZoom = 1.25;

/** The digits of the layers, in the order of the list. */
export const kLayerKeys: [string, LayerName][] = [
  ["1", "iso"], ["2", "checker"], ["3", "mesh"], ["4", "nets"], ["5", "exceptional"], ["6", "relaxed"], ["7", "features"],
];

export interface Commands {
  toggleLayer(name: LayerName): void;
  nextColour(): void;
  toggleLinked(): void;
  toggleTheme(): void;
  toggleMorph(): void;
  help(): void;
  /** Says a point to who cannot see it. */
  say(): void;
}

const kArrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};

function zoomActive(page: Page, factor: number): void {
  const { camera } = page.panes[page.active];
  camera.zoomAt(factor, camera.width / 2, camera.height / 2);
  page.moved(page.active);
}

// The point starts in the middle of the view, or where it is.
function movePoint(page: Page, dx: number, dy: number): void {
  const pane = page.panes[page.active], { camera } = pane;
  let [x, y] = [camera.width / 2, camera.height / 2];
  if (page.hover) {
    const local = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    page.scene.blend.evaluate(page.hover.sample.triangle, pane.s, page.hover.sample.at, local);
    [x, y] = camera.toScreen(local.x, local.y);
  }
  const place = page.locator(page.active).find(...camera.toPlane(x + dx, y + dy));
  page.pinned = true;
  if (place) page.show(place);
}

/** Whether the key does something by itself where the focus is. */
function isTyping(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement && target.type === "range") return key.startsWith("Arrow");
  if (target instanceof HTMLInputElement && target.type === "radio") return key.startsWith("Arrow") || key === " ";
  return key === " " && (target instanceof HTMLInputElement || target instanceof HTMLButtonElement || target.tagName === "SUMMARY");
}

export function installKeyboard(page: Page, commands: Commands): void {
  document.addEventListener("keydown", (e) => {
    if (e.ctrlKey || e.metaKey || e.altKey || isTyping(e.target, e.key)) return;
    if (document.querySelector("dialog[open]")) return;
    if (press(page, commands, e)) e.preventDefault();
  });
}

function press(page: Page, commands: Commands, e: KeyboardEvent): boolean {
  const arrow = kArrows[e.key], layer = kLayerKeys.find(([key]) => key === e.key);
  if (arrow && e.shiftKey) {
    movePoint(page, kPoint * arrow[0], kPoint * arrow[1]);
    commands.say();
  } else if (arrow) {
    page.panes[page.active].camera.pan(-kPan * arrow[0], -kPan * arrow[1]);
    page.moved(page.active);
  } else if (layer) commands.toggleLayer(layer[1]);
  else if (e.key === "+" || e.key === "=") zoomActive(page, kZoom);
  else if (e.key === "-" || e.key === "_") zoomActive(page, 1 / kZoom);
  else if (e.key === "0") page.fit();
  else if (e.key === "8") commands.nextColour();
  else if (e.key === "l") commands.toggleLinked();
  else if (e.key === "t") commands.toggleTheme();
  else if (e.key === " ") commands.toggleMorph();
  else if (e.key === "?") commands.help();
  else if (e.key === "Escape") {
    page.pinned = false;
    page.show(null);
  } else return false;
  return true;
}
