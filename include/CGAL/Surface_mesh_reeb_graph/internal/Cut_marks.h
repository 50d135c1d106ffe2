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

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The edges that cuts along components of level sets cross, each with the lowest cut: the one that is met
// first on the way up. A cut is named after its leaf, the node at which ways up end there.
template <class TriangleMesh>
class Cut_marks
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  // Adds the edge `h` that points to its lower end, the vertex with number `lower_end`. Cuts are added in
  // the order of their levels.
  void add(std::size_t lower_end, halfedge_descriptor h, std::uint32_t leaf)
  {
    m_marks.push_back({lower_end, h, leaf});
  }

  // To be called between the last `add()` and the first `leaf()`.
  void sort(std::size_t index_bound)
  {
    if (m_marks.empty())
      return;
    m_is_marked.assign(index_bound, false);
    for (const Mark& mark : m_marks)
      m_is_marked[mark.lower_end] = true;
    std::stable_sort(m_marks.begin(), m_marks.end(), Less());
  }

  bool empty() const { return m_marks.empty(); }

  // The lowest cut that crosses the edge `h`, or `no_node`.
  std::uint32_t leaf(std::size_t lower_end, halfedge_descriptor h) const
  {
    if (m_is_marked.empty() || !m_is_marked[lower_end])
      return no_node;
    const auto range = std::equal_range(
        m_marks.begin(), m_marks.end(), Mark{lower_end, halfedge_descriptor(), no_node}, Less());
    const auto mark =
        std::find_if(range.first, range.second, [&](const Mark& m) { return m.halfedge == h; });
    return mark == range.second ? no_node : mark->leaf;
  }

private:
  struct Mark
  {
    std::size_t lower_end;
    halfedge_descriptor halfedge;
    std::uint32_t leaf;
  };

  struct Less
  {
    bool operator()(const Mark& a, const Mark& b) const { return a.lower_end < b.lower_end; }
  };

  std::vector<Mark> m_marks;
  std::vector<bool> m_is_marked; // by the index of the lower end; empty without marks
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CUT_MARKS_H
