// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Cutting_algorithm.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Sweep_algorithm.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The algorithms of `compute_Reeb_graph()`, for its named parameter `algorithm`. All of them give the
same graph.
*/
enum class Reeb_graph_algorithm {
  /// `CUTTING`, unless that would take too long: then `SWEEP`
  AUTOMATIC,
  /// goes from the critical vertices along monotone paths, and cuts the surface where loops are
  /// closed. Takes O(*n* + *t* log *t*) time for *n* vertices, *t* of which are critical, plus the
  /// lengths of the components of level sets that are cut, for which there is no good bound if
  /// there are many loops
  CUTTING,
  /// follows the components of the level set from the lowest vertex to the highest. Takes O(*n* log
  /// *n*) time, whatever the surface and the function
  SWEEP
};

namespace internal {

// Cancels the pairs of persistence zero, which only plateaus produce.
template <class TriangleMesh, class VertexIndexMap, class VertexOrder>
void cancel_zero_persistence_pairs(Arc_list<TriangleMesh>& list,
                                   const TriangleMesh& tmesh,
                                   VertexIndexMap vertex_index_map,
                                   const VertexOrder& order)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  // only equality of values matters here: they are numbered in increasing order
  std::vector<double> values(list.nodes.size(), 0.);
  for (std::size_t i = 1; i < values.size(); ++i)
    values[i] =
        values[i - 1] + (order.value(list.nodes[i - 1]) < order.value(list.nodes[i]) ? 1. : 0.);

  Branch_cancellation cancellation(values, list.arcs);
  cancellation.run([](const Extremum_pair&) { return false; });
  const Compacted_graph remaining = compacted_graph(cancellation, list.nodes.size());

  const auto arc_after = [&](std::uint32_t arc, vertex_descriptor v) {
    return remaining.position_of_arc[cancellation.arc_after(
        arc, [&](std::uint32_t node) { return order(v, list.nodes[node]); })];
  };
  if (!list.arc_of_vertex.empty()) {
    for (const vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
      std::uint32_t& arc = list.arc_of_vertex[get(vertex_index_map, v)];
      if (arc != no_arc)
        arc = arc_after(arc, v);
    }
  }
  for (auto& wedge : list.upper_wedges)
    wedge.arc = arc_after(wedge.arc, target(wedge.halfedge, tmesh));

  std::vector<vertex_descriptor> nodes;
  nodes.reserve(remaining.nodes.size());
  for (const std::uint32_t node : remaining.nodes)
    nodes.push_back(list.nodes[node]);
  list.nodes = std::move(nodes);
  list.arcs = remaining.arcs;
  if (!list.arc_of_vertex.empty())
    list.set_arcs_of_nodes(vertex_index_map);
}

// Computes the Reeb graph as lists.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
Arc_list<TriangleMesh> arc_list(const TriangleMesh& tmesh,
                                const VertexOrder& order,
                                VertexIndexMap vertex_index_map,
                                std::size_t index_bound,
                                const Vertex_classification& states,
                                const Reeb_graph_request& request,
                                Reeb_graph_algorithm algorithm)
{
  if (algorithm != Reeb_graph_algorithm::SWEEP) {
    // so many steps of walks take less time than the sweep
    const std::size_t budget = algorithm == Reeb_graph_algorithm::CUTTING
                                   ? (std::numeric_limits<std::size_t>::max)()
                                   : 4 * index_bound;
    Arc_list<TriangleMesh> result;
    Cutting_algorithm<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap> cutting(
        tmesh, order, vertex_index_map, index_bound, states, request);
    if (cutting.run(budget, result))
      return result;
  }
  const auto halfedge_index_map = CGAL::get_initialized_halfedge_index_map(tmesh);
  return Sweep_algorithm<TriangleMesh,
                         VertexOrder,
                         VertexIndexMap,
                         std::decay_t<decltype(halfedge_index_map)>>(
             tmesh, order, vertex_index_map, index_bound, halfedge_index_map, request)
      .run(sorted_vertices<ConcurrencyTag>(tmesh, order));
}

// The vertices of every arc, in increasing order.
template <class ConcurrencyTag, class TriangleMesh, class VertexIndexMap, class VertexOrder>
auto vertices_of_arcs(const Arc_list<TriangleMesh>& list,
                      const TriangleMesh& tmesh,
                      VertexIndexMap vertex_index_map,
                      const VertexOrder& order)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  std::vector<std::vector<vertex_descriptor>> result(list.arcs.size());
  for (const vertex_descriptor v : sorted_vertices<ConcurrencyTag>(tmesh, order)) {
    const std::uint32_t arc = list.arc_of_vertex[get(vertex_index_map, v)];
    if (arc != no_arc)
      result[arc].push_back(v);
  }
  return result;
}

