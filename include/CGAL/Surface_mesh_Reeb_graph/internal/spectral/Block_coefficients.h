// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_COEFFICIENTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_COEFFICIENTS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The number of vectors that are multiplied and made orthogonal together: a row of them is one
// cache line.
constexpr int block_width = 8;

// A small square matrix, by rows; zero at first. It is none of Eigen's, since every product and
// every assignment of matrices of fixed size is unrolled where it stands: some dozens of these took
// compilers as long as the rest of the eigensolver.
class Block_coefficients
{
public:
  static Block_coefficients identity()
  {
    Block_coefficients result;
    for (int i = 0; i < block_width; ++i)
      result(i, i) = 1;
    return result;
  }

  double& operator()(int i, int j) { return m_entries[block_width * i + j]; }
  double operator()(int i, int j) const { return m_entries[block_width * i + j]; }

  double* data() { return m_entries; }
  const double* data() const { return m_entries; }

  bool is_zero() const
  {
    return std::all_of(
        m_entries, m_entries + block_width * block_width, [](double x) { return x == 0; });
  }

  Block_coefficients operator-() const
  {
    Block_coefficients result;
    std::transform(m_entries,
                   m_entries + block_width * block_width,
                   result.m_entries,
                   [](double x) { return -x; });
    return result;
  }

  Block_coefficients transposed() const
  {
    Block_coefficients result;
    for (int i = 0; i < block_width; ++i)
      for (int j = 0; j < block_width; ++j)
        result(j, i) = (*this)(i, j);
    return result;
  }

private:
  double m_entries[block_width * block_width] = {};
};

CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline Block_coefficients
operator*(const Block_coefficients& a, const Block_coefficients& b)
{
  Block_coefficients result;
  for (int i = 0; i < block_width; ++i)
    for (int k = 0; k < block_width; ++k)
      for (int j = 0; j < block_width; ++j)
        result(i, j) += a(i, k) * b(k, j);
  return result;
}

// The smallest and the largest magnitude on the diagonal.
inline double smallest_on_diagonal(const Block_coefficients& a)
{
  double result = std::abs(a(0, 0));
  for (int i = 1; i < block_width; ++i)
    result = (std::min)(result, std::abs(a(i, i)));
  return result;
}

inline double largest_on_diagonal(const Block_coefficients& a)
{
  double result = 0;
  for (int i = 0; i < block_width; ++i)
    result = (std::max)(result, std::abs(a(i, i)));
  return result;
}

// The Cholesky factorization `a = r^T r` with an upper triangular r; returns whether all pivots are
// positive.
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline bool
factor_symmetric(const Block_coefficients& a, Block_coefficients& r)
{
  r = Block_coefficients();
  for (int j = 0; j < block_width; ++j)
    for (int i = 0; i <= j; ++i) {
      double sum = a(i, j);
      for (int k = 0; k < i; ++k)
        sum -= r(k, i) * r(k, j);
      if (i < j)
        r(i, j) = sum / r(i, i);
      else if (sum > 0)
        r(j, j) = std::sqrt(sum);
      else
        return false;
    }
  return true;
}

CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE inline Block_coefficients
inverse_of_upper_triangle(const Block_coefficients& r)
{
  Block_coefficients result;
  for (int j = 0; j < block_width; ++j) {
    result(j, j) = 1 / r(j, j);
    for (int i = j - 1; i >= 0; --i) {
      double sum = 0;
      for (int k = i + 1; k <= j; ++k)
        sum += r(i, k) * result(k, j);
      result(i, j) = -sum / r(i, i);
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_COEFFICIENTS_H
