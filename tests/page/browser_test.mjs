// SPDX-License-Identifier: GPL-3.0-or-later
// browser_test.mjs C1MESH EXAMPLES FOLDER: pages made by the program, in a real browser.
import assert from "node:assert/strict";
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { box, figures, fingerprint, folder, inked, makePages, mapOf, near, number, placeOf, run, runTests, shot, state, test, url } from "./bench.mjs";

test("a point is shown on both sides, and its figures are the map's", async (browser) => {
  const page = await browser.open(url("puzzle.html")), result = JSON.parse(readFileSync(join(folder, "puzzle.c1.json"), "utf8"));
  assert.equal((await state(page)).point, null);
  for (const [side, other] of [["shape", "domain"], ["domain", "shape"]])
    for (const triangle of [3, 77, 150]) {
      const [x, y] = await placeOf(page, side, triangle, [0.3, 0.3, 0.4]);
      await page.hover(x, y);
      const { point } = await state(page), shown = await figures(page), exact = mapOf(result, triangle, point.at);
      assert.equal(point.triangle, triangle);
      assert.equal(shown.Triangle, String(triangle));
      for (const key of ["x", "y"]) near(point[key], exact[key], 1e-9);
      for (const key of ["u", "v"]) near(point[key], exact[key], 1e-12);
      const [sx, sy] = shown.Shape.split(", ").map(number), [du, dv] = shown.Domain.split(", ").map(number);
      near(sx, exact.x, 0.006);
      near(sy, exact.y, 0.006);
      near(du, exact.u, 6e-6);
      near(dv, exact.v, 6e-6);
      // The Jacobian against differences of the file's map, along the sides of the triangle.
      const h = 1e-6, [a, b, c, d] = point.jacobian;
      for (const turn of [[h, -h, 0], [0, h, -h]]) {
        const p = mapOf(result, triangle, point.at.map((w, k) => w + turn[k])), q = mapOf(result, triangle, point.at.map((w, k) => w - turn[k]));
        near((p.x - q.x) / h, (a * (p.u - q.u) + c * (p.v - q.v)) / h, 1e-4);
        near((p.y - q.y) / h, (b * (p.u - q.u) + d * (p.v - q.v)) / h, 1e-4);
      }
      near(number(shown["det J"]), a * d - b * c, 1e-4 * point.det);
      // Dots at both places, nothing where nothing is.
      const [ox, oy] = await placeOf(page, other, triangle, point.at);
      assert.ok(await inked(page, side, 1, x, y, 2) > 10);
      assert.ok(await inked(page, other, 1, ox, oy, 2) > 10);
    }
  await shot(page, "light");
  const b = await box(page, "shape");
  await page.hover(b.x + 3, b.y + 3);
  assert.equal((await state(page)).point, null);
  assert.equal(await inked(page, "domain", 1, b.x + 700, b.y + 300, 20), 0);
  return page;
});

test("a click pins, Escape lets go", async (browser) => {
  const page = await browser.open(url("puzzle.html")), [x, y] = await placeOf(page, "shape", 20, [0.3, 0.3, 0.4]);
  await page.click(x, y);
  const { point, pinned } = await state(page);
  assert.equal(pinned, true);
  await page.hover(x + 60, y);
  assert.deepEqual((await state(page)).point, point);
  await page.press("Escape");
  assert.equal((await state(page)).point, null);
  return page;
});

test("wheel and drag, linked and apart", async (browser) => {
  const page = await browser.open(url("puzzle.html"));
  // A whole pixel: that is what a wheel reports.
  const [x, y] = (await placeOf(page, "shape", 40, [0.3, 0.3, 0.4])).map(Math.round);
  await page.hover(x, y);
  const { triangle, at } = (await state(page)).point;
  const before = await fingerprint(page, "domain");
  for (let k = 0; k < 8; ++k) await page.wheel(x, y, -300);
  let now = await state(page);
  assert.ok(now.shape.zoom > 20);
  assert.equal(now.domain.zoom, now.shape.zoom);
  assert.notEqual(await fingerprint(page, "domain"), before);
  // What was under the pointer still is; the other view has its image in sight.
  const after = await placeOf(page, "shape", triangle, at);
  near(after[0], x, 0.01);
  near(after[1], y, 0.01);
  await page.drag(x, y, 80, 30);
  const moved = await placeOf(page, "shape", triangle, at);
  near(moved[0] - x, 80, 0.01);
  near(moved[1] - y, 30, 0.01);
  await page.press("0");
  now = await state(page);
  assert.deepEqual([now.shape.zoom, now.domain.zoom, now.shape.x, now.domain.y], [1, 1, 0, 0]);
  await page.press("l");
  await page.wheel(x, y, -300);
  now = await state(page);
  assert.ok(now.shape.zoom > 1);
  assert.equal(now.domain.zoom, 1);
  return page;
});

