// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_CLOSING_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_CLOSING_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Minimum_spanning_forest.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
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
// the changes from one side to the other: O(log m) for each zip, and O(m log m) more in all
// (Georgiadis, Kaplan, Shafrir, Tarjan, Werneck, "Data structures for mergeable trees", 2011). A
// change takes amortized O(log m) time.
//
// All cycles together have O(m log m) peaks. For consider the arcs of the forest that cycles may
// still run through: the upper node would make a small pair with the lower node of the next arc.
// Let them be divided into up-trees, connected parts in which no node has two arcs down; at first
// each arc is one. A path has a peak at most where it changes from one up-tree to another. In a
// tree of up-trees and nodes, let each node hang together with its up-trees by edges of its own:
// the path has one for each change. A closed cycle is an up-tree, with what hangs on it upwards in
// the up-trees on its path. Of each of these at most one part is left, which hangs downwards on the
// cycle. It becomes a neighbor of the new up-tree, as do the nodes: the path becomes a star. Arcs
// leave at the top, with an edge each; an up-tree without arcs stays, as a node. Now imagine a
// link-cut tree. To look up a path makes O(log m) edges solid, amortized, and a star without solid
// edges, of which only the center gets more below it, raises the potential by O(log m). There are
// O(m) such operations, and every edge that a star takes away had been made solid: O(m log m)
// edges.
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
      const Cycle cycle = m_forest.add(arc);
      if (cycle.highest_arc != no_arc &&
          is_small(Loop_pair{m_arcs[arc].lower, m_arcs[cycle.highest_arc].upper}))
        close(cycle);
    }
  }

  // What is left of every arc. If nothing is, the ends are the same.
  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  // Those of an arc from the highest to the lowest. Between two nodes there is only one path
  // downwards that they can have been glued to.
  const std::vector<Glued_part>& glued_parts() const { return m_glued_parts; }

  // Whether other pairs may have changed.
  bool have_other_pairs_changed() const { return m_have_other_pairs_changed; }

  // The time taken, but for a constant factor.
  std::uint64_t number_of_steps() const { return m_forest.number_of_steps(); }

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

  using Forest = Minimum_spanning_forest<Summary>;
  using Cycle = Forest::Cycle;
  using Path = Forest::Path;

  // A path downwards from where two sides meet: its first arc, and the rest, down to the valley,
  // which is not part of it.
  struct Side
  {
    std::uint32_t arc;
    Path rest;
    std::uint32_t valley;
  };

  // Folds a cycle flat.
  void close(const Cycle& cycle)
  {
    const std::uint32_t merge = m_arcs[cycle.highest_arc].upper;
    Path rest = cycle.path;
    Path down = m_forest.cut_off_monotone_part(true, merge, rest);
    std::uint32_t valley = m_forest.cut_off_last_node(down);
    Path up = m_forest.cut_off_monotone_part(false, valley, rest);
    while (rest != Forest::empty_path)
      close_peak(down, valley, up, rest);
    m_forest.cut_off_first_node(down);
    const Zipped_sides zipped =
        zip(merge, side(down, valley), {cycle.highest_arc, m_forest.reversed(up), valley});
    m_forest.join_by_node(zipped.path, valley, Forest::empty_path);
  }

  // Zips a peak of a cycle that goes down to a valley, up to the peak, and then the rest of its
  // path. Afterwards, `up` ends at the next peak. Neither `down` nor `up` contains the valley.
  void close_peak(Path& down, std::uint32_t& valley, Path& up, Path& rest)
  {
    m_have_other_pairs_changed = true;
    const std::uint32_t peak = m_forest.cut_off_last_node(up);
    Path other = m_forest.cut_off_monotone_part(true, peak, rest);
    const std::uint32_t other_valley = m_forest.cut_off_last_node(other);
    const Zipped_sides zipped =
        zip(peak, side(m_forest.reversed(up), valley), side(other, other_valley));
    m_forest.hang(m_forest.reversed(zipped.path), (std::max)(valley, other_valley));

    const Path left = m_forest.join_by_arc(Forest::empty_path, zipped.left.arc, zipped.left.rest);
    const Path next_up = m_forest.cut_off_monotone_part(false, other_valley, rest);
    if (other_valley < valley) {
      down = m_forest.join_by_node(down, valley, left);
      valley = other_valley;
      up = next_up;
    } else {
      up = m_forest.join_by_node(m_forest.reversed(left), other_valley, next_up);
    }
  }

  // A path downwards, without the node that it begins at, from its first arc on.
  Side side(Path path, std::uint32_t valley)
  {
    const std::uint32_t arc = m_forest.cut_off_first_arc(path);
    return {arc, path, valley};
  }

  // The path down to the higher one of the valleys, which is not part of it, and what is left of
  // the other side: its path from that valley on.
  struct Zipped_sides
  {
    Path path;
    Side left;
  };

  // Zips two sides together that begin at a node, down to the higher one of their valleys.
  Zipped_sides zip(std::uint32_t node, Side side, Side other)
  {
    Path path = Forest::path_of_node(node);
    for (;;) {
      // all of `side` that lies above the lower end of the longer arc passes at once
      if (m_arcs[side.arc].lower < m_arcs[other.arc].lower)
        std::swap(side, other);
      const std::uint32_t lower = m_arcs[other.arc].lower;
      if (side.valley >= lower) {
        glue(other.arc, side.valley);
        return {m_forest.join_by_arc(path, side.arc, side.rest), other};
      }
      Path passed = m_forest.cut_off_above(lower, side.rest);
      const std::uint32_t last = m_forest.cut_off_last_node(passed);
      glue(other.arc, last);
      path = m_forest.join_by_arc(path, side.arc, passed);
      path = m_forest.join_by_node(path, last, Forest::empty_path);
      side.arc = m_forest.cut_off_first_arc(side.rest);
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
  Forest m_forest;
  std::vector<Glued_part> m_glued_parts;
  bool m_have_other_pairs_changed = false;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_CLOSING_H
