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
#include <CGAL/Surface_mesh_reeb_graph/internal/Upper_level_set.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/vertex_indices.h>

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
template <class TriangleMesh, class VertexIndexMap, class EdgeIndexMap>
class Sweep
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  // `order` holds all vertices in increasing order.
  Sweep(const TriangleMesh& tmesh,
        const std::vector<vertex_descriptor>& order,
        VertexIndexMap vertex_index_map,
        EdgeIndexMap edge_index_map)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_edge_index_map(edge_index_map)
    , m_rank(index_bound(tmesh, vertex_index_map))
    , m_label(edge_index_bound(), no_arc)
    , m_upper_level_set(tmesh, has_border())
  {
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[get(vertex_index_map, order[i])] = static_cast<std::uint32_t>(i);
    m_result.arc_of_vertex.assign(m_rank.size(), no_arc);
  }

  Arc_list<vertex_descriptor> run()
  {
    for (std::size_t begin = 0; begin < m_order.size(); begin += m_stars.capacity) {
      const std::size_t size = (std::min)(m_stars.capacity, m_order.size() - begin);
      m_stars.read(m_order.data() + begin, size, m_tmesh);
      for (std::size_t i = 0; i < size; ++i)
        process(m_order[begin + i], m_stars.star(i));
    }
    if (m_number_of_star_edges != number_of_halfedges())
      throw_non_manifold();
    return std::move(m_result);
  }

