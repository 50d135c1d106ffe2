// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_EMBED_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_EMBED_REEB_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/Curve_skeleton.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Reeb_graph_curves.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The curves as the named parameters ask for them.
template <class TriangleMesh, class VertexScalarMap, class Graph, class NamedParameters>
auto reeb_graph_curves(const TriangleMesh& tmesh,
                       VertexScalarMap scalar_map,
                       const Graph& graph,
                       const NamedParameters& np)
{
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto number_of_samples = static_cast<long long>(CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_samples), 0));
  CGAL_precondition(number_of_samples >= 0);
  return Reeb_graph_curves<TriangleMesh,
                           VertexScalarMap,
                           std::decay_t<decltype(vertex_point_map)>,
                           std::decay_t<decltype(vertex_index_map)>,
                           Graph>(tmesh,
                                  scalar_map,
                                  vertex_point_map,
                                  vertex_index_map,
                                  graph,
                                  static_cast<std::size_t>(number_of_samples));
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

gives a Reeb graph its place in space: every arc becomes a polyline through the components of the
level sets that it stands for.

The points of an arc are the centroids, weighted by length, of exact contours of the function,
extended linearly over the triangles: one just above one of its vertices each, so many that the
distance between the points is about a third of the diameter of the shape there, at least 1/400 and
at most 1/60 of the diagonal of the bounding box, where the vertices are dense enough for that. An
extremum is at its critical vertex, any other node at the centroid of all contours that touch its
critical vertex. Components of level sets are followed in the graph of all details: the branches
that `simplify_Reeb_graph()` has cancelled do not pull at the line. (Where several arcs of a node
would begin with the same piece of that graph, because they hung on a cancelled branch, the node
moves to where they part.)

Centroids may lie outside the shape, and polylines zigzag where contours change fast;
`compute_curve_skeleton()` makes smooth curves inside the shape of them.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type
\tparam Graph a graph filled by `compute_Reeb_graph()`
\tparam Skeleton a model of `MutableGraph` that allows parallel edges, default constructible and
        assignable, with bundled properties that have (at least) the members of
        `Curve_skeleton_vertex` and `Curve_skeleton_edge`; for example `Curve_skeleton<TriangleMesh>`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph its Reeb graph, with the vertices of the arcs (see the named parameter
       `collect_arc_vertices` of `compute_Reeb_graph()`); it may have been simplified
\param skeleton receives the polylines; what it contained before is lost
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_samples}
    \cgalParamDescription{the number of points inside of every arc, evenly spaced on the polyline of the centroids}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{`0`: the centroids themselves}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
    \cgalParamExtra{the coordinates are used in double precision}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`, the same as for `compute_Reeb_graph()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O((n + c) log n + n p) time, in general, for *n* vertices, contours that cross *c* edges in all,
and *p* points in an arc. The method is this package's own.

\pre `number_of_samples` is not negative

\throws Input_error if the mesh is none that `compute_Reeb_graph()` takes, a coordinate is not a finite
        number, or the graph is not that of the function or has been made without the vertices of its
        arcs; `skeleton` is then left as it was

\sa `compute_curve_skeleton()`
\sa `arc_polyline()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class Graph,
          class Skeleton,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void embed_Reeb_graph(const TriangleMesh& tmesh,
                      VertexScalarMap scalar_map,
                      const Graph& graph,
                      Skeleton& skeleton,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  auto curves = internal::reeb_graph_curves(tmesh, scalar_map, graph, np);
  curves.embed();
  curves.write(skeleton);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_EMBED_REEB_GRAPH_H
