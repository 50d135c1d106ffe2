// The picture: surface, arcs and nodes in a canvas, and what of them is under the pointer.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  Matrix4,
  Mesh,
  PerspectiveCamera,
  Points,
  Quaternion,
  Raycaster,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { TrackballControls } from "three/addons/controls/TrackballControls.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { color_table, node_colors, node_types } from "./color_maps.js";

const field_of_view = 30; // degrees
const far_away = 1e6;

// The colors of ShaderMaterial are those of the screen; three.js leaves them as they are.
const surface_shader = {
  vertexShader: `
    attribute float value;
    attribute float lit;
    varying vec3 v_normal, v_position;
    varying float v_value, v_lit;
    void main() {
      vec4 position_in_view = modelViewMatrix * vec4(position, 1.0);
      v_normal = normalMatrix * normal;
      v_position = position_in_view.xyz;
      v_value = value;
      v_lit = lit;
      gl_Position = projectionMatrix * position_in_view;
    }`,
  fragmentShader: `
    uniform sampler2D color_map;
    uniform float opacity, has_lit_region;
    varying vec3 v_normal, v_position;
    varying float v_value, v_lit;
    void main() {
      vec3 n = normalize(v_normal), eye = -normalize(v_position);
      float facing = abs(dot(n, eye));
      vec3 color = texture2D(color_map, vec2(v_value, 0.5)).rgb;
      float is_lit = has_lit_region * step(0.5, v_lit);
      float is_dimmed = has_lit_region * (1.0 - step(0.5, v_lit));
      color = mix(color, vec3(dot(color, vec3(0.3, 0.5, 0.2))), 0.8 * is_dimmed);
      float light = 0.4 + 0.6 * facing;
      float shine = 0.15 * pow(facing, 30.0);
      color = color * light + shine + 0.12 * is_lit;
      // a surface seen from the side hides more, as glass does
      float alpha = mix(1.0 - (1.0 - opacity) * facing, opacity, 0.6);
      alpha = mix(alpha, max(alpha, 0.85), is_lit) * (1.0 - 0.5 * is_dimmed * step(opacity, 0.99));
      gl_FragColor = vec4(color, alpha);
    }`,
};

const node_shader = {
  vertexShader: `
    attribute vec3 color;
    attribute float shape, size;
    varying vec3 v_color;
    varying float v_shape, v_size;
    uniform float pixel_ratio;
    void main() {
      v_color = color;
      v_shape = shape;
      v_size = size;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      gl_Position.z -= 0.002 * gl_Position.w; // in front of the surface that it lies on
      gl_PointSize = pixel_ratio * size;
    }`,
  fragmentShader: `
    varying vec3 v_color;
    varying float v_shape, v_size;
    uniform vec3 outline, picked;
    uniform float picked_size;
    // the distance from the outline of a shape, negative inside, in a square from -1 to 1
    float distance_from(vec2 p) {
      if (v_shape < 0.5) return max(-p.y - 0.75, abs(p.x) * 0.87 + p.y * 0.5 - 0.42); // up
      if (v_shape < 1.5) return max(p.y - 0.75, abs(p.x) * 0.87 - p.y * 0.5 - 0.42);  // down
      if (v_shape < 2.5) return max(abs(p.x), abs(p.y)) - 0.68;
      if (v_shape < 3.5) return (abs(p.x) + abs(p.y)) * 0.72 - 0.66;
      return length(p) - 0.75;
    }
    void main() {
      vec2 p = 2.0 * gl_PointCoord - 1.0;
      p.y = -p.y;
      float d = distance_from(p), pixel = 2.0 / v_size;
      if (d > 0.5 * pixel) discard;
      bool is_picked = v_size > picked_size - 0.5;
      float width = is_picked ? 3.8 : 1.8;
      vec3 rim = is_picked ? picked : outline;
      vec3 color = mix(v_color, rim, smoothstep(-width * pixel, (1.0 - width) * pixel, d));
      gl_FragColor = vec4(color, 1.0);
    }`,
};

// 0: a triangle that points up, 1: down, 2: a square, 3: a diamond, 4: a circle.
const node_shapes = { maximum: 0, minimum: 1, split: 2, merge: 3, isolated: 4, degenerate: 4 };

