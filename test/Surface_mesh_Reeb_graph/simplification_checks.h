// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the simplification share: folded graphs, what is left of them, and where their
// points go.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_SIMPLIFICATION_CHECKS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_SIMPLIFICATION_CHECKS_H

#include "persistence_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Point_on_arc.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_simplification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace Reeb_graph_test {

using SMRG::internal::Arc_ends;
using SMRG::internal::Folded_graph;

inline const double infinity = std::numeric_limits<double>::infinity();

inline void
cancel_branches(Folded_graph& folded, const std::vector<double>& values, const double threshold)
{
  SMRG::internal::cancel_branches(folded, values, [&](const SMRG::internal::Extremum_pair& pair) {
    return pair.persistence < threshold;
  });
}

// What is left of a graph; its nodes have the numbers that they had in `nodes`.
struct Left
{
  std::vector<std::size_t> nodes;
  std::vector<Rank_pair> arcs;

  std::vector<Extended_pair> pairs() const
  {
    return with_ranks(extended_persistence(ranked_complex_of_graph(nodes.size(), arcs)), nodes);
  }

  // The arcs between the numbers of before, sorted.
  std::vector<Rank_pair> arcs_before() const
  {
    std::vector<Rank_pair> result;
    for (const Rank_pair& arc : arcs)
      result.emplace_back(nodes[arc.first], nodes[arc.second]);
    std::sort(result.begin(), result.end());
    return result;
  }
};

inline Left left_of(const Folded_graph& folded)
{
  const SMRG::internal::Compacted_graph remaining(folded);
  Left result;
  result.nodes.assign(remaining.nodes.begin(), remaining.nodes.end());
  for (const Arc_ends& arc : remaining.arcs)
    result.arcs.emplace_back(arc.lower, arc.upper);
  return result;
}

inline std::vector<Arc_ends> arc_ends_of(const Graph& graph)
{
  std::vector<Arc_ends> result;
  for (const Rank_pair& arc : arcs_of(graph))
    result.push_back(
        {static_cast<std::uint32_t>(arc.first), static_cast<std::uint32_t>(arc.second)});
  return result;
}

inline double persistence_of(const Extended_pair& pair, const std::vector<double>& values)
{
  return std::abs(values[pair.death] - values[pair.birth]);
}

inline bool is_loop(const Extended_pair& pair)
{
  return pair.kind == EXTENDED && pair.dimension == 1;
}

inline std::size_t number_of_loops(const std::vector<Extended_pair>& pairs)
{
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), is_loop));
}

// Closes the loops of persistence below the threshold.
inline SMRG::internal::Loop_simplification
close_loops(Folded_graph& folded, const std::vector<double>& values, const double threshold)
{
  return SMRG::internal::Loop_simplification(folded, [&](const SMRG::internal::Loop_pair& loop) {
    return values[loop.merge] - values[loop.split] < threshold;
  });
}

// The arcs that points of a graph have gone to. A point is an arc and the node just below the
// point.
inline std::vector<std::uint32_t> images_of(Folded_graph& folded,
                                            const SMRG::internal::Loop_simplification& closed_loops,
                                            const std::vector<Rank_pair>& points)
{
  std::vector<SMRG::internal::Point_on_arc> images;
  for (const Rank_pair& point : points)
    images.emplace_back(static_cast<std::uint32_t>(point.first));
  SMRG::internal::follow(
      folded, closed_loops, images, [&](const std::uint32_t i, const std::uint32_t node) {
        return points[i].second < node;
      });
  std::vector<std::uint32_t> result;
  for (const SMRG::internal::Point_on_arc& image : images)
    result.push_back(image.arc);
  return result;
}

// All points of a graph, from the lowest to the highest of every arc.
inline std::vector<Rank_pair> points_of(const std::vector<Rank_pair>& arcs)
{
  std::vector<Rank_pair> points;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc)
    for (std::size_t node = arcs[arc].first; node < arcs[arc].second; ++node)
      points.emplace_back(arc, node);
  return points;
}

// Calls `check(graph, values, threshold)` for random graphs and thresholds.
template <class Check>
void for_random_graphs(const unsigned number, const Check& check)
{
  for (unsigned seed = 0; seed < number; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      const std::vector<double> values = values_of(graph);
      check(graph, values, random_unit(rng) * (values.back() + 1));
    }
  }
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_SIMPLIFICATION_CHECKS_H
