// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FOLDED_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FOLDED_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Point_on_arc.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Zipped_arcs.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A Reeb graph while it is simplified: points of the same height are glued to each other, so that
// arcs go into other arcs. It remembers what became of every arc, for the vertices of the mesh to
// follow. All changes of single arcs take constant time, also at nodes with many arcs.
class Folded_graph
{
public:
  Folded_graph(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
    : m_arcs(arcs)
    , m_fates(arcs.size())
    , m_heirs(arcs.size())
    , m_links(arcs.size())
    , m_arcs_of_node(number_of_nodes)
    , m_is_removed(number_of_nodes, false)
  {
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
      m_heirs[arc] = {arc, arc};
      attach(arc);
    }
  }

  std::size_t number_of_nodes() const { return m_arcs_of_node.size(); }

  // A node is left if it has arcs that do not just pass through.
  bool is_node(std::uint32_t node) const { return !m_is_removed[node]; }

  bool is_arc(std::uint32_t arc) const { return m_fates[arc].kind == STAYS; }

  // All that ever were.
  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  std::size_t number_of_arcs(Side side, std::uint32_t node) const
  {
    return m_arcs_of_node[node][side].size;
  }

  std::uint32_t first_arc(Side side, std::uint32_t node) const
  {
    return m_arcs_of_node[node][side].first;
  }

  // The next arc on the same side of the same node.
  std::uint32_t next_arc(Side side, std::uint32_t arc) const { return m_links[arc][side].next; }

  // Moves a point to the arc that it belongs to now, or to one that is_glued_along_paths().
  // `is_below(node)` tells whether the vertex lies below a node.
  template <class IsBelow>
  void follow(Point_on_arc& point, const IsBelow& is_below)
  {
    Point_height<IsBelow> height(point, is_below);
    for (;;) {
      Fate& fate = m_fates[point.arc];
      if (fate.kind == STAYS || fate.kind == IS_GLUED_ALONG_PATHS)
        return;
      if (fate.kind == GOES_INTO) {
        Fate& next = m_fates[fate.arc];
        if (next.kind == GOES_INTO)
          fate = next; // halves the path for later queries
        point.arc = fate.arc;
      } else {
        const Zipped_arcs& zipped = m_zipped_arcs[fate.arc];
        if (fate.node == no_node)
          height.move_into(m_arcs[point.arc]);
        else
          height.move_next_to(fate.node, zipped.side());
        point.arc = zipped.arc_at(fate.position, height);
      }
    }
  }

  // The arc that a vertex belongs to which belonged to `arc` at the beginning, if no loops have
  // been closed.
  template <class IsBelow>
  std::uint32_t arc_after(std::uint32_t arc, const IsBelow& is_below)
  {
    Point_on_arc point(arc);
    follow(point, is_below);
    return point.arc;
  }

  // The arc that now has the end of `arc` on a side.
  std::uint32_t heir(Side side, std::uint32_t arc)
  {
    while (m_heirs[arc][side] != arc)
      arc = m_heirs[arc][side] = m_heirs[m_heirs[arc][side]][side];
    return arc;
  }

  // Lets the end of `arc` on a side be that of `other`.
  void set_heir(Side side, std::uint32_t arc, std::uint32_t other) { m_heirs[arc][side] = other; }

  std::uint32_t add_arc(const Arc_ends& ends)
  {
    const std::uint32_t arc = static_cast<std::uint32_t>(m_arcs.size());
    m_arcs.push_back(ends);
    m_fates.emplace_back();
    m_heirs.push_back({arc, arc});
    m_links.emplace_back();
    attach(arc);
    return arc;
  }

  // Removes an arc whose points are glued to points of `other`. Its ends have no heirs unless they
  // are set.
  void glue(std::uint32_t arc, std::uint32_t other)
  {
    CGAL_assertion(is_arc(arc) && is_arc(other) && arc != other);
    detach(arc);
    m_fates[arc].kind = GOES_INTO;
    m_fates[arc].arc = other;
  }

  // Replaces arcs by those that come about when branches are zipped together with their neighbors.
  // For arcs that are replaced, `first` holds the position of the new arc where their points begin
  // their way; `next_to` holds a node if the points go next to it instead of to those of the same
  // height.
  void replace(Zipped_arcs&& zipped,
               const std::vector<std::uint32_t>& first,
               const std::vector<std::uint32_t>& next_to)
  {
    for (std::uint32_t arc = 0; arc < first.size(); ++arc) {
      if (first[arc] == no_arc)
        continue;
      CGAL_assertion(is_arc(arc));
      detach(arc);
      Fate& fate = m_fates[arc];
      fate.kind = IS_ZIPPED;
      fate.arc = static_cast<std::uint32_t>(m_zipped_arcs.size());
      fate.position = first[arc];
      fate.node = next_to[arc];
    }
    zipped.finish([&](std::uint32_t begin, std::uint32_t end) {
      return add_arc(zipped.side() == BELOW ? Arc_ends{end, begin} : Arc_ends{begin, end});
    });
    m_zipped_arcs.push_back(std::move(zipped));
  }