const sizes = { node: 19, picked_node: 30, arc: 3.5, picked_arc: 8, curve: 2.5 }; // pixels
const smallest_sizes = { node: 4, arc: 1 }; // where there are very many
const many_nodes = 150;
// Without a graphics card, frames take longer than this; then a coarser surface is drawn while the
// shape moves, and the whole one when it has been at rest for a while. (milliseconds)
const slow_frame = 50; // on average, of some in a row
const slow_frames = 4;
const rest = 250;
const coarse_cells = 24; // in half the diagonal of the box

const reach = { node: 12, arc: 7 }; // how near a pointer must come, in pixels

export class View {
  constructor(canvas, data, surface) {
    this.data = data;
    this.surface = surface;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.camera = new PerspectiveCamera(field_of_view, 1, 0.05, 100);
    this.controls = new TrackballControls(this.camera, canvas);
    this.controls.staticMoving = true;
    this.controls.rotateSpeed = 2.5;
    this.controls.keys = [null, null, null]; // the page has its own
    this.controls.addEventListener("change", () => this.note_motion());
    this.last_motion = -Infinity;
    this.last_update = 0;
    this.frame_times = []; // of frames in a row
    this.is_slow = false;
    this.scene = new Scene();
    this.add_surface();
    this.add_graph();
    this.reset_camera();
  }

  add_surface() {
    const { data } = this;
    const geometry = new BufferGeometry();
    const number = data.points.length / 3;
    geometry.setAttribute("position", new BufferAttribute(data.points, 3));
    geometry.setIndex(new BufferAttribute(data.triangles, 1));
    geometry.computeVertexNormals();
    const values = Float32Array.from(data.values, (value) => value / data.header.steps);
    geometry.setAttribute("value", new BufferAttribute(values, 1));
    this.lit = new BufferAttribute(new Float32Array(number), 1);
    geometry.setAttribute("lit", this.lit);
    const uniforms = {
      color_map: { value: null },
      opacity: { value: 1 },
      has_lit_region: { value: 0 },
    };
    this.surface_material = new ShaderMaterial({
      ...surface_shader,
      uniforms,
      side: 2,
      transparent: true,
    });
    // Only the front of the surface is blended: a first pass finds it.
    const depth_material = this.surface_material.clone();
    depth_material.colorWrite = false;
    const front = new Mesh(geometry, depth_material);
    front.renderOrder = 1;
    const colored = new Mesh(geometry, this.surface_material);
    colored.renderOrder = 2;
    this.surface_meshes = [front, colored];
    this.whole_geometry = geometry;
    this.scene.add(front, colored);
  }

  add_graph() {
    const lines = (width) => {
      const line = new LineSegments2(
        new LineSegmentsGeometry(),
        new LineMaterial({ linewidth: width }),
      );
      line.frustumCulled = false;
      line.visible = false;
      this.scene.add(line);
      return line;
    };
    this.arc_lines = lines(sizes.arc);
    this.picked_lines = lines(sizes.picked_arc);
    this.curve_lines = lines(sizes.curve);
    // These are drawn after the surface, and what is picked shines through everything.
    for (const [i, line] of [this.curve_lines, this.picked_lines].entries()) {
      line.renderOrder = 3 + i;
      line.material.transparent = true;
    }
    this.picked_lines.material.depthTest = false;
    // in front of the surface that it lies on
    this.curve_lines.material.polygonOffset = true;
    this.curve_lines.material.polygonOffsetUnits = -200;
    this.node_material = new ShaderMaterial({
      ...node_shader,
      uniforms: {
        pixel_ratio: { value: 1 },
        picked_size: { value: sizes.picked_node },
        outline: { value: null },
        picked: { value: null },
      },
    });
    this.node_points = new Points(new BufferGeometry(), this.node_material);
    this.node_points.frustumCulled = false;
    this.scene.add(this.node_points);
  }

  // ---- what is shown ----

  set_color_map(color_map) {
    const table = color_table(color_map);
    const texture = new DataTexture(table, table.length / 4, 1);
    texture.magFilter = texture.minFilter = 1006; // linear
    texture.needsUpdate = true;
    for (const { material } of this.surface_meshes) material.uniforms.color_map.value = texture;
    this.request_frame();
  }

