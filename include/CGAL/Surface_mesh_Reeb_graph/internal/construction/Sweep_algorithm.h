// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_SWEEP_ALGORITHM_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_SWEEP_ALGORITHM_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Rising_level_set.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Reeb_graph_request.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Edge_numbers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star_batch.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/prefetch.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Computes the Reeb graph by a sweep through the vertices in increasing order (after
// Cole-McLaughlin, Edelsbrunner, Harer, Natarajan, Pascucci, "Loops in Reeb graphs of 2-manifolds",
// 2004).
//
// The components of the level set are sequences of crossed edges, which split and merge in
// logarithmic time: the sweep takes O(n log n) time whatever the function and the surface. At a
// regular vertex the upper edges just take over the places of the lower ones.
template <class TriangleMesh, class VertexOrder, class VertexIndexMap, class HalfedgeIndexMap>
class Sweep_algorithm
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Star = Vertex_star<TriangleMesh>;
  using Run = Rising_level_set::Run;

public:
  Sweep_algorithm(const TriangleMesh& tmesh,
                  const VertexOrder& order,
                  VertexIndexMap vertex_index_map,
                  std::size_t index_bound,
                  HalfedgeIndexMap halfedge_index_map,
                  const Reeb_graph_request& request)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_edge_numbers(tmesh, halfedge_index_map)
    , m_request(request)
    , m_element(m_edge_numbers.bound(), Rising_level_set::no_element)
  {
    if (request.has_vertex_arcs)
      m_result.arc_of_vertex.assign(index_bound, no_arc);
  }

  // Sweeps all vertices, given in increasing order.
  Arc_list<TriangleMesh> run(const std::vector<vertex_descriptor>& sorted)
  {
    const auto range = halfedges(m_tmesh);
    if (pass_vertices(sorted) !=
        static_cast<std::size_t>(std::distance(range.begin(), range.end())))
      throw_internal_error("the circulations around the vertices miss edges");
    // in a halfedge structure that is not valid, an arc may not have come to its end
    if (!m_result.are_arcs_upward())
      throw_internal_error("an arc does not end in a higher node");
    if (m_request.has_vertex_arcs)
      m_result.set_arcs_of_nodes(m_vertex_index_map);
    return std::move(m_result);
  }

