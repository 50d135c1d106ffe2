// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOOP_CUTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOOP_CUTS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_nodes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Level_set_component_finder.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Merge_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Monotone_paths.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Path_cutter.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Unfolded_saddle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Level_set_walk.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Cuts the surface along components of level sets such that its Reeb graph loses all loops and
// keeps everything else: just below a node every component of the sublevel set keeps one of the
// components of the level set that lead from it to the node, and is cut along the others. A cut
// ends the surface below in a leaf, a node that lies between its saddle and all that is lower.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Loop_cuts
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;
  using halfedge_descriptor = typename Nodes::halfedge_descriptor;
  using Walk = Level_set_walk<TriangleMesh>;
  using Paths = Monotone_paths<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Finder = Level_set_component_finder<ConcurrencyTag, TriangleMesh, VertexOrder>;
  using Cutter = Path_cutter<TriangleMesh, Nodes, Paths>;

public:
  Loop_cuts(const TriangleMesh& tmesh,
            const VertexOrder& order,
            const Nodes& nodes,
            const Paths& ascents,
            bool has_border,
            bool cuts_later_paths,
            std::size_t budget)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_nodes(nodes)
    , m_ascents(ascents)
    , m_cuts_later_paths(cuts_later_paths)
    , m_cutter(tmesh, nodes, ascents, cuts_later_paths)
    , m_finder(BELOW, tmesh, order, has_border)
    , m_budget(static_cast<std::int64_t>(
          (std::min)(budget, std::size_t((std::numeric_limits<std::int64_t>::max)() / 2))))
    , m_unfolded(tmesh, order)
  {}

  // Walks along the level set below the nodes at which there may be loops, which are in increasing
  // order, to find its components. Returns false if that takes more steps than the budget allows.
  bool find_components(const std::vector<std::uint32_t>& nodes)
  {
    std::vector<vertex_descriptor> vertices; // null for unfolded nodes
    vertices.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
      vertices.push_back(m_nodes.is_unfolded(node)
                             ? boost::graph_traits<TriangleMesh>::null_vertex()
                             : m_nodes.vertex[node]);
    return m_finder.find(vertices, m_budget);
  }

  // Makes the forest of sublevel sets, with the leaves of the cuts, and finds where these cut the
  // paths. The components must be known. Returns false if that takes more steps than the budget
  // allows.
  bool cut(const std::vector<std::uint32_t>& may_have_loops, Merge_forest& forest)
  {
    forest.clear(m_nodes.size());
    m_components = Disjoint_sets(m_nodes.size());
    sequence.reserve(m_nodes.size());
    auto next = may_have_loops.begin();
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) {
      if (next != may_have_loops.end() && *next == node) {
        if (!m_nodes.is_unfolded(node))
          cut_below(node, next - may_have_loops.begin(), forest);
        else if (!cut_below_simple_saddle(node, forest))
          return false;
        ++next;
      }
      for (std::uint32_t w = m_nodes.lower_begin[node]; w < m_nodes.lower_begin[node + 1]; ++w)
        attach(m_components.root(m_nodes.lower_end[w]), node, forest);
      sequence.push_back(node);
    }
    if (!m_cut_walks.empty())
      walk_along_cuts();
    return true;
  }

  bool is_leaf(std::uint32_t node) const { return node >= m_nodes.size(); }
  std::uint32_t saddle_of_leaf(std::uint32_t leaf) const
  {
    CGAL_precondition(is_leaf(leaf));
    return saddles[leaf - m_nodes.size()];
  }

  // The cuts of upward paths, which are handed over. With `cuts_later_paths`, those of ways that no
  // path has taken yet are there, too.
  std::vector<typename Paths::Cut> take_cuts() { return std::move(m_cutter.cuts); }

  std::vector<std::uint32_t> sequence; // of all nodes, the leaves included
  std::vector<std::uint32_t> saddles;  // of the leaves, whose numbers follow those of the nodes

