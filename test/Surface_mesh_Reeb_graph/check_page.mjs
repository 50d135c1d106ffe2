// Checks the HTML page of the tool reeb_graph in Chromium, without a window:
//
//   node check_page.mjs REEB_GRAPH CHROMIUM
//
// It draws, it can be used by pointer and by keyboard, it says what is picked, at every threshold
// it has the graph and the regions that simplify_Reeb_graph() makes, and nothing leaves the file.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

import { Headless_browser } from "./Headless_browser.mjs";

const [tool, chromium] = process.argv.slice(2);
const folder = mkdtempSync(path.join(tmpdir(), "reeb_graph_page_"));

// ---- meshes ---------------------------------------------------------------------------------------

// A generator of Park and Miller.
function random_numbers(seed) {
  let state = seed;
  return () => (state = (16807 * state) % 2147483647) / 2147483647;
}

// Tori with their axes upright, side by side, and a vertex without edges if asked for.
function tori(number, columns, rows, has_isolated_vertex = false) {
  const points = [];
  const triangles = [];
  for (let k = 0; k < number; ++k) {
    const vertex = (i, j) => (k * columns + (i % columns)) * rows + (j % rows);
    for (let i = 0; i < columns; ++i)
      for (let j = 0; j < rows; ++j) {
        const u = (2 * Math.PI * i) / columns;
        const v = (2 * Math.PI * j) / rows;
        const r = 2 + 0.7 * Math.cos(v);
        points.push([r * Math.cos(u) + 6 * k, 0.7 * Math.sin(v), r * Math.sin(u)]);
        triangles.push(
          [vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)],
          [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)],
        );
      }
  }
  if (has_isolated_vertex) points.push([0, 3, 0]);
  return { points, triangles };
}

function write_mesh(name, { points, triangles }, values) {
  const file = path.join(folder, `${name}.off`);
  writeFileSync(
    file,
    `OFF\n${points.length} ${triangles.length} 0\n` +
      points.map((p) => p.join(" ")).join("\n") +
      "\n" +
      triangles.map((t) => `3 ${t.join(" ")}`).join("\n") +
      "\n",
  );
  writeFileSync(path.join(folder, `${name}.txt`), values.join("\n") + "\n");
  return file;
}

function run_tool(name, prefix, options) {
  execFileSync(tool, [
    path.join(folder, `${name}.off`),
    "--values",
    path.join(folder, `${name}.txt`),
    "--output",
    path.join(folder, prefix),
    ...options,
  ]);
  return path.join(folder, prefix);
}

// ---- what the tool writes -------------------------------------------------------------------------

// Nodes as [vertex, type], arcs as [lower, upper], and the arc of every vertex.
function read_results(prefix) {
  const graphml = readFileSync(`${prefix}.graphml`, "utf8");
  const key_of = Object.fromEntries(
    [...graphml.matchAll(/<key id="(\w+)" for="(\w+)" attr\.name="(\w+)"/g)].map(
      ([, key, kind, name]) => [`${kind} ${name}`, key],
    ),
  );
  const datum = (text, name) => new RegExp(`key="${key_of[name]}">([^<]*)<`).exec(text)[1];
  const nodes = [];
  for (const [, text] of graphml.matchAll(/<node [^>]*>(.*?)<\/node>/gs))
    nodes[datum(text, "node id")] = [
      Number(datum(text, "node mesh_vertex")),
      datum(text, "node type"),
    ];
  const arcs = [];
  for (const [, s, t, text] of graphml.matchAll(
    /<edge [^>]*source="n(\d+)" target="n(\d+)"[^>]*>(.*?)<\/edge>/gs,
  ))
    arcs[datum(text, "edge id")] = [Number(s), Number(t)].sort((a, b) => a - b);
  const vtp = readFileSync(`${prefix}.vtp`, "utf8");
  const arc_of_vertex = /Name="arc"[^>]*>([^<]*)</.exec(vtp)[1].trim().split(/\s+/).map(Number);
  return { nodes, arcs, arc_of_vertex };
}

