// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_FUNCTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_FUNCTIONS_H

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

inline auto heat_weights(double time)
{
  return [time](const Eigen::VectorXd& eigenvalues) {
    return factors_of(eigenvalues, [time](double lambda) { return std::exp(-time * lambda); });
  };
}

// Writes the sums of the squared eigenfunctions, in units of a component of area 1, with the weights
// that a function of the eigenvalues gives, and with one for the constant eigenfunction. Normalized
// ones are divided by the sum of all weights, so that their mean over every component is 1.
template <class Eigenbasis, class Weights, class VertexScalarMap>
void write_weighted_squares(const Eigenbasis& basis,
                            double constant_weight,
                            const Weights& weights,
                            bool normalize,
                            VertexScalarMap values)
{
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const auto& b = basis.basis(c);
    const auto& component_vertices = basis.component_vertices(c);
    Eigen::VectorXd result =
        Eigen::VectorXd::Ones(static_cast<Eigen::Index>(component_vertices.size()));
    if (b.eigenvalues.size() > 0) {
      const Eigen::VectorXd w = weights(b.eigenvalues);
      const double scale = normalize ? 1 / (constant_weight + w.sum()) : 1;
      result *= scale * constant_weight;
      for (Eigen::Index k = 0; k < w.size(); ++k)
        for (Eigen::Index i = 0; i < result.size(); ++i) {
          const double psi = static_cast<double>(b.eigenfunctions(i, k));
          result[i] += scale * b.area * w[k] * psi * psi;
        }
    }
    for (std::size_t i = 0; i < component_vertices.size(); ++i)
      put(values, component_vertices[i], result[static_cast<Eigen::Index>(i)]);
  }
}

} // namespace internal

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

computes the auto-diffusion function (\cgalCite{gebal_2009}): of the heat that is put on a vertex, what
remains there after some time, `f(v) = A sum_i exp(-t lambda_i / lambda_1) psi_i(v)^2`, where `A` is
the area of the component and the sum begins with the constant eigenfunction, whose part is 1. Heat
stays on the tips of limbs, which are maxima; the larger the time, the fewer and larger are the limbs
that are seen. It does not depend on pose and size.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param t the time, without unit, see `Laplace_Beltrami_eigenbasis`; the source paper uses the same unit
\param values receives the function, without unit; it is 1 in components without eigenpairs, such as
       isolated vertices. Every component is seen alone, and nothing flows over borders.

Takes O(n k) time for *n* vertices and *k* eigenpairs. At small times the sum needs more eigenpairs
than there are: the last factor, `exp(-t lambda_k / lambda_1)`, bounds what is missing.

\pre `t` is a finite number and not negative

\sa `heat_kernel_signature()`
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexScalarMap>
void auto_diffusion_function(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    double t,
    VertexScalarMap values)
{
  CGAL_precondition(internal::is_diffusion_time(t));
  internal::write_weighted_squares(basis, 1, internal::heat_weights(t), false, values);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the heat kernel signature (\cgalCite{sun_2009}) at one time, divided by its mean over the
component as the source paper does to make times comparable:
`f(v) = A sum_i exp(-t lambda_i / lambda_1) psi_i(v)^2 / sum_i exp(-t lambda_i / lambda_1)`, where
`A` is the area of the component and both sums begin with the constant eigenfunction. On a component
it is a multiple of `auto_diffusion_function()` at the same time, so both have the same Reeb graph.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type

\param basis the eigenbasis
\param t the time, without unit, see `Laplace_Beltrami_eigenbasis`
\param values receives the signature, without unit: its mean over every component is 1. It is 1 in
       components without eigenpairs, such as isolated vertices. Every component is seen alone, and
       nothing flows over borders.

Takes O(n k) time for *n* vertices and *k* eigenpairs.

\pre `t` is a finite number and not negative

\sa `wave_kernel_signature()`
*/
template <class TriangleMesh, class Eigensolver, class EigenfunctionNumber, class VertexScalarMap>
void heat_kernel_signature(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    double t,
    VertexScalarMap values)
{
  CGAL_precondition(internal::is_diffusion_time(t));
  internal::write_weighted_squares(basis, 1, internal::heat_weights(t), true, values);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the wave kernel signature (\cgalCite{aubry_2011}) at one energy: the probability to meet a
quantum particle of about this energy at a vertex,
`f(v) = A sum_i w_i psi_i(v)^2 / sum_i w_i` with `w_i = exp(-(e - log(lambda_i / lambda_1))^2 / (2
sigma^2))`, where `A` is the area of the component and the sums begin with the first eigenvalue that
is not zero. Small energies see the shape as a whole, large ones its details; other than the heat
kernel signature, a large energy does not see the whole as well.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param basis the eigenbasis
\param energy the energy *e*: the logarithm of an eigenvalue divided by the smallest one, so that 0 is
       that of the first eigenfunction
\param values receives the signature, without unit: its mean over every component is 1. It is 1 in
       components without eigenpairs, such as isolated vertices. Every component is seen alone.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{energy_width}
    \cgalParamDescription{`sigma`, the standard deviation of the energy, without unit}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{7 % of the range of the energies, `log(lambda_k / lambda_1)`, of the component as in the source paper; 1 if there is no range}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n k) time for *n* vertices and *k* eigenpairs.

\pre `energy` is a finite number, and `energy_width` a positive one
*/
template <class TriangleMesh,
          class Eigensolver,
          class EigenfunctionNumber,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void wave_kernel_signature(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    double energy,
    VertexScalarMap values,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr double no_width = -1;
  const double given_width =
      internal::choose_own_parameter(np, internal::tags::energy_width, no_width);
  CGAL_precondition(std::isfinite(energy));
  CGAL_precondition(given_width == no_width || (given_width > 0 && std::isfinite(given_width)));
  const auto weights = [&](const Eigen::VectorXd& eigenvalues) -> Eigen::VectorXd {
    const Eigen::Index size = eigenvalues.size(); // not zero
    double width = given_width;
    if (width == no_width) {
      constexpr double part_of_range = 0.07;
      const double range = std::log(eigenvalues[size - 1] / eigenvalues[0]);
      width = range > 0 ? part_of_range * range : 1;
    }
    Eigen::VectorXd exponents(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double x = (energy - std::log(eigenvalues[i] / eigenvalues[0])) / width;
      exponents[i] = -x * x / 2;
    }
    // the largest one has weight 1, so that they do not vanish all together
    const double largest = exponents.maxCoeff();
    Eigen::VectorXd result(size);
    for (Eigen::Index i = 0; i < size; ++i)
      result[i] = std::exp(exponents[i] - largest);
    return result;
  };
  internal::write_weighted_squares(basis, 0, weights, true, values);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_FUNCTIONS_H
