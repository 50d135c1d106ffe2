// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGULATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGULATION_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The triangles of one connected component, known by nothing but their corners (positions of
// vertices in the component) and the lengths of their edges. Corners of a triangle may be the same
// vertex.
//
// Lengths are measured in the mean edge length of the component, so nothing depends on its size.
// They are mollified: all are increased by the least amount that makes every triangle inequality
// hold with a margin of 1e-5 mean lengths (Sharp and Crane, "A Laplacian for nonmanifold triangle
// meshes", 2020, Section 4.5). Nothing changes on good meshes; degenerate faces do no harm.
struct Intrinsic_triangulation
{
  struct Triangle
  {
    std::array<std::uint32_t, 3> corners;
    std::array<double, 3> lengths; // of the edges opposite to the corners
  };

  double unit = 0; // the mean edge length; 0 if the component has no extent, and then no triangles
  std::vector<Triangle> triangles; // in the order of the component's faces
};

// The triangles of a component (all its edges of length 0, or no faces: none).
template <class TriangleMesh, class VertexPointMap>
Intrinsic_triangulation intrinsic_triangulation(const TriangleMesh& tmesh,
                                                VertexPointMap vertex_point_map,
                                                const Mesh_components<TriangleMesh>& components,
                                                std::size_t component_number)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Triangle = Intrinsic_triangulation::Triangle;
  const auto& component = components[component_number];

  auto distance = [&](vertex_descriptor u, vertex_descriptor v) {
    const auto& p = get(vertex_point_map, u);
    const auto& q = get(vertex_point_map, v);
    return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()),
                      CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                      CGAL::to_double(p.z()) - CGAL::to_double(q.z()));
  };

  Intrinsic_triangulation result;
  result.triangles.reserve(component.faces.size());
  double sum_of_lengths = 0;
  for (auto f : component.faces) {
    Triangle triangle;
    int i = 0;
    // the halfedge that starts at corner i + 1 is opposite to corner i
    for (auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      CGAL_precondition(i < 3);
      triangle.corners[(i + 2) % 3] = components.position_of(source(h, tmesh));
      triangle.lengths[(i + 1) % 3] = distance(source(h, tmesh), target(h, tmesh));
      sum_of_lengths += triangle.lengths[(i + 1) % 3];
      ++i;
    }
    result.triangles.push_back(triangle);
  }

  if (!std::isfinite(sum_of_lengths))
    throw Input_error("its coordinates are too large: the edges have no finite length");
  if (sum_of_lengths == 0) {
    result.triangles.clear();
    return result;
  }
  result.unit = sum_of_lengths / (3. * static_cast<double>(result.triangles.size()));

  constexpr double margin = 1e-5;
  double excess = 0;
  for (Triangle& triangle : result.triangles) {
    for (double& length : triangle.lengths)
      length /= result.unit;
    const std::array<double, 3>& l = triangle.lengths;
    for (int i = 0; i < 3; ++i)
      excess = (std::max)(excess, margin + l[i] - l[(i + 1) % 3] - l[(i + 2) % 3]);
  }
  for (Triangle& triangle : result.triangles)
    for (double& length : triangle.lengths)
      length += excess;
  return result;
}

// A side of a triangle: side `3 t + i` is the edge opposite to corner i of triangle t.
using Triangle_side = std::uint32_t;
constexpr Triangle_side no_triangle_side = (std::numeric_limits<Triangle_side>::max)();

// For every side of the triangles of a component the one that it is glued to, `no_triangle_side` on
// borders.
template <class TriangleMesh>
std::vector<Triangle_side> glued_sides(const TriangleMesh& tmesh,
                                       const Mesh_components<TriangleMesh>& components,
                                       std::size_t component_number)
{
  const auto& component = components[component_number];
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges(
      3 * component.faces.size());
  // the sides by the ends of their edges, the smaller one first
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, Triangle_side>> by_ends;
  by_ends.reserve(halfedges.size());
  Triangle_side first = 0;
  for (auto f : component.faces) {
    Triangle_side i = 1; // in the order of `intrinsic_triangulation()`
    for (auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      const Triangle_side side = first + i % 3;
      halfedges[side] = h;
      by_ends.emplace_back(std::minmax({components.position_of(source(h, tmesh)),
                                        components.position_of(target(h, tmesh))}),
                           side);
      ++i;
    }
    first += 3;
  }
  std::sort(by_ends.begin(), by_ends.end());

  // Ends may have several edges in common, so the halfedges decide.
  std::vector<Triangle_side> result(halfedges.size(), no_triangle_side);
  for (std::size_t i = 0; i < by_ends.size(); ++i) {
    const Triangle_side side = by_ends[i].second;
    for (std::size_t j = i + 1; j < by_ends.size() && by_ends[j].first == by_ends[i].first; ++j) {
      const Triangle_side other = by_ends[j].second;
      if (halfedges[other] == opposite(halfedges[side], tmesh)) {
        result[side] = other;
        result[other] = side;
      }
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGULATION_H
