// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of one or several sources over a whole mesh, against sums in extended precision and the
// distances of single pairs; times at which the numbers get very small; float and double.

#define BOOST_TEST_MODULE spectral_distances
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/farthest_pair.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;
using Float_eigenbasis =
    SMRG::Laplace_Beltrami_eigenbasis<Mesh, SMRG::Block_Lanczos_eigensolver<>, float>;
using Eigenbases = boost::mpl::list<Eigenbasis, Float_eigenbasis>;
using Matrix_types = boost::mpl::list<Eigen::MatrixXf, Eigen::MatrixXd>;

namespace {

// -------------------------------------------------------------------------------------------------
// Matrices

template <class Matrix>
Matrix random_matrix(const Eigen::Index rows, const Eigen::Index columns, std::mt19937& rng)
{
  Matrix result(rows, columns);
  for (Eigen::Index i = 0; i < columns; ++i)
    for (Eigen::Index r = 0; r < rows; ++r)
      result(r, i) = static_cast<typename Matrix::Scalar>(random_unit(rng) - 0.5);
  return result;
}

// Decreasing from 1, as those of all distances.
Eigen::VectorXd random_factors(const Eigen::Index number, std::mt19937& rng)
{
  Eigen::VectorXd result(number);
  double factor = 1;
  for (double& x : result) {
    x = factor;
    factor *= 0.5 + random_unit(rng) / 2;
  }
  return result;
}

std::vector<std::size_t>
random_sources(const std::size_t number, const Eigen::Index rows, std::mt19937& rng)
{
  std::vector<std::size_t> result(number);
  for (std::size_t& source : result)
    source = random_index(static_cast<std::size_t>(rows), rng);
  return result;
}

// In the order of definition and with more digits.
template <class Matrix>
long double exact_squared_distance(const Matrix& eigenfunctions,
                                   const Eigen::VectorXd& factors,
                                   const Eigen::Index a,
                                   const Eigen::Index b)
{
  long double result = 0;
  for (Eigen::Index i = 0; i < factors.size(); ++i) {
    const long double difference =
        static_cast<long double>(factors[i]) * (static_cast<long double>(eigenfunctions(a, i)) -
                                                static_cast<long double>(eigenfunctions(b, i)));
    result += difference * difference;
  }
  return result;
}

// The largest relative error of `largest_squared_distances()`; infinity where zero does not come
// out as zero.
template <class Matrix>
double relative_error(const Matrix& eigenfunctions,
                      const Eigen::VectorXd& factors,
                      const std::vector<std::size_t>& sources)
{
  const Eigen::VectorXd computed =
      SMRG::internal::largest_squared_distances(eigenfunctions, factors, sources);
  BOOST_REQUIRE_EQUAL(computed.size(), eigenfunctions.rows());
  double result = 0;
  for (Eigen::Index r = 0; r < eigenfunctions.rows(); ++r) {
    long double expected = 0;
    for (const std::size_t source : sources)
      expected = (std::max)(
          expected,
          exact_squared_distance(eigenfunctions, factors, r, static_cast<Eigen::Index>(source)));
    const long double error = std::abs(static_cast<long double>(computed[r]) - expected);
    if (error > 0)
      result = (std::max)(result, static_cast<double>(error / expected));
  }
  return result;
}

// Sums of 60 squares, and for several sources of three numbers of up to four times the result.
constexpr double rounding = 1e-13;

// -------------------------------------------------------------------------------------------------
// Meshes

// A sphere pushed out of shape, and more components.
Index_mesh several_components()
{
  Index_mesh mesh = sphere(2);
  for (auto& p : mesh.points) {
    const double r = 1 + 0.2 * std::sin(2 * p[0] + 0.4) + 0.1 * std::cos(3 * p[1] - p[2]);
    p = {1.5 * r * p[0], 1.1 * r * p[1], 0.9 * r * p[2]};
  }
  append(mesh, grid(4, 3), 10);
  append(mesh, Index_mesh{{{0, 0, 0}}, {}}, 20); // an isolated vertex
  return mesh;
}

struct Shape
{
  Shape() { make_mesh(several_components(), mesh, vertices); }

  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
};

using Distances = std::map<vertex_descriptor, double>;

template <class Function>
Distances distances_of(const Function& function)
{
  Distances distances;
  function(boost::make_assoc_property_map(distances));
  return distances;
}

// The logarithm of the diffusion distance at any time: of sums of exponentials, the largest one
// taken out.
long double log_diffusion_distance(const Eigenbasis& basis,
                                   const vertex_descriptor u,
                                   const vertex_descriptor v,
                                   const double t)
{
  const auto& b = basis.basis(basis.component(u));
  std::vector<long double> logarithms;
  for (Eigen::Index k = 0; k < b.eigenvalues.size(); ++k) {
    const long double ratio = static_cast<long double>(b.eigenvalues[k]) / b.eigenvalues[0];
    const long double difference =
        static_cast<long double>(
            b.eigenfunctions(static_cast<Eigen::Index>(basis.position(u)), k)) -
        b.eigenfunctions(static_cast<Eigen::Index>(basis.position(v)), k);
    logarithms.push_back(-2 * t * ratio + 2 * std::log(std::abs(difference)));
  }
  const long double largest = *std::max_element(logarithms.begin(), logarithms.end());
  long double sum = 0;
  for (const long double logarithm : logarithms)
    sum += std::exp(logarithm - largest);
  return (largest + std::log(sum) + std::log(static_cast<long double>(b.area))) / 2;
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(kernels)

BOOST_AUTO_TEST_CASE_TEMPLATE(distances_are_those_in_extended_precision, Matrix, Matrix_types)
{
  constexpr unsigned seed = 1;
  std::mt19937 rng(seed);
  // around the sizes of blocks of rows and of groups of columns and sources
  for (const Eigen::Index rows : {1, 3, 4, 119, 120, 121, 240, 511, 512, 513, 1100}) {
    for (const Eigen::Index columns : {1, 2, 3, 4, 5, 8, 11, 60}) {
      const Matrix matrix = random_matrix<Matrix>(rows, columns, rng);
      const Eigen::VectorXd factors = random_factors(columns, rng);
      for (const std::size_t number : {0, 1, 2, 4, 5, 6, 9, 13}) {
        BOOST_TEST_CONTEXT("seed " << seed << ", " << rows << " rows, " << columns << " columns, "
                                   << number << " sources")
        BOOST_TEST(relative_error(matrix, factors, random_sources(number, rows, rng)) <= rounding);
      }
    }
  }
}

// Differences of numbers that agree in half of their digits.
BOOST_AUTO_TEST_CASE_TEMPLATE(distances_between_near_rows_are_as_precise, Matrix, Matrix_types)
{
  constexpr unsigned seed = 2;
  std::mt19937 rng(seed);
  using Scalar = typename Matrix::Scalar;
  const Scalar nearness = std::sqrt(std::numeric_limits<Scalar>::epsilon());
  for (int i = 0; i < 20; ++i) {
    Matrix matrix = nearness * random_matrix<Matrix>(300, 20, rng);
    matrix.rowwise() += random_matrix<Matrix>(1, 20, rng).row(0);
    matrix.topRows(100) += random_matrix<Matrix>(100, 20, rng); // and others far away
    const Eigen::VectorXd factors = random_factors(20, rng);
    for (const std::size_t number : {1, 2, 7}) {
      std::vector<std::size_t> sources = random_sources(number, 200, rng);
      for (std::size_t& source : sources)
        source += 100; // near ones
      BOOST_TEST_CONTEXT("seed " << seed << ", matrix " << i << ", " << number << " sources")
      BOOST_TEST(relative_error(matrix, factors, sources) <= rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(distance_of_a_source_from_itself_is_zero, Matrix, Matrix_types)
{
  std::mt19937 rng(3);
  const Matrix matrix = random_matrix<Matrix>(700, 50, rng);
  const Eigen::VectorXd factors = random_factors(50, rng);
  for (const std::size_t source : {0, 5, 511, 512, 699}) {
    const auto row = static_cast<Eigen::Index>(source);
    for (const std::size_t times : {1, 2, 3, 6}) {
      const std::vector<std::size_t> sources(times, source);
      BOOST_TEST(SMRG::internal::largest_squared_distances(matrix, factors, sources)[row] == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(farthest_pair_is_that_of_all_pairs, Matrix, Matrix_types)
{
  constexpr unsigned seed = 4;
  std::mt19937 rng(seed);
  for (int i = 0; i < 100; ++i) {
    const auto rows = 2 + static_cast<Eigen::Index>(random_index(600, rng));
    const auto columns = 1 + static_cast<Eigen::Index>(random_index(6, rng));
    const Matrix matrix = random_matrix<Matrix>(rows, columns, rng);
    const Eigen::VectorXd factors = random_factors(columns, rng);
    double longest = 0;
    for (Eigen::Index r = 0; r < rows; ++r)
      longest = (std::max)(
          longest,
          SMRG::internal::largest_squared_distances(matrix, factors, {static_cast<std::size_t>(r)})
              .maxCoeff());
    const auto pair = SMRG::internal::farthest_pair(matrix, factors);
    BOOST_TEST_CONTEXT("seed " << seed << ", matrix " << i)
    BOOST_CHECK_CLOSE_FRACTION(
        static_cast<double>(exact_squared_distance(matrix,
                                                   factors,
                                                   static_cast<Eigen::Index>(pair.first),
                                                   static_cast<Eigen::Index>(pair.second))),
        longest,
        rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(factors)

BOOST_AUTO_TEST_CASE(factors_are_those_of_the_definitions)
{
  const Eigen::Vector3d eigenvalues(2, 3, 10);
  const Eigen::VectorXd diffusion = SMRG::internal::diffusion_factors(eigenvalues, 0.7);
  const Eigen::VectorXd relative = SMRG::internal::relative_diffusion_factors(eigenvalues, 0.7);
  const Eigen::VectorXd commute_time = SMRG::internal::commute_time_factors(eigenvalues);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double ratio = eigenvalues[i] / 2;
    BOOST_CHECK_CLOSE_FRACTION(diffusion[i] * diffusion[i], std::exp(-1.4 * ratio), 1e-14);
    BOOST_CHECK_CLOSE_FRACTION(relative[i] * std::exp(-0.7), diffusion[i], 1e-14);
    BOOST_CHECK_CLOSE_FRACTION(commute_time[i] * commute_time[i], 1 / ratio, 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(factors_are_numbers_at_all_times)
{
  const Eigen::Vector3d eigenvalues(1, 3, 1e6);
  for (const double t : {0., 1., 200., 700., 1e5, 1e300, (std::numeric_limits<double>::max)()}) {
    const Eigen::VectorXd diffusion = SMRG::internal::diffusion_factors(eigenvalues, t);
    const Eigen::VectorXd relative = SMRG::internal::relative_diffusion_factors(eigenvalues, t);
    BOOST_TEST(diffusion.allFinite());
    BOOST_TEST(relative.allFinite());
    BOOST_TEST(relative[0] == 1);
  }
  // its square is not a number any more
  BOOST_CHECK_CLOSE_FRACTION(
      SMRG::internal::diffusion_factors(eigenvalues, 200)[1], std::exp(-600.), 1e-12);
}

BOOST_AUTO_TEST_CASE(without_eigenvalues_there_are_no_factors)
{
  const Eigen::VectorXd none(0);
  BOOST_TEST(SMRG::internal::diffusion_factors(none, 1).size() == 0);
  BOOST_TEST(SMRG::internal::relative_diffusion_factors(none, 1).size() == 0);
  BOOST_TEST(SMRG::internal::commute_time_factors(none).size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_FIXTURE_TEST_SUITE(distances_on_meshes, Shape)

BOOST_AUTO_TEST_CASE_TEMPLATE(distances_of_one_source_are_those_of_pairs, Basis, Eigenbases)
{
  const Basis basis(mesh);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // in every component; the last one is isolated
  for (const std::size_t s :
       {std::size_t(0), std::size_t(77), std::size_t(170), vertices.size() - 1}) {
    const vertex_descriptor source = vertices[s];
    for (const double t : {0., 0.3, 1.5, 20., 300.}) {
      const Distances distances =
          distances_of([&](auto map) { SMRG::diffusion_distances(basis, source, t, map); });
      BOOST_TEST(distances.size() == vertices.size());
      BOOST_TEST(distances.at(source) == 0);
      for (const vertex_descriptor v : vertices) {
        if (basis.component(v) == basis.component(source))
          BOOST_CHECK_CLOSE_FRACTION(
              distances.at(v), basis.diffusion_distance(source, v, t), 1e-12);
        else
          BOOST_TEST(distances.at(v) == infinity);
      }
    }
    const Distances distances =
        distances_of([&](auto map) { SMRG::commute_time_distances(basis, source, map); });
    BOOST_TEST(distances.size() == vertices.size());
    BOOST_TEST(distances.at(source) == 0);
    for (const vertex_descriptor v : vertices) {
      if (basis.component(v) == basis.component(source))
        BOOST_CHECK_CLOSE_FRACTION(distances.at(v), basis.commute_time_distance(source, v), 1e-13);
      else
        BOOST_TEST(distances.at(v) == infinity);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(commute_time_function_is_the_largest_distance, Basis, Eigenbases)
{
  const Basis basis(mesh);
  const std::vector<vertex_descriptor> points = {
      vertices[3], vertices[60], vertices[61], vertices[62], vertices[150], vertices[163]};
  std::vector<Distances> of_points;
  for (const vertex_descriptor point : points)
    of_points.push_back(
        distances_of([&](auto map) { SMRG::commute_time_distances(basis, point, map); }));
  const Distances values =
      distances_of([&](auto map) { SMRG::commute_time_function(basis, points, map); });
  for (const vertex_descriptor v : vertices) {
    double expected = 0;
    for (const Distances& distances : of_points)
      if (std::isfinite(distances.at(v)))
        expected = (std::max)(expected, distances.at(v));
    BOOST_CHECK_CLOSE_FRACTION(values.at(v), expected, 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(eigenfunctions_of_type_float_are_the_rounded_ones)
{
  const Eigenbasis basis(mesh);
  const Float_eigenbasis float_basis(mesh);
  BOOST_TEST(float_basis.residual() == basis.residual());
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    const std::size_t number = basis.number_of_eigenpairs(c);
    BOOST_TEST_REQUIRE(float_basis.number_of_eigenpairs(c) == number);
    for (std::size_t k = 1; k <= number; ++k) {
      BOOST_TEST(float_basis.eigenvalue(c, k) == basis.eigenvalue(c, k));
      for (const vertex_descriptor v : basis.component_vertices(c)) {
        const double value = basis.eigenfunction(k, v);
        BOOST_TEST(std::abs(float_basis.eigenfunction(k, v) - value) <=
                   6e-8 * std::abs(value) + (std::numeric_limits<float>::min)());
      }
    }
  }

  // and so are the distances, in the end
  const std::vector<vertex_descriptor> points = {vertices[3], vertices[60], vertices[163]};
  const Distances values =
      distances_of([&](auto map) { SMRG::commute_time_function(basis, points, map); });
  const Distances float_values =
      distances_of([&](auto map) { SMRG::commute_time_function(float_basis, points, map); });
  double largest = 0, largest_difference = 0;
  for (const vertex_descriptor v : vertices) {
    largest = (std::max)(largest, values.at(v));
    largest_difference =
        (std::max)(largest_difference, std::abs(float_values.at(v) - values.at(v)));
  }
  BOOST_TEST(largest_difference > 0);
  BOOST_TEST(largest_difference < 1e-6 * largest);
  const Distances eigenfunction =
      distances_of([&](auto map) { SMRG::eigenfunction(float_basis, 2, map); });
  for (const vertex_descriptor v : basis.component_vertices(0))
    BOOST_TEST(eigenfunction.at(v) == float_basis.eigenfunction(2, v));
}

// On a shape without any symmetry, where rounding does not decide.
BOOST_AUTO_TEST_CASE(feature_points_are_those_from_rounded_eigenfunctions)
{
  Index_mesh lump = sphere(3);
  for (auto& p : lump.points) {
    const double r = 1 + 0.2 * std::sin(2 * p[0] + 0.4) + 0.15 * std::cos(3 * p[1] - p[2] + 0.5) +
                     0.1 * std::sin(2 * p[1] + 3 * p[2] + 1);
    p = {1.5 * r * p[0], 1.1 * r * p[1], 0.9 * r * p[2]};
  }
  Mesh lump_mesh;
  std::vector<vertex_descriptor> lump_vertices;
  make_mesh(lump, lump_mesh, lump_vertices);
  std::vector<vertex_descriptor> points, float_points;
  SMRG::feature_points(Eigenbasis(lump_mesh), std::back_inserter(points));
  SMRG::feature_points(Float_eigenbasis(lump_mesh), std::back_inserter(float_points));
  BOOST_TEST(points.size() > 1);
  BOOST_TEST(float_points == points, boost::test_tools::per_element());
}

// Until they are smaller than all numbers.
BOOST_AUTO_TEST_CASE(diffusion_distances_are_precise_at_large_times)
{
  const Eigenbasis basis(mesh);
  const std::vector<double> times = {0, 1, 20, 100, 300, 372, 400, 600, 700};
  for (const double t : times) {
    const Distances distances =
        distances_of([&](auto map) { SMRG::diffusion_distances(basis, vertices[10], t, map); });
    for (std::size_t i = 11; i < 162; i += 10) {
      const double expected = static_cast<double>(
          std::exp(log_diffusion_distance(basis, vertices[10], vertices[i], t)));
      BOOST_TEST_CONTEXT("time " << t << ", vertex " << i)
      {
        BOOST_TEST(expected > 0);
        // the rounding of the exponent
        const double tolerance = 1e-13 + 1e-15 * t;
        BOOST_CHECK_CLOSE_FRACTION(
            basis.diffusion_distance(vertices[10], vertices[i], t), expected, tolerance);
        BOOST_CHECK_CLOSE_FRACTION(distances.at(vertices[i]), expected, tolerance);
      }
    }
  }
  for (const double t : {1e4, 1e300})
    BOOST_TEST(basis.diffusion_distance(vertices[10], vertices[11], t) == 0);
}

BOOST_AUTO_TEST_CASE(times_that_are_negative_or_not_finite_violate_a_precondition)
{
  const Eigenbasis basis(mesh);
  for (const double t : {-1.,
                         -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()})
  {
    Distances distances;
    BOOST_CHECK_THROW(basis.diffusion_distance(vertices[0], vertices[1], t),
                      CGAL::Precondition_exception);
    BOOST_CHECK_THROW(
        SMRG::diffusion_distances(basis, vertices[0], t, boost::make_assoc_property_map(distances)),
        CGAL::Precondition_exception);
    BOOST_TEST(distances.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
