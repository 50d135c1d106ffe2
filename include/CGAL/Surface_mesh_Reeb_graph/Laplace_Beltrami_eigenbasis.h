// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_LAPLACE_BELTRAMI_EIGENBASIS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_LAPLACE_BELTRAMI_EIGENBASIS_H

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/eigenpair_residuals.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The smallest eigenvalues and the eigenfunctions of the Laplace-Beltrami operator of a triangle mesh,
and the diffusion and commute-time distances that they give.

The eigenpairs are computed once, by the constructor; distances are cheap afterwards.

<b>Operator.</b> *L* is the cotangent stiffness matrix (symmetric, positive semi-definite,
`(cot a + cot b) / 2` for an edge with opposite angles *a* and *b*) and *M* the diagonal matrix of
mixed Voronoi areas (\cgalCite{meyer_2003}), which sum to the surface area. The eigenpairs solve *L
psi = lambda M psi*, the eigenfunctions are *M*-orthonormal: they have the unit of an inverse
length, eigenvalues that of an inverse area. Nothing is imposed on borders (Neumann condition). Both
matrices are made from edge lengths that are increased by the least amount, usually none, that gives
every triangle a margin in its triangle inequalities \cgalCite{sharp_2020}, so that degenerate faces
do no harm.

<b>Components.</b> Every connected component of the mesh has a basis of its own. The constant
eigenfunction of eigenvalue zero is left out: it drops out of every difference. A component with too
few vertices has all the eigenpairs that there are; one without extent, as an isolated vertex, has
none.

<b>Number of eigenpairs.</b> How many pairs are used is part of the definition of the distances, not
an accuracy. The basis is never cut inside a multiple eigenvalue, as symmetric shapes have them: it
is extended up to the next gap, unless `extend_to_gap` says otherwise. If a component has so few
vertices that all its pairs are used, those with eigenvalues more than some million times the
smallest one, which degenerate faces produce, are left out.

<b>Normalization.</b> In the distances, every component is scaled to area 1 and its eigenvalues are
divided by the smallest one (which is not zero), as the paper normalizes the spectrum. Hence
distances and times have no unit, and nothing depends on the size of the shape.

<b>Certificates.</b> Whatever the solver claims, the residual of every eigenpair is computed and
compared with the tolerance, and the only null vector of every component is the constant one.
On long or thin shapes the first eigenvalues are so small that `double` has no smaller residual relative
to them than some 1e-7: rounding the numbers of `psi` alone changes `L psi` by up to the unit roundoff
times `|L| |psi|`, and so does the rounding of the entries of *L*. There a pair is accepted, too, if its
residual is at most four times the machine epsilon relative to `|L| |psi| + lambda M |psi|`: no
computation with these numbers can tell it from an exact one. The relative residual must be at most the
root of the tolerance even so: the error of a simple eigenvalue is quadratic in the residual, and then
of the order of the tolerance. On a cylinder 10 000 times as long as its radius the residual is 4e-7, and
`lambda_1` is that of the closed form to six digits.
`residual()`, `backward_error()`, `orthonormality_error()` and `null_space_residual()` tell what was
found.

<b>Memory.</b> With `float` as the number type of the eigenfunctions the basis takes half of the
memory, and distances over the whole mesh take less time. All is computed in `double` nevertheless,
and only the eigenfunctions are rounded in the end, each value by a relative error of `6e-8` at
most; distances get an error of about `1e-7` times the largest one.

<b>Example.</b>
\cgalExample{Surface_mesh_Reeb_graph/eigenbasis.cpp}

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam Eigensolver a model of `LaplaceBeltramiEigensolver`; by default `Block_Lanczos_eigensolver`
\tparam EigenfunctionNumber the number type that the eigenfunctions are kept in: `double` (the
        default) or `float`

\sa `feature_points()`
\sa `commute_time_function()`
*/
template <class TriangleMesh,
          class Eigensolver = Block_Lanczos_eigensolver<>,
          class EigenfunctionNumber = double>