private:
  // Lets the level rise past vertices, given in increasing order. Returns how many edges there are
  // around them, counted for each of them.
  std::size_t pass_vertices(const std::vector<vertex_descriptor>& sorted)
  {
    Vertex_star_batch<TriangleMesh> stars;
    std::size_t number_of_star_edges = 0;
    for (std::size_t begin = 0; begin < sorted.size(); begin += stars.capacity) {
      const std::size_t size = (std::min)(stars.capacity, sorted.size() - begin);
      stars.read(sorted.data() + begin, size, m_tmesh);
      for (std::size_t i = 0; i < size; ++i) {
        number_of_star_edges += stars[i].halfedges.size();
        stars[i].find_wedges(sorted[begin + i], m_tmesh, m_order);
        for (const halfedge_descriptor h : stars[i].halfedges)
          prefetch(&element(h));
      }
      for (std::size_t i = 0; i < size; ++i)
        if (stars[i].wedges.size() > 2)
          prefetch_elements(stars[i]);
      for (std::size_t i = 0; i < size; ++i)
        process(sorted[begin + i], stars[i]);
    }
    return number_of_star_edges;
  }

  // The element that the edge has in the sequence of its component while it is crossed.
  std::uint32_t& element(halfedge_descriptor h) { return m_element[m_edge_numbers(h)]; }

  // An edge ends at one vertex only: a second one finds no element.
  std::uint32_t element_of_lower_edge(halfedge_descriptor h)
  {
    const std::uint32_t result = std::exchange(element(h), Rising_level_set::no_element);
    if (result == Rising_level_set::no_element)
      throw_internal_error("the level set has come past an edge without its lower end");
    return result;
  }

  void prefetch_elements(const Star& star)
  {
    for (const auto& wedge : star.wedges) {
      if (wedge.is_upper)
        continue;
      m_level_sets.prefetch_element(element(star.halfedges[wedge.begin]));
      m_level_sets.prefetch_element(element(star.halfedges[wedge.end - 1]));
    }
  }

  void process(vertex_descriptor v, Star& star)
  {
    if (star.number_of_wedges(false) == 1 && star.number_of_wedges(true) == 1) {
      continue_arc(v, star);
      return;
    }
    if (m_request.unfolds && star.number_of_simple_saddles() > 1) {
      unfold(v, star);
      return;
    }
    clear_runs();
    for (const auto& wedge : star.wedges)
      add_run(star, wedge);
    pass(v);
    for (std::size_t i = 0; i < m_runs.size(); ++i)
      set_elements(star, star.wedges[i], m_runs[i]);
    if (m_is_branching)
      add_upper_wedges(star, star.wedges.size());
  }

  void continue_arc(vertex_descriptor v, const Star& star)
  {
    const auto& lower = star.wedges[star.wedges[0].is_upper ? 1 : 0];
    const auto& upper = star.wedges[star.wedges[0].is_upper ? 0 : 1];
    CGAL_assertion(!lower.is_upper && upper.is_upper);
    m_elements.clear();
    for (std::size_t i = lower.begin; i < lower.end; ++i)
      m_elements.push_back(element_of_lower_edge(star.halfedges[i]));
    if (m_request.has_vertex_arcs)
      m_result.arc_of_vertex[get(m_vertex_index_map, v)] = m_level_sets.arc(m_elements.front());
    m_level_sets.replace(m_elements, upper.end - upper.begin);
    for (std::size_t i = upper.begin; i < upper.end; ++i)
      element(star.halfedges[i]) = m_elements[i - upper.begin];
  }

  void clear_runs()
  {
    m_runs.clear();
    m_lowest.clear();
  }

  void add_run(const Star& star, const typename Star::Wedge& wedge)
  {
    if (wedge.is_upper)
      m_lowest.push_back(
          {source(star.lowest_edge(wedge, m_tmesh, m_order), m_tmesh), m_runs.size()});
    m_runs.push_back(run_of_wedge(star, wedge));
  }

  Run run_of_wedge(const Star& star, const typename Star::Wedge& wedge)
  {
    Run run = {};
    run.is_upper = wedge.is_upper;
    run.is_linked = wedge.is_linked;
    run.size = wedge.end - wedge.begin;
    if (!wedge.is_upper) {
      run.first = run.last = element_of_lower_edge(star.halfedges[wedge.begin]);
      for (std::size_t i = wedge.begin + 1; i < wedge.end; ++i)
        run.last = element_of_lower_edge(star.halfedges[i]);
    }
    return run;
  }

  void set_elements(const Star& star, const typename Star::Wedge& wedge, const Run& run)
  {
    if (wedge.is_upper)
      for (std::size_t i = wedge.begin; i < wedge.end; ++i)
        element(star.halfedges[i]) = m_level_sets.elements[run.elements_begin + i - wedge.begin];
  }

  // Lets the level rise past the runs, which makes a node unless one component goes in and one
  // comes out.
  void pass(vertex_descriptor v)
  {
    if (m_lowest.size() > 1)
      sort_by_lowest_vertices(m_lowest, m_order);
    for (std::size_t i = 0; i < m_lowest.size(); ++i)
      m_runs[m_lowest[i].position].lowest = static_cast<std::uint32_t>(i);
    m_level_sets.pass(m_runs, m_arcs_below);
    m_is_branching = false;
    if (m_arcs_below.size() == 1 && m_level_sets.components.size() == 1) {
      if (m_request.has_vertex_arcs)
        m_result.arc_of_vertex[get(m_vertex_index_map, v)] = m_arcs_below.front();
      m_level_sets.set_arc(m_level_sets.components.front(), m_arcs_below.front());
      return;
    }
    const std::uint32_t node = static_cast<std::uint32_t>(m_result.nodes.size());
    m_result.nodes.push_back(v);
    for (const std::uint32_t arc : m_arcs_below)
      m_result.arcs[arc].upper = node;
    for (const Rising_level_set::Component& component : m_level_sets.components) {
      m_level_sets.set_arc(component, static_cast<std::uint32_t>(m_result.arcs.size()));
      m_result.arcs.push_back({node, no_node});
    }
    m_is_branching = m_request.has_wedge_arcs && m_level_sets.components.size() > 1;
  }

  // Around the vertex there are the wedges L1 U1 L2 U2 ... Lk Uk. The first simple saddle joins L1
  // and L2 across U1 to one strand that passes by the vertex, and so on; what passes by the last
  // one is Uk.
  CGAL_REEB_GRAPH_COLD void unfold(vertex_descriptor v, Star& star)
  {
    star.begin_at_lowest_vertex(m_tmesh, m_order);
    const std::size_t number = star.number_of_simple_saddles();
    Run strand = run_of_wedge(star, star.wedges[0]);
    for (std::size_t i = 1; i <= number; ++i) {
      clear_runs();
      m_runs.push_back(strand);
      add_run(star, star.wedges[2 * i - 1]);
      add_run(star, star.wedges[2 * i]);
      if (i < number) {
        Run passing = {};
        passing.is_upper = passing.is_linked = true;
        passing.size = 1;
        m_lowest.push_back({v, m_runs.size()}); // the next saddle
        m_runs.push_back(passing);
      } else {
        add_run(star, star.wedges.back());
      }
      pass(v);
      set_elements(star, star.wedges[2 * i - 1], m_runs[1]);
      if (i < number) {
        strand.first = strand.last = m_level_sets.elements[m_runs[3].elements_begin];
        strand.is_linked = true;
      } else {
        set_elements(star, star.wedges.back(), m_runs[3]);
      }
      if (m_request.has_wedge_arcs) {
        add_upper_wedge(star, 2 * i - 1);
        if (i == number)
          add_upper_wedge(star, 2 * i + 1);
      }
    }
  }

  void add_upper_wedges(const Star& star, std::size_t number_of_wedges)
  {
    for (std::size_t w = 0; w < number_of_wedges; ++w)
      if (star.wedges[w].is_upper)
        add_upper_wedge(star, w);
  }

  void add_upper_wedge(const Star& star, std::size_t wedge)
  {
    const halfedge_descriptor h = star.halfedges[star.wedges[wedge].begin];
    m_result.upper_wedges.push_back({h, m_level_sets.arc(element(h))});
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const Edge_numbers<TriangleMesh, HalfedgeIndexMap> m_edge_numbers;
  const Reeb_graph_request m_request;
  std::vector<std::uint32_t> m_element; // of the edges, by their numbers
  Rising_level_set m_level_sets;
  Arc_list<TriangleMesh> m_result;

  // Members, so that no vertex allocates.
  bool m_is_branching = false;
  std::vector<Run> m_runs;
  std::vector<Lowest_vertex<vertex_descriptor>> m_lowest; // of the upper runs
  std::vector<std::uint32_t> m_elements;
  std::vector<std::uint32_t> m_arcs_below;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_SWEEP_ALGORITHM_H
