// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of the topology of a mesh: faces are taken away and tubes put in.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TOPOLOGY_CHANGES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TOPOLOGY_CHANGES_H

#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <utility>
#include <vector>

namespace Robustness {

using Triangle = std::array<std::size_t, 3>;

struct Triangles
{
  std::vector<Point> points;
  std::vector<Triangle> faces;

  explicit Triangles(const Mesh& mesh) : points(mesh.points().begin(), mesh.points().end())
  {
    for (const Face f : mesh.faces())
      faces.push_back(corners(mesh, f));
  }

  static Triangle corners(const Mesh& mesh, const Face f)
  {
    Triangle result;
    std::size_t i = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      result[i++] = v;
    return result;
  }

  // Vertices where several fans meet are doubled; of several components the largest stays.
  Mesh mesh()
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    PMP::orient_polygon_soup(points, faces);
    Mesh result;
    PMP::polygon_soup_to_polygon_mesh(points, faces, result);
    PMP::keep_largest_connected_components(result, 1);
    result.collect_garbage();
    return result;
  }
};

// Distances along edges.
inline Values edge_distances(const Mesh& mesh, const Vertex source)
{
  Values distances(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  using Item = std::pair<double, Vertex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  distances[source] = 0;
  queue.emplace(0, source);
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v])
      continue;
    for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v))) {
      const double length =
          distance + std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
      if (length < distances[w]) {
        distances[w] = length;
        queue.emplace(length, w);
      }
    }
  }
  return distances;
}

inline Face face_at(const Mesh& mesh, const Vertex v)
{
  for (const Face f : mesh.faces_around_target(mesh.halfedge(v)))
    if (f != Mesh::null_face())
      return f;
  return Mesh::null_face();
}

// Replaces two faces by a tube between them: a handle more, or one component less.
inline void add_tube(Triangles& triangles, const std::size_t f, const std::size_t g)
{
  const Triangle a = triangles.faces[f], b = triangles.faces[g];
  // the turn of the second face that makes the tube shortest
  std::array<double, 3> length = {0, 0, 0};
  for (std::size_t turn = 0; turn < 3; ++turn)
    for (std::size_t i = 0; i < 3; ++i)
      length[turn] += std::sqrt(
          CGAL::squared_distance(triangles.points[a[i]], triangles.points[b[(turn + 3 - i) % 3]]));
  const std::size_t turn =
      static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
  for (const std::size_t face : {(std::max)(f, g), (std::min)(f, g)})
    triangles.faces.erase(triangles.faces.begin() + static_cast<std::ptrdiff_t>(face));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t u = b[(turn + 3 - i) % 3], v = b[(turn + 3 - j) % 3];
    triangles.faces.push_back({a[i], a[j], v});
    triangles.faces.push_back({a[i], v, u});
  }
}

// The two vertices are the nearest ones of a mesh that lie far apart on it, as hands that touch
// something do: of 40 vertices that are spread over the mesh, with all others that are farther away
// on the mesh than a fifth of the farthest.
inline std::pair<Vertex, Vertex> contact(const Mesh& mesh)
{
  std::pair<Vertex, Vertex> result;
  double least = std::numeric_limits<double>::infinity();
  Values to_sources(mesh.number_of_vertices(), least);
  Vertex source(0);
  for (int i = 0; i < 40; ++i) {
    const Values distances = edge_distances(mesh, source);
    const double farthest = *std::max_element(distances.begin(), distances.end());
    for (const Vertex v : mesh.vertices()) {
      to_sources[v] = (std::min)(to_sources[v], distances[v]);
      if (distances[v] < farthest / 5)
        continue;
      const double ratio =
          std::sqrt(CGAL::squared_distance(mesh.point(source), mesh.point(v))) / distances[v];
      if (ratio < least) {
        least = ratio;
        result = {source, v};
      }
    }
    source = Vertex(static_cast<Mesh::size_type>(
        std::max_element(to_sources.begin(), to_sources.end()) - to_sources.begin()));
  }
  return result;
}

// Two vertices with seven to nine mean edge lengths between them.
inline std::pair<Vertex, Vertex> neighbors(const Mesh& mesh, std::mt19937& rng)
{
  double length = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    length += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  length /= double(mesh.number_of_edges());
  for (;;) {
    const Vertex source(static_cast<Mesh::size_type>(rng() % mesh.number_of_vertices()));
    const Values distances = edge_distances(mesh, source);
    for (const Vertex v : mesh.vertices())
      if (distances[v] > 7 * length && distances[v] < 9 * length)
        return {source, v};
  }
}

inline Mesh with_tube(const Mesh& mesh, const std::pair<Vertex, Vertex>& ends)
{
  Triangles triangles(mesh);
  add_tube(triangles, face_at(mesh, ends.first), face_at(mesh, ends.second));
  return triangles.mesh();
}

