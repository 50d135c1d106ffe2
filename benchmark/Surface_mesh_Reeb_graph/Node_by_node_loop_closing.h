// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops closed with no other thought, to compare Loop_closing with.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_NODE_BY_NODE_LOOP_CLOSING_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_NODE_BY_NODE_LOOP_CLOSING_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Minimum_spanning_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Reeb_graph_benchmark {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

// Closes the same loops as Loop_closing, in the same order, but finds every cycle by a search
// through the graph, and zips it together one node after the other: what the tests check
// Loop_closing against, with lists of the arcs of every node, so that no step takes longer than it
// has to.
class Node_by_node_loop_closing
{
public:
  using Arc_ends = SMRG::internal::Arc_ends;

  Node_by_node_loop_closing(const std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
    : m_arcs(arcs)
    , m_arcs_of_node(number_of_nodes)
    , m_components(number_of_nodes)
    , m_reached_by(number_of_nodes, SMRG::internal::no_arc)
  {}

  template <class IsSmall>
  void run(const IsSmall& is_small)
  {
    using SMRG::internal::Loop_pair;
    for (const std::uint32_t arc : SMRG::internal::sorted_downwards(m_arcs_of_node.size(), m_arcs))
    {
      const std::uint32_t lower = m_arcs[arc].lower, upper = m_arcs[arc].upper;
      const std::uint32_t a = m_components.root(lower), b = m_components.root(upper);
      if (a != b)
        m_components.join(a, b);
      else if (is_small(Loop_pair{lower, upper}))
        find_cycle(arc, [&](std::uint32_t node) { return is_small(Loop_pair{lower, node}); });
      m_arcs_of_node[lower].push_back(arc);
      m_arcs_of_node[upper].push_back(arc);
      close_cycle();
    }
  }

  // What is left of every arc. If nothing is, the ends are the same.
  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  // How many nodes have been passed: the work of all zips.
  std::size_t number_of_steps() const { return m_number_of_steps; }

private:
  std::uint32_t other_end(const std::uint32_t arc, const std::uint32_t node) const
  {
    return m_arcs[arc].lower == node ? m_arcs[arc].upper : m_arcs[arc].lower;
  }

  // The cycle that an arc completes among the nodes that are not too high, if there is one: there
  // is only one, as all others are closed.
  template <class IsNotTooHigh>
  void find_cycle(const std::uint32_t arc, const IsNotTooHigh& is_not_too_high)
  {
    const std::uint32_t first = m_arcs[arc].lower, last = m_arcs[arc].upper;
    m_reached = {first};
    m_reached_by[first] = arc;
    for (std::size_t i = 0; i < m_reached.size() && m_reached_by[last] == SMRG::internal::no_arc;
         ++i)
      for (const std::uint32_t next : m_arcs_of_node[m_reached[i]]) {
        const std::uint32_t node = other_end(next, m_reached[i]);
        if (m_reached_by[node] == SMRG::internal::no_arc && is_not_too_high(m_arcs[next].upper)) {
          m_reached_by[node] = next;
          m_reached.push_back(node);
        }
      }
    if (m_reached_by[last] != SMRG::internal::no_arc) {
      m_cycle.push_back(arc);
      for (std::uint32_t node = last; node != first; node = other_end(m_cycle.back(), node))
        m_cycle.push_back(m_reached_by[node]);
    }
    for (const std::uint32_t node : m_reached)
      m_reached_by[node] = SMRG::internal::no_arc;
  }

  // Zips the two arcs at the highest node of the cycle together, until nothing is left of it.
  void close_cycle()
  {
    const auto is_lower = [this](const std::uint32_t i, const std::uint32_t j) {
      return std::make_pair(m_arcs[i].upper, m_arcs[i].lower) <
             std::make_pair(m_arcs[j].upper, m_arcs[j].lower);
    };
    std::make_heap(m_cycle.begin(), m_cycle.end(), is_lower);
    while (!m_cycle.empty()) {
      ++m_number_of_steps;
      std::pop_heap(m_cycle.begin(), m_cycle.end(), is_lower);
      const std::uint32_t shorter = m_cycle.back();
      m_cycle.pop_back();
      std::pop_heap(m_cycle.begin(), m_cycle.end(), is_lower);
      const std::uint32_t longer = m_cycle.back();
      remove(m_arcs[longer].upper, longer);
      m_arcs[longer].upper = m_arcs[shorter].lower;
      if (m_arcs[longer].lower == m_arcs[longer].upper) {
        remove(m_arcs[longer].lower, longer);
        m_cycle.clear();
      } else {
        m_arcs_of_node[m_arcs[longer].upper].push_back(longer);
        std::push_heap(m_cycle.begin(), m_cycle.end(), is_lower);
      }
    }
  }

  void remove(const std::uint32_t node, const std::uint32_t arc)
  {
    std::vector<std::uint32_t>& arcs = m_arcs_of_node[node];
    std::swap(*std::find(arcs.begin(), arcs.end(), arc), arcs.back());
    arcs.pop_back();
  }

  std::vector<Arc_ends> m_arcs;
  std::vector<std::vector<std::uint32_t>> m_arcs_of_node;
  SMRG::internal::Disjoint_sets m_components;
  std::vector<std::uint32_t> m_reached_by; // arc, by node; no_arc but while a cycle is looked for
  std::vector<std::uint32_t> m_reached, m_cycle;
  std::size_t m_number_of_steps = 0;
};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_NODE_BY_NODE_LOOP_CLOSING_H
