// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stiffness and mass matrices against the identities that they must fulfil and against what the
// tests compute from coordinates, and the eigenbasis of meshes with degenerate faces.

#define BOOST_TEST_MODULE Laplace_Beltrami_matrices
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"
#include "spectral_shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

BOOST_AUTO_TEST_SUITE(intrinsic_triangle)

const std::vector<std::array<std::array<double, 3>, 3>> triangles = {
    {{{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0}}},             // acute
    {{{0, 0, 1}, {1, 0, 1}, {0.5, std::sqrt(0.75), 1}}}, // equilateral
    {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}},                 // right
    {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}},                 // right, isosceles
    {{{0, 0, 0}, {1, 0, 0}, {-0.7, 0.3, 2}}},            // obtuse
    {{{0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}}},            // obtuse, flat
    {{{0, 0, 0}, {1e-4, 0, 0}, {0, 0, 1}}},              // needle, right
    {{{0, 0, 0}, {1e-4, 0, 0}, {5e-5, 1, 0}}},           // needle, acute
    {{{0, 0, 0}, {1e-4, 0, 0}, {-0.8, 0, 0.6}}}};        // needle, obtuse

struct Triangle_data
{
  explicit Triangle_data(const std::array<std::array<double, 3>, 3>& coordinates)
  {
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = Eigen::Vector3d(coordinates[i][0], coordinates[i][1], coordinates[i][2]);
    for (std::size_t i = 0; i < 3; ++i)
      lengths[i] = (p[(i + 1) % 3] - p[(i + 2) % 3]).norm();
    longest = *std::max_element(lengths.begin(), lengths.end());
    area = triangle_area(p[0], p[1], p[2]);
    // A cotangent is a sum of squared lengths over the area: what is left after cancellation has
    // the rounding of the largest square. The area has the rounding of the lengths, which counts
    // as much as the triangle is narrow.
    cotangent_error = 16 * epsilon * longest * longest / area * (1 + longest * longest / area);
    area_error = 16 * epsilon * area * (1 + longest * longest / area);
  }

  std::array<Eigen::Vector3d, 3> p;
  std::array<double, 3> lengths;
  double longest, area, cotangent_error, area_error;
};

BOOST_AUTO_TEST_CASE(area_and_cotangents_are_those_of_the_coordinates)
{
  for (const auto& coordinates : triangles) {
    const Triangle_data data(coordinates);
    const SMRG::internal::Intrinsic_triangle t(data.lengths);
    BOOST_TEST(std::abs(t.area() - data.area) <= data.area_error);
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = cotangent(data.p[i], data.p[(i + 1) % 3], data.p[(i + 2) % 3]);
      BOOST_TEST(std::abs(t.cotangent(static_cast<int>(i)) - expected) <=
                 data.cotangent_error * (1 + std::abs(expected)));
    }
  }
}

BOOST_AUTO_TEST_CASE(mixed_areas_are_those_of_the_regions_and_sum_to_the_area)
{
  for (const auto& coordinates : triangles) {
    const Triangle_data data(coordinates);
    const SMRG::internal::Intrinsic_triangle t(data.lengths);
    const double error = data.area_error + data.longest * data.longest * data.cotangent_error;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double mixed = t.mixed_voronoi_area(static_cast<int>(i));
      BOOST_TEST(mixed > 0);
      BOOST_TEST(
          std::abs(mixed - mixed_area(data.p[i], data.p[(i + 1) % 3], data.p[(i + 2) % 3])) <=
          error);
      sum += mixed;
    }
    BOOST_TEST(std::abs(sum - t.area()) <= error);
  }
}