class Laplace_Beltrami_eigenbasis
{
  static_assert(std::is_same<EigenfunctionNumber, double>::value ||
                    std::is_same<EigenfunctionNumber, float>::value,
                "the number type of the eigenfunctions is double or float");

public:
  /// \name Types
  /// @{

  /// the type of the mesh
  using Triangle_mesh = TriangleMesh;
  /// the vertex descriptor of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// the number type of eigenvalues, areas, times and distances
  using FT = double;
  /// the number type that the eigenfunctions are kept in
  using Eigenfunction_number = EigenfunctionNumber;

  /// @}
  /// \name Construction
  /// @{

  /*!
  computes the eigenpairs.

  \tparam NamedParameters a sequence of
          \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

  \param tmesh the mesh; it must outlive the basis and not be changed meanwhile
  \param np an optional sequence of named parameters among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{number_of_eigenpairs}
      \cgalParamDescription{how many of the smallest non-zero eigenvalues are computed for every component, counted with multiplicity}
      \cgalParamType{an integer, at least 1}
      \cgalParamDefault{`50`, as in the paper, Section 6}
      \cgalParamExtra{there are more if the last one is multiple, and fewer if the component has too few vertices}
    \cgalParamNEnd
    \cgalParamNBegin{residual_tolerance}
      \cgalParamDescription{the largest relative residual `||L psi - lambda M psi|| / (lambda ||M psi||)` that an eigenpair may have}
      \cgalParamType{`double`}
      \cgalParamDefault{`1e-8`}
      \cgalParamExtra{A residual that rounding alone explains is accepted, too, up to the root of the tolerance, see Certificates}
    \cgalParamNEnd
    \cgalParamNBegin{use_intrinsic_Delaunay}
      \cgalParamDescription{whether the operator is made from the intrinsic Delaunay triangulation of the surface \cgalCite{bobenko_2007} instead of the faces of the mesh}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
      \cgalParamExtra{The mesh is not changed: edges are flipped in a copy that has lengths but no points, until the angles opposite to an edge inside of the surface have a sum of at most 180 degrees. Then no coefficient of *L* outside of the diagonal is positive, except for edges on a border opposite to an obtuse angle, and *L* does not depend on how flat regions are triangulated. It costs less than the assembly of the matrices, and is worth that on meshes with badly shaped faces.}
    \cgalParamNEnd
    \cgalParamNBegin{extend_to_gap}
      \cgalParamDescription{whether there are more eigenpairs than asked for if the last one is multiple, so that the basis and all distances depend on the surface only}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{accept_converged_part}
      \cgalParamDescription{whether a basis with fewer eigenpairs than asked for, possibly none, is accepted if the solver does not find all of them, some have a residual above the tolerance, or a matrix cannot be factored}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`: this is an error}
      \cgalParamExtra{The eigenpairs of the component are then those before the first one that fails, and `failure()` says why; other components are not concerned. The basis may end inside a multiple eigenvalue.}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{the seed of the random vectors that the solver starts with; equal seeds give equal results on the same machine}
      \cgalParamType{an unsigned integer}
      \cgalParamDefault{`0`}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{a function that is called from time to time with the part of the work that is done, which is in [0,1] and never decreases; it returns whether to go on}
      \cgalParamType{a type convertible to `std::function<bool(double)>`}
      \cgalParamDefault{no function}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
      \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
      \cgalParamExtra{coordinates are converted to `double` by `CGAL::to_double()`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Takes one sparse factorization for every component and some hundred solves with it, and holds
  below 2.5 kB for every vertex of a component at 50 pairs, of which the result has 0.4.

  \pre the number of eigenpairs is at least 1, and the tolerance is not negative

  \throws Input_error if a face is not a triangle, a coordinate is not a finite number, or the
          whole surface has no area
  \throws Numerical_error if the factorization fails, the eigensolver does not converge, or a
          residual is larger than the tolerance and than what rounding explains
  \throws Interruption if the callback returns `false`
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Laplace_Beltrami_eigenbasis(
      const TriangleMesh& tmesh, const NamedParameters& np = CGAL::parameters::default_values())
    : m_tmesh(&tmesh), m_components(tmesh), m_bases(m_components.size())
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;

    internal::check_triangles(tmesh);
    internal::check_halfedges(tmesh, CGAL::get_initialized_vertex_index_map(tmesh));

    const auto number_of_eigenpairs = static_cast<long long>(
        internal::choose_own_parameter(np, internal::tags::number_of_eigenpairs, 50));
    CGAL_precondition(number_of_eigenpairs >= 1);
    const double tolerance =
        internal::choose_own_parameter(np, internal::tags::residual_tolerance, 1e-8);
    CGAL_precondition(tolerance >= 0);
    const bool use_intrinsic_Delaunay =
        internal::choose_own_parameter(np, internal::tags::use_intrinsic_Delaunay, false);
    const bool extend_to_gap =
        internal::choose_own_parameter(np, internal::tags::extend_to_gap, true);
    const bool accept_converged_part =
        internal::choose_own_parameter(np, internal::tags::accept_converged_part, false);
    Eigensolver_options options;
    options.residual_tolerance = tolerance;
    options.seed = static_cast<std::uint64_t>(
        choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), 0u));
    const std::function<bool(double)> callback = choose_parameter(
        get_parameter(np, CGAL::internal_np::callback), std::function<bool(double)>());
    const auto vertex_point_map = internal::vertex_point_map(tmesh, np);

    internal::check_coordinates(tmesh, vertex_point_map);
    bool has_area = faces(tmesh).begin() == faces(tmesh).end();
    const double number_of_vertices = static_cast<double>(vertices(tmesh).size());
    double vertices_done = 0, progress = 0;
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      const double size = static_cast<double>(m_components[c].vertices.size());
      if (callback)
        options.callback = [&](double part) {
          progress = (std::max)(progress, (vertices_done + part * size) / number_of_vertices);
          return callback((std::min)(progress, 1.));
        };
      try {
        compute_basis(c,
                      vertex_point_map,
                      number_of_eigenpairs,
                      options,
                      extend_to_gap,
                      accept_converged_part,
                      use_intrinsic_Delaunay);
      } catch (const Input_error& error) {
        throw Input_error(component_name(c) + error.what());
      } catch (const Numerical_error& error) {
        if (!accept_converged_part)
          throw Numerical_error(component_name(c) + error.what());
        m_bases[c].failure = error.what();
      }
      has_area = has_area || m_bases[c].area > 0;
      vertices_done += size;
    }
    if (!has_area)
      throw Input_error("the surface has no area: all faces are single points");
  }

  /// \cond SKIP_IN_MANUAL

  // The basis refers to the mesh: a temporary one would be gone.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Laplace_Beltrami_eigenbasis(
      const TriangleMesh&&, const NamedParameters& = CGAL::parameters::default_values()) = delete;

  /// \endcond

  /// @}
  /// \name Access
  /// @{

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return *m_tmesh; }

  /// returns the number of connected components of the mesh, isolated vertices included.
  std::size_t number_of_components() const { return m_components.size(); }

  /// returns the component of `v`; components are numbered in the order of their first vertices.
  std::size_t component(vertex_descriptor v) const { return m_components.component_of(v); }

  /// returns the vertices of component `c`, in the order of the mesh.
  /// \pre `c < number_of_components()`
  const std::vector<vertex_descriptor>& component_vertices(std::size_t c) const
  {
    CGAL_precondition(c < number_of_components());
    return m_components[c].vertices;
  }

  /// returns the surface area of component `c`.
  /// \pre `c < number_of_components()`
  FT area(std::size_t c) const { return basis(c).area * basis(c).unit * basis(c).unit; }

  /// returns the number of eigenpairs of component `c`, without the constant one.
  /// \pre `c < number_of_components()`
  std::size_t number_of_eigenpairs(std::size_t c) const
  {
    return static_cast<std::size_t>(basis(c).eigenvalues.size());
  }

  /// returns why component `c` has fewer eigenpairs than it should have, if the basis was told to
  /// `accept_converged_part`; empty if it has all.
  /// \pre `c < number_of_components()`
  const std::string& failure(std::size_t c) const { return basis(c).failure; }

  /// returns the `k`-th smallest non-zero eigenvalue of component `c`, from `k == 1` on.
  /// \pre `c < number_of_components() && 1 <= k && k <= number_of_eigenpairs(c)`
  FT eigenvalue(std::size_t c, std::size_t k) const
  {
    CGAL_precondition(1 <= k && k <= number_of_eigenpairs(c));
    const Basis& basis = m_bases[c];
    return basis.eigenvalues[static_cast<Eigen::Index>(k) - 1] / basis.unit / basis.unit;
  }

  /// returns the value at `v` of the eigenfunction of the `k`-th smallest non-zero eigenvalue of
  /// its component, from `k == 1` on. Signs are chosen such that the value of largest magnitude is
  /// positive.
  /// \pre `1 <= k && k <= number_of_eigenpairs(component(v))`
  FT eigenfunction(std::size_t k, vertex_descriptor v) const
  {
    CGAL_precondition(1 <= k && k <= number_of_eigenpairs(component(v)));
    const Basis& basis = m_bases[component(v)];
    return FT(basis.eigenfunctions(m_components.position_of(v), static_cast<Eigen::Index>(k) - 1)) /
           basis.unit;
  }

  /// returns the mixed Voronoi area of `v`: its entry of the mass matrix.
  FT vertex_area(vertex_descriptor v) const
  {
    const Basis& basis = m_bases[component(v)];
    return basis.mass[m_components.position_of(v)] * basis.unit * basis.unit;
  }

  /// returns the largest relative residual `||L psi - lambda M psi|| / (lambda ||M psi||)` of all
  /// eigenpairs, before the eigenfunctions are rounded to their number type.
  FT residual() const { return m_residual; }

  /// returns the largest backward error `||L psi - lambda M psi|| / || |L| |psi| + lambda M |psi| ||`
  /// of all eigenpairs, before the eigenfunctions are rounded to their number type: how much the
  /// entries of the matrices had to change, relative to themselves, to make an eigenpair exact.
  FT backward_error() const { return m_backward_error; }

  /// returns the largest entry of `|Psi^T M Psi - I|` of all components, where the columns of `Psi`
  /// are the eigenfunctions and the constant one, before they are rounded to their number type.
  FT orthonormality_error() const { return m_orthonormality_error; }

  /// returns the largest `||L 1|| / (||L|| ||1||)` of all components, with the Frobenius norm of
  /// *L*: the constants are null vectors. The eigenvalues certify that there are no others.
  FT null_space_residual() const { return m_null_space_residual; }

  /// @}
  /// \name Distances
  /// Vertices of different components have distance infinity.
  /// @{

  /*!
  returns the diffusion distance of `u` and `v` at time `t`: the square root of
  `A sum_i exp(-2 t lambda_i / lambda_1) (psi_i(u) - psi_i(v))^2`, where `A` is the area of the
  component (\cgalCite{el_khoury_2012}, Eq. 8). It has no unit, and takes O(number of eigenpairs).
  It decreases as `exp(-t)`, and is precise until it falls below the smallest number of type `FT`,
  near `t == 700`.

  \pre `t` is a finite number and not negative

  \sa `diffusion_distances()`
  */
  FT diffusion_distance(vertex_descriptor u, vertex_descriptor v, FT t) const
  {
    CGAL_precondition(internal::is_diffusion_time(t));
    return distance(u, v, [t](const Eigen::VectorXd& lambda) {
      return internal::diffusion_factors(lambda, t);
    });
  }

