// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SORTED_VERTICES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SORTED_VERTICES_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// All vertices in increasing order. The keys of the order are copied beside the vertices: sorting
// through property maps would miss the cache at every comparison.
template <class TriangleMesh, class VertexOrder, class VertexIndexMap>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
sorted_vertices(const TriangleMesh& tmesh,
                const VertexOrder& order,
                VertexIndexMap vertex_index_map)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using FT = typename VertexOrder::FT;

  struct Keyed_vertex
  {
    FT value;
    std::uint32_t plateau_distance;
    vertex_descriptor vertex;
  };

  std::vector<Keyed_vertex> keyed;
  keyed.reserve(num_vertices(tmesh));
  for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
    keyed.push_back({order.value(v), order.plateau_distance(v), v});
  std::sort(keyed.begin(), keyed.end(), [&](const Keyed_vertex& a, const Keyed_vertex& b) {
    if (a.value < b.value)
      return true;
    if (b.value < a.value)
      return false;
    if (a.plateau_distance != b.plateau_distance)
      return a.plateau_distance < b.plateau_distance;
    return get(vertex_index_map, a.vertex) < get(vertex_index_map, b.vertex);
  });

  std::vector<vertex_descriptor> result;
  result.reserve(keyed.size());
  for (const Keyed_vertex& k : keyed)
    result.push_back(k.vertex);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SORTED_VERTICES_H
