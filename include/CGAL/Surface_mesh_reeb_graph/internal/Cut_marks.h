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
#include <CGAL/Surface_mesh_reeb_graph/internal/concurrency.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The edges that cuts along components of level sets cross. A cut is named after its leaf, the node at which ways
// up end there; higher cuts have larger names. There are few marks as a rule, compared to the edges.
template <class TriangleMesh>
class Cut_marks
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  struct Mark
  {
    std::uint32_t lower_end; // the vertex index
    std::uint32_t leaf;
    halfedge_descriptor halfedge; // points to the lower end
  };

  Cut_marks() = default;

  template <class ConcurrencyTag>
  Cut_marks(std::vector<Mark>&& marks, std::size_t index_bound, ConcurrencyTag)
    : m_marks(std::move(marks)), m_is_marked(index_bound, false)
  {
    for (const Mark& mark : m_marks)
      m_is_marked[mark.lower_end] = true;
    internal::sort<ConcurrencyTag>(m_marks.begin(), m_marks.end(), Less());
  }

  // The lowest cut that crosses the edge `h`, which points to its lower end: the one that is met first on the way
  // up. `no_node` if there is none.
  std::uint32_t leaf(std::size_t lower_end, halfedge_descriptor h) const
  {
    if (m_is_marked.empty() || !m_is_marked[lower_end])
      return no_node;
    auto mark = std::lower_bound(
        m_marks.begin(), m_marks.end(), Mark{static_cast<std::uint32_t>(lower_end), 0, h}, Less());
    for (; mark != m_marks.end() && mark->lower_end == lower_end; ++mark)
      if (mark->halfedge == h)
        return mark->leaf;
    return no_node;
  }

private:
  struct Less
  {
    // marks of one vertex and one cut may come in any order
    bool operator()(const Mark& a, const Mark& b) const
    {
      return std::tie(a.lower_end, a.leaf) < std::tie(b.lower_end, b.leaf);
    }
  };

  std::vector<Mark> m_marks;
  std::vector<bool> m_is_marked; // by the index of the lower end; empty without marks
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CUT_MARKS_H
