// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The intrinsic Delaunay triangulation of a mesh and the Laplace-Beltrami operator on it, against
// the identities that they must fulfil, CGAL's Delaunay triangulation of the plane, and energies
// that the tests compute themselves.

#define BOOST_TEST_MODULE intrinsic_Delaunay
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_Delaunay.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangulation.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;
using Matrices = SMRG::internal::Laplace_Beltrami_matrices;
using Triangulation = SMRG::internal::Intrinsic_triangulation;
using Side = SMRG::internal::Triangle_side;
using SMRG::internal::Intrinsic_triangle;
using SMRG::internal::no_triangle_side;

namespace {

// -------------------------------------------------------------------------------------------------
// What is tested

Mesh mesh_of(const Index_mesh& input)
{
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  make_mesh(input, mesh, vertices);
  return mesh;
}

// A component of a mesh with the gluing of its triangles, before and after flipping.
struct Flipped
{
  explicit Flipped(const Index_mesh& input, const std::size_t component = 0)
  {
    const Mesh mesh = mesh_of(input);
    const SMRG::internal::Mesh_components<Mesh> components(mesh);
    before = SMRG::internal::intrinsic_triangulation(
        mesh, get(CGAL::vertex_point, mesh), components, component);
    glued_before = SMRG::internal::glued_sides(mesh, components, component);
    after = before;
    glued_after = glued_before;
    number_of_flips = SMRG::internal::Intrinsic_Delaunay(after, glued_after).flip_all();
  }

