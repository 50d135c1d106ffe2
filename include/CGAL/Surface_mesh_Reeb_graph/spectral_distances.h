// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_DISTANCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_DISTANCES_H

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Writes `scale` times the distances of all vertices from the source.
template <class Eigenbasis, class VertexDistanceMap>
void write_distances(const Eigenbasis& basis,
                     typename Eigenbasis::vertex_descriptor source,
                     const Eigen::VectorXd& factors,
                     double scale,
                     VertexDistanceMap distances)
{
  const std::size_t source_component = basis.component(source);
  const auto& b = basis.basis(source_component);
  const Eigen::VectorXd relative =
      largest_squared_distances(b.eigenfunctions, factors, {basis.position(source)}).cwiseSqrt();
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& component_vertices = basis.component_vertices(c);
    for (std::size_t i = 0; i < component_vertices.size(); ++i)
      put(distances,
          component_vertices[i],
          c == source_component ? scale * relative[static_cast<Eigen::Index>(i)]
                                : (std::numeric_limits<double>::infinity)());
  }
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the diffusion distances (\cgalCite{el_khoury_2012}, Eq. 8) of all vertices from one at time
`t`: what `Laplace_Beltrami_eigenbasis::diffusion_distance()` returns, for all vertices in one pass
over the eigenfunctions.

Where a distance is `1e-150` times the largest one or less, which takes large times and vertices
that the first eigenfunctions do not tell apart, it may come out as 0.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param source the vertex that the distances are measured from
\param t the time, without unit, see `Laplace_Beltrami_eigenbasis`
\param distances receives the distances, without unit: 0 for the source, infinity in other
       components

Takes O(n k) time for *n* vertices and *k* eigenpairs.

\pre `t` is a finite number and not negative

\sa `commute_time_distances()`
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexDistanceMap>
void diffusion_distances(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
    double t,
    VertexDistanceMap distances)
{
  CGAL_precondition(internal::is_diffusion_time(t));
  const auto& b = basis.basis(basis.component(source));
  internal::write_distances(basis,
                            source,
                            internal::relative_diffusion_factors(b.eigenvalues, t),
                            std::exp(-t) * std::sqrt(b.area),
                            distances);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the commute-time distances (\cgalCite{el_khoury_2012}, Eq. 9) of all vertices from one:
what `Laplace_Beltrami_eigenbasis::commute_time_distance()` returns, for all vertices in one pass
over the eigenfunctions.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param source the vertex that the distances are measured from
\param distances receives the distances, without unit: 0 for the source, infinity in other
       components

Takes O(n k) time for *n* vertices and *k* eigenpairs.

\sa `biharmonic_distances()`
\sa `diffusion_distances()`
\sa `commute_time_function()`
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexDistanceMap>
void commute_time_distances(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
    VertexDistanceMap distances)
{
  const auto& b = basis.basis(basis.component(source));
  internal::write_distances(
      basis, source, internal::commute_time_factors(b.eigenvalues), std::sqrt(b.area), distances);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the biharmonic distances (\cgalCite{lipman_2010}) of all vertices from one: the square root
of `A sum_i (lambda_1 / lambda_i)^2 (psi_i(v) - psi_i(s))^2`, where `A` is the area of the component
of the source *s*. They are smooth at the source, other than geodesic distances, and the sum converges,
other than that of the commute-time distance: more eigenpairs hardly change it.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param source the vertex that the distances are measured from
\param distances receives the distances, without unit: 0 for the source, infinity in other
       components

Takes O(n k) time for *n* vertices and *k* eigenpairs.

\sa `diffusion_distances()`
\sa `commute_time_distances()`
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexDistanceMap>
void biharmonic_distances(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
    VertexDistanceMap distances)
{
  const auto& b = basis.basis(basis.component(source));
  internal::write_distances(
      basis, source, internal::biharmonic_factors(b.eigenvalues), std::sqrt(b.area), distances);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_DISTANCES_H
