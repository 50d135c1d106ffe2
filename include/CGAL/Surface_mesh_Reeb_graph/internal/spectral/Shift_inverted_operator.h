// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SHIFT_INVERTED_OPERATOR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SHIFT_INVERTED_OPERATOR_H

#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/block_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/symmetric_eigenpairs.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Whether a model of `SparseLinearAlgebraWithFactorTraits_d` gives access to a solver with Eigen's
// interface, which solves for several right-hand sides at once ...
template <class SolverTraits, class = void>
struct Solves_matrices : std::false_type
{
};
template <class SolverTraits>
struct Solves_matrices<SolverTraits,
                       std::void_t<decltype(std::declval<Eigen::MatrixXd&>() =
                                                std::declval<SolverTraits&>().solver().solve(
                                                    std::declval<const Eigen::MatrixXd&>()))>>
  : std::true_type
{
};

// ... and to one that overwrites a block of right-hand sides by the solutions.
template <class SolverTraits, class = void>
struct Solves_in_place : std::false_type
{
};
template <class SolverTraits>
struct Solves_in_place<SolverTraits,
                       std::void_t<decltype(std::declval<SolverTraits&>().solver().solve_in_place(
                           std::declval<Row_block&>()))>> : std::true_type
{
};

// ... or does so in the order of the rows that its factor has, as `Supernodal_Cholesky`.
template <class SolverTraits, class = void>
struct Solves_permuted : std::false_type
{
};
template <class SolverTraits>
struct Solves_permuted<
    SolverTraits,
    std::void_t<decltype(std::declval<SolverTraits&>().solver().permutationP().indices()),
                decltype(std::declval<SolverTraits&>().solver().solve_permuted_in_place(
                    std::declval<Row_block&>()))>> : std::true_type
{
};

// Whether a type is `CGAL::Eigen_sparse_matrix`, or another one that can be made from a matrix of
// Eigen. It never gives back the memory of the entries that it is made from one by one.
template <class Matrix, class = void>
struct Is_CGAL_Eigen_matrix : std::false_type
{
};
template <class Matrix>
struct Is_CGAL_Eigen_matrix<
    Matrix,
    std::void_t<decltype(Matrix(std::declval<const Eigen::SparseMatrix<double>&>())),
                decltype(std::declval<Matrix&>().swap(std::declval<Matrix&>())),
                decltype(std::declval<Matrix&>().add_coef(0, 0, 0.))>> : std::true_type
{
};

