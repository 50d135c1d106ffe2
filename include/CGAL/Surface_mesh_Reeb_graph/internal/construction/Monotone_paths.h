// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MONOTONE_PATHS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MONOTONE_PATHS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/interleaved_tasks.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Monotone paths along the edges of the mesh, down or up to the first vertex that is given as a
// node, or up to a cut. Every vertex that a path passes is marked with it, and paths that come
// later end in it there, so all paths together take a step per vertex or little more. Cuts may be
// made when paths are known, and hold for later ones, too. Paths may be followed by several threads at once: where a path
// leads does not depend on who passes first.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Monotone_paths
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  // The place of a cut on a path: above the vertex `below`, where ways up end in the node `leaf`
  // then. Or on the way out of a vertex that no path has passed, for those that come later.
  struct Cut
  {
    std::uint32_t path; // no_path for later ones
    std::uint32_t leaf; // higher cuts have larger numbers
    vertex_descriptor below;
  };

  Monotone_paths(Side side,
                 const TriangleMesh& tmesh,
                 const VertexOrder& order,
                 VertexIndexMap vertex_index_map,
                 std::size_t index_bound)
    : m_side(side)
    , m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_way(index_bound)
  {}

  // Paths that reach `v` end there, at the node `node`. To be called for all nodes, numbered from 0
  // on, before there is any path.
  void set_node(vertex_descriptor v, std::uint32_t node)
  {
    CGAL_precondition(m_paths.empty());
    m_number_of_nodes = (std::max)(m_number_of_nodes, node + 1);
    m_way[index(v)].store(node + 1, std::memory_order_relaxed);
  }

  // Follows the paths from some vertices. Their numbers come after those of the paths that were
  // followed before.
  void follow(const std::vector<vertex_descriptor>& starts)
  {
    const std::size_t first = m_paths.size();
    m_paths.resize(first + starts.size());
    for_each_range<ConcurrencyTag>(starts.size(), [&](std::size_t begin, std::size_t end) {
      follow_range(first, begin, end, starts);
    });
    m_tails.clear();
    if (!m_later_cuts.empty())
      find_paths_of_cuts();
  }

  // The node at which a path ends from its start on, and from a vertex on that a path has passed
  // (or that is a node).
  std::uint32_t end(std::uint32_t path)
  {
    const auto cut = first_cut(path);
    return is_on(cut, path) ? cut->leaf : tail(path);
  }
  std::uint32_t end_from(vertex_descriptor v) { return end_from(way(index(v)), v); }

  // The node at a vertex, or the path that has passed it, if there is any.
  std::uint32_t node_at(vertex_descriptor v) const
  {
    const std::uint32_t w = way(index(v));
    return is_node(w) ? w : no_node;
  }
  std::uint32_t path_through(vertex_descriptor v) const
  {
    const std::uint32_t w = way(index(v));
    return w == no_way || is_node(w) ? no_path : w - m_number_of_nodes;
  }

  // The edge through which paths that pass a vertex go on, as a halfedge that points to the vertex.
  // That must be no node.
  halfedge_descriptor way_out(vertex_descriptor v) const
  {
    CGAL_precondition(node_at(v) == no_node);
    halfedge_descriptor h = halfedge(v, m_tmesh);
    while (!is_on_side(source(h, m_tmesh), v))
      h = next_edge(h);
    return h;
  }

  // Cuts the paths, which lead up.
  void set_cuts(std::vector<Cut>&& cuts)
  {
    CGAL_precondition(m_side == ABOVE);
    m_later_cuts = std::move(cuts);
    find_paths_of_cuts();
  }

  // Finds all ends, so that those that are asked for afterwards are only looked up: by several
  // threads, say.
  void find_ends()
  {
    for (std::uint32_t path = 0; path < m_paths.size(); ++path)
      tail(path);
  }

  static constexpr std::uint32_t no_path = static_cast<std::uint32_t>(-1);

