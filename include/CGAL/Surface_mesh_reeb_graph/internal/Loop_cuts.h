// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CUTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CUTS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Critical_nodes.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Cut_marks.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Level_set_walk.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Lockstep_walks.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Merge_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Number_sets.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Vertex_star.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Cuts the surface along components of level sets such that its Reeb graph loses all loops and keeps
// everything else: just below a node every component of the sublevel set keeps one of the components of the level
// set that lead from it to the node, and is cut along the others. A cut ends the surface below in a leaf, a
// node that lies between its saddle and all that is lower.
template <class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Loop_cuts
{
  using Nodes = Critical_nodes<TriangleMesh, VertexOrder, VertexIndexMap>;
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;
  using halfedge_descriptor = typename Nodes::halfedge_descriptor;
  using Walk = Level_set_walk<TriangleMesh>;

public:
  Loop_cuts(const TriangleMesh& tmesh,
            const VertexOrder& order,
            VertexIndexMap vertex_index_map,
            const Nodes& nodes,
            bool has_border,
            std::size_t budget)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_nodes(nodes)
    , m_budget(budget)
    , m_walks(tmesh, has_border)
  {}

  // Makes the forest of sublevel sets, with the leaves of the cuts. `may_have_loops(node)` tells for which
  // nodes the level set must be looked at. Returns false if that takes more steps than the budget allows.
  template <class MayHaveLoops>
  bool run(const MayHaveLoops& may_have_loops, Merge_forest& forest)
  {
    forest.clear(m_nodes.size());
    m_components = Number_sets(m_nodes.size());
    sequence.reserve(m_nodes.size());
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) {
      if (may_have_loops(node) &&
          !(m_nodes.is_unfolded(node) ? cut_below_simple_saddle(node, forest)
                                      : cut_below(node, forest)))
        return false;
      for (std::uint32_t w = m_nodes.lower_begin[node]; w < m_nodes.lower_begin[node + 1]; ++w)
        attach(m_components.root(m_nodes.lower_end[w]), node, forest);
      sequence.push_back(node);
    }
    return true;
  }

  bool is_leaf(std::uint32_t node) const { return node >= m_nodes.size(); }
  std::uint32_t saddle_of_leaf(std::uint32_t leaf) const { return saddles[leaf - m_nodes.size()]; }

  Cut_marks<TriangleMesh> marks;
  std::vector<std::uint32_t> sequence; // of all nodes, the leaves included
  std::vector<std::uint32_t> saddles;  // of the leaves, whose numbers follow those of the nodes