private:
  // A walk along a component that is cut at an unfolded saddle.
  struct Cut_walk
  {
    Walk walk;
    std::uint32_t leaf;
  };

  // ---- the cuts

  void attach(std::uint32_t component, std::uint32_t node, Merge_forest& forest)
  {
    if (component == node)
      return;
    CGAL_assertion(component < node || is_leaf(component));
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

  void cut_below(std::uint32_t node, std::ptrdiff_t number, Merge_forest& forest)
  {
    const typename Finder::Components& walked =
        m_finder.components[static_cast<std::size_t>(number)];
    // for every component of the level set the one of the sublevel set, found before there are
    // leaves
    struct Component
    {
      std::uint32_t sublevel, walked_last, level, end;
    };
    std::vector<Component> components;
    for (std::uint32_t w = 0; w < walked.component_of_wedge.size(); ++w) {
      if (walked.component_of_wedge[w] != w)
        continue;
      const std::uint32_t end = m_nodes.lower_end[m_nodes.lower_begin[node] + w];
      components.push_back({m_components.root(end), w == walked.longest ? 0u : 1u, w, end});
    }
    // one of the components of every sublevel set is kept: the longest one, or any other
    std::sort(components.begin(), components.end(), [](const Component& a, const Component& b) {
      return std::tie(a.sublevel, a.walked_last, a.level) <
             std::tie(b.sublevel, b.walked_last, b.level);
    });
    std::vector<std::uint32_t> leaf_of_component(walked.component_of_wedge.size(), no_node);
    for (std::size_t i = 1; i < components.size(); ++i)
      if (components[i].sublevel == components[i - 1].sublevel)
        leaf_of_component[components[i].level] = add_leaf(node, components[i].end, forest);

    m_star.read(m_nodes.vertex[node], m_tmesh, m_order);
    std::uint32_t w = 0;
    for (const auto& wedge : m_star.wedges) {
      if (wedge.is_upper)
        continue;
      const std::uint32_t leaf = leaf_of_component[walked.component_of_wedge[w++]];
      if (leaf == no_node)
        continue;
      cut_wedge(m_star, wedge, leaf);
    }
    for (std::size_t i = walked.crossed_begin; i < walked.crossed_end; ++i) {
      const std::uint32_t leaf = leaf_of_component[m_finder.crossed[i].component];
      if (leaf != no_node)
        m_cutter.cut(m_finder.crossed[i].halfedge, leaf);
    }
  }

  CGAL_REEB_GRAPH_COLD bool cut_below_simple_saddle(std::uint32_t node, Merge_forest& forest)
  {
    if (m_nodes.vertex[m_first] != m_nodes.vertex[node])
      for (m_first = node; !m_nodes.is_first_of_vertex(m_first);)
        --m_first;
    if (!m_unfolded.set_vertex(m_nodes.vertex[node], m_budget))
      return false;
    const std::uint32_t lower = m_nodes.lower_begin[node];
    if (m_unfolded.is_one_component(node - m_first + 1, m_budget) ||
        m_components.root(m_nodes.lower_end[lower]) !=
            m_components.root(m_nodes.lower_end[lower + 1]))
      return m_budget > 0;
    const std::uint32_t leaf = add_leaf(node, m_nodes.lower_end[lower + 1], forest);
    const Star& star = m_unfolded.star();
    for (const std::size_t wedge : m_unfolded.traced_wedges())
      cut_wedge(star, star.wedges[wedge], leaf);
    for (const std::size_t wedge : m_unfolded.traced_first_ends())
      m_cut_walks.push_back({first_walk(star, star.wedges[wedge]), leaf});
    for (const std::size_t wedge : m_unfolded.traced_last_ends())
      m_cut_walks.push_back({last_walk(star, star.wedges[wedge]), leaf});
    return true;
  }

  // ---- the cuts of the paths

  void cut_wedge(const Star& star, const typename Star::Wedge& wedge, std::uint32_t leaf)
  {
    for (std::size_t i = wedge.begin; i < wedge.end; ++i) {
      const halfedge_descriptor h = star.halfedges[i];
      m_cutter.cut(wedge.is_upper ? h : opposite(h, m_tmesh), leaf);
    }
  }

  // At unfolded saddles.
  CGAL_REEB_GRAPH_COLD void walk_along_cuts()
  {
    for_each_range<ConcurrencyTag>(m_cut_walks.size(), [&](std::size_t begin, std::size_t end) {
      Cutter cutter(m_tmesh, m_nodes, m_ascents, m_cuts_later_paths);
      for (std::size_t i = begin; i < end; ++i) {
        Walk walk = m_cut_walks[i].walk;
        const vertex_descriptor saddle = m_nodes.vertex[saddle_of_leaf(m_cut_walks[i].leaf)];
        std::size_t number_of_steps = 0;
        for (bool is_at_saddle = false; !is_at_saddle && !walk.is_at_border(m_tmesh);) {
          check_walk(++number_of_steps, m_tmesh);
          is_at_saddle = walk.step(m_tmesh, is_below(saddle)) == saddle;
          // in the reversed order of these walks, forward is down
          const halfedge_descriptor h = walk.halfedge();
          cutter.cut(walk.is_forward() ? h : opposite(h, m_tmesh), m_cut_walks[i].leaf);
        }
      }
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_cutter.cuts.insert(m_cutter.cuts.end(), cutter.cuts.begin(), cutter.cuts.end());
    });
  }

  auto is_below(vertex_descriptor v) const
  {
    return [this, v](vertex_descriptor u) { return m_order(u, v); };
  }

  Walk first_walk(const Star& star, const typename Star::Wedge& wedge) const
  {
    return Walk(opposite(star.halfedges[wedge.begin], m_tmesh), true);
  }

  Walk last_walk(const Star& star, const typename Star::Wedge& wedge) const
  {
    return Walk(star.halfedges[wedge.end - 1], false);
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  const Nodes& m_nodes;
  const Paths& m_ascents;
  const bool m_cuts_later_paths;
  Cutter m_cutter;
  Finder m_finder;
  std::int64_t m_budget;
  Disjoint_sets m_components; // of the sublevel set, with the highest node as the root
  std::mutex m_mutex;         // of m_cutter
  Unfolded_saddle<TriangleMesh, VertexOrder> m_unfolded;
  std::uint32_t m_first = 0; // of the nodes of its vertex
  Star m_star;
  std::vector<Cut_walk> m_cut_walks;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOOP_CUTS_H
