// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRA_EIGENSOLVER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRA_EIGENSOLVER_H

#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Default_solver_traits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Shift_inverted_operator.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Uniform_random_numbers.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The smallest eigenpairs of *L psi = lambda M psi* by the implicitly restarted Lanczos method of the
library <a href="https://spectralib.org">Spectra</a>, version 1.0 or later, with shift and invert:
one vector at a time.

It gives the same eigenpairs as `Block_Lanczos_eigensolver`, in several times its time on large
meshes (\ref eigenbasis_performance). The header is not among those that
`<CGAL/Surface_mesh_Reeb_graph/spectral.h>` includes, since it needs Spectra: with CMake, link to
`Spectra::Spectra`.

\tparam SolverTraits as in `Block_Lanczos_eigensolver`

\cgalModels `LaplaceBeltramiEigensolver`

\sa `Block_Lanczos_eigensolver`
*/
template <class SolverTraits = internal::Default_solver_traits>
class Spectra_eigensolver
{
public:
  /// factors *L + sigma M*, as `Block_Lanczos_eigensolver` does.
  /// \throws Numerical_error if the factorization fails
  /// \throws Interruption if the callback returns `false`
  Spectra_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                      const Eigen::VectorXd& mass,
                      double shift,
                      const Eigensolver_options& options = Eigensolver_options())
    : m_options(options)
    , m_random(options.seed)
    , m_operator((options.report_progress(0), stiffness), mass, shift)
    , m_found(m_operator.rows(), 0)
  {}

  /// returns the `number` smallest eigenpairs, or all if there are fewer, as
  /// `Block_Lanczos_eigensolver` does.
  /// \pre `number > 0`
  /// \throws Numerical_error if a linear system could not be solved
  /// \throws Interruption if the callback returns `false`
  Eigenpairs smallest(Eigen::Index number)
  {
    CGAL_precondition(number > 0);
    return m_operator.is_small_for(number) ? m_operator.dense_eigenpairs(number) : krylov(number);
  }

private:
  // The operator A, as Spectra wants it, on the vectors that are orthogonal to those found already.
  class Deflated_operator
  {
  public:
    using Scalar = double;

    explicit Deflated_operator(Spectra_eigensolver& eigensolver) : m_eigensolver(eigensolver) {}

    Eigen::Index rows() const { return m_eigensolver.m_operator.rows(); }
    Eigen::Index cols() const { return rows(); }
    void perform_op(const double* x_in, double* y_out) const
    {
      m_eigensolver.m_options.report_progress(m_eigensolver.m_progress);
      const Eigen::VectorXd x = deflated(Eigen::Map<const Eigen::VectorXd>(x_in, rows()));
      m_eigensolver.m_operator.apply(x.data(), y_out);
      Eigen::Map<Eigen::VectorXd> y(y_out, rows());
      y = deflated(y);
    }

  private:
    Eigen::VectorXd deflated(const Eigen::VectorXd& x) const
    {
      return x - m_eigensolver.m_found * (m_eigensolver.m_found.transpose() * x);
    }

    Spectra_eigensolver& m_eigensolver;
  };

  // A Krylov space holds one vector of every eigenspace: further ones of a multiple eigenvalue come
  // in by rounding only, late or never. So the space orthogonal to the vectors found is searched
  // again, until it has no eigenvalue left among those wanted.
  Eigenpairs krylov(Eigen::Index number)
  {
    constexpr Eigen::Index probes = 3;
    m_progress = 0;
    bool have_converged = m_nu.size() >= number || add_largest(number - m_nu.size(), 0.) != FAILED;
    Outcome outcome = ADDED;
    while (have_converged && outcome == ADDED) {
      m_progress = 0.5;
      outcome = add_largest(probes, m_nu[number - 1]);
      have_converged = outcome != FAILED;
    }

    number = (std::min)(number, m_nu.size());
    Eigenpairs result;
    result.have_converged = have_converged;
    result.values =
        m_nu.head(number).unaryExpr([this](double nu) { return m_operator.to_eigenvalue(nu); });
    result.vectors = m_found.leftCols(number);
    m_operator.to_eigenfunctions(result.vectors, m_nu.head(number));
    m_options.report_progress(1);
    return result;
  }

  enum Outcome { ADDED, NOTHING_ADDED, FAILED };

  // Of the `number` largest eigenvalues on the vectors orthogonal to those found, adds those above
  // `bound`.
  Outcome add_largest(Eigen::Index number, double bound)
  {
    const Eigen::Index dimension = 2 * number + 20; // of the Krylov space
    Deflated_operator deflated_operator(*this);
    Spectra::SymEigsSolver<Deflated_operator> solver(deflated_operator, number, dimension);
    Eigen::VectorXd start(m_operator.rows());
    for (Eigen::Index i = 0; i < start.size(); ++i)
      start[i] = m_random.next();
    solver.init(start.data());
    constexpr int max_restarts = 300;
    constexpr double tolerance = 1e-12;
    solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance);
    if (solver.info() != Spectra::CompInfo::Successful)
      return FAILED;
    const Eigen::Index added = (solver.eigenvalues().array() > bound).count();
    if (added == 0)
      return NOTHING_ADDED;

    Eigen::VectorXd nu(m_nu.size() + added);
    nu << m_nu, solver.eigenvalues().head(added);
    Eigen::MatrixXd vectors(m_operator.rows(), nu.size());
    vectors << m_found, solver.eigenvectors(added);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(nu.size()));
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::stable_sort(order.begin(), order.end(), [&nu](Eigen::Index i, Eigen::Index j) {
      return nu[i] > nu[j];
    });
    m_nu.resize(nu.size());
    m_found.resize(m_operator.rows(), nu.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      m_nu[static_cast<Eigen::Index>(i)] = nu[order[i]];
      m_found.col(static_cast<Eigen::Index>(i)) = vectors.col(order[i]);
    }
    return ADDED;
  }

  Eigensolver_options m_options;
  internal::Uniform_random_numbers m_random;
  internal::Shift_inverted_operator<SolverTraits> m_operator;
  Eigen::VectorXd m_nu;    // eigenvalues of A found so far, decreasing
  Eigen::MatrixXd m_found; // their eigenvectors, orthonormal
  double m_progress = 0;
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRA_EIGENSOLVER_H
