// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COORDINATE_FUNCTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COORDINATE_FUNCTIONS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the height of every vertex along an axis (\cgalCite{shinagawa_1991}): the scalar product of
its position vector with the normalized axis. It depends on the pose of the shape.

\tparam TriangleMesh a model of `VertexListGraph`
\tparam Vector_3 a three-dimensional vector of a \cgal kernel
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param axis the direction of increasing height
\param values receives the heights, in the unit of the coordinates
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n) time for *n* vertices.

\pre the axis has a finite length that is not zero
*/
template <class TriangleMesh,
          class Vector_3,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void height_function(const TriangleMesh& tmesh,
                     const Vector_3& axis,
                     VertexScalarMap values,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  const internal::Coordinates a = internal::coordinates(axis);
  // scaled first, since the sum of squares may not be a number
  const double scale = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  CGAL_precondition(scale > 0 && std::isfinite(scale));
  const internal::Coordinates scaled = {a[0] / scale, a[1] / scale, a[2] / scale};
  const double length = internal::length_of(scaled);
  for (auto v : CGAL::make_range(vertices(tmesh))) {
    const internal::Coordinates p = internal::coordinates(get(vertex_point_map, v));
    put(values, v, (scaled[0] * p[0] + scaled[1] * p[1] + scaled[2] * p[2]) / length);
  }
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the distance of every vertex from the barycenter of its connected component, through space:
`f(v) = |p(v) - b|`, where `b` is the integral of the position over the surface, divided by its area.
It does not change when the shape is moved or turned; it does when it is bent.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param values receives the distances, in the unit of the coordinates
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Borders need no care. A component without area, as an isolated vertex, has the mean of its vertices as
barycenter.

Takes O(n log n) time for *n* vertices, nearly all of it to find the components.

\throws Input_error if a face is not a triangle, or a coordinate not a finite number
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void barycenter_distance_function(const TriangleMesh& tmesh,
                                  VertexScalarMap values,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using internal::Coordinates;
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  internal::check_triangles(tmesh);
  internal::check_coordinates(tmesh, vertex_point_map);
  const internal::Mesh_components<TriangleMesh> components(tmesh);
  const auto point = [&](auto v) { return internal::coordinates(get(vertex_point_map, v)); };
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Coordinates origin = point(components[c].vertices.front()); // for precision far from 0
    double weight = 0;
    Coordinates sum = {0, 0, 0}; // of differences from the origin
    const auto add = [&](const Coordinates& p, double w) {
      for (int i = 0; i < 3; ++i)
        sum[i] += w * (p[i] - origin[i]);
      weight += w;
    };
    for (auto f : components[c].faces) {
      const auto h = halfedge(f, tmesh);
      const Coordinates corners[] = {
          point(source(h, tmesh)), point(target(h, tmesh)), point(target(next(h, tmesh), tmesh))};
      const double area = internal::triangle_area(corners[0], corners[1], corners[2]);
      for (const Coordinates& corner : corners)
        add(corner, area / 3);
    }
    if (!(weight > 0))
      for (auto v : components[c].vertices)
        add(point(v), 1);
    const Coordinates barycenter = {
        origin[0] + sum[0] / weight, origin[1] + sum[1] / weight, origin[2] + sum[2] / weight};
    for (auto v : components[c].vertices)
      put(values, v, internal::distance_between(point(v), barycenter));
  }
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COORDINATE_FUNCTIONS_H
