// The page: what is picked, the threshold, and how picture, diagram and panels follow them.

import { color_maps, color_table, node_colors, node_types } from "./color_maps.js";
import { Diagram, pair_kinds } from "./Diagram.js";
import { Leveled_graph, none } from "./Leveled_graph.js";
import { Surface } from "./Surface.js";
import { View } from "./View.js";

const by_id = (id) => document.getElementById(id);

// Four digits, and no exponent where none is needed.
export function format(x) {
  if (!Number.isFinite(x)) return String(x).replace("Infinity", "∞");
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e-3 && size < 1e5) return String(Number(x.toPrecision(4)));
  return x.toExponential(2);
}

function count(number, word) {
  return `${number} ${word}${number === 1 ? "" : "s"}`;
}

// Outlines of the nodes' shapes for the legend, in a square from 0 to 14.
const shape_paths = {
  maximum: "M7 1L13 12H1Z",
  minimum: "M7 13L13 2H1Z",
  split: "M2 2H12V12H2Z",
  merge: "M7 1L13 7L7 13L1 7Z",
  isolated: "M7 2A5 5 0 0 1 7 12A5 5 0 0 1 7 2Z",
  degenerate: "M7 2A5 5 0 0 1 7 12A5 5 0 0 1 7 2Z",
};

export class Page {
  constructor(data) {
    this.data = data;
    this.version = data.header.version;
    this.graph = new Leveled_graph(data);
    this.surface = new Surface(data);
    this.view = new View(by_id("canvas"), data, this.surface);
    this.diagram = new Diagram(by_id("diagram"), data, format, {
      on_hover: (pair) => this.hover(this.node_of_pair(pair)),
      on_pick: (pair) => this.pick(this.node_of_pair(pair), pair),
    });
    this.picked = null; // {kind: "node" or "arc", id}
    this.picked_pair = null;
    this.hovered = null;
    this.describe();
    this.listen();
    this.set_theme(window.matchMedia("(prefers-color-scheme: dark)").matches);
    this.set_color_map(Object.keys(color_maps)[0]);
    this.set_opacity(0.5);
    this.set_stop(data.header.first_stop);
    new ResizeObserver(() => this.view.resize()).observe(by_id("stage"));
    this.view.resize();
    this.view.render();
    const update = () => {
      this.view.update();
      requestAnimationFrame(update);
    };
    update();
  }

  // ---- panels ----

  describe() {
    const { header } = this.data;
    document.title = `Reeb graph of ${header.name}`;
    by_id("title").textContent = header.name;
    by_id("summary").textContent =
      `${header.function}; ${header.vertices} vertices, ${header.faces} faces`;
    const notes = [];
    if (header.is_decimated)
      notes.push(
        `The mesh is drawn with ${this.data.vertices.length} of its vertices; the graph is that of ` +
          "all of them.",
      );
    if (header.is_graph_simplified)
      notes.push("The finest graph here is the simplified one that the options asked for.");
    if (this.graph.number_of_stops < header.number_of_levels)
      notes.push(
        `The slider has ${this.graph.number_of_stops} of the ${header.number_of_levels} levels.`,
      );
    by_id("notes").textContent = notes.join(" ");
    by_id("generator").textContent = `${header.generator}, version ${header.version} of the page`;
    by_id("stop").max = this.graph.number_of_stops - 1;
    for (const name of Object.keys(color_maps)) by_id("color_map").add(new Option(name));
    const [low, high] = header.range;
    const labels = by_id("color_labels").children;
    [low, low / 2 + high / 2, high].forEach((x, i) => (labels[i].textContent = format(x)));
    by_id("diagram_note").textContent =
      this.diagram.number_left_out > 0
        ? `${this.diagram.number_left_out} pairs of smaller persistence are not drawn.`
        : "";
    const add_to_legend = (list, name, shape) => {
      const item = document.createElement("li");
      item.innerHTML = `<svg viewBox="0 0 14 14" aria-hidden="true">${shape}</svg>${name}`;
      by_id(list).append(item);
    };
    for (const kind of pair_kinds)
      add_to_legend("pair_kinds", kind, `<circle cx="7" cy="7" r="6" class="pair ${kind}"/>`);
    for (const type of node_types) {
      if (type === "isolated" || type === "degenerate") {
        const exists = this.graph.nodes.some((node) => this.graph.type(node) === type);
        if (!exists) continue;
      }
      const fill = node_colors[type];
      add_to_legend("node_types", type, `<path d="${shape_paths[type]}" fill="${fill}"/>`);
    }
  }

  threshold_text() {
    const { stop_lowers, stop_uppers, header } = this.data;
    const unit = header.is_threshold_absolute ? "" : " of the range";
    const lower = stop_lowers[this.graph.stop];
    const upper = stop_uppers[this.graph.stop];
    if (this.graph.stop === 0 && !(lower > 0)) return `0 to ${format(upper)}${unit}`;
    return upper === Infinity
      ? `above ${format(lower)}${unit}`
      : `${format(lower)} to ${format(upper)}${unit}`;
  }

