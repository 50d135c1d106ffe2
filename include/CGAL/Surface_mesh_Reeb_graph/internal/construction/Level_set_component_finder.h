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

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Lockstep_walks.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
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

// Finds the components of the level set just below or just above vertices, by walks along them.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder>
class Level_set_component_finder
{
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  // What the walks beside a vertex have found: the component of every wedge on the side, in the order
  // in which `Vertex_star` reads them, named after one of its wedges, and the component that has not
  // been walked to its end. Nothing, if the budget has been spent before.
  struct Components
  {
    std::vector<std::uint32_t> component_of_wedge;
    std::uint32_t longest = no_node;
    std::size_t crossed_begin = 0, crossed_end = 0; // the edges that the others cross
  };

  struct Crossed_edge
  {
    std::uint32_t component;
    halfedge_descriptor halfedge; // points to the end on the side
  };

  Level_set_component_finder(Side side,
                             const TriangleMesh& tmesh,
                             const VertexOrder& order,
                             bool has_border)
    : m_side(side), m_tmesh(tmesh), m_order(order), m_has_border(has_border)
  {}

  // Walks just beside some vertices; those that are null are passed over. Takes the steps of the walks
  // from the budget, and returns false if that does not suffice.
  bool find(const std::vector<vertex_descriptor>& vertices, std::int64_t& budget_left)
  {
    components.resize(vertices.size());
    std::atomic<bool> is_budget_spent(false);
    std::atomic<std::int64_t> budget(budget_left);
    // a part of the budget is there for all nodes; the rest is shared out, so that if the first
    // nodes take more than their shares, it is soon seen that all together will take too much
    constexpr std::int64_t common_part = 16;
    const std::int64_t share = (budget_left - budget_left / common_part) /
                               (std::max)(std::int64_t(1), std::int64_t(vertices.size()));
    std::atomic<std::int64_t> reserve(share * std::int64_t(vertices.size()));
    for_each_range<ConcurrencyTag>(vertices.size(), [&](std::size_t begin, std::size_t end) {
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
            while (begin < end && vertices[begin] == null_vertex())
              ++begin;
            if (begin == end || is_budget_spent)
              return false;
            reserve.fetch_sub(share, std::memory_order_relaxed);
            begin_walking(walking, vertices[begin]);
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
          [&](Walking& walking) { walking.walks.read_sides(is_on_side_of(walking.vertex)); });
      spend();
    });
    budget_left = budget;
    return !is_budget_spent;
  }

  std::vector<Components> components; // by position of the vertex
  std::vector<Crossed_edge> crossed;  // in the order in which the vertices were done

private:
  struct Walking
  {
    Lockstep_walks<TriangleMesh> walks;
    Star star;
    vertex_descriptor vertex;
    std::size_t number = 0;
  };

  static vertex_descriptor null_vertex()
  {
    return boost::graph_traits<TriangleMesh>::null_vertex();
  }

  void begin_walking(Walking& walking, vertex_descriptor v) const
  {
    walking.vertex = v;
    walking.star.read(walking.vertex, m_tmesh, m_order);
    walking.walks.clear(m_tmesh, m_has_border);
    for (const auto& wedge : walking.star.wedges)
      if (wedge.is_upper == (m_side == ABOVE))
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
      if (component != found.longest)
        crossed.push_back({component, h});
    }
    found.crossed_end = crossed.size();
  }

  // Below a vertex the walks take down for up.
  auto is_on_side_of(vertex_descriptor v) const
  {
    return
        [this, v](vertex_descriptor u) { return m_side == BELOW ? m_order(u, v) : m_order(v, u); };
  }

  const Side m_side;
  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  const bool m_has_border;
  std::mutex m_mutex; // of `crossed`
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LEVEL_SET_COMPONENT_FINDER_H
