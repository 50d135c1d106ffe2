// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is compared of a function on a shape: the simplified graphs for some thresholds, and the
// persistence diagrams.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ANALYSIS_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ANALYSIS_H

#include "diagram_distances.h"
#include "isomorphism.h"
#include "shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_gap.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

namespace Robustness {

inline const std::array<const char*, 5> threshold_names = {"3 %", "5 %", "10 %", "20 %", "gap"};
constexpr std::size_t gap_threshold = 4; // its position

// Minima, maxima, loops.
using Counts = std::tuple<std::size_t, std::size_t, std::size_t>;

struct Level
{
  Typed_graph graph;
  std::vector<Vertex> minima, maxima;
  std::size_t loops = 0;

  Counts counts() const { return {minima.size(), maxima.size(), loops}; }
};

struct Analysis
{
  Values values;
  std::array<Level, threshold_names.size()> levels;
  std::array<Diagram, 3> diagrams; // minima, maxima, loops; of the function with range 1
};

inline Level level_of(const CGAL::Surface_mesh_Reeb_graph::Reeb_graph<Mesh>& graph)
{
  Level level;
  std::vector<bool> has_arc_below(num_vertices(graph), false), has_arc_above = has_arc_below;
  for (const auto arc : CGAL::make_range(edges(graph))) {
    level.graph.arcs.emplace_back(lower_node(arc, graph), upper_node(arc, graph));
    has_arc_above[lower_node(arc, graph)] = true;
    has_arc_below[upper_node(arc, graph)] = true;
  }
  for (const auto node : CGAL::make_range(vertices(graph))) {
    level.graph.types.push_back(static_cast<int>(graph[node].type));
    if (!has_arc_below[node])
      level.minima.push_back(graph[node].vertex);
    if (!has_arc_above[node])
      level.maxima.push_back(graph[node].vertex);
  }
  std::vector<std::size_t> components(num_vertices(graph));
  level.loops = num_edges(graph) +
                static_cast<std::size_t>(boost::connected_components(graph, components.data())) -
                num_vertices(graph);
  return level;
}

inline Analysis analyze(const Mesh& mesh, const Values& values)
{
  namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
  using Graph = SMRG::Reeb_graph<Mesh>;
  Analysis result;
  result.values = values;
  Graph graph;
  SMRG::compute_Reeb_graph(mesh, CGAL::make_property_map(values), graph);

  const std::array<double, threshold_names.size()> thresholds = {
      0.03, 0.05, 0.1, 0.2, SMRG::persistence_gap(graph).threshold};
  const SMRG::Reeb_graph_hierarchy<Graph> hierarchy(graph);
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    Graph simplified;
    hierarchy.make_graph(thresholds[i], simplified);
    result.levels[i] = level_of(simplified);
  }

  const auto range = std::minmax_element(values.begin(), values.end());
  const double least = *range.first, length = *range.second - least;
  std::vector<SMRG::Persistence_pair<Graph>> pairs;
  SMRG::persistence_pairs(graph, std::back_inserter(pairs));
  for (const SMRG::Persistence_pair<Graph>& pair : pairs) {
    if (pair.kind == SMRG::Persistence_pair_kind::COMPONENT)
      continue;
    const double lower = (graph[pair.lower()].value - least) / length,
                 upper = (graph[pair.upper()].value - least) / length;
    const std::size_t i = pair.kind == SMRG::Persistence_pair_kind::MINIMUM   ? 0
                          : pair.kind == SMRG::Persistence_pair_kind::MAXIMUM ? 1
                                                                              : 2;
    if (lower < upper) // and does not become the same by rounding
      result.diagrams[i].emplace_back(lower, upper);
  }
  return result;
}

inline double bottleneck_distance(const Analysis& a, const Analysis& b)
{
  double result = 0;
  for (std::size_t i = 0; i < a.diagrams.size(); ++i)
    result = (std::max)(result, bottleneck_distance(a.diagrams[i], b.diagrams[i]));
  return result;
}

inline double wasserstein_distance(const Analysis& a, const Analysis& b)
{
  double result = 0;
  for (std::size_t i = 0; i < a.diagrams.size(); ++i)
    result += wasserstein_distance(a.diagrams[i], b.diagrams[i]);
  return result;
}

// The share of the maxima of `a` with a maximum of `b` within 5 percent of the diagonal, on a mesh
// of which the vertices correspond to those of `b`.
inline double share_of_repeated_maxima(const Mesh& mesh, const Level& a, const Level& b)
{
  const double radius = 0.05 * diagonal(mesh);
  const auto is_repeated = [&](const Vertex v) {
    return std::any_of(b.maxima.begin(), b.maxima.end(), [&](const Vertex w) {
      return CGAL::squared_distance(mesh.point(v), mesh.point(w)) <= radius * radius;
    });
  };
  return double(std::count_if(a.maxima.begin(), a.maxima.end(), is_repeated)) /
         double(a.maxima.size());
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ANALYSIS_H
