// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes with an eigenbasis, the operator as the tests compute it from coordinates, and comparisons
// of eigenvalues and distances.

#ifndef REEB_GRAPH_TEST_SPECTRAL_SHAPES_H
#define REEB_GRAPH_TEST_SPECTRAL_SHAPES_H

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline const double pi = std::acos(-1.);

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

inline Index_mesh scaled(const Index_mesh& mesh, const double factor)
{
  return transformed(mesh, [factor](const std::array<double, 3>& p) {
    return std::array<double, 3>{factor * p[0], factor * p[1], factor * p[2]};
  });
}

inline Index_mesh moved(const Index_mesh& mesh, const double shift)
{
  return transformed(mesh, [shift](const std::array<double, 3>& p) {
    return std::array<double, 3>{p[0] + shift, p[1], p[2]};
  });
}

// A rotation about a generic axis and a translation.
inline Index_mesh rigidly_moved(const Index_mesh& mesh)
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
inline Index_mesh renumbered(const Index_mesh& mesh, const std::vector<std::size_t>& number)
{
  Index_mesh result = mesh;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.points[number[v]] = mesh.points[v];
  for (auto& t : result.triangles)
    t = {number[t[0]], number[t[1]], number[t[2]]};
  return result;
}

// A sphere pushed out of shape: no symmetry, hence simple eigenvalues, and well-shaped triangles.
inline Index_mesh potato(const std::size_t subdivisions)
{
  return transformed(sphere(subdivisions), [](const std::array<double, 3>& p) {
    const double r =
        1 + 0.15 * std::sin(2 * p[0] + 0.4) + 0.1 * std::cos(3 * p[1] - p[2]) + 0.12 * p[0] * p[2];
    return std::array<double, 3>{1.5 * r * p[0], 1.1 * r * p[1], 0.9 * r * p[2]};
  });
}

// The surface of a cube, 3 x 3 x 3 vertices without the middle one; every face has the diagonals
// that meet in its middle, so that the triangulation has all symmetries of the cube.
inline Index_mesh symmetric_cube()
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
inline Index_mesh tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// -------------------------------------------------------------------------------------------------
// The operator, from coordinates

inline Eigen::Vector3d point(const Index_mesh& mesh, const std::size_t v)
{
  return Eigen::Vector3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
}

// Of the angle at p.
inline double
cotangent(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  return (q - p).dot(r - p) / (q - p).cross(r - p).norm();
}

inline double
triangle_area(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  return (q - p).cross(r - p).norm() / 2;
}

inline double surface_area(const Index_mesh& mesh)
{
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += triangle_area(point(mesh, t[0]), point(mesh, t[1]), point(mesh, t[2]));
  return area;
}

inline Eigen::Vector3d
circumcenter(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  const Eigen::Vector3d a = q - p, b = r - p, n = a.cross(b);
  return p + (b.squaredNorm() * n.cross(a) + a.squaredNorm() * b.cross(n)) / (2 * n.squaredNorm());
}

// The area of the region of p: the points of the triangle that are nearest to p, up to the
// circumcenter, or if the triangle is obtuse up to the middle of the longest edge.
inline double
mixed_area(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
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

inline double largest_relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
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

inline std::vector<std::size_t> identity(const std::size_t n)
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
bool is_sound(const Shape_type& shape, const double residual_tolerance = 1e-8)
{
  bool result = shape.basis.residual() <= residual_tolerance;
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

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace Reeb_graph_test

#endif // REEB_GRAPH_TEST_SPECTRAL_SHAPES_H
