// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_HIERARCHY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_HIERARCHY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/persistence_gaps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>

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

// What cancel_branches() makes of a Reeb graph, for every threshold.
//
// cancel_pairs() takes the pairs of a component one after the other. A branch that is a single arc
// when its turn comes is taken away at once; the others wait, and are zipped all together at the
// end. Whether a branch waits does not depend on how many follow. So one pass over all pairs shows
// the graph before the zip for every number of pairs, and it suffices to note at which pair every
// node and every arc goes, and every new arc comes. What is there after some pairs of a component
// is then found among all that goes later, which is not more than a constant factor more: an arc
// that is not there yet comes with a pair of which the extremum is still there.
class Branch_hierarchy
{
public:
  // What is left.
  struct Level
  {
    std::vector<std::uint32_t> nodes; // their numbers, increasing
    std::vector<Arc_ends> arcs;       // between positions in `nodes`, as Compacted_graph has them
  };

  // `values` increase with the nodes.
  Branch_hierarchy(std::vector<double> values, std::vector<Arc_ends> arcs, bool is_absolute)
    : m_values(std::move(values))
    , m_arcs(std::move(arcs))
    , m_is_absolute(is_absolute)
    , m_node_lives(m_values.size())
    , m_arc_lives(m_arcs.size())
  {
    find_components();
    Folded_graph graph(m_values.size(), m_arcs);
    sort_pairs(extremum_pairs(graph, m_values));
    for (std::size_t c = 0; c < m_components.size(); ++c)
      for (std::size_t i = m_first_pair[c]; i < m_first_pair[c + 1]; ++i)
        cancel(graph, m_components[c], i, static_cast<std::uint32_t>(i - m_first_pair[c]));
    m_arcs = graph.arcs();
    for (std::uint32_t node = 0; node < m_values.size(); ++node)
      component_of(node).nodes.push_back(node);
    for (std::uint32_t arc = 0; arc < m_arcs.size(); ++arc)
      component_of(m_arcs[arc].lower).arcs.push_back(arc);
    for (Component& component : m_components) {
      sort_by_end(m_node_lives, component.nodes);
      sort_by_end(m_arc_lives, component.arcs);
    }
  }

