// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_FARTHEST_PAIR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_FARTHEST_PAIR_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/row_distances.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The two rows of `eigenfunctions` (numbers of type `float` or `double`) that are farthest from
// each other after multiplication of the columns with the given factors, which decrease from 1.
//
// First the farthest point from a point is taken again and again until the distance grows no more.
// In the sphere around the middle of that pair, two points farther apart than the pair cannot both
// lie inside; the pairs that this leaves are compared exactly. At large times one function rules,
// and few are left. On shapes so symmetric that all points are candidates (a sphere), or at times
// so small that many eigenfunctions count, there may be too many: the comparison stops after half a
// billion numbers, which takes about half a second. The pair found by then need not be the farthest
// of all.
//
// Every step of the first part, of which there are few, and the middle take one pass over the
// columns whose factors are not negligible.
template <class Matrix>
std::pair<std::size_t, std::size_t>
farthest_pair(const Matrix& eigenfunctions, const Eigen::VectorXd& all_factors)
{
  using Number = typename Matrix::Scalar;
  CGAL_precondition(eigenfunctions.rows() > 0 && all_factors.size() > 0);
  CGAL_precondition(eigenfunctions.cols() == all_factors.size());
  // the square is lost in the rounding of the first one
  constexpr double negligible = 1e-9;
  const Eigen::Index dimension = number_of_factors_above(all_factors, negligible);
  const Eigen::VectorXd factors = all_factors.head(dimension);
  const Columns<Number> columns(eigenfunctions.leftCols(dimension));

  Eigen::Index p = 0, q = 0;
  double longest = -1; // squared
  for (;;) {
    Eigen::Index next;
    const double squared_distance =
        squared_distances<Number>(columns, factors, row_of<Number>(columns, q)).maxCoeff(&next);
    if (squared_distance <= longest)
      break;
    longest = squared_distance;
    p = q;
    q = next;
  }

  Eigen::VectorXd middle = row_of<Number>(columns, p);
  const Eigen::VectorXd end_of_pair = row_of<Number>(columns, q);
  for (Eigen::Index k = 0; k < dimension; ++k)
    middle[k] = (middle[k] + end_of_pair[k]) / 2;
  const Eigen::VectorXd squared_radius = squared_distances<Number>(columns, factors, middle);
  const double largest_radius = std::sqrt(
      *std::max_element(squared_radius.data(), squared_radius.data() + squared_radius.size()));
  // Those that are farthest from the middle come first: an end of the pair is likely among them.
  std::vector<std::pair<double, std::size_t>> candidates; // negative radius and row
  for (Eigen::Index i = 0; i < squared_radius.size(); ++i) {
    const double radius = std::sqrt(squared_radius[i]);
    if (radius + largest_radius > std::sqrt(longest))
      candidates.emplace_back(-radius, static_cast<std::size_t>(i));
  }
  std::sort(candidates.begin(), candidates.end());
  const auto number_of_candidates = static_cast<Eigen::Index>(candidates.size());
  const auto row_of_candidate = [&](Eigen::Index i) {
    return static_cast<Eigen::Index>(candidates[static_cast<std::size_t>(i)].second);
  };
  Eigen::MatrixXd points(number_of_candidates, dimension);
  for (Eigen::Index k = 0; k < dimension; ++k)
    for (Eigen::Index i = 0; i < number_of_candidates; ++i)
      points(i, k) = columns(row_of_candidate(i), k);

  constexpr Eigen::Index block_size = 512;
  Eigen::VectorXd block(block_size);
  Eigen::Index budget = 500000000 / dimension;
  Eigen::Index end = number_of_candidates; // before it are those that may be far enough from i
  for (Eigen::Index i = 0; i < number_of_candidates && budget > 0; ++i) {
    const auto radius_of = [&](Eigen::Index j) {
      return -candidates[static_cast<std::size_t>(j)].first;
    };
    while (end > i + 1 && radius_of(end - 1) + radius_of(i) <= std::sqrt(longest))
      --end;
    if (end <= i + 1)
      break; // nor are there any for the points that follow
    budget -= end - (i + 1);
    const Eigen::VectorXd point = row_of<double>(points, i);
    for (Eigen::Index begin = i + 1; begin < end; begin += block_size) {
      const Eigen::Index size = (std::min)(block_size, end - begin);
      write_squared_distances<double>(points, factors, point, begin, block.head(size));
      Eigen::Index j;
      const double squared_distance = block.head(size).maxCoeff(&j);
      if (squared_distance > longest) {
        longest = squared_distance;
        p = row_of_candidate(i);
        q = row_of_candidate(begin + j);
      }
    }
  }
  return std::make_pair(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_FARTHEST_PAIR_H
