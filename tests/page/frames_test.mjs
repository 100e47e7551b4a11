// SPDX-License-Identifier: GPL-3.0-or-later
// frames_test.mjs C1MESH EXAMPLES FOLDER REFINED.js: how long frames of large results take.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { folder, makePages, placeOf, refined, run, runTests, shot, state, test, url } from "./bench.mjs";

/** Milliseconds from frame to frame while the page is panned, magnified and morphed. */
const frameTimes = (page) => page.evaluate(`(async () => {
  const page = window.c1mesh, frame = () => new Promise(requestAnimationFrame), out = {};
  const measure = async (count, move) => {
    const times = [];
    await frame();
    for (let k = 0; k < count; ++k) {
      const start = performance.now();
      move(k);
      await frame();
      times.push(performance.now() - start);
    }
    times.sort((a, b) => a - b);
    return { median: times[count >> 1], worst: times[count - 1] };
  };
  const { camera } = page.panes.shape, all = () => page.all.forEach((pane) => { pane.stale = true; });
  out.full = await measure(30, () => { all(); page.drawNow(); });
  out.pan = await measure(30, (k) => { camera.pan(k % 2 ? 9 : -9, 4); page.moved("shape"); });
  out.zoom = await measure(30, (k) => { camera.zoomAt(k < 15 ? 1.15 : 1 / 1.15, 200, 300); page.moved("shape"); });
  out.morph = await measure(30, (k) => page.morph(1 - k / 30));
  page.morph(1);
  page.fit();
  await frame();
  return out;
})()`);

for (const [triangles, cuts] of [["5,000", 6], ["50,000", 18]])
  test(`frames with more than ${triangles} triangles`, async (browser) => {
    const name = `puzzle-${cuts}`;
    execFileSync(process.execPath, [refined, "puzzle.c1.json", String(cuts), `${name}.c1.json`], { cwd: folder });
    run("convert", `${name}.c1.json`, "-o", `${name}.html`);
    const page = await browser.open(url(`${name}.html`));
    const count = await page.evaluate("window.c1mesh.scene.model.triangleCount");
    assert.ok(count > Number(triangles.replace(",", "")));
    console.log(`  ${count} triangles: ${await page.evaluate("Math.round(performance.getEntriesByType('navigation')[0].loadEventEnd)")} ms to load`);
    for (const layers of [[], ["8"], ["2"]]) {
      for (const key of layers) await page.press(key);
      const times = Object.entries(await frameTimes(page)).map(([what, t]) => `${what} ${t.median.toFixed(0)} (${t.worst.toFixed(0)})`);
      console.log(`  ${count} triangles, ${layers.length ? `and layer ${layers}` : "default layers"}: ms per frame, median (worst): ${times.join(", ")}`);
      // Back; the colours go round.
      for (const key of layers) for (let k = 0; k < (key === "8" ? 2 : 1); ++k) await page.press(key);
    }
    const [x, y] = await placeOf(page, "shape", count >> 1, [0.3, 0.3, 0.4]);
    await page.hover(x, y);
    assert.equal((await state(page)).point.triangle, count >> 1);
    await shot(page, name);
    return page;
  });

makePages("puzzle.svg");
await runTests();
