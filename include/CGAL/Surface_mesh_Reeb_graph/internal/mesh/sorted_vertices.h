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
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The positions of vertices in increasing order of these; the same vertex may be there more than
// once. The values are copied beside the positions: sorting through property maps would miss the
// cache at every comparison.
template <class ConcurrencyTag, class VertexDescriptor, class VertexOrder>
std::vector<std::uint32_t>
sorted_positions(const std::vector<VertexDescriptor>& vertices, const VertexOrder& order)
{
  struct Keyed_position
  {
    typename VertexOrder::FT value;
    std::uint32_t position;
  };

  std::vector<Keyed_position> keyed;
  keyed.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    keyed.push_back({order.value(vertices[i]), static_cast<std::uint32_t>(i)});
  sort<ConcurrencyTag>(
      keyed.begin(), keyed.end(), [&](const Keyed_position& a, const Keyed_position& b) {
        if (a.value < b.value)
          return true;
        if (b.value < a.value)
          return false;
        const VertexDescriptor u = vertices[a.position], v = vertices[b.position];
        return u == v ? a.position < b.position : order(u, v);
      });
  std::vector<std::uint32_t> result;
  result.reserve(keyed.size());
  for (const Keyed_position& k : keyed)
    result.push_back(k.position);
  return result;
}

// Sorts vertices into increasing order.
template <class ConcurrencyTag, class VertexDescriptor, class VertexOrder>
void sort_vertices(std::vector<VertexDescriptor>& vertices, const VertexOrder& order)
{
  std::vector<VertexDescriptor> sorted;
  sorted.reserve(vertices.size());
  for (const std::uint32_t i : sorted_positions<ConcurrencyTag>(vertices, order))
    sorted.push_back(vertices[i]);
  vertices = std::move(sorted);
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
