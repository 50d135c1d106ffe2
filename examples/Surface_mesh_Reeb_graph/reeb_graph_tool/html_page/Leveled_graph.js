// The Reeb graph at all the thresholds of the page. Nodes and arcs have the numbers of the data, in
// which a node keeps its number while it exists, and an arc while it has the same ends and region.

const none = 0xffffffff;

function type_of_node(down, up) {
  if (down === 0 && up === 1) return "minimum";
  if (down === 1 && up === 0) return "maximum";
  if (down === 1 && up === 2) return "split";
  if (down === 2 && up === 1) return "merge";
  return down === 0 && up === 0 ? "isolated" : "degenerate";
}

export class Leveled_graph {
  constructor(data) {
    this.data = data;
    this.number_of_stops = data.stop_levels.length;
    // the places of the arcs' inner points
    this.first_point = new Uint32Array(data.arc_sizes.length + 1);
    for (let a = 0; a < data.arc_sizes.length; ++a)
      this.first_point[a + 1] = this.first_point[a] + data.arc_sizes[a];
    // where the groups of an arc without a single heir go
    this.partings = new Map();
    for (let i = 0; i < data.parting_arcs.length; ++i) {
      const arc = data.parting_arcs[i];
      if (!this.partings.has(arc)) this.partings.set(arc, new Map());
      this.partings.get(arc).set(data.parting_groups[i], data.parting_heirs[i]);
    }
    this.pairs_of_node = new Map();
    for (let p = 0; p < data.pair_kinds.length; ++p)
      for (const node of new Set([data.pair_births[p], data.pair_deaths[p]])) {
        if (!this.pairs_of_node.has(node)) this.pairs_of_node.set(node, []);
        this.pairs_of_node.get(node).push(p);
      }
    this.set_stop(data.header.first_stop);
  }

  // The coarsest stop whose thresholds are not all larger.
  stop_of_threshold(threshold) {
    let stop = this.number_of_stops - 1;
    while (stop > 0 && !(this.data.stop_lowers[stop] < threshold)) --stop;
    return stop;
  }

  set_stop(stop) {
    const { data } = this;
    this.stop = stop;
    this.nodes = [];
    this.arcs = [];
    this.node_number = new Map(); // in the files that the tool writes for this threshold
    for (let n = 0; n < data.node_ends.length; ++n)
      if (stop < data.node_ends[n]) {
        this.node_number.set(n, this.nodes.length);
        this.nodes.push(n);
      }
    this.arcs_of_node = new Map(this.nodes.map((n) => [n, { down: [], up: [] }]));
    for (let a = 0; a < data.arc_ends.length; ++a)
      if (this.is_arc(a)) {
        this.arcs.push(a);
        this.arcs_of_node.get(data.arc_lowers[a]).up.push(a);
        this.arcs_of_node.get(data.arc_uppers[a]).down.push(a);
      }
    this.arc_of_group = undefined; // found on demand
  }

  is_node(node) {
    return this.node_number.has(node);
  }

  is_arc(arc) {
    return this.data.arc_begins[arc] <= this.stop && this.stop < this.data.arc_ends[arc];
  }

  type(node) {
    const { down, up } = this.arcs_of_node.get(node);
    return type_of_node(down.length, up.length);
  }

  number_of_points(arc) {
    return this.data.arc_sizes[arc] + 2;
  }

  // All points of an arc, its ends included.
  polyline(arc) {
    const { arc_lowers, arc_uppers, node_places, arc_points } = this.data;
    const node_place = (n) => node_places.subarray(3 * n, 3 * n + 3);
    const inner = arc_points.subarray(3 * this.first_point[arc], 3 * this.first_point[arc + 1]);
    return [...node_place(arc_lowers[arc]), ...inner, ...node_place(arc_uppers[arc])];
  }

  // The arc that has a group of vertices.
  arc_with_group(group) {
    if (this.arc_of_group === undefined) {
      this.arc_of_group = new Uint32Array(this.data.group_arcs.length);
      for (let g = 0; g < this.arc_of_group.length; ++g)
        this.arc_of_group[g] = this.follow(this.data.group_arcs[g], g);
    }
    return this.arc_of_group[group];
  }

  // The arc of the picture's vertex, or none.
  arc_of_vertex(vertex) {
    const group = this.data.groups[vertex];
    return group === none ? none : this.arc_with_group(group);
  }

  // Where an arc is at this stop, or a group of it.
  follow(arc, group) {
    const { arc_ends, arc_heirs } = this.data;
    while (arc !== none && arc_ends[arc] <= this.stop)
      arc = arc_heirs[arc] !== none ? arc_heirs[arc] : this.heir_of_group(arc, group);
    return arc;
  }

  heir_of_group(arc, group) {
    const heirs = this.partings.get(arc);
    if (heirs === undefined) return none;
    return heirs.get(group ?? heirs.keys().next().value);
  }
}

export { none };
