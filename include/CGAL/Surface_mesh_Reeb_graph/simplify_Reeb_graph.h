// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Simplification.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The difference of values, or the fraction of the range, that a parameter gives.
template <class NamedParameters, class Tag>
double checked_threshold(const NamedParameters& np, Tag tag, const char* name)
{
  const double threshold = choose_own_parameter(np, tag, 0.);
  if (!(threshold >= 0))
    throw Input_error(std::string("the ") + name + " is negative or not a number");
  return threshold;
}

// The number of leaves asked for, the largest number if there is none.
template <class NamedParameters>
std::size_t checked_number_of_leaves(const NamedParameters& np)
{
  const auto number =
      choose_own_parameter(np, tags::number_of_leaves, (std::numeric_limits<std::size_t>::max)());
  using Number = std::decay_t<decltype(number)>;
  static_assert(std::is_integral<Number>::value, "the number of leaves is an integer");
  if constexpr (std::is_signed<Number>::value)
    if (number < 0)
      throw Input_error("the number of leaves is negative");
  return static_cast<std::size_t>(number);
}

// Throws if a parameter is wrong.
template <class NamedParameters>
Simplification_parameters simplification_parameters(const NamedParameters& np)
{
  return {
      checked_threshold(np, tags::persistence_threshold, "persistence threshold"),
      checked_threshold(np, tags::loop_persistence_threshold, "persistence threshold of the loops"),
      checked_number_of_leaves(np),
      choose_own_parameter(np, tags::threshold_is_absolute, false)};
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

simplifies a Reeb graph by cancelling its branches, and on demand its loops, of small persistence.

<b>Branches.</b> The pairs are those that `persistence_pairs()` gives: a minimum with the node where
its component of the sublevel set merges into one that has a lower minimum, and a maximum with a
node, upside down. The persistence of a pair is the difference of the two values. Pairs are
cancelled in the order of their persistence, those below the threshold and then as many more as the
number of leaves asks for. Every cancellation takes away one branch and changes no other pair and no
loop: what hung on a cancelled branch hangs on its neighbor afterwards, at the same height
(\cgalCite{agarwal_2006}). Pairs of persistence zero are always cancelled. The lowest minimum and
the highest maximum of a component always stay.

<b>Loops</b> stay unless `loop_persistence_threshold` is given. Then, after the branches, the loops
below that threshold are closed, those with the highest splits first: the cycle of the pair of split
and merge (of those that the split completes one whose highest node, the merge, lies lowest) is
folded flat, from its highest node downwards, so that points of the same height become one; what
hung on the cycle hangs on the fold, at the same height. Every closed loop makes the number of loops
smaller by exactly one, and none of persistence below the threshold is left. (Loops of infinite
persistence stay.)

- If the function is monotone on both sides of the cycle, from the merge to the split, then closing
  the loop takes away its pair and changes no other pair, neither of extrema nor of loops.
- Otherwise the cycle has peaks and valleys: nodes on it where branches or other loops leave in the
  wrong direction, and no fold is that exact. One peak after the other is folded down to the higher
  one of the valleys that are beside it then, and what is above that valley stays as a branch
  upwards. The pairs of extrema may then change, each by at most the persistence of the
  loop, and always towards smaller persistence; other loops may change as well. Loops and branches
  that fall below their thresholds thereby are taken away, too.

The nodes that stay keep their bundles, only `id` and `type` are brought up to date; the arcs are
new.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type
\tparam MutableGraph as in `compute_Reeb_graph()`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph a Reeb graph that `compute_Reeb_graph()` or this function has made from `tmesh` and
       `scalar_map`
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{persistence_threshold}
    \cgalParamDescription{pairs whose persistence is less than this are cancelled}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`}
    \cgalParamExtra{a fraction of the range of the function, for each connected component on its own (of the values of its nodes, those that are infinite left out), unless `threshold_is_absolute` is `true`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_leaves}
    \cgalParamDescription{if more leaves, nodes without an arc below or without one above, than this number are left, pairs are cancelled until no more are, or until those are left that always stay: two for every component that is not a single node}
    \cgalParamType{an integer type, not negative}
    \cgalParamDefault{no limit}
    \cgalParamExtra{Pairs of different components are compared by their persistence as a fraction of the range of their component, unless `threshold_is_absolute` is `true`. The pairs below `persistence_threshold`, 0 if it is not given, are cancelled in any case.}
  \cgalParamNEnd
  \cgalParamNBegin{loop_persistence_threshold}
    \cgalParamDescription{loops whose persistence is less than this are closed}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`: loops are never closed, not even those in a plateau}
    \cgalParamExtra{a fraction of the range of the function, as `persistence_threshold`, unless `threshold_is_absolute` is `true`}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_is_absolute}
    \cgalParamDescription{whether `persistence_threshold` and `loop_persistence_threshold` are differences of values rather than fractions of their range}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{the map that `compute_Reeb_graph()` has filled; it is brought up to date: the vertices of a cancelled branch that is a single arc go to an arc of the node that it hung on, whatever their values; those of other branches and of loops to the points of the same height}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
    \cgalParamExtra{`Reeb_arc::vertices` is brought up to date as well if it has been filled.}
  \cgalParamNEnd
  \cgalParamNBegin{face_arc_map}
    \cgalParamDescription{the map that `compute_Reeb_graph()` has filled; it is brought up to date: a face goes where a point of its old arc goes that lies as high as its middle vertex}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`, the same as for `compute_Reeb_graph()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(m log m) time for a graph with *m* nodes and arcs. To close loops, too, is proven to take