// Writes the arcs of the faces: that of the middle vertex; if several arcs begin there, the one
// above it in the wedge that the face's highest vertex belongs to.
template <class TriangleMesh, class VertexIndexMap, class VertexOrder, class FaceArcMap>
void write_face_arcs(const Arc_list<TriangleMesh>& list,
                     const TriangleMesh& tmesh,
                     VertexIndexMap vertex_index_map,
                     const VertexOrder& order,
                     FaceArcMap face_arc_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Number = typename boost::property_traits<FaceArcMap>::value_type;

  for (const auto f : CGAL::make_range(faces(tmesh))) {
    const auto v = middle_vertex(f, tmesh, order);
    put(face_arc_map, f, static_cast<Number>(list.arc_of_vertex[get(vertex_index_map, v)]));
  }
  for (const auto& wedge : list.upper_wedges) {
    const auto v = target(wedge.halfedge, tmesh);
    const auto write = [&](halfedge_descriptor h) {
      if (!is_border(h, tmesh) && middle_vertex(face(h, tmesh), tmesh, order) == v)
        put(face_arc_map, face(h, tmesh), static_cast<Number>(wedge.arc));
    };
    // from the edge of the wedge in both directions; once around if there is nothing else
    const auto follow = [&](const auto& next_edge) {
      halfedge_descriptor h = wedge.halfedge;
      do {
        write(h);
        write(opposite(h, tmesh));
        h = next_edge(h);
      } while (h != Graph_traits::null_halfedge() && h != wedge.halfedge &&
               order(v, source(h, tmesh)));
    };
    follow([&](halfedge_descriptor h) {
      return is_border(h, tmesh) ? Graph_traits::null_halfedge() : opposite(next(h, tmesh), tmesh);
    });
    follow([&](halfedge_descriptor h) {
      return is_border(opposite(h, tmesh), tmesh) ? Graph_traits::null_halfedge()
                                                  : prev(opposite(h, tmesh), tmesh);
    });
  }
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the Reeb graph of a scalar function on a triangle mesh.

Two points of the surface belong together if they have the same value and lie in the same connected
component of their level set; the Reeb graph is what remains of the surface then. Its nodes are the
vertices of the mesh at which components of level sets appear, vanish, split or merge; its arcs are
the families of components in between (\cgalCite{el_khoury_2012}, Sections 3.3 and 5). The function
is extended linearly over the triangles; the vertices are compared by `Vertex_order`, exactly.

The mesh may have borders (the components of level sets are then open curves), several connected
components, isolated vertices (a node each) and faces without area: only its connectivity and the
values count. On a closed connected mesh of genus *g* all of whose saddles are simple the graph has
exactly *g* loops. Pairs of an extremum and a saddle of the same plateau are no features and are
cancelled: a constant function on a sphere has one minimum, one maximum and one arc.

Infinite values are ordered as such. An empty mesh gives an empty graph.

Calls for the same mesh may run in several threads at once. (For a polyhedron whose items have ids
that are not set, \cgal sets them at the first use: that call must be over before others begin.)

The result is the same for all algorithms and any number of threads; for distinct values it does not
depend on how vertices and faces are numbered either.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or, if the program is linked with \tbb (see
        `CGAL::TBB_support`), `CGAL::Parallel_tag`. Then the property maps are read by several
        threads at once.
\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type that
        can be assigned to the member `value` of the nodes as value type. The map is read several
        times for every vertex: reading must be cheap, and always give the same.
\tparam MutableGraph a model of `VertexMutableGraph`, `EdgeMutableGraph` and `VertexListGraph` that
        allows parallel edges, default constructible and assignable, with bundled properties that
        have (at least) the members of `Reeb_node` and `Reeb_arc` and are default constructible and
        copyable; for example `Reeb_graph<TriangleMesh>`, or `Reeb_graph<TriangleMesh, FT>` for
        values of type `FT`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph the Reeb graph; what it contained before is lost, a property of the whole graph
       included
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{receives for every vertex the number (`Reeb_arc::id`) of its arc. Every vertex that has an edge belongs to one arc, the vertex of a node to the first arc that begins there, or else to the first that ends there; a vertex without edges gets `null_arc`}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map: the arcs of the vertices are not written}
  \cgalParamNEnd
  \cgalParamNBegin{face_arc_map}
    \cgalParamDescription{receives for every face the number of an arc, so that the surface is parted into regions, one for every arc that is wide enough to have a face of its own. It is the arc of the face's middle vertex in the vertex order; where several arcs begin at that vertex, the one that the face reaches into above}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map: the arcs of the faces are not written}
  \cgalParamNEnd
  \cgalParamNBegin{collect_arc_vertices}
    \cgalParamDescription{whether `Reeb_arc::vertices` is filled}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{unfold_multiple_saddles}
    \cgalParamDescription{whether a multiple saddle, a vertex in the interior whose lower neighbors form three or more separate parts of the ring of all neighbors, becomes several nodes, each a simple saddle: as if the vertex were several ones, infinitesimally apart. On a closed connected surface of genus *g* the graph of any function then has exactly *g* loops; otherwise a multiple saddle may hide some. The nodes have the same `Reeb_node::vertex`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`: a vertex is one node at most}
  \cgalParamNEnd
  \cgalParamNBegin{algorithm}
    \cgalParamDescription{the algorithm; all of them give the same}
    \cgalParamType{`Reeb_graph_algorithm`}
    \cgalParamDefault{`Reeb_graph_algorithm::AUTOMATIC`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

With `AUTOMATIC` and `SWEEP` takes O(*n* log *n*) time for *n* vertices and faces at most; with
`AUTOMATIC`, O(*n* + *t* log *t*) if *t* vertices are critical and there are few loops, unless a map
or `Reeb_arc::vertices` is to be filled. At its peak it needs about 10 bytes per vertex beyond its
output for a smooth function, and up to about 50 if the function is mere noise or the surface has
many handles, if the vertices of the mesh have indices and no map is filled (\ref
Reeb_graph_performance).

\throws Error if a face is not a triangle or has the same vertex twice, if a value is not
        a number, if the faces around a vertex form several closed fans, or if the arcs cannot be
        numbered in the value type of a map; `graph` and the maps are then left as they were. (If
        there is not enough memory to write the graph, `std::bad_alloc` is thrown and the graph is
        left empty.)

\sa `simplify_Reeb_graph()`
\sa `commute_time_Reeb_graph()`
*/
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class TriangleMesh,
          class VertexScalarMap,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_Reeb_graph(const TriangleMesh& tmesh,
                        VertexScalarMap scalar_map,
                        MutableGraph& graph,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  constexpr bool has_vertex_arc_map =
      !is_default_parameter<NamedParameters, internal::tags::vertex_arc_map_t>::value;
  constexpr bool has_face_arc_map =
      !is_default_parameter<NamedParameters, internal::tags::face_arc_map_t>::value;

  internal::check_concurrency_tag<ConcurrencyTag>();
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  using VIM = std::decay_t<decltype(vertex_index_map)>;
  using Order = Vertex_order<TriangleMesh, VertexScalarMap, VIM>;

  const std::size_t index_bound = internal::index_bound(tmesh, vertex_index_map);
  internal::Vertex_classification states(index_bound);
  const bool has_no_plateaus = states.classify<ConcurrencyTag>(
      tmesh, vertex_index_map, [&](vertex_descriptor v) { return get(scalar_map, v); });
  const bool is_simple = has_no_plateaus && !states.has_faceless_edges();
  const Order order = is_simple ? Order(scalar_map, vertex_index_map, internal::No_plateaus())
                                : Order(tmesh, scalar_map, vertex_index_map);
  if (!is_simple && !states.classify<ConcurrencyTag>(
                        tmesh, vertex_index_map, [&](vertex_descriptor v) { return order.key(v); }))
    throw Input_error("the mesh has a face with the same vertex twice");

  internal::Reeb_graph_request request;
  request.unfolds =
      internal::choose_own_parameter(np, internal::tags::unfold_multiple_saddles, false);
  const bool collects_arc_vertices =
      internal::choose_own_parameter(np, internal::tags::collect_arc_vertices, false);
  request.has_vertex_arcs = has_vertex_arc_map || has_face_arc_map || collects_arc_vertices;
  request.has_wedge_arcs = has_face_arc_map;
  internal::Arc_list<TriangleMesh> list = internal::arc_list<ConcurrencyTag>(
      tmesh,
      order,
      vertex_index_map,
      index_bound,
      states,
      request,
      choose_parameter(get_parameter(np, CGAL::internal_np::algorithm),
                       Reeb_graph_algorithm::AUTOMATIC));
  if (order.has_plateaus())
    internal::cancel_zero_persistence_pairs(list, tmesh, vertex_index_map, order);

  if constexpr (has_vertex_arc_map)
    internal::check_arc_number_type(list.arcs.size(),
                                    internal::get_own_parameter(np, internal::tags::vertex_arc_map),
                                    "vertex");
  if constexpr (has_face_arc_map)
    internal::check_arc_number_type(
        list.arcs.size(), internal::get_own_parameter(np, internal::tags::face_arc_map), "face");

  using Node = internal::Node_bundle<MutableGraph>;
  using Arc = internal::Arc_bundle<MutableGraph>;
  std::vector<std::vector<vertex_descriptor>> arc_vertices;
  if (collects_arc_vertices)
    arc_vertices = internal::vertices_of_arcs<ConcurrencyTag>(list, tmesh, vertex_index_map, order);
  internal::write_graph(
      graph,
      list.nodes.size(),
      list.arcs,
      [&](std::size_t i) {
        Node node;
        node.vertex = list.nodes[i];
        node.value = order.value(list.nodes[i]);
        return node;
      },
      [&](std::size_t i) {
        Arc arc;
        if (collects_arc_vertices)
          arc.vertices = std::move(arc_vertices[i]);
        return arc;
      });
  if constexpr (has_vertex_arc_map)
    internal::write_arc_numbers(tmesh,
                                vertex_index_map,
                                list.arc_of_vertex,
                                internal::get_own_parameter(np, internal::tags::vertex_arc_map));
  if constexpr (has_face_arc_map)
    internal::write_face_arcs(list,
                              tmesh,
                              vertex_index_map,
                              order,
                              internal::get_own_parameter(np, internal::tags::face_arc_map));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H
