// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UPPER_LEVEL_SET_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UPPER_LEVEL_SET_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Level_set_walk.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The components of the level set just above a vertex that touch it.
//
// The upper edges of the vertex form wedges. The level set leaves a wedge at its two ends: a forward
// walk starts at the first edge, and arrives at the last edge of a wedge or at the border. All walks
// take one step in turn, until all components but one are known from end to end; the one that is left,
// about the longest, is never walked to its end. On a mesh with border a component may end there in
// both directions, so backward walks start at the last edges too.
template <class TriangleMesh>
class Upper_level_set
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Walk = Level_set_walk<TriangleMesh>;

public:
  Upper_level_set(const TriangleMesh& tmesh, bool has_border)
    : m_tmesh(tmesh), m_has_border(has_border)
  {}

  void clear()
  {
    m_wedges.clear();
    m_components.clear();
  }

  // Adds a wedge by its first and last edge, as halfedges that point to the vertex; `lowest` is the
  // smallest rank of its upper vertices.
  void add_wedge(halfedge_descriptor first, halfedge_descriptor last, std::uint32_t lowest)
  {
    Wedge wedge;
    wedge.first = first;
    wedge.last = last;
    wedge.lowest = lowest;
    wedge.parent = number_of_wedges();
    m_wedges.push_back(wedge);
  }

  std::uint32_t number_of_wedges() const { return static_cast<std::uint32_t>(m_wedges.size()); }

  // Begins to join the wedges to components.
  void begin_walks()
  {
    m_number_of_unfinished = number_of_wedges();
    m_turns.clear();
    if (m_number_of_unfinished < 2)
      return;
    for (std::uint32_t i = 0; i < number_of_wedges(); ++i) {
      m_turns.push_back({forward_walk(i), i});
      if (m_has_border)
        m_turns.push_back({backward_walk(i), i});
    }
  }

  // (On a 2-manifold there are always walks left while components are not known.)
  // Instead of walks, if it is known that there is one component only.
  void join_all_wedges()
  {
    for (std::uint32_t i = 1; i < number_of_wedges(); ++i)
      join(0, i);
  }

  bool is_walking() const { return m_number_of_unfinished > 1 && !m_turns.empty(); }

  // Lets every walk take a step. `is_above(u)` tells whether a vertex lies above the level,
  // `wedge_of(h)` gives the wedge of an upper edge of the vertex.
  template <class IsAbove, class WedgeOf>
  void advance_walks(vertex_descriptor v, const IsAbove& is_above, const WedgeOf& wedge_of)
  {
    for (std::size_t i = 0; i < m_turns.size() && is_walking();) {
      if (take_turn(m_turns[i], v, is_above, wedge_of)) {
        ++i;
      } else {
        m_turns[i] = m_turns.back();
        m_turns.pop_back();
      }
    }
  }

  // Numbers the components, by their lowest upper vertices.
  void end_walks()
  {
    for (std::uint32_t i = 0; i < number_of_wedges(); ++i) {
      const std::uint32_t r = root(i);
      if (r == i)
        m_components.push_back(i);
      m_wedges[r].lowest = (std::min)(m_wedges[r].lowest, m_wedges[i].lowest);
    }
    std::sort(m_components.begin(), m_components.end(), [this](std::uint32_t i, std::uint32_t j) {
      return m_wedges[i].lowest < m_wedges[j].lowest;
    });
    for (std::size_t k = 0; k < m_components.size(); ++k)
      m_wedges[m_components[k]].component = k;
  }

  std::size_t number_of_components() const { return m_components.size(); }

  std::size_t component_of_wedge(std::uint32_t wedge) { return m_wedges[root(wedge)].component; }

  bool is_longest(std::size_t component) const
  {
    return m_wedges[m_components[component]].open_ends > 0;
  }

  // Calls `function` for all crossed edges of a component but those at the vertex itself.
  // \pre `!is_longest(component)`
  template <class IsAbove, class Function>
  void for_each_edge(std::size_t component,
                     vertex_descriptor v,
                     const IsAbove& is_above,
                     const Function& function)
  {
    for (std::uint32_t i = 0; i < number_of_wedges(); ++i) {
      if (root(i) != m_components[component])
        continue;
      follow(forward_walk(i), v, is_above, function);
      if (m_wedges[i].last_leads_to_border)
        follow(backward_walk(i), v, is_above, function);
    }
  }