private:
  // What is behind a vertex: a node, or a path, whose numbers follow those of the nodes.
  static constexpr std::uint32_t no_way = static_cast<std::uint32_t>(-1);

  // What a path leads to in the end, and the vertex at which it gets there.
  struct Path
  {
    std::uint32_t way;
    vertex_descriptor join;
  };

  // A path while it is followed.
  struct Walker
  {
    std::size_t path;
    vertex_descriptor vertex;
    halfedge_descriptor edge; // the next one to be looked at, points to the vertex
    // what is read before the look
    vertex_descriptor neighbor;
    halfedge_descriptor next_edge;
    bool is_neighbor_on_side;
    std::uint32_t way_of_neighbor;
  };

  using Cut_iterator = typename std::vector<Cut>::const_iterator;

  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  bool is_on_side(vertex_descriptor u, vertex_descriptor v) const
  {
    return m_side == BELOW ? m_order(u, v) : m_order(v, u);
  }

  // The next edge around a vertex. Ways up and down turn in different directions: as meshes are
  // made, the first edges of a vertex often lead to one side, and the last ones to the other.
  halfedge_descriptor next_edge(halfedge_descriptor h) const
  {
    return m_side == BELOW ? prev(opposite(h, m_tmesh), m_tmesh)
                           : opposite(next(h, m_tmesh), m_tmesh);
  }

  bool is_node(std::uint32_t way) const { return way < m_number_of_nodes; }

  std::uint32_t way(std::size_t i) const { return m_way[i].load(std::memory_order_relaxed) - 1; }

  // ---- following

  void follow_range(std::size_t first,
                    std::size_t begin,
                    std::size_t end,
                    const std::vector<vertex_descriptor>& starts)
  {
    // a path looks at no edge twice, and no other one at the edges of the same vertex
    const std::size_t most_looks = num_halfedges(m_tmesh);
    std::size_t number_of_looks = 0;
    std::vector<Walker> walkers((std::min)(end - begin, number_of_interleaved_tasks));
    run_interleaved(
        walkers,
        [&](Walker& walker) {
          while (begin < end) {
            const std::size_t i = begin++;
            walker.path = first + i;
            if (pass(walker, starts[i], way(index(starts[i]))))
              return true;
          }
          return false;
        },
        [&](Walker& walker) {
          if (++number_of_looks > most_looks)
            throw_internal_error("a monotone path does not end");
          return advance(walker);
        },
        [&](Walker& walker) {
          walker.neighbor = source(walker.edge, m_tmesh);
          walker.next_edge = next_edge(walker.edge);
        },
        [&](Walker& walker) {
          walker.is_neighbor_on_side = is_on_side(walker.neighbor, walker.vertex);
          walker.way_of_neighbor = way(index(walker.neighbor));
        });
  }

  // Looks at one edge. Any one to a vertex on the side will do: all of them lead to the same
  // component of the sublevel (or superlevel) sets that hold the vertex too. Returns false if the
  // path is over.
  bool advance(Walker& walker)
  {
    if (walker.is_neighbor_on_side)
      return pass(walker, walker.neighbor, walker.way_of_neighbor);
    walker.edge = walker.next_edge;
    // the pass over the faces has seen an edge on this side
    if (walker.edge == halfedge(walker.vertex, m_tmesh))
      throw_internal_error("a monotone path ends at a vertex that is no node");
    return true;
  }

  // Marks the vertex `v`, unless `way_of_v` or another path is there already: then the path is
  // over.
  bool pass(Walker& walker, vertex_descriptor v, std::uint32_t way_of_v)
  {
    if (way_of_v == no_way)
      way_of_v = mark(index(v), static_cast<std::uint32_t>(m_number_of_nodes + walker.path));
    if (way_of_v != no_way) {
      m_paths[walker.path] = {way_of_v, v};
      return false;
    }
    walker.vertex = v;
    walker.edge = halfedge(v, m_tmesh);
    return true;
  }

  // Returns the mark of somebody else, if there is one.
  std::uint32_t mark(std::size_t i, std::uint32_t own)
  {
    std::uint32_t other = 0;
    if constexpr (is_parallel<ConcurrencyTag>) {
      m_way[i].compare_exchange_strong(other, own + 1, std::memory_order_relaxed);
    } else { // much faster
      other = m_way[i].load(std::memory_order_relaxed);
      if (other == 0)
        m_way[i].store(own + 1, std::memory_order_relaxed);
    }
    return other - 1;
  }

  // ---- cuts

  void find_paths_of_cuts()
  {
    for (Cut& cut : m_later_cuts)
      if (cut.path == no_path)
        cut.path = path_through(cut.below);
    const auto found = std::partition(m_later_cuts.begin(), m_later_cuts.end(), [](const Cut& cut) {
      return cut.path == no_path;
    });
    m_cuts.insert(m_cuts.end(), found, m_later_cuts.end());
    m_later_cuts.erase(found, m_later_cuts.end());
    CGAL_assertion_code(for (const Cut& cut
                             : m_cuts))
        CGAL_assertion(cut.path < m_paths.size() && cut.leaf >= m_number_of_nodes);
    std::sort(m_cuts.begin(), m_cuts.end(), [this](const Cut& a, const Cut& b) {
      if (a.path != b.path)
        return a.path < b.path;
      return a.below != b.below ? m_order(a.below, b.below) : a.leaf < b.leaf;
    });
    m_tails.clear();
  }

  // ---- ends

  bool is_on(Cut_iterator cut, std::uint32_t path) const
  {
    return cut != m_cuts.end() && cut->path == path;
  }

  Cut_iterator first_cut(std::uint32_t path) const
  {
    return std::partition_point(
        m_cuts.begin(), m_cuts.end(), [&](const Cut& cut) { return cut.path < path; });
  }

  // The lowest cut on a path that is not below the vertex `v` of the path.
  Cut_iterator first_cut_from(std::uint32_t path, vertex_descriptor v) const
  {
    return std::partition_point(m_cuts.begin(), m_cuts.end(), [&](const Cut& cut) {
      return cut.path < path || (cut.path == path && m_order(cut.below, v));
    });
  }

  std::uint32_t end_from(std::uint32_t way, vertex_descriptor v)
  {
    CGAL_precondition(way != no_way);
    if (is_node(way))
      return way;
    const std::uint32_t path = way - m_number_of_nodes;
    const auto cut = first_cut_from(path, v);
    return is_on(cut, path) ? cut->leaf : tail(path);
  }

  // The end of a path without its own cuts.
  std::uint32_t tail(std::uint32_t path)
  {
    if (m_tails.empty())
      m_tails.resize(m_paths.size(), no_node);
    if (m_tails[path] != no_node)
      return m_tails[path];
    // all paths on the way to one whose tail is known, or that ends in a node or a cut
    m_waiting.clear();
    std::uint32_t end = no_node;
    while (end == no_node) {
      m_waiting.push_back(path);
      const Path& last = m_paths[path];
      if (is_node(last.way)) {
        end = last.way;
      } else {
        path = last.way - m_number_of_nodes;
        const auto cut = first_cut_from(path, last.join);
        end = is_on(cut, path) ? cut->leaf : m_tails[path];
      }
    }
    for (const std::uint32_t p : m_waiting)
      m_tails[p] = end;
    return end;
  }

  const Side m_side;
  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  std::uint32_t m_number_of_nodes = 0;
  std::vector<std::atomic<std::uint32_t>> m_way; // plus 1, by vertex index; 0 if there is none
  std::vector<Path> m_paths;
  std::vector<Cut> m_cuts;       // by path, from below
  std::vector<Cut> m_later_cuts; // of no path, so far
  std::vector<std::uint32_t> m_tails, m_waiting;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MONOTONE_PATHS_H