private:
  void attach(std::uint32_t component, std::uint32_t node, Merge_forest& forest)
  {
    if (component == node)
      return;
    forest.attach(component, node);
    m_components.join(component, node);
  }

  // `end` is the end of a path into the component of the level set that is cut.
  std::uint32_t add_leaf(std::uint32_t node, std::uint32_t end, Merge_forest& forest)
  {
    const std::uint32_t leaf = static_cast<std::uint32_t>(m_nodes.size() + saddles.size());
    saddles.push_back(node);
    forest.resize(m_nodes.size() + saddles.size());
    m_components.add();
    attach(m_components.root(end), leaf, forest);
    sequence.push_back(leaf);
    return leaf;
  }

  void mark(halfedge_descriptor h, std::uint32_t leaf)
  {
    if (m_order(source(h, m_tmesh), target(h, m_tmesh)))
      h = opposite(h, m_tmesh);
    marks.add(static_cast<std::size_t>(get(m_vertex_index_map, target(h, m_tmesh))), h, leaf);
  }

  void mark_wedge(const typename Star::Wedge& wedge, std::uint32_t leaf)
  {
    for (std::size_t i = wedge.begin; i < wedge.end; ++i)
      mark(m_star.halfedges[i], leaf);
  }

  auto is_below(vertex_descriptor v) const
  {
    return [this, v](vertex_descriptor u) { return m_order(u, v); };
  }

  void read_star(vertex_descriptor v)
  {
    m_star.read(v, m_tmesh);
    m_star.find_wedges(m_tmesh,
                       [&](halfedge_descriptor h) { return m_order(v, source(h, m_tmesh)); });
  }

  bool cut_below(std::uint32_t node, Merge_forest& forest)
  {
    const vertex_descriptor v = m_nodes.vertex[node];
    read_star(v);
    m_walks.clear();
    m_lower_wedges.clear();
    for (const auto& wedge : m_star.wedges) {
      if (wedge.is_upper)
        continue;
      m_walks.add_wedge(m_star.halfedges[wedge.begin], m_star.halfedges[wedge.end - 1]);
      m_lower_wedges.push_back(wedge);
    }
    if (!m_walks.run(v, is_below(v), m_budget))
      return false;

    // for every component of the level set the one of the sublevel set, found before there are leaves
    struct Component
    {
      std::uint32_t sublevel, walked_last, level, end;
    };
    std::vector<Component> components;
    for (std::uint32_t w = 0; w < m_walks.number_of_wedges(); ++w) {
      if (m_walks.component(w) != w)
        continue;
      const std::uint32_t end = m_nodes.lower_end[m_nodes.lower_begin[node] + w];
      components.push_back({m_components.root(end), m_walks.is_longest(w) ? 0u : 1u, w, end});
    }
    // one of the components of every sublevel set is kept: the longest one, or any other
    std::sort(components.begin(), components.end(), [](const Component& a, const Component& b) {
      return std::tie(a.sublevel, a.walked_last, a.level) <
             std::tie(b.sublevel, b.walked_last, b.level);
    });
    for (std::size_t i = 1; i < components.size(); ++i) {
      if (components[i].sublevel != components[i - 1].sublevel)
        continue;
      const std::uint32_t leaf = add_leaf(node, components[i].end, forest);
      m_walks.for_each_edge(
          components[i].level, v, is_below(v), [&](halfedge_descriptor h) { mark(h, leaf); });
      for (std::uint32_t w = 0; w < m_lower_wedges.size(); ++w)
        if (m_walks.component(w) == components[i].level)
          mark_wedge(m_lower_wedges[w], leaf);
    }
    return true;
  }

  // Below saddle i of those that a vertex is unfolded into, the level set has the strand that passes by the
  // saddles before and the strand of the wedge L(i + 1). If they belong to different components, which the same
  // component of the sublevel set leads to, the one of L(i + 1) is cut.
  bool cut_below_simple_saddle(std::uint32_t node, Merge_forest& forest)
  {
    const std::uint32_t first = m_nodes.first_of_vertex(node);
    const vertex_descriptor v = m_nodes.vertex[node];
    if (m_first != first) {
      m_first = first;
      read_star(v);
      m_star.begin_at_lowest_vertex(m_tmesh, m_order);
      if (!find_ways_between_wedges(v))
        return false;
    }
    const std::size_t i = node - first + 1;
    const std::uint32_t lower = m_nodes.lower_begin[node];
    if (!trace(i))
      return true; // the strands belong to one component
    if (m_components.root(m_nodes.lower_end[lower]) !=
        m_components.root(m_nodes.lower_end[lower + 1]))
      return true;
    const std::uint32_t leaf = add_leaf(node, m_nodes.lower_end[lower + 1], forest);
    for (const std::size_t wedge : m_traced_wedges)
      mark_wedge(m_star.wedges[wedge], leaf);
    for (const std::size_t way : m_traced_ways)
      for_each_edge_of_way(v, way, [&](halfedge_descriptor h) { mark(h, leaf); });
    return true;
  }

  std::size_t number_of_lower_wedges() const { return m_star.wedges.size() / 2; }

  // The way of the level set from the first edge of lower wedge `way` backward: to the last edge of which
  // lower wedge, or to the border.
  bool find_ways_between_wedges(vertex_descriptor v)
  {
    const std::size_t k = number_of_lower_wedges();
    boost::unordered_map<halfedge_descriptor, std::size_t> wedge_of_last;
    for (std::size_t w = 0; w < k; ++w)
      wedge_of_last.emplace(m_star.halfedges[m_star.wedges[2 * w].end - 1], w);
    m_previous.assign(k, no_wedge);
    m_next.assign(k, no_wedge);
    for (std::size_t w = 0; w < k; ++w) {
      halfedge_descriptor last = boost::graph_traits<TriangleMesh>::null_halfedge();
      std::size_t steps = 0;
      const bool returns = for_each_step(v, first_walk(w), [&](const Walk& walk) {
        last = walk.halfedge();
        return ++steps < m_budget;
      });
      m_budget -= (std::min)(steps, m_budget);
      if (m_budget == 0)
        return false;
      if (returns) {
        const auto found = wedge_of_last.find(opposite(last, m_tmesh));
        if (found == wedge_of_last.end())
          throw_several_fans();
        m_previous[w] = found->second;
        m_next[found->second] = w;
      }
    }
    return true;
  }

  Walk first_walk(std::size_t w) const
  {
    return Walk(opposite(m_star.halfedges[m_star.wedges[2 * w].begin], m_tmesh), true);
  }

  Walk last_walk(std::size_t w) const
  {
    return Walk(m_star.halfedges[m_star.wedges[2 * w].end - 1], false);
  }

  // Calls `function(walk)` after every step until it returns false, or the walk is back at the vertex or at the
  // border. Returns whether it is back.
  template <class Function>
  bool for_each_step(vertex_descriptor v, Walk walk, const Function& function) const
  {
    while (!walk.is_at_border(m_tmesh)) {
      walk.step(m_tmesh, is_below(v));
      if (!function(walk))
        return false;
      if (walk.lower_vertex(m_tmesh) == v)
        return true;
    }
    return false;
  }

  // Follows, below saddle `i`, the component of the strand of L(i + 1) = wedge 2 i, which has the number i
  // among the lower wedges. Returns false if it arrives at the strand that passes by the saddles before.
  bool trace(std::size_t i)
  {
    m_traced_wedges.assign(1, 2 * i);
    m_traced_ways.clear();
    // backward along first edges: a strand is entered at its last edge and left at its first one
    for (std::size_t w = i;;) {
      m_traced_ways.push_back(2 * w);
      const std::size_t p = m_previous[w]; // arrives at the last edge of L(p + 1)
      if (p == no_wedge)
        break; // at the border: the rest of the component lies the other way
      if (m_budget > 0)
        --m_budget;
      if (p == i)
        return true; // closed
      if (p + 1 == i)
        return false; // the last edge of L(i) is the end of the strand that passes by
      m_traced_wedges.push_back(p > i ? 2 * p : 2 * p + 1);
      w = p > i ? p
                : p + 1; // across U(p + 1), an upper strand by now, to the first edge of L(p + 2)
    }
    for (std::size_t w = i;;) {
      m_traced_ways.push_back(2 * w + 1);
      const std::size_t n = m_next[w]; // arrives at the first edge of L(n + 1)
      if (n == no_wedge)
        return true;
      if (n == 0)
        return false; // the first edge of L(1) is the other end of the strand that passes by
      m_traced_wedges.push_back(n > i ? 2 * n : 2 * n - 1);
      w = n > i ? n : n - 1; // across U(n) to the last edge of L(n)
    }
  }

  template <class Function>
  void for_each_edge_of_way(vertex_descriptor v, std::size_t way, const Function& function) const
  {
    const Walk walk = way % 2 == 0 ? first_walk(way / 2) : last_walk(way / 2);
    for_each_step(v, walk, [&](const Walk& w) {
      if (w.lower_vertex(m_tmesh) != v)
        function(w.halfedge());
      return true;
    });
  }

  static constexpr std::size_t no_wedge = (std::numeric_limits<std::size_t>::max)();

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const Nodes& m_nodes;
  std::size_t m_budget;
  Number_sets m_components; // of the sublevel set, with the highest node as the root
  Lockstep_walks<TriangleMesh> m_walks;
  Star m_star;
  std::vector<typename Star::Wedge> m_lower_wedges;

  // of the vertex that is unfolded
  std::uint32_t m_first = no_node;
  std::vector<std::size_t> m_previous, m_next; // lower wedges, along the level set
  std::vector<std::size_t> m_traced_wedges;
  std::vector<std::size_t>
      m_traced_ways; // 2 w from the first edge of lower wedge w, 2 w + 1 from the last
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_CUTS_H
