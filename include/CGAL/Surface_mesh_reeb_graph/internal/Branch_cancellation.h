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

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Cancels (minimum, merge) and (maximum, split) pairs of a Reeb graph.
//
// To cancel a minimum, two paths are zipped together that descend from its saddle, one to the minimum,
// the other past its height: points of the same height become one (Agarwal, Edelsbrunner, Harer, Wang,
// "Extreme elevation on a 2-manifold", 2006). If the branch is a single arc, the zip just takes it away;
// if other arcs hang on it, they hang on the other path afterwards, at their own heights. A zip
// removes its pair and leaves all other extended persistence pairs as they are, loops included.
//
// Vertices of the mesh follow their arcs: those of a cancelled branch go to the arc that it hung on.
class Branch_cancellation
{
public:
  // `values` increase with the nodes.
  Branch_cancellation(const std::vector<double>& values, const std::vector<Arc_ends>& arcs)
    : m_values(values), m_arcs(arcs), m_fates(arcs.size()), m_arcs_of_node(values.size())
  {
    for (std::uint32_t a = 0; a < arcs.size(); ++a) {
      attach(ABOVE, arcs[a].lower, a);
      attach(BELOW, arcs[a].upper, a);
    }
  }

  // Cancels all pairs of persistence 0, and those for which `is_small(pair)` holds; if it holds for a
  // pair, it must hold for all pairs of smaller persistence in the same component.
  template <class IsSmall>
  void run(const IsSmall& is_small)
  {
    for (const Extremum_pair& pair : Extremum_pairing(m_values, m_arcs).run())
      if (pair.persistence == 0 || is_small(pair))
        cancel(pair);
  }

  std::size_t number_of_arcs(Side side, std::uint32_t node) const
  {
    return m_arcs_of_node[node][side].size();
  }

  // A node is left if it has arcs that do not just pass through.
  bool is_node(std::uint32_t node) const { return !m_is_removed[node]; }

  bool is_arc(std::uint32_t arc) const { return m_fates[arc].kind == STAYS; }

  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  // The arc that a vertex belongs to which belonged to `arc` at the beginning. `is_below(node)` tells
  // whether the vertex lies below a node.
  template <class IsBelow>
  std::uint32_t arc_after(std::uint32_t arc, const IsBelow& is_below)
  {
    for (;;) {
      Fate& fate = m_fates[arc];
      if (fate.kind == STAYS)
        return arc;
      if (fate.kind == GOES_INTO) {
        Fate& next = m_fates[fate.arc];
        if (next.kind == GOES_INTO)
          fate = next; // halves the path for later queries
        arc = fate.arc;
      } else {
        arc = is_below(fate.node) ? fate.arc : fate.upper_arc;
      }
    }
  }

private:
  // What became of an arc: it stays; it went into another one; or it was cut at a node into a lower and
  // an upper arc.
  enum Fate_kind { STAYS, GOES_INTO, IS_CUT };

  struct Fate
  {
    Fate_kind kind = STAYS;
    std::uint32_t arc = no_arc; // the one it went into, or the lower one
    std::uint32_t upper_arc = no_arc;
    std::uint32_t node = no_node;
  };

  using Arcs_of_side = boost::container::small_vector<std::uint32_t, 2>;

  static Side opposite_side(Side side) { return side == BELOW ? ABOVE : BELOW; }

  Arcs_of_side& arcs_on(Side side, std::uint32_t node) { return m_arcs_of_node[node][side]; }

  void attach(Side side, std::uint32_t node, std::uint32_t arc)
  {
    m_arcs_of_node[node][side].push_back(arc);
  }

  void detach(Side side, std::uint32_t node, std::uint32_t arc)
  {
    Arcs_of_side& arcs = m_arcs_of_node[node][side];
    arcs.erase(std::find(arcs.begin(), arcs.end(), arc));
  }

  void cancel(const Extremum_pair& pair)
  {
    find_paths(pair);
    zip(pair);
  }

  struct Path
  {
    std::uint32_t first_arc;
    std::uint32_t tip;
    std::vector<std::uint32_t> arcs;
  };

