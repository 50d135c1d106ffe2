// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Point_on_arc.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/persistence_gaps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_simplification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Simplification_parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Simplifies a Reeb graph as simplify_Reeb_graph() says. `values` increase with the nodes.
class Simplification
{
public:
  Simplification(const std::vector<double>& values,
                 const std::vector<Arc_ends>& ends,
                 const Simplification_parameters& parameters)
    : m_values(values), m_ends(ends), m_parameters(parameters), m_folded(values.size(), ends)
  {
    CGAL_precondition(parameters.threshold >= 0 && parameters.loop_threshold >= 0);
    // of the graph as it is given, also for what is left when loops have been closed
    if (parameters.gap != 0)
      m_parameters.threshold =
          kth_widest_gap(
              persistence_gaps(branch_persistences(values, ends, parameters.is_absolute)),
              parameters.gap)
              .threshold();
  }

  const Folded_graph& folded_graph() const { return m_folded; }

  void run()
  {
    cancel_branches();
    if (m_parameters.loop_threshold > 0) {
      close_loops();
      if (m_loops.have_other_pairs_changed())
        cancel_branches();
    }
  }

  // Moves points to the arcs that they belong to now. `is_below(i, node)` tells whether `points[i]`
  // lies below a node.
  template <class IsBelow>
  void follow(std::vector<Point_on_arc>& points, const IsBelow& is_below)
  {
    internal::follow(m_folded, m_loops, points, is_below);
  }

private:
  std::vector<double> thresholds_of_nodes(double threshold) const
  {
    return m_parameters.is_absolute ? std::vector<double>(m_values.size(), threshold)
                                    : fractions_of_component_ranges(m_values, m_ends, threshold);
  }

  void close_loops()
  {
    const std::vector<double> thresholds = thresholds_of_nodes(m_parameters.loop_threshold);
    m_loops = Loop_simplification(m_folded, [&](const Loop_pair& loop) {
      return difference(m_values[loop.split], m_values[loop.merge]) < thresholds[loop.merge];
    });
  }

  void cancel_branches()
  {
    const std::vector<double> thresholds = thresholds_of_nodes(m_parameters.threshold);
    internal::cancel_branches(m_folded, m_values, [&](const Extremum_pair& pair) {
      return pair.persistence < thresholds[pair.extremum];
    });
    const std::size_t number_of_leaves = m_parameters.number_of_leaves;
    if (number_of_leaves == (std::numeric_limits<std::size_t>::max)())
      return;
    std::size_t number = 0;
    for (std::uint32_t node = 0; node < m_values.size(); ++node)
      if (m_folded.is_node(node) &&
          (m_folded.number_of_arcs(BELOW, node) == 0 || m_folded.number_of_arcs(ABOVE, node) == 0))
        ++number;
    if (number <= number_of_leaves)
      return;

    std::vector<Extremum_pair> pairs = extremum_pairs(m_folded, m_values);
    if (!m_parameters.is_absolute)
      sort_by_relative_persistence(pairs);
    pairs.resize((std::min)(pairs.size(), number - number_of_leaves));
    cancel_pairs(m_folded, m_values, pairs);
  }

  // Inside a component the order stays as it is.
  void sort_by_relative_persistence(std::vector<Extremum_pair>& pairs) const
  {
    const std::vector<double> half_ranges = fractions_of_component_ranges(m_values, m_ends, 0.5);
    std::vector<std::pair<double, std::size_t>> keyed;
    keyed.reserve(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      keyed.emplace_back(relative_persistence(pairs[i], m_values, half_ranges[pairs[i].extremum]),
                         i);
    std::sort(keyed.begin(), keyed.end());
    std::vector<Extremum_pair> sorted;
    sorted.reserve(pairs.size());
    for (const auto& [persistence, i] : keyed)
      sorted.push_back(pairs[i]);
    pairs = std::move(sorted);
  }

  const std::vector<double>& m_values;
  const std::vector<Arc_ends>& m_ends;
  Simplification_parameters m_parameters;
  Folded_graph m_folded;
  Loop_simplification m_loops;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_H
