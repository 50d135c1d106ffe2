// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CUTTING_ALGORITHM_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CUTTING_ALGORITHM_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Arc_propagation.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Contour_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_node_finder.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_nodes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Loop_cuts.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Merge_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Monotone_paths.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Vertex_assignment.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/build_merge_forests.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Reeb_graph_request.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// So many steps of walks per vertex take less time than the other way to find the arcs of vertices.
constexpr std::size_t WALK_STEPS_FOR_ARCS = 8;

// Computes the Reeb graph without sorting the vertices.
//
// 1. From every wedge of the critical vertices a monotone path leads to another critical vertex.
//    With these, a pass over the critical vertices in increasing (decreasing) order tells how the
//    components of the sublevel (superlevel) sets merge (Chiang, Lenz, Lu, Rote, "Simple and
//    optimal output-sensitive construction of contour trees using monotone paths", 2005).
// 2. Without loops, the Reeb graph follows from these two forests (see Contour_forest). A loop is
//    closed where two components of a level set meet that belong to one component of the sublevel
//    set. Where that may be (a simple saddle at which neither forest merges anything, for example:
//    on a closed surface of genus g these are 2 g) walks along the level set find out, and the
//    surface is cut along the shorter component: then there are no loops, and every cut becomes a
//    leaf of the graph whose arc is led to the saddle of the cut in the end.
//
// Takes O(n + t log t) time for n vertices and t critical ones, and the walks, which a budget
// bounds.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Cutting_algorithm
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using Finder = Critical_node_finder<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Cuts = Loop_cuts<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Places = Vertex_assignment<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Propagation = Arc_propagation<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Paths = Monotone_paths<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;

public:
  Cutting_algorithm(const TriangleMesh& tmesh,
                    const VertexOrder& order,
                    VertexIndexMap vertex_index_map,
                    std::size_t index_bound,
                    const Vertex_classification& states,
                    const std::vector<Monotone_neighbors<TriangleMesh>>& neighbors,
                    const Reeb_graph_request& request)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_index_bound(index_bound)
    , m_states(states)
    , m_neighbors(neighbors)
    , m_request(request)
  {}

  // Returns false if the walks would take more than `budget` steps.
  bool run(std::size_t budget, Arc_list<TriangleMesh>& result)
  {
    const Finder finder(m_tmesh, m_order, m_vertex_index_map, m_states, m_request.unfolds);
    Paths descents = paths(BELOW), ascents = paths(ABOVE);
    finder.find(m_nodes, descents, ascents);

    std::vector<std::uint32_t> sequence(m_nodes.size());
    std::iota(sequence.begin(), sequence.end(), 0);
    invoke_both<ConcurrencyTag>(
        [&]() { merge_sublevel_sets(m_nodes, sequence, m_sublevel_forest); },
        [&]() { merge_superlevel_sets(sequence); });

    Cuts cuts(m_tmesh,
              m_order,
              m_nodes,
              ascents,
              m_states.has_border(),
              m_request.has_vertex_arcs,
              budget);
    const std::vector<std::uint32_t> may_have_loops = nodes_that_may_have_loops(ascents);
    if (!may_have_loops.empty() && !cuts.find_components(may_have_loops))
      return false;
    if (!may_have_loops.empty()) {
      Merge_forest forest; // the other one is needed without the cuts if there are none in the end
      if (!cuts.cut(may_have_loops, forest))
        return false;
      m_sublevel_forest = std::move(forest);
      sequence = std::move(cuts.sequence);
      if (!cuts.saddles.empty()) {
        finder.cut_ascents(m_nodes, ascents, cuts.take_cuts());
        merge_superlevel_sets(sequence);
      }
    }
    Places places(m_order, m_nodes, cuts, sequence, m_sublevel_forest, m_superlevel_forest);

    m_number_below.resize(m_nodes.size());
    m_number_above.resize(m_nodes.size());
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) {
      m_number_below[node] = m_sublevel_forest.degree(node);
      m_number_above[node] = m_superlevel_forest.degree(node);
    }
    for (const std::uint32_t saddle : cuts.saddles)
      ++m_number_below[saddle];

    for (std::uint32_t& component : m_component_of_upper_wedge) // the pruning changes the positions
      component = m_superlevel_forest.position(component);

    Contour_forest pruning(m_sublevel_forest, m_superlevel_forest);
    pruning.run(sequence,
                [&](std::uint32_t node) { return !cuts.is_leaf(node) && is_regular(node); });
    const std::vector<std::uint32_t> arc_number = write(sequence, cuts, pruning, result);
    if (m_request.has_vertex_arcs)
      find_vertex_arcs(places, descents, ascents, pruning, arc_number, result);
    return true;
  }