test("linked views have the same place in the middle", async (browser) => {
  const page = await browser.open(url("letter.html")), [x, y] = await placeOf(page, "shape", 30, [0.3, 0.3, 0.4]);
  await page.hover(x, y);
  for (let k = 0; k < 12; ++k) await page.wheel(x, y, -300);
  const middle = await page.evaluate(`(() => {
    const page = window.c1mesh, { x, y } = page.panes.shape.camera, place = page.locator("shape").find(x, y);
    const p = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    page.scene.blend.evaluate(place.triangle, 0, place.at, p);
    const { camera } = page.panes.domain;
    return [...camera.toScreen(p.x, p.y), camera.width / 2, camera.height / 2];
  })()`);
  near(middle[0], middle[2], 20);
  near(middle[1], middle[3], 20);
  await page.press("4");
  await shot(page, "nets");
  return page;
});

test("every layer draws something, and takes it away again", async (browser) => {
  const page = await browser.open(url("interfaces.html"));
  const digits = { iso: "1", checker: "2", mesh: "3", nets: "4", exceptional: "5", relaxed: "6", features: "7" };
  for (const [name, digit] of Object.entries(digits)) {
    const before = await fingerprint(page, "shape"), { layers } = await state(page);
    await page.press(digit);
    assert.notEqual((await state(page)).layers[name], layers[name], name);
    assert.equal(await page.evaluate(`document.querySelector("#layer-${name}").checked`), !layers[name]);
    assert.notEqual(await fingerprint(page, "shape"), before, name);
    await page.press(digit);
    assert.equal(await fingerprint(page, "shape"), before, name);
  }
  const seen = new Set();
  for (const colour of ["distortion", "deviation", "none"]) {
    await page.press("8");
    assert.equal((await state(page)).layers.colour, colour);
    seen.add(await fingerprint(page, "shape"));
    assert.equal(await page.evaluate(`document.querySelector("#legend").hidden`), colour === "none");
    if (colour !== "none") await shot(page, colour);
  }
  assert.equal(seen.size, 3);
  return page;
});

test("the morph ends in the domain, and comes back", async (browser) => {
  const page = await browser.open(url("puzzle.html"));
  await page.press(" ");
  await page.frames(20);
  const between = (await state(page)).shape.s;
  assert.ok(between < 1 && between > 0, String(between));
  await page.evaluate(`new Promise((done) => {
    const look = () => (window.c1mesh.panes.shape.s === 0 ? done() : requestAnimationFrame(look));
    look();
  })`);
  await page.frames();
  assert.equal(await fingerprint(page, "shape"), await fingerprint(page, "domain"));
  assert.equal(await page.evaluate(`document.querySelector("#morph").value`), "0");
  // Half way a point is where its control points are.
  await page.evaluate(`(() => { const m = document.querySelector("#morph"); m.value = 0.5; m.dispatchEvent(new Event("input")); })()`);
  await page.frames();
  const [x, y] = await placeOf(page, "shape", 33, [0.3, 0.3, 0.4]);
  await page.hover(x, y);
  const { point } = await state(page);
  assert.equal(point.triangle, 33);
  near(point.at[1], 0.3, 1e-6);
  await shot(page, "morph");
  return page;
});

test("keys", async (browser) => {
  const page = await browser.open(url("puzzle.html"));
  await page.press("+");
  assert.equal((await state(page)).shape.zoom, 1.25);
  await page.press("ArrowRight");
  assert.ok((await state(page)).shape.x > 0);
  await page.press("-");
  near((await state(page)).shape.zoom, 1, 1e-12);
  await page.press("0");
  await page.evaluate(`document.querySelectorAll("canvas")[3].focus()`);
  await page.press("ArrowUp", 8);
  const { point } = await state(page);
  assert.ok(point);
  assert.match(await page.evaluate(`document.querySelector("#live").textContent`), /Triangle \d+/);
  await page.press("l");
  await page.press("+");
  const now = await state(page);
  assert.deepEqual([now.shape.zoom, now.domain.zoom], [1, 1.25]);
  await page.press("?");
  assert.equal(await page.evaluate(`document.querySelector("#help").open`), true);
  await shot(page, "help");
  await page.evaluate(`document.querySelector("#help").close()`);
  // Space on a button is the button's.
  await page.evaluate(`document.querySelector("#fit").focus()`);
  assert.equal(await page.evaluate(`getComputedStyle(document.activeElement).outlineStyle`), "solid");
  await page.press(" ");
  assert.equal((await state(page)).shape.s, 1);
  return page;
});

test("everything that can be used has a name", async (browser) => {
  const page = await browser.open(url("letter.html"));
  await page.send("Accessibility.enable");
  const { nodes } = await page.send("Accessibility.getFullAXTree");
  const usable = nodes.filter((n) => !n.ignored && ["button", "checkbox", "radio", "slider", "application"].includes(n.role?.value));
  assert.ok(usable.length > 15);
  for (const node of usable) assert.ok(node.name?.value, JSON.stringify(node));
  return page;
});

