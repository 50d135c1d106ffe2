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

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

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

struct Scalar_product
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(const double* x, const double* y, Eigen::Index size, double* result)
  {
    Vector<double, width> v, w, sums;
    fill(sums, 0.);
    Eigen::Index i = 0;
    for (; i + width <= size; i += width) {
      load(v, x + i);
      load(w, y + i);
      sums += v * w;
    }
    *result = 0;
    for (int k = 0; k < width; ++k)
      *result += sums[k];
    for (; i < size; ++i)
      *result += x[i] * y[i];
  }
};

// `y += factor x`
struct Add_multiple
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(double factor, const double* x, Eigen::Index size, double* y)
  {
    Eigen::Index i = 0;
    for (; i + width <= size; i += width) {
      Vector<double, width> v, w;
      load(v, x + i);
      load(w, y + i);
      w += factor * v;
      store(w, y + i);
    }
    for (; i < size; ++i)
      y[i] += factor * x[i];
  }
};

inline double scalar_product(const double* x, const double* y, Eigen::Index size)
{
  double result;
  run_kernel<Scalar_product>(x, y, size, &result);
  return result;
}

inline void add_multiple(double factor, const double* x, Eigen::Index size, double* y)
{
  run_kernel<Add_multiple>(factor, x, size, y);
}

// `A = Q T Q^T` with a symmetric tridiagonal matrix T and an orthogonal matrix Q that is a product
// of reflections `I - 2 v v^T` (Householder 1958; Golub and Van Loan, "Matrix computations",
// Section 8.3).
//
// Eigen has the same, and all below, with blocks of reflections that are multiplied by its products
// of matrices. The matrices here have some hundred rows, where that gains nothing, and instantiating
// it took compilers a third of their time for the eigensolver.
class Tridiagonalization
{
public:
  // Of `a` the lower triangle counts. Its largest magnitude is 1, unless all are zero.
  explicit Tridiagonalization(Eigen::MatrixXd a)
    : m_a(std::move(a)), m_diagonal(m_a.rows()), m_subdiagonal(m_a.rows() > 0 ? m_a.rows() - 1 : 0)
  {
    const Eigen::Index n = m_a.rows();
    CGAL_precondition_code(
        for (Eigen::Index j = 0; j < n; ++j) for (Eigen::Index i = j; i < n; ++i))
        CGAL_precondition(!(std::abs(m_a(i, j)) > 1));
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
      const double* const v = m_a.data() + (k + 1) + k * m_a.rows();
      const Eigen::Index size = m_a.rows() - k - 1;
      for (Eigen::Index j = 0; j < z.cols(); ++j) {
        double* const column = z.data() + (k + 1) + j * z.rows();
        add_multiple(-2 * scalar_product(v, column, size), v, size, column);
      }
    }
  }

private:
  // Makes all entries of column k below the subdiagonal zero. The reflection takes their place.
  CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE void reflect(Eigen::Index k, Eigen::VectorXd& product)
  {
    const Eigen::Index n = m_a.rows(), size = n - k - 1;
    double *const v = m_a.data() + (k + 1) + k * n, *const p = product.data();
    // Of an entry that is nothing beside the largest one of the matrix, which is 1, the square may
    // have no more than a few digits: a reflection by that would not be orthogonal.
    constexpr double negligible =
        (std::numeric_limits<double>::min)() / std::numeric_limits<double>::epsilon();
    const double squared_norm_below = scalar_product(v + 1, v + 1, size - 1);
    if (squared_norm_below <= negligible) {
      m_subdiagonal[k] = v[0];
      std::fill_n(v, size, 0.); // no reflection is one with v = 0
      return;
    }
    const double norm = std::sqrt(v[0] * v[0] + squared_norm_below);
    m_subdiagonal[k] = v[0] > 0 ? -norm : norm;
    v[0] -= m_subdiagonal[k];
    const double length = std::sqrt(v[0] * v[0] + squared_norm_below);
    for (Eigen::Index i = 0; i < size; ++i)
      v[i] /= length;

    // the rest of the matrix is `A - v w^T - w v^T` with `w = 2 (A v - (v^T A v) v)`
    std::fill_n(p, size, 0.);
    for (Eigen::Index j = 0; j < size; ++j) {
      const double* const column = m_a.data() + (k + 1 + j) * (n + 1);
      const Eigen::Index below = size - j - 1;
      p[j] += column[0] * v[j] + scalar_product(column + 1, v + j + 1, below);
      add_multiple(v[j], column + 1, below, p + j + 1);
    }
    add_multiple(-scalar_product(v, p, size), v, size, p);
    for (Eigen::Index j = 0; j < size; ++j) {
      double* const column = m_a.data() + (k + 1 + j) * (n + 1);
      add_multiple(-2 * p[j], v + j, size - j, column);
      add_multiple(-2 * v[j], p + j, size - j, column);
    }
  }

  Eigen::MatrixXd m_a; // vectors v of the reflections below the diagonal
  Eigen::VectorXd m_diagonal, m_subdiagonal;
};

