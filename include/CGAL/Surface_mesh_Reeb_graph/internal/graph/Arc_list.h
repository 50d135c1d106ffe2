// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_LIST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_LIST_H

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

constexpr std::uint32_t no_node = (std::numeric_limits<std::uint32_t>::max)();
constexpr std::uint32_t no_arc = (std::numeric_limits<std::uint32_t>::max)();

struct Arc_ends
{
  std::uint32_t lower, upper; // positions in the list of nodes
};

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

inline std::uint32_t end_on(Side side, const Arc_ends& arc)
{
  return side == BELOW ? arc.lower : arc.upper;
}

// What a user wants of a Reeb graph.
struct Reeb_graph_request
{
  bool unfolds = false;        // multiple saddles into simple ones
  bool has_vertex_arcs = true; // fills Arc_list::arc_of_vertex
  bool has_wedge_arcs = false; // fills Arc_list::upper_wedges
};

// A Reeb graph as plain lists: what the algorithms make, before it is written to the user's graph.
template <class TriangleMesh>
struct Arc_list
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  // The arc above a vertex in a wedge of upper edges, which an edge that points to the vertex
  // stands for.
  struct Upper_wedge
  {
    halfedge_descriptor halfedge;
    std::uint32_t arc;
  };

  std::vector<vertex_descriptor> nodes; // the critical vertices in increasing order
  std::vector<Arc_ends> arcs; // by lower node, then by the lowest vertex above it that they lead to
  std::vector<std::uint32_t> arc_of_vertex; // by vertex index; no_arc if the vertex has no edge
  std::vector<Upper_wedge> upper_wedges;    // of the vertices that several arcs begin at

  // Gives the vertex of every node the first arc that begins there, or else the first that ends
  // there. If several nodes have one vertex, the first node counts.
  template <class VertexIndexMap>
  void set_arcs_of_nodes(VertexIndexMap vertex_index_map)
  {
    std::vector<std::uint32_t> first_arc(nodes.size(), no_arc);
    for (std::uint32_t a = static_cast<std::uint32_t>(arcs.size()); a-- > 0;)
      first_arc[arcs[a].upper] = a;
    for (std::uint32_t a = static_cast<std::uint32_t>(arcs.size()); a-- > 0;)
      first_arc[arcs[a].lower] = a;
    for (std::size_t i = nodes.size(); i-- > 0;)
      arc_of_vertex[static_cast<std::size_t>(get(vertex_index_map, nodes[i]))] = first_arc[i];
  }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_LIST_H
