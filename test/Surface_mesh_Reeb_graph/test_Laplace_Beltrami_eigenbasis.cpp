// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Laplace-Beltrami operator, its eigenpairs and the distances that they give, against the
// identities that they must fulfil and against what the tests compute themselves from coordinates.

#define BOOST_TEST_MODULE Laplace_Beltrami_eigenbasis
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Spectra_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_basis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Laplace_Beltrami_matrices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/farthest_pair.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
#include <malloc.h>
#define REEB_GRAPH_TEST_COUNTS_MEMORY
#endif

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const double pi = std::acos(-1.);

// A mesh, its vertices in the order of the points that it was made from, and its basis.
template <class Eigensolver>
struct Shape_with_solver
{
  using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh, Eigensolver>;

  template <class NamedParameters>
  Shape_with_solver(const Index_mesh& input, const NamedParameters& np)
    : mesh(with_vertices(input, vertices)), basis(mesh, np)
  {}
  explicit Shape_with_solver(const Index_mesh& input, const int number_of_eigenpairs = 50)
    : Shape_with_solver(input, SMRG::parameters::number_of_eigenpairs(number_of_eigenpairs))
  {}
  // the basis points to the mesh
  Shape_with_solver(const Shape_with_solver&) = delete;
  Shape_with_solver& operator=(const Shape_with_solver&) = delete;

  Eigen::VectorXd eigenvalues(const std::size_t component = 0) const
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(basis.number_of_eigenpairs(component)));
    for (Eigen::Index i = 0; i < result.size(); ++i)
      result[i] = basis.eigenvalue(component, static_cast<std::size_t>(i) + 1);
    return result;
  }

  // n x k, for meshes with one component
  Eigen::MatrixXd eigenfunctions() const
  {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(vertices.size()),
                           static_cast<Eigen::Index>(basis.number_of_eigenpairs(0)));
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      for (Eigen::Index k = 0; k < result.cols(); ++k)
        result(i, k) = basis.eigenfunction(static_cast<std::size_t>(k) + 1,
                                           vertices[static_cast<std::size_t>(i)]);
    return result;
  }

  double commute_time_distance(const std::size_t i, const std::size_t j) const
  {
    return basis.commute_time_distance(vertices[i], vertices[j]);
  }
  double diffusion_distance(const std::size_t i, const std::size_t j, const double t) const
  {
    return basis.diffusion_distance(vertices[i], vertices[j], t);
  }

  std::vector<vertex_descriptor> vertices;
  Mesh mesh;
  Basis basis;

private:
  static Mesh with_vertices(const Index_mesh& input, std::vector<vertex_descriptor>& vertices)
  {
    Mesh mesh;
    make_mesh(input, mesh, vertices);
    return mesh;
  }
};
using Shape = Shape_with_solver<SMRG::Block_Lanczos_eigensolver<>>;

// -------------------------------------------------------------------------------------------------
// Shapes

template <class Function>
Index_mesh transformed(Index_mesh mesh, const Function& function)
{
  for (auto& p : mesh.points)
    p = function(p);
  return mesh;
}

Index_mesh scaled(const Index_mesh& mesh, const double factor)
{
  return transformed(mesh, [factor](const std::array<double, 3>& p) {
    return std::array<double, 3>{factor * p[0], factor * p[1], factor * p[2]};
  });
}

Index_mesh moved(const Index_mesh& mesh, const double shift)
{
  return transformed(mesh, [shift](const std::array<double, 3>& p) {
    return std::array<double, 3>{p[0] + shift, p[1], p[2]};
  });
}

// A rotation about a generic axis and a translation.
Index_mesh rigidly_moved(const Index_mesh& mesh)
{
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -3).normalized()).toRotationMatrix();
  return transformed(mesh, [&](const std::array<double, 3>& p) {
    const Eigen::Vector3d q =
        rotation * Eigen::Vector3d(p[0], p[1], p[2]) + Eigen::Vector3d(1, -2, 0.5);
    return std::array<double, 3>{q[0], q[1], q[2]};
  });
}

// Vertex v gets the number `number[v]`.
Index_mesh renumbered(const Index_mesh& mesh, const std::vector<std::size_t>& number)
{
  Index_mesh result = mesh;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.points[number[v]] = mesh.points[v];
  for (auto& t : result.triangles)
    t = {number[t[0]], number[t[1]], number[t[2]]};
  return result;
}

// A sphere pushed out of shape: no symmetry, hence simple eigenvalues, and well-shaped triangles.
Index_mesh potato(const std::size_t subdivisions)
{
  return transformed(sphere(subdivisions), [](const std::array<double, 3>& p) {
    const double r =
        1 + 0.15 * std::sin(2 * p[0] + 0.4) + 0.1 * std::cos(3 * p[1] - p[2]) + 0.12 * p[0] * p[2];
    return std::array<double, 3>{1.5 * r * p[0], 1.1 * r * p[1], 0.9 * r * p[2]};
  });
}

// The surface of a cube, 3 x 3 x 3 vertices without the middle one; every face has the diagonals
// that meet in its middle, so that the triangulation has all symmetries of the cube.
Index_mesh symmetric_cube()
{
  Index_mesh mesh;
  std::map<std::array<int, 3>, std::size_t> numbers;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto inserted = numbers.emplace(p, mesh.points.size());
    if (inserted.second)
      mesh.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return inserted.first->second;
  };
  constexpr std::array<std::array<int, 2>, 8> around = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto at = [&](const std::array<int, 2>& uv) {
        std::array<int, 3> p;
        p[axis] = side;
        p[(axis + 1) % 3] = uv[0];
        p[(axis + 2) % 3] = uv[1];
        return number(p);
      };
      for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t a = at(around[i]), b = at(around[(i + 1) % 8]);
        mesh.triangles.push_back({at({0, 0}), side > 0 ? a : b, side > 0 ? b : a});
      }
    }
  }
  return mesh;
}

