// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_UNFOLDED_SADDLE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_UNFOLDED_SADDLE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Level_set_walk.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The components of the level set just below each of the simple saddles that a multiple saddle is
// unfolded into. Around the vertex there are the wedges L1 U1 L2 U2 ... Lk Uk. Saddle i joins the
// strand of the level set that passes by the saddles before, from the first edge of L1 to the last
// one of L(i), and the strand of L(i + 1), across U(i). Outside of the star of the vertex the level
// set is the same for all of them.
template <class TriangleMesh, class VertexOrder>
class Unfolded_saddle
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Star = Vertex_star<TriangleMesh>;
  using Walk = Level_set_walk<TriangleMesh>;

public:
  Unfolded_saddle(const TriangleMesh& tmesh, const VertexOrder& order)
    : m_tmesh(tmesh), m_order(order)
  {}

  // Finds the ways of the level set around the vertex from the first edge of every lower wedge to
  // the last edge of another one, or to the border. Returns false if that takes more steps than the
  // budget allows.
  CGAL_REEB_GRAPH_COLD bool set_vertex(vertex_descriptor v, std::int64_t& budget)
  {
    if (!m_star.halfedges.empty() && target(m_star.halfedges.front(), m_tmesh) == v)
      return true;
    m_star.read(v, m_tmesh, m_order);
    m_star.begin_at_lowest_vertex(m_tmesh, m_order);

    const std::size_t k = m_star.wedges.size() / 2;
    std::unordered_map<halfedge_descriptor, std::uint32_t, boost::hash<halfedge_descriptor>>
        wedge_of_last;
    for (std::size_t w = 0; w < k; ++w)
      wedge_of_last.emplace(m_star.halfedges[m_star.wedges[2 * w].end - 1],
                            static_cast<std::uint32_t>(w));
    m_previous.assign(k, no_wedge);
    m_next.assign(k, no_wedge);
    const auto is_below = [&](vertex_descriptor u) { return m_order(u, v); };
    for (std::size_t w = 0; w < k; ++w) {
      Walk walk(opposite(m_star.halfedges[m_star.wedges[2 * w].begin], m_tmesh), true);
      std::size_t number_of_steps = 0;
      while (!walk.is_at_border(m_tmesh)) {
        check_walk(++number_of_steps, m_tmesh);
        if (budget-- <= 0)
          return false;
        if (walk.step(m_tmesh, is_below) != v)
          continue;
        const auto found = wedge_of_last.find(opposite(walk.halfedge(), m_tmesh));
        if (found == wedge_of_last.end())
          throw_internal_error("a walk along a level set has come to no wedge");
        m_previous[w] = found->second;
        m_next[found->second] = w;
        break;
      }
    }
    return true;
  }

  const Star& star() const { return m_star; }

  // Whether, just below saddle `i`, both strands belong to one component. If they do not, the parts
  // of the component of L(i + 1) are told by the functions that follow.
  CGAL_REEB_GRAPH_COLD bool is_one_component(std::size_t i, std::int64_t& budget)
  {
    CGAL_precondition(0 < i && i < m_next.size());
    m_traced_wedges.assign(1, 2 * i);
    m_traced_first_ends.clear();
    m_traced_last_ends.clear();
    // against the direction of the walks: a strand is entered at its last edge and left at its
    // first one
    for (std::size_t w = i;;) {
      m_traced_first_ends.push_back(2 * w);
      const std::size_t p = m_previous[w]; // arrives at the last edge of L(p + 1)
      if (p == no_wedge)
        break; // at the border: the rest of the component lies the other way
      --budget;
      if (p == i)
        return false; // closed
      if (p + 1 == i)
        return true; // the last edge of L(i) is the end of the strand that passes by
      m_traced_wedges.push_back(p > i ? 2 * p : 2 * p + 1);
      w = p > i ? p
                : p + 1; // across U(p + 1), an upper strand by now, to the first edge of L(p + 2)
    }
    for (std::size_t w = i;;) {
      m_traced_last_ends.push_back(2 * w);
      const std::size_t n = m_next[w]; // arrives at the first edge of L(n + 1)
      if (n == no_wedge)
        return false;
      --budget;
      if (n == 0)
        return true; // the first edge of L(1) is the other end of the strand that passes by
      m_traced_wedges.push_back(n > i ? 2 * n : 2 * n - 1);
      w = n > i ? n : n - 1; // across U(n) to the last edge of L(n)
    }
  }

  // Of the component, as positions in the star: its wedges, and the lower wedges from whose first
  // (last) edge it leaves the star.
  const std::vector<std::size_t>& traced_wedges() const { return m_traced_wedges; }
  const std::vector<std::size_t>& traced_first_ends() const { return m_traced_first_ends; }
  const std::vector<std::size_t>& traced_last_ends() const { return m_traced_last_ends; }

private:
  static constexpr std::size_t no_wedge = (std::numeric_limits<std::size_t>::max)();

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  Star m_star;
  std::vector<std::size_t> m_previous, m_next; // lower wedges, along the level set
  std::vector<std::size_t> m_traced_wedges, m_traced_first_ends, m_traced_last_ends;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_UNFOLDED_SADDLE_H
