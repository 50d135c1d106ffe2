// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CLOSING_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CLOSING_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Folded_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Loop_pairs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Closes loops of a Reeb graph: folds their cycles flat.
//
// At the highest node of a cycle its two arcs there are zipped together, down to the nearer one of
// their other ends, which leaves a cycle with one node less; and so on, until two parallel arcs are
// left, which become one. What hangs on the cycle hangs on the fold afterwards, at its own height,
// so the fold is a quotient of the graph that has one loop less.
//
// If the cycle of the pair (s, m) consists of two monotone sides, the fold glues each point of one
// side to the point of the same height on the other, and no other extended persistence pair
// changes. Sublevel and superlevel sets stay connected as they were, since s and m have joined the
// two sides already. Of the part of the graph between two heights, the fold glues two intervals: if
// s or m lies between the heights, they hang together there, and no cycle comes or goes; if both
// do, the cycle goes; if none does, the two intervals belong to different components of the part,
// or else there would be a cycle with the merge m and a split above s, and no cycle comes or goes
// either.
//
// If a side goes up and down, other pairs may change: two points of the same height are glued that
// were connected only along the cycle, so two components of sublevel or superlevel sets may become
// one earlier, by no more than the persistence of the loop.
class Loop_closing
{
public:
  explicit Loop_closing(Folded_graph& graph) : m_graph(graph) {}

  // Closes the loops for which `is_small(pair)` holds, and such as come up then. Returns whether
  // other pairs may have changed.
  template <class IsSmall>
  bool run(const IsSmall& is_small)
  {
    bool have_other_pairs_changed = false;
    for (;;) {
      m_number_of_turns = 0;
      close_upwards(is_small);
      if (m_number_of_turns == 0)
        break;
      have_other_pairs_changed = true;
    }
    for (std::uint32_t node = 0; node < m_graph.number_of_nodes(); ++node)
      m_graph.pass_through_if_regular(node);
    return have_other_pairs_changed;
  }

private:
  // As loop_pairs(), but that the forest and the graph below a merge change when a loop is closed
  // there.
  template <class IsSmall>
  void close_upwards(const IsSmall& is_small)
  {
    Arc_forest forest(m_graph.number_of_nodes());
    std::vector<std::uint32_t> arcs;
    for (std::uint32_t merge = 0; merge < m_graph.number_of_nodes(); ++merge) {
      arcs.clear();
      for (std::uint32_t arc = m_graph.first_arc(BELOW, merge); arc != no_arc;
           arc = m_graph.next_arc(BELOW, arc))
        arcs.push_back(arc);
      for (const std::uint32_t arc : arcs) {
        const Arc_ends ends = m_graph.arcs()[arc];
        if (forest.are_connected(ends.lower, merge)) {
          const std::uint32_t lowest = forest.lowest_arc(ends.lower, merge);
          const Arc_ends lowest_ends = m_graph.arcs()[lowest];
          if (is_small(Loop_pair{(std::min)(ends.lower, lowest_ends.lower), merge})) {
            close(arc, forest);
            continue;
          }
          if (ends.lower <= lowest_ends.lower)
            continue;
          forest.remove(lowest, lowest_ends);
        }
        forest.insert(arc, ends);
      }
    }
  }

  // Closes the loop of an arc and the path between its ends in the forest. The cycle becomes a tree
  // on the same nodes. It takes the place of the path, and the forest stays a maximum one: what the
  // path connected down to a height, the tree does.
  void close(std::uint32_t closing_arc, Arc_forest& forest)
  {
    const Arc_ends ends = m_graph.arcs()[closing_arc];
    m_cycle = forest.path(ends.lower, ends.upper);
    m_nodes.assign(1, ends.lower);
    for (const std::uint32_t arc : m_cycle) {
      const Arc_ends& arc_ends = m_graph.arcs()[arc];
      m_nodes.push_back(arc_ends.lower == m_nodes.back() ? arc_ends.upper : arc_ends.lower);
      forest.remove(arc, arc_ends);
    }
    m_cycle.push_back(closing_arc);

    fold();
    for (const std::uint32_t arc : m_tree)
      forest.insert(arc, m_graph.arcs()[arc]);
  }

  // Folds the cycle of m_nodes, of which m_cycle[i] joins m_nodes[i] to the next one, to m_tree.
  void fold()
  {
    const std::uint32_t size = static_cast<std::uint32_t>(m_nodes.size());
    m_previous.resize(size);
    m_next.resize(size);
    m_order.resize(size);
    std::iota(m_order.begin(), m_order.end(), 0);
    std::sort(m_order.begin(), m_order.end(), [this](std::uint32_t i, std::uint32_t j) {
      return m_nodes[i] > m_nodes[j];
    });
    for (std::uint32_t i = 0; i < size; ++i) {
      m_previous[i] = (i + size - 1) % size;
      m_next[i] = (i + 1) % size;
    }
    for (std::uint32_t i = 0; i < size; ++i)
      if (m_nodes[i] != m_nodes[m_order.front()] && m_nodes[m_previous[i]] < m_nodes[i] &&
          m_nodes[m_next[i]] < m_nodes[i])
        ++m_number_of_turns;

    m_tree.clear();
    for (const std::uint32_t top : m_order) {
      const std::uint32_t previous = m_previous[top], next = m_next[top];
      const std::uint32_t previous_arc = m_cycle[previous], next_arc = m_cycle[top];
      if (previous == next) {
        m_graph.glue(previous_arc, next_arc);
        m_tree.push_back(next_arc);
        return;
      }
      const bool is_next_nearer = m_nodes[previous] < m_nodes[next];
      const std::uint32_t shorter_arc = is_next_nearer ? next_arc : previous_arc;
      const std::uint32_t longer_arc = is_next_nearer ? previous_arc : next_arc;
      const Arc_ends parts = m_graph.cut(longer_arc, m_nodes[is_next_nearer ? next : previous]);
      m_graph.glue(shorter_arc, parts.upper);
      m_tree.push_back(parts.upper);
      m_cycle[previous] = parts.lower;
      m_next[previous] = next;
      m_previous[next] = previous;
    }
  }

  Folded_graph& m_graph;
  std::size_t m_number_of_turns = 0; // peaks of the cycles other than their merges
  std::vector<std::uint32_t> m_nodes, m_cycle, m_tree;    // of the loop that is being closed
  std::vector<std::uint32_t> m_previous, m_next, m_order; // positions in m_nodes
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CLOSING_H
