// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_FUNCTION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_FUNCTION_H

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Default_solver_traits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// To the nearest of the rows, zero if there are none.
template <class Matrix>
Eigen::VectorXd smallest_squared_distances(const Matrix& columns,
                                           const Eigen::VectorXd& factors,
                                           const std::vector<std::size_t>& sources)
{
  if (sources.empty())
    return Eigen::VectorXd::Zero(columns.rows());
  Eigen::VectorXd result = largest_squared_distances(columns, factors, {sources.front()});
  for (std::size_t i = 1; i < sources.size(); ++i)
    result = result.cwiseMin(largest_squared_distances(columns, factors, {sources[i]}));
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the commute-time mapping function (\cgalCite{el_khoury_2012}, Eq. 12): the largest
commute-time distance of a vertex to the feature points of its component,
`F(v) = max_i d_C(v, V_i)`. It is smallest in the center of the shape and largest on the tips of its
limbs, and does not depend on pose and size. On demand it is the distance to the nearest feature point,
`F(v) = min_i d_C(v, V_i)`, as the text of the paper says in another place; that is smallest on the
tips, and largest in between.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexRange a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param basis the eigenbasis
\param points the feature points, for example those of `feature_points()`
\param values receives the function, without unit; it is 0 in components without feature points
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{use_nearest_feature_point}
    \cgalParamDescription{whether the smallest distance is taken instead of the largest one}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n k m) time for *n* vertices, *k* eigenpairs and *m* feature points.

\sa `feature_points()`
\sa `commute_time_Reeb_graph()`
*/
template <class TriangleMesh,
          class Eigensolver,
          class EigenfunctionNumber,
          class VertexRange,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void commute_time_function(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    const VertexRange& points,
    VertexScalarMap values,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  const bool takes_nearest =
      internal::choose_own_parameter(np, internal::tags::use_nearest_feature_point, false);
  std::vector<std::vector<std::size_t>> sources(basis.number_of_components());
  for (auto v : points)
    sources[basis.component(v)].push_back(basis.position(v));

  std::vector<Eigen::VectorXd> distances; // all of them before anything is written
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& b = basis.basis(c);
    const Eigen::VectorXd factors = internal::commute_time_factors(b.eigenvalues);
    const Eigen::VectorXd squared_distances =
        takes_nearest ? internal::smallest_squared_distances(b.eigenfunctions, factors, sources[c])
                      : internal::largest_squared_distances(b.eigenfunctions, factors, sources[c]);
    distances.push_back((b.area * squared_distances).cwiseSqrt());
  }
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& component_vertices = basis.component_vertices(c);
    for (std::size_t i = 0; i < component_vertices.size(); ++i)
      put(values, component_vertices[i], distances[c][static_cast<Eigen::Index>(i)]);
  }
}

namespace internal {

// The whole method; returns the feature points.
template <class TriangleMesh, class VertexScalarMap, class NamedParameters>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
write_commute_time_function(const TriangleMesh& tmesh,
                            VertexScalarMap values,
                            const NamedParameters& np)
{
  using Solver_traits =
      typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::sparse_linear_solver_t,
                                                         NamedParameters,
                                                         Default_solver_traits>::type;

  const Laplace_Beltrami_eigenbasis<TriangleMesh, Block_Lanczos_eigensolver<Solver_traits>> basis(
      tmesh, np);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> points;
  if constexpr (CGAL::parameters::is_default_parameter<NamedParameters,
                                                       tags::feature_points_t>::value)
  {
    feature_points(basis, std::back_inserter(points), np);
  } else {
    const auto given = get_own_parameter(np, tags::feature_points);
    points.assign(given.begin(), given.end());
  }
  commute_time_function(basis, points, values, np);
  return points;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the commute-time mapping function of \cgalCite{el_khoury_2012} in one call, from the mesh:
the eigenbasis, the feature points, and the function.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param values receives the function, without unit; it is 0 in components without feature points
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_eigenpairs}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`, whose other named parameters are read, too}
    \cgalParamType{an integer, at least 1}
    \cgalParamDefault{`50`}
  \cgalParamNEnd
  \cgalParamNBegin{small_time}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`1.5`}
  \cgalParamNEnd
  \cgalParamNBegin{large_time}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`20`}
  \cgalParamNEnd
  \cgalParamNBegin{minima_as_feature_points}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{feature_points}
    \cgalParamDescription{feature points of the user instead of those of `feature_points()`, whose parameters have no effect then}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`; it is copied}
    \cgalParamDefault{those of `feature_points()`}
  \cgalParamNEnd
  \cgalParamNBegin{use_nearest_feature_point}
    \cgalParamDescription{whether the smallest distance to a feature point is taken instead of the largest one}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{receives the feature points}
    \cgalParamType{a model of `OutputIterator` that holds `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{`CGAL::Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{an object of the type that factors and solves the linear systems; only its type counts}
    \cgalParamType{a class model of `SparseLinearAlgebraWithFactorTraits_d`}
    \cgalParamDefault{the default of `Laplace_Beltrami_eigenbasis`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Nearly all of the time is that of the eigenbasis.

\throws Error as `Laplace_Beltrami_eigenbasis`; all outputs are then left as they were
\throws Interruption if the callback returns `false`; all outputs are then left as they were

\sa `commute_time_Reeb_graph()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void commute_time_function(const TriangleMesh& tmesh,
                           VertexScalarMap values,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto points = internal::write_commute_time_function(tmesh, values, np);
  if constexpr (!CGAL::parameters::is_default_parameter<
                    NamedParameters,
                    CGAL::internal_np::output_iterator_t>::value)
    std::copy(points.begin(),
              points.end(),
              CGAL::parameters::get_parameter(np, CGAL::internal_np::output_iterator));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_FUNCTION_H
