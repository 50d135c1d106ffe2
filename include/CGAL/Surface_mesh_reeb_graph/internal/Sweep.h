// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SWEEP_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SWEEP_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Number_sets.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Star_block.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Computes the Reeb graph by a sweep through the vertices in increasing order (after Parsa, "A
// deterministic O(m log m) time algorithm for the Reeb graph", 2013, with walks along the level set in
// the place of dynamic trees).
//
// Every crossed edge carries the number of the arc to which its component of the level set belonged
// when the label was given. When an arc ends at a node, a union-find structure hands its labels on to
// an arc that begins there: only the edges of the shorter components get new labels.
template <class TriangleMesh, class VertexIndexMap, class HalfedgeIndexMap>
class Sweep
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  using Star = Vertex_star<TriangleMesh>;

public:
  // `order` holds all vertices in increasing order.
  Sweep(const TriangleMesh& tmesh,
        const std::vector<vertex_descriptor>& order,
        VertexIndexMap vertex_index_map,
        HalfedgeIndexMap halfedge_index_map)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_halfedge_index_map(halfedge_index_map)
    , m_rank(index_bound(tmesh, vertex_index_map))
    , m_are_halfedges_paired(are_halfedges_paired())
    , m_label(m_are_halfedges_paired ? (halfedge_index_bound() + 1) / 2 : halfedge_index_bound(),
              no_arc)
    , m_stars(tmesh, has_border())
  {
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[get(vertex_index_map, order[i])] = static_cast<std::uint32_t>(i);
    m_result.arc_of_vertex.assign(m_rank.size(), no_arc);
  }

  Arc_list<vertex_descriptor> run()
  {
    for (std::size_t begin = 0; begin < m_order.size(); begin += m_stars.capacity) {
      const std::size_t size = (std::min)(m_stars.capacity, m_order.size() - begin);
      m_stars.read(m_order.data() + begin, size);
      m_stars.find_upper_components(*this);
      for (std::size_t i = 0; i < size; ++i) {
        m_number_of_star_edges += m_stars[i].halfedges.size();
        process(m_stars[i]);
      }
    }
    if (m_number_of_star_edges != number_of_halfedges())
      throw_non_manifold();
    return std::move(m_result);
  }

  // What the block of stars asks: the position of a vertex in the order, ...
  std::uint32_t rank(vertex_descriptor v) const { return m_rank[get(m_vertex_index_map, v)]; }

  // ... and the wedge of an upper edge of a vertex of the block. The edge belongs to no arc yet: until
  // the vertex is processed, its label is the number of its wedge.
  void set_wedge(halfedge_descriptor h, std::uint32_t wedge) { label(h) = wedge; }
  std::uint32_t wedge(halfedge_descriptor h) { return label(h); }

  // Whether two lower edges of a vertex of the block belong to different components, as far as the labels
  // tell by now: those of edges from other vertices of the block are not known yet.
  bool seem_apart(halfedge_descriptor h, halfedge_descriptor g)
  {
    const std::size_t arcs = m_result.arcs.size();
    return label(h) < arcs && label(g) < arcs &&
           m_arc_sets.root(label(h)) != m_arc_sets.root(label(g));
  }

  // A circulation sees one closed fan of faces around a vertex; if there are several, the data
  // structure cannot show them all, and an edge of a vertex may be met that is not in its star.
  [[noreturn]] static void throw_non_manifold()
  {
    throw Reeb_graph_error(
        "the mesh is not a 2-manifold: the faces around a vertex form several fans");
  }

