// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_STAR_BLOCK_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_STAR_BLOCK_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Upper_level_set.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// What the order of the vertices alone says of a vertex. Its lower and its upper edges form wedges:
// runs of edges each of which is joined to the next one by a triangle.
template <class TriangleMesh>
struct Vertex_star
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  Vertex_star(const TriangleMesh& tmesh, bool has_border) : above(tmesh, has_border) {}

  vertex_descriptor vertex;
  std::vector<halfedge_descriptor> halfedges;    // that point to the vertex, in cyclic order
  std::vector<halfedge_descriptor> upper_edges;  // those from higher vertices
  std::vector<halfedge_descriptor> lower_wedges; // one from every wedge of lower edges
  Upper_level_set<TriangleMesh> above;
  bool may_merge = false; // the components of `above` have not been looked for, see Star_block
};

// The stars of several vertices that follow each other in the order. In memory such vertices lie far
// apart, and every step around one of them, or along its level set, waits for the memory. So the work on
// a block goes on in turn: while one vertex waits, the others do too.
template <class TriangleMesh>
class Star_block
{
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename Star::vertex_descriptor;
  using halfedge_descriptor = typename Star::halfedge_descriptor;

public:
  static constexpr std::size_t capacity = 16;

  Star_block(const TriangleMesh& tmesh, bool has_border)
    : m_tmesh(tmesh), m_has_border(has_border), m_stars(capacity, Star(tmesh, has_border))
  {}

  Star& operator[](std::size_t i) { return m_stars[i]; }

  // Reads the halfedges around `size` vertices, at most `capacity`.
  void read(const vertex_descriptor* vertices, std::size_t size)
  {
    m_size = size;
    m_active.clear();
    for (std::size_t i = 0; i < size; ++i) {
      m_stars[i].vertex = vertices[i];
      m_stars[i].halfedges.clear();
      if (!has_no_edge(vertices[i], m_tmesh)) {
        m_stars[i].halfedges.push_back(halfedge(vertices[i], m_tmesh));
        m_active.push_back(i);
      }
    }
    in_turn([this](Star& star) {
      const halfedge_descriptor h = opposite(next(star.halfedges.back(), m_tmesh), m_tmesh);
      if (h == star.halfedges.front())
        return false;
      star.halfedges.push_back(h);
      return true;
    });
  }

  // Finds the wedges of the vertices, and the components of the level sets just above them. `context` gives
  // the ranks of vertices and remembers the wedges of upper edges.
  //
  // Two closed components that meet at a simple saddle merge into one: there is nothing to walk. Whether
  // they are two is known only when the vertex has its turn in the sweep; where it seems so, the vertex
  // may merge and waits.
  template <class Context>
  void find_upper_components(Context& context)
  {
    m_active.clear();
    for (std::size_t i = 0; i < m_size; ++i) {
      Star& star = m_stars[i];
      find_wedges(star, context);
      star.may_merge = !m_has_border && star.lower_wedges.size() == 2 &&
                       star.above.number_of_wedges() == 2 &&
                       context.seem_apart(star.lower_wedges[0], star.lower_wedges[1]);
      star.above.begin_walks();
      if (!star.may_merge && star.above.is_walking())
        m_active.push_back(i);
    }
    in_turn([&](Star& star) {
      advance(star, context);
      return star.above.is_walking();
    });
    for (std::size_t i = 0; i < m_size; ++i)
      if (!m_stars[i].may_merge)
        m_stars[i].above.end_walks();
  }

  // What has been left out for a vertex that may merge.
  template <class Context>
  static void find_upper_components(Star& star, bool merges, Context& context)
  {
    if (merges)
      star.above.join_all_wedges();
    while (star.above.is_walking())
      advance(star, context);
    star.above.end_walks();
  }

private:
  template <class Context>
  static void advance(Star& star, Context& context)
  {
    const std::uint32_t level = context.rank(star.vertex);
    star.above.advance_walks(
        star.vertex,
        [&](vertex_descriptor u) { return level < context.rank(u); },
        [&](halfedge_descriptor h) {
          const std::uint32_t wedge = context.wedge(h);
          if (wedge >= star.above.number_of_wedges())
            context.throw_non_manifold();
          return wedge;
        });
  }

  // Calls `step` for every active star in turn until it returns false for it.
  template <class Step>
  void in_turn(const Step& step)
  {
    while (!m_active.empty()) {
      for (std::size_t k = 0; k < m_active.size();) {
        if (step(m_stars[m_active[k]])) {
          ++k;
        } else {
          m_active[k] = m_active.back();
          m_active.pop_back();
        }
      }
    }
  }

  template <class Context>
  void find_wedges(Star& star, Context& context)
  {
    star.upper_edges.clear();
    star.lower_wedges.clear();
    star.above.clear();
    const std::size_t size = star.halfedges.size();
    if (size == 0)
      return;

    m_ranks.clear();
    for (halfedge_descriptor h : star.halfedges)
      m_ranks.push_back(context.rank(source(h, m_tmesh)));
    const std::uint32_t level = context.rank(star.vertex);
    const auto begins_wedge = [&](std::size_t i) {
      const std::size_t previous = i == 0 ? size - 1 : i - 1;
      return (level < m_ranks[previous]) != (level < m_ranks[i]) ||
             is_border(star.halfedges[previous], m_tmesh);
    };
    // a closed fan of edges that all point to the same side is one wedge, wherever it begins
    std::size_t begin = 0;
    while (begin < size && !begins_wedge(begin))
      ++begin;
    if (begin == size)
      begin = 0;

    for (std::size_t done = 0; done < size;) {
      const std::size_t first = (begin + done) % size;
      std::size_t last = first;
      std::uint32_t lowest = m_ranks[first];
      for (++done; done < size && !begins_wedge((begin + done) % size); ++done) {
        last = (begin + done) % size;
        lowest = (std::min)(lowest, m_ranks[last]);
      }
      if (m_ranks[first] < level) {
        star.lower_wedges.push_back(star.halfedges[first]);
      } else {
        const std::uint32_t wedge = star.above.number_of_wedges();
        star.above.add_wedge(star.halfedges[first], star.halfedges[last], lowest);
        for (std::size_t i = first;; i = (i + 1) % size) {
          star.upper_edges.push_back(star.halfedges[i]);
          context.set_wedge(star.halfedges[i], wedge);
          if (i == last)
            break;
        }
      }
    }
  }

  const TriangleMesh& m_tmesh;
  bool m_has_border;
  std::vector<Star> m_stars;
  std::size_t m_size = 0;
  std::vector<std::size_t> m_active;
  std::vector<std::uint32_t> m_ranks; // of the neighbors, in the order of the halfedges
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_STAR_BLOCK_H