private:
  Paths paths(Side side) const
  {
    return Paths(side, m_tmesh, m_order, m_vertex_index_map, m_index_bound);
  }

  bool is_regular(std::uint32_t node) const
  {
    return m_number_below[node] == 1 && m_number_above[node] == 1;
  }

  // The arcs of vertices are spread from the wedges.
  bool has_wedge_arcs() const { return m_request.has_wedge_arcs || m_request.has_vertex_arcs; }

  void merge_superlevel_sets(const std::vector<std::uint32_t>& sequence)
  {
    internal::merge_superlevel_sets(m_nodes,
                                    sequence,
                                    m_superlevel_forest,
                                    has_wedge_arcs() ? &m_component_of_upper_wedge : nullptr);
  }

  // Below which nodes two components of the level set may belong to the same component of the
  // sublevel set, as far as the forests tell; in increasing order.
  //
  // Let a vertex in the interior have k lower and k upper wedges; around it they alternate, and
  // the level sets below and above it are the same elsewhere. Closed components make at most k + 1
  // together, below and above. The sublevel and superlevel sets have no more of them: if they have
  // as many, all of them are apart. A component that ends on the border changes nothing as long as
  // there is one at most.
  std::vector<std::uint32_t> nodes_that_may_have_loops(Paths& ascents) const
  {
    std::vector<std::uint32_t> result;
    std::vector<std::uint32_t> open_above;
    if (m_states.has_border())
      open_above = number_of_open_components_above(ascents);
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) {
      const std::uint32_t lower = m_nodes.lower_begin[node + 1] - m_nodes.lower_begin[node];
      const std::uint32_t upper = m_nodes.upper_begin[node + 1] - m_nodes.upper_begin[node];
      const std::uint32_t below = m_sublevel_forest.degree(node),
                          above = m_superlevel_forest.degree(node);
      if (below == lower)
        continue;
      const bool is_interior = !m_states.is_on_border(index(node));
      const bool has_open_end_at_most =
          open_above.empty() || open_above[node] == 0 || (open_above[node] == 1 && above == upper);
      if (is_interior && below + above == lower + 1 && has_open_end_at_most)
        continue;
      result.push_back(node);
    }
    return result;
  }

  // How many of the components of the superlevel set that merge at a node touch the border, or may
  // do so.
  std::vector<std::uint32_t> number_of_open_components_above(Paths& ascents) const
  {
    std::vector<bool> touches_border(m_nodes.size(), false);
    std::vector<vertex_descriptor> border;
    for (const vertex_descriptor v : CGAL::make_range(vertices(m_tmesh)))
      if (m_states.is_on_border(static_cast<std::size_t>(get(m_vertex_index_map, v))))
        border.push_back(v);
    ascents.follow(border);
    for (const vertex_descriptor v : border)
      touches_border[m_nodes.number_of_end(ascents.end_from(v))] = true;
    std::vector<std::uint32_t> result(m_nodes.size(), 0);
    for (std::uint32_t node = static_cast<std::uint32_t>(m_nodes.size()); node-- > 0;) {
      const std::uint32_t parent = m_superlevel_forest.parent(node);
      if (parent != no_node && (touches_border[node] || result[node] > 0))
        ++result[parent];
    }
    return result;
  }

  std::size_t index(std::uint32_t node) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, m_nodes.vertex[node]));
  }

  // Numbers nodes and arcs, and returns the numbers of the arcs of the contour forest.
  std::vector<std::uint32_t> write(const std::vector<std::uint32_t>& sequence,
                                   const Cuts& cuts,
                                   const Contour_forest& pruning,
                                   Arc_list<TriangleMesh>& result) const
  {
    std::vector<std::uint32_t> number(m_nodes.size(), no_node);
    std::vector<std::uint32_t> first_arc; // by number, one more than there are nodes
    std::uint32_t number_of_arcs = 0;
    for (const std::uint32_t node : sequence) {
      if (cuts.is_leaf(node) || is_regular(node))
        continue;
      number[node] = static_cast<std::uint32_t>(result.nodes.size());
      result.nodes.push_back(m_nodes.vertex[node]);
      first_arc.push_back(number_of_arcs);
      number_of_arcs += m_number_above[node];
    }
    result.arcs.resize(number_of_arcs);
    std::vector<std::uint32_t> arc_number(pruning.arcs.size());
    for (std::size_t i = 0; i < pruning.arcs.size(); ++i) {
      const Contour_forest::Arc& arc = pruning.arcs[i];
      const std::uint32_t lower = number[arc.lower];
      const std::uint32_t upper =
          number[cuts.is_leaf(arc.upper) ? cuts.saddle_of_leaf(arc.upper) : arc.upper];
      CGAL_assertion(lower < upper && upper != no_node && arc.position < m_number_above[arc.lower]);
      arc_number[i] = first_arc[lower] + arc.position;
      result.arcs[arc_number[i]] = {lower, upper};
    }

    CGAL_assertion(result.are_arcs_upward());

    if (has_wedge_arcs()) {
      for (const std::uint32_t node : sequence) {
        if (cuts.is_leaf(node) || is_regular(node) ||
            (m_number_above[node] < 2 && !m_nodes.is_unfolded(node)))
          continue;
        for (std::uint32_t w = m_nodes.upper_begin[node]; w < m_nodes.upper_begin[node + 1]; ++w)
          if (m_nodes.upper_halfedge[w] != boost::graph_traits<TriangleMesh>::null_halfedge())
            result.upper_wedges.push_back(
                {m_nodes.upper_halfedge[w],
                 first_arc[number[node]] + m_component_of_upper_wedge[w]});
      }
    }
    return arc_number;
  }

  // Finds the arcs of the vertices: from their neighbors where these tell, otherwise by the places of
  // the vertices in both forests.
  void find_vertex_arcs(Places& places,
                        Paths& descents,
                        Paths& ascents,
                        Contour_forest& pruning,
                        const std::vector<std::uint32_t>& arc_number,
                        Arc_list<TriangleMesh>& result) const
  {
    Propagation propagation(
        m_tmesh, m_order, m_vertex_index_map, m_neighbors, m_states.has_border(), result);
    const std::vector<vertex_descriptor> left =
        propagation.run(WALK_STEPS_FOR_ARCS * m_index_bound);
    if (!left.empty()) {
      places.find(left, descents, ascents);
      for (std::size_t i = 0; i < left.size(); ++i) {
        const std::uint32_t arc = pruning.arc(places.node_below[i], places.node_above[i]);
        CGAL_assertion(arc != no_arc);
        propagation.set_arc(left[i], arc_number[arc]);
      }
    }
    result.arc_of_vertex.resize(m_index_bound);
    for (std::size_t i = 0; i < m_index_bound; ++i)
      result.arc_of_vertex[i] = propagation.arc(i);
    result.set_arcs_of_nodes(m_vertex_index_map);
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const std::size_t m_index_bound;
  const Vertex_classification& m_states;
  const std::vector<Monotone_neighbors<TriangleMesh>>& m_neighbors; // for the arcs of vertices
  const Reeb_graph_request m_request;
  Nodes m_nodes;
  Merge_forest m_sublevel_forest, m_superlevel_forest;
  std::vector<std::uint32_t> m_number_below, m_number_above; // of arcs, by node
  // what an upper wedge leads to: a child of its node in the forest, later its position; only on
  // request
  std::vector<std::uint32_t> m_component_of_upper_wedge;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CUTTING_ALGORITHM_H
