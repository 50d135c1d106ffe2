// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_UPPER_WEDGE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_UPPER_WEDGE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Calls `function(h)` for the edges of an upper wedge, as halfedges that point to its vertex;
// `halfedge` is one of them, for which it is called twice.
template <class TriangleMesh, class VertexOrder, class Function>
void for_each_edge_of_upper_wedge(
    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge,
    const TriangleMesh& tmesh,
    const VertexOrder& order,
    const Function& function)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  const auto v = target(halfedge, tmesh);
  // from the edge of the wedge in both directions; once around if there is nothing else
  const auto follow = [&](const auto& next_edge) {
    halfedge_descriptor h = halfedge;
    std::size_t number_of_steps = 0;
    do {
      check_walk(++number_of_steps, tmesh);
      function(h);
      h = next_edge(h);
    } while (h != Graph_traits::null_halfedge() && h != halfedge && order(v, source(h, tmesh)));
  };
  follow([&](halfedge_descriptor h) {
    return is_border(h, tmesh) ? Graph_traits::null_halfedge() : opposite(next(h, tmesh), tmesh);
  });
  follow([&](halfedge_descriptor h) {
    return is_border(opposite(h, tmesh), tmesh) ? Graph_traits::null_halfedge()
                                                : prev(opposite(h, tmesh), tmesh);
  });
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_UPPER_WEDGE_H