// A regular tetrahedron.
Index_mesh tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// -------------------------------------------------------------------------------------------------
// The operator, from coordinates

Eigen::Vector3d point(const Index_mesh& mesh, const std::size_t v)
{
  return Eigen::Vector3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
}

// Of the angle at p.
double cotangent(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  return (q - p).dot(r - p) / (q - p).cross(r - p).norm();
}

double triangle_area(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  return (q - p).cross(r - p).norm() / 2;
}

double surface_area(const Index_mesh& mesh)
{
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += triangle_area(point(mesh, t[0]), point(mesh, t[1]), point(mesh, t[2]));
  return area;
}

Eigen::Vector3d
circumcenter(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  const Eigen::Vector3d a = q - p, b = r - p, n = a.cross(b);
  return p + (b.squaredNorm() * n.cross(a) + a.squaredNorm() * b.cross(n)) / (2 * n.squaredNorm());
}

// The area of the region of p: the points of the triangle that are nearest to p, up to the
// circumcenter, or if the triangle is obtuse up to the middle of the longest edge.
double mixed_area(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  if ((q - p).dot(r - p) < 0)
    return triangle_area(p, q, r) / 2;
  if ((p - q).dot(r - q) < 0 || (p - r).dot(q - r) < 0)
    return triangle_area(p, q, r) / 4;
  const Eigen::Vector3d center = circumcenter(p, q, r);
  return triangle_area(p, (p + q) / 2, center) + triangle_area(p, center, (p + r) / 2);
}

struct Reference_operator
{
  explicit Reference_operator(const Index_mesh& mesh)
    : mass(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size())))
    , stiffness(mass.size(), mass.size())
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for (const auto& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t u = t[i], v = t[(i + 1) % 3], w = t[(i + 2) % 3];
        mass[static_cast<Eigen::Index>(u)] +=
            mixed_area(point(mesh, u), point(mesh, v), point(mesh, w));
        const double weight = cotangent(point(mesh, u), point(mesh, v), point(mesh, w)) / 2;
        const int j = static_cast<int>(v), k = static_cast<int>(w);
        triplets.emplace_back(j, k, -weight);
        triplets.emplace_back(k, j, -weight);
        triplets.emplace_back(j, j, weight);
        triplets.emplace_back(k, k, weight);
      }
    }
    stiffness.setFromTriplets(triplets.begin(), triplets.end());
  }

  // All generalized eigenvalues, increasing; the first one is zero.
  Eigen::VectorXd eigenvalues() const
  {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
               stiffness.toDense(), mass.asDiagonal().toDenseMatrix(), Eigen::EigenvaluesOnly)
        .eigenvalues();
  }

  Eigen::VectorXd mass;
  Eigen::SparseMatrix<double> stiffness;
};

// -------------------------------------------------------------------------------------------------
// Comparisons

// Eigenvalues are compared relatively. 1e-9 is what the residual tolerance of 1e-8 leaves far
// behind (errors of eigenvalues are of second order in it) and what no mistake in the operator can
// meet.
constexpr double eigenvalue_tolerance = 1e-9;

double largest_relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  BOOST_REQUIRE_EQUAL(a.size(), b.size());
  return a.size() == 0 ? 0 : ((a - b).array().abs() / b.array().abs()).maxCoeff();
}

// Stands for the commute-time distance among the times of diffusion distances.
constexpr double commute_time = -1;

// The largest difference of distances between corresponding vertices of two shapes, relative to the
// largest distance: the distance of near vertices is a difference of nearly equal eigenfunctions.
// `at[i]` is the vertex of `b` that corresponds to vertex i of `a`.
template <class A, class B>
double difference_of_distances(const A& a,
                               const B& b,
                               const std::vector<std::size_t>& at,
                               const std::vector<double>& times = {commute_time, 0, 0.2, 1.5})
{
  const std::size_t step = (std::max)(std::size_t(1), at.size() / 60);
  double result = 0;
  for (const double t : times) {
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < at.size(); i += step) {
      for (std::size_t j = 0; j < i; j += step) {
        const bool is_commute_time = t == commute_time;
        const double in_a =
            is_commute_time ? a.commute_time_distance(i, j) : a.diffusion_distance(i, j, t);
        const double in_b = is_commute_time ? b.commute_time_distance(at[i], at[j])
                                            : b.diffusion_distance(at[i], at[j], t);
        largest = (std::max)(largest, in_a);
        if (!(std::abs(in_a - in_b) <= difference)) // NaN counts
          difference = std::abs(in_a - in_b);
      }
    }
    BOOST_REQUIRE(largest > 0);
    if (!(difference / largest <= result))
      result = difference / largest;
  }
  return result;
}

