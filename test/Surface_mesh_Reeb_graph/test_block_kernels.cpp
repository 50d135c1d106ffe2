// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Products of blocks of vectors, the kernels that make them, and the small dense matrices of the
// eigensolver, against Eigen's products and factorizations.

#define BOOST_TEST_MODULE block_kernels
#include <boost/test/unit_test.hpp>

#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/panel_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_basis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_coefficients.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/block_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/eigenpair_residuals.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/symmetric_eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <type_traits>

namespace internal = CGAL::Surface_mesh_Reeb_graph::internal;
using namespace Reeb_graph_test;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::MatrixXd
random_matrix(const Eigen::Index rows, const Eigen::Index columns, std::mt19937& rng)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&rng]() { return random_unit(rng) - 0.5; });
}

internal::Block_coefficients coefficients(const Eigen::MatrixXd& matrix)
{
  internal::Block_coefficients result;
  for (int i = 0; i < internal::block_width; ++i)
    for (int j = 0; j < internal::block_width; ++j)
      result(i, j) = matrix(i, j);
  return result;
}

Eigen::MatrixXd dense(const internal::Block_coefficients& c)
{
  Eigen::MatrixXd result(internal::block_width, internal::block_width);
  for (int i = 0; i < internal::block_width; ++i)
    for (int j = 0; j < internal::block_width; ++j)
      result(i, j) = c(i, j);
  return result;
}

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  BOOST_REQUIRE_EQUAL(a.rows(), b.rows());
  BOOST_REQUIRE_EQUAL(a.cols(), b.cols());
  return a.size() == 0 ? 0 : (a - b).cwiseAbs().maxCoeff();
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(blocks_of_rows)

BOOST_AUTO_TEST_CASE(products_are_those_of_dense_matrices)
{
  std::mt19937 rng(23);
  // shorter and longer than what stays in the cache, odd and even
  for (const Eigen::Index n : {1, 2, 7, 8, 511, 512, 513, 1025, 3000}) {
    const Eigen::Index number = 1 + static_cast<Eigen::Index>(random_index(5, rng));
    const Eigen::MatrixXd v = random_matrix(n, 8 * number, rng), w = random_matrix(n, 8, rng);
    internal::Block_basis basis;
    for (Eigen::Index i = 0; i < number; ++i)
      basis.insert(i, internal::Row_block(v.middleCols(8 * i, 8)));
    const double rounding = 8 * epsilon * static_cast<double>(n + 8 * number);

    // the first block with given coefficients, those from `begin` on with the products
    internal::Row_block rest = w;
    const Eigen::MatrixXd known = random_matrix(8, 8, rng);
    const Eigen::Index begin = number / 2;
    const auto later = v.rightCols(8 * (number - begin));
    const Eigen::MatrixXd difference = w - v.leftCols(8) * known;
    const Eigen::MatrixXd products = later.transpose() * difference;
    const auto found = basis.subtract_and_project({{0, coefficients(known)}}, begin, rest);
    for (Eigen::Index i = begin; i < number; ++i)
      BOOST_TEST(
          (dense(found[static_cast<std::size_t>(i)]) - products.middleRows(8 * (i - begin), 8))
              .cwiseAbs()
              .maxCoeff() <= rounding);
    BOOST_TEST((rest - (difference - later * products)).cwiseAbs().maxCoeff() <=
               rounding * (1 + products.norm()));

    // the last block is loose, or none
    for (const bool is_loose : {false, true}) {
      Eigen::MatrixXd tight = v;
      double expected_error = 0;
      if (is_loose) {
        const auto others = v.leftCols(8 * (number - 1));
        const Eigen::MatrixXd d = others.transpose() * v.rightCols(8);
        tight.rightCols(8) -= others * d;
        expected_error = d.size() == 0 ? 0 : d.cwiseAbs().maxCoeff();
      }
      rest = w;
      const Eigen::MatrixXd c = v.transpose() * w, expected = w - tight * c;
      const Eigen::MatrixXd square = dense(basis.project_out_of(rest, is_loose ? number - 1 : -1));
      const double bound = rounding * (1 + c.norm()) * (1 + expected_error);
      BOOST_TEST((rest - expected).cwiseAbs().maxCoeff() <= bound);
      BOOST_TEST((square - rest.transpose() * rest).cwiseAbs().maxCoeff() <=
                 rounding * (1 + rest.squaredNorm()));
      BOOST_TEST((basis[number - 1] - tight.rightCols(8)).cwiseAbs().maxCoeff() <=
                 rounding * (1 + expected_error));
      basis.erase(number - 1, number);
      basis.insert(number - 1, internal::Row_block(v.rightCols(8)));
    }

    const Eigen::MatrixXd q = random_matrix(8 * number, 8 * (1 + number / 2), rng);
    basis.multiply_from_right(q);
    BOOST_REQUIRE_EQUAL(basis.size(), 1 + number / 2);
    for (Eigen::Index i = 0; i < basis.size(); ++i)
      BOOST_TEST((basis[i] - (v * q).middleCols(8 * i, 8)).cwiseAbs().maxCoeff() <= rounding);
  }
}