  level_text() {
    return `level ${this.data.stop_levels[this.graph.stop]} of ${this.data.header.number_of_levels - 1}`;
  }

  counts_text() {
    const { nodes, arcs } = this.graph;
    const components = this.data.pair_kinds.filter((kind) => pair_kinds[kind] === "component").length;
    const loops = arcs.length - nodes.length + components;
    return [
      count(nodes.length, "node"),
      count(arcs.length, "arc"),
      count(loops, "loop"),
    ].join(", ");
  }

  // Names and values of what is picked, for the panel, the tooltip and the announcement.
  facts(item) {
    const { data, graph } = this;
    if (item.kind === "node") {
      const { down, up } = graph.arcs_of_node.get(item.id);
      return [
        ["node", `${graph.node_number.get(item.id)}, ${graph.type(item.id)}`],
        ["value", format(data.node_values[item.id])],
        ...this.persistence_facts(item.id),
        ["vertex", String(data.node_vertices[item.id])],
        ["arcs", `${down.length} below, ${up.length} above`],
      ];
    }
    const lower = data.arc_lowers[item.id];
    const upper = data.arc_uppers[item.id];
    const name = (node) => `${graph.node_number.get(node)} (${graph.type(node)})`;
    const persistences = [lower, upper].flatMap((node) => this.pairs_of(node)).map(
      (pair) => data.pair_persistences[pair],
    );
    return [
      ["arc", `from node ${name(lower)} to ${name(upper)}`],
      ["values", `${format(data.node_values[lower])} to ${format(data.node_values[upper])}`],
      ["persistence", this.persistence_text(Math.min(...persistences))],
      ["vertices", `${data.node_vertices[lower]}, ${data.node_vertices[upper]}`],
    ];
  }

  pairs_of(node) {
    return this.graph.pairs_of_node.get(node) ?? [];
  }

  persistence_text(persistence) {
    return this.data.header.is_threshold_absolute || !Number.isFinite(persistence)
      ? format(persistence)
      : `${format(100 * persistence)} % of the range`;
  }

  persistence_facts(node) {
    const { data } = this;
    return this.pairs_of(node)
      .filter((pair) => this.graph.is_node(data.pair_births[pair]))
      .map((pair) => {
        const kind = pair_kinds[data.pair_kinds[pair]];
        return ["persistence", `${this.persistence_text(data.pair_persistences[pair])} (${kind})`];
      });
  }

  // ---- what the user does ----

  // The finest graph of all is at 0.
  set_stop(stop) {
    this.graph.set_stop(Math.min(Math.max(stop, 0), this.graph.number_of_stops - 1));
    if (this.picked?.kind === "arc") {
      const arc = this.graph.follow(this.picked.id);
      this.picked = arc !== none && this.graph.is_arc(arc) ? { kind: "arc", id: arc } : null;
    } else if (this.picked !== null && !this.graph.is_node(this.picked.id)) {
      this.picked = null;
    }
    if (this.picked === null) this.picked_pair = null;
    this.hovered = null;
    by_id("stop").value = this.graph.stop;
    by_id("threshold").textContent = this.threshold_text();
    by_id("counts").textContent = this.counts_text();
    by_id("level").textContent = this.level_text();
    by_id("stop").setAttribute("aria-valuetext", `${this.threshold_text()}: ${this.counts_text()}`);
    this.diagram.set_threshold(this.graph, this.difference_of_threshold());
    this.view.show_graph(this.graph, ...this.emphasized());
    this.show_picked();
  }

  // What the threshold is as a difference of values, or null if that depends on the component.
  difference_of_threshold() {
    const { data } = this;
    const components = [...data.pair_kinds.keys()].filter(
      (pair) => pair_kinds[data.pair_kinds[pair]] === "component",
    );
    const lower = data.stop_lowers[this.graph.stop];
    if (data.header.is_threshold_absolute) return lower;
    if (components.length !== 1) return null;
    const [pair] = components;
    return (
      lower * (data.node_values[data.pair_deaths[pair]] - data.node_values[data.pair_births[pair]])
    );
  }

  set_threshold(threshold) {
    this.set_stop(this.graph.stop_of_threshold(threshold));
  }

  set_color_map(name) {
    by_id("color_map").value = name;
    this.view.set_color_map(color_maps[name]);
    const bar = by_id("color_bar").getContext("2d");
    const colors = new Uint8ClampedArray(color_table(color_maps[name]));
    bar.putImageData(new ImageData(colors, 256, 1), 0, 0);
  }

