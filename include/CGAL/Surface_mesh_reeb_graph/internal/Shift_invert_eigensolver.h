// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SHIFT_INVERT_EIGENSOLVER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SHIFT_INVERT_EIGENSOLVER_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Laplace_beltrami_matrices.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

struct Eigenpairs
{
  Eigen::VectorXd values;  // increasing
  Eigen::MatrixXd vectors; // a column per value, M-orthonormal
};

// Smallest eigenpairs of `L psi = lambda M psi`, by shift and invert: the largest eigenvalues nu of
// `A = M^1/2 (L + sigma M)^-1 M^1/2` are `1 / (lambda + sigma)`. The shift is half of what the smallest
// non-zero eigenvalue of a sphere of the same area is about, so that it depends on no unit.
// Vertices without area (mass 0) are allowed.
template <class SolverTraits>
class Shift_invert_eigensolver
{
  using Matrix = typename SolverTraits::Matrix;
  using Vector = typename SolverTraits::Vector;

public:
  // The type of the operator's numbers, for Spectra.
  using Scalar = double;

  explicit Shift_invert_eigensolver(const Laplace_beltrami_matrices& matrices)
    : m_matrices(matrices)
    , m_sqrt_mass(matrices.mass.cwiseSqrt())
    , m_shift(0.5 * 4 * pi() / matrices.area)
    , m_shifted(static_cast<int>(rows()))
    , m_found(rows(), 0)
    , m_right_hand_side(static_cast<int>(rows()))
    , m_solution(static_cast<int>(rows()))
  {
    for (Eigen::Index j = 0; j < matrices.stiffness.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrices.stiffness, j); it; ++it)
        m_shifted.set_coef(it.row(),
                           it.col(),
                           it.value() + (it.row() == it.col() ? m_shift * matrices.mass[j] : 0.),
                           true);
    double determinant;
    if (!m_solver.factor(m_shifted, determinant))
      throw Reeb_graph_error("the factorization of the shifted stiffness matrix failed");
  }

  // The `number` smallest eigenpairs, or all that there are. What earlier calls have found is used.
  Eigenpairs smallest(Eigen::Index number)
  {
    // a Krylov space and what is orthogonal to it need room
    return 3 * number + 60 < rows() ? krylov(number) : dense(number);
  }

  // The operator A, as Spectra wants it, on the vectors that are orthogonal to those found already.
  Eigen::Index rows() const { return m_matrices.mass.size(); }
  Eigen::Index cols() const { return rows(); }
  void perform_op(const double* x_in, double* y_out) const
  {
    const Eigen::Map<const Eigen::VectorXd> x(x_in, rows());
    Eigen::Map<Eigen::VectorXd> y(y_out, rows());
    y = m_sqrt_mass.cwiseProduct(solve(m_sqrt_mass.cwiseProduct(deflated(x))));
    y = deflated(y);
  }

private:
  static double pi() { return 3.14159265358979323846; }

  const Vector& solve(const Eigen::VectorXd& right_hand_side) const
  {
    for (Eigen::Index i = 0; i < rows(); ++i)
      m_right_hand_side.set(i, right_hand_side[i]);
    if (!m_solver.linear_solver(m_right_hand_side, m_solution))
      throw Reeb_graph_error("the solution of a linear system failed");
    return m_solution;
  }

  Eigen::VectorXd deflated(const Eigen::VectorXd& x) const
  {
    return x - m_found * (m_found.transpose() * x);
  }

  // A Krylov space holds one vector of every eigenspace: further ones of a multiple eigenvalue come in by
  // rounding only, late or never. So the space orthogonal to the vectors found is searched again, until
  // it has no eigenvalue left among those wanted.
  Eigenpairs krylov(Eigen::Index number)
  {
    if (m_nu.size() < number)
      add_largest(number - m_nu.size(), 0.);
    constexpr Eigen::Index probes = 3;
    while (add_largest(probes, m_nu[number - 1])) {
    }
    return untransformed(m_nu.head(number), m_found.leftCols(number));
  }

  // Of the `number` largest eigenvalues on the vectors orthogonal to those found, adds those above `bound`.
  // Returns whether there are any.
  bool add_largest(Eigen::Index number, double bound)
  {
    const Eigen::Index dimension = 2 * number + 20; // of the Krylov space
    Spectra::SymEigsSolver<Shift_invert_eigensolver> solver(*this, number, dimension);
    solver.init();
    constexpr int max_restarts = 300;
    constexpr double tolerance = 1e-12;
    solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance);
    if (solver.info() != Spectra::CompInfo::Successful)
      throw Reeb_graph_error("the eigensolver did not converge in " + std::to_string(max_restarts) +
                             " restarts");
    const Eigen::Index added = (solver.eigenvalues().array() > bound).count();
    if (added == 0)
      return false;

    Eigen::VectorXd nu(m_nu.size() + added);
    nu << m_nu, solver.eigenvalues().head(added);
    Eigen::MatrixXd vectors(rows(), nu.size());
    vectors << m_found, solver.eigenvectors(added);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(nu.size()));
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::stable_sort(order.begin(), order.end(), [&nu](Eigen::Index i, Eigen::Index j) {
      return nu[i] > nu[j];
    });
    m_nu.resize(nu.size());
    m_found.resize(rows(), nu.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      m_nu[static_cast<Eigen::Index>(i)] = nu[order[i]];
      m_found.col(static_cast<Eigen::Index>(i)) = vectors.col(order[i]);
    }
    return true;
  }

  Eigenpairs dense(Eigen::Index number)
  {
    m_nu.resize(0);
    m_found.resize(rows(), 0);
    Eigen::MatrixXd a(rows(), rows());
    for (Eigen::Index j = 0; j < rows(); ++j) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(rows(), j);
      perform_op(unit.data(), a.col(j).data());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((a + a.transpose()) / 2);
    if (solver.info() != Eigen::Success)
      throw Reeb_graph_error("the dense eigensolver did not converge");
    // Eigenvalues that small have few correct digits, and none if a vertex has no mass. They belong to
    // faces that are degenerate: those of a regular mesh of so few vertices differ by a thousand.
    constexpr double negligible = 1e-7;
    const double largest = solver.eigenvalues().maxCoeff();
    const Eigen::Index available = (solver.eigenvalues().array() > negligible * largest).count();
    number = (std::min)(number, available);
    return untransformed(solver.eigenvalues().tail(number).reverse(),
                         solver.eigenvectors().rightCols(number).rowwise().reverse());
  }

  // From the eigenpairs (nu, y) of A, nu decreasing: psi = (L + sigma M)^-1 M^1/2 y / nu.
  Eigenpairs untransformed(const Eigen::VectorXd& nu, const Eigen::MatrixXd& y) const
  {
    Eigenpairs result;
    result.values = nu.cwiseInverse().array() - m_shift;
    result.vectors.resize(rows(), nu.size());
    for (Eigen::Index i = 0; i < nu.size(); ++i)
      result.vectors.col(i) = solve(m_sqrt_mass.cwiseProduct(y.col(i))) / nu[i];
    return result;
  }

  const Laplace_beltrami_matrices& m_matrices;
  Eigen::VectorXd m_sqrt_mass;
  double m_shift;
  Matrix m_shifted;
  Eigen::VectorXd m_nu;    // eigenvalues of A found so far, decreasing
  Eigen::MatrixXd m_found; // their eigenvectors, orthonormal
  // a solver works on its own state when it solves
  mutable SolverTraits m_solver;
  mutable Vector m_right_hand_side, m_solution;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SHIFT_INVERT_EIGENSOLVER_H
