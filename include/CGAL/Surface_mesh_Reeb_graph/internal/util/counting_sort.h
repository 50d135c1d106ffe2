// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COUNTING_SORT_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COUNTING_SORT_H

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Sorts the items 0, ..., `number_of_items` - 1 by `key(item)`, a number less than
// `number_of_keys`; items of equal key keep their order. Calls `place(position, item)` for all of
// them. Returns where the items of every key begin in the sorted order, and at last where those of
// the largest key end: those of key k have the positions from `result[k]` to `result[k + 1]`. Takes
// linear time.
template <class Key, class Place>
std::vector<std::size_t> counting_sort(std::size_t number_of_items,
                                       std::size_t number_of_keys,
                                       const Key& key,
                                       const Place& place)
{
  // Two places ahead: after the sums, begin[k + 1] is where the items of key k begin, and when all
  // items are placed, where they end.
  std::vector<std::size_t> begin(number_of_keys + 2, 0);
  for (std::size_t item = 0; item < number_of_items; ++item) {
    CGAL_assertion(static_cast<std::size_t>(key(item)) < number_of_keys);
    ++begin[static_cast<std::size_t>(key(item)) + 2];
  }
  for (std::size_t k = 1; k < begin.size(); ++k)
    begin[k] += begin[k - 1];
  for (std::size_t item = 0; item < number_of_items; ++item)
    place(begin[static_cast<std::size_t>(key(item)) + 1]++, item);
  begin.pop_back();
  CGAL_assertion(begin.back() == number_of_items);
  return begin;
}

// The items alone, in their sorted order.
template <class Key>
std::vector<std::uint32_t>
items_sorted_by_counting(std::size_t number_of_items, std::size_t number_of_keys, const Key& key)
{
  std::vector<std::uint32_t> result(number_of_items);
  counting_sort(number_of_items, number_of_keys, key, [&](std::size_t position, std::size_t item) {
    result[position] = static_cast<std::uint32_t>(item);
  });
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COUNTING_SORT_H
