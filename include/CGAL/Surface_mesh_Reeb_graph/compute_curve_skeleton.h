// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_CURVE_SKELETON_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_CURVE_SKELETON_H

#include <CGAL/Surface_mesh_Reeb_graph/Curve_skeleton.h>
#include <CGAL/Surface_mesh_Reeb_graph/embed_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes a curve skeleton: curves inside a shape, centered and smooth, that are connected as a Reeb
graph is. On a closed surface it has as many cycles as the Reeb graph, one for every handle if no
multiple saddle hides one (see the named parameter `unfold_multiple_saddles`), and it ends at the
extrema of the function, on the surface.

It begins with the curves of `embed_Reeb_graph()`, without zigzag. Where they leave the shape, the
centroids of contours are replaced by points in the middle of the solid, as seen from the contour
inwards, on the shortest way through the contours; more contours are put in between if need be. Then
in some steps all curves are moved to where

- in the plane normal to the curve the surface is as far away in a direction as in the opposite one,
  and
- the curves turn little.

Every segment of a curve that has come to be inside stays there: a point moves only as far as the
segments to its neighbors do not cross the surface, which is decided exactly.
`Curve_skeleton_edge::is_inside` tells for every segment, checked exactly again, whether it is
inside. Where no way inside has been found, as may be near nodes in thin walls, or where the surface
intersects itself, it is `false`.

Components of the mesh with a border have no inside. Their curves are centered between what there is
of the surface, in the same way, and may cross it.

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
\param skeleton receives the skeleton; what it contained before is lost
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_samples}
    \cgalParamDescription{the number of points inside of every arc, evenly spaced; more where corners may not be cut because the curve would leave the shape}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{`0`: as many as let the distance between points be about a third of the diameter of the shape there, but no less than 1/400 and no more than 1/60 of the diagonal of the bounding box}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing}
    \cgalParamDescription{how much it counts that curves turn little, as against that they are centered}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`1`}
  \cgalParamNEnd
  \cgalParamNBegin{keep_inside}
    \cgalParamDescription{whether the curves are brought and kept inside of closed components; if not, they are only centered and smoothed}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
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

Takes O((n + c) log n + s log n + n p) time, in general, for *n* vertices, contours that cross *c*
edges in all, *s* points, and *p* of these in an arc. The method is this package's own.

\pre `number_of_samples` and `smoothing` are not negative

\throws Input_error if the mesh is none that `compute_Reeb_graph()` takes, a coordinate is not a finite
        number, or the graph is not that of the function or has been made without the vertices of its
        arcs; `skeleton` is then left as it was

\sa `embed_Reeb_graph()`
\sa `Curve_skeleton`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class Graph,
          class Skeleton,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_curve_skeleton(const TriangleMesh& tmesh,
                            VertexScalarMap scalar_map,
                            const Graph& graph,
                            Skeleton& skeleton,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const double smoothing = internal::choose_own_parameter(np, internal::tags::smoothing, 1.);
  const bool keeps_inside = internal::choose_own_parameter(np, internal::tags::keep_inside, true);
  CGAL_precondition(smoothing >= 0);
  auto curves = internal::reeb_graph_curves(tmesh, scalar_map, graph, np);
  curves.make_skeleton(smoothing, keeps_inside);
  curves.write(skeleton);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMPUTE_CURVE_SKELETON_H