// Takes the faces around some vertices away.
inline Mesh with_holes(const Mesh& mesh, const int number, const double radius, std::mt19937& rng)
{
  std::vector<bool> is_away(mesh.number_of_vertices(), false);
  for (int i = 0; i < number; ++i) {
    const Vertex center(static_cast<Mesh::size_type>(rng() % mesh.number_of_vertices()));
    const Values distances = edge_distances(mesh, center);
    for (const Vertex v : mesh.vertices())
      if (distances[v] <= radius)
        is_away[v] = true;
  }
  Triangles triangles(mesh);
  triangles.faces.erase(std::remove_if(triangles.faces.begin(),
                                       triangles.faces.end(),
                                       [&](const Triangle& face) {
                                         return std::any_of(
                                             face.begin(), face.end(), [&](const std::size_t v) {
                                               return is_away[v];
                                             });
                                       }),
                        triangles.faces.end());
  return triangles.mesh();
}

// Puts a new vertex into some of the faces.
inline Mesh with_split_faces(const Mesh& mesh, const double share, std::mt19937& rng)
{
  Triangles triangles(mesh);
  const std::size_t size = triangles.faces.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (std::uniform_real_distribution<>()(rng) > share)
      continue;
    const Triangle f = triangles.faces[i];
    const std::size_t v = triangles.points.size();
    triangles.points.push_back(
        CGAL::centroid(triangles.points[f[0]], triangles.points[f[1]], triangles.points[f[2]]));
    triangles.faces[i] = {f[0], f[1], v};
    triangles.faces.push_back({f[1], f[2], v});
    triangles.faces.push_back({f[2], f[0], v});
  }
  return triangles.mesh();
}

// What lies on the positive side of a plane. (The clipping of CGAL needs meshes that do not intersect
// themselves, which scanned shapes often do.)
inline Mesh clipped(const Mesh& mesh, const Point& point, const Vector& normal)
{
  const Triangles before(mesh);
  Triangles after = before;
  after.faces.clear();
  std::vector<double> heights;
  for (const Point& p : before.points)
    heights.push_back((p - point) * normal);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> point_of_edge;
  const auto crossing = [&](const std::size_t u, const std::size_t v) {
    const auto [it, is_new] = point_of_edge.emplace(std::minmax(u, v), after.points.size());
    if (is_new)
      after.points.push_back(before.points[u] + heights[u] / (heights[u] - heights[v]) *
                                                    (before.points[v] - before.points[u]));
    return it->second;
  };
  for (Triangle f : before.faces) {
    const auto number =
        std::count_if(f.begin(), f.end(), [&](const std::size_t v) { return heights[v] > 0; });
    if (number == 3)
      after.faces.push_back(f);
    if (number == 0 || number == 3)
      continue;
    // the vertex first that is alone on its side
    while ((heights[f[0]] > 0) != (number == 1) || (heights[f[1]] > 0) != (number == 2) ||
           (heights[f[2]] > 0) != (number == 2))
      std::rotate(f.begin(), f.begin() + 1, f.end());
    const std::size_t u = crossing(f[0], f[1]), v = crossing(f[0], f[2]);
    if (number == 1) {
      after.faces.push_back({f[0], u, v});
    } else {
      after.faces.push_back({u, f[1], f[2]});
      after.faces.push_back({u, f[2], v});
    }
  }
  return after.mesh();
}

// Two models that touch: the second one is moved beside the first one, and a tube joins them.
inline Mesh combined(const Mesh& mesh, Mesh other)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh),
                     other_box = CGAL::Polygon_mesh_processing::bbox(other);
  const double scale = diagonal(mesh) / diagonal(other);
  for (Point& p : other.points())
    p = Point(box.xmax() + scale * (p.x() - other_box.xmin()),
              box.ymin() + scale * (p.y() - other_box.ymin()),
              box.zmin() + scale * (p.z() - other_box.zmin()));
  const auto least = [](const Mesh& m, const double sign) {
    return *std::min_element(
        m.vertices().begin(), m.vertices().end(), [&](const Vertex v, const Vertex w) {
          return sign * m.point(v).x() < sign * m.point(w).x();
        });
  };
  Triangles triangles(mesh);
  const Triangles others(other);
  const std::size_t n = triangles.points.size(), number = triangles.faces.size();
  triangles.points.insert(triangles.points.end(), others.points.begin(), others.points.end());
  for (const Triangle& f : others.faces)
    triangles.faces.push_back({f[0] + n, f[1] + n, f[2] + n});
  add_tube(triangles, face_at(mesh, least(mesh, -1)), number + face_at(other, least(other, 1)));
  return triangles.mesh();
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TOPOLOGY_CHANGES_H
