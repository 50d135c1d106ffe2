// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_HARMONIC_FUNCTION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_HARMONIC_FUNCTION_H

#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/flatten_extrema.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The values that make the Dirichlet energy smallest among those with the values 0 at `minima` and 1
// at `maxima`, which are positions and not empty.
inline std::vector<double> solve_Dirichlet_problem(const Eigen::SparseMatrix<double>& stiffness,
                                                   const std::vector<std::size_t>& minima,
                                                   const std::vector<std::size_t>& maxima)
{
  using Matrix = Eigen::SparseMatrix<double>;
  const Eigen::Index n = stiffness.rows();
  std::vector<double> values(static_cast<std::size_t>(n), 0.);
  std::vector<Eigen::Index> unknown(values.size(), 0); // the numbers of the unknowns
  constexpr Eigen::Index known = -1;
  for (const std::size_t i : minima)
    unknown[i] = known;
  for (const std::size_t i : maxima) {
    unknown[i] = known;
    values[i] = 1;
  }
  Eigen::Index size = 0;
  for (Eigen::Index& number : unknown)
    if (number != known)
      number = size++;

  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(static_cast<std::size_t>(stiffness.nonZeros()));
  Eigen::VectorXd right_hand_side = Eigen::VectorXd::Zero(size);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Matrix::InnerIterator it(stiffness, j); it; ++it) {
      const Eigen::Index row = unknown[static_cast<std::size_t>(it.row())];
      const Eigen::Index column = unknown[static_cast<std::size_t>(j)];
      if (row == known)
        continue;
      if (column == known)
        right_hand_side[row] -= it.value() * values[static_cast<std::size_t>(j)];
      else
        triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), it.value());
    }
  Matrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const Supernodal_Cholesky<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw Numerical_error("the operator of the harmonic function could not be factored");
  const Eigen::VectorXd solution = solver.solve(right_hand_side);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (unknown[i] != known)
      values[i] = (std::min)((std::max)(solution[unknown[i]], 0.), 1.);
  return values;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes a harmonic function with chosen minima and maxima (\cgalCite{ni_2004}): `L f = 0` with the
values 0 at the minima and 1 at the maxima, where `L` is the cotangent operator of
`Laplace_Beltrami_eigenbasis`. The function has no minimum and no maximum anywhere else, so that its
Reeb graph has only those leaves that were asked for; its loops are those of the surface.

That is exact. A harmonic function has the mean value property as long as no weight is negative; the
intrinsic Delaunay triangulation makes sure of that except on borders. What rounding (in limbs without a
chosen vertex, where the function is nearly constant) and neighbors in the mesh that are none in the
intrinsic triangulation leave of minima and maxima elsewhere is flattened in the end: values change by
no more than the persistence of what disappears, and plateaus may remain, which make no nodes.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexRange a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param minima the vertices with value 0
\param maxima the vertices with value 1
\param values receives the function, without unit, between 0 and 1. A component with maxima only is 1
       everywhere; one without maxima is 0 everywhere, such as an isolated vertex that was not chosen.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{use_intrinsic_Delaunay}
    \cgalParamDescription{whether the operator is that of the intrinsic Delaunay triangulation of the surface (\cgalCite{bobenko_2007}), whose weights are not negative in the interior}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

On borders the derivative across the border is zero (Neumann condition). A chosen vertex is not seen as
a point on a smooth surface, where a harmonic function with such a condition does not exist: the
function near it depends on the size of the triangles. Many vertices along a curve do not have this
drawback.

Takes one sparse factorization per component, O(n^1.5) time, and O(n log n) memory for *n* vertices.

\pre no vertex is in both ranges

\throws Input_error if a face is not a triangle, or a coordinate not a finite number
\throws Numerical_error if the operator cannot be factored
All outputs are then left as they were.
*/
template <class TriangleMesh,
          class MinimumRange,
          class MaximumRange,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void harmonic_function(const TriangleMesh& tmesh,
                       const MinimumRange& minima,
                       const MaximumRange& maxima,
                       VertexScalarMap values,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  const bool use_intrinsic_Delaunay =
      internal::choose_own_parameter(np, internal::tags::use_intrinsic_Delaunay, true);
  internal::check_triangles(tmesh);
  internal::check_halfedges(tmesh, CGAL::get_initialized_vertex_index_map(tmesh));
  internal::check_coordinates(tmesh, vertex_point_map);

  const internal::Mesh_components<TriangleMesh> components(tmesh);
  std::vector<std::vector<std::size_t>> component_minima(components.size()),
      component_maxima(components.size());
  for (auto v : minima)
    component_minima[components.component_of(v)].push_back(components.position_of(v));
  for (auto v : maxima)
    component_maxima[components.component_of(v)].push_back(components.position_of(v));

  std::vector<std::vector<double>> results; // all of them before anything is written
  for (std::size_t c = 0; c < components.size(); ++c) {
    const std::vector<std::size_t>&low = component_minima[c], &high = component_maxima[c];
    CGAL_precondition(std::find_first_of(low.begin(), low.end(), high.begin(), high.end()) ==
                      low.end());
    results.emplace_back(components[c].vertices.size(), low.empty() && !high.empty() ? 1. : 0.);
    if (low.empty() || high.empty())
      continue;
    const internal::Laplace_Beltrami_matrices matrices =
        internal::assemble_Laplace_Beltrami_matrices(
            tmesh, vertex_point_map, components, c, use_intrinsic_Delaunay);
    if (matrices.area > 0)
      results.back() = internal::solve_Dirichlet_problem(matrices.stiffness, low, high);
    else // there is no operator: any values without extrema elsewhere
      for (const std::size_t i : high)
        results.back()[i] = 1;
    internal::flatten_minima(tmesh, components, c, low, results.back());
    internal::flatten_maxima(tmesh, components, c, high, results.back());
  }
  for (std::size_t c = 0; c < components.size(); ++c)
    for (std::size_t i = 0; i < results[c].size(); ++i)
      put(values, components[c].vertices[i], results[c][i]);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_HARMONIC_FUNCTION_H
