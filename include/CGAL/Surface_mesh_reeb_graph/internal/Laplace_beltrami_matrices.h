// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LAPLACE_BELTRAMI_MATRICES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LAPLACE_BELTRAMI_MATRICES_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Mesh_components.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Sparse>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The Laplace-Beltrami operator of one connected component with n vertices, discretized with linear
// elements on the lengths of the edges.
//
// Lengths are measured in the mean edge length of the component, so nothing depends on its size.
// They are mollified: all are increased by the least amount that makes every triangle inequality hold
// with a margin of 1e-5 mean lengths (Sharp and Crane, "A Laplacian for nonmanifold triangle meshes",
// 2020, Section 4.5). Nothing changes on good meshes; degenerate faces do no harm.
//
// Nothing is imposed on borders: this is the Neumann condition.
struct Laplace_beltrami_matrices
{
  double unit = 0; // the mean edge length
  Eigen::SparseMatrix<double>
      stiffness;        // n x n, symmetric, positive semi-definite: half the sum of
                        // the cotangents opposite to an edge, with negative sign
  Eigen::VectorXd mass; // n mixed Voronoi areas, in squared units
  double area = 0;      // their sum, in squared units
};

// A component without extent (all edges of length 0, or no faces) gives matrices with `area == 0`.
template <class TriangleMesh, class VertexPointMap>
Laplace_beltrami_matrices laplace_beltrami_matrices(const TriangleMesh& tmesh,
                                                    VertexPointMap vertex_point_map,
                                                    const Mesh_components<TriangleMesh>& components,
                                                    std::size_t component_number)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto& component = components[component_number];

  struct Triangle
  {
    std::array<std::uint32_t, 3> corners;
    std::array<double, 3> lengths; // of the edges opposite to the corners
  };

  auto distance = [&](vertex_descriptor u, vertex_descriptor v) {
    const auto& p = get(vertex_point_map, u);
    const auto& q = get(vertex_point_map, v);
    return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()),
                      CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                      CGAL::to_double(p.z()) - CGAL::to_double(q.z()));
  };

  std::vector<Triangle> triangles;
  triangles.reserve(component.faces.size());
  double sum_of_lengths = 0;
  for (auto f : component.faces) {
    Triangle triangle;
    int i = 0;
    // the halfedge that starts at corner i + 1 is opposite to corner i
    for (auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      triangle.corners[(i + 2) % 3] = components.position_of(source(h, tmesh));
      triangle.lengths[(i + 1) % 3] = distance(source(h, tmesh), target(h, tmesh));
      sum_of_lengths += triangle.lengths[(i + 1) % 3];
      ++i;
    }
    triangles.push_back(triangle);
  }

  Laplace_beltrami_matrices result;
  const Eigen::Index n = static_cast<Eigen::Index>(component.vertices.size());
  result.stiffness.resize(n, n);
  result.mass = Eigen::VectorXd::Zero(n);
  if (!std::isfinite(sum_of_lengths))
    throw Reeb_graph_error("its coordinates are too large: the edges have no finite length");
  if (sum_of_lengths == 0)
    return result;
  result.unit = sum_of_lengths / (3. * static_cast<double>(triangles.size()));

  constexpr double margin = 1e-5;
  double excess = 0;
  for (Triangle& triangle : triangles) {
    for (double& length : triangle.lengths)
      length /= result.unit;
    const std::array<double, 3>& l = triangle.lengths;
    for (int i = 0; i < 3; ++i)
      excess = (std::max)(excess, margin + l[i] - l[(i + 1) % 3] - l[(i + 2) % 3]);
  }

  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(12 * triangles.size());
  for (Triangle& triangle : triangles) {
    for (double& length : triangle.lengths)
      length += excess;
    const Intrinsic_triangle t(triangle.lengths);
    result.area += t.area();
    for (int i = 0; i < 3; ++i) {
      const int u = static_cast<int>(triangle.corners[(i + 1) % 3]);
      const int v = static_cast<int>(triangle.corners[(i + 2) % 3]);
      const double weight = t.cotangent(i) / 2;
      triplets.emplace_back(u, v, -weight);
      triplets.emplace_back(v, u, -weight);
      triplets.emplace_back(u, u, weight);
      triplets.emplace_back(v, v, weight);
      result.mass[triangle.corners[i]] += t.mixed_voronoi_area(i);
    }
  }
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LAPLACE_BELTRAMI_MATRICES_H