  set_opacity(opacity) {
    this.opacity = opacity;
    for (const mesh of this.surface_meshes) {
      mesh.material.uniforms.opacity.value = opacity;
      mesh.visible = opacity > 0;
    }
    this.request_frame();
  }

  set_theme({ background, line, picked, curve, outline }) {
    this.renderer.setClearColor(new Color(background));
    this.arc_lines.material.color.set(line);
    this.picked_lines.material.color.set(picked);
    this.curve_lines.material.color.set(curve);
    this.node_material.uniforms.outline.value = color_of_screen(outline);
    this.node_material.uniforms.picked.value = color_of_screen(picked);
    this.request_frame();
  }

  // Draws a graph, with some nodes and arcs emphasized.
  show_graph(graph, emphasized_nodes, emphasized_arcs) {
    this.graph = graph;
    const { nodes } = graph;
    const crowding = Math.min(Math.sqrt(many_nodes / nodes.length), 1);
    const size = (kind) => Math.max(sizes[kind] * crowding, smallest_sizes[kind]);
    this.node_size = size("node");
    this.arc_lines.material.linewidth = size("arc");
    this.set_arcs(graph);
    const places = new Float32Array(3 * nodes.length);
    const colors = new Float32Array(3 * nodes.length);
    const shapes = new Float32Array(nodes.length);
    this.node_sizes = new BufferAttribute(new Float32Array(nodes.length), 1);
    const color_of_type = Object.fromEntries(
      node_types.map((type) => [type, color_of_screen(node_colors[type]).toArray()]),
    );
    nodes.forEach((node, i) => {
      const type = graph.type(node);
      places.set(this.data.node_places.subarray(3 * node, 3 * node + 3), 3 * i);
      colors.set(color_of_type[type], 3 * i);
      shapes[i] = node_shapes[type];
    });
    this.shown_places = places;
    this.node_points.geometry.dispose();
    this.node_points.geometry = new BufferGeometry()
      .setAttribute("position", new BufferAttribute(places, 3))
      .setAttribute("color", new BufferAttribute(colors, 3))
      .setAttribute("shape", new BufferAttribute(shapes, 1))
      .setAttribute("size", this.node_sizes);
    this.emphasize(emphasized_nodes, emphasized_arcs);
  }

  set_arcs(graph) {
    const lengths = graph.arcs.map((arc) => graph.number_of_points(arc));
    const number = lengths.reduce((sum, length) => sum + length, 0);
    this.arc_points = new Float32Array(3 * number);
    this.arc_of_point = new Uint32Array(number);
    const ends = new Float32Array(6 * (number - graph.arcs.length)); // of segments
    let point = 0;
    let segment = 0;
    graph.arcs.forEach((arc, i) => {
      const polyline = graph.polyline(arc);
      this.arc_points.set(polyline, 3 * point);
      this.arc_of_point.fill(arc, point, point + lengths[i]);
      ends.set(segments(polyline), 6 * segment);
      point += lengths[i];
      segment += lengths[i] - 1;
    });
    this.set_segments(this.arc_lines, ends);
  }

  emphasize(nodes, arcs) {
    this.graph.nodes.forEach((node, i) => {
      this.node_sizes.array[i] = nodes.has(node) ? sizes.picked_node : this.node_size;
    });
    this.node_sizes.needsUpdate = true;
    this.set_segments(
      this.picked_lines,
      [...arcs].flatMap((a) => segments(this.graph.polyline(a))),
    );
    const has_region = arcs.size > 0;
    for (const { material } of this.surface_meshes)
      material.uniforms.has_lit_region.value = Number(has_region);
    if (has_region) {
      for (let v = 0; v < this.lit.array.length; ++v)
        this.lit.array[v] = Number(arcs.has(this.graph.arc_of_vertex(v)));
      this.lit.needsUpdate = true;
    }
    this.request_frame();
  }

  show_curve(curve) {
    this.set_segments(this.curve_lines, curve);
    this.request_frame();
  }

  set_segments(line, positions) {
    line.visible = positions.length > 0;
    if (!line.visible) return;
    line.geometry.dispose();
    line.geometry = new LineSegmentsGeometry().setPositions(positions);
  }