// The same of the page as it is.
const graph_of_page = `(() => {
  const { graph, data } = reeb_graph_page;
  return {
    nodes: graph.nodes.map((n) => [data.node_vertices[n], graph.type(n)]),
    arcs: graph.arcs.map((a) => [
      graph.node_number.get(data.arc_lowers[a]),
      graph.node_number.get(data.arc_uppers[a]),
    ]),
    arc_of_vertex: [...data.vertices.keys()].map((v) => graph.arcs.indexOf(graph.arc_of_vertex(v))),
    threshold: [data.stop_lowers[graph.stop], data.stop_uppers[graph.stop]].map(String), // infinity, too
  };
})()`;

const sorted = (arcs) => arcs.map((arc) => arc.join(" ")).sort();

function compare(page, files) {
  assert.deepEqual(page.nodes, files.nodes);
  assert.deepEqual(sorted(page.arcs), sorted(files.arcs));
  // The vertex of a node may belong to any of its arcs; all others make a bijection.
  const is_node = new Set(files.nodes.map(([vertex]) => vertex));
  const arc_of_file = new Map();
  const arc_of_page = new Map();
  page.arc_of_vertex.forEach((arc, v) => {
    if (is_node.has(v)) return;
    const other = files.arc_of_vertex[v];
    assert.deepEqual(page.arcs[arc], files.arcs[other]);
    assert.equal(arc_of_page.get(other) ?? arc, arc);
    assert.equal(arc_of_file.get(arc) ?? other, other);
    arc_of_page.set(other, arc);
    arc_of_file.set(arc, other);
  });
}

// ---- checks ---------------------------------------------------------------------------------------

let browser;

async function open(prefix) {
  browser.requests.length = 0;
  await browser.open(`${prefix}.html`);
  await browser.wait_for("window.reeb_graph_page !== undefined");
}

async function next_frame() {
  await browser.evaluate("new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))");
}

function check_silence() {
  assert.deepEqual(browser.complaints, []);
  for (const request of browser.requests) assert.match(request, /^(file:.*\.html|data:,|blob:.*)$/);
}

// The parts of the pixels that differ from the background, and from the picture before; and a number
// that tells pictures apart.
const picture_of_page = `(() => {
  const canvas = document.getElementById("canvas");
  const copy = new OffscreenCanvas(canvas.width, canvas.height);
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  const last = window.last_pixels ?? pixels;
  window.last_pixels = pixels;
  let drawn = 0, changed = 0, hash = 0;
  pixels.forEach((pixel, i) => {
    drawn += pixel !== pixels[0];
    changed += pixel !== last[i];
    hash = (31 * hash + pixel) | 0;
  });
  return { part: drawn / pixels.length, changed: changed / pixels.length, hash };
})()`;

async function picture() {
  await next_frame();
  return browser.evaluate(picture_of_page);
}

// At all thresholds at which something changes, on both sides, and at some in between.
async function check_thresholds(name, options) {
  const first = run_tool(name, `${name}_first`, ["--simplify", "0.05", ...options]);
  await open(first);
  compare(await browser.evaluate(graph_of_page), read_results(first));
  const bounds = await browser.evaluate("[...reeb_graph_page.data.stop_lowers]");
  const thresholds = new Set([0, 0.05, 0.1, 0.3, 1e9]);
  const step = Math.ceil(bounds.length / 12);
  for (let i = 0; i < bounds.length; i += step) {
    thresholds.add(bounds[i]);
    thresholds.add(bounds[i] * (1 + 1e-9));
  }
  let number = 0;
  const seen = new Set();
  for (const threshold of [...thresholds].sort((a, b) => a - b)) {
    const prefix = run_tool(name, `${name}_${number++}`, [
      "--simplify",
      String(threshold),
      ...options,
    ]);
    await browser.evaluate(`reeb_graph_page.set_threshold(${threshold})`);
    const page = await browser.evaluate(graph_of_page);
    const [lower, upper] = page.threshold.map(Number);
    assert.ok(threshold === 0 ? lower === 0 : lower < threshold);
    assert.ok(threshold <= upper);
    compare(page, read_results(prefix));
    seen.add(page.nodes.length);
  }
  check_silence();
  return seen.size;
}