BOOST_AUTO_TEST_CASE(obtuse_corner_has_half_of_the_area)
{
  const SMRG::internal::Intrinsic_triangle t({1.9, 1, 1}); // obtuse at corner 0
  BOOST_TEST(t.mixed_voronoi_area(0) == t.area() / 2);
  BOOST_TEST(t.mixed_voronoi_area(1) == t.area() / 4);
  BOOST_TEST(t.mixed_voronoi_area(2) == t.area() / 4);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(matrices)

SMRG::internal::Laplace_Beltrami_matrices matrices_of(const Index_mesh& input)
{
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  make_mesh(input, mesh, vertices);
  const SMRG::internal::Mesh_components<Mesh> components(mesh);
  return SMRG::internal::assemble_Laplace_Beltrami_matrices(mesh, mesh.points(), components, 0);
}

const std::vector<Index_mesh> meshes = {
    potato(2), torus(12, 7), cylinder(9, 5), grid(6, 5), symmetric_cube()};

BOOST_AUTO_TEST_CASE(stiffness_matrix_is_symmetric_and_its_rows_sum_to_zero)
{
  for (const Index_mesh& mesh : meshes) {
    const Eigen::MatrixXd stiffness = matrices_of(mesh).stiffness.toDense();
    BOOST_TEST((stiffness - stiffness.transpose()).norm() == 0);
    // sums of some ten cotangents of well-shaped triangles
    BOOST_TEST(stiffness.rowwise().sum().cwiseAbs().maxCoeff() <= 100 * epsilon);
  }
}

BOOST_AUTO_TEST_CASE(stiffness_matrix_is_positive_semidefinite_with_the_constants_as_kernel)
{
  for (const Index_mesh& mesh : meshes) {
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrices_of(mesh).stiffness.toDense())
            .eigenvalues();
    const double rounding = 1e-13 * values.maxCoeff();
    BOOST_TEST(values[0] >= -rounding);
    BOOST_TEST(values[0] <= rounding);
    BOOST_TEST(values[1] > 1e-3); // connected; these meshes have a few hundred vertices at most
  }
}

