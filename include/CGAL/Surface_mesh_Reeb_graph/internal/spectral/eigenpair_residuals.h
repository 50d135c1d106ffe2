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

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// `||L psi - lambda M psi|| / (lambda ||M psi||)` of every pair; without meaning for `lambda == 0`.
inline Eigen::VectorXd relative_residuals(const Eigen::SparseMatrix<double>& stiffness,
                                          const Eigen::VectorXd& mass,
                                          const Eigenpairs& pairs)
{
  Eigen::VectorXd result(pairs.values.size());
  Eigen::VectorXd l_psi(mass.size()), m_psi(mass.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    l_psi.noalias() = stiffness * pairs.vectors.col(i);
    m_psi = mass.cwiseProduct(pairs.vectors.col(i));
    result[i] = (l_psi - pairs.values[i] * m_psi).norm() / (pairs.values[i] * m_psi.norm());
  }
  return result;
}

// The largest entry of `|Psi^T M Psi - I|`.
inline double
orthonormality_error(const Eigen::VectorXd& mass, const Eigen::Ref<const Eigen::MatrixXd>& psi)
{
  // Rows of some hundred functions that stay in the cache while all of them meet all others.
  constexpr Eigen::Index rows_in_cache = 512;
  Eigen::MatrixXd gram = -Eigen::MatrixXd::Identity(psi.cols(), psi.cols()), rows;
  for (Eigen::Index row = 0; row < psi.rows(); row += rows_in_cache) {
    const Eigen::Index size = (std::min)(rows_in_cache, psi.rows() - row);
    rows = mass.segment(row, size).cwiseSqrt().asDiagonal() * psi.middleRows(row, size);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  }
  return gram.size() == 0
             ? 0
             : gram.triangularView<Eigen::Lower>().toDenseMatrix().cwiseAbs().maxCoeff();
}

// `||L 1||` relative to `||L||`, in Frobenius norm, and `||1||`.
inline double null_space_residual(const Eigen::SparseMatrix<double>& stiffness)
{
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(stiffness.cols());
  return (stiffness * ones).norm() / (stiffness.norm() * ones.norm());
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_EIGENPAIR_RESIDUALS_H