std::vector<std::size_t> identity(const std::size_t n)
{
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

// Distances of the same shape, computed twice with different rounding.
constexpr double distance_tolerance = 1e-9;

// No NaN, no negative or infinite number among eigenvalues, eigenfunctions and distances within a
// component, and residuals within the tolerance.
template <class Shape_type>
bool is_sound(const Shape_type& shape)
{
  bool result = shape.basis.residual() <= 1e-8;
  for (std::size_t c = 0; c < shape.basis.number_of_components(); ++c) {
    const auto& vertices = shape.basis.component_vertices(c);
    const double area = shape.basis.area(c);
    result = result && std::isfinite(area) && area >= 0;
    for (std::size_t k = 1; k <= shape.basis.number_of_eigenpairs(c); ++k) {
      const double lambda = shape.basis.eigenvalue(c, k);
      result = result && std::isfinite(lambda) && lambda > 0;
      for (const vertex_descriptor v : vertices)
        result = result && std::isfinite(shape.basis.eigenfunction(k, v));
    }
    for (const vertex_descriptor v : vertices) {
      result = result && std::isfinite(shape.basis.vertex_area(v));
      for (const double d : {shape.basis.commute_time_distance(vertices.front(), v),
                             shape.basis.diffusion_distance(vertices.front(), v, 0),
                             shape.basis.diffusion_distance(vertices.front(), v, 1.5),
                             shape.basis.diffusion_distance(vertices.front(), v, 1e3)})
        result = result && std::isfinite(d) && d >= 0;
    }
  }
  return result;
}

// The message of the error that constructing a basis of the mesh gives, empty if there is none.
template <class Shape_type = Shape, class... Parameters>
std::string error_of(const Index_mesh& mesh, const Parameters&... parameters)
{
  try {
    const Shape_type shape(mesh, parameters...);
  } catch (const SMRG::Error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

// -------------------------------------------------------------------------------------------------

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
    BOOST_CHECK_THROW(SMRG::eigenfunction(shape.basis, k, values), SMRG::Error);
    BOOST_TEST(std::all_of(values.begin(), values.end(), [](double x) { return x == -1; }));
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

// What is as thin as the lengths are mollified is at the limits of double precision: a sound basis
// or an error that says what could not be computed.
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
      BOOST_TEST(is_sound(Shape(mesh)));
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
    BOOST_TEST(contains(error_of(potato(1), number), "number of eigenpairs"));
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
                      SMRG::Error);
    BOOST_CHECK_THROW(SMRG::feature_points(shape.basis,
                                           std::back_inserter(points),
                                           SMRG::parameters::large_time(bad)),
                      SMRG::Error);
    BOOST_TEST(points.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(solvers)

using Eigen_matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
using Cholesky_traits = CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Eigen_matrix>>;
using Lu_traits =
    CGAL::Eigen_solver_traits<Eigen::SparseLU<Eigen_matrix, Eigen::COLAMDOrdering<int>>>;

// A minimal model of `SparseLinearAlgebraWithFactorTraits_d`, with one right-hand side at a time;
// it fails on demand.
template <bool FACTORS = true, bool SOLVES = true>
class Minimal_traits
{
public:
  using NT = double;
  using Matrix = Cholesky_traits::Matrix;
  using Vector = Cholesky_traits::Vector;

  bool factor(const Matrix& matrix, NT& determinant)
  {
    return m_traits.factor(matrix, determinant) && FACTORS;
  }
  bool linear_solver(const Vector& right_hand_side, Vector& solution)
  {
    return m_traits.linear_solver(right_hand_side, solution) && SOLVES;
  }

private:
  Cholesky_traits m_traits;
};

// A solver with Eigen's interface that solves in place, too, and fails on demand.
template <bool IN_PLACE, bool SOLVES>
class Block_solver : public Eigen::SimplicialLLT<Eigen_matrix>
{
  using Base = Eigen::SimplicialLLT<Eigen_matrix>;

public:
  template <class Matrix, bool ENABLED = IN_PLACE, class = std::enable_if_t<ENABLED>>
  void solve_in_place(Matrix& x)
  {
    static_assert(Matrix::IsRowMajor && Matrix::ColsAtCompileTime == 8);
    x = Base::solve(Eigen::MatrixXd(x)).eval();
    ++number_of_solves();
  }
  Eigen::ComputationInfo info() const
  {
    return m_is_factored && !SOLVES ? Eigen::NumericalIssue : Base::info();
  }
  template <class Matrix>
  Block_solver& compute(const Matrix& matrix)
  {
    Base::compute(matrix);
    return *this;
  }
  template <class Right_hand_side>
  auto solve(const Right_hand_side& b)
  {
    m_is_factored = true;
    return Base::solve(b);
  }

  static int& number_of_solves()
  {
    static int number = 0;
    return number;
  }

private:
  bool m_is_factored = false;
};

template <class Eigensolver>
void check_same_basis(const Index_mesh& mesh)
{
  const Shape expected(mesh);
  const Shape_with_solver<Eigensolver> shape(mesh);
  BOOST_TEST(largest_relative_difference(shape.eigenvalues(), expected.eigenvalues()) <=
             eigenvalue_tolerance);
  BOOST_TEST(difference_of_distances(expected, shape, identity(mesh.points.size())) <=
             distance_tolerance);
  BOOST_TEST(shape.basis.residual() <= 1e-8);
}

BOOST_AUTO_TEST_CASE(direct_solvers_give_the_same_basis)
{
  using In_place = Block_solver<true, true>;
  for (const Index_mesh& mesh : {potato(3), sphere(2), grid(12, 9), tetrahedron()}) {
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Cholesky_traits>>(mesh);
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Lu_traits>>(mesh);
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Minimal_traits<>>>(mesh);
    In_place::number_of_solves() = 0;
    check_same_basis<SMRG::Block_Lanczos_eigensolver<CGAL::Eigen_solver_traits<In_place>>>(mesh);
    BOOST_TEST(In_place::number_of_solves() > 0);
    check_same_basis<SMRG::Spectra_eigensolver<>>(mesh);
    check_same_basis<SMRG::Spectra_eigensolver<Minimal_traits<>>>(mesh);
  }
}

template <template <class> class Eigensolver>
void check_failures()
{
  // Lanczos and dense path
  for (const Index_mesh& mesh : {potato(2), tetrahedron()}) {
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Minimal_traits<false, true>>>>(mesh),
                        "factorization"));
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Minimal_traits<true, false>>>>(mesh),
                        "solution of a linear system failed"));
    using Failing = CGAL::Eigen_solver_traits<Block_solver<false, false>>;
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Failing>>>(mesh),
                        "solution of a linear system failed"));
    BOOST_TEST(error_of<Shape_with_solver<Eigensolver<Minimal_traits<>>>>(mesh) == "");
  }
}