private:
  std::size_t halfedge_index(halfedge_descriptor h) const
  {
    return static_cast<std::size_t>(get(m_halfedge_index_map, h));
  }

  std::size_t halfedge_index_bound() const
  {
    std::size_t bound = 0;
    for (halfedge_descriptor h : CGAL::make_range(halfedges(m_tmesh)))
      bound = (std::max)(bound, halfedge_index(h) + 1);
    if (bound >= no_arc)
      throw Reeb_graph_error("the mesh has more than 2^32 - 2 halfedges");
    return bound;
  }

  // Whether the halfedges of every edge have the numbers 2 i and 2 i + 1, as they usually do.
  bool are_halfedges_paired() const
  {
    for (auto e : CGAL::make_range(edges(m_tmesh))) {
      const halfedge_descriptor h = halfedge(e, m_tmesh);
      if (halfedge_index(h) / 2 != halfedge_index(opposite(h, m_tmesh)) / 2)
        return false;
    }
    return true;
  }

  bool has_border() const
  {
    for (auto h : CGAL::make_range(halfedges(m_tmesh)))
      if (is_border(h, m_tmesh))
        return true;
    return false;
  }

  std::size_t number_of_halfedges() const
  {
    const auto range = halfedges(m_tmesh);
    return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  }

  auto is_above(vertex_descriptor v) const
  {
    return [this, level = rank(v)](vertex_descriptor u) { return level < rank(u); };
  }

  std::uint32_t& label(halfedge_descriptor h)
  {
    const std::size_t i = halfedge_index(h);
    return m_label[m_are_halfedges_paired ? i / 2
                                          : (std::min)(i, halfedge_index(opposite(h, m_tmesh)))];
  }

  // The arc that the component of a crossed edge belongs to now.
  std::uint32_t current_arc(halfedge_descriptor h)
  {
    if (label(h) == no_arc)
      throw_non_manifold();
    return label(h) = m_arc_sets.root(label(h));
  }

  std::uint32_t begin_arc(std::uint32_t lower_node)
  {
    const std::uint32_t arc = static_cast<std::uint32_t>(m_result.arcs.size());
    m_result.arcs.push_back({lower_node, no_node});
    m_arc_sets.add();
    return arc;
  }

  void process(Star& star)
  {
    m_arcs_below.clear();
    for (halfedge_descriptor h : star.lower_wedges)
      m_arcs_below.push_back(current_arc(h));
    std::sort(m_arcs_below.begin(), m_arcs_below.end());
    m_arcs_below.erase(std::unique(m_arcs_below.begin(), m_arcs_below.end()), m_arcs_below.end());

    if (star.may_merge)
      m_stars.find_upper_components(star, m_arcs_below.size() == 2, *this);
    if (m_arcs_below.size() == 1 && star.above.number_of_components() == 1)
      continue_arc(star);
    else
      make_node(star);
  }

  void continue_arc(const Star& star)
  {
    const std::uint32_t arc = m_arcs_below.front();
    m_result.arc_of_vertex[get(m_vertex_index_map, star.vertex)] = arc;
    for (halfedge_descriptor h : star.upper_edges)
      label(h) = arc;
  }

  void make_node(Star& star)
  {
    const std::uint32_t node = static_cast<std::uint32_t>(m_result.nodes.size());
    m_result.nodes.push_back(star.vertex);
    for (std::uint32_t arc : m_arcs_below)
      m_result.arcs[arc].upper = node;

    std::uint32_t first_arc = m_arcs_below.empty() ? no_arc : m_arcs_below.front();
    m_arcs_above.clear();
    for (std::size_t i = 0; i < star.above.number_of_components(); ++i) {
      const std::uint32_t arc = begin_arc(node);
      m_arcs_above.push_back(arc);
      if (i == 0)
        first_arc = arc;
      if (star.above.is_longest(i)) {
        for (std::uint32_t below : m_arcs_below)
          m_arc_sets.join(below, arc);
      } else {
        star.above.for_each_edge(
            i, star.vertex, is_above(star.vertex), [&](halfedge_descriptor h) { label(h) = arc; });
      }
    }
    // the labels of the upper edges are still the numbers of their wedges
    for (halfedge_descriptor h : star.upper_edges)
      label(h) = m_arcs_above[star.above.component_of_wedge(label(h))];

    m_result.arc_of_vertex[get(m_vertex_index_map, star.vertex)] = first_arc;
  }

  const TriangleMesh& m_tmesh;
  const std::vector<vertex_descriptor>& m_order;
  VertexIndexMap m_vertex_index_map;
  HalfedgeIndexMap m_halfedge_index_map;
  std::vector<std::uint32_t> m_rank; // by vertex index
  bool m_are_halfedges_paired;
  std::vector<std::uint32_t> m_label; // of the edges, by the indices of their halfedges
  Number_sets m_arc_sets; // arcs that have ended, with the arc that has their labels now
  Arc_list<vertex_descriptor> m_result;
  std::size_t m_number_of_star_edges = 0;

  Star_block<TriangleMesh> m_stars;
  // Members, so that no vertex allocates.
  std::vector<std::uint32_t> m_arcs_below;
  std::vector<std::uint32_t> m_arcs_above;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SWEEP_H
