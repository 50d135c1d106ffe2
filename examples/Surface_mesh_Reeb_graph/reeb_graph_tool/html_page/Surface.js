// The triangles of the picture: where a ray meets them, and level sets of the function.

export class Surface {
  constructor(data) {
    this.points = data.points;
    this.triangles = data.triangles;
    this.values = data.values;
  }

  // The first triangle that a ray meets: its number, the distance, and barycentric coordinates.
  first_hit(origin, direction) {
    const { points, triangles } = this;
    const [ox, oy, oz] = origin;
    const [dx, dy, dz] = direction;
    let hit = null;
    let closest = Infinity;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t];
      const b = 3 * triangles[t + 1];
      const c = 3 * triangles[t + 2];
      const ax = points[a], ay = points[a + 1], az = points[a + 2];
      const ux = points[b] - ax, uy = points[b + 1] - ay, uz = points[b + 2] - az;
      const vx = points[c] - ax, vy = points[c + 1] - ay, vz = points[c + 2] - az;
      const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
      const determinant = ux * px + uy * py + uz * pz;
      if (determinant === 0) continue;
      const sx = ox - ax, sy = oy - ay, sz = oz - az;
      const u = (sx * px + sy * py + sz * pz) / determinant;
      if (u < 0 || u > 1) continue;
      const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
      const v = (dx * qx + dy * qy + dz * qz) / determinant;
      if (v < 0 || u + v > 1) continue;
      const distance = (vx * qx + vy * qy + vz * qz) / determinant;
      if (distance > 0 && distance < closest) {
        closest = distance;
        hit = { triangle: t / 3, distance, weights: [1 - u - v, u, v] };
      }
    }
    return hit;
  }

  // The value, in steps, at a hit.
  value_at({ triangle, weights }) {
    return weights.reduce(
      (sum, weight, i) => sum + weight * this.values[this.triangles[3 * triangle + i]],
      0,
    );
  }

  // The corner next to a hit.
  vertex_at({ triangle, weights }) {
    return this.triangles[3 * triangle + weights.indexOf(Math.max(...weights))];
  }

  // The component of a level set that passes a triangle: segments, two points each.
  level_set_component(triangle, value) {
    this.neighbors ??= this.find_neighbors();
    const segments = [];
    const seen = new Set([triangle]);
    const waiting = [triangle];
    while (waiting.length > 0) {
      const t = waiting.pop();
      for (let i = 0; i < 3; ++i) {
        const a = this.triangles[3 * t + i];
        const b = this.triangles[3 * t + ((i + 1) % 3)];
        if (this.values[a] < value === this.values[b] < value) continue;
        const s = (value - this.values[a]) / (this.values[b] - this.values[a]);
        for (let k = 0; k < 3; ++k)
          segments.push((1 - s) * this.points[3 * a + k] + s * this.points[3 * b + k]);
        const neighbor = this.neighbors[3 * t + i];
        if (neighbor >= 0 && !seen.has(neighbor)) {
          seen.add(neighbor);
          waiting.push(neighbor);
        }
      }
    }
    return segments;
  }

  // Fewer triangles between some of the vertices: those in a cell of a grid become one.
  coarse_triangles(cells_per_unit) {
    const cells = new Map();
    const number = this.points.length / 3;
    const kept = new Uint32Array(number);
    for (let v = 0; v < number; ++v) {
      let cell = 0;
      for (let k = 0; k < 3; ++k)
        cell = cell * 4 * cells_per_unit + Math.floor((this.points[3 * v + k] + 2) * cells_per_unit);
      if (!cells.has(cell)) cells.set(cell, v);
      kept[v] = cells.get(cell);
    }
    const result = [];
    for (let t = 0; t < this.triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => kept[this.triangles[t + i]]);
      if (a !== b && b !== c && c !== a) result.push(a, b, c);
    }
    return Uint32Array.from(result);
  }

  // By corner: the triangle beyond the edge that begins there, or -1. At edges of more than two
  // triangles, which a coarser picture may have, some are neighbors of none.
  find_neighbors() {
    const { triangles } = this;
    const first = new Uint32Array(this.points.length / 3 + 1);
    const smaller_end = (corner) => Math.min(triangles[corner], triangles[next(corner)]);
    const larger_end = (corner) => Math.max(triangles[corner], triangles[next(corner)]);
    const next = (corner) => (corner % 3 === 2 ? corner - 2 : corner + 1);
    for (let corner = 0; corner < triangles.length; ++corner) ++first[smaller_end(corner) + 1];
    for (let v = 1; v < first.length; ++v) first[v] += first[v - 1];
    const corners = new Uint32Array(triangles.length);
    const filled = first.slice();
    for (let corner = 0; corner < triangles.length; ++corner)
      corners[filled[smaller_end(corner)]++] = corner;
    const neighbors = new Int32Array(triangles.length).fill(-1);
    for (let v = 0; v + 1 < first.length; ++v)
      for (let i = first[v]; i < first[v + 1]; ++i)
        for (let j = i + 1; j < first[v + 1] && neighbors[corners[i]] < 0; ++j)
          if (
            neighbors[corners[j]] < 0 &&
            larger_end(corners[i]) === larger_end(corners[j])
          ) {
            neighbors[corners[i]] = Math.floor(corners[j] / 3);
            neighbors[corners[j]] = Math.floor(corners[i] / 3);
          }
    return neighbors;
  }
}
