// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SYMMETRIC_EIGENPAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SYMMETRIC_EIGENPAIRS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <utility>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The eigenpairs of a dense symmetric matrix, with increasing eigenvalues.
struct Symmetric_eigenpairs
{
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors; // a column for every value; empty if they were not wanted
  bool have_converged = false;
};

// `A = Q T Q^T` with a symmetric tridiagonal matrix T and an orthogonal matrix Q that is a product
// of reflections `I - 2 v v^T` (Householder 1958; Golub and Van Loan, "Matrix computations",
// Section 8.3).
//
// Eigen has the same, with blocks of reflections that are multiplied by its products of matrices.
// The matrices here have some hundred rows, where that gains nothing, and instantiating it took
// compilers a third of their time for the eigensolver.
class Tridiagonalization
{
public:
  // Of `a` the lower triangle counts.
  explicit Tridiagonalization(Eigen::MatrixXd a)
    : m_a(std::move(a)), m_diagonal(m_a.rows()), m_subdiagonal(m_a.rows() > 0 ? m_a.rows() - 1 : 0)
  {
    const Eigen::Index n = m_a.rows();
    Eigen::VectorXd product(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      m_diagonal[k] = m_a(k, k);
      if (k + 1 < n)
        reflect(k, product);
    }
  }

  const Eigen::VectorXd& diagonal() const { return m_diagonal; }
  const Eigen::VectorXd& subdiagonal() const { return m_subdiagonal; }

  // `z = Q z`
  CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE void apply(Eigen::MatrixXd& z) const
  {
    for (Eigen::Index k = m_a.rows() - 2; k >= 0; --k) {
      const Vector_map v(m_a.data() + (k + 1) + k * m_a.rows(), m_a.rows() - k - 1);
      for (Eigen::Index j = 0; j < z.cols(); ++j) {
        Eigen::Map<Eigen::VectorXd> column(z.data() + (k + 1) + j * z.rows(), v.size());
        column -= (2 * v.dot(column)) * v;
      }
    }
  }

private:
  using Vector_map = Eigen::Map<const Eigen::VectorXd>;

  // Makes all entries of column k below the subdiagonal zero. The reflection takes their place.
  CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE void reflect(Eigen::Index k, Eigen::VectorXd& product)
  {
    const Eigen::Index n = m_a.rows(), size = n - k - 1;
    Eigen::Map<Eigen::VectorXd> v(m_a.data() + (k + 1) + k * n, size), p(product.data(), size);
    const double norm = v.norm(), first = v[0];
    m_subdiagonal[k] = first > 0 ? -norm : norm;
    v[0] -= m_subdiagonal[k];
    const double length = v.norm();
    if (!(length > 0))
      return; // they are zero; no reflection is one with v = 0
    v /= length;

    // the rest of the matrix is `A - v w^T - w v^T` with `w = 2 (A v - (v^T A v) v)`
    p.setZero();
    for (Eigen::Index j = 0; j < size; ++j) {
      const double* const column = m_a.data() + (k + 1 + j) * (n + 1);
      const Vector_map below(column + 1, size - j - 1);
      p[j] += column[0] * v[j] + below.dot(v.tail(size - j - 1));
      p.tail(size - j - 1) += v[j] * below;
    }
    p = 2 * (p - v.dot(p) * v);
    for (Eigen::Index j = 0; j < size; ++j) {
      Eigen::Map<Eigen::VectorXd> column(m_a.data() + (k + 1 + j) * (n + 1), size - j);
      column -= p[j] * v.tail(size - j) + v[j] * p.tail(size - j);
    }
  }

  Eigen::MatrixXd m_a; // vectors v of the reflections below the diagonal
  Eigen::VectorXd m_diagonal, m_subdiagonal;
};

// Of `a` the lower triangle counts.
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline Symmetric_eigenpairs
symmetric_eigenpairs(Eigen::MatrixXd a, bool with_vectors = true)
{
  Symmetric_eigenpairs result;
  // so that no square is out of range
  const double largest = a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff(),
               scale = largest > 0 ? largest : 1;
  a /= scale;
  const Tridiagonalization tridiagonalization(std::move(a));
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(tridiagonalization.diagonal(),
                                tridiagonalization.subdiagonal(),
                                with_vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
  result.have_converged = solver.info() == Eigen::Success;
  if (!result.have_converged)
    return result;
  result.values = scale * solver.eigenvalues();
  if (with_vectors) {
    result.vectors = solver.eigenvectors();
    tridiagonalization.apply(result.vectors);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SYMMETRIC_EIGENPAIRS_H
