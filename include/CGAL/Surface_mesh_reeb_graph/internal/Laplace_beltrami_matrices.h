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

#include <CGAL/Surface_mesh_reeb_graph/internal/Intrinsic_delaunay.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Intrinsic_triangulation.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Mesh_components.h>

#include <Eigen/Core>
#include <Eigen/Sparse>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The Laplace-Beltrami operator of one connected component with n vertices, discretized with linear
// elements on the lengths of the edges.
//
// The triangles are those of the mesh with mollified lengths (see `Intrinsic_triangulation`) or, optionally, those
// of the intrinsic Delaunay triangulation of the same surface (see `Intrinsic_delaunay`), for which no coefficient
// outside of the diagonal is positive but those of edges on a border opposite to an obtuse angle.
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
                                                    std::size_t component_number,
                                                    bool use_intrinsic_delaunay = false)
{
  Intrinsic_triangulation triangulation =
      intrinsic_triangulation(tmesh, vertex_point_map, components, component_number);
  if (use_intrinsic_delaunay && !triangulation.triangles.empty()) {
    std::vector<Triangle_side> glued = glued_sides(tmesh, components, component_number);
    Intrinsic_delaunay(triangulation, glued).flip_all();
  }

  Laplace_beltrami_matrices result;
  const Eigen::Index n = static_cast<Eigen::Index>(components[component_number].vertices.size());
  result.unit = triangulation.unit;
  result.stiffness.resize(n, n);
  result.mass = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(12 * triangulation.triangles.size());
  for (const Intrinsic_triangulation::Triangle& triangle : triangulation.triangles) {
    const Intrinsic_triangle t(triangle.lengths);
    result.area += t.area();
    for (int i = 0; i < 3; ++i) {
      result.mass[triangle.corners[i]] += t.mixed_voronoi_area(i);
      const int u = static_cast<int>(triangle.corners[(i + 1) % 3]);
      const int v = static_cast<int>(triangle.corners[(i + 2) % 3]);
      if (u == v)
        continue; // functions do not differ between the ends of such an edge
      const double weight = t.cotangent(i) / 2;
      triplets.emplace_back(u, v, -weight);
      triplets.emplace_back(v, u, -weight);
      triplets.emplace_back(u, u, weight);
      triplets.emplace_back(v, v, weight);
    }
  }
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LAPLACE_BELTRAMI_MATRICES_H
