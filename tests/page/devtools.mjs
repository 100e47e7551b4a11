// SPDX-License-Identifier: GPL-3.0-or-later
// Drives a Chromium by its DevTools protocol over a pipe: messages end with a NUL, the browser reads
// them from descriptor 3 and answers on 4.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  #next = 1;
  #waiting = new Map();
  #rest = "";
  #folder = mkdtempSync(join(tmpdir(), "c1mesh-browser-"));
  listeners = [];

  constructor(program) {
    // A container has no sandbox for the browser, nor much shared memory.
    const options = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--no-first-run",
      "--disable-extensions", "--disable-background-networking", "--disable-component-update",
      "--force-color-profile=srgb", "--hide-scrollbars", `--user-data-dir=${this.#folder}`,
      "--remote-debugging-pipe", "about:blank"];
    this.process = spawn(program, options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.process.stdio[4].setEncoding("utf8");
    this.process.stdio[4].on("data", (text) => this.#receive(text));
    this.process.stdio[3].on("error", () => {});
    this.ended = new Promise((resolve) => this.process.on("exit", resolve));
    this.ended.then(() => {
      for (const { reject } of this.#waiting.values()) reject(new Error("the browser ended"));
    });
  }

  #receive(text) {
    const messages = (this.#rest + text).split("\0");
    this.#rest = messages.pop();
    for (const message of messages.map((m) => JSON.parse(m))) {
      if (!message.id) {
        for (const listener of this.listeners) listener(message);
        continue;
      }
      const { resolve, reject } = this.#waiting.get(message.id);
      this.#waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    });
  }

  async open(url, size = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Tab(this, sessionId, targetId);
    await page.load(url, size);
    return page;
  }

  async close() {
    await Promise.race([this.send("Browser.close").catch(() => {}), this.ended]);
    await this.ended;
    rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

export class Tab {
  /** Errors, warnings and exceptions of the page; addresses it asked for. */
  complaints = [];
  requests = [];

  constructor(browser, sessionId, targetId) {
    this.browser = browser;
    this.sessionId = sessionId;
    this.targetId = targetId;
    browser.listeners.push((message) => {
      if (message.sessionId === sessionId) this.#hear(message);
    });
  }

  send(method, params) {
    return this.browser.send(method, params, this.sessionId);
  }

  #hear({ method, params }) {
    if (method === "Runtime.exceptionThrown")
      this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && ["error", "warning", "assert"].includes(params.type))
      this.complaints.push(params.args.map((a) => a.value ?? a.description).join(" "));
    if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level))
      this.complaints.push(params.entry.text);
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Page.loadEventFired") this.loaded?.();
  }

  close() {
    return this.browser.send("Target.closeTarget", { targetId: this.targetId });
  }

  async size({ width = 1280, height = 800, scale = 1, mobile = false } = {}) {
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile });
    await this.send("Emulation.setTouchEmulationEnabled", { enabled: mobile, maxTouchPoints: mobile ? 5 : 1 });
  }

  async scheme(dark) {
    await this.send("Emulation.setEmulatedMedia",
      { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
  }

  async load(url, size) {
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(`${domain}.enable`);
    await this.size(size);
    const loaded = new Promise((resolve) => (this.loaded = resolve));
    await this.send("Page.navigate", { url });
    await loaded;
    await this.frames(3);
  }

  /** The value of an expression; promises are waited for. */
  async evaluate(expression) {
    const { result, exceptionDetails } =
      await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits for so many frames. */
  frames(count = 2) {
    return this.evaluate(`new Promise((done) => {
      let left = ${count};
      const step = () => (--left < 0 ? done() : requestAnimationFrame(step));
      step();
    })`);
  }

  mouse(type, x, y, more = {}) {
    return this.send("Input.dispatchMouseEvent", { type, x, y, ...more });
  }

  async hover(x, y) {
    await this.mouse("mouseMoved", x, y);
    await this.frames();
  }

  async click(x, y) {
    await this.mouse("mouseMoved", x, y);
    await this.mouse("mousePressed", x, y, { button: "left", buttons: 1, clickCount: 1 });
    await this.mouse("mouseReleased", x, y, { button: "left", clickCount: 1 });
    await this.frames();
  }

  async drag(x, y, dx, dy) {
    await this.mouse("mouseMoved", x, y);
    await this.mouse("mousePressed", x, y, { button: "left", buttons: 1, clickCount: 1 });
    for (let k = 1; k <= 5; ++k)
      await this.mouse("mouseMoved", x + (k * dx) / 5, y + (k * dy) / 5, { button: "left", buttons: 1 });
    await this.mouse("mouseReleased", x + dx, y + dy, { button: "left", clickCount: 1 });
    await this.frames();
  }

  async wheel(x, y, deltaY) {
    await this.mouse("mouseWheel", x, y, { deltaX: 0, deltaY });
    await this.frames();
  }

  /** A key by its `key` value, such as "ArrowLeft" or "3". */
  async press(key, modifiers = 0) {
    const text = key.length === 1 ? { text: key } : {};
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, modifiers, ...text });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, modifiers });
    await this.frames();
  }

  async touch(type, points) {
    await this.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  }

  async screenshot(path) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    writeFileSync(path, Buffer.from(data, "base64"));
  }
}
