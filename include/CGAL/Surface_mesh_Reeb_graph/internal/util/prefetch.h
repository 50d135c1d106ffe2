// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_PREFETCH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_PREFETCH_H

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Prefetches the cache line at an address.
inline void prefetch([[maybe_unused]] const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_PREFETCH_H
