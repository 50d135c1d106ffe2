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
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
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

// Closes loops of a Reeb graph: folds their cycles flat, those with the highest splits first.
//
// At the highest node of a cycle its two arcs there are zipped together, down to the nearer one of
// their other ends, and so on, until two parallel arcs are left, which become one. What hangs on
// the cycle hangs on the fold afterwards, at its own height. If a side of the cycle goes up and
// down, its peaks are zipped first, each down to the higher one of the two valleys beside it.
//
// A zip follows only one side at a time: the longer arc passes all nodes of the other side that lie
// above its lower end at once. So the time is in the changes from one side to the other: O(m log m)
// in all, beside those at peaks, each of them amortized O(log m).
//
// The design chapter, loop_closing.md, has the proofs: no other pair changes if both sides are
// monotone; no small loop comes up later; the numbers of changes and of peaks. It also has the
// figures that tell why the nodes are not passed one by one.
class Loop_closing
{
public:
  Loop_closing(const Loop_closing&) = delete; // the forest refers to the arcs
  Loop_closing& operator=(const Loop_closing&) = delete;

  // The nodes are numbered from the lowest to the highest.
  Loop_closing(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
    : m_number_of_nodes(number_of_nodes), m_arcs(arcs), m_forest(number_of_nodes, m_arcs)
  {
    CGAL_precondition(std::all_of(arcs.begin(), arcs.end(), [&](const Arc_ends& ends) {
      return ends.lower < ends.upper && ends.upper < number_of_nodes;
    }));
  }

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
    CGAL_assertion(m_arcs[zipped.left.arc].lower == m_arcs[zipped.left.arc].upper);
    CGAL_assertion(zipped.left.rest == Forest::empty_path);
    m_forest.join_by_node(zipped.path, valley, Forest::empty_path);
  }

  // Zips a peak of a cycle that goes down to a valley, up to the peak, and then the rest of its
  // path. Afterwards, `up` ends at the next peak. Neither `down` nor `up` contains the valley.
  void close_peak(Path& down, std::uint32_t& valley, Path& up, Path& rest)
  {
    m_have_other_pairs_changed = true;
    const std::uint32_t peak = m_forest.cut_off_last_node(up);
    CGAL_assertion(valley < peak);
    Path other = m_forest.cut_off_monotone_part(true, peak, rest);
    const std::uint32_t other_valley = m_forest.cut_off_last_node(other);
    CGAL_assertion(other_valley < peak && other_valley != valley);
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
      CGAL_assertion(m_arcs[side.arc].upper == m_arcs[other.arc].upper);
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
