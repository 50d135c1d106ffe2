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

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

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

  // The points at the minimum. Where the terms leave a choice, points stay.
  std::vector<Coordinates> minimum() const
  {
    const auto size = static_cast<Eigen::Index>(3 * m_points.size());
    Eigen::VectorXd force = Eigen::VectorXd::Zero(size), diagonal = force;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::size_t i, int r, std::size_t j, int c, double entry) {
      if (m_is_fixed[i] || m_is_fixed[j])
        return;
      entries.emplace_back(static_cast<int>(row(i, r)), static_cast<int>(row(j, c)), entry);
      if (i == j && r == c)
        diagonal[row(i, r)] += entry;
    };
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (int r = 0; r < 3; ++r) {
        force[row(i, r)] = m_pulls[i].force[r];
        for (int c = 0; c < 3; ++c)
          add(i, r, i, c, m_pulls[i].matrix[r][c]);
      }
    for (const Bend& bend : m_bends)
      for (int c = 0; c < 3; ++c) {
        double curvature = 0;
        for (int j = 0; j < 3; ++j)
          curvature += bend.coefficients[j] * m_points[bend.points[j]][c];
        for (int j = 0; j < 3; ++j) {
          const double weight = bend.weight * bend.coefficients[j];
          force[row(bend.points[j], c)] -= weight * curvature;
          for (int k = 0; k < 3; ++k)
            add(bend.points[j], c, bend.points[k], c, weight * bend.coefficients[k]);
        }
      }
    // what makes the choice
    constexpr double least = 1e-12;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (int r = 0; r < 3; ++r)
        add(i, r, i, r, diagonal[row(i, r)] > 0 ? least * diagonal[row(i, r)] : 1);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_is_fixed[i])
        for (int r = 0; r < 3; ++r) {
          force[row(i, r)] = 0;
          entries.emplace_back(static_cast<int>(row(i, r)), static_cast<int>(row(i, r)), 1);
        }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd step = solver.solve(force);
    std::vector<Coordinates> result = m_points;
    if (solver.info() == Eigen::Success && step.allFinite())
      for (std::size_t i = 0; i < m_points.size(); ++i)
        for (int r = 0; r < 3; ++r)
          result[i][r] += step[row(i, r)];
    return result;
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

  // Of a coordinate in the equations.
  static Eigen::Index row(std::size_t i, int coordinate)
  {
    return static_cast<Eigen::Index>(3 * i) + coordinate;
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
