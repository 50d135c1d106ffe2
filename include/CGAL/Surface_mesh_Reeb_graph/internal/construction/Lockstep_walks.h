// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOCKSTEP_WALKS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOCKSTEP_WALKS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Level_set_walk.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds which wedges on one side of a vertex belong to the same component of the level set there.
//
// The level set leaves a wedge at its two ends: a forward walk starts at the first edge, and
// arrives at the last edge of a wedge or at the border. All walks advance in lockstep, until all
// components but one are known from end to end; the one that is left, about the longest, is never
// walked to its end. On a mesh with border a component may end there in both directions, so
// backward walks start at the last edges too.
//
// What is said of the side above holds for the side below in the reversed order.
template <class TriangleMesh>
class Lockstep_walks
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Walk = Level_set_walk<TriangleMesh>;

public:
  // Is to be called first, for every vertex.
  void clear(const TriangleMesh& tmesh, bool has_border)
  {
    m_tmesh = &tmesh;
    m_has_border = has_border;
    m_wedges.clear();
    m_sets = Disjoint_sets();
    crossed.clear();
  }

  // Adds a wedge by its first and last edge, as halfedges that point to the vertex.
  void add_wedge(halfedge_descriptor first, halfedge_descriptor last)
  {
    Wedge wedge;
    wedge.first = first;
    wedge.last = last;
    m_wedges.push_back(wedge);
    m_sets.add();
  }

  std::uint32_t number_of_wedges() const { return static_cast<std::uint32_t>(m_wedges.size()); }

  // Begins to walk.
  void begin()
  {
    m_number_of_unfinished = number_of_wedges();
    m_number_of_steps = 0;
    m_turns.clear();
    for (std::uint32_t i = 0; i < number_of_wedges(); ++i) {
      add_turn(forward_walk(i), i);
      if (m_has_border)
        add_turn(backward_walk(i), i);
    }
    m_wedge_of_first.clear();
    m_wedge_of_last.clear();
    if (number_of_wedges() > LINEAR_SEARCH_BOUND) {
      for (std::uint32_t i = 0; i < number_of_wedges(); ++i) {
        m_wedge_of_first.emplace(m_wedges[i].first, i);
        m_wedge_of_last.emplace(m_wedges[i].last, i);
      }
    }
  }

  // How many walks there are to take the next step.
  std::size_t number_of_walks() const { return is_done() ? 0 : m_turns.size(); }

  // Reads what the next steps need, in two stages; `is_above(u)` tells on which side of the level a
  // vertex lies.
  void read_crossings()
  {
    for (Turn& turn : m_turns)
      turn.crossing = turn.walk.crossing(*m_tmesh);
  }

  template <class IsAbove>
  void read_sides(const IsAbove& is_above)
  {
    for (Turn& turn : m_turns)
      turn.is_vertex_above = is_above(turn.crossing.vertex);
  }

  // Lets every walk around `v` take a step. Returns false if all is known.
  bool advance(vertex_descriptor v)
  {
    check_walk(++m_number_of_steps, *m_tmesh);
    for (std::size_t i = 0; i < m_turns.size() && !is_done();) {
      if (take_turn(m_turns[i], v)) {
        ++i;
      } else {
        m_turns[i] = m_turns.back();
        m_turns.pop_back();
      }
    }
    return !is_done();
  }

  // A wedge that stands for all those of its component.
  std::uint32_t component(std::uint32_t wedge) { return m_sets.root(wedge); }

  // Whether a component is the one that has not been walked to its end.
  bool is_longest(std::uint32_t component) const { return m_wedges[component].open_ends > 0; }

  // The edges that were crossed, as halfedges that point upwards, with a wedge of their component.
  // There may be some twice; those at the vertex itself are not among them.
  std::vector<std::pair<std::uint32_t, halfedge_descriptor>> crossed;

