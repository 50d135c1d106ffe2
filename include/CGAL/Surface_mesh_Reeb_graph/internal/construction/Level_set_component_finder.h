// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LEVEL_SET_COMPONENT_FINDER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LEVEL_SET_COMPONENT_FINDER_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_nodes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Lockstep_walks.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/interleaved_tasks.h>

#include <atomic>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds the components of the level set just below nodes, by walks along them.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder>
class Level_set_component_finder
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;
  using halfedge_descriptor = typename Nodes::halfedge_descriptor;

public:
  // What the walks below a node have found: the component of every lower wedge, named after one of
  // its wedges, and the component that has not been walked to its end.
  struct Components
  {
    std::vector<std::uint32_t> component_of_wedge;
    std::uint32_t longest = no_node;
    std::size_t crossed_begin = 0, crossed_end = 0; // the edges that the others cross
  };

  struct Crossed_edge
  {
    std::uint32_t component;
    halfedge_descriptor halfedge; // points to the lower end
  };

  Level_set_component_finder(const TriangleMesh& tmesh,
                             const VertexOrder& order,
                             const Nodes& nodes,
                             bool has_border)
    : m_tmesh(tmesh), m_order(order), m_nodes(nodes), m_has_border(has_border)
  {}

  // Walks below the given nodes, which are in increasing order, except unfolded ones. Takes the
  // steps of the walks from the budget, and returns false if that does not suffice.
  bool find(const std::vector<std::uint32_t>& nodes, std::int64_t& budget_left)
  {
    components.resize(nodes.size());
    std::atomic<bool> is_budget_spent(false);
    std::atomic<std::int64_t> budget(budget_left);
    // a part of the budget is there for all nodes; the rest is shared out, so that if the first
    // nodes take more than their shares, it is soon seen that all together will take too much
    constexpr std::int64_t common_part = 16;
    const std::int64_t share = (budget_left - budget_left / common_part) /
                               (std::max)(std::int64_t(1), std::int64_t(nodes.size()));
    std::atomic<std::int64_t> reserve(share * std::int64_t(nodes.size()));
    for_each_range<ConcurrencyTag>(nodes.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<Walking> tasks((std::min)(end - begin, number_of_interleaved_tasks));
      // some steps at a time, since the atomic numbers are contended
      constexpr std::int64_t most_steps = 256;
      std::int64_t steps = 0;
      const auto spend = [&]() {
        if (budget.fetch_sub(steps, std::memory_order_relaxed) - steps < reserve)
          is_budget_spent = true;
        steps = 0;
      };
      run_interleaved(
          tasks,
          [&](Walking& walking) {
            while (begin < end && m_nodes.is_unfolded(nodes[begin]))
              ++begin;
            if (begin == end || is_budget_spent)
              return false;
            reserve.fetch_sub(share, std::memory_order_relaxed);
            begin_walking(walking, nodes[begin]);
            walking.number = begin++;
            return true;
          },
          [&](Walking& walking) {
            steps += static_cast<std::int64_t>(walking.walks.number_of_walks());
            if (steps >= most_steps)
              spend();
            if (is_budget_spent)
              return false;
            if (walking.walks.advance(walking.vertex))
              return true;
            end_walking(walking);
            return false;
          },
          [](Walking& walking) { walking.walks.read_crossings(); },
          [&](Walking& walking) { walking.walks.read_sides(is_below(walking.vertex)); });
      spend();
    });
    budget_left = budget;
    return !is_budget_spent;
  }

  std::vector<Components> components; // by position of the node
  std::vector<Crossed_edge> crossed;  // in the order in which the nodes were done

private:
  struct Walking
  {
    Lockstep_walks<TriangleMesh> walks;
    Star star;
    vertex_descriptor vertex;
    std::size_t number = 0;
  };

  void begin_walking(Walking& walking, std::uint32_t node) const
  {
    walking.vertex = m_nodes.vertex[node];
    walking.star.read(walking.vertex, m_tmesh, m_order);
    walking.walks.clear(m_tmesh, m_has_border);
    for (const auto& wedge : walking.star.wedges)
      if (!wedge.is_upper)
        walking.walks.add_wedge(walking.star.halfedges[wedge.begin],
                                walking.star.halfedges[wedge.end - 1]);
    walking.walks.begin();
  }

  void end_walking(Walking& walking)
  {
    Components& found = components[walking.number];
    for (std::uint32_t w = 0; w < walking.walks.number_of_wedges(); ++w) {
      const std::uint32_t component = walking.walks.component(w);
      found.component_of_wedge.push_back(component);
      if (walking.walks.is_longest(component))
        found.longest = component;
    }
    const std::lock_guard<std::mutex> lock(m_mutex);
    found.crossed_begin = crossed.size();
    for (const auto& [wedge, h] : walking.walks.crossed) {
      const std::uint32_t component = found.component_of_wedge[wedge];
      if (component != found.longest) // up is down in these walks
        crossed.push_back({component, h});
    }
    found.crossed_end = crossed.size();
  }

  auto is_below(vertex_descriptor v) const
  {
    return [this, v](vertex_descriptor u) { return m_order(u, v); };
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  const Nodes& m_nodes;
  const bool m_has_border;
  std::mutex m_mutex; // of `crossed`
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LEVEL_SET_COMPONENT_FINDER_H