O((m + p) log<sup>2</sup> m) time at most, however long the cycles are (\cgalCite{georgiadis_2011}),
if they have *p* peaks beside the merges, which are O(m log m). No graphs are known that take more
than O(m log m), not even those that let merging change sides as often as it can. If there is
anything to bring up to date for *n* vertices or faces, O(n log m) more, or O(n log n) if
`Reeb_arc::vertices` has been filled.

\throws Error if a threshold is negative or not a number, if the number of leaves is
        negative, if a value is not a number, if the nodes or arcs of the graph are not numbered or
        the values of the nodes not sorted as `compute_Reeb_graph()` does it, or, where maps or
        `Reeb_arc::vertices` are brought up to date, if they, graph and function do not belong
        together; `graph` and the maps are then left as they were. (If there is not enough memory,
        `std::bad_alloc` is thrown, and the maps are left as they were, the graph too or empty.)

\sa `compute_Reeb_graph()`
\sa `persistence_pairs()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void simplify_Reeb_graph(const TriangleMesh& tmesh,
                         VertexScalarMap scalar_map,
                         MutableGraph& graph,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Node = internal::Node_bundle<MutableGraph>;
  using Arc = internal::Arc_bundle<MutableGraph>;
  constexpr bool has_vertex_arc_map =
      !CGAL::parameters::is_default_parameter<NamedParameters,
                                              internal::tags::vertex_arc_map_t>::value;
  constexpr bool has_face_arc_map =
      !CGAL::parameters::is_default_parameter<NamedParameters,
                                              internal::tags::face_arc_map_t>::value;

  const internal::Simplification_parameters parameters = internal::simplification_parameters(np);

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<internal::Arc_ends> ends;
  internal::read_graph(graph, nodes, arcs, ends);

  const std::vector<double> values = internal::values_of_nodes(nodes);
  internal::Simplification simplification(values, ends, parameters);
  simplification.run();
  const internal::Compacted_graph remaining =
      internal::compacted_graph(simplification.folded_graph(), nodes.size());

  std::vector<Node> remaining_nodes;
  remaining_nodes.reserve(remaining.nodes.size());
  for (std::uint32_t node : remaining.nodes)
    remaining_nodes.push_back(nodes[node]);
  std::vector<Arc> remaining_arcs(remaining.arcs.size());

  // before anything is written
  using Vertices_on_arcs = internal::Vertices_on_arcs<vertex_descriptor>;
  [[maybe_unused]] Vertices_on_arcs vertices_of_map, vertices_of_faces;
  const bool has_arc_vertices =
      std::any_of(arcs.begin(), arcs.end(), [](const Arc& arc) { return !arc.vertices.empty(); });
  if (has_arc_vertices || has_vertex_arc_map || has_face_arc_map) {
    internal::check_function(nodes, scalar_map);
    const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
    using VIM = std::decay_t<decltype(vertex_index_map)>;
    const Vertex_order<TriangleMesh, VertexScalarMap, VIM> order(
        tmesh, scalar_map, vertex_index_map);

    const auto move_to_new_arcs = [&](Vertices_on_arcs& list) {
      simplification.follow(list.points, [&](std::uint32_t i, std::uint32_t node) {
        return order(list.vertices[i], nodes[node].vertex);
      });
      for (internal::Point_on_arc& point : list.points)
        point.arc = remaining.position_of_arc[point.arc];
    };
    // The vertices of the nodes that stay belong to an arc of the node whatever their old arc
    // became. Several nodes may lie at one vertex: it belongs to an arc of the first one.
    std::vector<std::uint32_t> arc_of_node_vertex(internal::index_bound(tmesh, vertex_index_map),
                                                  internal::no_arc);
    for (std::size_t i = 0; i < remaining_nodes.size(); ++i) {
      std::uint32_t& arc = arc_of_node_vertex[get(vertex_index_map, remaining_nodes[i].vertex)];
      if (arc == internal::no_arc)
        arc = remaining.first_arc_of_node[i];
    }
    const auto move_vertices_to_new_arcs = [&](Vertices_on_arcs& list) {
      move_to_new_arcs(list);
      for (std::size_t i = 0; i < list.points.size(); ++i) {
        const std::uint32_t arc = arc_of_node_vertex[get(vertex_index_map, list.vertices[i])];
        if (arc != internal::no_arc)
          list.points[i].arc = arc;
      }
    };

    if constexpr (has_vertex_arc_map)
      internal::check_arc_numbers(vertices(tmesh),
                                  arcs.size(),
                                  internal::get_own_parameter(np, internal::tags::vertex_arc_map),
                                  "vertex");
    if constexpr (has_face_arc_map)
      internal::check_arc_numbers(faces(tmesh),
                                  arcs.size(),
                                  internal::get_own_parameter(np, internal::tags::face_arc_map),
                                  "face");

    if (has_arc_vertices) {
      Vertices_on_arcs list;
      for (std::size_t i = 0; i < arcs.size(); ++i)
        for (const vertex_descriptor v : arcs[i].vertices)
          list.add(v, i);
      move_vertices_to_new_arcs(list);
      for (std::size_t i = 0; i < list.points.size(); ++i)
        remaining_arcs[list.points[i].arc].vertices.push_back(list.vertices[i]);
      for (Arc& arc : remaining_arcs)
        std::sort(arc.vertices.begin(), arc.vertices.end(), order);
    }
    if constexpr (has_vertex_arc_map) {
      vertices_of_map = internal::read_arc_numbers<vertex_descriptor>(
          vertices(tmesh),
          internal::get_own_parameter(np, internal::tags::vertex_arc_map),
          [](vertex_descriptor v) { return v; });
      move_vertices_to_new_arcs(vertices_of_map);
    }
    if constexpr (has_face_arc_map) {
      vertices_of_faces = internal::read_arc_numbers<vertex_descriptor>(
          faces(tmesh),
          internal::get_own_parameter(np, internal::tags::face_arc_map),
          [&](face_descriptor f) { return internal::middle_vertex(f, tmesh, order); });
      move_to_new_arcs(vertices_of_faces);
    }
  }
  internal::write_graph(
      graph,
      remaining_nodes.size(),
      remaining.arcs,
      [&](std::size_t i) { return std::move(remaining_nodes[i]); },
      [&](std::size_t i) { return std::move(remaining_arcs[i]); });
  // nothing can fail any more
  if constexpr (has_vertex_arc_map)
    internal::write_arc_numbers(vertices(tmesh),
                                vertices_of_map.points,
                                internal::get_own_parameter(np, internal::tags::vertex_arc_map));
  if constexpr (has_face_arc_map)
    internal::write_arc_numbers(faces(tmesh),
                                vertices_of_faces.points,
                                internal::get_own_parameter(np, internal::tags::face_arc_map));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