  /*!
  returns the commute-time distance of `u` and `v`: the square root of
  `A sum_i lambda_1 / lambda_i (psi_i(u) - psi_i(v))^2`, where `A` is the area of the component
  (\cgalCite{el_khoury_2012}, Eq. 9). It has no unit, and takes O(number of eigenpairs).

  \sa `commute_time_distances()`
  */
  FT commute_time_distance(vertex_descriptor u, vertex_descriptor v) const
  {
    return distance(u, v, internal::commute_time_factors);
  }

  /// @}

  /// \cond SKIP_IN_MANUAL

  // What the functions of this package compute with: matrices over the positions of the vertices in
  // their components.
  struct Basis
  {
    double unit = 1; // the mean edge length; the rest is measured in it
    double area = 0;
    std::string failure;         // why there are fewer eigenpairs than there should be
    Eigen::VectorXd mass;        // n
    Eigen::VectorXd eigenvalues; // k, without zero, increasing
    Eigen::Matrix<Eigenfunction_number, Eigen::Dynamic, Eigen::Dynamic> eigenfunctions; // n x k
  };

  const Basis& basis(std::size_t c) const
  {
    CGAL_precondition(c < number_of_components());
    return m_bases[c];
  }

  std::size_t position(vertex_descriptor v) const { return m_components.position_of(v); }