  // ---- camera ----

  // Looks along the shortest side of the box, a bit from above.
  reset_camera() {
    const lengths = this.data.header.box.map(([low, high]) => high - low);
    const shortest = lengths.indexOf(Math.min(...lengths));
    const up = shortest === 1 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
    const forward = new Vector3().setComponent(shortest, 1);
    const right = new Vector3().crossVectors(up, forward);
    const distance = 1.05 / Math.sin((field_of_view / 2) * (Math.PI / 180));
    this.camera.up.copy(up);
    this.camera.position
      .copy(forward)
      .addScaledVector(up, 0.25)
      .addScaledVector(right, 0.35)
      .setLength(distance);
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.request_frame();
  }

  // Turns by angles about the vertical and the horizontal axis of the screen.
  turn(about_vertical, about_horizontal) {
    const { camera, controls } = this;
    const offset = camera.position.clone().sub(controls.target);
    const right = new Vector3().crossVectors(camera.up, offset).normalize();
    const rotation = new Quaternion()
      .setFromAxisAngle(camera.up.clone().normalize(), about_vertical)
      .multiply(new Quaternion().setFromAxisAngle(right, about_horizontal));
    camera.up.applyQuaternion(rotation);
    camera.position.copy(controls.target).add(offset.applyQuaternion(rotation));
    controls.update();
    this.note_motion();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.note_motion();
  }

  pan(right, up) {
    const { camera, controls } = this;
    const offset = camera.position.clone().sub(controls.target);
    const scale = offset.length() * 0.5;
    const direction = new Vector3().crossVectors(camera.up, offset).setLength(right * scale);
    direction.addScaledVector(camera.up.clone().normalize(), up * scale);
    camera.position.add(direction);
    controls.target.add(direction);
    controls.update();
    this.note_motion();
  }

