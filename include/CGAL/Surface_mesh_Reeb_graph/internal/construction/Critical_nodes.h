// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODES_H

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The vertices that may be critical, as nodes, numbered in their order, and for every wedge of
// theirs a node in the component of the sublevel (or superlevel) set that it leads to: the end of a
// monotone path. On demand a multiple saddle is unfolded: it becomes several nodes with the same
// vertex, which are simple saddles.
template <class TriangleMesh>
struct Critical_nodes
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  std::size_t size() const { return vertex.size(); }

  // Whether a node is the first (or the only) one that a vertex is unfolded into.
  bool is_first_of_vertex(std::uint32_t node) const
  {
    return node == 0 || vertex[node - 1] != vertex[node];
  }

  bool is_unfolded(std::uint32_t node) const
  {
    return !is_first_of_vertex(node) || (node + 1 < size() && !is_first_of_vertex(node + 1));
  }

  // The ends of monotone paths have the numbers that the nodes get in the order of the mesh; the
  // leaves of cuts have numbers beyond.
  std::uint32_t number_of_end(std::uint32_t end) const
  {
    return end < number.size() ? number[end] : end;
  }

  std::vector<vertex_descriptor> vertex;
  std::vector<std::uint32_t> number; // of the node, by its number in the order of the mesh
  // the wedges of node i are those from lower_begin[i] to lower_begin[i + 1], upper ones likewise
  std::vector<std::uint32_t> lower_begin, upper_begin;
  std::vector<std::uint32_t> lower_end, upper_end; // ends of paths, by wedge
  // the numbers of the upward paths, by wedge; none for the way to another node of the same vertex
  std::vector<std::uint32_t> upper_path;
  // the first edges of the upper wedges, in the order of their lowest vertices; null for the way to
  // another node of the same vertex
  std::vector<halfedge_descriptor> upper_halfedge;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODES_H