private:
  struct Wedge
  {
    halfedge_descriptor first, last;
    // of the component, at its root: the ends whose other side is not known
    std::uint32_t open_ends = 2;
    bool first_is_known = false, last_is_known = false;
  };

  struct Turn
  {
    Walk walk;
    std::uint32_t wedge;
    // of the next step
    typename Walk::Crossing crossing;
    bool is_vertex_above;
  };

  void add_turn(const Walk& walk, std::uint32_t wedge)
  {
    m_turns.push_back({walk, wedge, {}, false});
  }

  bool is_done() const { return m_number_of_unfinished < 2 || m_turns.empty(); }

  Walk forward_walk(std::uint32_t i) const
  {
    return Walk(opposite(m_wedges[i].first, *m_tmesh), true);
  }

  Walk backward_walk(std::uint32_t i) const { return Walk(m_wedges[i].last, false); }

  // The wedge at which a walk that has come back to the vertex arrives.
  std::uint32_t wedge_of_arrival(const Walk& walk) const
  {
    const bool is_forward = walk.is_forward();
    const halfedge_descriptor h =
        is_forward ? opposite(walk.halfedge(), *m_tmesh) : walk.halfedge();
    if (number_of_wedges() > LINEAR_SEARCH_BOUND) {
      const auto& wedges = is_forward ? m_wedge_of_last : m_wedge_of_first;
      const auto found = wedges.find(h);
      if (found != wedges.end())
        return found->second;
    } else {
      for (std::uint32_t i = 0; i < number_of_wedges(); ++i)
        if ((is_forward ? m_wedges[i].last : m_wedges[i].first) == h)
          return i;
    }
    throw_internal_error("a walk along a level set has come to no wedge");
  }

  // Returns false when the walk is over.
  bool take_turn(Turn& turn, vertex_descriptor v)
  {
    Walk& walk = turn.walk;
    Wedge& wedge = m_wedges[turn.wedge];
    // another walk may have come the other way
    if (walk.is_forward() ? wedge.first_is_known : wedge.last_is_known)
      return false;
    if (walk.is_at_border(*m_tmesh)) {
      (walk.is_forward() ? wedge.first_is_known : wedge.last_is_known) = true;
      close_ends(turn.wedge, 1);
      return false;
    }
    walk.cross(turn.crossing, turn.is_vertex_above, *m_tmesh);
    if (turn.crossing.vertex != v) {
      crossed.emplace_back(
          turn.wedge, walk.is_forward() ? walk.halfedge() : opposite(walk.halfedge(), *m_tmesh));
      return true;
    }
    const std::uint32_t other = wedge_of_arrival(walk);
    (walk.is_forward() ? wedge.first_is_known : wedge.last_is_known) = true;
    (walk.is_forward() ? m_wedges[other].last_is_known : m_wedges[other].first_is_known) = true;
    join(turn.wedge, other);
    close_ends(turn.wedge, 2);
    return false;
  }

  void join(std::uint32_t i, std::uint32_t j)
  {
    i = m_sets.root(i);
    j = m_sets.root(j);
    if (i == j)
      return;
    m_sets.join(j, i);
    m_wedges[i].open_ends += m_wedges[j].open_ends;
    --m_number_of_unfinished;
  }

  void close_ends(std::uint32_t i, std::uint32_t number)
  {
    Wedge& wedge = m_wedges[m_sets.root(i)];
    CGAL_assertion(number <= wedge.open_ends && m_number_of_unfinished > 0);
    wedge.open_ends -= number;
    if (wedge.open_ends == 0)
      --m_number_of_unfinished;
  }

  static constexpr std::uint32_t LINEAR_SEARCH_BOUND = 8;

  const TriangleMesh* m_tmesh = nullptr;
  bool m_has_border = false;
  std::vector<Wedge> m_wedges;
  Disjoint_sets m_sets; // of wedges
  std::unordered_map<halfedge_descriptor, std::uint32_t, boost::hash<halfedge_descriptor>>
      m_wedge_of_first, m_wedge_of_last;
  std::vector<Turn> m_turns;
  std::uint32_t m_number_of_unfinished = 0;
  std::size_t m_number_of_steps = 0; // of every walk
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_LOCKSTEP_WALKS_H
