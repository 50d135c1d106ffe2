// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DISTANCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DISTANCES_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The weights that a distance gives to the eigenpairs, from their eigenvalues (increasing, not zero).
// The eigenvalues are normalized by the smallest one.

// Eq. 8 of the paper.
inline Eigen::VectorXd diffusion_weights(const Eigen::VectorXd& eigenvalues, double time)
{
  return (-2 * time * eigenvalues.array() / eigenvalues[0]).exp();
}

// The same without the factor `exp(-2 t)` that all weights have in common: for comparisons of distances
// at large times, where it would underflow.
inline Eigen::VectorXd relative_diffusion_weights(const Eigen::VectorXd& eigenvalues, double time)
{
  return (-2 * time * (eigenvalues.array() / eigenvalues[0] - 1)).exp();
}

// Eq. 9 of the paper.
inline Eigen::VectorXd commute_time_weights(const Eigen::VectorXd& eigenvalues)
{
  return eigenvalues[0] * eigenvalues.cwiseInverse();
}

// For every row x of `eigenfunctions` the largest, over the rows y of the sources, of
// `sum_i weights[i] (x[i] - y[i])^2`. In blocks of rows that stay in the cache for all sources.
inline Eigen::VectorXd largest_squared_distances(const Eigen::MatrixXd& eigenfunctions,
                                                 const Eigen::VectorXd& weights,
                                                 const std::vector<std::size_t>& sources)
{
  constexpr Eigen::Index block_size = 256;
  const Eigen::Index n = eigenfunctions.rows();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
  Eigen::ArrayXd sum(block_size);
  for (Eigen::Index begin = 0; begin < n; begin += block_size) {
    const Eigen::Index size = (std::min)(block_size, n - begin);
    for (std::size_t source : sources) {
      sum.head(size).setZero();
      for (Eigen::Index i = 0; i < weights.size(); ++i)
        sum.head(size) += weights[i] * (eigenfunctions.col(i).segment(begin, size).array() -
                                        eigenfunctions(static_cast<Eigen::Index>(source), i))
                                           .square();
      result.segment(begin, size) = result.segment(begin, size).cwiseMax(sum.head(size).matrix());
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DISTANCES_H
