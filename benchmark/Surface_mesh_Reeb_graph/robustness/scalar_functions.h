// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that are compared: a new one is a line in the table at the end.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SCALAR_FUNCTIONS_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SCALAR_FUNCTIONS_H

#include "shapes.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>
#include <CGAL/centroid.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace Robustness {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

// That of the paper.
inline Values commute_time(const Mesh& mesh, const Basis& basis)
{
  Values values(mesh.number_of_vertices());
  std::vector<Vertex> points;
  SMRG::feature_points(basis, std::back_inserter(points));
  SMRG::commute_time_function(basis, points, CGAL::make_property_map(values));
  return values;
}

// Gebal, Baerentzen, Aanaes, Larsen, "Shape analysis using the auto diffusion function", 2009: the
// heat that is left at a point after a time. As there, times are multiples of the inverse of the
// smallest eigenvalue; 0.1 of it keeps all limbs and lets their details go.
inline Values auto_diffusion(const Mesh& mesh, const Basis& basis)
{
  constexpr double time = 0.1;
  Values values(mesh.number_of_vertices(), 0.);
  for (const Vertex v : mesh.vertices()) {
    const std::size_t c = basis.component(v);
    for (std::size_t k = 1; k <= basis.number_of_eigenpairs(c); ++k) {
      const double phi = basis.eigenfunction(k, v);
      values[v] += std::exp(-time * basis.eigenvalue(c, k) / basis.eigenvalue(c, 1)) * phi * phi;
    }
  }
  return values;
}

// The geodesic distance from the vertex that lies farthest from the barycenter of the vertices.
inline Values geodesic(const Mesh& mesh, const Basis&)
{
  const Point center = CGAL::centroid(mesh.points().begin(), mesh.points().end());
  const Vertex source = *std::max_element(
      mesh.vertices().begin(), mesh.vertices().end(), [&](const Vertex v, const Vertex w) {
        return CGAL::compare_distance_to_point(center, mesh.point(v), mesh.point(w)) ==
               CGAL::SMALLER;
      });
  Values values(mesh.number_of_vertices());
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, CGAL::make_property_map(values), source);
  return values;
}

inline Values height(const Mesh& mesh, const Basis&)
{
  Values values;
  for (const Vertex v : mesh.vertices())
    values.push_back(mesh.point(v).z());
  return values;
}

struct Scalar_function
{
  const char* name;
  Values (*compute)(const Mesh&, const Basis&);
};

inline const std::vector<Scalar_function> scalar_functions = {
    {"commute_time", commute_time},
    {"auto_diffusion", auto_diffusion},
    {"geodesic", geodesic},
    {"height", height},
};

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SCALAR_FUNCTIONS_H
