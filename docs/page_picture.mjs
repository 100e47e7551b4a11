// SPDX-License-Identifier: GPL-3.0-or-later
// node docs/page_picture.mjs [BIN]: docs/pictures/page.png, the page of the puzzle piece with a point.
// Needs Node, Chromium and pngquant. BIN: build/release/bin/c1mesh.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { Browser } from "../tests/page/devtools.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const program = process.argv[2] ?? join(root, "build/release/bin/c1mesh");
const folder = mkdtempSync(join(tmpdir(), "c1mesh-page-"));
execFileSync(program, ["--quiet", "run", join(root, "examples/puzzle.svg"), "-o", folder, "--formats", "json,html"]);
const browser = new Browser("chromium");
const page = await browser.open(pathToFileURL(join(folder, "puzzle.html")).href, { width: 1200, height: 720 });
await page.press("8");
await page.click(330, 270);
const picture = join(root, "docs/pictures/page.png");
await page.screenshot(picture);
execFileSync("pngquant", ["--nofs", "--strip", "--force", "--output", picture, "96", picture]);
await browser.close();
rmSync(folder, { recursive: true });
