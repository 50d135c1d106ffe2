// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_FARTHEST_PAIR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_FARTHEST_PAIR_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The two rows of `eigenfunctions` that are farthest from each other in the distance with the given
// weights, which decrease from 1.
//
// First the farthest point from a point is taken in turn until the distance grows no more. In the sphere
// around the middle of that pair, two points farther apart than the pair cannot both lie inside; the pairs
// that this leaves are compared exactly. At large times one eigenfunction rules, and few are left. On
// shapes so symmetric that all points are candidates (a sphere) the comparison stops after a number of
// pairs in proportion to the number of points: the result is then a pair no end of which can be moved to
// make it longer.
inline std::pair<std::size_t, std::size_t>
farthest_pair(const Eigen::MatrixXd& eigenfunctions, const Eigen::VectorXd& weights)
{
  // weights that are lost in the rounding of the first one
  constexpr double negligible = 1e-18;
  const Eigen::Index dimension = (weights.array() > negligible).count();
  // a point per column
  const Eigen::MatrixXd points = weights.head(dimension).cwiseSqrt().asDiagonal() *
                                 eigenfunctions.leftCols(dimension).transpose();
  const Eigen::Index n = points.cols();

  auto farthest_from = [&](Eigen::Index i) {
    Eigen::Index j;
    const double squared_distance =
        (points.colwise() - points.col(i)).colwise().squaredNorm().maxCoeff(&j);
    return std::make_pair(squared_distance, j);
  };
  Eigen::Index p = 0, q = 0;
  double longest = -1;
  for (;;) {
    const std::pair<double, Eigen::Index> next = farthest_from(q);
    if (next.first <= longest)
      break;
    longest = next.first;
    p = q;
    q = next.second;
  }

  const Eigen::VectorXd middle = (points.col(p) + points.col(q)) / 2;
  const Eigen::VectorXd radius = (points.colwise() - middle).colwise().norm();
  std::vector<Eigen::Index> by_radius(static_cast<std::size_t>(n));
  std::iota(by_radius.begin(), by_radius.end(), Eigen::Index(0));
  std::sort(by_radius.begin(), by_radius.end(), [&](Eigen::Index i, Eigen::Index j) {
    return radius[i] > radius[j];
  });
  std::size_t budget = 10000000 + 100 * static_cast<std::size_t>(n);
  for (std::size_t i = 1; i < by_radius.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Index a = by_radius[i], b = by_radius[j];
      const double bound = radius[a] + radius[b];
      if (bound * bound <= longest) {
        if (j == 0)
          i = by_radius.size() - 1; // nor can any of the points that follow
        break;
      }
      const double squared_distance = (points.col(a) - points.col(b)).squaredNorm();
      if (squared_distance > longest) {
        longest = squared_distance;
        p = a;
        q = b;
      }
      if (--budget == 0)
        return std::make_pair(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
    }
  }
  return std::make_pair(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_FARTHEST_PAIR_H
