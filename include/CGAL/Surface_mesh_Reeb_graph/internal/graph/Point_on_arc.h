// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_POINT_ON_ARC_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_POINT_ON_ARC_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A point of a Reeb graph while the graph is simplified: a vertex on its way from arc to arc. It
// may have been moved off its height, into an arc that ends above or below it, for example.
struct Point_on_arc
{
  explicit Point_on_arc(std::uint32_t arc) : arc(arc) {}

  std::uint32_t arc;
  // between nodes below the first number and those from the second one on; in between the vertex
  // decides
  std::uint32_t lower = 0, upper = no_node;
};

// The height of a point among the nodes, whose numbers increase with their heights.
template <class IsBelow>
class Point_height
{
public:
  // `is_below(node)` tells whether the vertex lies below a node.
  Point_height(Point_on_arc& point, const IsBelow& is_below) : m_point(point), m_is_below(is_below)
  {}

  bool is_below(std::uint32_t node) const
  {
    return node >= m_point.upper || (node >= m_point.lower && m_is_below(node));
  }

  // Moves the point into an arc, to the nearer end if it lies outside.
  void move_into(const Arc_ends& ends)
  {
    CGAL_precondition(ends.lower < ends.upper);
    m_point.lower = std::clamp(m_point.lower, ends.lower + 1, ends.upper);
    m_point.upper = std::clamp(m_point.upper, ends.lower + 1, ends.upper);
  }

  // Moves the point next to a node, on a side of it.
  void move_next_to(std::uint32_t node, Side side)
  {
    m_point.lower = m_point.upper = side == BELOW ? node : node + 1;
  }

private:
  Point_on_arc& m_point;
  const IsBelow& m_is_below;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_POINT_ON_ARC_H
