// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Of all components.
template <class Eigenbasis>
std::size_t largest_number_of_eigenpairs(const Eigenbasis& basis)
{
  std::size_t result = 0;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    result = (std::max)(result, basis.number_of_eigenpairs(c));
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the height of every vertex along an axis (Shinagawa and Kunii 1991): the scalar product of
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
  const Eigen::Vector3d a(
      CGAL::to_double(axis.x()), CGAL::to_double(axis.y()), CGAL::to_double(axis.z()));
  const double length = a.stableNorm();
  CGAL_precondition(length > 0 && std::isfinite(length));
  const Eigen::Vector3d direction = a / length;
  for (auto v : CGAL::make_range(vertices(tmesh))) {
    const auto& p = get(vertex_point_map, v);
    put(values,
        v,
        direction.dot(Eigen::Vector3d(
            CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()))));
  }
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

writes the eigenfunction of the `k`-th smallest non-zero eigenvalue, of every component its own.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param k the number of the eigenfunction, from 1 on
\param values receives the eigenfunction, in the unit of an inverse length; it is 0 in components
       with fewer than `k` eigenpairs

Takes O(n) time for *n* vertices.

\pre `k` is at least 1, and some component has `k` eigenpairs
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexScalarMap>
void eigenfunction(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    std::size_t k,
    VertexScalarMap values)
{
  CGAL_precondition(1 <= k && k <= internal::largest_number_of_eigenpairs(basis));
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    for (auto v : basis.component_vertices(c))
      put(values, v, k <= basis.number_of_eigenpairs(c) ? basis.eigenfunction(k, v) : 0.);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the commute-time mapping function (\cgalCite{el_khoury_2012}, Eq. 12): the largest
commute-time distance of a vertex to the feature points of its component,
`F(v) = max_i d_C(v, V_i)`. It is smallest in the center of the shape and largest on the tips of its
limbs, and does not depend on pose and size.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexRange a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param points the feature points, for example those of `feature_points()`
\param values receives the function, without unit; it is 0 in components without feature points

Takes O(n k m) time for *n* vertices, *k* eigenpairs and *m* feature points.

\sa `feature_points()`
\sa `commute_time_Reeb_graph()`
*/
template <class TriangleMesh,
          class Eigensolver,
          class EigenfunctionNumber,
          class VertexRange,
          class VertexScalarMap>
void commute_time_function(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    const VertexRange& points,
    VertexScalarMap values)
{
  std::vector<std::vector<std::size_t>> sources(basis.number_of_components());
  for (auto v : points)
    sources[basis.component(v)].push_back(basis.position(v));

  std::vector<Eigen::VectorXd> distances; // all of them before anything is written
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& b = basis.basis(c);
    distances.push_back(
        (b.area * internal::largest_squared_distances(
                      b.eigenfunctions, internal::commute_time_factors(b.eigenvalues), sources[c]))
            .cwiseSqrt());
  }
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& component_vertices = basis.component_vertices(c);
    for (std::size_t i = 0; i < component_vertices.size(); ++i)
      put(values, component_vertices[i], distances[c][static_cast<Eigen::Index>(i)]);
  }
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H