  // Removes an arc that is glued along paths of several arcs. Others know which, by a number.
  void glue_along_paths(std::uint32_t arc, std::uint32_t number)
  {
    CGAL_assertion(is_arc(arc));
    detach(arc);
    m_fates[arc].kind = IS_GLUED_ALONG_PATHS;
    m_fates[arc].arc = number;
  }

  bool is_glued_along_paths(std::uint32_t arc) const
  {
    return m_fates[arc].kind == IS_GLUED_ALONG_PATHS;
  }

  // The number for the others.
  std::uint32_t number_of_glued_arc(std::uint32_t arc) const
  {
    CGAL_assertion(is_glued_along_paths(arc));
    return m_fates[arc].arc;
  }

  // Removes a node that has no arcs any more.
  void remove_node(std::uint32_t node) { m_is_removed[node] = true; }

  // A node with one arc below and one above is none: the two arcs become one.
  void pass_through_if_regular(std::uint32_t node)
  {
    if (m_is_removed[node] || number_of_arcs(BELOW, node) != 1 || number_of_arcs(ABOVE, node) != 1)
      return;
    m_is_removed[node] = true;
    const std::uint32_t below = first_arc(BELOW, node), above = first_arc(ABOVE, node);
    const std::uint32_t arc = add_arc({m_arcs[below].lower, m_arcs[above].upper});
    glue(below, arc);
    glue(above, arc);
    set_heir(BELOW, below, arc);
    set_heir(ABOVE, above, arc);
  }

private:
  // What became of an arc: it stays; it went into another one; it was glued along paths of others;
  // or it was zipped together with others, as a part of a branch.
  enum Fate_kind { STAYS, GOES_INTO, IS_GLUED_ALONG_PATHS, IS_ZIPPED };

  struct Fate
  {
    Fate_kind kind = STAYS;
    // the one it went into; or the number that others know; or the number of the zipped arcs
    std::uint32_t arc = no_arc;
    std::uint32_t position = no_arc; // in the zipped arcs
    std::uint32_t node = no_node;    // that the points of a zipped arc go next to, if there is one
  };

  // The arcs on a side of a node are a linked list: nodes may have very many.
  struct Links
  {
    std::uint32_t previous = no_arc, next = no_arc;
  };

  struct Arcs_of_side
  {
    std::uint32_t first = no_arc, last = no_arc, size = 0;
  };

  void attach(std::uint32_t arc)
  {
    CGAL_assertion(m_arcs[arc].lower < m_arcs[arc].upper && m_arcs[arc].upper < number_of_nodes());
    for (const Side side : {BELOW, ABOVE}) {
      Arcs_of_side& arcs = m_arcs_of_node[end_on(opposite_side(side), m_arcs[arc])][side];
      m_links[arc][side] = {arcs.last, no_arc};
      (arcs.last == no_arc ? arcs.first : m_links[arcs.last][side].next) = arc;
      arcs.last = arc;
      ++arcs.size;
    }
  }

  void detach(std::uint32_t arc)
  {
    for (const Side side : {BELOW, ABOVE}) {
      Arcs_of_side& arcs = m_arcs_of_node[end_on(opposite_side(side), m_arcs[arc])][side];
      const Links& links = m_links[arc][side];
      (links.previous == no_arc ? arcs.first : m_links[links.previous][side].next) = links.next;
      (links.next == no_arc ? arcs.last : m_links[links.next][side].previous) = links.previous;
      CGAL_assertion(arcs.size > 0);
      --arcs.size;
    }
  }

  std::vector<Arc_ends> m_arcs;
  std::vector<Fate> m_fates;                         // by arc
  std::vector<std::array<std::uint32_t, 2>> m_heirs; // by arc and side; paths are halved
  std::vector<std::array<Links, 2>> m_links; // by arc and side, in the list of the arc's other end
  std::vector<std::array<Arcs_of_side, 2>> m_arcs_of_node;
  std::vector<bool> m_is_removed;
  std::vector<Zipped_arcs> m_zipped_arcs;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FOLDED_GRAPH_H