  set_opacity(opacity) {
    by_id("opacity").value = opacity;
    this.view.set_opacity(opacity);
  }

  set_theme(is_dark) {
    this.is_dark = is_dark;
    document.documentElement.dataset.theme = is_dark ? "dark" : "light";
    by_id("theme").textContent = is_dark ? "Light" : "Dark";
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(`--${name}`).trim();
    this.view.set_theme({
      background: color("background"),
      line: color("line"),
      picked: color("picked"),
      curve: color("curve"),
      outline: color("outline"),
    });
  }

  // The node that stands for a pair, if the pair is not cancelled.
  node_of_pair(pair) {
    if (pair === null) return null;
    const node = this.data.pair_births[pair];
    return this.graph.is_node(node) ? { kind: "node", id: node } : null;
  }

  pick(item, pair = null) {
    this.picked = item;
    this.picked_pair = pair;
    this.update_emphasis();
    this.show_picked();
    const facts = this.picked_facts();
    by_id("announcement").textContent =
      facts.length === 0 ? "nothing picked" : facts.map((fact) => fact.join(" ")).join(", ");
  }

  // The item after the picked one, or before it.
  pick_next(kind, step) {
    const items = kind === "node" ? this.graph.nodes : this.graph.arcs;
    if (items.length === 0) return;
    const place = this.picked?.kind === kind ? items.indexOf(this.picked.id) : step > 0 ? -1 : 0;
    this.pick({ kind, id: items[(place + step + items.length) % items.length] });
  }

  hover(item) {
    if (item?.kind === this.hovered?.kind && item?.id === this.hovered?.id) return;
    this.hovered = item;
    this.update_emphasis();
  }

  // Nodes and arcs, of what is picked or else under the pointer; both ends of pairs.
  emphasized() {
    const nodes = new Set();
    const arcs = new Set();
    for (const item of [this.picked, this.hovered]) {
      if (item?.kind === "node") nodes.add(item.id);
      if (item?.kind === "arc") arcs.add(item.id);
    }
    if (this.picked_pair !== null)
      for (const node of [
        this.data.pair_births[this.picked_pair],
        this.data.pair_deaths[this.picked_pair],
      ])
        if (this.graph.is_node(node)) nodes.add(node);
    return [nodes, arcs];
  }

  update_emphasis() {
    const [nodes, arcs] = this.emphasized();
    this.view.emphasize(nodes, arcs);
    const pairs = new Set();
    for (const node of nodes) for (const pair of this.pairs_of(node)) pairs.add(pair);
    for (const arc of arcs)
      for (const node of [this.data.arc_lowers[arc], this.data.arc_uppers[arc]])
        for (const pair of this.pairs_of(node)) pairs.add(pair);
    if (this.picked_pair !== null) {
      pairs.clear();
      pairs.add(this.picked_pair);
    }
    this.diagram.emphasize(pairs, this.picked_pair ?? [...pairs][0]);
  }

  picked_facts() {
    if (this.picked !== null) return this.facts(this.picked);
    if (this.picked_pair === null) return [];
    const { pair_kinds: kinds, pair_persistences } = this.data;
    return [
      ["pair", `${pair_kinds[kinds[this.picked_pair]]}, cancelled`],
      ["persistence", this.persistence_text(pair_persistences[this.picked_pair])],
    ];
  }

  show_picked() {
    const list = document.createElement("dl");
    const facts = this.picked_facts();
    for (const [name, value] of facts) {
      list.append(
        Object.assign(document.createElement("dt"), { textContent: name }),
        Object.assign(document.createElement("dd"), { textContent: value }),
      );
    }
    if (facts.length > 0) by_id("picked").replaceChildren(list);
    else by_id("picked").textContent = "Click a node or an arc, or press N or A.";
  }

  // ---- pointer and keys ----

