// The persistence diagram as an SVG: birth to the right, death upwards.

const size = 300;
const margin = { left: 46, right: 10, top: 10, bottom: 36 };
const most_pairs = 1500; // so that it stays fluent; the least persistent ones are left out

export const pair_kinds = ["minimum", "maximum", "component", "loop"];

function element(name, attributes, text = "") {
  const result = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.textContent = text;
  return result;
}

export class Diagram {
  // `on_hover` and `on_pick` are called with the number of a pair, or null.
  constructor(svg, data, format, { on_hover, on_pick }) {
    this.svg = svg;
    this.data = data;
    const number = data.pair_kinds.length;
    this.order = Array.from({ length: number }, (_, p) => p)
      .sort((p, q) => data.pair_persistences[q] - data.pair_persistences[p])
      .slice(0, most_pairs);
    this.number_left_out = number - this.order.length;
    [this.low, this.high] = data.header.range;
    this.marks = new Map();
    this.draw(format);
    svg.addEventListener("pointermove", (event) => on_hover(this.pair_of(event)));
    svg.addEventListener("pointerleave", () => on_hover(null));
    svg.addEventListener("click", (event) => on_pick(this.pair_of(event)));
    svg.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (step === undefined || this.order.length === 0) return;
      event.preventDefault();
      event.stopPropagation();
      const place = this.order.indexOf(this.picked) + step;
      on_pick(this.order[Math.min(Math.max(place, 0), this.order.length - 1)]);
    });
  }

  x(value) {
    return margin.left + this.fraction(value) * (size - margin.left - margin.right);
  }

  y(value) {
    return size - margin.bottom - this.fraction(value) * (size - margin.top - margin.bottom);
  }

  // halves, since the difference of two finite numbers may overflow
  fraction(value) {
    const half_length = this.high / 2 - this.low / 2;
    const t = half_length > 0 ? (value / 2 - this.low / 2) / half_length : 0.5;
    return Math.min(Math.max(t, 0), 1);
  }

  draw(format) {
    const { svg, data, low, high } = this;
    svg.setAttribute("viewBox", `0 0 ${size} ${size}`);
    const [left, right, bottom, top] = [this.x(low), this.x(high), this.y(low), this.y(high)];
    this.band = element("path", { class: "band" });
    svg.append(
      this.band,
      element("path", { class: "axis", d: `M${left} ${top}V${bottom}H${right}` }),
      element("path", { class: "diagonal", d: `M${left} ${bottom}L${right} ${top}` }),
      element("text", { x: left, y: bottom + 14 }, format(low)),
      element("text", { x: right, y: bottom + 14, "text-anchor": "end" }, format(high)),
      element("text", { x: (left + right) / 2, y: bottom + 30, "text-anchor": "middle" }, "birth"),
      element("text", { x: left - 5, y: bottom, "text-anchor": "end" }, format(low)),
      element("text", { x: left - 5, y: top + 8, "text-anchor": "end" }, format(high)),
      element(
        "text",
        { transform: `translate(14 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle" },
        "death",
      ),
    );
    for (const p of [...this.order].reverse()) {
      const mark = element("circle", {
        cx: this.x(data.node_values[data.pair_births[p]]),
        cy: this.y(data.node_values[data.pair_deaths[p]]),
        r: 4.5,
        class: `pair ${pair_kinds[data.pair_kinds[p]]}`,
      });
      this.marks.set(p, mark);
      svg.append(mark);
    }
  }

  // The pair next to the pointer.
  pair_of(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = size / box.width;
    const x = (event.clientX - box.left) * scale;
    const y = (event.clientY - box.top) * scale;
    let closest = 9;
    let result = null;
    for (const [p, mark] of this.marks) {
      const distance = Math.hypot(mark.cx.baseVal.value - x, mark.cy.baseVal.value - y);
      if (distance < closest) {
        closest = distance;
        result = p;
      }
    }
    return result;
  }

  // Shows what is cancelled below a threshold; `difference` of values is its width, or null.
  set_threshold(graph, difference) {
    for (const [p, mark] of this.marks)
      mark.classList.toggle("cancelled", !graph.is_node(this.data.pair_births[p]));
    const { low, high } = this;
    const width = difference === null ? 0 : Math.min(difference, high - low);
    const line = (birth, death) => `${this.x(birth)} ${this.y(death)}`;
    this.band.setAttribute(
      "d",
      width > 0
        ? `M${line(low, low)}L${line(low, low + width)}L${line(high - width, high)}` +
            `L${line(high, high)}L${line(high, high - width)}L${line(low + width, low)}Z`
        : "",
    );
  }

  emphasize(pairs, picked) {
    this.picked = picked;
    for (const [p, mark] of this.marks) {
      const is_emphasized = pairs.has(p);
      mark.classList.toggle("emphasized", is_emphasized);
      mark.setAttribute("r", is_emphasized ? 7 : 4.5);
    }
  }
}
