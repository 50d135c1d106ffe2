// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_CONCURRENCY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_CONCURRENCY_H

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The few forms of parallelism that the package uses. No result depends on the tag.

template <class ConcurrencyTag>
constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;

template <class ConcurrencyTag>
constexpr void check_concurrency_tag()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag is enabled but TBB is unavailable.");
#endif
}

// Into how many parts to cut work on `size` items whose parts have memory of their own.
template <class ConcurrencyTag>
std::size_t number_of_parts([[maybe_unused]] std::size_t size)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    const std::size_t threads =
        static_cast<std::size_t>((std::max)(1, tbb::this_task_arena::max_concurrency()));
    return (std::min)((std::min)(threads, std::size_t(8)), size / 4096 + 1);
  }
#endif
  return 1;
}

template <class ConcurrencyTag, class Function>
void for_each_part(std::size_t number, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::parallel_for(std::size_t(0), number, function);
    return;
  }
#endif
  for (std::size_t i = 0; i < number; ++i)
    function(i);
}

// Calls `function(begin, end)` for ranges that make up [0, size).
template <class ConcurrencyTag, class Function>
void for_each_range(std::size_t size, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        function(range.begin(), range.end());
                      });
    return;
  }
#endif
  function(std::size_t(0), size);
}

template <class ConcurrencyTag, class First, class Second>
void invoke_both(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::parallel_invoke(first, second);
    return;
  }
#endif
  first();
  second();
}

// `less` must be a strict total order, so that there is one result only.
template <class ConcurrencyTag, class Iterator, class Less>
void sort(Iterator begin, Iterator end, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::parallel_sort(begin, end, less);
    return;
  }
#endif
  std::sort(begin, end, less);
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_CONCURRENCY_H