  listen() {
    const canvas = by_id("canvas");
    let pressed = null;
    canvas.addEventListener("pointerdown", (event) => {
      pressed = [event.clientX, event.clientY];
      this.point_at(null);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0 || event.pointerType === "touch") return;
      // once in a frame at most
      this.pointer ??= requestAnimationFrame(() => {
        this.pointer = undefined;
        this.point_at(this.last_pointer);
      });
      this.last_pointer = event;
    });
    canvas.addEventListener("pointerleave", () => this.point_at(null));
    canvas.addEventListener("pointerup", (event) => {
      const moved =
        pressed === null ||
        Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4;
      pressed = null;
      if (moved || event.button !== 0) return;
      const found = this.find(event);
      this.pick(found === null ? null : this.item_of(found));
      if (event.pointerType === "touch") this.point_at(event);
    });
    by_id("stop").addEventListener("input", (event) => this.set_stop(Number(event.target.value)));
    by_id("color_map").addEventListener("change", (event) => this.set_color_map(event.target.value));
    by_id("opacity").addEventListener("input", (event) =>
      this.set_opacity(Number(event.target.value)),
    );
    by_id("has_curve").addEventListener("change", () => this.point_at(null));
    by_id("reset").addEventListener("click", () => this.view.reset_camera());
    by_id("theme").addEventListener("click", () => this.set_theme(!this.is_dark));
    by_id("export").addEventListener("click", () => this.save_picture());
    by_id("help").addEventListener("click", () => by_id("keys").showModal());
    document.addEventListener("keydown", (event) => this.press(event));
  }

  find(event) {
    const box = by_id("canvas").getBoundingClientRect();
    return this.view.find(event.clientX - box.left, event.clientY - box.top);
  }

  // The node or arc that has been found; a point of the surface belongs to an arc.
  item_of(found) {
    if (found.kind !== "surface") return found;
    const arc = this.graph.arc_of_vertex(this.surface.vertex_at(found.hit));
    return arc === none ? null : { kind: "arc", id: arc };
  }

  // Shows what is under the pointer, or nothing.
  point_at(event) {
    const found = event === null ? null : this.find(event);
    const tooltip = by_id("tooltip");
    tooltip.hidden = found === null;
    let curve = [];
    if (found === null) {
      this.hover(null);
    } else if (found.kind === "surface") {
      const { header } = this.data;
      const [low, high] = header.range;
      const step = this.surface.value_at(found.hit);
      const t = step / header.steps;
      tooltip.textContent = `value ${format((1 - t) * low + t * high)}`;
      if (by_id("has_curve").checked)
        curve = this.surface.level_set_component(found.hit.triangle, step);
      this.hover(null);
    } else {
      tooltip.textContent = this.facts(found)
        .slice(0, 3)
        .map(([name, value]) => `${name} ${value}`)
        .join(", ");
      this.hover(found);
    }
    this.view.show_curve(curve);
    if (found === null) return;
    const box = by_id("stage").getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    const is_right = x > box.width / 2;
    tooltip.style.left = is_right ? "" : `${x + 14}px`;
    tooltip.style.right = is_right ? `${box.width - x + 14}px` : "";
    tooltip.style.top = `${Math.min(y + 14, box.height - 60)}px`;
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || by_id("keys").open) return;
    const is_field = /^(INPUT|SELECT)$/.test(event.target.tagName);
    if (is_field && /^(Arrow|[a-z]$)/i.test(event.key)) return;
    const turn = Math.PI / 24;
    const pan = 0.05;
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[
      event.key
    ];
    const actions = {
      "+": () => this.view.zoom(1 / 1.15),
      "=": () => this.view.zoom(1 / 1.15),
      "-": () => this.view.zoom(1.15),
      n: () => this.pick_next("node", event.shiftKey ? -1 : 1),
      a: () => this.pick_next("arc", event.shiftKey ? -1 : 1),
      "]": () => this.set_stop(this.graph.stop + 1),
      "[": () => this.set_stop(this.graph.stop - 1),
      t: () => this.set_opacity({ 1: 0.5, 0.5: 0.2, 0.2: 0 }[this.view.opacity] ?? 1),
      c: () => this.set_next_color_map(),
      l: () => by_id("has_curve").click(),
      d: () => this.set_theme(!this.is_dark),
      r: () => this.view.reset_camera(),
      s: () => this.save_picture(),
      escape: () => this.pick(null),
      "?": () => by_id("keys").showModal(),
    };
    const action = actions[event.key.toLowerCase()];
    if (arrow !== undefined) {
      if (event.shiftKey) this.view.pan(-pan * arrow[0], -pan * arrow[1]);
      else this.view.turn(-turn * arrow[0], turn * arrow[1]);
    } else if (action !== undefined) {
      action();
    } else {
      return;
    }
    event.preventDefault();
  }

  set_next_color_map() {
    const names = Object.keys(color_maps);
    this.set_color_map(names[(names.indexOf(by_id("color_map").value) + 1) % names.length]);
  }

  // The view with its legend.
  save_picture() {
    const canvas = this.view.picture();
    const context = canvas.getContext("2d");
    const scale = canvas.width / by_id("canvas").clientWidth;
    const [x, height] = [24 * scale, 12 * scale];
    const width = 230 * scale;
    const y = canvas.height - 48 * scale;
    context.imageSmoothingEnabled = true;
    context.drawImage(by_id("color_bar"), x, y, width, height);
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--text");
    context.font = `${12 * scale}px sans-serif`;
    [...by_id("color_labels").children].forEach((label, i) => {
      context.textAlign = ["left", "center", "right"][i];
      context.fillText(label.textContent, x + (i * width) / 2, y + height + 15 * scale);
    });
    canvas.toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = `${this.data.header.name.replace(/\.[^.]*$/, "")}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }, "image/png");
  }
}