// Those for other processors than the one at hand are used by nothing else here.
template <int width>
void check_kernels()
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::mt19937 rng(29);
  for (const Eigen::Index n : {0, 1, 3, 4, 7, 8, 9, 31, 64, 100}) {
    const double rounding = 8 * epsilon * static_cast<double>(n + 8);
    const Matrix v = random_matrix(n, 8, rng), w = random_matrix(n, 8, rng),
                 c = random_matrix(8, 8, rng);
    Matrix product = c;
    internal::Add_transposed_product::run<width>(v.data(), w.data(), n, product.data());
    BOOST_TEST(largest_difference(product, c + v.transpose() * w) <= rounding);

    Matrix y = w;
    internal::Subtract_product::run<width>(y.data(), v.data(), n, c.data());
    BOOST_TEST(largest_difference(y, w - v * c) <= rounding);

    const Eigen::VectorXd factors = random_matrix(n, 1, rng);
    internal::Multiply_rows::run<width>(v.data(), factors.data(), n, y.data());
    BOOST_TEST(largest_difference(y, factors.asDiagonal() * v) == 0);

    // a tile inside a larger matrix
    const Matrix a = random_matrix(n, 16, rng);
    const Eigen::MatrixXd large = random_matrix(19, 8, rng);
    Eigen::MatrixXd tile = large, expected_tile = large;
    internal::Subtract_tile<double>::run<width>(a.data(), v.data(), n, tile.data() + 1, 19);
    expected_tile.middleRows(1, 16) -= a.transpose() * v;
    BOOST_TEST(largest_difference(tile, expected_tile) <= rounding);

    // two of the rows in the triangle, the others below
    const auto check_columns = [&](const auto columns) {
      constexpr int k = decltype(columns)::value;
      Eigen::MatrixXd l = random_matrix(k + 2 + n, k, rng);
      l.diagonal().array() += 2;
      const Matrix x = random_matrix(k + 2, 8, rng);
      const auto triangle = l.topRows(k).template triangularView<Eigen::Lower>();
      Matrix expected_x = x;
      expected_x.topRows(k) = triangle.solve(Matrix(x.topRows(k)));
      expected_x.bottomRows(2) -= l.middleRows(k, 2) * expected_x.topRows(k);
      const Matrix expected_y = w - l.bottomRows(n) * expected_x.topRows(k);
      Matrix found_x = x, found_y = w;
      internal::Substitute_forward<double, k>::template run<width>(
          l.data(), l.rows(), 2, n, found_x.data(), found_y.data());
      BOOST_TEST(largest_difference(found_x, expected_x) <= rounding);
      BOOST_TEST(largest_difference(found_y, expected_y) <= rounding);

      expected_x = x;
      expected_x.topRows(k) -= l.bottomRows(n).transpose() * w;
      expected_x.topRows(k) -= l.middleRows(k, 2).transpose() * x.bottomRows(2);
      expected_x.topRows(k) = triangle.transpose().solve(Matrix(expected_x.topRows(k)));
      found_x = x;
      internal::Substitute_backward<double, k>::template run<width>(
          l.data(), l.rows(), 2, n, found_x.data(), w.data());
      BOOST_TEST(largest_difference(found_x, expected_x) <= rounding);
    };
    check_columns(std::integral_constant<int, 1>());
    check_columns(std::integral_constant<int, 2>());
    check_columns(std::integral_constant<int, 3>());
    check_columns(std::integral_constant<int, 4>());
  }
}

BOOST_AUTO_TEST_CASE(kernels_of_all_vector_widths_are_products)
{
  check_kernels<2>();
  check_kernels<4>();
}