  Triangulation before, after;
  std::vector<Side> glued_before, glued_after;
  std::size_t number_of_flips;
};

Matrices matrices_of(const Index_mesh& input, const bool use_intrinsic_Delaunay)
{
  const Mesh mesh = mesh_of(input);
  const SMRG::internal::Mesh_components<Mesh> components(mesh);
  BOOST_REQUIRE_EQUAL(components.size(), 1u);
  return SMRG::internal::assemble_Laplace_Beltrami_matrices(
      mesh, get(CGAL::vertex_point, mesh), components, 0, use_intrinsic_Delaunay);
}

Eigen::VectorXd vertex_areas(const Matrices& matrices)
{
  return matrices.mass * matrices.unit * matrices.unit;
}

double largest_difference(const Matrices& a, const Matrices& b)
{
  return Eigen::MatrixXd(a.stiffness - b.stiffness).cwiseAbs().maxCoeff();
}

double largest_coefficient_outside_of_the_diagonal(const Matrices& matrices)
{
  Eigen::MatrixXd coefficients = matrices.stiffness;
  coefficients.diagonal().setConstant(coefficients.minCoeff());
  return coefficients.maxCoeff();
}

double cotangent(const Triangulation& triangulation, const Side side)
{
  return Intrinsic_triangle(triangulation.triangles[side / 3].lengths)
      .cotangent(static_cast<int>(side % 3));
}

double area(const Triangulation& triangulation)
{
  double result = 0;
  for (const Triangulation::Triangle& triangle : triangulation.triangles)
    result += Intrinsic_triangle(triangle.lengths).area();
  return result;
}

std::size_t corner(const Triangulation& triangulation, const Side side, const Side step)
{
  return triangulation.triangles[side / 3].corners[(side + step) % 3];
}

// Sides are glued in pairs, with the same length and the same ends in opposite order.
bool is_glued_well(const Triangulation& triangulation, const std::vector<Side>& glued)
{
  for (Side side = 0; side < glued.size(); ++side) {
    const Side other = glued[side];
    if (other == no_triangle_side)
      continue;
    // corner numbers follow those of the sides within a triangle: 3 t is a multiple of 3
    if (other == side || glued[other] != side ||
        triangulation.triangles[side / 3].lengths[side % 3] !=
            triangulation.triangles[other / 3].lengths[other % 3] ||
        corner(triangulation, side, 1) != corner(triangulation, other, 2) ||
        corner(triangulation, side, 2) != corner(triangulation, other, 1))
      return false;
  }
  return true;
}

// The smallest sum of the two cotangents opposite to an edge, relative to the sum of all six.
double
smallest_sum_of_cotangents(const Triangulation& triangulation, const std::vector<Side>& glued)
{
  double result = 0;
  for (Side side = 0; side < glued.size(); ++side) {
    const Side other = glued[side];
    if (other == no_triangle_side)
      continue;
    double all = 0;
    for (const Side t : {side / 3, other / 3})
      all += Intrinsic_triangle(triangulation.triangles[t].lengths).sum_of_cotangents();
    const double sum = cotangent(triangulation, side) + cotangent(triangulation, other);
    result = (std::min)(result, sum / all);
  }
  return result;
}

// The precision to which flips can tell whether an edge is Delaunay, see `Intrinsic_Delaunay`.
constexpr double rounding = 1e-13;

// -------------------------------------------------------------------------------------------------
// Shapes

Eigen::Vector3d point(const Index_mesh& mesh, const std::size_t v)
{
  return Eigen::Vector3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
}

Eigen::Vector3d
normal(const Index_mesh& mesh, const std::size_t a, const std::size_t b, const std::size_t c)
{
  return (point(mesh, b) - point(mesh, a)).cross(point(mesh, c) - point(mesh, a));
}

// By how much the triangle inequalities hold.
double margin(const Index_mesh& mesh, const std::size_t a, const std::size_t b, const std::size_t c)
{
  const std::array<double, 3> l = {(point(mesh, a) - point(mesh, b)).norm(),
                                   (point(mesh, b) - point(mesh, c)).norm(),
                                   (point(mesh, c) - point(mesh, a)).norm()};
  return l[0] + l[1] + l[2] - 2 * *std::max_element(l.begin(), l.end());
}

// Flips edges at random between faces that lie in one plane: the surface stays the same.
void flip_flat_edges(Index_mesh& mesh, const std::size_t attempts, std::mt19937& rng)
{
  std::map<Index_edge, std::size_t> triangle_of; // of a directed edge
  const auto enter = [&](const std::size_t triangle) {
    const auto& t = mesh.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i)
      triangle_of[{t[i], t[(i + 1) % 3]}] = triangle;
  };
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    enter(triangle);
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t left = random_index(mesh.triangles.size(), rng), i = random_index(3, rng);
    const std::size_t a = mesh.triangles[left][i], b = mesh.triangles[left][(i + 1) % 3],
                      c = mesh.triangles[left][(i + 2) % 3];
    const auto opposite = triangle_of.find({b, a});
    if (opposite == triangle_of.end())
      continue;
    const std::size_t right = opposite->second;
    const auto& t = mesh.triangles[right];
    const std::size_t d = t[0] + t[1] + t[2] - a - b;
    if (triangle_of.count({c, d}) != 0 || triangle_of.count({d, c}) != 0)
      continue;
    // all four triangles must look in the same direction, and none be so thin that its lengths are
    // mollified
    const Eigen::Vector3d n = normal(mesh, a, b, c).normalized();
    constexpr double smallest = 1e-3;
    if (n.dot(normal(mesh, b, a, d).normalized()) < 1 - 1e-9 || normal(mesh, a, d, c).dot(n) <= 0 ||
        normal(mesh, d, b, c).dot(n) <= 0 || margin(mesh, a, d, c) < smallest ||
        margin(mesh, d, b, c) < smallest)
      continue;
    triangle_of.erase({a, b});
    triangle_of.erase({b, a});
    mesh.triangles[left] = {a, d, c};
    mesh.triangles[right] = {d, b, c};
    enter(left);
    enter(right);
  }
}

double random_shift(std::mt19937& rng)
{
  return 0.6 * (random_unit(rng) - 0.5);
}

// A grid whose points are moved at random, on the border along it.
Index_mesh random_grid(const std::size_t m, const std::size_t n, std::mt19937& rng)
{
  Index_mesh mesh = grid(m, n);
  for (auto& p : mesh.points) {
    if (p[0] > 0 && p[0] < static_cast<double>(m))
      p[0] += random_shift(rng);
    if (p[1] > 0 && p[1] < static_cast<double>(n))
      p[1] += random_shift(rng);
  }
  return mesh;
}

// The surface of a cube of side m in m x m squares per face, whose points are moved at random
// within faces and along edges.
Index_mesh random_cube(const std::size_t m, std::mt19937& rng)
{
  Index_mesh mesh;
  std::map<std::array<std::size_t, 3>, std::size_t> numbers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::size_t side : {std::size_t(0), m}) {
      const auto number = [&](const std::size_t i, const std::size_t j) {
        std::array<std::size_t, 3> p;
        p[axis] = side;
        // so that all normals point outwards
        p[(axis + 1) % 3] = side > 0 ? i : j;
        p[(axis + 2) % 3] = side > 0 ? j : i;
        const auto inserted = numbers.emplace(p, mesh.points.size());
        if (inserted.second) {
          std::array<double, 3> q;
          for (std::size_t k = 0; k < 3; ++k)
            q[k] = static_cast<double>(p[k]) + (p[k] == 0 || p[k] == m ? 0 : random_shift(rng));
          mesh.points.push_back(q);
        }
        return inserted.first->second;
      };
      const auto triangles = split_quads(m, m, number);
      mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    }
  }
  return mesh;
}

