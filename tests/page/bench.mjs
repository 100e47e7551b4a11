// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests in a browser share: pages made by the program, looks at what they show, a list of
// tests that is run in one browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./devtools.mjs";

export const [program, examples, folder, refined] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
export const run = (...args) => execFileSync(program, ["--quiet", ...args], { cwd: folder });
export const makePages = (...names) => {
  for (const name of names) run("run", join(examples, name), "-o", ".", "--formats", "json,html");
};
export const url = (name) => pathToFileURL(join(folder, name)).href;
export const shot = (page, name) => page.screenshot(join(folder, `${name}.png`));

/** What the page shows: its state in short. `c1mesh` is the page's handle for scripts. */
export const state = (page) => page.evaluate(`(() => {
  const { hover, panes, layers, linked, pinned } = window.c1mesh;
  const camera = (pane) => ({ x: pane.camera.x, y: pane.camera.y, zoom: pane.camera.zoom, s: pane.s });
  return { point: hover && hover.sample, shape: camera(panes.shape), domain: camera(panes.domain), layers, linked, pinned };
})()`);
export const box = (page, side) => page.evaluate(`(() => {
  const b = document.querySelector("#${side}-stack").getBoundingClientRect();
  return { x: b.left, y: b.top, width: b.width, height: b.height };
})()`);
/** The rows of figures of the point, by name. */
export const figures = (page) => page.evaluate(`Object.fromEntries(
  [...document.querySelectorAll("#point-rows tr")].map((r) => [r.cells[0].textContent, r.cells[1].textContent]))`);
/** How many pixels of a canvas (0: mesh, 1: point) are not transparent within some pixels of a place of the page. */
export const inked = (page, side, canvas, x, y, size) => page.evaluate(`(() => {
  const c = document.querySelectorAll("#${side}-stack canvas")[${canvas}], b = c.getBoundingClientRect(), r = c.width / b.width;
  const data = c.getContext("2d").getImageData((${x} - b.left - ${size}) * r, (${y} - b.top - ${size}) * r, 2 * ${size} * r, 2 * ${size} * r).data;
  let count = 0;
  for (let k = 3; k < data.length; k += 4) count += data[k] > 0;
  return count;
})()`);
/** A number of the base canvas's pixels: changes with what is drawn. */
export const fingerprint = (page, side) => page.evaluate(`(() => {
  const c = document.querySelector("#${side}-stack canvas");
  const data = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
  let sum = 0;
  for (let k = 0; k < data.length; ++k) sum = (Math.imul(sum, 31) + data[k]) | 0;
  return sum;
})()`);
/** Where a place of a triangle is on the page. */
export const placeOf = (page, side, triangle, at) => page.evaluate(`(() => {
  const { scene, panes } = window.c1mesh, pane = panes.${side}, p = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
  scene.blend.evaluate(${triangle}, pane.s, ${JSON.stringify(at)}, p);
  const [x, y] = pane.camera.toScreen(p.x, p.y), b = pane.stack.getBoundingClientRect();
  return [b.left + x, b.top + y];
})()`);
export const number = (text) => Number(text.replace("\u2212", "-"));
export const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b} to ${tolerance}`);

/** The map of a result file at a place of a triangle, by Bernstein polynomials. */
export function mapOf(result, triangle, at) {
  const n = result.degree, net = result.triangle_control_points[triangle], factorial = (k) => (k < 2 ? 1 : k * factorial(k - 1));
  let k = 0, x = 0, y = 0;
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n - j; ++i, ++k) {
      const b = (factorial(n) / (factorial(i) * factorial(j) * factorial(n - i - j))) * at[0] ** (n - i - j) * at[1] ** i * at[2] ** j;
      x += b * result.control_points[net[k]][0];
      y += b * result.control_points[net[k]][1];
    }
  const corner = (axis) => at.reduce((sum, w, c) => sum + w * result.domain_vertices[result.triangles[triangle][c]][axis], 0);
  return { x, y, u: corner(0), v: corner(1) };
}

const tests = [];
/** `body` takes the browser and returns the tab that it used. */
export const test = (name, body) => tests.push([name, body]);

/** Runs them, ONLY those whose name contains that variable; no page may complain or ask the network. */
export async function runTests() {
  const browser = new Browser("chromium");
  let failed = 0;
  for (const [name, body] of tests.filter(([name]) => name.includes(process.env.ONLY ?? ""))) {
    try {
      const page = await body(browser);
      // The test reads pixels back, the page does not.
      assert.deepEqual(page.complaints.filter((c) => !c.includes("willReadFrequently")), []);
      assert.deepEqual(page.requests.filter((u) => !u.startsWith("file:") && !u.startsWith("data:")), []);
      assert.equal(page.requests.filter((u) => u.startsWith("file:")).length, 1);
      await page.close();
      console.log(`ok: ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAILED: ${name}\n${error.stack}`);
    }
  }
  await browser.close();
  process.exit(failed ? 1 : 0);
}