async function check_picture_and_pointer(prefix) {
  await open(prefix);
  assert.equal(await browser.evaluate("reeb_graph_page.version"), 1);
  assert.match(
    await browser.evaluate("document.getElementById('generator').textContent"),
    /^reeb_graph \d+\.\d+\.\d+, version 1 of the page$/,
  );
  const first = await picture();
  assert.ok(first.part > 0.05 && first.part < 0.9, `${first.part} of the canvas is drawn`);

  // The node that has the most room around it.
  const { node, x, y } = await browser.evaluate(`(() => {
    const { graph, view } = reeb_graph_page;
    const places = graph.nodes.map((node) => ({ node, ...view.node_on_screen(node) }));
    const room = (p) =>
      Math.min(...places.filter((q) => q !== p).map((q) => Math.hypot(p.x - q.x, p.y - q.y)));
    return places.reduce((p, q) => (room(q) > room(p) ? q : p));
  })()`);
  await browser.mouse("mouseMoved", x + 2, y - 2);
  await next_frame();
  assert.equal(await browser.evaluate("document.getElementById('tooltip').hidden"), false);
  assert.match(await browser.evaluate("document.getElementById('tooltip').textContent"), /^node \d/);
  await browser.click(x + 2, y - 2);
  assert.deepEqual(await browser.evaluate("reeb_graph_page.picked"), { kind: "node", id: node });
  const facts = await browser.evaluate("document.getElementById('picked').textContent");
  const vertex = await browser.evaluate(`reeb_graph_page.data.node_vertices[${node}]`);
  assert.match(facts, new RegExp(`node\\d+.*value.*persistence.*vertex${vertex}`));
  assert.match(
    await browser.evaluate("document.getElementById('announcement').textContent"),
    new RegExp(`vertex ${vertex}`),
  );
  const pair_class = ".pair.emphasized";
  assert.ok(await browser.evaluate(`document.querySelectorAll("${pair_class}").length > 0`));
  const picked = await picture();
  assert.notEqual(picked.hash, first.hash);

  // The diagram leads to the picture, too.
  const mark = await browser.evaluate(`(() => {
    const { diagram, graph, data } = reeb_graph_page;
    const pair = diagram.order.find((p) => graph.is_node(data.pair_births[p]));
    const box = diagram.marks.get(pair).getBoundingClientRect();
    return { pair, x: box.x + box.width / 2, y: box.y + box.height / 2 };
  })()`);
  await browser.click(mark.x, mark.y);
  assert.equal(await browser.evaluate("reeb_graph_page.picked_pair"), mark.pair);
  assert.equal(
    await browser.evaluate("reeb_graph_page.picked.id"),
    await browser.evaluate(`reeb_graph_page.data.pair_births[${mark.pair}]`),
  );

  // So does the keyboard: to the next pair, and at last to one that is cancelled.
  await browser.evaluate("document.getElementById('diagram').focus()");
  await browser.press("ArrowRight");
  assert.equal(
    await browser.evaluate("reeb_graph_page.picked_pair"),
    await browser.evaluate(`(() => {
      const { order } = reeb_graph_page.diagram;
      return order[order.indexOf(${mark.pair}) + 1];
    })()`),
  );
  const number = await browser.evaluate("reeb_graph_page.diagram.order.length");
  for (let i = 0; i < number; ++i) await browser.press("ArrowRight");
  assert.match(
    await browser.evaluate("document.getElementById('announcement').textContent"),
    /^pair \w+, cancelled, persistence /,
  );

  // A point of the surface: its level set, and the region of its arc.
  await browser.evaluate("reeb_graph_page.pick(null)");
  const place = await browser.evaluate(`(() => {
    const { view } = reeb_graph_page;
    const { clientWidth, clientHeight } = document.getElementById("canvas");
    for (let y = 5; y < clientHeight; y += 5)
      for (let x = 5; x < clientWidth; x += 5)
        if (view.find(x, y)?.kind === "surface") return { x, y };
  })()`);
  await browser.mouse("mouseMoved", place.x, place.y);
  await next_frame();
  assert.equal(await browser.evaluate("reeb_graph_page.view.curve_lines.visible"), true);
  await picture();
  await browser.click(place.x, place.y);
  assert.equal(await browser.evaluate("reeb_graph_page.picked.kind"), "arc");
  const { changed, part } = await picture();
  assert.ok(changed > 0.9 * part, "the region does not stand out from the others");
  const lit = await browser.evaluate("reeb_graph_page.view.lit.array.reduce((s, x) => s + x, 0)");
  assert.ok(lit > 0);

  // Dragging turns the shape and picks nothing.
  const before = await browser.evaluate("reeb_graph_page.view.camera.position.toArray()");
  await browser.mouse("mousePressed", 300, 300, { button: "left", buttons: 1, clickCount: 1 });
  await browser.mouse("mouseMoved", 360, 330, { button: "left", buttons: 1 });
  await next_frame();
  await browser.mouse("mouseReleased", 360, 330, { button: "left", clickCount: 1 });
  assert.notDeepEqual(
    await browser.evaluate("reeb_graph_page.view.camera.position.toArray()"),
    before,
  );
  assert.equal(await browser.evaluate("reeb_graph_page.picked.kind"), "arc");
  check_silence();
}

