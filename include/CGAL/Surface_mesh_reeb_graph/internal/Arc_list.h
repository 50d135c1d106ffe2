// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_LIST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_LIST_H

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

constexpr std::uint32_t no_node = (std::numeric_limits<std::uint32_t>::max)();
constexpr std::uint32_t no_arc = (std::numeric_limits<std::uint32_t>::max)();

struct Arc_ends
{
  std::uint32_t lower, upper; // positions in the list of nodes
};

// A Reeb graph as plain lists: what the algorithms make, before it is written to the user's graph.
template <class Vertex>
struct Arc_list
{
  std::vector<Vertex> nodes;  // the critical vertices in increasing order
  std::vector<Arc_ends> arcs; // by lower node, then by the lowest vertex above it that they lead to
  std::vector<std::uint32_t> arc_of_vertex; // by vertex index; no_arc if the vertex has no edge
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_LIST_H
