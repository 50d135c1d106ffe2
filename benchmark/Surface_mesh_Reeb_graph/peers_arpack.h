// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The eigensolver of ARPACK. To be included after all other headers, since that of ARPACK includes
// `<complex.h>`, whose macro `I` they do not expect.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_ARPACK_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_ARPACK_H

#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <arpack/arpack.hpp>

namespace Reeb_graph_benchmark {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

// A model of `LaplaceBeltramiEigensolver`: the implicitly restarted Lanczos method with shift and
// invert, ARPACK's mode 3 for `L x = lambda M x`, one right-hand side at a time. It does not look
// for vectors that a multiple eigenvalue may lack.
template <class SolverTraits>
class Arpack_eigensolver
{
  using Matrix = typename SolverTraits::Matrix;
  using Vector = typename SolverTraits::Vector;
  using Const_column = Eigen::Map<const Eigen::VectorXd>;
  using Column = Eigen::Map<Eigen::VectorXd>;

public:
  Arpack_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                     const Eigen::VectorXd& mass,
                     const double shift,
                     const SMRG::Eigensolver_options& options)
    : m_options(options)
    , m_mass(mass)
    , m_shift(shift)
    , m_right_hand_side(size())
    , m_solution(size())
  {
    Matrix shifted(size());
    for (Eigen::Index j = 0; j < stiffness.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, j); it; ++it)
        shifted.set_coef(
            it.row(), it.col(), it.value() + (it.row() == it.col() ? shift * mass[j] : 0.), true);
    double determinant;
    if (!m_solver.factor(shifted, determinant))
      throw SMRG::Numerical_error("the factorization of the shifted stiffness matrix failed");
  }

  SMRG::Eigenpairs smallest(const Eigen::Index number)
  {
    // What SciPy takes for the dimension of the Krylov space; the tolerance as for the others here.
    const int wanted = int(number), dimension = (std::min)(2 * wanted + 1, size());
    constexpr double tolerance = 1e-12;

    Eigen::VectorXd residual(size()), work(3 * size());
    Eigen::MatrixXd krylov(size(), dimension);
    std::vector<double> small_work(std::size_t(dimension * (dimension + 8)));
    std::array<int, 11> parameters = {1, 0, 300, 1, 0, 0, 3, 0, 0, 0, 0};
    std::array<int, 14> pointers = {};
    int request = 0, info = 0;
    const auto column = [&](const std::size_t i) { return work.data() + pointers[i] - 1; };
    while (true) {
      arpack::saupd(request,
                    arpack::bmat::generalized,
                    size(),
                    arpack::which::largest_magnitude,
                    wanted,
                    tolerance,
                    residual.data(),
                    dimension,
                    krylov.data(),
                    size(),
                    parameters.data(),
                    pointers.data(),
                    work.data(),
                    small_work.data(),
                    int(small_work.size()),
                    info);
      Column y(column(1), size());
      if (request == -1)
        solve(m_mass.cwiseProduct(Const_column(column(0), size())), y);
      else if (request == 1)
        solve(Const_column(column(2), size()), y); // has been multiplied by M before
      else if (request == 2)
        y = m_mass.cwiseProduct(Const_column(column(0), size()));
      else
        break;
    }
    if (info < 0)
      throw SMRG::Numerical_error("dsaupd of ARPACK returns " + std::to_string(info));

    SMRG::Eigenpairs result;
    result.have_converged = info == 0 && parameters[4] >= wanted;
    result.values.resize(wanted);
    std::vector<int> selected(std::size_t(dimension), 1);
    arpack::seupd(1,
                  arpack::howmny::ritz_vectors,
                  selected.data(),
                  result.values.data(),
                  krylov.data(),
                  size(),
                  -m_shift,
                  arpack::bmat::generalized,
                  size(),
                  arpack::which::largest_magnitude,
                  wanted,
                  tolerance,
                  residual.data(),
                  dimension,
                  krylov.data(),
                  size(),
                  parameters.data(),
                  pointers.data(),
                  work.data(),
                  small_work.data(),
                  int(small_work.size()),
                  info);
    if (info != 0)
      throw SMRG::Numerical_error("dseupd of ARPACK returns " + std::to_string(info));
    krylov.conservativeResize(Eigen::NoChange, wanted);
    result.vectors.swap(krylov);
    return result;
  }

private:
  int size() const { return int(m_mass.size()); }

  template <class Expression>
  void solve(const Expression& b, Column& x)
  {
    m_options.report_progress(0);
    m_right_hand_side = b;
    if (!m_solver.linear_solver(m_right_hand_side, m_solution))
      throw SMRG::Numerical_error("the solution of a linear system failed");
    x = m_solution;
  }

  SMRG::Eigensolver_options m_options;
  Eigen::VectorXd m_mass;
  double m_shift;
  SolverTraits m_solver;
  Vector m_right_hand_side, m_solution;
};

} // namespace Reeb_graph_benchmark

#undef I

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_ARPACK_H