  // The persistences of the pairs that can be cancelled, increasing, without 0 and infinity, and
  // without repetitions.
  std::vector<double> persistences() const
  {
    std::vector<double> result;
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      const double half_range = 0.5 * m_components[c].highest - 0.5 * m_components[c].lowest;
      for (std::size_t i = m_first_pair[c]; i < m_first_pair[c + 1]; ++i) {
        const double persistence = m_is_absolute
                                       ? m_pairs[i].persistence
                                       : relative_persistence(m_pairs[i], m_values, half_range);
        if (persistence != 0 && std::isfinite(persistence))
          result.push_back(persistence);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // What is left when all pairs of persistence below a threshold, and those of persistence 0, are
  // cancelled.
  Level level(double threshold) const
  {
    std::vector<std::uint32_t> nodes, arcs, waiting_pairs;
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      const Component& component = m_components[c];
      const std::uint32_t number = number_of_small_pairs(c, threshold);
      append_what_is_left(component.nodes, m_node_lives, number, nodes);
      append_what_is_left(component.arcs, m_arc_lives, number, arcs);
      waiting_pairs.insert(waiting_pairs.end(),
                           component.waiting_pairs.begin(),
                           std::lower_bound(component.waiting_pairs.begin(),
                                            component.waiting_pairs.end(),
                                            m_first_pair[c] + number));
    }
    // arcs in the order in which they come, as in the graph that all pairs were taken from
    std::sort(nodes.begin(), nodes.end());
    std::sort(arcs.begin(), arcs.end());

    std::vector<Arc_ends> ends;
    ends.reserve(arcs.size());
    for (const std::uint32_t arc : arcs)
      ends.push_back({position(nodes, m_arcs[arc].lower), position(nodes, m_arcs[arc].upper)});
    Folded_graph graph(nodes.size(), ends);
    if (!waiting_pairs.empty())
      zip(graph, nodes, waiting_pairs);

    Compacted_graph compacted(graph);
    for (std::uint32_t& node : compacted.nodes)
      node = nodes[node];
    return {std::move(compacted.nodes), std::move(compacted.arcs)};
  }

private:
  static constexpr std::uint32_t never = (std::numeric_limits<std::uint32_t>::max)();

  // How many pairs of the component are cancelled when something comes, and when it goes.
  struct Life
  {
    std::uint32_t begin = 0, end = never;
  };

  struct Component
  {
    double lowest = 0, highest = 0;           // of the finite values
    std::vector<std::uint32_t> nodes, arcs;   // all that ever are; what goes last comes first
    std::vector<std::uint32_t> waiting_pairs; // increasing
  };

  Component& component_of(std::uint32_t node) { return m_components[m_component_of_node[node]]; }

  void find_components()
  {
    const std::uint32_t n = static_cast<std::uint32_t>(m_values.size());
    Disjoint_sets sets(n);
    for (const Arc_ends& ends : m_arcs)
      sets.join(sets.root(ends.lower), sets.root(ends.upper));
    std::vector<std::uint32_t> component_of_root(n, never);
    std::vector<bool> has_finite_values;
    m_component_of_node.resize(n);
    for (std::uint32_t node = 0; node < n; ++node) {
      std::uint32_t& c = component_of_root[sets.root(node)];
      if (c == never) {
        c = static_cast<std::uint32_t>(m_components.size());
        m_components.emplace_back();
        has_finite_values.push_back(false);
      }
      m_component_of_node[node] = c;
      if (!std::isfinite(m_values[node]))
        continue;
      if (!has_finite_values[c])
        m_components[c].lowest = m_values[node];
      has_finite_values[c] = true;
      m_components[c].highest = m_values[node];
    }
  }

  // Puts the pairs of every component together, in their order.
  void sort_pairs(const std::vector<Extremum_pair>& pairs)
  {
    m_pairs.resize(pairs.size());
    m_first_pair = counting_sort(
        pairs.size(),
        m_components.size(),
        [&](std::size_t i) { return m_component_of_node[pairs[i].extremum]; },
        [&](std::size_t position, std::size_t i) { m_pairs[position] = pairs[i]; });
  }

  // Takes the branch of a pair away, and notes what goes and comes thereby.
  void cancel(Folded_graph& graph,
              Component& component,
              std::size_t i,
              std::uint32_t number_of_pairs_before)
  {
    const Extremum_pair& pair = m_pairs[i];
    const Side other_side = opposite_side(pair.side);
    const std::uint32_t arc = graph.heir(other_side, pair.arc),
                        other_arc = graph.heir(other_side, pair.other_arc),
                        arc_across = graph.first_arc(other_side, pair.saddle),
                        number = number_of_pairs_before + 1;
    const std::size_t number_of_arcs = graph.arcs().size();
    if (!cancel_leaf(graph, pair)) {
      component.waiting_pairs.push_back(static_cast<std::uint32_t>(i));
      return;
    }
    m_arc_lives[arc].end = number;
    m_node_lives[pair.extremum].end = number;
    if (graph.arcs().size() == number_of_arcs)
      return;
    // the saddle is no node any more: the other two arcs have become one
    CGAL_assertion(!graph.is_node(pair.saddle) && !graph.is_arc(other_arc) &&
                   !graph.is_arc(arc_across) && graph.arcs().size() == number_of_arcs + 1);
    m_node_lives[pair.saddle].end = number;
    m_arc_lives[other_arc].end = number;
    m_arc_lives[arc_across].end = number;
    m_arc_lives.push_back({number, never});
  }

  static void sort_by_end(const std::vector<Life>& lives, std::vector<std::uint32_t>& items)
  {
    std::sort(items.begin(), items.end(), [&](std::uint32_t a, std::uint32_t b) {
      return lives[a].end > lives[b].end;
    });
  }

  // The comparison is that of simplify_Reeb_graph(), to the last bit.
  std::uint32_t number_of_small_pairs(std::size_t c, double threshold) const
  {
    const Component& component = m_components[c];
    const double difference = m_is_absolute || std::isinf(threshold)
                                  ? threshold
                                  : threshold * component.highest - threshold * component.lowest;
    const auto begin = m_pairs.begin() + static_cast<std::ptrdiff_t>(m_first_pair[c]),
               end = m_pairs.begin() + static_cast<std::ptrdiff_t>(m_first_pair[c + 1]);
    return static_cast<std::uint32_t>(std::partition_point(begin,
                                                           end,
                                                           [&](const Extremum_pair& pair) {
                                                             return pair.persistence == 0 ||
                                                                    pair.persistence < difference;
                                                           }) -
                                      begin);
  }

  // Appends those of some nodes or arcs that are there when a number of pairs is cancelled.
  static void append_what_is_left(const std::vector<std::uint32_t>& items,
                                  const std::vector<Life>& lives,
                                  std::uint32_t number,
                                  std::vector<std::uint32_t>& result)
  {
    for (const std::uint32_t item : items) {
      if (lives[item].end <= number)
        return;
      if (lives[item].begin <= number)
        result.push_back(item);
    }
  }

  static std::uint32_t position(const std::vector<std::uint32_t>& nodes, std::uint32_t node)
  {
    const auto it = std::lower_bound(nodes.begin(), nodes.end(), node);
    CGAL_assertion(it != nodes.end() && *it == node);
    return static_cast<std::uint32_t>(it - nodes.begin());
  }

  // Zips the branches that wait, in a graph of what is left else.
  void zip(Folded_graph& graph,
           const std::vector<std::uint32_t>& nodes,
           const std::vector<std::uint32_t>& waiting_pairs) const
  {
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
      values.push_back(m_values[node]);
    std::array<std::vector<bool>, 2> is_extremum; // by side
    for (const std::uint32_t i : waiting_pairs) {
      const Extremum_pair& pair = m_pairs[i];
      is_extremum[pair.side].resize(nodes.size(), false);
      is_extremum[pair.side][position(nodes, pair.extremum)] = true;
    }
    for (const Side side : {BELOW, ABOVE})
      if (!is_extremum[side].empty())
        zip_branches(graph, values, side, is_extremum[side]);
  }

  std::vector<double> m_values;
  std::vector<Arc_ends> m_arcs; // all that ever are
  bool m_is_absolute;
  std::vector<Life> m_node_lives, m_arc_lives;
  std::vector<Component> m_components;
  std::vector<std::uint32_t> m_component_of_node;
  std::vector<Extremum_pair> m_pairs;    // by component
  std::vector<std::size_t> m_first_pair; // by component, and the number of all pairs
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_HIERARCHY_H