private:
  std::size_t edge_index_bound() const
  {
    std::size_t bound = 0;
    for (auto e : CGAL::make_range(edges(m_tmesh)))
      bound = (std::max)(bound, static_cast<std::size_t>(get(m_edge_index_map, e)) + 1);
    if (bound >= no_arc)
      throw Reeb_graph_error("the mesh has more than 2^32 - 2 edges");
    return bound;
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

  // A circulation sees one closed fan of faces around a vertex; if there are several, the data
  // structure cannot show them all.
  [[noreturn]] static void throw_non_manifold()
  {
    throw Reeb_graph_error(
        "the mesh is not a 2-manifold: the faces around a vertex form several fans");
  }

  std::uint32_t rank(vertex_descriptor v) const { return m_rank[get(m_vertex_index_map, v)]; }

  std::uint32_t& label(halfedge_descriptor h)
  {
    return m_label[get(m_edge_index_map, edge(h, m_tmesh))];
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

  // Reads the star of v: the arcs of the components just below, and the wedges of upper edges. Two
  // consecutive upper edges lie in one wedge if a triangle joins them.
  void read_star(vertex_descriptor v, const std::vector<halfedge_descriptor>& star)
  {
    m_star.clear();
    m_arcs_below.clear();
    m_upper_level_set.clear();
    if (star.empty())
      return;

    const std::uint32_t v_rank = rank(v);
    for (halfedge_descriptor h : star)
      m_star.push_back({h, v_rank < rank(source(h, m_tmesh))});
    m_number_of_star_edges += m_star.size();

    for (std::size_t i = 0; i < m_star.size(); ++i) {
      const Star_edge& previous = m_star[i == 0 ? m_star.size() - 1 : i - 1];
      const bool begins_wedge =
          previous.is_upper != m_star[i].is_upper || is_border(previous.halfedge, m_tmesh);
      if (begins_wedge)
        m_wedge_begins.push_back(i);
    }
    // a closed fan of edges that all point to the same side is one wedge
    if (m_wedge_begins.empty())
      m_wedge_begins.push_back(0);

    for (std::size_t k = 0; k < m_wedge_begins.size(); ++k) {
      const std::size_t begin = m_wedge_begins[k];
      const std::size_t end =
          k + 1 < m_wedge_begins.size() ? m_wedge_begins[k + 1] : m_wedge_begins[0] + m_star.size();
      if (m_star[begin].is_upper)
        add_upper_wedge(begin, end);
      else
        m_arcs_below.push_back(current_arc(m_star[begin].halfedge));
    }
    m_wedge_begins.clear();

    std::sort(m_arcs_below.begin(), m_arcs_below.end());
    m_arcs_below.erase(std::unique(m_arcs_below.begin(), m_arcs_below.end()), m_arcs_below.end());
  }

  void add_upper_wedge(std::size_t begin, std::size_t end)
  {
    std::uint32_t lowest = no_node;
    const std::uint32_t wedge = m_upper_level_set.number_of_wedges();
    for (std::size_t i = begin; i < end; ++i) {
      const halfedge_descriptor h = m_star[i % m_star.size()].halfedge;
      lowest = (std::min)(lowest, rank(source(h, m_tmesh)));
      // the edge has no arc yet: until it gets one, its label tells its wedge to the walks
      label(h) = wedge;
    }
    m_upper_level_set.add_wedge(
        m_star[begin].halfedge, m_star[(end - 1) % m_star.size()].halfedge, lowest);
  }

  void process(vertex_descriptor v, const std::vector<halfedge_descriptor>& star)
  {
    read_star(v, star);

    const std::uint32_t v_rank = rank(v);
    auto is_above = [&](vertex_descriptor u) { return v_rank < rank(u); };
    auto wedge_of = [&](halfedge_descriptor h) {
      if (label(h) == no_arc)
        throw_non_manifold();
      return label(h);
    };
    m_upper_level_set.find_components(v, is_above, wedge_of);

    const std::size_t up = m_upper_level_set.number_of_components();
    if (m_arcs_below.size() == 1 && up == 1)
      continue_arc(v);
    else
      make_node(v, is_above);
  }

  void continue_arc(vertex_descriptor v)
  {
    const std::uint32_t arc = m_arcs_below.front();
    m_result.arc_of_vertex[get(m_vertex_index_map, v)] = arc;
    for (const Star_edge& e : m_star)
      if (e.is_upper)
        label(e.halfedge) = arc;
  }

  template <class IsAbove>
  void make_node(vertex_descriptor v, const IsAbove& is_above)
  {
    const std::uint32_t node = static_cast<std::uint32_t>(m_result.nodes.size());
    m_result.nodes.push_back(v);
    for (std::uint32_t arc : m_arcs_below)
      m_result.arcs[arc].upper = node;

    // the wedges of the star's edges are read off before the walks write over them
    m_wedge_of_star_edge.clear();
    for (const Star_edge& e : m_star)
      m_wedge_of_star_edge.push_back(e.is_upper ? label(e.halfedge) : 0);

    std::uint32_t first_arc = m_arcs_below.empty() ? no_arc : m_arcs_below.front();
    const std::size_t up = m_upper_level_set.number_of_components();
    m_arcs_above.resize(up);
    for (std::size_t i = 0; i < up; ++i) {
      const std::uint32_t arc = begin_arc(node);
      m_arcs_above[i] = arc;
      if (i == 0)
        first_arc = arc;
      if (m_upper_level_set.is_longest(i)) {
        for (std::uint32_t below : m_arcs_below)
          m_arc_sets.join(below, arc);
      } else {
        m_upper_level_set.for_each_edge(
            i, v, is_above, [&](halfedge_descriptor h) { label(h) = arc; });
      }
    }
    for (std::size_t i = 0; i < m_star.size(); ++i)
      if (m_star[i].is_upper)
        label(m_star[i].halfedge) =
            m_arcs_above[m_upper_level_set.component_of_wedge(m_wedge_of_star_edge[i])];

    m_result.arc_of_vertex[get(m_vertex_index_map, v)] = first_arc;
  }

  struct Star_edge
  {
    halfedge_descriptor halfedge;
    bool is_upper;
  };

  const TriangleMesh& m_tmesh;
  const std::vector<vertex_descriptor>& m_order;
  VertexIndexMap m_vertex_index_map;
  EdgeIndexMap m_edge_index_map;
  std::vector<std::uint32_t> m_rank;  // by vertex index
  std::vector<std::uint32_t> m_label; // by edge index, valid for crossed edges
  Number_sets m_arc_sets; // arcs that have ended, with the arc that has their labels now
  Arc_list<vertex_descriptor> m_result;
  std::size_t m_number_of_star_edges = 0;

  Star_block<TriangleMesh> m_stars;
  // The star of the current vertex; members, so that no vertex allocates.
  std::vector<Star_edge> m_star;
  std::vector<std::size_t> m_wedge_begins;
  std::vector<std::uint32_t> m_wedge_of_star_edge;
  std::vector<std::uint32_t> m_arcs_below;
  std::vector<std::uint32_t> m_arcs_above;
  Upper_level_set<TriangleMesh> m_upper_level_set;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SWEEP_H
