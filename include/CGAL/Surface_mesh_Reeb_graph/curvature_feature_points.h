// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_CURVATURE_FEATURE_POINTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_CURVATURE_FEATURE_POINTS_H

#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// By positions: two pi minus the sum of the angles, 0 on borders.
template <class TriangleMesh, class VertexPointMap>
Eigen::VectorXd angle_defects(const TriangleMesh& tmesh,
                              VertexPointMap vertex_point_map,
                              const Mesh_components<TriangleMesh>& components,
                              std::size_t component_number)
{
  constexpr double two_pi = 6.28318530717958647692;
  const auto& component_vertices = components[component_number].vertices;
  Eigen::VectorXd result(static_cast<Eigen::Index>(component_vertices.size()));
  for (std::size_t i = 0; i < component_vertices.size(); ++i) {
    const Coordinates p = coordinates(get(vertex_point_map, component_vertices[i]));
    double angles = 0;
    bool is_on_border = false;
    for_each_halfedge_to(component_vertices[i], tmesh, [&](auto h) {
      if (CGAL::is_border(h, tmesh)) {
        is_on_border = true;
        return;
      }
      const Coordinates q = coordinates(get(vertex_point_map, source(h, tmesh)));
      const Coordinates r = coordinates(get(vertex_point_map, target(next(h, tmesh), tmesh)));
      const Coordinates a = difference_of(q, p), b = difference_of(r, p);
      angles += std::atan2(2 * triangle_area(p, q, r), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    });
    result[static_cast<Eigen::Index>(i)] = is_on_border ? 0 : two_pi - angles;
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the Gaussian curvature of a mesh, smoothed: the angle defects of the vertices (two pi minus
the sum of the angles), spread by one implicit step of heat flow, `(M + s^2 A L) f = d`, where *M* and
*L* are the matrices of `Laplace_Beltrami_eigenbasis`, `A` the area of the component, and *s* the
smoothing length. The integral of the result is that of the angle defects: on closed surfaces, 2 pi
times the Euler characteristic.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param values receives the curvature, in units of that of a sphere with the same area as the component:
       it has no unit, and on a sphere it is 1. It is 0 in components without area.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{smoothing_length}
    \cgalParamDescription{`s`, in units of the square root of the area of the component: what is smaller is noise}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0.05`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

On borders the angle defect is that of the border, not of the surface, and counts as 0.

Takes one sparse factorization per component, O(n^1.5) time, and O(n log n) memory for *n* vertices.

\pre `smoothing_length` is a finite number and not negative

\throws Input_error if a face is not a triangle, or a coordinate not a finite number
\throws Numerical_error if the operator cannot be factored
All outputs are then left as they were.

\sa `curvature_feature_points()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void Gaussian_curvature_function(const TriangleMesh& tmesh,
                                 VertexScalarMap values,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr double four_pi = 12.5663706143591729539;
  const double length = internal::choose_own_parameter(np, internal::tags::smoothing_length, 0.05);
  CGAL_precondition(length >= 0 && std::isfinite(length));
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  internal::check_triangles(tmesh);
  internal::check_halfedges(tmesh, CGAL::get_initialized_vertex_index_map(tmesh));
  internal::check_coordinates(tmesh, vertex_point_map);

  const internal::Mesh_components<TriangleMesh> components(tmesh);
  std::vector<Eigen::VectorXd> results; // all of them before anything is written
  for (std::size_t c = 0; c < components.size(); ++c) {
    const internal::Laplace_Beltrami_matrices matrices =
        internal::assemble_Laplace_Beltrami_matrices(tmesh, vertex_point_map, components, c, true);
    results.push_back(Eigen::VectorXd::Zero(matrices.mass.size()));
    if (!(matrices.area > 0))
      continue;
    Eigen::SparseMatrix<double> matrix = length * length * matrices.area * matrices.stiffness;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      matrix.coeffRef(i, i) += matrices.mass[i]; // every diagonal entry is stored
    const Supernodal_Cholesky<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
      throw Numerical_error("the operator of the smoothed curvature could not be factored");
    const Eigen::VectorXd defects = internal::angle_defects(tmesh, vertex_point_map, components, c);
    results.back() = matrices.area / four_pi * solver.solve(defects);
  }
  for (std::size_t c = 0; c < components.size(); ++c)
    for (std::size_t i = 0; i < components[c].vertices.size(); ++i)
      put(values, components[c].vertices[i], results[c][static_cast<Eigen::Index>(i)]);
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

finds feature points by Gaussian curvature (\cgalCite{mortara_2002}): of every connected region where
`Gaussian_curvature_function()` exceeds a threshold, the vertex where it is largest. These are the tips
of pointed limbs. The mapping function of that paper is the distance from them, which
`geodesic_distance_function()` computes with these points as sources.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam OutputIterator a model of `OutputIterator` that holds
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param out receives the feature points, in the order of the mesh
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{curvature_threshold}
    \cgalParamDescription{the threshold, in units of the curvature of a sphere with the same area as the component}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{`8`}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing_length}
    \cgalParamDescription{as in `Gaussian_curvature_function()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0.05`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

A component that is nowhere curved that much, such as a sphere or a flat disc, has no feature points.

Takes the time of `Gaussian_curvature_function()`.

\return the output iterator

\pre `curvature_threshold` is positive

\throws Error as `Gaussian_curvature_function()`; nothing is written then
*/
template <class TriangleMesh,
          class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator
curvature_feature_points(const TriangleMesh& tmesh,
                         OutputIterator out,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const double threshold =
      internal::choose_own_parameter(np, internal::tags::curvature_threshold, 8.);
  CGAL_precondition(threshold > 0);
  const auto curvature = get(CGAL::dynamic_vertex_property_t<double>(), tmesh);
  const auto is_seen = get(CGAL::dynamic_vertex_property_t<bool>(), tmesh);
  Gaussian_curvature_function(tmesh, curvature, np);
  for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
    put(is_seen, v, !(get(curvature, v) > threshold));

  std::vector<vertex_descriptor> points, waiting;
  for (vertex_descriptor first : CGAL::make_range(vertices(tmesh))) {
    if (get(is_seen, first))
      continue;
    vertex_descriptor highest = first;
    put(is_seen, first, true);
    waiting.push_back(first);
    while (!waiting.empty()) {
      const vertex_descriptor v = waiting.back();
      waiting.pop_back();
      if (get(curvature, v) > get(curvature, highest))
        highest = v;
      internal::for_each_neighbor(v, tmesh, [&](vertex_descriptor neighbor) {
        if (!get(is_seen, neighbor)) {
          put(is_seen, neighbor, true);
          waiting.push_back(neighbor);
        }
      });
    }
    points.push_back(highest);
  }
  return std::copy(points.begin(), points.end(), out);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_CURVATURE_FEATURE_POINTS_H