  // ---- drawing ----

  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    // the shape fits into high canvases, too
    this.camera.fov =
      width >= height
        ? field_of_view
        : (360 / Math.PI) *
          Math.atan((Math.tan((field_of_view * Math.PI) / 360) * height) / width);
    this.camera.updateProjectionMatrix();
    this.set_pixel_ratio(window.devicePixelRatio);
    this.controls.handleResize();
    this.request_frame();
  }

  set_pixel_ratio(ratio) {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.node_material.uniforms.pixel_ratio.value = ratio;
  }

  request_frame() {
    this.is_frame_wanted = true;
  }

  note_motion() {
    this.last_motion = performance.now();
    this.request_frame();
  }

  // Is called before every frame of the screen.
  update() {
    this.controls.update();
    const now = performance.now();
    const is_moving = this.last_motion >= this.last_update || now - this.last_motion < rest;
    if (!is_moving && this.is_coarse) this.request_frame();
    if (is_moving && this.is_frame_wanted && this.was_frame_wanted)
      this.frame_times.push(now - this.last_update);
    else this.frame_times = [];
    if (this.frame_times.length >= slow_frames) {
      // one may have had other reasons
      const times = this.frame_times.splice(0).sort((a, b) => a - b).slice(0, -1);
      const sum = times.reduce((s, time) => s + time, 0);
      this.is_slow ||= sum > times.length * slow_frame;
    }
    this.last_update = now;
    this.was_frame_wanted = this.is_frame_wanted;
    if (!this.is_frame_wanted) return;
    this.is_frame_wanted = false;
    this.set_coarse(is_moving && this.is_slow);
    this.render();
  }

  set_coarse(is_coarse) {
    this.is_coarse = is_coarse;
    if (is_coarse) this.coarse_geometry ??= this.make_coarse_geometry();
    for (const mesh of this.surface_meshes)
      mesh.geometry = is_coarse ? this.coarse_geometry : this.whole_geometry;
  }

  // The vertices are shared.
  make_coarse_geometry() {
    const geometry = new BufferGeometry();
    for (const [name, attribute] of Object.entries(this.whole_geometry.attributes))
      geometry.setAttribute(name, attribute);
    const triangles = this.surface.coarse_triangles(coarse_cells);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    return geometry;
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }

  // A copy of the picture with at least two pixels for one of the screen.
  picture() {
    this.set_coarse(false);
    this.set_pixel_ratio(Math.max(2, window.devicePixelRatio));
    this.render();
    const { domElement } = this.renderer;
    const copy = document.createElement("canvas");
    copy.width = domElement.width;
    copy.height = domElement.height;
    copy.getContext("2d").drawImage(domElement, 0, 0);
    this.set_pixel_ratio(window.devicePixelRatio);
    this.render();
    return copy;
  }

  // ---- picking ----

  // The places of points in the canvas, in pixels, each with its depth.
  project(points) {
    this.camera.updateMatrixWorld();
    const { clientWidth, clientHeight } = this.renderer.domElement;
    const m = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    ).elements;
    const result = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i];
      const y = points[i + 1];
      const z = points[i + 2];
      const w = m[3] * x + m[7] * y + m[11] * z + m[15]; // negative behind the eye
      const px = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
      const py = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
      result[i] = w > 0 ? ((1 + px) / 2) * clientWidth : far_away;
      result[i + 1] = w > 0 ? ((1 - py) / 2) * clientHeight : far_away;
      result[i + 2] = w;
    }
    return result;
  }

  node_on_screen(node) {
    const [x, y] = this.project(this.data.node_places.subarray(3 * node, 3 * node + 3));
    return { x, y };
  }

  // What is at a place in the canvas: a node, an arc, or a point of the surface.
  find(x, y) {
    this.camera.updateMatrixWorld();
    const { clientWidth, clientHeight } = this.renderer.domElement;
    const raycaster = new Raycaster();
    raycaster.setFromCamera(
      new Vector2((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight),
      this.camera,
    );
    const { origin, direction } = raycaster.ray;
    const hit =
      this.opacity > 0 ? this.surface.first_hit(origin.toArray(), direction.toArray()) : null;
    // What an opaque surface hides cannot be meant.
    let limit = Infinity;
    if (hit !== null && this.opacity >= 1)
      limit = hit.distance * direction.dot(this.camera.getWorldDirection(new Vector3())) + 0.02;
    const node = this.closest_node(x, y, limit);
    if (node !== null) return { kind: "node", id: node };
    const arc = this.closest_arc(x, y, limit);
    if (arc !== null) return { kind: "arc", id: arc };
    return hit === null ? null : { kind: "surface", hit };
  }

  closest_node(x, y, limit) {
    const places = this.project(this.shown_places);
    let closest = reach.node;
    let result = null;
    this.graph.nodes.forEach((node, i) => {
      const distance = Math.hypot(places[3 * i] - x, places[3 * i + 1] - y);
      if (distance < closest && places[3 * i + 2] <= limit) {
        closest = distance;
        result = node;
      }
    });
    return result;
  }

  closest_arc(x, y, limit) {
    const places = this.project(this.arc_points);
    let closest = reach.arc;
    let result = null;
    for (let i = 1; i < this.arc_of_point.length; ++i) {
      if (this.arc_of_point[i] !== this.arc_of_point[i - 1]) continue;
      const p = 3 * i - 3;
      const q = 3 * i;
      if (places[p] === far_away || places[q] === far_away) continue;
      if (places[p + 2] > limit && places[q + 2] > limit) continue;
      const distance = distance_to_segment(
        x,
        y,
        places[p],
        places[p + 1],
        places[q],
        places[q + 1],
      );
      if (distance < closest) {
        closest = distance;
        result = this.arc_of_point[i];
      }
    }
    return result;
  }
}

// A color for our shaders, whose colors are those of the screen.
function color_of_screen(style) {
  return new Color().setStyle(style, "");
}

// A polyline as segments of two points each.
function segments(polyline) {
  const result = [];
  for (let i = 3; i < polyline.length; i += 3)
    for (let k = i - 3; k < i + 3; ++k) result.push(polyline[k]);
  return result;
}

function distance_to_segment(x, y, px, py, qx, qy) {
  const dx = qx - px;
  const dy = qy - py;
  const square = dx * dx + dy * dy;
  const t = square === 0 ? 0 : ((x - px) * dx + (y - py) * dy) / square;
  const clamped = Math.min(Math.max(t, 0), 1);
  return Math.hypot(px + clamped * dx - x, py + clamped * dy - y);
}
