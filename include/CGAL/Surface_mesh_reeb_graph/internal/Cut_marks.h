// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CUT_MARKS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CUT_MARKS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Edge_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The edges that cuts along components of level sets cross, each with the lowest cut: the one that is met
// first on the way up. A cut is named after its leaf, the node at which ways up end there; higher cuts have
// larger names. Several threads may add marks at once.
template <class TriangleMesh, class HalfedgeIndexMap>
class Cut_marks
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  bool empty() const { return m_leaf.empty(); }

  // To be called before the first mark is added.
  void begin(const TriangleMesh& tmesh, HalfedgeIndexMap halfedge_index_map)
  {
    m_edge_numbers.emplace(tmesh, halfedge_index_map);
    m_leaf = std::vector<std::atomic<std::uint32_t>>(m_edge_numbers->bound());
  }

  void add(halfedge_descriptor h, std::uint32_t leaf)
  {
    std::atomic<std::uint32_t>& mark = m_leaf[(*m_edge_numbers)(h)];
    std::uint32_t known = mark.load(std::memory_order_relaxed);
    while ((known == 0 || leaf + 1 < known) &&
           !mark.compare_exchange_weak(known, leaf + 1, std::memory_order_relaxed))
    {}
  }

  // The lowest cut that crosses the edge `h`, or `no_node`.
  std::uint32_t leaf(halfedge_descriptor h) const
  {
    return empty() ? no_node : m_leaf[(*m_edge_numbers)(h)].load(std::memory_order_relaxed) - 1;
  }

private:
  std::optional<Edge_numbers<TriangleMesh, HalfedgeIndexMap>> m_edge_numbers;
  std::vector<std::atomic<std::uint32_t>> m_leaf; // plus 1, by edge number; 0 without a mark
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CUT_MARKS_H