// `A = M^1/2 (L + sigma M)^-1 M^1/2`. Its eigenvalues are `nu = 1 / (lambda + sigma)` for those of
// `L psi = lambda M psi`, and infinitely large lambda (nu = 0) for vertices without mass.
//
// Vectors that A is applied to have their rows in an order of its own: that of the factor, if the
// solver can do with it. Eigenfunctions have them in the order of L and M.
template <class SolverTraits>
class Shift_inverted_operator
{
  using Matrix = typename SolverTraits::Matrix;
  using Vector = typename SolverTraits::Vector;

public:
  Shift_inverted_operator(const Eigen::SparseMatrix<double>& stiffness,
                          const Eigen::VectorXd& mass,
                          double shift)
    : m_sqrt_mass(mass.cwiseSqrt())
    , m_shift(shift)
    , m_shifted(make_matrix(rows()))
    , m_right_hand_side(static_cast<int>(rows()))
    , m_solution(static_cast<int>(rows()))
  {
    CGAL_precondition(stiffness.rows() == rows() && stiffness.cols() == rows());
    CGAL_precondition(shift > 0);
    // A copy of Eigen's matrix takes less memory than one that is made entry by entry.
    if constexpr (std::is_same_v<Matrix, Eigen::SparseMatrix<double>>) {
      add_diagonal(stiffness, shift, mass, m_shifted);
    } else if constexpr (Is_CGAL_Eigen_matrix<Matrix>::value) {
      Matrix(stiffness).swap(m_shifted);
      for (Eigen::Index i = 0; i < rows(); ++i)
        m_shifted.add_coef(i, i, shift * mass[i]);
    } else {
      for (Eigen::Index j = 0; j < rows(); ++j) {
        double diagonal = shift * mass[j];
        for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, j); it; ++it)
          if (it.row() == j)
            diagonal += it.value();
          else
            m_shifted.set_coef(it.row(), it.col(), it.value(), true);
        m_shifted.set_coef(j, j, diagonal, true);
      }
    }
    double determinant;
    if (!m_solver.factor(m_shifted, determinant))
      throw Numerical_error("the factorization of the shifted stiffness matrix failed");
    Eigen::VectorXd permuted(rows());
    for (Eigen::Index i = 0; i < rows(); ++i)
      permuted[own_row(i)] = m_sqrt_mass[i];
    m_sqrt_mass.swap(permuted);
  }

  Eigen::Index rows() const { return m_sqrt_mass.size(); }

  // `y = A x`
  void apply(const Row_block& x, Row_block& y)
  {
    CGAL_precondition(x.rows() == rows());
    multiply_rows(x, m_sqrt_mass, y);
    solve(y);
    multiply_rows(y, m_sqrt_mass, y);
  }
  void apply(const double* x_in, double* y_out)
  {
    const Eigen::Map<const Eigen::VectorXd> x(x_in, rows());
    Eigen::Map<Eigen::VectorXd> y(y_out, rows());
    y = m_sqrt_mass.cwiseProduct(x);
    solve(y);
    y = m_sqrt_mass.cwiseProduct(y);
  }

  // Writes the eigenfunctions that belong to eigenvectors y of A with the eigenvalues nu to the
  // columns of `psi`, as many as these are. `psi = M^-1/2 y` would say nothing where M is zero. One
  // more application of A, `psi = (L + sigma M)^-1 M^1/2 y / nu`, gives it everywhere, and takes
  // out most of the error of y, which is in the directions that A makes small. `y` is changed.
  void to_eigenfunctions(Row_block& y, const double* nu, Eigen::Ref<Eigen::MatrixXd> psi)
  {
    CGAL_precondition(psi.cols() <= block_width && psi.rows() == rows());
    multiply_rows(y, m_sqrt_mass, y);
    solve(y);
    for (Eigen::Index i = 0; i < rows(); ++i) {
      const double* const row = y.data() + block_width * own_row(i);
      for (Eigen::Index j = 0; j < psi.cols(); ++j)
        psi(i, j) = row[j] / nu[j];
    }
  }

  void to_eigenfunctions(Eigen::MatrixXd& vectors, const Eigen::VectorXd& nu)
  {
    for_blocks(vectors, [&](Eigen::Index j, Eigen::Index width, Row_block& block) {
      to_eigenfunctions(block, nu.data() + j, vectors.middleCols(j, width));
    });
  }
  double to_eigenvalue(double nu) const { return 1 / nu - m_shift; }

  // Whether `number` of all eigenpairs are so many that a Krylov space leaves no room for what is
  // orthogonal to it: then all eigenpairs are computed. A search for multiple ones keeps two
  // vectors for every pair, and multiplies one or fewer for every pair.
  bool is_small_for(Eigen::Index number) const
  {
    return (std::max)(3 * number + 60, 4 * number + 24) >=
           std::count_if(
               m_sqrt_mass.data(), m_sqrt_mass.data() + rows(), [](double x) { return x > 0; });
  }

  // The `number` smallest eigenpairs, or all that there are, from the eigenpairs of A as a dense
  // matrix.
  Eigenpairs dense_eigenpairs(Eigen::Index number)
  {
    const Eigen::Index n = rows();
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n);
    Row_block product;
    for_blocks(a, [&](Eigen::Index begin, Eigen::Index width, Row_block& block) {
      apply(block, product);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < width; ++j)
          a(i, begin + j) = product(i, j);
    });
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = j; i < n; ++i)
        a(i, j) = (a(i, j) + a(j, i)) / 2;
    const Symmetric_eigenpairs all = symmetric_eigenpairs(std::move(a));
    if (!all.have_converged)
      throw Numerical_error("the dense eigensolver did not converge");
    // Eigenvalues that small have few correct digits, and none if a vertex has no mass. They belong
    // to faces that are degenerate: those of a regular mesh of so few vertices differ by a
    // thousand.
    constexpr double negligible = 1e-7;
    Eigen::Index available = 0;
    while (available < n && all.values[n - 1 - available] > negligible * all.values[n - 1])
      ++available;
    number = (std::min)(number, available);
    Eigenpairs result;
    Eigen::VectorXd nu(number);
    result.values.resize(number);
    result.vectors.resize(n, number);
    for (Eigen::Index i = 0; i < number; ++i) {
      nu[i] = all.values[n - 1 - i];
      result.values[i] = to_eigenvalue(nu[i]);
      std::copy_n(all.vectors.data() + (n - 1 - i) * n, n, result.vectors.data() + i * n);
    }
    to_eigenfunctions(result.vectors, nu);
    return result;
  }

