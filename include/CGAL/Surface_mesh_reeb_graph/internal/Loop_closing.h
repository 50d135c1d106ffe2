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

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Loop_pairs.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// A part of an arc that has been glued to a path upwards, from one node to another one.
struct Glued_part
{
  std::uint32_t arc, lower, upper;
};

// Closes loops of a Reeb graph: folds their cycles flat.
//
// At the highest node of a cycle its two arcs there are zipped together, down to the nearer one of
// their other ends. Of the longer arc a part is left there, the cycle has one node less; and so on,
// until two parallel arcs are left, which become one. What hangs on the cycle hangs on the fold
// afterwards, at its own height, so the fold is a quotient of the graph that has one loop less.
//
// If the cycle of the pair (s, m) consists of two monotone sides, the fold glues each point of one
// side to the point of the same height on the other, and no other extended persistence pair
// changes. Sublevel and superlevel sets stay connected as they were, since s and m have joined the
// two sides already. Of the part of the graph between two heights, the fold glues two intervals: if
// s or m lies between the heights, they hang together there, and no cycle comes or goes; if both
// do, the cycle goes; if none does, the two intervals belong to different components of the part,
// or else there would be a cycle with the split s and a merge below m, and no cycle comes or goes
// either.
//
// If a side goes up and down, its peaks are zipped first, each down to the higher one of the two
// valleys beside it. Then other pairs may change: two points of the same height are glued that were
// connected only along the cycle, so two components of sublevel or superlevel sets may become one
// earlier, by no more than the persistence of the loop.
//
// The loops are closed in the order of their splits, from the highest one on, and no small loop
// comes up later. Before an arc comes there is no small loop at all, and two through the arc would
// differ by one without it; so there is at most one. To close it changes the highest node of
// another cycle only if this is a peak that is zipped, which lies at or below m, and never raises
// the lowest one; a cycle that gets small thereby lay between s and m before, and was small.
//
// A zip follows only one side at a time: the longer arc passes all nodes of the other side that lie
// above its lower end at once. The logarithms of the lengths of all arcs, measured in nodes, bound
// the number of changes from one side to the other: it is O(log m) for each zip and O(m log m) in
// all (Georgiadis, Kaplan, Shafrir, Tarjan, Werneck, "Data structures for mergeable trees", 2011).
// Every change takes O(log m) time.
class Loop_closing
{
public:
  Loop_closing(const Loop_closing&) = delete; // the forest refers to the arcs
  Loop_closing& operator=(const Loop_closing&) = delete;

  // The nodes are numbered from the lowest to the highest.
  Loop_closing(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
    : m_number_of_nodes(number_of_nodes), m_arcs(arcs), m_forest(number_of_nodes, m_arcs)
  {}

  // Closes the loops for which `is_small(pair)` holds. If it holds for a pair, it must hold for all
  // pairs of the same component that lie between the two nodes.
  template <class IsSmall>
  void run(const IsSmall& is_small)
  {
    for (const std::uint32_t arc : sorted_downwards(m_number_of_nodes, m_arcs)) {
      const std::uint32_t highest = m_forest.add(arc);
      if (highest != no_arc && is_small(Loop_pair{m_arcs[arc].lower, m_arcs[highest].upper}))
        close(highest, m_arcs[arc].lower);
    }
  }

  // What is left of every arc. If nothing is, the ends are the same.
  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  // Those of an arc from the highest to the lowest. Between two nodes there is only one path
  // downwards that they can have been glued to.
  const std::vector<Glued_part>& glued_parts() const { return m_glued_parts; }

  // Whether other pairs may have changed.
  bool have_other_pairs_changed() const { return m_have_other_pairs_changed; }

private:
  struct Summary : Highest_arc
  {
    Summary() = default;
    Summary(std::uint32_t arc, const Arc_ends& ends)
      : Highest_arc(arc, ends), length(ends.upper - ends.lower)
    {}

    friend Summary operator+(const Summary& a, const Summary& b)
    {
      Summary result;
      static_cast<Highest_arc&>(result) = static_cast<const Highest_arc&>(a) + b;
      result.length = a.length + b.length;
      return result;
    }

    std::uint64_t length = 0; // the sum over the arcs
  };

  // Closes the loop of the path between the ends of an arc that is not in the forest, and whose
  // upper node is the highest one of the cycle.
  void close(std::uint32_t arc, std::uint32_t split)
  {
    const Arc_ends ends = m_arcs[arc];
    const std::uint64_t length = m_forest.sum_on_path(ends.upper, ends.lower).length;
    if (length != (ends.upper - split) + std::uint64_t(ends.lower - split))
      close_peaks(ends.upper, ends.lower);
    zip(ends.upper, {arc, split}, split);
  }

  // Makes a path between two nodes, the first one its highest, one that goes down and then up.
  void close_peaks(std::uint32_t node, std::uint32_t other)
  {
    m_have_other_pairs_changed = true;
    m_turns.clear();
    for (bool goes_down = true; node != other; goes_down = !goes_down) {
      node = m_forest.first_turn(goes_down, node, other);
      m_turns.push_back(node);
    }
    std::uint32_t valley = m_turns.front();
    for (std::size_t i = 1; i + 1 < m_turns.size(); i += 2) {
      const std::uint32_t peak = m_turns[i], next_valley = m_turns[i + 1];
      const std::uint32_t arc = m_forest.first_on_path(peak, valley);
      m_forest.remove(arc);
      zip(peak, {arc, valley}, next_valley);
      valley = (std::min)(valley, next_valley);
    }
  }

  // A path downwards that begins with an arc that is not in the forest; the others are.
  struct Side_of_cycle
  {
    std::uint32_t arc, valley;
  };

  // Zips two paths downwards together that begin at a node, one of them in the forest, down to the
  // higher one of their valleys.
  void zip(std::uint32_t node, Side_of_cycle side, std::uint32_t other_valley)
  {
    std::uint32_t other_arc = m_forest.first_on_path(node, other_valley);
    for (;;) {
      if (m_arcs[other_arc].lower < m_arcs[side.arc].lower) {
        m_forest.remove(other_arc);
        m_forest.insert(side.arc);
        std::swap(side.arc, other_arc);
        std::swap(side.valley, other_valley);
      }
      const std::uint32_t lower = m_arcs[side.arc].lower;
      if (lower == other_valley) { // then it is the valley of both
        glue(side.arc, lower);
        return;
      }
      const auto last = m_forest.last_on_path_down(
          node, other_valley, [lower](std::uint32_t other) { return other > lower; });
      glue(side.arc, last.node);
      if (last.node == other_valley) {
        m_forest.insert(side.arc);
        return;
      }
      node = last.node;
      other_arc = last.next_arc;
    }
  }

  // Glues an arc to the path downwards from its upper end to a node.
  void glue(std::uint32_t arc, std::uint32_t node)
  {
    CGAL_assertion(m_arcs[arc].lower <= node && node < m_arcs[arc].upper);
    m_glued_parts.push_back({arc, node, m_arcs[arc].upper});
    m_arcs[arc].upper = node;
  }

  std::size_t m_number_of_nodes;
  std::vector<Arc_ends> m_arcs;
  Arc_forest<Summary> m_forest;
  std::vector<Glued_part> m_glued_parts;
  bool m_have_other_pairs_changed = false;
  std::vector<std::uint32_t> m_turns; // of the path whose peaks are closed
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CLOSING_H
