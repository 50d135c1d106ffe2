// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The supernodal Cholesky factorization against Eigen's solvers, and against what every solution
// fulfils.

#define BOOST_TEST_MODULE supernodal_Cholesky
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

namespace {

template <class Scalar>
using Sparse = Eigen::SparseMatrix<Scalar>;
template <class Scalar>
using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Solver = SMRG::Supernodal_Cholesky<Sparse<Scalar>>;

// A named matrix, for messages.
struct Example
{
  std::string name;
  Sparse<double> matrix;
};

Sparse<double>
symmetric_matrix(const int n, const std::set<std::pair<int, int>>& positions, std::mt19937& rng)
{
  // Dominated by the diagonal, thus positive definite, but hardly so in some rows.
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> sum(static_cast<std::size_t>(n), 0.);
  for (const auto& [i, j] : positions) {
    if (i == j)
      continue;
    const double value = 2 * random_unit(rng) - 1;
    entries.emplace_back(i, j, value);
    entries.emplace_back(j, i, value);
    sum[static_cast<std::size_t>(i)] += std::abs(value);
    sum[static_cast<std::size_t>(j)] += std::abs(value);
  }
  for (int i = 0; i < n; ++i)
    entries.emplace_back(i, i, sum[static_cast<std::size_t>(i)] + 0.01 + random_unit(rng));
  Sparse<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Sparse<double> random_matrix(const int n, const double entries_per_row, std::mt19937& rng)
{
  std::set<std::pair<int, int>> positions;
  const std::size_t size = static_cast<std::size_t>(n);
  for (int k = 0; k < entries_per_row * n; ++k) {
    const int i = static_cast<int>(random_index(size, rng));
    const int j = static_cast<int>(random_index(size, rng));
    positions.emplace(std::min(i, j), std::max(i, j));
  }
  return symmetric_matrix(n, positions, rng);
}

// `L + shift I` for the graph Laplacian L with random positive weights
Sparse<double> mesh_matrix(const Index_mesh& mesh, const double shift, std::mt19937& rng)
{
  const int n = static_cast<int>(mesh.points.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = static_cast<int>(t[k]);
      const int j = static_cast<int>(t[(k + 1) % 3]);
      const double weight = 0.1 + random_unit(rng);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
    }
  for (int i = 0; i < n; ++i)
    entries.emplace_back(i, i, shift);
  Sparse<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<Example> examples(const unsigned seed)
{
  std::mt19937 rng(seed);
  std::vector<Example> result;
  const auto add = [&](const std::string& name, const Sparse<double>& matrix) {
    result.push_back({name + ", seed " + std::to_string(seed), matrix});
  };
  for (const int n : {1, 2, 3, 5, 17, 60, 200, 500})
    for (const double density : {0., 0.5, 1., 3., 12.})
      add("random " + std::to_string(n) + " x " + std::to_string(density),
          random_matrix(n, density, rng));

  for (const int n : {1, 2, 3, 4, 5, 7, 48, 49, 130, 300}) {
    std::set<std::pair<int, int>> all, first, last;
    for (int i = 0; i < n; ++i) {
      first.emplace(0, i);
      last.emplace(i, n - 1);
      for (int j = i; j < n; ++j)
        all.emplace(i, j);
    }
    add("dense " + std::to_string(n), symmetric_matrix(n, all, rng));
    add("arrow up " + std::to_string(n), symmetric_matrix(n, first, rng));
    add("arrow down " + std::to_string(n), symmetric_matrix(n, last, rng));
  }

  // Several blocks, one of them dense, in any order of the rows.
  {
    std::set<std::pair<int, int>> positions;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < i; ++j)
        positions.emplace(7 * i, 7 * j);
    for (int i = 0; i + 8 < 300; i += 7)
      positions.emplace(i + 1, i + 8);
    add("blocks", symmetric_matrix(300, positions, rng));
  }

  Index_mesh mesh = torus(40, 25);
  flip_random_edges(mesh, 3000, rng);
  relabel_randomly(mesh, rng);
  add("torus", mesh_matrix(mesh, 1e-3, rng));
  mesh = sphere(4);
  flip_random_edges(mesh, 4000, rng);
  relabel_randomly(mesh, rng);
  add("sphere", mesh_matrix(mesh, 1e-3, rng));
  append(mesh, torus(9, 7), 5);
  append(mesh, grid(12, 3), 9);
  add("components", mesh_matrix(mesh, 1, rng));
  return result;
}

// Largest of `|A x - b| / (|A| |x| + |b|)` over the columns, in the maximum norm. Backward stable
// solutions have it of the size of the rounding error.
template <class Matrix, class Block>
double backward_error(const Matrix& a, const Block& x, const Block& b)
{
  using Scalar = typename Block::Scalar;
  double norm = 0;
  for (Eigen::Index i = 0; i < a.outerSize(); ++i) {
    double sum = 0;
    for (typename Matrix::InnerIterator it(a, i); it; ++it)
      sum += std::abs(static_cast<double>(it.value()));
    norm = std::max(norm, sum);
  }
  double result = 0;
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> residual = a * x.col(j) - b.col(j);
    const double scale = norm * static_cast<double>(x.col(j).cwiseAbs().maxCoeff()) +
                         static_cast<double>(b.col(j).cwiseAbs().maxCoeff());
    result = std::max(result, static_cast<double>(residual.cwiseAbs().maxCoeff()) / scale);
  }
  return result;
}

template <class Scalar>
Dense<Scalar> random_block(const Eigen::Index rows, const Eigen::Index columns, std::mt19937& rng)
{
  Dense<Scalar> result(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i)
      result(i, j) = static_cast<Scalar>(2 * random_unit(rng) - 1);
  return result;
}

// Of backward errors: the bound of theory grows with the number of operations per entry, which stay
// few.
template <class Scalar>
constexpr double rounding = 20. * std::numeric_limits<Scalar>::epsilon();

Sparse<double> matrix_of(const Dense<double>& dense)
{
  return dense.sparseView();
}

// 2 on the diagonal (1 at both ends) and -1 next to it: singular, and elimination is exact.
Sparse<double> path_Laplacian(const int n)
{
  Dense<double> result = Dense<double>::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    result(i, i) += 1;
    result(i + 1, i + 1) += 1;
    result(i, i + 1) = result(i + 1, i) = -1;
  }
  return matrix_of(result);
}

} // namespace