test("dark, by the system and by hand", async (browser) => {
  const page = await browser.open(url("letter.html"));
  const ground = () => page.evaluate(`getComputedStyle(document.body).backgroundColor`);
  const light = await ground(), before = await fingerprint(page, "shape");
  await page.scheme(true);
  await page.frames();
  const dark = await ground();
  assert.notEqual(dark, light);
  assert.notEqual(await fingerprint(page, "shape"), before);
  await page.press("8");
  const [x, y] = await placeOf(page, "domain", 30, [0.3, 0.3, 0.4]);
  await page.hover(x, y);
  await shot(page, "dark");
  await page.press("8");
  await page.press("8");
  await page.press("t");
  assert.equal(await ground(), light);
  await page.hover(2, 2);
  assert.equal(await fingerprint(page, "shape"), before);
  await page.press("t");
  assert.equal(await ground(), dark);
  return page;
});

test("a phone: one view below the other, pinch, drag, tap", async (browser) => {
  const page = await browser.open(url("annulus.html"), { width: 390, height: 844, scale: 2, mobile: true });
  const shape = await box(page, "shape"), domain = await box(page, "domain");
  assert.ok(domain.y > shape.y + shape.height);
  assert.ok(shape.width > 350);
  assert.equal(await page.evaluate("document.documentElement.scrollWidth"), 390);
  await shot(page, "phone");
  const [x, y] = [shape.x + shape.width / 2, shape.y + shape.height / 2];
  await page.touch("touchStart", [[x - 40, y], [x + 40, y]]);
  for (let k = 1; k <= 8; ++k) await page.touch("touchMove", [[x - 40 - 10 * k, y], [x + 40 + 10 * k, y]]);
  await page.touch("touchEnd", []);
  await page.frames();
  const pinched = await state(page);
  near(pinched.shape.zoom, 3, 0.05);
  assert.equal(pinched.point, null);
  await page.touch("touchStart", [[x, y]]);
  for (let k = 1; k <= 4; ++k) await page.touch("touchMove", [[x + 10 * k, y + 5 * k]]);
  await page.touch("touchEnd", []);
  await page.frames();
  const dragged = await state(page);
  assert.ok(dragged.shape.x < pinched.shape.x && dragged.shape.y > pinched.shape.y);
  const [px, py] = await page.evaluate(`(() => {
    // A triangle in view.
    const { scene, panes } = window.c1mesh, b = panes.shape.stack.getBoundingClientRect(), p = { x: 0, y: 0, xs: 0, ys: 0, xt: 0, yt: 0 };
    for (let t = 0; ; ++t) {
      scene.blend.evaluate(t, 1, [0.3, 0.3, 0.4], p);
      const [x, y] = panes.shape.camera.toScreen(p.x, p.y);
      if (x > 20 && y > 20 && x < b.width - 20 && y < b.height - 20) return [b.left + x, b.top + y];
    }
  })()`);
  await page.touch("touchStart", [[px, py]]);
  await page.touch("touchEnd", []);
  await page.frames();
  assert.ok((await state(page)).point);
  await page.evaluate("scrollTo(0, 900)");
  await page.frames();
  await shot(page, "phone-below");
  return page;
});

test("vertices of the list are shown", async (browser) => {
  const page = await browser.open(url("letter.html"));
  await page.evaluate(`document.querySelector("#exceptional-list button").click()`);
  await page.frames();
  const { point, shape } = await state(page), result = JSON.parse(readFileSync(join(folder, "letter.c1.json"), "utf8"));
  assert.ok(result.triangles[point.triangle].includes(result.exceptional_vertices[0]));
  assert.deepEqual([...point.at].sort(), [0, 0, 1]);
  assert.ok(shape.zoom > 4);
  return page;
});

test("names are text, whatever they are", async (browser) => {
  const name = `<img src=x onerror="hacked=1"> &lt; \u2028 '`, result = JSON.parse(readFileSync(join(folder, "blob.c1.json"), "utf8"));
  result.parameters[`</script><script>hacked=1</script>`] = `<!--<script>"</td><svg onload=hacked=1>`;
  writeFileSync(join(folder, `${name}.c1.json`), JSON.stringify(result));
  run("convert", `${name}.c1.json`, "-o", "hostile.html");
  const page = await browser.open(url("hostile.html"));
  assert.equal(await page.evaluate(`document.querySelector("h1").textContent`), name);
  assert.equal(await page.evaluate(`document.title`), `${name} \u2013 c1mesh`.replace(/[\u2028]/g, "\u2028"));
  assert.ok(await page.evaluate(`[...document.querySelectorAll("#parameter-rows th")].some((th) => th.textContent.startsWith("</script>"))`));
  assert.equal(await page.evaluate("typeof hacked"), "undefined");
  assert.equal(await page.evaluate(`document.images.length + document.scripts.length`), 2);
  return page;
});

makePages("puzzle.svg", "letter.svg", "annulus.svg", "blob.svg", "interfaces.json");
renameSync(join(folder, "puzzle.html"), join(folder, "first.html"));
run("convert", "puzzle.c1.json", "-o", "puzzle.html");
assert.equal(readFileSync(join(folder, "puzzle.html"), "utf8"), readFileSync(join(folder, "first.html"), "utf8"));
await runTests();
