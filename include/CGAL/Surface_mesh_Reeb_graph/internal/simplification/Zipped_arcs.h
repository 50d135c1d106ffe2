// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ZIPPED_ARCS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ZIPPED_ARCS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The arcs that come about when the branches on a side of a graph are zipped together with their
// neighbors, and where the points of the arcs go that they are made of. Towards the side they
// follow each other: the points of an arc that was zipped begin in one of the new arcs and go on to
// those behind it, down to their own height. Jump pointers find it in O(log m) time for m arcs.
class Zipped_arcs
{
public:
  explicit Zipped_arcs(Side side) : m_side(side) {}

  Side side() const { return m_side; }

  // Adds an arc that begins at a node. Returns its position.
  std::uint32_t begin_arc(std::uint32_t node)
  {
    const std::uint32_t position = static_cast<std::uint32_t>(m_arcs.size());
    m_arcs.push_back({no_arc, node, no_node, position, position, 0});
    return position;
  }

  void end_arc(std::uint32_t position, std::uint32_t node) { m_arcs[position].end = node; }

  // Says which arc the points go to that come from one and lie beyond its end. It has been added
  // later.
  void set_next(std::uint32_t position, std::uint32_t next)
  {
    CGAL_assertion(position < next && next < m_arcs.size());
    m_arcs[position].next = next;
  }

  // Calls `add(begin, end)`, which returns a number, for all arcs.
  template <class AddArc>
  void finish(const AddArc& add)
  {
    for (std::uint32_t i = static_cast<std::uint32_t>(m_arcs.size()); i-- > 0;) {
      if (m_arcs[i].next != i)
        set_jump(i);
    }
    for (Arc& arc : m_arcs) {
      CGAL_assertion(arc.end != no_node);
      arc.number = add(arc.begin, arc.end);
    }
  }

  // The number of the arc that a point goes to whose way begins in an arc. `point.is_below(node)`
  // tells whether the point lies below a node.
  template <class Point>
  std::uint32_t arc_at(std::uint32_t position, const Point& point) const
  {
    const auto lies_behind = [&](std::uint32_t i) {
      return m_arcs[i].next != i && point.is_below(m_arcs[i].end) == (m_side == BELOW);
    };
    while (lies_behind(position)) {
      const std::uint32_t jump = m_arcs[position].jump;
      position = lies_behind(jump) ? jump : m_arcs[position].next;
    }
    return m_arcs[position].number;
  }

private:
  struct Arc
  {
    std::uint32_t number;
    std::uint32_t begin, end;
    std::uint32_t next, jump; // the arc itself if there is no next one
    std::uint32_t distance;   // how many follow
  };

  // Myers, "An applicative random-access stack", 1983.
  void set_jump(std::uint32_t i)
  {
    const std::uint32_t next = m_arcs[i].next, jump = m_arcs[next].jump,
                        jump_of_jump = m_arcs[jump].jump;
    m_arcs[i].distance = m_arcs[next].distance + 1;
    const bool are_equal = m_arcs[next].distance - m_arcs[jump].distance ==
                           m_arcs[jump].distance - m_arcs[jump_of_jump].distance;
    m_arcs[i].jump = are_equal ? jump_of_jump : next;
  }

  Side m_side;
  std::vector<Arc> m_arcs;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ZIPPED_ARCS_H
