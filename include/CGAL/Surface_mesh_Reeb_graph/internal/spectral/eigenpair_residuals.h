// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_EIGENPAIR_RESIDUALS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_EIGENPAIR_RESIDUALS_H

#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_coefficients.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/block_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// `A x` for a column of numbers.
inline Eigen::VectorXd sparse_product(const Eigen::SparseMatrix<double>& a, const double* x)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(a.rows());
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(a, j); it; ++it)
      result[it.row()] += it.value() * x[j];
  return result;
}

// What rounding leaves of a backward error: a third of the epsilon was measured.
constexpr double attainable_backward_error = 4 * std::numeric_limits<double>::epsilon();

struct Eigenpair_residuals
{
  // `||L psi - lambda M psi|| / (lambda ||M psi||)`, without meaning for `lambda == 0`
  Eigen::VectorXd relative;
  // `||L psi - lambda M psi|| / || |L| |psi| + lambda M |psi| ||`
  Eigen::VectorXd backward;
};

CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline Eigenpair_residuals
eigenpair_residuals(const Eigen::SparseMatrix<double>& stiffness,
                    const Eigen::VectorXd& mass,
                    const Eigenpairs& pairs)
{
  CGAL_precondition(pairs.vectors.rows() == mass.size());
  CGAL_precondition(pairs.vectors.cols() == pairs.values.size());
  const Eigen::Index n = mass.size(), number = pairs.values.size();
  Eigenpair_residuals result = {Eigen::VectorXd(number), Eigen::VectorXd(number)};
  Eigen::VectorXd m_psi(n), residual(n), magnitude(n);
  for (Eigen::Index i = 0; i < number; ++i) {
    const double* const psi = pairs.vectors.data() + i * n;
    const double lambda = pairs.values[i];
    for (Eigen::Index r = 0; r < n; ++r) {
      m_psi[r] = mass[r] * psi[r];
      residual[r] = -lambda * m_psi[r];
      magnitude[r] = std::abs(residual[r]);
    }
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, j); it; ++it) {
        const double product = it.value() * psi[j];
        residual[it.row()] += product;
        magnitude[it.row()] += std::abs(product);
      }
    const double norm = residual.norm();
    result.relative[i] = norm / (lambda * m_psi.norm());
    result.backward[i] = norm / magnitude.norm();
  }
  return result;
}

// The largest entry of `|Psi^T M Psi - I|` for the first `number` eigenfunctions.
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline double
orthonormality_error(const Eigen::VectorXd& mass, const Eigen::MatrixXd& psi, Eigen::Index number)
{
  CGAL_precondition(psi.rows() == mass.size() && number <= psi.cols());
  const Eigen::Index number_of_blocks = (number + block_width - 1) / block_width;
  std::vector<Block_coefficients> gram(
      static_cast<std::size_t>(number_of_blocks * number_of_blocks));
  const auto gram_block = [&](Eigen::Index i, Eigen::Index j) -> Block_coefficients& {
    return gram[static_cast<std::size_t>(i * number_of_blocks + j)];
  };
  // rows of all functions that stay in the cache while all of them meet all others
  constexpr Eigen::Index block_size = block_width * rows_in_cache;
  std::vector<double> rows(static_cast<std::size_t>(number_of_blocks * block_size), 0.);
  Eigen::VectorXd sqrt_mass(rows_in_cache);
  for (Eigen::Index begin = 0; begin < psi.rows(); begin += rows_in_cache) {
    const Eigen::Index size = (std::min)(rows_in_cache, psi.rows() - begin);
    for (Eigen::Index r = 0; r < size; ++r)
      sqrt_mass[r] = std::sqrt(mass[begin + r]);
    for (Eigen::Index k = 0; k < number; ++k) {
      double* const to = rows.data() + k / block_width * block_size + k % block_width;
      for (Eigen::Index r = 0; r < size; ++r)
        to[block_width * r] = sqrt_mass[r] * psi(begin + r, k);
    }
    for (Eigen::Index i = 0; i < number_of_blocks; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        add_transposed_product(
            rows.data() + i * block_size, rows.data() + j * block_size, size, gram_block(i, j));
  }

  double result = 0;
  for (Eigen::Index i = 0; i < number; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double product = gram_block(i / block_width, j / block_width)(
          static_cast<int>(i % block_width), static_cast<int>(j % block_width));
      result = (std::max)(result, std::abs(product - (i == j ? 1 : 0)));
    }
  return result;
}

// `||L 1||` relative to `||L||`, in Frobenius norm, and `||1||`.
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline double
null_space_residual(const Eigen::SparseMatrix<double>& stiffness)
{
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(stiffness.cols());
  return sparse_product(stiffness, ones.data()).norm() / (stiffness.norm() * ones.norm());
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_EIGENPAIR_RESIDUALS_H