BOOST_AUTO_TEST_CASE(solver_that_fails_is_an_error)
{
  check_failures<SMRG::Block_Lanczos_eigensolver>();
  check_failures<SMRG::Spectra_eigensolver>();
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(eigensolvers)

// Stiffness and mass matrix without a mesh.
struct Pencil
{
  // Of the eigenvalues up to the last one given: all there are, with multiplicity.
  Eigen::VectorXd smallest_eigenvalues(const Eigen::Index number) const
  {
    // Vertices without mass are eliminated: the Schur complement.
    std::vector<Eigen::Index> heavy, light;
    for (Eigen::Index i = 0; i < mass.size(); ++i)
      (mass[i] > 0 ? heavy : light).push_back(i);
    const Eigen::MatrixXd l = stiffness.toDense();
    Eigen::MatrixXd schur = l(heavy, heavy);
    if (!light.empty())
      schur -= l(heavy, light) * l(light, light).llt().solve(l(light, heavy).eval());
    const Eigen::VectorXd scale = mass(heavy).cwiseSqrt().cwiseInverse();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
               scale.asDiagonal() * schur * scale.asDiagonal(), Eigen::EigenvaluesOnly)
        .eigenvalues()
        .head(number);
  }

  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd mass;
  double shift;
};

Pencil pencil_of(const Index_mesh& mesh)
{
  const Reference_operator reference(mesh);
  return {reference.stiffness, reference.mass, 2 * pi / reference.mass.sum()};
}

// The graph Laplacian of the hypercube: the eigenvalue 2 k has multiplicity "dimension over k".
Pencil hypercube(const int dimension)
{
  const int n = 1 << dimension;
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) {
    triplets.emplace_back(i, i, dimension);
    for (int k = 0; k < dimension; ++k)
      triplets.emplace_back(i, i ^ (1 << k), -1);
  }
  Pencil result{{n, n}, Eigen::VectorXd::Ones(n), 1};
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

Pencil copies(const Pencil& pencil, const int number)
{
  const Eigen::Index n = pencil.mass.size();
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < number; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(pencil.stiffness, j); it; ++it)
        triplets.emplace_back(i * n + it.row(), i * n + it.col(), it.value());
  Pencil result{{number * n, number * n}, pencil.mass.replicate(number, 1), pencil.shift};
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

void check_pairs(const Pencil& pencil,
                 const SMRG::Eigenpairs& pairs,
                 const Eigen::VectorXd& expected)
{
  BOOST_TEST(pairs.have_converged);
  BOOST_REQUIRE_EQUAL(pairs.values.size(), expected.size());
  BOOST_REQUIRE_EQUAL(pairs.vectors.cols(), expected.size());
  BOOST_TEST(
      ((pairs.values - expected).array().abs() / (pencil.shift + expected.array())).maxCoeff() <=
      eigenvalue_tolerance);
  const Eigen::MatrixXd m_psi = pencil.mass.asDiagonal() * pairs.vectors;
  BOOST_TEST((pairs.vectors.transpose() * m_psi -
              Eigen::MatrixXd::Identity(expected.size(), expected.size()))
                 .cwiseAbs()
                 .maxCoeff() <= 1e-10);
  const Eigen::MatrixXd residual =
      pencil.stiffness * pairs.vectors - m_psi * pairs.values.asDiagonal();
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    BOOST_TEST(residual.col(i).norm() <=
               1e-10 * (pencil.shift + expected[i]) * m_psi.col(i).norm());
}

template <class Eigensolver>
void check_eigensolver(const Pencil& pencil,
                       const std::vector<Eigen::Index>& numbers,
                       const Eigen::VectorXd& expected,
                       const SMRG::Eigensolver_options& options = SMRG::Eigensolver_options())
{
  for (const Eigen::Index number : numbers) {
    BOOST_TEST_CONTEXT(number << " eigenpairs of " << pencil.mass.size())
    {
      Eigensolver solver(pencil.stiffness, pencil.mass, pencil.shift, options);
      check_pairs(pencil, solver.smallest(number), expected.head(number));
    }
  }
}

// Multiplicities far beyond the number of vectors that are iterated at a time, cut at all places.
BOOST_AUTO_TEST_CASE(multiple_eigenvalues_are_complete)
{
  for (const int dimension : {8, 10}) {
    const Pencil pencil = hypercube(dimension);
    std::vector<double> eigenvalues;
    for (Eigen::Index i = 0; i < pencil.mass.size(); ++i) {
      int bits = 0;
      for (Eigen::Index j = i; j > 0; j /= 2)
        bits += j % 2;
      eigenvalues.push_back(2 * bits);
    }
    std::sort(eigenvalues.begin(), eigenvalues.end());
    const Eigen::VectorXd expected =
        Eigen::Map<const Eigen::VectorXd>(eigenvalues.data(), pencil.mass.size());
    const std::vector<Eigen::Index> numbers = {1, 2, 8, 9, 10, 11, 12, 37, 38, 55, 56, 57, 64};
    check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, numbers, expected);
    check_eigensolver<SMRG::Spectra_eigensolver<>>(pencil, {1, 12, 38}, expected);
  }
}