  /// \endcond

private:
  // With which the message of an error begins.
  std::string component_name(std::size_t c) const
  {
    return "component " + std::to_string(c) + " (" +
           std::to_string(m_components[c].vertices.size()) + " vertices): ";
  }

  template <class VertexPointMap>
  void compute_basis(std::size_t c,
                     VertexPointMap vertex_point_map,
                     long long number_of_eigenpairs,
                     const Eigensolver_options& options,
                     bool extend_to_gap,
                     bool accept_converged_part,
                     bool use_intrinsic_Delaunay)
  {
    Basis& basis = m_bases[c];
    internal::Laplace_Beltrami_matrices matrices = internal::assemble_Laplace_Beltrami_matrices(
        *m_tmesh, vertex_point_map, m_components, c, use_intrinsic_Delaunay);
    const Eigen::Index n = matrices.mass.size();
    basis.mass = matrices.mass;
    basis.eigenfunctions.resize(n, 0);
    if (!(matrices.area > 0))
      return;
    basis.unit = matrices.unit;
    basis.area = matrices.area;
    const Eigen::Index wanted =
        static_cast<Eigen::Index>((std::min)(number_of_eigenpairs, static_cast<long long>(n) - 1));
    Eigenpairs pairs = eigenpairs(matrices, wanted, options, extend_to_gap);
    if (!pairs.have_converged) {
      std::ostringstream message;
      message.imbue(std::locale::classic());
      message << "the eigensolver did not converge: it found "
              << (std::max)(pairs.values.size() - 1, Eigen::Index(0)) << " of " << wanted
              << " eigenpairs";
      if (!accept_converged_part)
        throw Numerical_error(message.str());
      basis.failure = message.str();
    }
    take_pairs(
        basis, matrices, std::move(pairs), options.residual_tolerance, accept_converged_part);
  }

