// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Laplace-Beltrami eigenpairs and the distances that they give, against the identities that they
// must fulfil and against what the tests compute themselves from coordinates.

#define BOOST_TEST_MODULE Laplace_Beltrami_eigenbasis
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"
#include "spectral_shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

BOOST_AUTO_TEST_SUITE(eigenpairs)

BOOST_AUTO_TEST_CASE(eigenfunctions_are_mass_orthonormal_and_have_no_constant_part)
{
  // of simple and of multiple eigenvalues, with border and without
  for (const Index_mesh& mesh : {potato(3), sphere(3), grid(20, 15), torus(30, 12)}) {
    const Shape shape(mesh);
    const Eigen::VectorXd mass = Reference_operator(mesh).mass;
    const Eigen::MatrixXd psi = shape.eigenfunctions();
    BOOST_TEST(psi.cols() >= 50);
    // what Lanczos with full reorthogonalization gives
    const Eigen::MatrixXd gram = psi.transpose() * mass.asDiagonal() * psi;
    BOOST_TEST((gram - Eigen::MatrixXd::Identity(psi.cols(), psi.cols())).cwiseAbs().maxCoeff() <=
               1e-10);
    // the constant function of norm 1 is 1 / sqrt(area)
    BOOST_TEST((psi.transpose() * mass).cwiseAbs().maxCoeff() / std::sqrt(mass.sum()) <= 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(eigenpairs_solve_the_equation_within_the_residual_reported)
{
  for (const Index_mesh& mesh : {potato(3), grid(20, 15)}) {
    const Shape shape(mesh);
    const Reference_operator reference(mesh);
    const Eigen::MatrixXd psi = shape.eigenfunctions();
    const Eigen::VectorXd lambda = shape.eigenvalues();
    double residual = 0;
    for (Eigen::Index k = 0; k < lambda.size(); ++k) {
      const Eigen::VectorXd l_psi = reference.stiffness * psi.col(k);
      const Eigen::VectorXd m_psi = reference.mass.cwiseProduct(psi.col(k));
      residual =
          (std::max)(residual, (l_psi - lambda[k] * m_psi).norm() / (lambda[k] * m_psi.norm()));
    }
    // measured: 1e-12; the tolerance of the class is 1e-8
    BOOST_TEST(residual <= 1e-10);
    BOOST_TEST(shape.basis.residual() <= 1e-10);
    BOOST_TEST(shape.basis.residual() > 0);
    // Both are sums of rounding errors, and the operators differ by rounding themselves: the same
    // order of magnitude is all that can be asked for.
    BOOST_TEST(residual <= 100 * shape.basis.residual());
  }
}

BOOST_AUTO_TEST_CASE(eigenvalues_increase_and_are_the_energies_of_their_eigenfunctions)
{
  const Index_mesh mesh = potato(3);
  const Shape shape(mesh);
  const Reference_operator reference(mesh);
  const Eigen::MatrixXd psi = shape.eigenfunctions();
  const Eigen::VectorXd lambda = shape.eigenvalues();
  BOOST_TEST(lambda[0] > 0);
  for (Eigen::Index k = 0; k < lambda.size(); ++k) {
    BOOST_CHECK_CLOSE_FRACTION(
        psi.col(k).dot(reference.stiffness * psi.col(k)), lambda[k], eigenvalue_tolerance);
    if (k > 0)
      BOOST_TEST(lambda[k - 1] <= lambda[k]);
  }
}

BOOST_AUTO_TEST_CASE(value_of_largest_magnitude_is_positive)
{
  const Shape shape(potato(3));
  const Eigen::MatrixXd psi = shape.eigenfunctions();
  for (Eigen::Index k = 0; k < psi.cols(); ++k)
    BOOST_TEST(psi.col(k).maxCoeff() >= -psi.col(k).minCoeff());
}

BOOST_AUTO_TEST_CASE(areas_are_those_of_the_coordinates)
{
  const Index_mesh mesh = potato(3);
  const Shape shape(mesh, 5);
  const Eigen::VectorXd mass = Reference_operator(mesh).mass;
  BOOST_CHECK_CLOSE_FRACTION(shape.basis.area(0), surface_area(mesh), 1e-12);
  double difference = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    difference = (std::max)(
        difference,
        std::abs(shape.basis.vertex_area(shape.vertices[v]) / mass[static_cast<Eigen::Index>(v)] -
                 1));
  BOOST_TEST(difference <= 1e-12);
}

// Spherical harmonics of degree l have the eigenvalue l (l + 1) and the multiplicity 2 l + 1.
BOOST_AUTO_TEST_CASE(eigenvalues_of_spheres_converge_to_those_of_spherical_harmonics)
{
  double previous_error = 0;
  for (const std::size_t subdivisions : {2, 3, 4}) {
    const Shape shape(sphere(subdivisions), 15);
    const Eigen::VectorXd lambda = shape.eigenvalues();
    BOOST_REQUIRE(lambda.size() == 15);
    double error = 0;
    Eigen::Index i = 0;
    for (int l = 1; l <= 3; ++l)
      for (int m = 0; m < 2 * l + 1; ++m, ++i)
        error = (std::max)(error, std::abs(lambda[i] / (l * (l + 1)) - 1));
    // linear elements: the error is a quarter when edges are half as long
    if (previous_error > 0) {
      BOOST_TEST(error < 0.27 * previous_error);
      BOOST_TEST(error > 0.2 * previous_error);
    } else {
      BOOST_TEST(error < 0.08); // edges of length 0.3
    }
    previous_error = error;
  }
}

// On a grid of squares the operator is the classical five-point stencil with mirrored borders: its
// eigenfunctions are products of cosines, its eigenvalues are known exactly.
BOOST_AUTO_TEST_CASE(eigenvalues_of_flat_rectangles_are_those_of_cosines)
{
  for (const auto& [m, n] : {std::pair<int, int>(24, 17), std::pair<int, int>(9, 40)}) {
    const Shape shape(grid(static_cast<std::size_t>(m), static_cast<std::size_t>(n)), 30);
    std::vector<double> discrete, continuous;
    for (int i = 0; i <= m; ++i) {
      for (int j = 0; j <= n; ++j) {
        discrete.push_back(4 - 2 * std::cos(i * pi / m) - 2 * std::cos(j * pi / n));
        continuous.push_back(pi * pi * (double(i * i) / (m * m) + double(j * j) / (n * n)));
      }
    }
    std::sort(discrete.begin(), discrete.end());
    std::sort(continuous.begin(), continuous.end());
    const Eigen::VectorXd lambda = shape.eigenvalues();
    BOOST_TEST(lambda.size() >= 30);
    for (Eigen::Index k = 0; k < lambda.size(); ++k) {
      const std::size_t number = static_cast<std::size_t>(k) + 1; // after zero
      BOOST_CHECK_CLOSE_FRACTION(lambda[k], discrete[number], eigenvalue_tolerance);
      // Taylor: 2 - 2 cos x lies between x^2 - x^4 / 12 and x^2
      const double deviation = continuous[number] - lambda[k];
      BOOST_TEST(deviation > 0);
      BOOST_TEST(deviation < continuous[number] * continuous[number] / 12);
    }
  }
}

BOOST_AUTO_TEST_CASE(small_components_have_all_the_eigenpairs_that_there_are)
{
  const std::vector<std::pair<Index_mesh, std::size_t>> cases = {
      {Index_mesh{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}}, {{0, 1, 2}}}, 2},
      {Index_mesh{{{0, 0, 0}, {1, 0, 0}, {-0.5, 0.1, 0}}, {{0, 1, 2}}}, 2},
      {tetrahedron(), 3},
      {sphere(0), 11},
      {symmetric_cube(), 25},
      {potato(1), 41}};
  for (const auto& [mesh, number] : cases) {
    const Shape shape(mesh);
    BOOST_TEST(shape.basis.number_of_eigenpairs(0) == number);
    const Eigen::VectorXd expected = Reference_operator(mesh).eigenvalues();
    BOOST_TEST(
        largest_relative_difference(shape.eigenvalues(), expected.tail(expected.size() - 1)) <=
        eigenvalue_tolerance);
  }
}

// Up to some number of vertices all eigenvalues are computed, above it only those wanted: the
// result is the same, on both sides of the switch.
BOOST_AUTO_TEST_CASE(few_eigenvalues_are_the_smallest_of_all)
{
  for (const Index_mesh& mesh : {potato(1),
                                 potato(2),
                                 grid(6, 5),
                                 grid(7, 5),
                                 grid(8, 5),
                                 grid(9, 5),
                                 torus(9, 5),
                                 torus(10, 5),
                                 cylinder(20, 12)})
  {
    const Eigen::VectorXd all = Reference_operator(mesh).eigenvalues();
    for (const int number : {1, 2, 10, 25}) {
      const Shape shape(mesh, number);
      const Eigen::VectorXd lambda = shape.eigenvalues();
      BOOST_TEST(lambda.size() >= number);
      BOOST_TEST(largest_relative_difference(lambda, all.segment(1, lambda.size())) <=
                 eigenvalue_tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(basis_is_never_cut_inside_a_multiple_eigenvalue)
{
  // multiplicities of up to 5 on the sphere, 3 on the cube; the rectangle's sides are equal
  for (const Index_mesh& mesh : {sphere(2), symmetric_cube(), grid(9, 9)}) {
    const Eigen::VectorXd all = Reference_operator(mesh).eigenvalues();
    for (int number = 1; number <= 40; ++number) {
      const Shape shape(mesh, number);
      const Eigen::VectorXd lambda = shape.eigenvalues();
      // none is missing ...
      BOOST_TEST(lambda.size() >= (std::min)(Eigen::Index(number), all.size() - 1));
      BOOST_TEST(largest_relative_difference(lambda, all.segment(1, lambda.size())) <=
                 eigenvalue_tolerance);
      // ... and the next one, if any, is another eigenvalue. It is extended to the next gap, no
      // further.
      const Eigen::Index next = lambda.size() + 1;
      if (next < all.size())
        BOOST_TEST(all[next] - all[next - 1] > 1e-6 * all[next]);
      for (Eigen::Index k = number; k < lambda.size(); ++k)
        BOOST_TEST(lambda[k] - lambda[k - 1] <= 1e-4 * lambda[k]);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(invariance)

BOOST_AUTO_TEST_CASE(scale_drops_out_of_distances)
{
  const Index_mesh mesh = potato(3);
  const Shape shape(mesh);
  for (const double scale : {1e-150, 1e-100, 1e-3, 1e7, 1e100, 1e150}) {
    const Shape other(scaled(mesh, scale));
    BOOST_TEST(difference_of_distances(shape, other, identity(mesh.points.size())) <=
               distance_tolerance);
    // eigenvalues have the unit of an inverse area, eigenfunctions that of an inverse length
    BOOST_TEST(largest_relative_difference(other.eigenvalues() * scale * scale,
                                           shape.eigenvalues()) <= eigenvalue_tolerance);
    BOOST_CHECK_CLOSE_FRACTION(other.basis.area(0), shape.basis.area(0) * scale * scale, 1e-12);
    BOOST_TEST((other.eigenfunctions() * scale - shape.eigenfunctions()).norm() <=
               1e-8 * shape.eigenfunctions().norm());
  }
}

BOOST_AUTO_TEST_CASE(rigid_motion_drops_out_of_distances)
{
  for (const Index_mesh& mesh : {potato(3), sphere(3), grid(15, 15)}) {
    const Shape shape(mesh), other(rigidly_moved(mesh));
    BOOST_TEST(difference_of_distances(shape, other, identity(mesh.points.size())) <=
               distance_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(numbering_of_the_vertices_drops_out_of_distances)
{
  std::mt19937 rng(5);
  // simple eigenvalues, and exactly symmetric shapes, whose eigenfunctions are arbitrary within
  // the eigenspaces: only whole eigenspaces give distances
  for (const Index_mesh& mesh : {potato(3), sphere(2), sphere(3), symmetric_cube(), grid(12, 12)}) {
    for (const int number : {4, 10, 23, 50}) {
      const std::vector<std::size_t> at = random_permutation(mesh.points.size(), rng);
      const Shape shape(mesh, number), other(renumbered(mesh, at), number);
      BOOST_TEST(shape.basis.number_of_eigenpairs(0) == other.basis.number_of_eigenpairs(0));
      BOOST_TEST(difference_of_distances(shape, other, at) <= distance_tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(symmetric_pairs_have_equal_distances)
{
  // the first twelve vertices are those of the icosahedron: every one has five neighbors among
  // them, five next neighbors and one opposite vertex
  const Index_mesh mesh = sphere(3);
  const Shape shape(mesh, 20);
  std::array<double, 3> first = {0, 0, 0};
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < 12; ++j) {
      if (i == j)
        continue;
      const double cosine = point(mesh, i).dot(point(mesh, j));
      const std::size_t kind = cosine > 0 ? 0 : cosine > -0.9 ? 1 : 2;
      const double distance = shape.commute_time_distance(i, j);
      if (first[kind] == 0)
        first[kind] = distance;
      BOOST_CHECK_CLOSE_FRACTION(distance, first[kind], distance_tolerance);
    }
  }
  BOOST_TEST(first[0] < first[1]);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(components)

BOOST_AUTO_TEST_CASE(every_component_has_the_basis_that_it_has_alone)
{
  const Index_mesh shape = potato(3);
  const Shape alone(shape);
  const Index_mesh vertex{{{0, 0, 0}}, {}};
  const Index_mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}}, {{0, 1, 2}}};
  for (const Index_mesh& fleck : {vertex,
                                  triangle,
                                  tetrahedron(),
                                  scaled(tetrahedron(), 1e-9),
                                  scaled(sphere(1), 1e3),
                                  grid(9, 4)})
  {
    const bool has_pairs = !fleck.triangles.empty();
    const Shape fleck_alone(fleck);
    for (const bool fleck_first : {false, true}) {
      Index_mesh both = fleck_first ? fleck : shape;
      append(both, fleck_first ? moved(shape, -1e4) : fleck, 1e4);
      // shape and fleck at their old places, up to the translation of one of them by 1e4, which
      // rounds coordinates to 1e-12
      const std::size_t shape_begin = fleck_first ? fleck.points.size() : 0;
      const std::size_t fleck_begin = fleck_first ? 0 : shape.points.size();
      const std::size_t c = fleck_first ? 1 : 0;
      const Shape together(both);

      BOOST_TEST(together.basis.number_of_components() == 2);
      BOOST_TEST(together.basis.component_vertices(c).size() == shape.points.size());
      BOOST_TEST(together.basis.component_vertices(1 - c).size() == fleck.points.size());
      BOOST_TEST(together.basis.number_of_eigenpairs(c) == alone.basis.number_of_eigenpairs(0));
      BOOST_TEST(together.basis.number_of_eigenpairs(1 - c) ==
                 fleck_alone.basis.number_of_eigenpairs(0));
      for (std::size_t v = 0; v < both.points.size(); ++v) {
        const bool in_shape = v >= shape_begin && v < shape_begin + shape.points.size();
        BOOST_REQUIRE(together.basis.component(together.vertices[v]) == (in_shape ? c : 1 - c));
      }

      std::vector<std::size_t> at = identity(shape.points.size());
      for (std::size_t& v : at)
        v += shape_begin;
      BOOST_TEST(difference_of_distances(alone, together, at) <= distance_tolerance);
      if (has_pairs && fleck_first) {
        BOOST_TEST(difference_of_distances(fleck_alone, together, identity(fleck.points.size())) <=
                   distance_tolerance);
      }

      const double infinity = std::numeric_limits<double>::infinity();
      BOOST_TEST(together.commute_time_distance(shape_begin, fleck_begin) == infinity);
      BOOST_TEST(together.commute_time_distance(fleck_begin, shape_begin) == infinity);
      BOOST_TEST(together.diffusion_distance(shape_begin + 3, fleck_begin, 1.5) == infinity);
    }
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertices_have_no_eigenpairs)
{
  Index_mesh mesh = tetrahedron();
  mesh.points.push_back({5, 5, 5});
  mesh.points.push_back({5, 5, 5});
  const Shape shape(mesh);
  BOOST_TEST(shape.basis.number_of_components() == 3);
  BOOST_TEST(shape.basis.number_of_eigenpairs(0) == 3);
  for (const std::size_t c : {1, 2}) {
    BOOST_TEST(shape.basis.number_of_eigenpairs(c) == 0);
    BOOST_TEST(shape.basis.area(c) == 0);
    BOOST_TEST(shape.basis.component(shape.vertices[3 + c]) == c);
    BOOST_TEST(shape.basis.vertex_area(shape.vertices[3 + c]) == 0);
    BOOST_TEST(shape.commute_time_distance(3 + c, 3 + c) == 0);
    BOOST_TEST(shape.diffusion_distance(3 + c, 3 + c, 1.5) == 0);
  }
  BOOST_TEST(shape.commute_time_distance(4, 5) == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(meshes_without_faces_have_no_eigenpairs)
{
  const Shape empty((Index_mesh()));
  BOOST_TEST(empty.basis.number_of_components() == 0);
  BOOST_TEST(empty.basis.residual() == 0);
  const Shape points(Index_mesh{{{0, 0, 0}, {1, 2, 3}}, {}});
  BOOST_TEST(points.basis.number_of_components() == 2);
  BOOST_TEST(points.basis.number_of_eigenpairs(0) == 0);
  BOOST_TEST(points.basis.number_of_eigenpairs(1) == 0);
}

BOOST_AUTO_TEST_CASE(removed_elements_do_not_count)
{
  const Index_mesh input = potato(2);
  Index_mesh with_fleck = tetrahedron();
  append(with_fleck, input, 0);
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  make_mesh(with_fleck, mesh, vertices);
  // those of the tetrahedron
  const std::vector<Mesh::Face_index> first_faces(mesh.faces().begin(),
                                                  std::next(mesh.faces().begin(), 4));
  for (const Mesh::Face_index f : first_faces)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  BOOST_REQUIRE(mesh.number_of_vertices() == input.points.size());
  BOOST_REQUIRE(mesh.has_garbage());
  const Eigenbasis basis(mesh);
  const Shape alone(input);
  BOOST_TEST(basis.number_of_components() == 1);
  double difference = 0;
  for (std::size_t v = 0; v < input.points.size(); v += 7)
    difference = (std::max)(difference,
                            std::abs(basis.commute_time_distance(vertices[4], vertices[4 + v]) -
                                     alone.commute_time_distance(0, v)));
  BOOST_TEST(difference <= distance_tolerance);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(distances)

// Distances are roots of sums of squares of differences of eigenfunctions: rounding of the
// eigenfunctions (values of a few units on area 1) is all the error that there is.
constexpr double rounding = 1e-13;

BOOST_AUTO_TEST_CASE(distances_are_metrics)
{
  for (const Index_mesh& mesh : {potato(2), sphere(2), grid(8, 5), tetrahedron()}) {
    const Shape shape(mesh);
    std::vector<std::size_t> sample;
    for (std::size_t v = 0; v < mesh.points.size(); v += 1 + mesh.points.size() / 25)
      sample.push_back(v);
    for (const double t : {-1., 0., 0.5, 1.5, 20.}) {
      const auto d = [&](const std::size_t i, const std::size_t j) {
        return t < 0 ? shape.commute_time_distance(i, j) : shape.diffusion_distance(i, j, t);
      };
      bool is_symmetric = true, is_zero_on_the_diagonal = true, fulfils_triangle_inequality = true;
      for (const std::size_t i : sample) {
        is_zero_on_the_diagonal = is_zero_on_the_diagonal && d(i, i) == 0;
        for (const std::size_t j : sample) {
          is_symmetric = is_symmetric && d(i, j) == d(j, i);
          for (const std::size_t k : sample)
            fulfils_triangle_inequality =
                fulfils_triangle_inequality && d(i, k) <= (d(i, j) + d(j, k)) * (1 + rounding);
        }
      }
      BOOST_TEST(is_symmetric);
      BOOST_TEST(is_zero_on_the_diagonal);
      BOOST_TEST(fulfils_triangle_inequality);
    }
  }
}

BOOST_AUTO_TEST_CASE(different_vertices_have_positive_distances)
{
  const Shape shape(potato(2));
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shape.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      smallest = (std::min)(
          {smallest, shape.commute_time_distance(i, j), shape.diffusion_distance(i, j, 1.5)});
  BOOST_TEST(smallest > 1e-6);
}

BOOST_AUTO_TEST_CASE(distances_are_those_of_the_formulas)
{
  Index_mesh mesh = potato(3);
  append(mesh, scaled(sphere(1), 0.1), 9); // the area of the component, not that of the mesh
  const Shape shape(mesh);
  const std::size_t first_of_sphere = mesh.points.size() - 42;
  for (const auto& [u, v] : {std::pair<std::size_t, std::size_t>(0, 1),
                             std::pair<std::size_t, std::size_t>(17, 345),
                             std::pair<std::size_t, std::size_t>(501, 77),
                             std::make_pair(first_of_sphere, first_of_sphere + 20)})
  {
    const std::size_t c = shape.basis.component(shape.vertices[u]);
    const double first = shape.basis.eigenvalue(c, 1);
    double commute_time = 0;
    std::array<double, 5> diffusion = {0, 0, 0, 0, 0};
    const std::array<double, 5> times = {0, 0.1, 1, 1.5, 20};
    for (std::size_t k = 1; k <= shape.basis.number_of_eigenpairs(c); ++k) {
      const double normalized = shape.basis.eigenvalue(c, k) / first;
      const double difference = shape.basis.eigenfunction(k, shape.vertices[u]) -
                                shape.basis.eigenfunction(k, shape.vertices[v]);
      const double square = shape.basis.area(c) * difference * difference;
      commute_time += square / normalized;
      for (std::size_t i = 0; i < times.size(); ++i)
        diffusion[i] += std::exp(-2 * times[i] * normalized) * square;
    }
    BOOST_CHECK_CLOSE_FRACTION(
        shape.commute_time_distance(u, v), std::sqrt(commute_time), 100 * rounding);
    for (std::size_t i = 0; i < times.size(); ++i)
      BOOST_CHECK_CLOSE_FRACTION(
          shape.diffusion_distance(u, v, times[i]), std::sqrt(diffusion[i]), 100 * rounding);
  }
}

// Of all vertices, at time zero and with all eigenpairs, the squared diffusion distance is that of
// two heat sources of one unit each: the sum of the inverse masses, on area 1.
BOOST_AUTO_TEST_CASE(complete_basis_resolves_single_vertices)
{
  const Index_mesh mesh = potato(1);
  const Shape shape(mesh, 100);
  const Eigen::VectorXd mass = Reference_operator(mesh).mass / surface_area(mesh);
  for (std::size_t i = 1; i < mesh.points.size(); ++i) {
    const double expected = std::sqrt(1 / mass[0] + 1 / mass[static_cast<Eigen::Index>(i)]);
    BOOST_CHECK_CLOSE_FRACTION(shape.diffusion_distance(0, i, 0), expected, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(diffusion_distance_decreases_with_time)
{
  const Shape shape(potato(3));
  for (std::size_t i = 1; i < shape.vertices.size(); i += 41) {
    double previous = std::numeric_limits<double>::infinity();
    for (const double t : {0., 1e-3, 0.1, 0.5, 1., 1.5, 2., 5., 20., 100.}) {
      const double distance = shape.diffusion_distance(0, i, t);
      BOOST_TEST(distance < previous);
      BOOST_TEST(distance > 0);
      previous = distance;
    }
  }
}

BOOST_AUTO_TEST_CASE(large_times_give_small_numbers_and_no_nan)
{
  for (const Index_mesh& mesh : {potato(2), tetrahedron(), grid(3, 3)}) {
    const Shape shape(mesh);
    for (const double t : {0., 20., 1e3, 1e300}) {
      const double distance = shape.diffusion_distance(0, 2, t);
      BOOST_TEST(std::isfinite(distance));
      // `exp(-t)` times the largest distance at time zero, 1e3 at most on such meshes; below that
      // the root of the smallest number
      BOOST_TEST(distance >= 0);
      BOOST_TEST(distance <= 1e3 * std::exp(-t) + 1e-150);
    }
  }
}

BOOST_AUTO_TEST_CASE(eigenfunction_and_mapping_function_are_those_of_the_basis)
{
  Index_mesh mesh = potato(2);
  append(mesh, tetrahedron(), 9);
  append(mesh, Index_mesh{{{0, 0, 0}}, {}}, 20);
  const Shape shape(mesh, 10);
  Mesh copy = shape.mesh;
  auto values = copy.add_property_map<vertex_descriptor, double>("v:value", -1).first;

  SMRG::eigenfunction(shape.basis, 4, values);
  for (const vertex_descriptor v : shape.vertices)
    BOOST_TEST(values[v] == (shape.basis.component(v) == 0 ? shape.basis.eigenfunction(4, v) : 0));

  const std::vector<vertex_descriptor> points = {
      shape.vertices[3], shape.vertices[90], shape.vertices[162]};
  SMRG::commute_time_function(shape.basis, points, values);
  for (const vertex_descriptor v : shape.vertices) {
    double expected = 0;
    for (const vertex_descriptor p : points)
      if (shape.basis.component(p) == shape.basis.component(v))
        expected = (std::max)(expected, shape.basis.commute_time_distance(p, v));
    BOOST_TEST(std::abs(values[v] - expected) <= rounding * (1 + expected));
  }

  for (const std::size_t k : {0, 11}) {
    std::fill(values.begin(), values.end(), -1);
    BOOST_CHECK_THROW(SMRG::eigenfunction(shape.basis, k, values), CGAL::Precondition_exception);
    BOOST_TEST(std::all_of(values.begin(), values.end(), [](double x) { return x == -1; }));
  }
}

BOOST_AUTO_TEST_SUITE_END()