  // Follows, from the saddle, one path in every arc on the side, the one furthest behind first, until
  // the first of them can go no further: it has reached the extremum of the pair, since all other
  // extrema on this side of the saddle that lie less far have been cancelled before. The paths whose
  // tips lie beyond the extremum by then belong to other branches.
  void find_paths(const Extremum_pair& pair)
  {
    m_paths.clear();
    for (std::uint32_t arc : arcs_on(pair.side, pair.saddle))
      m_paths.push_back({arc, end_on(pair.side, m_arcs[arc]), {arc}});

    const bool is_leaf = number_of_arcs(opposite_side(pair.side), pair.extremum) == 1;
    for (Path& path : m_paths)
      if (path.tip == pair.extremum && is_leaf)
        return;

    for (;;) {
      Path& path =
          *std::max_element(m_paths.begin(), m_paths.end(), [&pair](const Path& p, const Path& q) {
            return lies_towards(pair.side, p.tip, q.tip);
          });
      if (number_of_arcs(pair.side, path.tip) == 0)
        break;
      path.arcs.push_back(arcs_on(pair.side, path.tip).front());
      path.tip = end_on(pair.side, m_arcs[path.arcs.back()]);
    }
  }

  void zip(const Extremum_pair& pair)
  {
    const Side side = pair.side;
    auto is_to_extremum = [&pair](const Path& path) { return path.tip == pair.extremum; };
    const auto path = std::find_if(m_paths.begin(), m_paths.end(), is_to_extremum);
    const auto other = std::find_if_not(m_paths.begin(), m_paths.end(), is_to_extremum);
    CGAL_assertion(path != m_paths.end() && other != m_paths.end());

    std::uint32_t other_arc =
        other->first_arc; // the arc that the next node of the path is zipped to
    std::uint32_t previous = pair.saddle;
    for (const std::uint32_t arc : path->arcs) {
      const std::uint32_t node = end_on(side, m_arcs[arc]);
      remove_arc(arc);
      const bool vanishes = number_of_arcs(ABOVE, node) == 0 && number_of_arcs(BELOW, node) == 0;
      if (vanishes) {
        m_is_removed[node] = true;
        go_into(arc, other_arc);
      } else {
        while (lies_towards(opposite_side(side), end_on(side, m_arcs[other_arc]), node))
          other_arc = arcs_on(side, end_on(side, m_arcs[other_arc])).front();
        const Arc_ends cut = cut_arc(other_arc, node);
        go_into(arc, side == BELOW ? cut.upper : cut.lower);
        other_arc = side == BELOW ? cut.lower : cut.upper;
      }
      pass_through_if_regular(previous, other_arc);
      previous = node;
    }
    pass_through_if_regular(previous, other_arc);
  }

  void remove_arc(std::uint32_t arc)
  {
    detach(ABOVE, m_arcs[arc].lower, arc);
    detach(BELOW, m_arcs[arc].upper, arc);
  }

  void go_into(std::uint32_t arc, std::uint32_t other)
  {
    m_fates[arc].kind = GOES_INTO;
    m_fates[arc].arc = other;
  }

  std::uint32_t add_arc(std::uint32_t lower, std::uint32_t upper)
  {
    const std::uint32_t arc = static_cast<std::uint32_t>(m_arcs.size());
    m_arcs.push_back({lower, upper});
    m_fates.push_back(Fate());
    attach(ABOVE, lower, arc);
    attach(BELOW, upper, arc);
    return arc;
  }

  // Returns the lower and the upper part.
  Arc_ends cut_arc(std::uint32_t arc, std::uint32_t node)
  {
    remove_arc(arc);
    const std::uint32_t lower_arc = add_arc(m_arcs[arc].lower, node);
    const std::uint32_t upper_arc = add_arc(node, m_arcs[arc].upper);
    m_fates[arc] = {IS_CUT, lower_arc, upper_arc, node};
    return {lower_arc, upper_arc};
  }

  // A node with one arc below and one above is none: the two arcs become one. `other_arc` is kept
  // up to date if it is one of them.
  void pass_through_if_regular(std::uint32_t node, std::uint32_t& other_arc)
  {
    if (m_is_removed[node] || number_of_arcs(BELOW, node) != 1 || number_of_arcs(ABOVE, node) != 1)
      return;
    const std::uint32_t below = arcs_on(BELOW, node).front(), above = arcs_on(ABOVE, node).front();
    m_is_removed[node] = true;
    const std::uint32_t lower = m_arcs[below].lower, upper = m_arcs[above].upper;
    remove_arc(below);
    remove_arc(above);
    const std::uint32_t arc = add_arc(lower, upper);
    go_into(below, arc);
    go_into(above, arc);
    if (other_arc == below || other_arc == above)
      other_arc = arc;
  }

  const std::vector<double>& m_values;
  std::vector<Arc_ends> m_arcs; // all that ever were
  std::vector<Fate> m_fates;    // by arc
  std::vector<std::array<Arcs_of_side, 2>> m_arcs_of_node;
  std::vector<bool> m_is_removed = std::vector<bool>(m_values.size(), false);
  std::vector<Path> m_paths;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_BRANCH_CANCELLATION_H
