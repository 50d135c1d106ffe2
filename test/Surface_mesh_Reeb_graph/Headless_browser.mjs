// Chromium without a window, driven by its DevTools protocol through two pipes.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const time_limit = 60000; // milliseconds, for every answer

export class Headless_browser {
  static async start(program, { width = 1280, height = 800, is_dark = false } = {}) {
    const browser = new Headless_browser(program, width, height);
    const { targetId } = await browser.send("Target.createTarget", { url: "about:blank" });
    const attached = await browser.send("Target.attachToTarget", { targetId, flatten: true });
    browser.session = attached.sessionId;
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await browser.send(`${domain}.enable`);
    await browser.send("Emulation.setEmulatedMedia", {
      features: [{ name: "prefers-color-scheme", value: is_dark ? "dark" : "light" }],
    });
    await browser.send("Emulation.setDeviceMetricsOverride", {
      width,
      height,
      deviceScaleFactor: 1,
      mobile: false,
    });
    return browser;
  }

  constructor(program, width, height) {
    this.folder = mkdtempSync(path.join(tmpdir(), "headless_browser_"));
    this.process = spawn(
      program,
      [
        "--headless=new",
        "--no-sandbox",
        "--no-first-run",
        "--disable-dev-shm-usage",
        "--disable-background-networking",
        "--disable-component-update",
        "--remote-debugging-pipe",
        "--use-gl=angle",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        `--user-data-dir=${this.folder}`,
        `--window-size=${width},${height}`,
      ],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
    );
    this.waiting = new Map();
    this.last_id = 0;
    this.requests = []; // addresses
    this.complaints = []; // of the console: errors, warnings and exceptions
    this.events = new Map();
    let rest = "";
    this.process.stdio[4].setEncoding("utf8");
    this.process.stdio[4].on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      for (const message of messages) this.receive(JSON.parse(message));
    });
  }

  receive(message) {
    if (message.id !== undefined) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
      return;
    }
    const { method, params } = message;
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown")
      this.complaints.push(
        params.exceptionDetails.exception?.description ?? params.exceptionDetails.text,
      );
    if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type))
      this.complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level))
      this.complaints.push(params.entry.text);
    this.events.get(method)?.(params);
  }

  send(method, params = {}) {
    const id = ++this.last_id;
    const message = { id, method, params, sessionId: this.session };
    this.process.stdio[3].write(JSON.stringify(message) + "\0");
    return new Promise((resolve, reject) => {
      const timer = setTimeout(
        () => reject(new Error(`${method}: no answer in ${time_limit / 1000} s`)),
        time_limit,
      );
      const done = (action) => (value) => {
        clearTimeout(timer);
        action(value);
      };
      this.waiting.set(id, { resolve: done(resolve), reject: done(reject) });
    });
  }

  async open(file) {
    const loaded = new Promise((resolve) => this.events.set("Page.loadEventFired", resolve));
    await this.send("Page.navigate", { url: pathToFileURL(path.resolve(file)).href });
    await loaded;
  }

  // The value of an expression in the page, which may be a promise.
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails)
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async wait_for(expression) {
    const end = Date.now() + time_limit;
    while (!(await this.evaluate(expression))) {
      if (Date.now() > end) throw new Error(`${expression} does not become true`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  async mouse(type, x, y, options = {}) {
    await this.send("Input.dispatchMouseEvent", { type, x, y, ...options });
  }

  async click(x, y) {
    await this.mouse("mouseMoved", x, y);
    await this.mouse("mousePressed", x, y, { button: "left", buttons: 1, clickCount: 1 });
    await this.mouse("mouseReleased", x, y, { button: "left", clickCount: 1 });
  }

  // Fingers, each with x and y; none end the touch.
  async touch(type, touchPoints) {
    await this.send("Input.dispatchTouchEvent", { type, touchPoints });
  }

  async press(key, modifiers = 0) {
    const text = key.length === 1 ? key : undefined;
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, text, modifiers });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, modifiers });
  }

  // The bytes of a PNG.
  async screenshot() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }

  async stop() {
    const stopped = new Promise((resolve) => this.process.on("exit", resolve));
    this.session = undefined;
    this.send("Browser.close").catch(() => {});
    await stopped;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}