BOOST_AUTO_TEST_CASE(identical_copies_have_identical_eigenvalues)
{
  // eigenvalue zero included
  for (const int number : {2, 5, 8, 9, 20}) {
    const Pencil pencil = copies(pencil_of(potato(1)), number);
    const Eigen::VectorXd expected = pencil.smallest_eigenvalues(60);
    check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
        pencil, {1, number, number + 1, 3 * number - 1, 60}, expected);
  }
}

// What is missing may lie in the vectors that are waiting when all others have converged.
BOOST_AUTO_TEST_CASE(missing_eigenvalues_are_found_with_any_seed)
{
  const Pencil pencil = copies(pencil_of(potato(1)), 20);
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(60);
  SMRG::Eigensolver_options options;
  for (options.seed = 0; options.seed < 10; ++options.seed)
    BOOST_TEST_CONTEXT("seed " << options.seed)
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
      pencil, {17, 20, 21, 26, 45}, expected, options);
}

// As many copies as there are eigenpairs, in a space that has just room for the search for missing
// ones.
BOOST_AUTO_TEST_CASE(multiplicities_may_fill_small_spaces)
{
  constexpr Eigen::Index size = 221, multiplicity = 52, number = 49;
  Pencil pencil{{size, size}, Eigen::VectorXd::Ones(size), 1};
  Eigen::VectorXd expected(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    expected[i] = i < multiplicity ? 1 : 2 + 0.01 * static_cast<double>(i);
    pencil.stiffness.insert(i, i) = expected[i];
  }
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, {number}, expected);
}

// Wherever it was stopped, the first step and the search for missing eigenvalues included.
BOOST_AUTO_TEST_CASE(interrupted_solvers_go_on)
{
  const Pencil pencil = copies(pencil_of(potato(1)), 9);
  constexpr Eigen::Index number = 26;
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(number);
  int calls = 0, last_call = 0;
  SMRG::Eigensolver_options options;
  options.callback = [&](double) { return calls++ != last_call; };
  for (bool is_interrupted = true; is_interrupted; ++last_call) {
    BOOST_TEST_CONTEXT("interrupted at call " << last_call)
    {
      calls = 0;
      is_interrupted = false;
      try {
        SMRG::Block_Lanczos_eigensolver<> solver(
            pencil.stiffness, pencil.mass, pencil.shift, options);
        try {
          solver.smallest(number);
        } catch (const SMRG::Interruption&) {
          is_interrupted = true;
          check_pairs(pencil, solver.smallest(number), expected);
        }
      } catch (const SMRG::Interruption&) {
        is_interrupted = true; // by the constructor
      }
    }
  }
  BOOST_TEST(last_call > 20);
}

BOOST_AUTO_TEST_CASE(random_weights_agree_with_dense_matrices)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Pencil pencil = pencil_of(transformed(potato(2), [&rng](const std::array<double, 3>& p) {
        return std::array<double, 3>{p[0] + 0.05 * random_unit(rng),
                                     p[1] + 0.05 * random_unit(rng),
                                     p[2] + 0.05 * random_unit(rng)};
      }));
      // masses that differ by ten thousand, and none at some vertices
      for (Eigen::Index i = 0; i < pencil.mass.size(); ++i)
        pencil.mass[i] *= random_index(8, rng) == 0 ? 0 : std::pow(10., -4 * random_unit(rng));
      pencil.shift = 2 * pi / pencil.mass.sum();
      const std::vector<Eigen::Index> numbers = {
          static_cast<Eigen::Index>(1 + random_index(20, rng)), 22};
      const Eigen::VectorXd expected = pencil.smallest_eigenvalues(22);
      check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, numbers, expected);
      check_eigensolver<SMRG::Spectra_eigensolver<>>(pencil, numbers, expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(numbers_may_change_from_call_to_call)
{
  const Pencil pencil = pencil_of(sphere(3));
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(300);
  SMRG::Block_Lanczos_eigensolver<> solver(pencil.stiffness, pencil.mass, pencil.shift);
  for (const Eigen::Index number : {1, 9, 30, 5, 31, 80, 300, 40})
    check_pairs(pencil, solver.smallest(number), expected.head(number));
}

// Spherical harmonics of degrees 1 to 7: clusters of 3 to 15 eigenvalues that split into the
// smaller multiplicities of the icosahedron.
BOOST_AUTO_TEST_CASE(clusters_of_spheres_are_those_of_dense_matrices)
{
  const Pencil pencil = pencil_of(sphere(3));
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(64);
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
      pencil, {4, 7, 16, 23, 25, 36, 40, 49, 64}, expected);
}

BOOST_AUTO_TEST_CASE(seeds_decide_about_rounding_only)
{
  const Index_mesh mesh = potato(3);
  const Shape shape(mesh, 20);
  const Shape same(mesh, SMRG::parameters::number_of_eigenpairs(20).random_seed(0));
  const Shape other(mesh, SMRG::parameters::number_of_eigenpairs(20).random_seed(1));
  BOOST_TEST((shape.eigenvalues() == same.eigenvalues()));
  BOOST_TEST((shape.eigenfunctions() == same.eigenfunctions()));
  BOOST_TEST((shape.eigenfunctions() != other.eigenfunctions()));
  BOOST_TEST(largest_relative_difference(shape.eigenvalues(), other.eigenvalues()) <=
             eigenvalue_tolerance);
  BOOST_TEST(difference_of_distances(shape, other, identity(mesh.points.size())) <=
             distance_tolerance);
}