BOOST_AUTO_TEST_CASE(masses_sum_to_the_surface_area)
{
  for (const Index_mesh& mesh : meshes) {
    const SMRG::internal::Laplace_Beltrami_matrices matrices = matrices_of(mesh);
    const double expected = surface_area(mesh) / (matrices.unit * matrices.unit);
    BOOST_TEST(matrices.mass.minCoeff() > 0);
    BOOST_CHECK_CLOSE_FRACTION(matrices.area, expected, 1e-12);
    BOOST_CHECK_CLOSE_FRACTION(matrices.mass.sum(), expected, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(unit_is_the_mean_edge_length)
{
  // two legs of length 1 for every hypotenuse
  BOOST_CHECK_CLOSE_FRACTION(matrices_of(grid(4, 4)).unit, (2 + std::sqrt(2.)) / 3, 1e-14);
  BOOST_CHECK_CLOSE_FRACTION(matrices_of(scaled(tetrahedron(), 7)).unit, 7 * std::sqrt(8.), 1e-14);
}

BOOST_AUTO_TEST_CASE(mollification_changes_nothing_on_good_meshes)
{
  for (const Index_mesh& mesh : meshes) {
    const SMRG::internal::Laplace_Beltrami_matrices matrices = matrices_of(mesh);
    const Reference_operator reference(mesh);
    // rounding only; lengths increased by 1e-5 would show
    BOOST_TEST((matrices.stiffness - reference.stiffness).norm() <=
               1e-13 * reference.stiffness.norm());
    BOOST_TEST((matrices.unit * matrices.unit * matrices.mass - reference.mass).norm() <=
               1e-13 * reference.mass.norm());
  }
}

BOOST_AUTO_TEST_CASE(Laplacian_of_a_linear_function_vanishes_inside_a_flat_mesh)
{
  constexpr std::size_t m = 8, n = 7;
  std::mt19937 rng(3);
  Index_mesh mesh = grid(m, n);
  for (std::size_t i = 1; i < m; ++i) {
    for (std::size_t j = 1; j < n; ++j) {
      mesh.points[i * (n + 1) + j][0] += 0.3 * (random_unit(rng) - 0.5);
      mesh.points[i * (n + 1) + j][1] += 0.3 * (random_unit(rng) - 0.5);
    }
  }
  // flat, but not in a coordinate plane
  const SMRG::internal::Laplace_Beltrami_matrices matrices = matrices_of(rigidly_moved(mesh));
  Eigen::VectorXd linear(matrices.mass.size());
  for (Eigen::Index v = 0; v < linear.size(); ++v)
    linear[v] = 2 * mesh.points[static_cast<std::size_t>(v)][0] -
                3 * mesh.points[static_cast<std::size_t>(v)][1] + 1;
  const Eigen::VectorXd laplacian = matrices.stiffness * linear;
  double inside = 0, on_border = 0;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      double& largest = i % m == 0 || j % n == 0 ? on_border : inside;
      largest =
          (std::max)(largest, std::abs(laplacian[static_cast<Eigen::Index>(i * (n + 1) + j)]));
    }
  }
  // values of up to 40, cotangents of a few units
  BOOST_TEST(inside <= 1e-12);
  BOOST_TEST(on_border > 0.1);
}

BOOST_AUTO_TEST_CASE(scale_drops_out_of_both_matrices)
{
  const SMRG::internal::Laplace_Beltrami_matrices expected = matrices_of(potato(2));
  for (const double scale : {1e-140, 1e-3, 1e150}) {
    const SMRG::internal::Laplace_Beltrami_matrices matrices =
        matrices_of(scaled(potato(2), scale));
    BOOST_CHECK_CLOSE_FRACTION(matrices.unit, scale * expected.unit, 1e-13);
    BOOST_TEST((matrices.stiffness - expected.stiffness).norm() <=
               1e-13 * expected.stiffness.norm());
    BOOST_TEST((matrices.mass - expected.mass).norm() <= 1e-13 * expected.mass.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(degenerate_input)

// One vertex moves onto a neighbor (two faces without area and two points that coincide), onto the
// middle of an edge of its link (a face with three collinear corners), or nearly so.
enum Defect {
  COINCIDING_POINTS,
  COLLINEAR_POINTS,
  NEARLY_COINCIDING_POINTS,
  NEARLY_COLLINEAR_POINTS
};

Index_mesh with_defects(Index_mesh mesh, const Defect defect, const std::size_t number)
{
  std::mt19937 rng(11);
  for (std::size_t i = 0; i < number; ++i) {
    const auto& t = mesh.triangles[random_index(mesh.triangles.size(), rng)];
    const Eigen::Vector3d from = point(mesh, t[0]), a = point(mesh, t[1]), b = point(mesh, t[2]);
    const Eigen::Vector3d to =
        defect == COINCIDING_POINTS || defect == NEARLY_COINCIDING_POINTS ? a : (a + b) / 2;
    const double rest = defect == COINCIDING_POINTS || defect == COLLINEAR_POINTS ? 0 : 1e-9;
    const Eigen::Vector3d p = to + rest * (from - to);
    mesh.points[t[0]] = {p[0], p[1], p[2]};
  }
  return mesh;
}

BOOST_AUTO_TEST_CASE(degenerate_faces_do_no_harm)
{
  const Index_mesh good = potato(3);
  const Shape shape(good, 20);
  for (const Defect defect :
       {COINCIDING_POINTS, COLLINEAR_POINTS, NEARLY_COINCIDING_POINTS, NEARLY_COLLINEAR_POINTS})
  {
    for (const std::size_t number : {1, 10}) {
      const Shape other(with_defects(good, defect, number), 20);
      BOOST_TEST(is_sound(other));
      // Some of 642 vertices have moved by one edge, which is 3 % of the diameter: the shape is
      // the same within a few percent, and so are low eigenvalues, and distances at a time at
      // which high ones do not count (measured: up to 7 %).
      BOOST_TEST(largest_relative_difference(other.eigenvalues().head(10),
                                             shape.eigenvalues().head(10)) <= 0.03);
      BOOST_TEST(difference_of_distances(shape, other, identity(good.points.size()), {1, 1.5}) <=
                 0.1);
    }
  }
}

BOOST_AUTO_TEST_CASE(degenerate_faces_of_large_meshes_keep_residuals_small)
{
  const Index_mesh good = potato(5); // 10242 vertices
  for (const Defect defect : {COINCIDING_POINTS, COLLINEAR_POINTS, NEARLY_COLLINEAR_POINTS})
    BOOST_TEST(is_sound(Shape(with_defects(good, defect, 3), 6)));
}

BOOST_AUTO_TEST_CASE(needles_do_no_harm)
{
  // a cylinder of triangles a hundred times as long as wide
  BOOST_TEST(is_sound(Shape(cylinder(100, 2, 12))));
  // the same ones among well-shaped triangles
  Index_mesh mesh = cylinder(100, 20, 1.2);
  for (auto& p : mesh.points)
    if (p[2] > 1.17)
      p[2] = 6;
  BOOST_TEST(is_sound(Shape(mesh)));
  // one corner far away: a spike
  mesh = potato(2);
  mesh.points[5] = {1e3, 2e3, 3e3};
  BOOST_TEST(is_sound(Shape(mesh)));
}

// What is as thin as the lengths are mollified is at the limits of double precision: a sound basis,
// with residuals up to the root of the tolerance where rounding explains them, or an error that says
// what could not be computed.
BOOST_AUTO_TEST_CASE(extremely_thin_surfaces_are_sound_or_an_error)
{
  const Index_mesh collinear = transformed(potato(2), [](const std::array<double, 3>& p) {
    return std::array<double, 3>{p[0], 2 * p[0], 0};
  });
  Index_mesh spike = potato(2);
  spike.points[5] = {1e7, 2e7, 3e7};
  for (const Index_mesh& mesh : {collinear, spike, cylinder(100, 2, 6e4)}) {
    const std::string message = error_of(mesh);
    if (message.empty())
      BOOST_TEST(is_sound(Shape(mesh), 1e-4));
    else
      BOOST_TEST((contains(message, "residual") || contains(message, "eigenvalue zero")));
  }
}

// Debris of bad faces beside a shape: a component that has few vertices, so that all of its
// eigenpairs are computed, also those with huge eigenvalues that thin faces make.
BOOST_AUTO_TEST_CASE(debris_of_degenerate_faces_does_not_spoil_another_component)
{
  const Index_mesh good = potato(2);
  const Shape alone(good);
  Index_mesh collapsed_edge = tetrahedron();
  collapsed_edge.points[0] = collapsed_edge.points[1];
  Index_mesh flat_tetrahedron = tetrahedron();
  flat_tetrahedron.points[0] = {-1. / 3, -1. / 3, -1. / 3}; // in the middle of the opposite face
  Index_mesh collinear_fan = grid(2, 2);
  collinear_fan.points[4] = {0.5, 0.5, 0}; // onto the middle of an edge
  Index_mesh crumpled = sphere(0);
  for (auto& p : crumpled.points)
    for (double& x : p)
      x = std::round(x); // 12 points on 27 places
  Index_mesh crumpled_sphere = sphere(1);
  for (auto& p : crumpled_sphere.points)
    for (double& x : p)
      x = std::round(x);
  for (const Index_mesh& debris :
       {collapsed_edge, flat_tetrahedron, collinear_fan, crumpled, crumpled_sphere})
  {
    Index_mesh both = good;
    append(both, debris, 0);
    const std::string message = error_of(both);
    BOOST_TEST(message == "");
    if (!message.empty())
      continue;
    const Shape shape(both);
    BOOST_TEST(is_sound(shape));
    BOOST_TEST(shape.basis.number_of_eigenpairs(1) > 0);
    BOOST_TEST(difference_of_distances(alone, shape, identity(good.points.size())) <=
               distance_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(component_of_coinciding_points_does_not_spoil_another_one)
{
  const Index_mesh good = potato(2);
  const Shape alone(good);
  for (const bool bad_first : {false, true}) {
    Index_mesh bad = sphere(1);
    for (auto& p : bad.points)
      p = {7, 7, 7};
    Index_mesh both = bad_first ? bad : good;
    append(both, bad_first ? good : bad, 0);
    const std::size_t c = bad_first ? 1 : 0;
    const Shape shape(both);
    BOOST_TEST(is_sound(shape));
    BOOST_TEST(shape.basis.number_of_eigenpairs(1 - c) == 0);
    BOOST_TEST(shape.basis.area(1 - c) == 0);
    const std::size_t bad_begin = bad_first ? 0 : good.points.size();
    BOOST_TEST(shape.commute_time_distance(bad_begin, bad_begin + 5) == 0);
    BOOST_TEST(shape.diffusion_distance(bad_begin, bad_begin + 5, 1.5) == 0);
    std::vector<std::size_t> at = identity(good.points.size());
    for (std::size_t& v : at)
      v += bad_first ? 42 : 0;
    BOOST_TEST(difference_of_distances(alone, shape, at) <= distance_tolerance);
  }
}

// Surfaces of any topology, also pinched ones, with points on a coarse lattice: faces without area
// and coinciding points everywhere.
BOOST_AUTO_TEST_CASE(random_surfaces_with_points_on_a_lattice_are_sound)
{
  std::mt19937 rng(2026);
  for (int i = 0; i < 150; ++i) {
    Index_mesh mesh = random_small_mesh(rng, i % 3 == 0);
    if (mesh.triangles.empty())
      continue;
    const std::size_t side = 2 + random_index(3, rng);
    for (auto& p : mesh.points)
      for (double& x : p)
        x = static_cast<double>(random_index(side, rng));
    mesh.points[mesh.triangles[0][0]][0] = -1; // not all in one point
    const std::string message = error_of(mesh, 20);
    BOOST_TEST_CONTEXT("mesh " << i)
    BOOST_TEST(message == "");
    if (message.empty())
      BOOST_TEST(is_sound(Shape(mesh, 20)));
  }
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_an_error_that_names_the_vertex)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
  {
    for (const std::size_t axis : {0, 1, 2}) {
      Index_mesh mesh = potato(1);
      mesh.points[7][axis] = bad;
      const std::string message = error_of(mesh);
      BOOST_TEST(contains(message, "not a finite number"));
      BOOST_TEST(contains(message, "vertex 7"));
    }
  }
  // of an isolated vertex as well
  Index_mesh mesh = potato(1);
  mesh.points.push_back({0, std::numeric_limits<double>::quiet_NaN(), 0});
  BOOST_TEST(contains(error_of(mesh), "vertex 42 is not a finite number"));
}

BOOST_AUTO_TEST_CASE(coordinates_too_large_for_lengths_are_an_error_that_names_the_component)
{
  Index_mesh mesh = tetrahedron();
  append(mesh, scaled(tetrahedron(), 1.7e308), 0);
  const std::string message = error_of(mesh);
  BOOST_TEST(contains(message, "too large"));
  BOOST_TEST(contains(message, "component 1 (4 vertices)"));
}

BOOST_AUTO_TEST_CASE(surface_without_area_is_an_error)
{
  Index_mesh mesh = potato(1);
  for (auto& p : mesh.points)
    p = {1, 2, 3};
  BOOST_TEST(contains(error_of(mesh), "no area"));
  append(mesh, Index_mesh{{{0, 0, 0}}, {}}, 9); // an isolated vertex does not help
  BOOST_TEST(contains(error_of(mesh), "no area"));
}

BOOST_AUTO_TEST_CASE(number_of_eigenpairs_must_be_positive)
{
  for (const int number : {0, -1, -50})
    BOOST_CHECK_THROW(Shape(potato(1), number), CGAL::Precondition_exception);
  BOOST_TEST(error_of(potato(1), 1) == "");
}

BOOST_AUTO_TEST_CASE(residual_above_the_tolerance_is_an_error_that_names_the_eigenpair)
{
  const std::string message =
      error_of(potato(2), SMRG::parameters::number_of_eigenpairs(5).residual_tolerance(0));
  BOOST_TEST(contains(message, "eigenpair 1"));
  BOOST_TEST(contains(message, "tolerance"));
  BOOST_TEST(contains(message, "component 0 (162 vertices)"));
}

BOOST_AUTO_TEST_CASE(diffusion_times_must_be_numbers_that_are_not_negative)
{
  const Shape shape(potato(2));
  for (const double bad : {-1.,
                           std::numeric_limits<double>::quiet_NaN(),
                           // a distance at infinite time is zero everywhere and has no farthest
                           // pair and no maxima
                           std::numeric_limits<double>::infinity()})
  {
    std::vector<vertex_descriptor> points;
    BOOST_CHECK_THROW(SMRG::feature_points(shape.basis,
                                           std::back_inserter(points),
                                           SMRG::parameters::small_time(bad)),
                      CGAL::Precondition_exception);
    BOOST_CHECK_THROW(SMRG::feature_points(shape.basis,
                                           std::back_inserter(points),
                                           SMRG::parameters::large_time(bad)),
                      CGAL::Precondition_exception);
    BOOST_TEST(points.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