// A rotation in the plane of two columns: `x = c x - s y`, `y = s x + c y`.
struct Rotate_columns
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(double* x, double* y, Eigen::Index size, double c, double s)
  {
    Eigen::Index i = 0;
    for (; i + width <= size; i += width) {
      Vector<double, width> v, w, rotated;
      load(v, x + i);
      load(w, y + i);
      rotated = c * v - s * w;
      store(rotated, x + i);
      rotated = s * v + c * w;
      store(rotated, y + i);
    }
    for (; i < size; ++i) {
      const double v = x[i], w = y[i];
      x[i] = c * v - s * w;
      y[i] = s * v + c * w;
    }
  }
};

// Makes the symmetric tridiagonal matrix with the diagonal d and the subdiagonal e diagonal by
// implicit QR steps with Wilkinson's shift (Golub and Van Loan, Section 8.3), and multiplies the
// columns of z by the rotations, if there are any. Returns whether that came to an end.
class Tridiagonal_QR_iteration
{
public:
  Tridiagonal_QR_iteration(Eigen::VectorXd& d, Eigen::VectorXd& e, Eigen::MatrixXd& z)
    : m_d(d), m_e(e), m_z(z)
  {}

  CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE bool run()
  {
    constexpr Eigen::Index max_steps_per_row = 30;
    Eigen::Index end = m_d.size() - 1, steps = 0;
    while (end > 0) {
      neglect_small_entries(end);
      while (end > 0 && m_e[end - 1] == 0)
        --end;
      if (end <= 0)
        break;
      if (++steps > max_steps_per_row * m_d.size())
        return false;
      Eigen::Index begin = end - 1;
      while (begin > 0 && m_e[begin - 1] != 0)
        --begin;
      step(begin, end);
    }
    return std::all_of(
        m_d.data(), m_d.data() + m_d.size(), [](double x) { return std::isfinite(x); });
  }

private:
  // Of a matrix whose largest entry is 1.
  void neglect_small_entries(Eigen::Index end)
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (Eigen::Index i = 0; i < end; ++i)
      if (std::abs(m_e[i]) <= epsilon * std::sqrt(std::abs(m_d[i]) + std::abs(m_d[i + 1])) ||
          std::abs(m_e[i]) < (std::numeric_limits<double>::min)())
        m_e[i] = 0;
  }

  double shift(Eigen::Index end) const
  {
    const double half = (m_d[end - 1] - m_d[end]) / 2, e = m_e[end - 1];
    const double length = std::hypot(half, e);
    return m_d[end] - e / ((half + (half > 0 ? length : -length)) / e);
  }

  void step(Eigen::Index begin, Eigen::Index end)
  {
    double x = m_d[begin] - shift(end), bulge = m_e[begin];
    for (Eigen::Index k = begin; k < end && bulge != 0; ++k) {
      // the rotation that takes (x, bulge) to the first axis
      const double length = std::hypot(x, bulge), c = x / length, s = -bulge / length;
      if (k > begin)
        m_e[k - 1] = length;
      const double p = m_d[k], q = m_e[k], r = m_d[k + 1];
      m_d[k] = c * (c * p - s * q) - s * (c * q - s * r);
      m_d[k + 1] = s * (s * p + c * q) + c * (s * q + c * r);
      m_e[k] = c * (s * p + c * q) - s * (s * q + c * r);
      x = m_e[k];
      if (k + 1 < end) {
        bulge = -s * m_e[k + 1];
        m_e[k + 1] *= c;
      }
      if (m_z.cols() > 0)
        run_kernel<Rotate_columns>(
            m_z.data() + k * m_z.rows(), m_z.data() + (k + 1) * m_z.rows(), m_z.rows(), c, s);
    }
  }

  Eigen::VectorXd& m_d;
  Eigen::VectorXd& m_e;
  Eigen::MatrixXd& m_z;
};

// Of `a` the lower triangle counts.
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline Symmetric_eigenpairs
symmetric_eigenpairs(Eigen::MatrixXd a, bool with_vectors = true)
{
  CGAL_precondition(a.rows() == a.cols());
  const Eigen::Index n = a.rows();
  double scale = 0;
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = j; i < n; ++i)
      scale = (std::max)(scale, std::abs(a(i, j)));
  if (scale > 0)
    a /= scale; // no square is out of range then
  const Tridiagonalization tridiagonalization(std::move(a));
  Eigen::VectorXd d = tridiagonalization.diagonal(), e = tridiagonalization.subdiagonal();
  Eigen::MatrixXd z;
  if (with_vectors)
    z = Eigen::MatrixXd::Identity(n, n);
  Symmetric_eigenpairs result;
  result.have_converged = Tridiagonal_QR_iteration(d, e, z).run();
  if (!result.have_converged)
    return result;
  if (with_vectors)
    tridiagonalization.apply(z);

  std::vector<std::pair<double, std::size_t>> order;
  for (Eigen::Index i = 0; i < n; ++i)
    order.emplace_back(d[i], static_cast<std::size_t>(i));
  std::sort(order.begin(), order.end());
  result.values.resize(n);
  result.vectors.resize(n, with_vectors ? n : 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto from = static_cast<Eigen::Index>(order[static_cast<std::size_t>(i)].second);
    result.values[i] = scale * d[from];
    if (with_vectors)
      result.vectors.col(i) = z.col(from);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_SYMMETRIC_EIGENPAIRS_H