  // The `wanted` smallest eigenpairs after the one of the constant function, which comes first.
  static Eigenpairs eigenpairs(const internal::Laplace_Beltrami_matrices& matrices,
                               Eigen::Index wanted,
                               const Eigensolver_options& options,
                               bool extend_to_gap)
  {
    // half of what the smallest non-zero eigenvalue of a sphere of the same area is about: it
    // depends on no unit
    constexpr double pi = 3.14159265358979323846;
    const double shift = 0.5 * 4 * pi / matrices.area;
    Eigensolver solver(matrices.stiffness, matrices.mass, shift, options);
    const Eigen::Index n = matrices.mass.size();
    if (!extend_to_gap)
      return solver.smallest(wanted + 1);
    // one more, to see the gap behind the last one
    for (Eigen::Index number = wanted + 2;; number += (std::max)(Eigen::Index(8), number / 4)) {
      Eigenpairs pairs = solver.smallest((std::min)(number, n));
      const Eigen::Index size = number_up_to_gap(pairs.values, wanted + 1);
      if (size < pairs.values.size() || pairs.values.size() < number || !pairs.have_converged) {
        pairs.values.conservativeResize(size);
        pairs.vectors.conservativeResize(Eigen::NoChange, size);
        return pairs;
      }
    }
  }

