// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_BRANCH_CANCELLATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_BRANCH_CANCELLATION_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Extremum_pairs.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Folded_graph.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Cancels (minimum, merge) and (maximum, split) pairs of a Reeb graph.
//
// To cancel a minimum, two paths are zipped together that descend from its saddle, one to the
// minimum, the other past its height: points of the same height become one (Agarwal, Edelsbrunner,
// Harer, Wang, "Extreme elevation on a 2-manifold", 2006). If the branch is a single arc, the zip
// just takes it away; if other arcs hang on it, they hang on the other path afterwards, at their
// own heights. A zip removes its pair and leaves all other extended persistence pairs as they are,
// loops included.
//
// Vertices of the mesh follow their arcs: those of a branch that is a single arc go to the arc that
// it hung on, others to the points of the same height.
class Branch_cancellation : public Folded_graph
{
public:
  // `values` increase with the nodes.
  Branch_cancellation(const std::vector<double>& values, const std::vector<Arc_ends>& arcs)
    : Folded_graph(values.size(), arcs), m_values(values)
  {}

  // The pairs of the graph as it is now, in an order in which they can be cancelled.
  std::vector<Extremum_pair> pairs() const
  {
    return Extremum_pairing(m_values, arcs(), [this](std::uint32_t arc) { return is_arc(arc); })
        .run();
  }

  // Cancels all pairs of persistence 0, and those for which `is_small(pair)` holds; if it holds for
  // a pair, it must hold for all pairs of smaller persistence in the same component.
  template <class IsSmall>
  void run(const IsSmall& is_small)
  {
    for (const Extremum_pair& pair : pairs())
      if (pair.persistence == 0 || is_small(pair))
        cancel(pair);
  }

  // Cancels one of `pairs()`; all that come before it in the same component must have been
  // cancelled, and nothing else have changed since then.
  void cancel(const Extremum_pair& pair)
  {
    find_path(pair);
    zip(pair);
  }

private:
  // Of the extrema on the branch of the pair all others have been cancelled before, so every path
  // away from the saddle ends at the one of the pair.
  void find_path(const Extremum_pair& pair)
  {
    m_path.clear();
    for (std::uint32_t arc = heir(opposite_side(pair.side), pair.arc); arc != no_arc;
         arc = first_arc(pair.side, end_on(pair.side, arcs()[arc])))
      m_path.push_back(arc);
    CGAL_assertion(end_on(pair.side, arcs()[m_path.back()]) == pair.extremum);
  }

  void zip(const Extremum_pair& pair)
  {
    const Side side = pair.side;
    // the arc that the next node of the path is zipped to
    std::uint32_t other_arc = heir(opposite_side(side), pair.other_arc);
    std::uint32_t previous = pair.saddle;
    for (const std::uint32_t path_arc : m_path) {
      const std::uint32_t node = end_on(side, arcs()[path_arc]);
      const bool vanishes =
          number_of_arcs(side, node) == 0 && number_of_arcs(opposite_side(side), node) == 1;
      if (vanishes) {
        set_heir(opposite_side(side), path_arc, other_arc);
        glue(path_arc, other_arc);
        remove_node(node);
      } else {
        std::uint32_t arc = path_arc; // what is not glued yet
        for (std::uint32_t passed = end_on(side, arcs()[other_arc]);
             lies_towards(opposite_side(side), passed, node);
             passed = end_on(side, arcs()[other_arc]))
        {
          const Parts parts = cut_seen_from(opposite_side(side), arc, passed);
          set_heir(opposite_side(side), parts.near, other_arc);
          glue(parts.near, other_arc);
          arc = parts.far;
          other_arc = first_arc(side, passed);
        }
        const Parts parts = cut_seen_from(opposite_side(side), other_arc, node);
        set_heir(opposite_side(side), arc, parts.near);
        set_heir(side, arc, parts.near);
        glue(arc, parts.near);
        other_arc = parts.far;
      }
      pass_through(previous, other_arc);
      previous = node;
    }
    pass_through(previous, other_arc);
  }

  struct Parts
  {
    std::uint32_t near, far;
  };

  Parts cut_seen_from(Side side, std::uint32_t arc, std::uint32_t node)
  {
    const Arc_ends parts = cut(arc, node);
    return side == BELOW ? Parts{parts.lower, parts.upper} : Parts{parts.upper, parts.lower};
  }

  // Keeps `other_arc` up to date if it is one of the two arcs at the node.
  void pass_through(std::uint32_t node, std::uint32_t& other_arc)
  {
    const std::uint32_t arc = pass_through_if_regular(node);
    if (arc != no_arc && !is_arc(other_arc))
      other_arc = arc;
  }

  const std::vector<double>& m_values;
  std::vector<std::uint32_t> m_path;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_BRANCH_CANCELLATION_H
