// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Branch_cancellation.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Remaining_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/read_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/write_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_reeb_graph/vertex_order.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

template <class NamedParameters>
double checked_persistence_threshold(const NamedParameters& np)
{
  const double threshold = choose_own_parameter(np, tags::persistence_threshold, 0.);
  if (!(threshold >= 0))
    throw Reeb_graph_error("the persistence threshold is negative or not a number");
  return threshold;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

simplifies a Reeb graph by cancelling its branches of small persistence.

The pairs are those of persistent homology in dimension 0: a minimum with the node where its component
of the sublevel set merges into one that has a lower minimum, and a maximum with a node, upside down. The
persistence of a pair is the difference of the two values. Pairs are cancelled in the order of their
persistence; every cancellation takes away one branch and changes no other pair and no loop: what
hung on a cancelled branch hangs on its neighbor afterwards, at the same height. Pairs of persistence
zero are always cancelled. The global minimum and maximum of a component always stay, and so do loops.

The nodes that stay keep their bundles, only `id` and `type` are brought up to date; the arcs are new.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as value
        type
\tparam MutableGraph as in `compute_reeb_graph()`
\tparam NamedParameters a sequence of \ref CGAL::Surface_mesh_reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph a Reeb graph that `compute_reeb_graph()` or this function has made from `tmesh` and
       `scalar_map`
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{persistence_threshold}
    \cgalParamDescription{pairs whose persistence is less than this are cancelled}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`}
    \cgalParamExtra{a fraction of the range of the function, for each connected component on its own (of the values of its nodes, those that are infinite left out), unless `threshold_is_absolute` is `true`}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_is_absolute}
    \cgalParamDescription{whether `persistence_threshold` is a difference of values rather than a fraction of their range}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{the map that `compute_reeb_graph()` has filled; it is brought up to date: the vertices of a cancelled branch go to the arc that it hung on}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
    \cgalParamExtra{`Reeb_arc::vertices` is brought up to date as well if it has been filled.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`, the same as for `compute_reeb_graph()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(m log m) time for a graph with *m* nodes, plus the lengths of the paths that are zipped together when
other branches hang on a cancelled one, plus O(n) for *n* vertices if there is anything to bring up to
date for them.

\throws Reeb_graph_error if the threshold is negative or not a number, if a value is not a number, or if graph and
        map do not belong together; `graph` and the map are then left as they were

\sa `compute_reeb_graph()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void simplify_reeb_graph(const TriangleMesh& tmesh,
                         VertexScalarMap scalar_map,
                         MutableGraph& graph,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Node = internal::Node_bundle<MutableGraph>;
  using Arc = internal::Arc_bundle<MutableGraph>;
  constexpr bool has_vertex_arc_map =
      !CGAL::parameters::is_default_parameter<NamedParameters,
                                              internal::tags::vertex_arc_map_t>::value;

  const double threshold = internal::checked_persistence_threshold(np);
  const bool is_absolute =
      internal::choose_own_parameter(np, internal::tags::threshold_is_absolute, false);

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<internal::Arc_ends> ends;
  internal::read_graph(graph, nodes, arcs, ends);

  const std::vector<double> values = internal::values_of_nodes(nodes);
  const std::vector<double> thresholds =
      is_absolute ? std::vector<double>(nodes.size(), threshold)
                  : internal::fractions_of_component_ranges(values, ends, threshold);

  internal::Branch_cancellation cancellation(values, ends);
  cancellation.run([&](const internal::Extremum_pair& pair) {
    return pair.persistence < thresholds[pair.extremum];
  });
  const internal::Remaining_graph remaining = internal::remaining_graph(cancellation, nodes.size());

  std::vector<Node> remaining_nodes;
  remaining_nodes.reserve(remaining.nodes.size());
  for (std::uint32_t node : remaining.nodes)
    remaining_nodes.push_back(nodes[node]);
  std::vector<Arc> remaining_arcs(remaining.arcs.size());

  const bool has_arc_vertices =
      std::any_of(arcs.begin(), arcs.end(), [](const Arc& arc) { return !arc.vertices.empty(); });
  if (has_arc_vertices || has_vertex_arc_map) {
    const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
    using VIM = std::decay_t<decltype(vertex_index_map)>;
    const Vertex_order<TriangleMesh, VertexScalarMap, VIM> order(
        tmesh, scalar_map, vertex_index_map);

    auto arc_after = [&](vertex_descriptor v, std::uint32_t arc) {
      return remaining.position_of_arc[cancellation.arc_after(
          arc, [&](std::uint32_t node) { return order(v, nodes[node].vertex); })];
    };
    // the vertices of the nodes that stay belong to an arc of the node whatever their old arc became
    std::vector<std::uint32_t> arc_of_node_vertex(internal::index_bound(tmesh, vertex_index_map),
                                                  internal::no_arc);
    for (std::size_t i = 0; i < remaining_nodes.size(); ++i)
      arc_of_node_vertex[get(vertex_index_map, remaining_nodes[i].vertex)] =
          remaining.first_arc_of_node[i];
    auto new_arc = [&](vertex_descriptor v, std::uint32_t arc) {
      const std::uint32_t arc_of_node = arc_of_node_vertex[get(vertex_index_map, v)];
      return arc_of_node == internal::no_arc ? arc_after(v, arc) : arc_of_node;
    };

    if (has_arc_vertices) {
      for (std::size_t i = 0; i < arcs.size(); ++i)
        for (const vertex_descriptor v : arcs[i].vertices)
          remaining_arcs[new_arc(v, static_cast<std::uint32_t>(i))].vertices.push_back(v);
      for (Arc& arc : remaining_arcs)
        std::sort(arc.vertices.begin(), arc.vertices.end(), order);
    }
    if constexpr (has_vertex_arc_map) {
      auto vertex_arc_map = internal::get_own_parameter(np, internal::tags::vertex_arc_map);
      using Number = typename boost::property_traits<decltype(vertex_arc_map)>::value_type;
      for (vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
        const Number arc = get(vertex_arc_map, v);
        if (arc != static_cast<Number>(null_arc) && static_cast<std::size_t>(arc) >= arcs.size())
          throw Reeb_graph_error("the vertex arc map does not belong to the Reeb graph");
      }
      for (vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
        const Number arc = get(vertex_arc_map, v);
        if (arc != static_cast<Number>(null_arc))
          put(vertex_arc_map, v, static_cast<Number>(new_arc(v, static_cast<std::uint32_t>(arc))));
      }
    }
  }
  graph = internal::make_graph<MutableGraph>(
      remaining_nodes.size(),
      remaining.arcs,
      [&](std::size_t i) { return std::move(remaining_nodes[i]); },
      [&](std::size_t i) { return std::move(remaining_arcs[i]); });
}

} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
