// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_FEATURE_POINTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_FEATURE_POINTS_H

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/farthest_pair.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Adds the local maxima of `values` in component c as (value, position) pairs.
template <class Eigenbasis>
void add_local_maxima(const Eigenbasis& basis,
                      std::size_t c,
                      const Eigen::VectorXd& values,
                      std::vector<std::pair<double, std::size_t>>& maxima)
{
  const auto& tmesh = basis.triangle_mesh();
  const auto& component_vertices = basis.component_vertices(c);
  for (std::size_t i = 0; i < component_vertices.size(); ++i) {
    const auto value_at = [&](std::size_t position) {
      // equal neighbors, as symmetric meshes may have them, are told apart by their positions
      return std::make_pair(values[static_cast<Eigen::Index>(position)], position);
    };
    bool is_maximum = true;
    for_each_neighbor(component_vertices[i], tmesh, [&](auto neighbor) {
      is_maximum = is_maximum && value_at(basis.position(neighbor)) < value_at(i);
    });
    if (is_maximum)
      maxima.push_back(value_at(i));
  }
}

// Of the given (value, position) pairs keeps one, with the largest value, of those that are
// neighbors. Returns their positions by decreasing value.
template <class Eigenbasis>
std::vector<std::size_t> without_neighbors(const Eigenbasis& basis,
                                           std::size_t c,
                                           std::vector<std::pair<double, std::size_t>> points)
{
  const auto& component_vertices = basis.component_vertices(c);
  std::sort(points.begin(), points.end());
  std::reverse(points.begin(), points.end());
  std::vector<bool> is_kept(component_vertices.size(), false);
  std::vector<std::size_t> result;
  for (const std::pair<double, std::size_t>& point : points) {
    bool is_taken = is_kept[point.second];
    for_each_neighbor(component_vertices[point.second], basis.triangle_mesh(), [&](auto neighbor) {
      is_taken = is_taken || is_kept[basis.position(neighbor)];
    });
    if (!is_taken) {
      is_kept[point.second] = true;
      result.push_back(point.second);
    }
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

finds the feature points of a mesh: the tips of its limbs (\cgalCite{el_khoury_2012}, Section 4.1).

In every connected component,
1. `V1` and `V2` are the two vertices with the largest diffusion distance (Eq. 8) at the large time;
2. candidates are the local maxima of the diffusion distances from `V1` and from `V2` (Eq. 10 and
   11) at the small time, that is, the vertices all of whose neighbors have a smaller distance;
3. of candidates that are neighbors the one with the largest distance is kept.

The paper asks for local minima in step 2. Far from `V1` the squared distance to `V1` is, up to a
constant, the heat that remains at the vertex itself, and that is largest on the tips: so we take
maxima, as does the method that the paper builds on. The literal reading is available as a named
parameter.

Components without eigenpairs (isolated vertices) have no feature points; all others have at least
one.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam OutputIterator a model of `OutputIterator` that holds
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param basis the eigenbasis
\param out receives the feature points, component by component, by decreasing distance
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{small_time}
    \cgalParamDescription{the time at which local details are seen; without unit, see `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{`double`}
    \cgalParamDefault{`1.5`; the paper, Section 6, recommends 1 to 2}
  \cgalParamNEnd
  \cgalParamNBegin{large_time}
    \cgalParamDescription{the time at which `V1` and `V2` are found}
    \cgalParamType{`double`}
    \cgalParamDefault{`20`, as in the paper, Section 6}
  \cgalParamNEnd
  \cgalParamNBegin{minima_as_feature_points}
    \cgalParamDescription{whether local minima are taken instead of maxima, as the paper's text says}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n k) time for *n* vertices and *k* eigenpairs, plus O(n) comparisons for the farthest pair.
That pair is exact, except on large meshes if the shape is so symmetric, or the large time so small,
that a large part of all pairs is about as long as the longest: then it is a long one.

\return the output iterator

\pre both times are finite numbers and not negative
*/
template <class TriangleMesh,
          class Eigensolver,
          class EigenfunctionNumber,
          class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator feature_points(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    OutputIterator out,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  const double small_time = internal::choose_own_parameter(np, internal::tags::small_time, 1.5);
  const double large_time = internal::choose_own_parameter(np, internal::tags::large_time, 20.);
  const bool takes_minima =
      internal::choose_own_parameter(np, internal::tags::minima_as_feature_points, false);
  CGAL_precondition(internal::is_diffusion_time(small_time));
  CGAL_precondition(internal::is_diffusion_time(large_time));

  // all of them before anything is written
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> points;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    if (basis.number_of_eigenpairs(c) == 0)
      continue;
    const auto& b = basis.basis(c);
    const std::pair<std::size_t, std::size_t> farthest = internal::farthest_pair(
        b.eigenfunctions, internal::relative_diffusion_factors(b.eigenvalues, large_time));
    const Eigen::VectorXd factors = internal::relative_diffusion_factors(b.eigenvalues, small_time);
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t origin : {farthest.first, farthest.second}) {
      Eigen::VectorXd distances =
          internal::largest_squared_distances(b.eigenfunctions, factors, {origin});
      if (takes_minima)
        distances = -distances;
      internal::add_local_maxima(basis, c, distances, candidates);
    }
    for (std::size_t i : internal::without_neighbors(basis, c, std::move(candidates)))
      points.push_back(basis.component_vertices(c)[i]);
  }
  return std::copy(points.begin(), points.end(), out);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_FEATURE_POINTS_H
