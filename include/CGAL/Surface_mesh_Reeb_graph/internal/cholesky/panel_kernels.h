// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_KERNELS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// How many right-hand sides the kernels solve for at a time: a row of them is one cache line.
constexpr int kernel_columns = 8;

// `number` rows of right-hand sides, of each as many columns as two vectors have: with the sums for
// four columns of the panel these fill the registers that every 64-bit processor has.
template <class Scalar, int width, int number>
class Kernel_rows
{
public:
  CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE explicit Kernel_rows(const Scalar* x)
  {
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int row = 0; row < number; ++row) {
      load(m_vectors[row][0], x + kernel_columns * row);
      load(m_vectors[row][1], x + kernel_columns * row + width);
    }
  }

  CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void write(Scalar* x) const
  {
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int row = 0; row < number; ++row) {
      store(m_vectors[row][0], x + kernel_columns * row);
      store(m_vectors[row][1], x + kernel_columns * row + width);
    }
  }

  CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void multiply(int row, Scalar factor)
  {
    m_vectors[row][0] = factor * m_vectors[row][0];
    m_vectors[row][1] = factor * m_vectors[row][1];
  }

  // Subtracts a multiple of the row `other_row` of other rows.
  template <int other_number>
  CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  subtract(int row, Scalar factor, const Kernel_rows<Scalar, width, other_number>& x, int other_row)
  {
    m_vectors[row][0] -= factor * x.m_vectors[other_row][0];
    m_vectors[row][1] -= factor * x.m_vectors[other_row][1];
  }

private:
  template <class, int, int>
  friend class Kernel_rows;

  Vector<Scalar, width> m_vectors[number][2];
};

// Both substitutions for `columns` columns of a panel of a triangular factor, `stride` apart, the
// first of which begins on the diagonal at l. The triangle has `inside` rows below those columns,
// and there are `below` rows below the triangle. x are the rows of the right-hand sides from the
// first of the columns on, y those below the triangle, which may be null where there are none:
// nothing may be added to it then.
template <class Scalar, int columns>
struct Substitute_forward
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(const Scalar* l,
                                                             Eigen::Index stride,
                                                             Eigen::Index inside,
                                                             Eigen::Index below,
                                                             Scalar* x,
                                                             Scalar* y)
  {
    for (int j = 0; j < kernel_columns; j += 2 * width)
      substitute<width>(l, stride, inside, below, x + j, below == 0 ? y : y + j);
  }

private:
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void substitute(const Scalar* l,
                                                                    Eigen::Index stride,
                                                                    Eigen::Index inside,
                                                                    Eigen::Index below,
                                                                    Scalar* x,
                                                                    Scalar* y)
  {
    Kernel_rows<Scalar, width, columns> r(x);
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int k = 0; k < columns; ++k) {
      r.multiply(k, 1 / l[k + k * stride]);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int i = k + 1; i < columns; ++i)
        r.subtract(i, l[i + k * stride], r, k);
    }
    r.write(x);
    subtract_columns(l + columns, stride, inside, r, x + kernel_columns * columns);
    subtract_columns(l + columns + inside, stride, below, r, y);
  }

  // `y -= l x`
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  subtract_columns(const Scalar* l,
                   Eigen::Index stride,
                   Eigen::Index rows,
                   const Kernel_rows<Scalar, width, columns>& x,
                   Scalar* y)
  {
    for (Eigen::Index i = 0; i < rows; ++i, ++l, y += kernel_columns) {
      Kernel_rows<Scalar, width, 1> sum(y);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int k = 0; k < columns; ++k)
        sum.subtract(0, l[k * stride], x, k);
      sum.write(y);
    }
  }
};

template <class Scalar, int columns>
struct Substitute_backward
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(const Scalar* l,
                                                             Eigen::Index stride,
                                                             Eigen::Index inside,
                                                             Eigen::Index below,
                                                             Scalar* x,
                                                             const Scalar* y)
  {
    for (int j = 0; j < kernel_columns; j += 2 * width)
      substitute<width>(l, stride, inside, below, x + j, below == 0 ? y : y + j);
  }

private:
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void substitute(const Scalar* l,
                                                                    Eigen::Index stride,
                                                                    Eigen::Index inside,
                                                                    Eigen::Index below,
                                                                    Scalar* x,
                                                                    const Scalar* y)
  {
    Kernel_rows<Scalar, width, columns> r(x);
    subtract_transposed_columns(l + columns + inside, stride, below, y, r);
    subtract_transposed_columns(l + columns, stride, inside, x + kernel_columns * columns, r);
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int k = columns - 1; k >= 0; --k) {
      r.multiply(k, 1 / l[k + k * stride]);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int i = 0; i < k; ++i)
        r.subtract(i, l[k + i * stride], r, k);
    }
    r.write(x);
  }

  // `x -= l^T y`
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  subtract_transposed_columns(const Scalar* l,
                              Eigen::Index stride,
                              Eigen::Index rows,
                              const Scalar* y,
                              Kernel_rows<Scalar, width, columns>& x)
  {
    for (Eigen::Index i = 0; i < rows; ++i, ++l, y += kernel_columns) {
      const Kernel_rows<Scalar, width, 1> row(y);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int k = 0; k < columns; ++k)
        x.subtract(k, l[k * stride], row, 0);
    }
  }
};

// `c -= a b^T` for a tile of 16 x 8 entries of c, whose columns are `stride` apart, where the
// columns of a and b follow each other.
constexpr Eigen::Index tile_rows = 16, tile_columns = 8;

template <class Scalar>
struct Subtract_tile
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(const Scalar* a, const Scalar* b, Eigen::Index depth, Scalar* c, Eigen::Index stride)
  {
    // Arrays without columns may be null, which nothing may be added to.
    if (depth == 0)
      return;
    for (Eigen::Index j = 0; j < tile_columns; j += columns_in_registers)
      for (Eigen::Index i = 0; i < tile_rows; i += 2 * width)
        subtract_part<width>(a + i, b + j, depth, c + i + j * stride, stride);
  }

private:
  static constexpr int columns_in_registers = 4;

  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void subtract_part(
      const Scalar* a, const Scalar* b, Eigen::Index depth, Scalar* c, Eigen::Index stride)
  {
    Vector<Scalar, width> sum[columns_in_registers][2], x[2];
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int q = 0; q < columns_in_registers; ++q) {
      load(sum[q][0], c + q * stride);
      load(sum[q][1], c + q * stride + width);
    }
    for (Eigen::Index k = 0; k < depth; ++k, a += tile_rows, b += tile_columns) {
      load(x[0], a);
      load(x[1], a + width);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int q = 0; q < columns_in_registers; ++q) {
        sum[q][0] -= b[q] * x[0];
        sum[q][1] -= b[q] * x[1];
      }
    }
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int q = 0; q < columns_in_registers; ++q) {
      store(sum[q][0], c + q * stride);
      store(sum[q][1], c + q * stride + width);
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_KERNELS_H
