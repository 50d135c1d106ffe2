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
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/compute_arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Reeb_graph_request.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_zero_persistence_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
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
  const bool collects_arc_vertices =
      internal::choose_own_parameter(np, internal::tags::collect_arc_vertices, false);
  const bool has_vertex_arcs = has_vertex_arc_map || has_face_arc_map || collects_arc_vertices;
  internal::Vertex_classification states(internal::index_bound(tmesh, vertex_index_map));
  std::vector<internal::Monotone_neighbors<TriangleMesh>> neighbors;
  const auto order = internal::classify_vertices<ConcurrencyTag>(
      tmesh, scalar_map, vertex_index_map, states, has_vertex_arcs ? &neighbors : nullptr);

  const Reeb_graph_algorithm algorithm = choose_parameter(
      get_parameter(np, CGAL::internal_np::algorithm), Reeb_graph_algorithm::AUTOMATIC);
  internal::Reeb_graph_request request;
  request.unfolds =
      internal::choose_own_parameter(np, internal::tags::unfold_multiple_saddles, false);
  request.has_vertex_arcs = has_vertex_arcs;
  request.has_wedge_arcs = has_face_arc_map;
  request.may_cut = algorithm != Reeb_graph_algorithm::SWEEP;
  request.may_sweep = algorithm != Reeb_graph_algorithm::CUTTING;
  auto list = internal::check_mesh_on_internal_error(tmesh, vertex_index_map, [&]() {
    return internal::compute_arc_list<ConcurrencyTag>(
        tmesh, order, vertex_index_map, states, neighbors, request);
  });
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
    internal::check_mesh_on_internal_error(tmesh, vertex_index_map, [&]() {
      internal::write_face_arcs(list,
                                tmesh,
                                vertex_index_map,
                                order,
                                internal::get_own_parameter(np, internal::tags::face_arc_map));
    });
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_REEB_GRAPH_H
