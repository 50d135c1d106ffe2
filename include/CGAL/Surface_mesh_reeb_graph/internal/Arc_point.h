// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_POINT_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_POINT_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The height of a point of a Reeb graph among the nodes, whose numbers increase with their heights. The point is a
// vertex that may have been moved: into an arc that ends above or below it, for example.
template <class IsBelow>
class Arc_point
{
public:
  // `is_below(node)` tells whether the vertex lies below a node.
  explicit Arc_point(const IsBelow& is_below) : m_is_below(is_below) {}

  bool is_below(std::uint32_t node) const
  {
    return node >= m_upper || (node >= m_lower && m_is_below(node));
  }

  // Moves the point into an arc, to the nearer end if it lies outside.
  void move_into(const Arc_ends& ends)
  {
    m_lower = std::clamp(m_lower, ends.lower + 1, ends.upper);
    m_upper = std::clamp(m_upper, ends.lower + 1, ends.upper);
  }

  // Moves the point next to a node, on a side of it.
  void move_next_to(std::uint32_t node, Side side)
  {
    m_lower = m_upper = side == BELOW ? node : node + 1;
  }

private:
  const IsBelow& m_is_below;
  // between nodes below the first number and those from the second one on; in between the vertex decides
  std::uint32_t m_lower = 0, m_upper = no_node;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_POINT_H
