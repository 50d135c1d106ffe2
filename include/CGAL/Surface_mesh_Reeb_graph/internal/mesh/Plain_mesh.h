// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_PLAIN_MESH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_PLAIN_MESH_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Uniform_random_numbers.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A connected component as a mesh of its own, with coordinates of type `double` in units of its mean
// edge length: what algorithms of CGAL accept that know no vertex point maps, exact kernels, isolated
// vertices or degenerate faces.
struct Plain_mesh
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point_3>;

  double unit = 0; // the mean edge length; 0 if the component has no extent, and then no mesh
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices; // by positions in the component
  std::vector<double> vertex_areas;         // a third of the area of the faces, in squared units
};

// The corners of degenerate faces are moved by `margin` units, so that no face is degenerate.
template <class TriangleMesh, class VertexPointMap>
Plain_mesh plain_mesh(const TriangleMesh& tmesh,
                      VertexPointMap vertex_point_map,
                      const Mesh_components<TriangleMesh>& components,
                      std::size_t component_number)
{
  const auto& component = components[component_number];
  Plain_mesh result;
  result.vertex_areas.resize(component.vertices.size(), 0.);
  std::vector<Coordinates> points;
  points.reserve(component.vertices.size());
  for (auto v : component.vertices)
    points.push_back(coordinates(get(vertex_point_map, v)));

  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(component.faces.size());
  double sum_of_lengths = 0;
  for (auto f : component.faces) {
    const auto h = halfedge(f, tmesh);
    triangles.push_back({components.position_of(source(h, tmesh)),
                         components.position_of(target(h, tmesh)),
                         components.position_of(target(next(h, tmesh), tmesh))});
    const std::array<std::uint32_t, 3>& t = triangles.back();
    for (int i = 0; i < 3; ++i)
      sum_of_lengths += distance_between(points[t[i]], points[t[(i + 1) % 3]]);
  }
  if (!std::isfinite(sum_of_lengths))
    throw Input_error("coordinates are too large: the edges have no finite length");
  if (sum_of_lengths == 0)
    return result;
  result.unit = sum_of_lengths / (3 * static_cast<double>(triangles.size()));

  const Coordinates origin = points.front();
  for (Coordinates& p : points) {
    p = difference_of(p, origin);
    for (double& x : p)
      x /= result.unit;
  }
  constexpr double margin = 1e-6;
  std::vector<bool> is_corner_of_degenerate(points.size(), false);
  for (const std::array<std::uint32_t, 3>& t : triangles) {
    const double area = triangle_area(points[t[0]], points[t[1]], points[t[2]]);
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = (std::max)(longest, distance_between(points[t[i]], points[t[(i + 1) % 3]]));
    for (int i = 0; i < 3; ++i) {
      result.vertex_areas[t[i]] += area / 3;
      if (2 * area <= margin * longest) // the smallest height
        is_corner_of_degenerate[t[i]] = true;
    }
  }
  Uniform_random_numbers random(0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_corner_of_degenerate[i])
      for (double& x : points[i])
        x += 2 * margin * random.next();

  result.mesh.reserve(static_cast<Plain_mesh::Mesh::size_type>(points.size()),
                      static_cast<Plain_mesh::Mesh::size_type>(points.size() + triangles.size()),
                      static_cast<Plain_mesh::Mesh::size_type>(triangles.size()));
  for (const Coordinates& p : points)
    result.vertices.push_back(result.mesh.add_vertex(Plain_mesh::Point_3(p[0], p[1], p[2])));
  for (const std::array<std::uint32_t, 3>& t : triangles)
    if (CGAL::Euler::add_face(std::array<Plain_mesh::Mesh::Vertex_index, 3>{result.vertices[t[0]],
                                                                            result.vertices[t[1]],
                                                                            result.vertices[t[2]]},
                              result.mesh) == Plain_mesh::Mesh::null_face())
      throw Input_error("the mesh is not a 2-manifold");
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_PLAIN_MESH_H