BOOST_AUTO_TEST_CASE(solutions_are_backward_stable_and_those_of_other_solvers)
{
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937 rng(seed);
    for (const Example& example : examples(seed))
      BOOST_TEST_CONTEXT(example.name)
      {
        const Sparse<double>& a = example.matrix;
        const Solver<double> solver(a);
        BOOST_REQUIRE(solver.info() == Eigen::Success);
        BOOST_TEST(solver.rows() == a.rows());
        BOOST_TEST(solver.cols() == a.cols());
        const Dense<double> b = random_block<double>(a.rows(), 3, rng);
        const Dense<double> x = solver.solve(b);
        BOOST_TEST(backward_error(a, x, b) < rounding<double>);

        const Eigen::SimplicialLDLT<Sparse<double>> simplicial(a);
        const Dense<double> expected = simplicial.solve(b);
        // the condition of these matrices is below 1e5
        BOOST_TEST((x - expected).norm() <= 1e-10 * expected.norm());
        const Dense<double> dense = Dense<double>(a).llt().solve(b);
        BOOST_TEST((x - dense).norm() <= 1e-10 * dense.norm());
      }
  }
}

BOOST_AUTO_TEST_CASE(float_solutions_are_backward_stable)
{
  std::mt19937 rng(4);
  for (const Example& example : examples(4))
    BOOST_TEST_CONTEXT(example.name)
    {
      const Sparse<float> a = example.matrix.cast<float>();
      const Solver<float> solver(a);
      BOOST_REQUIRE(solver.info() == Eigen::Success);
      for (const int columns : {1, 4, 8}) {
        const Dense<float> b = random_block<float>(a.rows(), columns, rng);
        const Dense<float> x = solver.solve(b);
        BOOST_TEST(backward_error(a, x, b) < rounding<float>);
      }
    }
}

