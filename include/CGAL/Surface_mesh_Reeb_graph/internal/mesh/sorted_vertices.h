// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_SORTED_VERTICES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_SORTED_VERTICES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Sorts vertices into increasing order. The values are copied beside the vertices: sorting through
// property maps would miss the cache at every comparison.
template <class ConcurrencyTag, class VertexDescriptor, class VertexOrder>
void sort_vertices(std::vector<VertexDescriptor>& vertices, const VertexOrder& order)
{
  struct Keyed_vertex
  {
    typename VertexOrder::FT value;
    VertexDescriptor vertex;
  };

  std::vector<Keyed_vertex> keyed;
  keyed.reserve(vertices.size());
  for (const VertexDescriptor v : vertices)
    keyed.push_back({order.value(v), v});
  sort<ConcurrencyTag>(
      keyed.begin(), keyed.end(), [&](const Keyed_vertex& a, const Keyed_vertex& b) {
        if (a.value < b.value)
          return true;
        if (b.value < a.value)
          return false;
        return order(a.vertex, b.vertex);
      });
  for (std::size_t i = 0; i < keyed.size(); ++i)
    vertices[i] = keyed[i].vertex;
}

// All vertices in increasing order.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
sorted_vertices(const TriangleMesh& tmesh, const VertexOrder& order)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  std::vector<vertex_descriptor> result;
  result.reserve(num_vertices(tmesh));
  for (const vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
    if (has_no_edge(v, tmesh))
      order.check_value(v); // all others are checked by the comparisons
    result.push_back(v);
  }
  sort_vertices<ConcurrencyTag>(result, order);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_SORTED_VERTICES_H
