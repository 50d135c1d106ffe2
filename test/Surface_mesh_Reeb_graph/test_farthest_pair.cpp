// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pair of vertices with the largest diffusion distance, against a search among all pairs.

#define BOOST_TEST_MODULE farthest_pair
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"
#include "spectral_shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/farthest_pair.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

BOOST_AUTO_TEST_SUITE(farthest_pairs)

double squared_distance(const Eigen::MatrixXd& eigenfunctions,
                        const Eigen::VectorXd& factors,
                        const std::size_t i,
                        const std::size_t j)
{
  return (eigenfunctions.row(static_cast<Eigen::Index>(i)) -
          eigenfunctions.row(static_cast<Eigen::Index>(j)))
      .cwiseProduct(factors.transpose())
      .squaredNorm();
}

// Not the pair but its length is compared: several pairs may have the same one.
void check_farthest_pair(const Eigen::MatrixXd& eigenfunctions, const Eigen::VectorXd& factors)
{
  const std::size_t n = static_cast<std::size_t>(eigenfunctions.rows());
  double longest = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      longest = (std::max)(longest, squared_distance(eigenfunctions, factors, i, j));
  const auto pair = SMRG::internal::farthest_pair(eigenfunctions, factors);
  BOOST_REQUIRE(pair.first < n);
  BOOST_REQUIRE(pair.second < n);
  // rounding of sums of squares
  BOOST_CHECK_CLOSE_FRACTION(
      squared_distance(eigenfunctions, factors, pair.first, pair.second), longest, 1e-13);
}

BOOST_AUTO_TEST_CASE(farthest_pair_of_random_points_is_that_of_all_pairs)
{
  std::mt19937 rng(17);
  for (int i = 0; i < 1500; ++i) {
    const Eigen::Index n = 2 + static_cast<Eigen::Index>(random_index(40, rng));
    const Eigen::Index dimension = 1 + static_cast<Eigen::Index>(random_index(5, rng));
    // on a lattice, in a ball or on a sphere: ties, few and many candidates
    const std::size_t kind = random_index(3, rng);
    Eigen::MatrixXd points(n, dimension);
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index k = 0; k < dimension; ++k)
        points(p, k) =
            kind == 0 ? static_cast<double>(random_index(4, rng)) : random_unit(rng) - 0.5;
      if (kind == 2 && points.row(p).norm() > 0)
        points.row(p).normalize();
    }
    points(0, 0) += 1; // not all in one point
    Eigen::VectorXd factors(dimension);
    double factor = 1;
    for (Eigen::Index k = 0; k < dimension; ++k) {
      factors[k] = factor;
      factor *= i % 2 == 0 ? 1 : random_unit(rng);
    }
    check_farthest_pair(points, factors);
  }
}

BOOST_AUTO_TEST_CASE(farthest_pair_of_coinciding_points_is_any)
{
  const Eigen::MatrixXd points = Eigen::MatrixXd::Constant(7, 3, 0.25);
  const auto pair = SMRG::internal::farthest_pair(points, Eigen::VectorXd::Ones(3));
  BOOST_TEST(pair.first < 7);
  BOOST_TEST(pair.second < 7);
}

BOOST_AUTO_TEST_CASE(farthest_pair_of_eigenfunctions_is_that_of_all_pairs)
{
  const Index_mesh elongated = transformed(potato(3), [](const std::array<double, 3>& p) {
    return std::array<double, 3>{5 * p[0], p[1] + 0.3 * p[0] * p[0], p[2]};
  });
  // on a sphere every vertex is farthest from its opposite
  for (const Index_mesh& mesh : {elongated, sphere(3), grid(20, 20)}) {
    const Shape shape(mesh, 15);
    const Eigen::MatrixXd psi = shape.eigenfunctions();
    const Eigen::VectorXd lambda = shape.eigenvalues();
    for (const double t : {0., 1., 20., 1e3})
      check_farthest_pair(psi, SMRG::internal::relative_diffusion_factors(lambda, t));
  }
}

BOOST_AUTO_TEST_CASE(farthest_pair_of_an_elongated_shape_are_its_ends)
{
  const Index_mesh mesh = transformed(sphere(3), [](const std::array<double, 3>& p) {
    return std::array<double, 3>{(p[0] > 0 ? 6 : 5) * p[0], p[1], p[2]};
  });
  const Shape shape(mesh);
  const auto [p, q] = SMRG::internal::farthest_pair(
      shape.eigenfunctions(), SMRG::internal::relative_diffusion_factors(shape.eigenvalues(), 20));
  const double x = mesh.points[p][0], y = mesh.points[q][0];
  // the ends are smooth: within two edges of them
  BOOST_TEST((std::max)(x, y) > 5.7);
  BOOST_TEST((std::min)(x, y) < -4.7);
}

BOOST_AUTO_TEST_CASE(relative_factors_order_distances_as_the_absolute_ones_do)
{
  const Shape shape(potato(2));
  const Eigen::VectorXd lambda = shape.eigenvalues();
  for (const double t : {0., 1.5, 20.}) {
    const Eigen::VectorXd relative = SMRG::internal::relative_diffusion_factors(lambda, t);
    const Eigen::VectorXd absolute = SMRG::internal::diffusion_factors(lambda, t);
    BOOST_TEST(relative[0] == 1);
    BOOST_TEST((absolute - std::exp(-t) * relative).cwiseAbs().maxCoeff() <= 1e-13 * absolute[0]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