BOOST_AUTO_TEST_CASE(blocks_of_any_width_are_solved_column_by_column)
{
  std::mt19937 rng(5);
  for (const Example& example : examples(5))
    BOOST_TEST_CONTEXT(example.name)
    {
      const Sparse<double>& a = example.matrix;
      const Solver<double> solver(a);
      for (Eigen::Index columns = 0; columns <= 18; ++columns) {
        const Dense<double> b = random_block<double>(a.rows(), columns, rng);
        const Dense<double> x = solver.solve(b);
        BOOST_TEST(backward_error(a, x, b) < rounding<double>);
        for (Eigen::Index j = 0; j < columns; ++j) {
          const Eigen::VectorXd column = solver.solve(b.col(j));
          BOOST_TEST((column - x.col(j)).norm() <= 1e-10 * column.norm());
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(right_hand_sides_of_any_kind)
{
  std::mt19937 rng(6);
  const Sparse<double> a = random_matrix(150, 2, rng);
  const Solver<double> solver(a);
  const Dense<double> b = random_block<double>(150, 11, rng);
  const Dense<double> x = solver.solve(b);

  using Row_major = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Row_major by_rows = solver.solve(Row_major(b));
  BOOST_TEST((by_rows - x).norm() == 0);
  const Dense<double> of_expression = solver.solve(2 * b - b);
  BOOST_TEST((of_expression - x).norm() == 0);
  Dense<double> in_place = b;
  in_place = solver.solve(in_place);
  BOOST_TEST((in_place - x).norm() == 0);
  const Sparse<double> sparse_b = b.sparseView();
  const Sparse<double> sparse = solver.solve(sparse_b);
  BOOST_TEST((Dense<double>(sparse) - x).norm() <= 1e-12 * x.norm());

  Eigen::Matrix<double, Eigen::Dynamic, 8, Eigen::RowMajor> block =
      solver.permutationP() * b.leftCols(8);
  solver.solve_permuted_in_place(block);
  BOOST_TEST((solver.permutationP().transpose() * block - x.leftCols(8)).norm() == 0);
  Eigen::VectorXd column = solver.permutationP() * b.col(0);
  solver.solve_permuted_in_place(column);
  BOOST_TEST((solver.permutationP().transpose() * column - x.col(0)).norm() <=
             1e-12 * x.col(0).norm());
  Eigen::Matrix<double, Eigen::Dynamic, 5, Eigen::RowMajor> five =
      solver.permutationP() * b.leftCols(5);
  solver.solve_permuted_in_place(five);
  BOOST_TEST((solver.permutationP().transpose() * five - x.leftCols(5)).norm() <=
             1e-12 * x.leftCols(5).norm());
}

BOOST_AUTO_TEST_CASE(one_triangle_is_read)
{
  std::mt19937 rng(7);
  using Row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  for (const Example& example : examples(7))
    BOOST_TEST_CONTEXT(example.name)
    {
      const Sparse<double>& a = example.matrix;
      Sparse<double> lower = a.triangularView<Eigen::Lower>();
      Sparse<double> upper = a.triangularView<Eigen::Upper>();
      const Dense<double> b = random_block<double>(a.rows(), 2, rng);
      const Dense<double> x = Solver<double>(a).solve(b);
      const auto difference = [&](const auto& solver) {
        const Dense<double> other = solver.solve(b);
        return (other - x).norm();
      };
      // the order in which entries are found may break ties of the ordering
      const double tolerance = 1e-10 * x.norm();
      BOOST_TEST(difference(Solver<double>(lower)) <= tolerance);
      BOOST_TEST(difference(SMRG::Supernodal_Cholesky<Sparse<double>, Eigen::Upper>(upper)) <=
                 tolerance);
      BOOST_TEST(difference(SMRG::Supernodal_Cholesky<Row_matrix>(Row_matrix(lower))) <= tolerance);
      BOOST_TEST(difference(SMRG::Supernodal_Cholesky<Row_matrix, Eigen::Upper>(
                     Row_matrix(upper))) <= tolerance);
      BOOST_TEST(
          difference(
              SMRG::Supernodal_Cholesky<Sparse<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>(
                  a)) <= tolerance);
    }
}

// Against products of whole matrices; above the diagonal anything may come out.
template <class Scalar>
void check_rank_update(std::mt19937& rng)
{
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const auto random_matrix = [&rng](const Eigen::Index rows, const Eigen::Index columns) {
    std::uniform_real_distribution<double> number(-0.5, 0.5);
    return Matrix(
        Matrix::NullaryExpr(rows, columns, [&]() { return static_cast<Scalar>(number(rng)); }));
  };
  const auto random_size = [&rng](const Eigen::Index largest) {
    return std::uniform_int_distribution<Eigen::Index>(1, largest)(rng);
  };
  SMRG::internal::Rank_update<Scalar> update; // one for all: its memory is used again
  for (int i = 0; i < 60; ++i) {
    const bool is_large = i % 10 == 0;
    const Eigen::Index rows = random_size(is_large ? 400 : 60),
                       columns = i % 2 == 0 ? rows : random_size(rows),
                       depth = random_size(is_large ? 420 : 30);
    const Matrix a = random_matrix(rows + 3, depth), c = random_matrix(rows + 5, columns);
    Matrix result = c;
    update.subtract(a.data(), rows + 3, rows, columns, depth, result.data(), rows + 5);
    const Matrix expected = c.topRows(rows) - a.topRows(rows) * a.topRows(columns).transpose();
    const Scalar rounding =
        4 * std::numeric_limits<Scalar>::epsilon() * static_cast<Scalar>(depth + 4);
    Scalar error = 0;
    for (Eigen::Index k = 0; k < columns; ++k) {
      const auto difference = (result.col(k).head(rows) - expected.col(k)).tail(rows - k);
      error = (std::max)(error, difference.cwiseAbs().maxCoeff());
    }
    BOOST_TEST(error <= rounding, rows << " x " << columns << ", depth " << depth);
    BOOST_TEST((result.bottomRows(5).array() == c.bottomRows(5).array()).all());
  }
}

BOOST_AUTO_TEST_CASE(rank_update_is_a_product)
{
  std::mt19937 rng(31);
  check_rank_update<double>(rng);
  check_rank_update<float>(rng); // without kernels
}

BOOST_AUTO_TEST_CASE(determinant_is_that_of_dense_factorization)
{
  for (const Example& example : examples(8))
    BOOST_TEST_CONTEXT(example.name)
    {
      if (example.matrix.rows() > 60)
        continue;
      const double expected = Dense<double>(example.matrix).determinant();
      BOOST_TEST(std::abs(Solver<double>(example.matrix).determinant() - expected) <=
                 1e-11 * expected);
    }
}

BOOST_AUTO_TEST_CASE(stored_entries_are_few_more_than_those_of_the_factor)
{
  for (const Example& example : examples(9))
    BOOST_TEST_CONTEXT(example.name)
    {
      const Solver<double> solver(example.matrix);
      const Eigen::SimplicialLLT<Sparse<double>> simplicial(example.matrix);
      const Eigen::Index factor = Sparse<double>(simplicial.matrixL()).nonZeros();
      BOOST_TEST(solver.nonZeros() >= factor);
      BOOST_TEST(solver.nonZeros() <= 2 * factor);
      BOOST_TEST(solver.memory() >= sizeof(double) * static_cast<std::size_t>(factor));
    }
}

BOOST_AUTO_TEST_CASE(pattern_is_used_again)
{
  std::mt19937 rng(10);
  for (const Example& example : examples(10))
    BOOST_TEST_CONTEXT(example.name)
    {
      Sparse<double> a = example.matrix;
      Solver<double> solver;
      solver.analyzePattern(a);
      BOOST_TEST(solver.info() == Eigen::Success);
      const Dense<double> b = random_block<double>(a.rows(), 8, rng);
      for (int i = 0; i < 3; ++i) {
        solver.factorize(a);
        BOOST_REQUIRE(solver.info() == Eigen::Success);
        const Dense<double> x = solver.solve(b);
        const Dense<double> expected = Solver<double>(a).solve(b);
        BOOST_TEST((x - expected).norm() == 0);

        // a failure in between leaves no trace
        solver.factorize(-a);
        BOOST_TEST(solver.info() == Eigen::NumericalIssue);
        a = 1.5 * a;
        a.coeffRef(0, 0) += 1;
      }
    }
}

BOOST_AUTO_TEST_CASE(another_pattern_is_invalid_input)
{
  Sparse<double> a = path_Laplacian(6);
  for (int i = 0; i < 6; ++i)
    a.coeffRef(i, i) += 1;
  Solver<double> solver(a);
  BOOST_TEST(solver.info() == Eigen::Success);

  std::mt19937 rng(11);
  std::set<std::pair<int, int>> all;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      all.emplace(i, j);
  solver.factorize(symmetric_matrix(6, all, rng));
  BOOST_TEST(solver.info() == Eigen::InvalidInput);
  solver.factorize(path_Laplacian(7));
  BOOST_TEST(solver.info() == Eigen::InvalidInput);
  solver.factorize(a);
  BOOST_TEST(solver.info() == Eigen::Success);

  solver.compute(Sparse<double>(3, 4));
  BOOST_TEST(solver.info() == Eigen::InvalidInput);
  Solver<double> without_pattern;
  without_pattern.factorize(a);
  BOOST_TEST(without_pattern.info() == Eigen::InvalidInput);
}

BOOST_AUTO_TEST_CASE(not_positive_definite_is_a_numerical_issue)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto is_refused = [](const Sparse<double>& matrix) {
    const Solver<double> solver(matrix);
    const Dense<double> x = solver.solve(Dense<double>::Ones(matrix.rows(), 9));
    return solver.info() == Eigen::NumericalIssue && x.isZero(0);
  };
  for (const double value : {0., -1., nan, infinity, -infinity})
    BOOST_TEST(is_refused(matrix_of(Dense<double>::Constant(1, 1, value))));
  BOOST_TEST(is_refused(Sparse<double>(1, 1)));
  BOOST_TEST(is_refused(Sparse<double>(20, 20)));
  for (const int n : {2, 3, 4, 5, 9, 64})
    BOOST_TEST(is_refused(matrix_of(Dense<double>::Ones(n, n))));
  for (const int n : {2, 10, 1000})
    BOOST_TEST(is_refused(path_Laplacian(n)));

  // Any single entry spoils any matrix.
  std::mt19937 rng(12);
  for (const Example& example : examples(12))
    BOOST_TEST_CONTEXT(example.name)
    {
      const int n = static_cast<int>(example.matrix.rows());
      for (const double value : {0., -1., nan, infinity, -infinity}) {
        Sparse<double> a = example.matrix;
        const int i = static_cast<int>(random_index(static_cast<std::size_t>(n), rng));
        a.coeffRef(i, i) = value;
        BOOST_TEST(is_refused(a));
      }
      for (const double value : {nan, infinity, -infinity, 1e200}) {
        Sparse<double> a = example.matrix;
        for (int j = 0; j < n; ++j)
          for (Sparse<double>::InnerIterator it(a, j); it; ++it)
            if (it.row() > j) {
              it.valueRef() = value;
              BOOST_TEST(is_refused(a));
              j = n;
              break;
            }
      }
    }
}

BOOST_AUTO_TEST_CASE(empty_matrix)
{
  const Solver<double> solver(Sparse<double>(0, 0));
  BOOST_TEST(solver.info() == Eigen::Success);
  BOOST_TEST(solver.rows() == 0);
  BOOST_TEST(solver.determinant() == 1);
  BOOST_TEST(solver.nonZeros() == 0);
  const Dense<double> x = solver.solve(Dense<double>(0, 3));
  BOOST_TEST(x.rows() == 0);
  BOOST_TEST(x.cols() == 3);
}

BOOST_AUTO_TEST_CASE(threads_share_a_factor)
{
  std::mt19937 rng(13);
  const Sparse<double> a = mesh_matrix(sphere(4), 1e-3, rng);
  const Solver<double> solver(a);
  const Dense<double> b = random_block<double>(a.rows(), 13, rng);
  const Dense<double> expected = solver.solve(b);
  std::vector<Dense<double>> results(2);
  std::vector<std::thread> threads;
  for (Dense<double>& x : results)
    threads.emplace_back([&] {
      for (int i = 0; i < 20; ++i)
        x = solver.solve(b);
    });
  for (std::thread& thread : threads)
    thread.join();
  for (const Dense<double>& x : results)
    BOOST_TEST((x - expected).norm() == 0);
}

BOOST_AUTO_TEST_CASE(eigenbasis_is_that_of_another_solver)
{
  using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
  using Eigensolver =
      SMRG::Block_Lanczos_eigensolver<CGAL::Eigen_solver_traits<SMRG::Supernodal_Cholesky<Matrix>>>;
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  make_mesh(torus(30, 20), mesh, vertices);
  const auto np = SMRG::parameters::number_of_eigenpairs(20);
  using Simplicial_eigensolver =
      SMRG::Block_Lanczos_eigensolver<CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix>>>;
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh, Simplicial_eigensolver> expected(mesh, np);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh, Eigensolver> basis(mesh, np);
  BOOST_REQUIRE(basis.number_of_eigenpairs(0) == expected.number_of_eigenpairs(0));
  for (std::size_t i = 1; i <= basis.number_of_eigenpairs(0); ++i)
    BOOST_TEST(std::abs(basis.eigenvalue(0, i) - expected.eigenvalue(0, i)) <=
               1e-10 * expected.eigenvalue(0, i));
}
