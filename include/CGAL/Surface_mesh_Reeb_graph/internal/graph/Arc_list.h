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

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
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

inline std::uint32_t end_on(Side side, const Arc_ends& arc)
{
  return side == BELOW ? arc.lower : arc.upper;
}

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

  // Whether every arc leads from a node to a higher one.
  bool are_arcs_upward() const
  {
    return std::all_of(arcs.begin(), arcs.end(), [this](const Arc_ends& arc) {
      return arc.lower < arc.upper && arc.upper < nodes.size();
    });
  }

  // Gives the vertex of every node the first arc that begins there, or else the first that ends
  // there. If several nodes have one vertex, the first node counts.
  template <class VertexIndexMap>
  void set_arcs_of_nodes(VertexIndexMap vertex_index_map)
  {
    std::vector<std::uint32_t> first_arc(nodes.size(), no_arc);
    CGAL_assertion(are_arcs_upward());
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
