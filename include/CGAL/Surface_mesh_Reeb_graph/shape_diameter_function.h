// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_DIAMETER_FUNCTION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_DIAMETER_FUNCTION_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/mesh_segmentation.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the shape diameter function (\cgalCite{shapira_2008}): how thick the shape is at every vertex.
At the center of every face, rays in a cone around the inward normal are sent to the opposite side of the
surface, and the mean of their lengths without the outliers is taken, by `CGAL::sdf_values()` without
its postprocessing. The value of a vertex is the mean of those of its faces, weighted by their areas.

It hardly changes when the shape is bent. It is about the volume that the surface encloses: limbs are told
apart by their thickness, not by their place, so it has many extrema and is noisy.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` whose faces are oriented
        outwards
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param values receives the diameters, in the unit of the coordinates
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{cone_angle}
    \cgalParamDescription{the opening angle of the cones, in radians}
    \cgalParamType{`double`, positive and at most pi}
    \cgalParamDefault{`2 pi / 3`, as `CGAL::sdf_values()`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rays}
    \cgalParamDescription{the number of rays for every face}
    \cgalParamType{an integer, at least 1}
    \cgalParamDefault{`25`, as `CGAL::sdf_values()`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Rays that leave through a hole count as none. Faces none of whose rays meet the inner side of another
face, and degenerate ones, have no value. Vertices that have only such faces get the mean of their
neighbors, those that are next to vertices with a value first; if no vertex of a component has one, as
in a flat disc, the values are 0 there, and so they are at isolated vertices. Rays see all components,
not only their own.

Takes O(r n log n) time, in general, for *n* vertices and *r* rays.

\pre `cone_angle` is positive and at most pi, and `number_of_rays` at least 1

\throws Input_error if a face is not a triangle, or a coordinate not a finite number; all outputs are
        then left as they were
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void shape_diameter_function(const TriangleMesh& tmesh,
                             VertexScalarMap values,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Plain_kernel = CGAL::Simple_cartesian<double>;
  constexpr double pi = 3.14159265358979323846;
  const double cone_angle =
      internal::choose_own_parameter(np, internal::tags::cone_angle, 2 * pi / 3);
  const auto number_of_rays = static_cast<long long>(
      internal::choose_own_parameter(np, internal::tags::number_of_rays, 25));
  CGAL_precondition(cone_angle > 0 && cone_angle <= pi);
  CGAL_precondition(number_of_rays >= 1);
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  internal::check_triangles(tmesh);
  internal::check_halfedges(tmesh, CGAL::get_initialized_vertex_index_map(tmesh));
  internal::check_coordinates(tmesh, vertex_point_map);

  // points of any kernel as those of one that the rays can be computed with
  const auto points = get(CGAL::dynamic_vertex_property_t<Plain_kernel::Point_3>(), tmesh);
  for (vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
    const internal::Coordinates p = internal::coordinates(get(vertex_point_map, v));
    put(points, v, Plain_kernel::Point_3(p[0], p[1], p[2]));
  }
  const auto corner = [&](auto h) { return internal::coordinates(get(points, target(h, tmesh))); };
  const auto area = [&](auto h) {
    return internal::triangle_area(
        corner(h), corner(next(h, tmesh)), corner(next(next(h, tmesh), tmesh)));
  };
  double total_area = 0;
  for (auto f : CGAL::make_range(faces(tmesh)))
    total_area += area(halfedge(f, tmesh));
  const auto diameters = get(CGAL::dynamic_face_property_t<double>(), tmesh);
  constexpr double none = -1;
  if (total_area > 0)
    CGAL::sdf_values(tmesh,
                     diameters,
                     cone_angle,
                     static_cast<std::size_t>(number_of_rays),
                     false,
                     points,
                     Plain_kernel());

  const auto result = get(CGAL::dynamic_vertex_property_t<double>(), tmesh);
  std::vector<vertex_descriptor> front;
  for (vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
    double sum = 0, weight = 0;
    if (total_area > 0)
      internal::for_each_halfedge_to(v, tmesh, [&](auto h) {
        if (CGAL::is_border(h, tmesh))
          return;
        const double diameter = get(diameters, face(h, tmesh));
        if (diameter >= 0) {
          sum += area(h) * diameter;
          weight += area(h);
        }
      });
    put(result, v, weight > 0 ? sum / weight : none);
    if (weight > 0)
      front.push_back(v);
  }
  // to those without a value, ring by ring
  while (!front.empty()) {
    std::vector<vertex_descriptor> next_front;
    std::vector<double> means;
    const auto is_next = get(CGAL::dynamic_vertex_property_t<bool>(), tmesh);
    for (const vertex_descriptor v : front)
      internal::for_each_neighbor(v, tmesh, [&](vertex_descriptor w) {
        if (get(result, w) == none && !get(is_next, w)) {
          put(is_next, w, true);
          next_front.push_back(w);
        }
      });
    for (const vertex_descriptor v : next_front) {
      double sum = 0, number = 0;
      internal::for_each_neighbor(v, tmesh, [&](vertex_descriptor w) {
        if (get(result, w) != none) {
          sum += get(result, w);
          ++number;
        }
      });
      means.push_back(sum / number);
    }
    for (std::size_t i = 0; i < next_front.size(); ++i)
      put(result, next_front[i], means[i]);
    front = next_front;
  }
  for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
    put(values, v, get(result, v) == none ? 0 : get(result, v));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_DIAMETER_FUNCTION_H
