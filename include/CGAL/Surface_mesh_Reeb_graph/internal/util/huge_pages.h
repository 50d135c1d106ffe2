// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_HUGE_PAGES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_HUGE_PAGES_H

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <memory>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Asks the system for huge pages behind `size` objects of memory that was allocated but not used
// yet. The page fault at the first use of every small page costs as much as reading it several
// times, and on virtual machines more than that. Where the system has no huge pages, nothing
// happens.
template <class T>
void prefer_huge_pages(const T* data, std::size_t size)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t huge_page = std::uintptr_t(1) << 21;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t begin = (address + huge_page - 1) / huge_page * huge_page;
  const std::uintptr_t end = (address + size * sizeof(T)) / huge_page * huge_page;
  if (begin < end) {
    const int error = errno;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    errno = error; // it was a wish
  }
#else
  static_cast<void>(data);
  static_cast<void>(size);
#endif
}

// An allocator for large containers.
template <class T>
class Huge_page_allocator
{
public:
  using value_type = T;

  Huge_page_allocator() = default;
  template <class U>
  Huge_page_allocator(const Huge_page_allocator<U>&)
  {}

  T* allocate(std::size_t size)
  {
    T* const result = std::allocator<T>().allocate(size);
    prefer_huge_pages(result, size);
    return result;
  }
  void deallocate(T* data, std::size_t size) { std::allocator<T>().deallocate(data, size); }

  friend bool operator==(const Huge_page_allocator&, const Huge_page_allocator&) { return true; }
  friend bool operator!=(const Huge_page_allocator&, const Huge_page_allocator&) { return false; }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_HUGE_PAGES_H