// A sphere with points at random heights: acute, obtuse and thin triangles.
Index_mesh rough_sphere(const std::size_t subdivisions, const double roughness, std::mt19937& rng)
{
  Index_mesh mesh = sphere(subdivisions);
  for (auto& p : mesh.points) {
    const double r = 1 + roughness * (random_unit(rng) - 0.5);
    p = {r * p[0], 1.5 * r * p[1], 3 * r * p[2]};
  }
  return mesh;
}

// The tip p of a thin cone, a vertex v near to it and all others far away: the shortest way from v
// around the tip comes back to v.
Index_mesh lone_vertex_on_a_thin_cone()
{
  const auto at = [](const double height, const double turn) {
    const double angle = 2 * std::acos(-1.) * turn;
    return std::array<double, 3>{
        0.05 * height * std::cos(angle), 0.05 * height * std::sin(angle), height};
  };
  return {{{0, 0, 0}, at(1, 0), at(10, 0.35), at(10, 0.7), {0, 0, 12}},
          {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}};
}

// Shapes of every kind with random coordinates.
std::vector<Index_mesh> random_shapes(const unsigned seed, const int number)
{
  std::mt19937 rng(seed);
  std::vector<Index_mesh> result = {lone_vertex_on_a_thin_cone()};
  for (int i = 0; i < number; ++i) {
    Index_mesh mesh = i % 3 == 0   ? rough_sphere(2, 0.8, rng)
                      : i % 3 == 1 ? closed_surface(1 + random_index(3, rng), 4, 5)
                                   : random_grid(7, 6, rng);
    flip_random_edges(mesh, random_index(2 * mesh.triangles.size(), rng), rng);
    if (i % 3 == 1) {
      for (auto& p : mesh.points)
        for (double& x : p)
          x += random_shift(rng);
    }
    result.push_back(mesh);
  }
  return result;
}

// -------------------------------------------------------------------------------------------------
// Energies

// The integral of the squared gradient of the function that is linear on every triangle, the
// triangle laid out in the plane.
double Dirichlet_energy(const Triangulation& triangulation, const Eigen::VectorXd& f)
{
  double result = 0;
  for (const Triangulation::Triangle& t : triangulation.triangles) {
    // corner 0 at the origin, corner 1 on the x-axis
    const double a = t.lengths[0], b = t.lengths[1], c = t.lengths[2];
    const double x = (b * b + c * c - a * a) / (2 * c);
    const double y = std::sqrt((b - x) * (b + x));
    const double df1 = f[t.corners[1]] - f[t.corners[0]], df2 = f[t.corners[2]] - f[t.corners[0]];
    const double slope_x = df1 / c, slope_y = (df2 - slope_x * x) / y;
    result += (slope_x * slope_x + slope_y * slope_y) * c * y / 2;
  }
  return result;
}

