// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DISJOINT_SETS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DISJOINT_SETS_H

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Disjoint sets (union-find) of the numbers 0, 1, ... Which of two roots stays root is up to the
// caller: in the graph algorithms the root has a meaning (the arc that goes on, the set of the
// older extremum). With path halving any sequence of m operations takes O(m log m) time.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n = 0) : m_parent(n)
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  // Adds the next number, a set of its own.
  void add() { m_parent.push_back(static_cast<std::uint32_t>(m_parent.size())); }

  std::uint32_t root(std::uint32_t i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  // Joins the set of the root `i` to the set of the root `j`.
  void join(std::uint32_t i, std::uint32_t j)
  {
    CGAL_precondition(is_root(i) && is_root(j));
    m_parent[i] = j;
  }

private:
  bool is_root(std::uint32_t i) const { return i < m_parent.size() && m_parent[i] == i; }

  std::vector<std::uint32_t> m_parent;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DISJOINT_SETS_H
