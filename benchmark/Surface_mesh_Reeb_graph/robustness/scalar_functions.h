// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that are compared: a new one is a line in the table at the end.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SCALAR_FUNCTIONS_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SCALAR_FUNCTIONS_H

#include "shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/geodesic_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
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

// At a time that keeps all limbs and lets their details go.
inline Values auto_diffusion(const Mesh& mesh, const Basis& basis)
{
  constexpr double time = 0.1;
  Values values(mesh.number_of_vertices());
  SMRG::auto_diffusion_function(basis, time, CGAL::make_property_map(values));
  return values;
}

// From the vertex that lies farthest from the barycenter of the surface.
inline Values geodesic(const Mesh& mesh, const Basis&)
{
  Values values(mesh.number_of_vertices());
  SMRG::barycenter_distance_function(mesh, CGAL::make_property_map(values));
  const std::array<Vertex, 1> source = {Vertex(static_cast<Mesh::size_type>(
      std::max_element(values.begin(), values.end()) - values.begin()))};
  SMRG::geodesic_distance_function(mesh, source, CGAL::make_property_map(values));
  return values;
}

inline Values height(const Mesh& mesh, const Basis&)
{
  Values values(mesh.number_of_vertices());
  SMRG::height_function(mesh, Vector(0, 0, 1), CGAL::make_property_map(values));
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