BOOST_AUTO_TEST_CASE(certificates_are_what_the_test_computes)
{
  for (const Index_mesh& mesh : {potato(3), sphere(3), grid(20, 15), tetrahedron()}) {
    const Shape shape(mesh, 20);
    const Eigen::VectorXd mass = Reference_operator(mesh).mass;
    const Eigen::MatrixXd psi = shape.eigenfunctions();
    const Eigen::MatrixXd gram = psi.transpose() * mass.asDiagonal() * psi;
    const double error =
        (gram - Eigen::MatrixXd::Identity(psi.cols(), psi.cols())).cwiseAbs().maxCoeff();
    BOOST_TEST(shape.basis.orthonormality_error() <= 1e-10);
    // it has the constant function in addition; the rest is rounding
    BOOST_TEST(error <= shape.basis.orthonormality_error() + 1e-13);
    BOOST_TEST(shape.basis.null_space_residual() <= 4 * epsilon);
  }
}

BOOST_AUTO_TEST_CASE(extension_to_the_gap_can_be_turned_off)
{
  for (const Index_mesh& mesh : {sphere(2), symmetric_cube(), grid(9, 9), potato(2)}) {
    const Eigen::VectorXd all = Reference_operator(mesh).eigenvalues();
    for (const int number : {1, 2, 5, 10, 24}) {
      const Shape shape(mesh, SMRG::parameters::number_of_eigenpairs(number).extend_to_gap(false));
      BOOST_TEST(shape.basis.number_of_eigenpairs(0) == static_cast<std::size_t>(number));
      BOOST_TEST(largest_relative_difference(shape.eigenvalues(), all.segment(1, number)) <=
                 eigenvalue_tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(callback_is_told_the_progress)
{
  Index_mesh mesh = potato(3);
  append(mesh, tetrahedron(), 9);
  append(mesh, sphere(2), 20);
  std::vector<double> progress;
  const auto callback = [&progress](const double part) {
    progress.push_back(part);
    return true;
  };
  const Shape shape(mesh, SMRG::parameters::number_of_eigenpairs(12).callback(callback));
  BOOST_REQUIRE(progress.size() > 10);
  BOOST_TEST(progress.front() == 0);
  BOOST_TEST(progress.back() == 1);
  BOOST_TEST(std::is_sorted(progress.begin(), progress.end()));
}

template <class Eigensolver>
void check_interruption(const int number_of_calls)
{
  for (int last = 0; last < number_of_calls; ++last) {
    int calls = 0;
    const auto callback = [&calls, last](double) { return calls++ < last; };
    BOOST_CHECK_THROW(
        (Shape_with_solver<Eigensolver>(
            potato(3), SMRG::parameters::number_of_eigenpairs(12).callback(callback))),
        SMRG::Interruption);
    BOOST_TEST(calls == last + 1); // not called again
  }
}

BOOST_AUTO_TEST_CASE(callback_interrupts)
{
  check_interruption<SMRG::Block_Lanczos_eigensolver<>>(8);
  check_interruption<SMRG::Spectra_eigensolver<>>(8);
}

// A minimal model of `LaplaceBeltramiEigensolver`. It is told by the first pair that it spoils, and
// by the number of pairs that it finds at most, how to fail.
struct Dense_eigensolver
{
  Dense_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                    const Eigen::VectorXd& mass,
                    double,
                    const SMRG::Eigensolver_options&)
    : solver(stiffness.toDense(), mass.asDiagonal().toDenseMatrix())
  {}

  SMRG::Eigenpairs smallest(Eigen::Index number)
  {
    number = (std::min)(number, solver.eigenvalues().size());
    SMRG::Eigenpairs pairs;
    pairs.have_converged = number <= found;
    number = (std::min)(number, found);
    pairs.values = solver.eigenvalues().head(number);
    pairs.vectors = solver.eigenvectors().leftCols(number);
    if (spoiled < number)
      pairs.vectors(0, spoiled) += 1e-3;
    return pairs;
  }

  Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  static Eigen::Index found, spoiled;
};

Eigen::Index Dense_eigensolver::found = std::numeric_limits<Eigen::Index>::max();
Eigen::Index Dense_eigensolver::spoiled = std::numeric_limits<Eigen::Index>::max();

BOOST_AUTO_TEST_CASE(eigensolver_of_the_user_gives_the_same_basis)
{
  for (const Index_mesh& mesh : {potato(2), sphere(2), grid(12, 9), tetrahedron()})
    solvers::check_same_basis<Dense_eigensolver>(mesh);
}

BOOST_AUTO_TEST_CASE(converged_part_is_accepted_on_request)
{
  using Dense_shape = Shape_with_solver<Dense_eigensolver>;
  const Index_mesh mesh = potato(2);
  const Shape expected(mesh, 20);
  const auto strict = SMRG::parameters::number_of_eigenpairs(20);
  const auto lenient = strict.accept_converged_part(true);
  const Eigen::Index all = std::numeric_limits<Eigen::Index>::max();
  for (const auto& [found, spoiled, number] : {std::array<Eigen::Index, 3>{12, all, 11},
                                               std::array<Eigen::Index, 3>{all, 5, 4},
                                               std::array<Eigen::Index, 3>{12, 5, 4},
                                               std::array<Eigen::Index, 3>{all, 1, 0},
                                               std::array<Eigen::Index, 3>{1, all, 0},
                                               std::array<Eigen::Index, 3>{0, all, 0}})
  {
    Dense_eigensolver::found = found;
    Dense_eigensolver::spoiled = spoiled;
    const std::string message = error_of<Dense_shape>(mesh, strict);
    if (found < all)
      BOOST_TEST(contains(message,
                          "found " + std::to_string((std::max)(found - 1, Eigen::Index(0))) +
                              " of 20 eigenpairs"));
    else
      BOOST_TEST(contains(message, "eigenpair " + std::to_string(spoiled) + " has"));
    const Dense_shape shape(mesh, lenient);
    BOOST_TEST(is_sound(shape));
    BOOST_TEST(
        largest_relative_difference(shape.eigenvalues(), expected.eigenvalues().head(number)) <=
        eigenvalue_tolerance);
  }
  Dense_eigensolver::found = Dense_eigensolver::spoiled = all;
}

#ifdef REEB_GRAPH_TEST_COUNTS_MEMORY
// Counted whenever the solver reports its progress. Where malloc() is not that of glibc, as with a
// sanitizer, the count is zero.
BOOST_AUTO_TEST_CASE(memory_is_bounded)
{
  const Pencil pencil = pencil_of(potato(5));
  const auto allocated = [] {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  const double before = allocated();
  double most = 0;
  SMRG::Eigensolver_options options;
  options.callback = [&](double) {
    most = (std::max)(most, allocated() - before);
    return true;
  };
  SMRG::Block_Lanczos_eigensolver<> solver(pencil.stiffness, pencil.mass, pencil.shift, options);
  const SMRG::Eigenpairs pairs = solver.smallest(52);
  BOOST_TEST(pairs.have_converged);
  // of what a component has in all, 2500 bytes for every vertex, the mesh and its matrices need 200
  BOOST_TEST(most <= 2300. * static_cast<double>(pencil.mass.size()));
}
#endif

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(blocks_of_rows)

BOOST_AUTO_TEST_CASE(products_are_those_of_dense_matrices)
{
  std::mt19937 rng(23);
  const auto random_matrix = [&rng](const Eigen::Index rows, const Eigen::Index columns) {
    return Eigen::MatrixXd(
        Eigen::MatrixXd::NullaryExpr(rows, columns, [&rng]() { return random_unit(rng) - 0.5; }));
  };
  // shorter and longer than what stays in the cache, odd and even
  for (const Eigen::Index n : {1, 2, 7, 8, 511, 512, 513, 1025, 3000}) {
    const Eigen::Index number = 1 + static_cast<Eigen::Index>(random_index(5, rng));
    const Eigen::MatrixXd v = random_matrix(n, 8 * number), w = random_matrix(n, 8);
    SMRG::internal::Block_basis basis;
    for (Eigen::Index i = 0; i < number; ++i)
      basis.insert(i, SMRG::internal::Row_block(v.middleCols(8 * i, 8)));
    const double rounding = 8 * epsilon * static_cast<double>(n + 8 * number);

    // the first block with given coefficients, those from `begin` on with the products
    SMRG::internal::Row_block rest = w;
    const SMRG::internal::Block_coefficients known = random_matrix(8, 8);
    const Eigen::Index begin = number / 2;
    const auto later = v.rightCols(8 * (number - begin));
    const Eigen::MatrixXd difference = w - v.leftCols(8) * known;
    const Eigen::MatrixXd products = later.transpose() * difference;
    const auto found = basis.subtract_and_project({{0, known}}, begin, rest);
    for (Eigen::Index i = begin; i < number; ++i)
      BOOST_TEST((found[static_cast<std::size_t>(i)] - products.middleRows(8 * (i - begin), 8))
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
      const Eigen::MatrixXd square = basis.project_out_of(rest, is_loose ? number - 1 : -1);
      const double bound = rounding * (1 + c.norm()) * (1 + expected_error);
      BOOST_TEST((rest - expected).cwiseAbs().maxCoeff() <= bound);
      BOOST_TEST((square - rest.transpose() * rest).cwiseAbs().maxCoeff() <=
                 rounding * (1 + rest.squaredNorm()));
      BOOST_TEST((basis[number - 1] - tight.rightCols(8)).cwiseAbs().maxCoeff() <=
                 rounding * (1 + expected_error));
      basis.erase(number - 1, number);
      basis.insert(number - 1, SMRG::internal::Row_block(v.rightCols(8)));
    }

    const Eigen::MatrixXd q = random_matrix(8 * number, 8 * (1 + number / 2));
    basis.multiply_from_right(q);
    BOOST_REQUIRE_EQUAL(basis.size(), 1 + number / 2);
    for (Eigen::Index i = 0; i < basis.size(); ++i)
      BOOST_TEST((basis[i] - (v * q).middleCols(8 * i, 8)).cwiseAbs().maxCoeff() <= rounding);
  }
}

#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
// Those for other instructions than the best that this processor has are used by nothing else here.
BOOST_AUTO_TEST_CASE(kernels_of_all_instruction_sets_agree)
{
  namespace internal = SMRG::internal;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::mt19937 rng(29);
  const auto random_matrix = [&rng](const Eigen::Index rows, const Eigen::Index columns) {
    return Matrix(Matrix::NullaryExpr(rows, columns, [&rng]() { return random_unit(rng) - 0.5; }));
  };
  const auto check = [&](const auto& add_transposed_product,
                         const auto& add_transposed_products,
                         const auto& subtract_product,
                         const auto& subtract_products,
                         const auto& forward,
                         const auto& backward,
                         const auto& subtract_tile) {
    for (const Eigen::Index n : {1, 3, 4, 7, 8, 9, 31, 64, 100}) {
      const double rounding = 8 * epsilon * static_cast<double>(n + 8);
      const Matrix v = random_matrix(n, 8), w = random_matrix(n, 8), c = random_matrix(8, 8);
      Matrix product = c;
      add_transposed_product(v.data(), w.data(), n, product.data());
      BOOST_TEST((product - (c + v.transpose() * w)).cwiseAbs().maxCoeff() <= rounding);

      Matrix y = w;
      const Eigen::Index done = subtract_product(y.data(), v.data(), n, c.data());
      BOOST_TEST(n - done < 8);
      if (done > 0)
        BOOST_TEST((y - (w - v * c)).topRows(done).cwiseAbs().maxCoeff() <= rounding);
      BOOST_TEST((y.bottomRows(n - done).array() == w.bottomRows(n - done).array()).all());

      const Matrix u = random_matrix(n, 8), d = random_matrix(8, 8);
      product = c;
      Matrix other_product = d;
      add_transposed_products(
          v.data(), w.data(), u.data(), n, product.data(), other_product.data());
      BOOST_TEST((product - (c + v.transpose() * w)).cwiseAbs().maxCoeff() <= rounding);
      BOOST_TEST((other_product - (d + v.transpose() * u)).cwiseAbs().maxCoeff() <= rounding);

      y = w;
      Matrix other_y = u;
      const Eigen::Index both_done =
          subtract_products(y.data(), other_y.data(), v.data(), n, c.data(), d.data());
      BOOST_TEST(n - both_done < 8);
      Matrix expected = w, other_expected = u;
      expected.topRows(both_done) -= v.topRows(both_done) * c;
      other_expected.topRows(both_done) -= v.topRows(both_done) * d;
      BOOST_TEST((y - expected).cwiseAbs().maxCoeff() <= rounding);
      BOOST_TEST((other_y - other_expected).cwiseAbs().maxCoeff() <= rounding);

      // a tile inside a larger matrix
      const Matrix a = random_matrix(n, 16);
      const Eigen::MatrixXd large = random_matrix(19, 8);
      Eigen::MatrixXd tile = large;
      subtract_tile(a.data(), v.data(), n, tile.data() + 1, 19);
      Eigen::MatrixXd expected_tile = large;
      expected_tile.middleRows(1, 16) -= a.transpose() * v;
      BOOST_TEST((tile - expected_tile).cwiseAbs().maxCoeff() <= rounding);

      // two of the rows in the triangle, the others below
      const auto check_columns = [&](const auto columns) {
        constexpr Eigen::Index k = decltype(columns)::value;
        Eigen::MatrixXd l = random_matrix(k + 2 + n, k);
        l.diagonal().array() += 2;
        const Matrix x = random_matrix(k + 2, 8);
        const auto triangle = l.topRows(k).template triangularView<Eigen::Lower>();
        Matrix expected_x = x;
        expected_x.topRows(k) = triangle.solve(Matrix(x.topRows(k)));
        expected_x.bottomRows(2) -= l.middleRows(k, 2) * expected_x.topRows(k);
        const Matrix expected_y = w - l.bottomRows(n) * expected_x.topRows(k);
        Matrix found_x = x, found_y = w;
        forward(columns, l.data(), l.rows(), 2, n, found_x.data(), found_y.data());
        BOOST_TEST((found_x - expected_x).cwiseAbs().maxCoeff() <= rounding);
        BOOST_TEST((found_y - expected_y).cwiseAbs().maxCoeff() <= rounding);

        expected_x = x;
        expected_x.topRows(k) -= l.bottomRows(n).transpose() * w;
        expected_x.topRows(k) -= l.middleRows(k, 2).transpose() * x.bottomRows(2);
        expected_x.topRows(k) = triangle.transpose().solve(Matrix(expected_x.topRows(k)));
        found_x = x;
        backward(columns, l.data(), l.rows(), 2, n, found_x.data(), w.data());
        BOOST_TEST((found_x - expected_x).cwiseAbs().maxCoeff() <= rounding);
      };
      check_columns(std::integral_constant<int, 1>());
      check_columns(std::integral_constant<int, 2>());
      check_columns(std::integral_constant<int, 3>());
      check_columns(std::integral_constant<int, 4>());
    }
  };
  int number = 0;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    check(
        internal::avx2::add_transposed_product,
        internal::avx2::add_transposed_products,
        internal::avx2::subtract_product,
        internal::avx2::subtract_products,
        [](const auto columns, const auto... arguments) {
          internal::avx2::substitute_forward<decltype(columns)::value>(arguments...);
        },
        [](const auto columns, const auto... arguments) {
          internal::avx2::substitute_backward<decltype(columns)::value>(arguments...);
        },
        internal::avx2::subtract_tile);
    ++number;
  }
  if (internal::x86::has_avx512()) {
    check(
        internal::avx512::add_transposed_product,
        internal::avx512::add_transposed_products,
        internal::avx512::subtract_product,
        internal::avx512::subtract_products,
        [](const auto columns, const auto... arguments) {
          internal::avx512::substitute_forward<decltype(columns)::value>(arguments...);
        },
        [](const auto columns, const auto... arguments) {
          internal::avx512::substitute_backward<decltype(columns)::value>(arguments...);
        },
        internal::avx512::subtract_tile);
    ++number;
  }
  BOOST_TEST_MESSAGE(number << " instruction sets");
  BOOST_TEST(internal::x86::has_kernels() == (number > 0));
}
#endif

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

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