async function check_touch(prefix) {
  await open(prefix);
  const camera = () => browser.evaluate("reeb_graph_page.view.camera.position.toArray()");
  const distance = async () => Math.hypot(...(await camera()));
  const node = await browser.evaluate("reeb_graph_page.graph.nodes[0]");
  const { x, y } = await browser.evaluate(`reeb_graph_page.view.node_on_screen(${node})`);
  await browser.touch("touchStart", [{ x, y }]);
  await browser.touch("touchEnd", []);
  await browser.wait_for("reeb_graph_page.picked !== null");
  assert.deepEqual(await browser.evaluate("reeb_graph_page.picked"), { kind: "node", id: node });

  const before = await camera();
  await browser.touch("touchStart", [{ x: 300, y: 300 }]);
  await browser.touch("touchMove", [{ x: 340, y: 320 }]);
  await browser.touch("touchMove", [{ x: 380, y: 340 }]);
  await next_frame();
  await browser.touch("touchEnd", []);
  assert.notDeepEqual(await camera(), before);

  const far = await distance();
  const fingers = (d) => [
    { x: 400 - d, y: 400, id: 0 },
    { x: 400 + d, y: 400, id: 1 },
  ];
  await browser.touch("touchStart", fingers(50));
  for (const d of [60, 80, 100]) {
    await browser.touch("touchMove", fingers(d));
    await next_frame();
  }
  await browser.touch("touchEnd", []);
  assert.ok((await distance()) < 0.9 * far, "two fingers that part do not zoom in");
  check_silence();
}

async function check_keys(prefix) {
  await open(prefix);
  await browser.evaluate("document.getElementById('canvas').focus()");
  const announcement = () =>
    browser.evaluate("document.getElementById('announcement').textContent");
  await browser.press("n");
  assert.match(await announcement(), /^node 0, /);
  await browser.press("n");
  assert.match(await announcement(), /^node 1, /);
  await browser.press("a");
  assert.match(await announcement(), /^arc from node /);
  await browser.press("Escape");
  assert.equal(await announcement(), "nothing picked");

  const stop = await browser.evaluate("reeb_graph_page.graph.stop");
  const number = await browser.evaluate("reeb_graph_page.graph.nodes.length");
  let last = await picture();
  await browser.press("[");
  assert.equal(await browser.evaluate("reeb_graph_page.graph.stop"), stop - 1);
  assert.ok((await browser.evaluate("reeb_graph_page.graph.nodes.length")) > number);
  for (const key of ["ArrowLeft", "+", "t", "c", "d", "r"]) {
    const next = await picture();
    assert.notEqual(next.hash, last.hash, `nothing changes before ${key}`);
    last = next;
    await browser.press(key);
  }
  await browser.press("?");
  assert.equal(await browser.evaluate("document.getElementById('keys').open"), true);
  await browser.press("Escape");
  check_silence();
}