private:
  // Calls `f` with the first one and the number of some columns that make a block, and with a block
  // that begins with them.
  template <class Function>
  static void for_blocks(const Eigen::MatrixXd& columns, const Function& f)
  {
    Row_block block = Row_block::Zero(columns.rows(), block_width);
    for (Eigen::Index begin = 0; begin < columns.cols(); begin += block_width) {
      const Eigen::Index width = (std::min)(Eigen::Index(block_width), columns.cols() - begin);
      for (Eigen::Index i = 0; i < columns.rows(); ++i)
        for (Eigen::Index j = 0; j < width; ++j)
          block(i, j) = columns(i, begin + j);
      f(begin, width, block);
    }
  }

  // `result = a + factor D` for the diagonal matrix of `d`.
  static void add_diagonal(const Eigen::SparseMatrix<double>& a,
                           double factor,
                           const Eigen::VectorXd& d,
                           Eigen::SparseMatrix<double>& result)
  {
    result.reserve(a.nonZeros() + a.cols());
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      result.startVec(j);
      Eigen::SparseMatrix<double>::InnerIterator it(a, j);
      for (; it && it.row() < j; ++it)
        result.insertBack(it.row(), j) = it.value();
      double& diagonal = result.insertBack(j, j);
      diagonal = factor * d[j];
      if (it && it.row() == j) {
        diagonal += it.value();
        ++it;
      }
      for (; it; ++it)
        result.insertBack(it.row(), j) = it.value();
    }
    result.finalize();
  }

  static Matrix make_matrix(Eigen::Index n)
  {
    if constexpr (std::is_same_v<Matrix, Eigen::SparseMatrix<double>>)
      return Matrix(n, n);
    else
      return Matrix(static_cast<int>(n));
  }

  // The row of a vertex in the order of the operator.
  Eigen::Index own_row(Eigen::Index i)
  {
    if constexpr (Solves_permuted<SolverTraits>::value)
      return m_solver.solver().permutationP().indices()[i];
    else
      return i;
  }

  void solve(Row_block& x)
  {
    if constexpr (Solves_permuted<SolverTraits>::value) {
      m_solver.solver().solve_permuted_in_place(x);
      check(m_solver.solver().info() == Eigen::Success);
    } else if constexpr (Solves_in_place<SolverTraits>::value) {
      m_solver.solver().solve_in_place(x);
      check(m_solver.solver().info() == Eigen::Success);
    } else if constexpr (Solves_matrices<SolverTraits>::value) {
      m_right_hand_sides = x;
      m_solutions = m_solver.solver().solve(m_right_hand_sides);
      check(m_solver.solver().info() == Eigen::Success);
      x = m_solutions;
    } else {
      for (int j = 0; j < block_width; ++j) {
        auto column = x.col(j);
        solve(column);
      }
    }
  }

  template <class Column>
  void solve(Column& x)
  {
    for (Eigen::Index i = 0; i < rows(); ++i)
      m_right_hand_side.set(i, x[own_row(i)]);
    check(m_solver.linear_solver(m_right_hand_side, m_solution));
    for (Eigen::Index i = 0; i < rows(); ++i)
      x[own_row(i)] = m_solution[i];
  }

  static void check(bool success)
  {
    if (!success)
      throw Numerical_error("the solution of a linear system failed");
  }

  Eigen::VectorXd m_sqrt_mass;
  double m_shift;
  Matrix m_shifted;
  SolverTraits m_solver;
  Vector m_right_hand_side, m_solution;            // for one column
  Eigen::MatrixXd m_right_hand_sides, m_solutions; // for blocks
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SHIFT_INVERTED_OPERATOR_H