Eigen::VectorXd random_function(const Eigen::Index n, std::mt19937& rng)
{
  Eigen::VectorXd result(n);
  for (double& x : result)
    x = random_unit(rng) - 0.5;
  return result;
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(triangulation)

BOOST_AUTO_TEST_CASE(triangles_stay_glued_and_become_Delaunay)
{
  constexpr unsigned seed = 1;
  int number = 0;
  std::size_t flips = 0;
  for (const Index_mesh& mesh : random_shapes(seed, 60)) {
    const Flipped flipped(mesh);
    BOOST_TEST_CONTEXT("seed " << seed << ", shape " << number++)
    {
      BOOST_TEST(is_glued_well(flipped.before, flipped.glued_before));
      BOOST_TEST(is_glued_well(flipped.after, flipped.glued_after));
      BOOST_TEST(smallest_sum_of_cotangents(flipped.after, flipped.glued_after) >= -rounding);
      BOOST_TEST(std::abs(area(flipped.after) - area(flipped.before)) <=
                 1e-12 * area(flipped.before));
      flips += flipped.number_of_flips;
    }
  }
  BOOST_TEST(flips > 1000u);
}

// Every side of a triangle of the mesh that is not on a border is glued.
BOOST_AUTO_TEST_CASE(borders_are_left_alone)
{
  std::mt19937 rng(2);
  Index_mesh mesh = random_grid(9, 5, rng);
  flip_flat_edges(mesh, 500, rng);
  const Flipped flipped(mesh);
  BOOST_TEST(flipped.number_of_flips > 0u);
  const auto border = [](const Triangulation& triangulation, const std::vector<Side>& glued) {
    std::map<std::pair<std::size_t, std::size_t>, double> lengths;
    for (Side side = 0; side < glued.size(); ++side)
      if (glued[side] == no_triangle_side)
        lengths[{corner(triangulation, side, 1), corner(triangulation, side, 2)}] =
            triangulation.triangles[side / 3].lengths[side % 3];
    return lengths;
  };
  const auto before = border(flipped.before, flipped.glued_before);
  BOOST_TEST(before.size() == 28u);
  BOOST_TEST((before == border(flipped.after, flipped.glued_after)));
}

BOOST_AUTO_TEST_CASE(Delaunay_meshes_are_not_changed)
{
  // equilateral triangles up to rounding
  Index_mesh lattice = grid(6, 8);
  for (auto& p : lattice.points)
    p = {p[0] - p[1] / 2, std::sqrt(0.75) * p[1], 0};
  // right ones: both diagonals of the squares are Delaunay
  for (const Index_mesh& mesh : {sphere(3), lattice, grid(7, 5)}) {
    BOOST_TEST(Flipped(mesh).number_of_flips == 0u);
    const Matrices without = matrices_of(mesh, false), with = matrices_of(mesh, true);
    BOOST_TEST(largest_difference(with, without) == 0);
    BOOST_TEST((with.mass.array() == without.mass.array()).all());
    BOOST_TEST(with.area == without.area);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_left_to_flip_after_flipping)
{
  for (const Index_mesh& mesh : random_shapes(3, 30)) {
    Flipped flipped(mesh);
    BOOST_TEST(SMRG::internal::Intrinsic_Delaunay(flipped.after, flipped.glued_after).flip_all() ==
               0u);
  }
}

BOOST_AUTO_TEST_CASE(vertices_get_edges_to_themselves)
{
  const Flipped flipped(lone_vertex_on_a_thin_cone());
  std::size_t loops = 0;
  for (Side side = 0; side < flipped.glued_after.size(); ++side)
    loops += corner(flipped.after, side, 1) == corner(flipped.after, side, 2);
  BOOST_TEST(loops > 0u);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(matrices)

BOOST_AUTO_TEST_CASE(coefficients_outside_of_the_diagonal_are_not_positive)
{
  std::mt19937 rng(4);
  for (int i = 0; i < 20; ++i) {
    for (const Index_mesh& mesh : {rough_sphere(2, 1, rng), random_cube(4, rng)}) {
      BOOST_TEST(largest_coefficient_outside_of_the_diagonal(matrices_of(mesh, true)) <= rounding);
    }
  }
  BOOST_TEST(largest_coefficient_outside_of_the_diagonal(
                 matrices_of(rough_sphere(2, 1, rng), false)) > 0.1);
}

BOOST_AUTO_TEST_CASE(areas_are_those_of_the_surface)
{
  for (const Index_mesh& mesh : random_shapes(5, 30)) {
    const Matrices without = matrices_of(mesh, false), with = matrices_of(mesh, true);
    BOOST_TEST(with.unit == without.unit);
    BOOST_CHECK_CLOSE_FRACTION(with.area, without.area, 1e-12);
    BOOST_CHECK_CLOSE_FRACTION(with.mass.sum(), with.area, 1e-12);
    BOOST_TEST(with.mass.minCoeff() > 0);
  }
}

// With the triangles laid out one by one in the plane, loops and multiple edges included.
BOOST_AUTO_TEST_CASE(quadratic_form_is_the_Dirichlet_energy)
{
  std::mt19937 rng(6);
  for (const Index_mesh& mesh : random_shapes(6, 30)) {
    const Matrices matrices = matrices_of(mesh, true);
    const Flipped flipped(mesh);
    BOOST_TEST(
        (matrices.stiffness - Eigen::SparseMatrix<double>(matrices.stiffness.transpose())).norm() ==
        0);
    const Eigen::Index n = matrices.mass.size();
    BOOST_TEST((matrices.stiffness * Eigen::VectorXd::Ones(n)).cwiseAbs().maxCoeff() <=
               1e-13 * matrices.stiffness.diagonal().maxCoeff());
    for (int i = 0; i < 5; ++i) {
      const Eigen::VectorXd f = random_function(n, rng);
      BOOST_CHECK_CLOSE_FRACTION(
          f.dot(matrices.stiffness * f), Dirichlet_energy(flipped.after, f), 1e-9);
    }
  }
}

// Rippa's theorem: of all triangulations of a surface, the Delaunay one has the least energy,
// whatever the function.
BOOST_AUTO_TEST_CASE(flips_decrease_the_energy_of_every_function)
{
  std::mt19937 rng(7);
  for (const Index_mesh& mesh : random_shapes(7, 30)) {
    const Eigen::MatrixXd difference =
        matrices_of(mesh, false).stiffness - matrices_of(mesh, true).stiffness;
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(difference, Eigen::EigenvaluesOnly)
            .eigenvalues();
    BOOST_TEST(eigenvalues[0] >= -1e-12 * eigenvalues[eigenvalues.size() - 1]);
  }
}

BOOST_AUTO_TEST_CASE(
    triangulations_of_a_square_give_one_operator_that_of_the_planar_Delaunay_triangulation)
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact_kernel>;
  using Planar_Delaunay =
      CGAL::Delaunay_triangulation_2<Exact_kernel,
                                     CGAL::Triangulation_data_structure_2<Vertex_base>>;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 rng(seed);
    const Index_mesh mesh = random_grid(8, 8, rng);
    std::vector<std::pair<Exact_kernel::Point_2, std::size_t>> points;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      points.emplace_back(Exact_kernel::Point_2(mesh.points[v][0], mesh.points[v][1]), v);
    const Planar_Delaunay planar(points.begin(), points.end());
    Index_mesh delaunay{mesh.points, {}};
    for (auto f = planar.finite_faces_begin(); f != planar.finite_faces_end(); ++f)
      delaunay.triangles.push_back(
          {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    const Matrices expected = matrices_of(delaunay, false);

    for (std::size_t attempts : {0, 100, 10000}) {
      Index_mesh other = mesh;
      flip_flat_edges(other, attempts, rng);
      const Matrices matrices = matrices_of(other, true);
      BOOST_TEST_CONTEXT("seed " << seed << ", " << attempts << " attempts")
      {
        BOOST_TEST(largest_difference(matrices, expected) <= 1e-10);
        BOOST_TEST((vertex_areas(matrices) - vertex_areas(expected)).cwiseAbs().maxCoeff() <=
                   1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(triangulations_of_a_polyhedron_give_one_operator)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 rng(seed);
    Index_mesh mesh = random_cube(4, rng);
    const Matrices expected = matrices_of(mesh, true);
    for (int i = 0; i < 3; ++i) {
      flip_flat_edges(mesh, 5000, rng);
      const Matrices matrices = matrices_of(mesh, true);
      BOOST_TEST_CONTEXT("seed " << seed << ", triangulation " << i)
      {
        // the triangulations themselves do differ
        BOOST_TEST(largest_difference(matrices_of(mesh, false), expected) > 0.1);
        BOOST_TEST(largest_difference(matrices, expected) <= 1e-10);
        BOOST_TEST((vertex_areas(matrices) - vertex_areas(expected)).cwiseAbs().maxCoeff() <=
                   1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(linear_functions_on_flat_meshes_are_harmonic)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 rng(seed);
    Index_mesh mesh = random_grid(9, 7, rng);
    flip_flat_edges(mesh, 1000, rng);
    const Matrices matrices = matrices_of(mesh, true);
    Eigen::VectorXd f(matrices.mass.size());
    for (Eigen::Index v = 0; v < f.size(); ++v) {
      const auto& p = mesh.points[static_cast<std::size_t>(v)];
      f[v] = 2 * p[0] - 3 * p[1] + 1;
    }
    const Eigen::VectorXd lf = matrices.stiffness * f;
    for (Eigen::Index v = 0; v < f.size(); ++v) {
      const auto& p = mesh.points[static_cast<std::size_t>(v)];
      if (p[0] > 0 && p[0] < 9 && p[1] > 0 && p[1] < 7) {
        BOOST_TEST_CONTEXT("seed " << seed)
        BOOST_TEST(std::abs(lf[v]) <= 1e-11);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(eigenbasis)

BOOST_AUTO_TEST_CASE(mesh_is_not_changed)
{
  std::mt19937 rng(8);
  const Mesh mesh = mesh_of(rough_sphere(2, 1, rng));
  const Mesh copy = mesh;
  const Eigenbasis basis(mesh, SMRG::parameters::use_intrinsic_Delaunay(true));
  BOOST_TEST(basis.residual() <= 1e-8);
  for (const auto h : halfedges(mesh)) {
    BOOST_TEST((target(h, mesh) == target(h, copy)));
    BOOST_TEST((next(h, mesh) == next(h, copy)));
    BOOST_TEST((face(h, mesh) == face(h, copy)));
  }
  for (const auto v : vertices(mesh))
    BOOST_TEST((mesh.point(v) == copy.point(v)));
}

BOOST_AUTO_TEST_CASE(option_is_off_by_default_and_passed_on)
{
  std::mt19937 rng(9);
  const Mesh mesh = mesh_of(rough_sphere(2, 1, rng));
  const double by_default = Eigenbasis(mesh).eigenvalue(0, 1);
  const double without =
      Eigenbasis(mesh, SMRG::parameters::use_intrinsic_Delaunay(false)).eigenvalue(0, 1);
  const double with =
      Eigenbasis(mesh, SMRG::parameters::use_intrinsic_Delaunay(true)).eigenvalue(0, 1);
  BOOST_TEST(by_default == without);
  BOOST_TEST(with < 0.999 * without); // Rippa's theorem again

  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::use_intrinsic_Delaunay(true));
  BOOST_TEST(num_vertices(graph) > 0u);
}

BOOST_AUTO_TEST_CASE(distances_do_not_depend_on_the_triangulation_of_flat_faces)
{
  std::mt19937 rng(10);
  Index_mesh input = random_cube(5, rng);
  const Mesh mesh = mesh_of(input);
  flip_flat_edges(input, 10000, rng);
  const Mesh other = mesh_of(input);
  const auto np = SMRG::parameters::use_intrinsic_Delaunay(true).number_of_eigenpairs(20);
  const Eigenbasis basis(mesh, np), other_basis(other, np);
  const vertex_descriptor source = *vertices(mesh).begin();
  for (const vertex_descriptor v : vertices(mesh))
    BOOST_TEST(std::abs(basis.commute_time_distance(source, v) -
                        other_basis.commute_time_distance(source, v)) <= 1e-9);
}

// Random surfaces of any topology, also pinched ones and several components, with points on a
// coarse lattice: faces without area and coinciding points everywhere.
BOOST_AUTO_TEST_CASE(degenerate_faces_do_no_harm)
{
  constexpr unsigned seed = 11;
  std::mt19937 rng(seed);
  for (int i = 0; i < 150; ++i) {
    Index_mesh input = random_small_mesh(rng, i % 3 == 0);
    if (input.triangles.empty())
      continue;
    const std::size_t side = 2 + random_index(3, rng);
    for (auto& p : input.points)
      for (double& x : p)
        x = static_cast<double>(random_index(side, rng));
    input.points[input.triangles[0][0]][0] = -1; // not all in one point
    const Mesh mesh = mesh_of(input);
    BOOST_TEST_CONTEXT("seed " << seed << ", mesh " << i)
    {
      const Eigenbasis basis(
          mesh, SMRG::parameters::use_intrinsic_Delaunay(true).number_of_eigenpairs(20));
      BOOST_TEST(basis.residual() <= 1e-8);
      for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
        if (basis.area(c) == 0)
          continue;
        const Flipped flipped(input, c);
        BOOST_TEST(is_glued_well(flipped.after, flipped.glued_after));
        BOOST_TEST(smallest_sum_of_cotangents(flipped.after, flipped.glued_after) >= -rounding);
        BOOST_CHECK_CLOSE_FRACTION(area(flipped.after), area(flipped.before), 1e-9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(needles_and_caps_do_no_harm)
{
  // needles a hundred times as long as wide; a spike; caps, as thin as the lengths are mollified
  Index_mesh spike = sphere(2);
  spike.points[5] = {1e3, 2e3, 3e3};
  std::mt19937 rng(12);
  Index_mesh caps = random_grid(12, 12, rng);
  for (auto& p : caps.points)
    p[1] *= 1e-4;
  for (const Index_mesh& input : {cylinder(100, 2, 12), spike, caps}) {
    const Mesh mesh = mesh_of(input);
    const Eigenbasis basis(mesh,
                           SMRG::parameters::use_intrinsic_Delaunay(true).number_of_eigenpairs(10));
    BOOST_TEST(basis.residual() <= 1e-8);
    BOOST_TEST(basis.eigenvalue(0, 1) > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
