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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

template <class FT>
struct Valued_position
{
  FT value;
  std::uint32_t position;
};

// Sorts into buckets of equal width, which hold few items each if the values are spread out, and then
// these; `less` must order by value first. Values that are not spread out take as long as before.
template <class FT, class Less>
void sort_by_buckets(std::vector<Valued_position<FT>>& items, const Less& less)
{
  constexpr std::size_t items_per_bucket = 8;
  const std::size_t number_of_buckets = items.size() / items_per_bucket;
  if (number_of_buckets < 2) {
    std::sort(items.begin(), items.end(), less);
    return;
  }
  FT lowest = items.front().value, highest = lowest;
  for (const Valued_position<FT>& item : items) {
    lowest = (std::min)(lowest, item.value);
    highest = (std::max)(highest, item.value);
  }
  // monotone with all its rounding
  const FT scale = static_cast<FT>(number_of_buckets) / (highest - lowest);
  if (!(scale > 0) || !std::isfinite(scale) || !std::isfinite(highest - lowest)) {
    std::sort(items.begin(), items.end(), less);
    return;
  }
  const auto bucket = [&](std::size_t i) {
    return (std::min)(static_cast<std::size_t>((items[i].value - lowest) * scale),
                      number_of_buckets - 1);
  };
  std::vector<Valued_position<FT>> sorted(items.size());
  const std::vector<std::size_t> begin = counting_sort(
      items.size(), number_of_buckets, bucket, [&](std::size_t position, std::size_t i) {
        sorted[position] = items[i];
      });
  items = std::move(sorted);
  for (std::size_t b = 0; b < number_of_buckets; ++b)
    std::sort(items.begin() + static_cast<std::ptrdiff_t>(begin[b]),
              items.begin() + static_cast<std::ptrdiff_t>(begin[b + 1]),
              less);
}

// The positions of vertices in increasing order of these; the same vertex may be there more than
// once. The values are copied beside the positions: sorting through property maps would miss the
// cache at every comparison.
template <class ConcurrencyTag, class VertexDescriptor, class VertexOrder>
std::vector<std::uint32_t>
sorted_positions(const std::vector<VertexDescriptor>& vertices, const VertexOrder& order)
{
  using Item = Valued_position<typename VertexOrder::FT>;

  std::vector<Item> items;
  items.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    items.push_back({order.value(vertices[i]), static_cast<std::uint32_t>(i)});
  const auto less = [&](const Item& a, const Item& b) {
    if (a.value < b.value)
      return true;
    if (b.value < a.value)
      return false;
    const VertexDescriptor u = vertices[a.position], v = vertices[b.position];
    return u == v ? a.position < b.position : order(u, v);
  };
  if constexpr (std::is_floating_point<typename VertexOrder::FT>::value &&
                !is_parallel<ConcurrencyTag>)
    sort_by_buckets(items, less);
  else
    sort<ConcurrencyTag>(items.begin(), items.end(), less);
  std::vector<std::uint32_t> result;
  result.reserve(items.size());
  for (const Item& item : items)
    result.push_back(item.position);
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
