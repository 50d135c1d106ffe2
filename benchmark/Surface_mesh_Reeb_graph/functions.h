// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions of the benchmark, by fixed seeds.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_FUNCTIONS_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_FUNCTIONS_H

#include "meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <vector>

namespace Reeb_graph_benchmark {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

enum Function { SMOOTH, FINE_NOISE, ONE_PERCENT_NOISE, PURE_NOISE, MAPPING };

inline const std::array<const char*, 5> function_names = {
    "smooth", "fine_noise", "one_percent_noise", "pure_noise", "mapping"};

// The height along a direction in which none of the meshes has a symmetry.
inline std::vector<double> smooth_function(const Mesh& mesh)
{
  std::vector<double> values;
  values.reserve(mesh.number_of_vertices());
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    values.push_back(p.x() + 0.31 * p.y() + 0.17 * p.z());
  }
  return values;
}

inline void add_noise(std::vector<double>& values, const double amplitude)
{
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> noise(-amplitude, amplitude);
  for (double& value : values)
    value += noise(generator);
}

inline double mean_difference_along_edges(const Mesh& mesh, const std::vector<double>& values)
{
  double sum = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    sum += std::abs(values[mesh.vertex(e, 0)] - values[mesh.vertex(e, 1)]);
  return sum / double(mesh.number_of_edges());
}

// The commute-time mapping function, which takes far longer to compute than its Reeb graph.
inline std::vector<double> mapping_function(const Mesh& mesh)
{
  std::vector<double> values(mesh.number_of_vertices());
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(mesh);
  std::vector<Mesh::Vertex_index> points;
  SMRG::feature_points(basis, std::back_inserter(points));
  SMRG::commute_time_function(basis, points, CGAL::make_property_map(values));
  return values;
}

inline std::vector<double> values_of(const Function function, const Mesh& mesh)
{
  if (function == MAPPING)
    return mapping_function(mesh);
  std::vector<double> values = smooth_function(mesh);
  switch (function) {
  case FINE_NOISE:
    // That of a scanner, say, which does not depend on how fine the mesh is: two to five vertices
    // in a hundred are critical, mostly where the surface is level.
    add_noise(values, 0.5 * mean_difference_along_edges(mesh, values));
    break;
  case ONE_PERCENT_NOISE: {
    const auto range = std::minmax_element(values.begin(), values.end());
    add_noise(values, 0.005 * (*range.second - *range.first));
    break;
  }
  case PURE_NOISE:
    std::fill(values.begin(), values.end(), 0.);
    add_noise(values, 1);
    break;
  default:
    break;
  }
  return values;
}

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_FUNCTIONS_H