  // How many eigenvalues to take, at least `wanted` if there are so many, such that the last one
  // taken and the first one left out are not the same multiple eigenvalue.
  static Eigen::Index number_up_to_gap(const Eigen::VectorXd& values, Eigen::Index wanted)
  {
    constexpr double smallest_gap = 1e-5;
    Eigen::Index size = (std::min)(wanted, values.size());
    while (size < values.size() && values[size] - values[size - 1] < smallest_gap * values[size])
      ++size;
    return size;
  }

  void take_pairs(Basis& basis,
                  const internal::Laplace_Beltrami_matrices& matrices,
                  Eigenpairs&& pairs,
                  double tolerance,
                  bool accept_converged_part)
  {
    Eigen::Index size = pairs.values.size();
    if (size < 2)
      return;
    // the constant function and, since the component is connected, nothing else has eigenvalue zero
    if (!(pairs.values[1] > 1e6 * std::abs(pairs.values[0])))
      throw Numerical_error("the eigenvalue zero could not be told from the others");
    const internal::Eigenpair_residuals residuals =
        internal::eigenpair_residuals(matrices.stiffness, matrices.mass, pairs);
    for (Eigen::Index i = 1; i < size; ++i) {
      if (residuals.relative[i] <= tolerance ||
          (residuals.backward[i] <= internal::attainable_backward_error &&
           residuals.relative[i] <= std::sqrt(tolerance)))
        continue;
      std::ostringstream message;
      message.imbue(std::locale::classic());
      message << "eigenpair " << i << " has the relative residual " << residuals.relative[i]
              << ", which is more than the tolerance " << tolerance;
      if (!accept_converged_part)
        throw Numerical_error(message.str());
      basis.failure = message.str();
      size = i;
    }
    for (Eigen::Index i = 1; i < size; ++i) {
      m_residual = (std::max)(m_residual, residuals.relative[i]);
      m_backward_error = (std::max)(m_backward_error, residuals.backward[i]);
    }
    m_orthonormality_error = (std::max)(
        m_orthonormality_error, internal::orthonormality_error(matrices.mass, pairs.vectors, size));
    m_null_space_residual =
        (std::max)(m_null_space_residual, internal::null_space_residual(matrices.stiffness));

    // without the constant function, and without a second matrix of this size
    basis.eigenvalues = pairs.values.segment(1, size - 1);
    for (Eigen::Index i = 1; i < size; ++i)
      pairs.vectors.col(i - 1) = pairs.vectors.col(i);
    pairs.vectors.conservativeResize(Eigen::NoChange, size - 1);
    for (Eigen::Index k = 0; k < pairs.vectors.cols(); ++k) {
      double* const psi = pairs.vectors.data() + k * pairs.vectors.rows();
      double* const end = psi + pairs.vectors.rows();
      const double largest =
          *std::max_element(psi, end, [](double x, double y) { return std::abs(x) < std::abs(y); });
      if (largest < 0)
        std::transform(psi, end, psi, std::negate<double>());
    }
    if constexpr (std::is_same<Eigenfunction_number, double>::value)
      basis.eigenfunctions = std::move(pairs.vectors);
    else
      basis.eigenfunctions = pairs.vectors.template cast<Eigenfunction_number>();
  }

  template <class Factors>
  FT distance(vertex_descriptor u, vertex_descriptor v, const Factors& factors) const
  {
    if (component(u) != component(v))
      return std::numeric_limits<FT>::infinity();
    const Basis& basis = m_bases[component(u)];
    if (basis.eigenvalues.size() == 0)
      return 0;
    const auto row = [&](vertex_descriptor w) {
      return basis.eigenfunctions.row(m_components.position_of(w)).template cast<double>();
    };
    const Eigen::VectorXd difference = row(u) - row(v);
    // the squares may be too small for a number where the distance is not
    return std::sqrt(basis.area) * difference.cwiseProduct(factors(basis.eigenvalues)).stableNorm();
  }

  const TriangleMesh* m_tmesh;
  internal::Mesh_components<TriangleMesh> m_components;
  std::vector<Basis> m_bases; // by component
  FT m_residual = 0;
  FT m_backward_error = 0;
  FT m_orthonormality_error = 0;
  FT m_null_space_residual = 0;
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_LAPLACE_BELTRAMI_EIGENBASIS_H