BOOST_AUTO_TEST_CASE(kernel_called_is_one_of_them)
{
  std::mt19937 rng(31);
  const Eigen::MatrixXd random = random_matrix(1000, 16, rng);
  const internal::Row_block v = random.leftCols(8), w = random.rightCols(8);
  internal::Block_coefficients called, narrow, wide;
  internal::add_transposed_product(v.data(), w.data(), v.rows(), called);
  internal::Add_transposed_product::run<2>(v.data(), w.data(), v.rows(), narrow.data());
  internal::Add_transposed_product::run<4>(v.data(), w.data(), v.rows(), wide.data());
  // equal but for the rounding of products, where these are rounded before they are added
  BOOST_TEST(largest_difference(dense(called), dense(narrow)) <= 1e-12);
  BOOST_TEST(largest_difference(dense(called), dense(wide)) <= 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(small_matrices)

BOOST_AUTO_TEST_CASE(coefficients_are_added_and_multiplied_as_matrices)
{
  std::mt19937 rng(37);
  const Eigen::MatrixXd a = random_matrix(8, 8, rng), b = random_matrix(8, 8, rng);
  const internal::Block_coefficients x = coefficients(a), y = coefficients(b);
  BOOST_TEST(largest_difference(dense(x * y), a * b) <= 16 * epsilon);
  BOOST_TEST(largest_difference(dense(-x), -a) == 0);
  BOOST_TEST(largest_difference(dense(x.transposed()), a.transpose()) == 0);
  BOOST_TEST(largest_difference(dense(internal::Block_coefficients::identity()),
                                Eigen::MatrixXd::Identity(8, 8)) == 0);
  BOOST_TEST(internal::Block_coefficients().is_zero());
  BOOST_TEST(!x.is_zero());
  BOOST_TEST(internal::smallest_on_diagonal(x) == a.diagonal().cwiseAbs().minCoeff());
  BOOST_TEST(internal::largest_on_diagonal(x) == a.diagonal().cwiseAbs().maxCoeff());
}

BOOST_AUTO_TEST_CASE(factors_of_symmetric_matrices_are_triangular_and_have_inverses)
{
  std::mt19937 rng(41);
  for (int i = 0; i < 100; ++i) {
    const Eigen::MatrixXd b = random_matrix(12, 8, rng), a = b.transpose() * b;
    internal::Block_coefficients r;
    BOOST_REQUIRE(internal::factor_symmetric(coefficients(a), r));
    const Eigen::MatrixXd factor = dense(r);
    BOOST_TEST(factor.isUpperTriangular(0));
    BOOST_TEST(largest_difference(factor.transpose() * factor, a) <= 64 * epsilon * a.norm());
    const Eigen::MatrixXd inverse = dense(internal::inverse_of_upper_triangle(r));
    BOOST_TEST(inverse.isUpperTriangular(0));
    BOOST_TEST(largest_difference(factor * inverse, Eigen::MatrixXd::Identity(8, 8)) <=
               64 * epsilon * factor.norm() * inverse.norm());
  }
}

BOOST_AUTO_TEST_CASE(matrices_that_are_not_positive_definite_have_no_factor)
{
  internal::Block_coefficients r;
  BOOST_TEST(!internal::factor_symmetric(internal::Block_coefficients(), r));
  BOOST_TEST(!internal::factor_symmetric(-internal::Block_coefficients::identity(), r));
  internal::Block_coefficients a = internal::Block_coefficients::identity();
  a(5, 2) = a(2, 5) = 2;
  BOOST_TEST(!internal::factor_symmetric(a, r));
  a(5, 2) = a(2, 5) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!internal::factor_symmetric(a, r));
}

void check_eigenpairs(const Eigen::MatrixXd& a)
{
  const Eigen::Index n = a.rows();
  const internal::Symmetric_eigenpairs pairs = internal::symmetric_eigenpairs(a);
  BOOST_REQUIRE(pairs.have_converged);
  BOOST_REQUIRE_EQUAL(pairs.values.size(), n);
  const double rounding = 8 * epsilon * static_cast<double>(n);
  const Eigen::MatrixXd& v = pairs.vectors;
  BOOST_TEST(largest_difference(v.transpose() * v, Eigen::MatrixXd::Identity(n, n)) <= rounding);
  BOOST_TEST(largest_difference(a * v, v * pairs.values.asDiagonal()) <= rounding * a.norm());
  for (Eigen::Index i = 1; i < n; ++i)
    BOOST_TEST(pairs.values[i - 1] <= pairs.values[i]);
  const Eigen::VectorXd alone = internal::symmetric_eigenpairs(a, false).values;
  BOOST_TEST(largest_difference(alone, pairs.values) <= rounding * a.norm());
  // of the lower triangle alone
  Eigen::MatrixXd lower = a;
  lower.triangularView<Eigen::StrictlyUpper>().setConstant(7 * a.norm());
  BOOST_TEST(largest_difference(internal::symmetric_eigenpairs(lower).values, pairs.values) <=
             8 * rounding * a.norm());
}

BOOST_AUTO_TEST_CASE(eigenpairs_of_symmetric_matrices)
{
  std::mt19937 rng(43);
  for (const Eigen::Index n : {1, 2, 3, 5, 8, 13, 40, 130}) {
    const Eigen::MatrixXd b = random_matrix(n, n, rng);
    const Eigen::MatrixXd a = b + b.transpose();
    check_eigenpairs(a);
    check_eigenpairs(1e150 * a);
    check_eigenpairs(1e-150 * a);
    check_eigenpairs(Eigen::MatrixXd(a.diagonal().asDiagonal()));
    check_eigenpairs(Eigen::MatrixXd::Identity(n, n));
    check_eigenpairs(Eigen::MatrixXd::Ones(n, n));
    // eigenvalues of several orders of magnitude, some of them multiple
    const Eigen::MatrixXd q = b.householderQr().householderQ();
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(
        n, [](const Eigen::Index i) { return std::pow(10., -static_cast<double>(i / 3)); });
    const Eigen::MatrixXd c = q * values.asDiagonal() * q.transpose();
    check_eigenpairs((c + c.transpose()) / 2);
  }
}

// As the couplings of eigenvectors that converged long ago are: their squares are no numbers of full
// precision, or zero.
BOOST_AUTO_TEST_CASE(eigenpairs_of_matrices_with_tiny_couplings)
{
  for (const Eigen::Index n : {10, 50})
    for (const double exponent : {100., 145., 155., 158., 160., 162., 165., 200., 300.}) {
      Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
      for (Eigen::Index i = 0; i < n; ++i) {
        a(i, i) = 1. / static_cast<double>(1 + i);
        if (i > 0)
          a(i, 0) = a(0, i) = std::pow(10., -exponent) * static_cast<double>(1 + i % 7);
      }
      check_eigenpairs(a);
    }
}

BOOST_AUTO_TEST_CASE(zero_and_empty_matrices_have_eigenpairs)
{
  const internal::Symmetric_eigenpairs pairs =
      internal::symmetric_eigenpairs(Eigen::MatrixXd::Zero(5, 5));
  BOOST_TEST(pairs.have_converged);
  BOOST_TEST(pairs.values.norm() == 0);
  BOOST_TEST(largest_difference(pairs.vectors.transpose() * pairs.vectors,
                                Eigen::MatrixXd::Identity(5, 5)) == 0);
  BOOST_TEST(internal::symmetric_eigenpairs(Eigen::MatrixXd(0, 0)).values.size() == 0);
}

BOOST_AUTO_TEST_CASE(eigenpairs_of_what_is_no_number_do_not_converge)
{
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(9, 9);
  a(6, 3) = a(3, 6) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!internal::symmetric_eigenpairs(a).have_converged);
}

BOOST_AUTO_TEST_CASE(orthonormality_error_is_that_of_the_matrix_of_products)
{
  std::mt19937 rng(47);
  for (const Eigen::Index n : {1, 9, 511, 512, 1300}) {
    const Eigen::MatrixXd psi = random_matrix(n, 21, rng);
    const Eigen::VectorXd mass = random_matrix(n, 1, rng).cwiseAbs();
    for (const Eigen::Index number : {0, 1, 7, 8, 9, 21}) {
      const auto first = psi.leftCols(number);
      const Eigen::MatrixXd error =
          first.transpose() * mass.asDiagonal() * first - Eigen::MatrixXd::Identity(number, number);
      const double expected = number == 0 ? 0 : error.cwiseAbs().maxCoeff();
      BOOST_TEST(std::abs(internal::orthonormality_error(mass, psi, number) - expected) <=
                 8 * epsilon * static_cast<double>(n + 8));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
