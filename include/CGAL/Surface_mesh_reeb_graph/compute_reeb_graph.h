// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Branch_cancellation.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Remaining_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Sweep.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/sorted_vertices.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/write_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_reeb_graph/vertex_order.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Cancels the pairs of persistence zero, which only plateaus produce.
template <class Vertex, class VertexIndexMap, class VertexOrder>
void cancel_zero_persistence_pairs(Arc_list<Vertex>& list,
                                   const std::vector<Vertex>& sorted_vertices,
                                   VertexIndexMap vertex_index_map,
                                   const VertexOrder& order)
{
  // only equality of values matters here: they are numbered in increasing order
  std::vector<double> values(list.nodes.size(), 0.);
  for (std::size_t i = 1; i < values.size(); ++i)
    values[i] =
        values[i - 1] + (order.value(list.nodes[i - 1]) < order.value(list.nodes[i]) ? 1. : 0.);

  Branch_cancellation cancellation(values, list.arcs);
  cancellation.run([](const Extremum_pair&) { return false; });
  const Remaining_graph remaining = remaining_graph(cancellation, list.nodes.size());

  std::uint32_t next_node = 0; // the first node that is not below the vertex
  for (const Vertex v : sorted_vertices) {
    if (next_node < list.nodes.size() && list.nodes[next_node] == v)
      ++next_node;
    std::uint32_t& arc = list.arc_of_vertex[get(vertex_index_map, v)];
    if (arc != no_arc)
      arc = remaining.position_of_arc[cancellation.arc_after(
          arc, [&](std::uint32_t node) { return next_node <= node; })];
  }
  std::vector<Vertex> nodes;
  nodes.reserve(remaining.nodes.size());
  for (std::size_t i = 0; i < remaining.nodes.size(); ++i) {
    nodes.push_back(list.nodes[remaining.nodes[i]]);
    list.arc_of_vertex[get(vertex_index_map, nodes.back())] = remaining.first_arc_of_node[i];
  }
  list.nodes = std::move(nodes);
  list.arcs = remaining.arcs;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the Reeb graph of a scalar function on a triangle mesh.

Two points of the surface belong together if they have the same value and lie in the same connected
component of their level set; the Reeb graph is what remains of the surface then. Its nodes are the
vertices of the mesh at which components of level sets appear, vanish, split or merge; its arcs are the
families of components in between (\cgalCite{el_khoury_2012}, Sections 3.3 and 5). The function is extended
linearly over the triangles; the vertices are compared by `Vertex_order`, exactly.

The mesh may have borders (the components of level sets are then open curves), several connected
components, isolated vertices (a node each) and degenerate faces: only its connectivity and the
values count. On a closed connected mesh of genus *g* all of whose saddles are simple the graph has
exactly *g* loops. Pairs of an extremum and a saddle of the same plateau are no features and are
cancelled: a constant function on a sphere has one minimum, one maximum and one arc.

Infinite values are ordered as such. An empty mesh gives an empty graph.

Calls for the same mesh may run in several threads at once. (For a polyhedron whose items have ids that are not set,
\cgal sets them at the first use: that call must be over before others begin.)

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type that can
        be assigned to the member `value` of the nodes as value type. The map is read several times for
        every vertex: reading must be cheap, and always give the same.
\tparam MutableGraph a model of `VertexMutableGraph`, `EdgeMutableGraph` and `VertexListGraph` that
        allows parallel edges, default constructible and assignable, with bundled properties that have
        (at least) the members of `Reeb_node` and `Reeb_arc` and are default constructible and copyable;
        for example `Reeb_graph<TriangleMesh>`, or `Reeb_graph<TriangleMesh, FT>` for values of type `FT`
\tparam NamedParameters a sequence of \ref CGAL::Surface_mesh_reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph the Reeb graph; what it contained before is lost, a property of the whole graph included
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{receives for every vertex the number (`Reeb_arc::id`) of its arc. Every vertex that has an edge belongs to one arc, the vertex of a node to the first arc that begins there, or else to the first that ends there; a vertex without edges gets `null_arc`}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map: the arcs of the vertices are not written}
  \cgalParamNEnd
  \cgalParamNBegin{collect_arc_vertices}
    \cgalParamDescription{whether `Reeb_arc::vertices` is filled}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n log n) time for *n* vertices, plus the time to walk along the shorter components at every saddle,
and about 40 bytes per vertex while it runs if the vertices and halfedges of the mesh have indices.

\pre `CGAL::is_triangle_mesh(tmesh)`

\throws Reeb_graph_error if a face is not a triangle, if a value is not a number, if the faces around a vertex form several closed fans, or
        if the arcs cannot be numbered in the value type of the map; `graph` and the map are then left
        as they were

\sa `simplify_reeb_graph()`
\sa `commute_time_reeb_graph()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_reeb_graph(const TriangleMesh& tmesh,
                        VertexScalarMap scalar_map,
                        MutableGraph& graph,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using CGAL::parameters::is_default_parameter;

  internal::check_triangles(tmesh);

  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto halfedge_index_map = CGAL::get_initialized_halfedge_index_map(tmesh);
  using VIM = std::decay_t<decltype(vertex_index_map)>;
  using HIM = std::decay_t<decltype(halfedge_index_map)>;

  const Vertex_order<TriangleMesh, VertexScalarMap, VIM> order(tmesh, scalar_map, vertex_index_map);
  const std::vector<vertex_descriptor> sorted_vertices =
      internal::sorted_vertices(tmesh, order, vertex_index_map);

  internal::Arc_list<vertex_descriptor> list =
      internal::Sweep<TriangleMesh, VIM, HIM>(
          tmesh, sorted_vertices, vertex_index_map, halfedge_index_map)
          .run();
  if (order.has_plateaus())
    internal::cancel_zero_persistence_pairs(list, sorted_vertices, vertex_index_map, order);

  if constexpr (!is_default_parameter<NamedParameters, internal::tags::vertex_arc_map_t>::value)
    internal::check_arc_number_type(
        list.arcs.size(), internal::get_own_parameter(np, internal::tags::vertex_arc_map));

  std::vector<internal::Node_bundle<MutableGraph>> nodes(list.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].vertex = list.nodes[i];
    nodes[i].value = order.value(list.nodes[i]);
  }
  std::vector<internal::Arc_bundle<MutableGraph>> arcs(list.arcs.size());
  internal::number_and_classify(nodes, arcs, list.arcs);
  if (internal::choose_own_parameter(np, internal::tags::collect_arc_vertices, false)) {
    for (const vertex_descriptor v : sorted_vertices) {
      const std::uint32_t arc = list.arc_of_vertex[get(vertex_index_map, v)];
      if (arc != internal::no_arc)
        arcs[arc].vertices.push_back(v);
    }
  }

  internal::write_graph(graph, std::move(nodes), std::move(arcs), list.arcs);
  if constexpr (!is_default_parameter<NamedParameters, internal::tags::vertex_arc_map_t>::value) {
    auto vertex_arc_map = internal::get_own_parameter(np, internal::tags::vertex_arc_map);
    internal::write_arc_numbers(
        sorted_vertices, vertex_index_map, list.arc_of_vertex, vertex_arc_map);
  }
}

} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H
