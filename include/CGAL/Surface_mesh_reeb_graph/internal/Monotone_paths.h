// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Cut_marks.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Extremum_pairs.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Monotone paths along the edges of the mesh, down to minima or up to maxima and cuts. Their ends are
// remembered at all vertices that they pass, so all paths together take a step per vertex at most. They
// may be followed by several threads at once: the end of a path does not depend on who finds it.
template <class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Monotone_paths
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  Monotone_paths(Side side,
                 const TriangleMesh& tmesh,
                 const VertexOrder& order,
                 VertexIndexMap vertex_index_map,
                 std::size_t index_bound)
    : m_side(side)
    , m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_end(index_bound)
  {}

  // Paths that reach `v` end there, at the node `node`.
  void set_end(vertex_descriptor v, std::uint32_t node) { remember(index(v), node); }

  void forget()
  {
    for (std::atomic<std::uint32_t>& end : m_end)
      end.store(0, std::memory_order_relaxed);
  }

  std::uint32_t known_end(std::size_t vertex_index) const
  {
    return m_end[vertex_index].load(std::memory_order_relaxed) - 1; // no_node if it is not known
  }

  // The end of a path that begins at `v`. Upward paths end where they cross a cut. `passed` is memory to be used
  // again.
  std::uint32_t
  end(vertex_descriptor v, const Cut_marks<TriangleMesh>& marks, std::vector<std::size_t>& passed)
  {
    std::size_t i = index(v);
    std::uint32_t result = known_end(i);
    if (result != no_node)
      return result;
    passed.clear();
    while (result == no_node) {
      passed.push_back(i);
      const halfedge_descriptor h = next_edge(v);
      result = marks.leaf(i, h);
      if (result == no_node) {
        v = source(h, m_tmesh);
        i = index(v);
        result = known_end(i);
      }
    }
    for (const std::size_t j : passed)
      remember(j, result);
    return result;
  }

private:
  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  void remember(std::size_t i, std::uint32_t node)
  {
    m_end[i].store(node + 1, std::memory_order_relaxed);
  }

  // Any edge to a vertex on the side will do: all of them lead to the same component of the sublevel (or
  // superlevel) sets that hold `v` too.
  halfedge_descriptor next_edge(vertex_descriptor v) const
  {
    for (const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_tmesh)) {
      const vertex_descriptor u = source(h, m_tmesh);
      if (m_side == BELOW ? m_order(u, v) : m_order(v, u))
        return h;
    }
    // the passes over the faces have seen one, which is in another fan of faces
    throw_several_fans();
  }

  const Side m_side;
  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  std::vector<std::atomic<std::uint32_t>> m_end; // plus 1, by vertex index; 0 if it is not known
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H
