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
#include <CGAL/Surface_mesh_reeb_graph/internal/in_turn.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Monotone paths along the edges of the mesh, down or up to the first vertex that is given as an end, or up to a
// cut. Their ends are remembered at all vertices that they pass, so all paths together take a step per vertex
// or little more. They may be followed by several threads at once: the end of a path does not depend on who finds it.
template <class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Monotone_paths
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  using Marks = Cut_marks<TriangleMesh>;

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

  // Follows the paths from the vertices `start(i)` for begin <= i < end and calls `set_end(i, node)` with their
  // ends. Upward paths end where they cross a cut.
  template <class Start, class Set_end>
  void follow(std::size_t begin,
              std::size_t end,
              const Marks& marks,
              const Start& start,
              const Set_end& set_end)
  {
    std::vector<Path> paths((std::min)(end - begin, number_of_tasks_in_turn));
    const auto begin_path = [&](Path& path) {
      for (; begin < end; ++begin) {
        const vertex_descriptor v = start(begin);
        const std::uint32_t node = known_end(index(v));
        if (node == no_node) {
          path.number = begin++;
          path.passed.clear();
          pass(path, v);
          return true;
        }
        set_end(begin, node);
      }
      return false;
    };
    in_turn(
        paths,
        begin_path,
        [&](Path& path) {
          const std::uint32_t node = advance(path, marks);
          if (node == no_node)
            return true;
          for (const std::size_t i : path.passed)
            remember(i, node);
          set_end(path.number, node);
          return false;
        },
        [&](Path& path) {
          path.neighbor = source(path.edge, m_tmesh);
          path.next_edge = opposite(next(path.edge, m_tmesh), m_tmesh);
        },
        [&](Path& path) {
          path.is_neighbor_on_side = m_side == BELOW ? m_order(path.neighbor, path.vertex)
                                                     : m_order(path.vertex, path.neighbor);
          path.end_of_neighbor = known_end(index(path.neighbor));
        });
  }

private:
  struct Path
  {
    std::size_t number;
    vertex_descriptor vertex;
    halfedge_descriptor edge; // the next one to be looked at, points to the vertex
    // what is read before the look
    vertex_descriptor neighbor;
    halfedge_descriptor next_edge;
    bool is_neighbor_on_side;
    std::uint32_t end_of_neighbor;
    std::vector<std::size_t> passed;
  };

  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  // `no_node` if it is not known.
  std::uint32_t known_end(std::size_t i) const
  {
    return m_end[i].load(std::memory_order_relaxed) - 1;
  }

  void remember(std::size_t i, std::uint32_t node)
  {
    m_end[i].store(node + 1, std::memory_order_relaxed);
  }

  void pass(Path& path, vertex_descriptor v) const
  {
    path.vertex = v;
    path.edge = halfedge(v, m_tmesh);
    path.passed.push_back(index(v));
  }

  // Looks at one edge. Any one to a vertex on the side will do: all of them lead to the same component of the
  // sublevel (or superlevel) sets that hold the vertex too. Returns the end of the path if it is known then.
  std::uint32_t advance(Path& path, const Marks& marks) const
  {
    if (path.is_neighbor_on_side) {
      std::uint32_t node = m_side == BELOW ? no_node : marks.leaf(path.passed.back(), path.edge);
      if (node == no_node)
        node = path.end_of_neighbor;
      if (node == no_node)
        pass(path, path.neighbor);
      return node;
    }
    path.edge = path.next_edge;
    // the pass over the faces has seen an edge on this side, which is in another fan of faces
    if (path.edge == halfedge(path.vertex, m_tmesh))
      throw_several_fans();
    return no_node;
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