async function check_export(prefix) {
  await open(prefix);
  const { send } = browser;
  const session = browser.session;
  browser.session = undefined; // a command for the browser, not for the page
  await send.call(browser, "Browser.setDownloadBehavior", {
    behavior: "allow",
    downloadPath: folder,
  });
  browser.session = session;
  await browser.evaluate("document.getElementById('export').click()");
  const file = path.join(folder, "tori.png");
  for (let i = 0; i < 200; ++i) {
    try {
      const bytes = readFileSync(file);
      assert.equal(bytes.subarray(1, 4).toString(), "PNG");
      assert.ok(bytes.readUInt32BE(16) >= 1000, "the picture is small");
      check_silence();
      return;
    } catch (error) {
      if (error.code !== "ENOENT") throw error;
      await sleep(50);
    }
  }
  assert.fail("no picture has been saved");
}

// More vertices than are drawn: the page says so, and the graph is the same.
async function check_large_mesh() {
  const mesh = tori(1, 400, 300);
  write_mesh("large", mesh, mesh.points.map(([x, , z]) => z + 0.1 * x));
  const prefix = run_tool("large", "large", []);
  const size = readFileSync(`${prefix}.html`).length;
  assert.ok(size < 8e6, `${size} bytes`);
  await open(prefix);
  const { nodes, arcs } = await browser.evaluate(graph_of_page);
  const files = read_results(prefix);
  assert.deepEqual(nodes, files.nodes);
  assert.deepEqual(sorted(arcs), sorted(files.arcs));
  const drawn = await browser.evaluate("reeb_graph_page.data.vertices.length");
  assert.ok(drawn <= 100000 && drawn > 30000, `${drawn} vertices`);
  assert.match(
    await browser.evaluate("document.getElementById('notes').textContent"),
    new RegExp(`drawn with ${drawn} of its vertices`),
  );
  assert.ok((await picture()).part > 0.05);

  // As if there was no graphics card: fewer triangles while the shape moves, all of them afterwards.
  await browser.evaluate("reeb_graph_page.view.is_slow = true");
  await browser.evaluate("reeb_graph_page.view.turn(0.1, 0)");
  await browser.wait_for("reeb_graph_page.view.is_coarse");
  const shown = "reeb_graph_page.view.renderer.info.render.triangles";
  const coarse = await browser.evaluate(shown);
  await browser.wait_for("!reeb_graph_page.view.is_coarse");
  await next_frame();
  const whole = await browser.evaluate(shown);
  assert.ok(coarse < whole / 5, `${coarse} of ${whole} triangles are drawn`);
  check_silence();
  const first = await browser.evaluate("performance.getEntriesByName('first picture')[0].startTime");
  console.log(`${mesh.points.length} vertices: ${size} bytes, first picture in ${first.toFixed()} ms`);
}

try {
  browser = await Headless_browser.start(chromium);
  const random = random_numbers(7);

  const smooth = tori(1, 40, 24);
  write_mesh("tori", smooth, smooth.points.map(([x, y, z]) => z + 0.3 * Math.sin(5 * x + 3 * y)));
  const prefix = run_tool("tori", "tori", ["--simplify", "0.1"]);
  await check_picture_and_pointer(prefix);
  await check_touch(prefix);
  await check_keys(prefix);
  await check_export(prefix);

  const noisy = tori(2, 24, 16, true);
  write_mesh("noisy", noisy, noisy.points.map(([x, , z]) => z + 0.02 * x + 2 * random()));
  assert.ok((await check_thresholds("noisy", [])) > 10);
  assert.ok((await check_thresholds("noisy", ["--threshold-absolute"])) > 10);

  const ties = tori(1, 30, 20);
  write_mesh("ties", ties, ties.points.map(() => Math.floor(8 * random())));
  assert.ok((await check_thresholds("ties", [])) > 4);

  await check_large_mesh();
} finally {
  await browser?.stop();
  rmSync(folder, { recursive: true, force: true });
}
