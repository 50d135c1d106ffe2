// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_SIDE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_SIDE_H

#include <cstdint>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The two directions along a Reeb graph. What is said of minima holds for maxima with the graph
// upside down, so the code says it once, for a side.
enum Side { BELOW = 0, ABOVE = 1 };

inline Side opposite_side(Side side)
{
  return side == BELOW ? ABOVE : BELOW;
}

inline bool lies_towards(Side side, std::uint32_t i, std::uint32_t j)
{
  return side == BELOW ? i < j : j < i;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_SIDE_H