private:
  struct Wedge
  {
    halfedge_descriptor first, last;
    std::uint32_t lowest;
    std::uint32_t parent; // union-find over the wedges
    // of the component, at its root: the ends whose other side is not known
    std::uint32_t open_ends = 2;
    std::size_t component = 0; // at the root
    bool first_is_known = false, last_is_known = false, last_leads_to_border = false;
  };

  struct Turn
  {
    Walk walk;
    std::uint32_t wedge;
  };

  Walk forward_walk(std::uint32_t i) const
  {
    return Walk(opposite(m_wedges[i].first, m_tmesh), true);
  }

  Walk backward_walk(std::uint32_t i) const { return Walk(m_wedges[i].last, false); }

  std::uint32_t root(std::uint32_t i)
  {
    while (m_wedges[i].parent != i)
      i = m_wedges[i].parent = m_wedges[m_wedges[i].parent].parent;
    return i;
  }

  // Returns false when the walk is over.
  template <class IsAbove, class WedgeOf>
  bool take_turn(Turn& turn, vertex_descriptor v, const IsAbove& is_above, const WedgeOf& wedge_of)
  {
    Walk& walk = turn.walk;
    Wedge& wedge = m_wedges[turn.wedge];
    // another walk may have come the other way
    if (walk.is_forward() ? wedge.first_is_known : wedge.last_is_known)
      return false;
    if (walk.is_at_border(m_tmesh)) {
      if (walk.is_forward()) {
        wedge.first_is_known = true;
      } else {
        wedge.last_is_known = true;
        wedge.last_leads_to_border = true;
      }
      close_ends(turn.wedge, 1);
      return false;
    }
    walk.step(m_tmesh, is_above);
    if (walk.lower_vertex(m_tmesh) != v)
      return true;
    const std::uint32_t other = wedge_of(walk.halfedge());
    (walk.is_forward() ? wedge.first_is_known : wedge.last_is_known) = true;
    (walk.is_forward() ? m_wedges[other].last_is_known : m_wedges[other].first_is_known) = true;
    join(turn.wedge, other);
    close_ends(turn.wedge, 2);
    return false;
  }

  void join(std::uint32_t i, std::uint32_t j)
  {
    i = root(i);
    j = root(j);
    if (i == j)
      return;
    m_wedges[j].parent = i;
    m_wedges[i].open_ends += m_wedges[j].open_ends;
    --m_number_of_unfinished;
  }

  void close_ends(std::uint32_t i, std::uint32_t number)
  {
    Wedge& wedge = m_wedges[root(i)];
    wedge.open_ends -= number;
    if (wedge.open_ends == 0)
      --m_number_of_unfinished;
  }

  template <class IsAbove, class Function>
  void
  follow(Walk walk, vertex_descriptor v, const IsAbove& is_above, const Function& function) const
  {
    while (!walk.is_at_border(m_tmesh)) {
      walk.step(m_tmesh, is_above);
      if (walk.lower_vertex(m_tmesh) == v)
        return;
      function(walk.halfedge());
    }
  }

  const TriangleMesh& m_tmesh;
  bool m_has_border;
  std::vector<Wedge> m_wedges;
  std::vector<std::uint32_t> m_components; // roots, sorted by the lowest upper vertex
  std::vector<Turn> m_turns;
  std::uint32_t m_number_of_unfinished = 0;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UPPER_LEVEL_SET_H
