// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_ENERGY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_ENERGY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A sum of squares in the coordinates of points, some of which are fixed, and its minimum.
class Curve_energy
{
public:
  Curve_energy(std::vector<Coordinates> points, std::vector<bool> is_fixed)
    : m_points(std::move(points)), m_is_fixed(std::move(is_fixed)), m_pulls(m_points.size())
  {}

  const Coordinates& point(std::size_t i) const { return m_points[i]; }

  // Adds weight * (v . (x - p) - offset)^2 for point `i`, which is at p now.
  void add_offset(std::size_t i, const Coordinates& v, double offset, double weight)
  {
    Pull& pull = m_pulls[i];
    for (int r = 0; r < 3; ++r) {
      pull.force[r] += weight * offset * v[r];
      for (int c = 0; c < 3; ++c)
        pull.matrix[r][c] += weight * v[r] * v[c];
    }
  }

  // Adds weight * |x - target|^2 for point `i`.
  void add_target(std::size_t i, const Coordinates& target, double weight)
  {
    for (int r = 0; r < 3; ++r) {
      m_pulls[i].force[r] += weight * (target[r] - m_points[i][r]);
      m_pulls[i].matrix[r][r] += weight;
    }
  }

  // Adds weight * |curvature|^2 at the middle one of three consecutive points of a curve.
  void add_bending(std::size_t i, std::size_t j, std::size_t k, double weight)
  {
    const double a = distance_between(m_points[i], m_points[j]);
    const double b = distance_between(m_points[j], m_points[k]);
    // points that coincide have no direction to turn from
    const double least = 0.05 * (a + b);
    if (!(least > 0))
      return;
    const double lower = (std::max)(a, least), upper = (std::max)(b, least);
    const double alpha = 2 / (lower * (lower + upper)), gamma = 2 / (upper * (lower + upper));
    m_bends.push_back({{i, j, k}, {alpha, -alpha - gamma, gamma}, weight});
  }

  // The points at the minimum, by conjugate gradients with the diagonal as preconditioner. What is
  // far from it after the steps allowed is closer than before all the same.
  std::vector<Coordinates> minimum() const
  {
    constexpr int most_steps = 400;
    constexpr double tolerance = 1e-8; // of the preconditioned residual
    const std::size_t n = m_points.size();
    std::vector<Coordinates> x = m_points, residual = gradient(), scaled(n), product(n);
    const std::vector<Coordinates> diagonal = diagonal_of_matrix();
    const auto precondition = [&]() {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c) {
          scaled[i][c] = diagonal[i][c] > 0 ? residual[i][c] / diagonal[i][c] : 0;
          sum += scaled[i][c] * residual[i][c];
        }
      return sum;
    };
    double rho = precondition();
    const double goal = rho * tolerance * tolerance;
    std::vector<Coordinates> direction = scaled;
    for (int step = 0; step < most_steps && rho > goal; ++step) {
      multiply(direction, product);
      double curvature = 0;
      for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c)
          curvature += direction[i][c] * product[i][c];
      if (!(curvature > 0))
        break;
      const double length = rho / curvature;
      for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c) {
          x[i][c] += length * direction[i][c];
          residual[i][c] -= length * product[i][c];
        }
      const double last_rho = rho;
      rho = precondition();
      for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c)
          direction[i][c] = scaled[i][c] + rho / last_rho * direction[i][c];
    }
    return x;
  }

private:
  // Of the terms that know one point only: half of their derivatives at the points as they are.
  struct Pull
  {
    std::array<Coordinates, 3> matrix = {};
    Coordinates force = {};
  };

  struct Bend
  {
    std::array<std::size_t, 3> points;
    std::array<double, 3> coefficients;
    double weight;
  };

  Coordinates curvature(const Bend& bend, const std::vector<Coordinates>& x) const
  {
    Coordinates result = {};
    for (int j = 0; j < 3; ++j)
      for (int c = 0; c < 3; ++c)
        result[c] += bend.coefficients[j] * x[bend.points[j]][c];
    return result;
  }

  // Half of the negative gradient at the points, 0 where they are fixed.
  std::vector<Coordinates> gradient() const
  {
    std::vector<Coordinates> result(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
      result[i] = m_pulls[i].force;
    for (const Bend& bend : m_bends) {
      const Coordinates k = curvature(bend, m_points);
      for (int j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c)
          result[bend.points[j]][c] -= bend.weight * bend.coefficients[j] * k[c];
    }
    clear_fixed(result);
    return result;
  }

  void multiply(const std::vector<Coordinates>& x, std::vector<Coordinates>& result) const
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int r = 0; r < 3; ++r)
        result[i][r] = m_pulls[i].matrix[r][0] * x[i][0] + m_pulls[i].matrix[r][1] * x[i][1] +
                       m_pulls[i].matrix[r][2] * x[i][2];
    for (const Bend& bend : m_bends) {
      const Coordinates k = curvature(bend, x);
      for (int j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c)
          result[bend.points[j]][c] += bend.weight * bend.coefficients[j] * k[c];
    }
    clear_fixed(result);
  }

  std::vector<Coordinates> diagonal_of_matrix() const
  {
    std::vector<Coordinates> result(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (int c = 0; c < 3; ++c)
        result[i][c] = m_pulls[i].matrix[c][c];
    for (const Bend& bend : m_bends)
      for (int j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c)
          result[bend.points[j]][c] += bend.weight * bend.coefficients[j] * bend.coefficients[j];
    return result;
  }

  void clear_fixed(std::vector<Coordinates>& x) const
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (m_is_fixed[i])
        x[i] = {};
  }

  std::vector<Coordinates> m_points;
  std::vector<bool> m_is_fixed;
  std::vector<Pull> m_pulls;
  std::vector<Bend> m_bends;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_ENERGY_H
