// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_KERNELS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_coefficients.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Vectors side by side: a row of them is one cache line, which every kernel below uses at once.
using Row_block = Eigen::Matrix<double, Eigen::Dynamic, block_width, Eigen::RowMajor>;

// Rows of a block that stay in the cache while they meet all other blocks.
constexpr Eigen::Index rows_in_cache = 512;

// Both kernels keep sums of four rows and two vectors in registers, as many as every 64-bit
// processor has for them.
constexpr int tile_height = 4;

struct Add_transposed_product
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(const double* v, const double* w, Eigen::Index rows, double* c)
  {
    // An array without rows may be null, which nothing may be added to.
    if (rows == 0)
      return;
    for (int i = 0; i < block_width; i += tile_height)
      for (int j = 0; j < block_width; j += 2 * width)
        add_tile<width>(v + i, w + j, rows, c + block_width * i + j);
  }

private:
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  add_tile(const double* v, const double* w, Eigen::Index rows, double* c)
  {
    Vector<double, width> sum[tile_height][2], x[2];
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int k = 0; k < tile_height; ++k) {
      load(sum[k][0], c + block_width * k);
      load(sum[k][1], c + block_width * k + width);
    }
    for (Eigen::Index row = 0; row < rows; ++row, v += block_width, w += block_width) {
      load(x[0], w);
      load(x[1], w + width);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int k = 0; k < tile_height; ++k) {
        sum[k][0] += v[k] * x[0];
        sum[k][1] += v[k] * x[1];
      }
    }
    CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
    for (int k = 0; k < tile_height; ++k) {
      store(sum[k][0], c + block_width * k);
      store(sum[k][1], c + block_width * k + width);
    }
  }
};

struct Subtract_product
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(double* w, const double* v, Eigen::Index rows, const double* c)
  {
    Eigen::Index row = 0;
    for (; row + tile_height <= rows; row += tile_height)
      subtract_from_rows<width, tile_height>(w + block_width * row, v + block_width * row, c);
    for (; row < rows; ++row)
      subtract_from_rows<width, 1>(w + block_width * row, v + block_width * row, c);
  }

private:
  template <int width, int number>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  subtract_from_rows(double* w, const double* v, const double* c)
  {
    for (int j = 0; j < block_width; j += 2 * width) {
      Vector<double, width> sum[number][2], x[2];
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int i = 0; i < number; ++i) {
        load(sum[i][0], w + block_width * i + j);
        load(sum[i][1], w + block_width * i + j + width);
      }
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int k = 0; k < block_width; ++k) {
        load(x[0], c + block_width * k + j);
        load(x[1], c + block_width * k + j + width);
        CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
        for (int i = 0; i < number; ++i) {
          sum[i][0] -= v[block_width * i + k] * x[0];
          sum[i][1] -= v[block_width * i + k] * x[1];
        }
      }
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int i = 0; i < number; ++i) {
        store(sum[i][0], w + block_width * i + j);
        store(sum[i][1], w + block_width * i + j + width);
      }
    }
  }
};

struct Multiply_rows
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
  run(const double* x, const double* factors, Eigen::Index rows, double* y)
  {
    for (Eigen::Index row = 0; row < rows; ++row, x += block_width, y += block_width) {
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int j = 0; j < block_width; j += width) {
        Vector<double, width> v;
        load(v, x + j);
        v = factors[row] * v;
        store(v, y + j);
      }
    }
  }
};

// `c += v^T w` for blocks of `rows` rows.
inline void
add_transposed_product(const double* v, const double* w, Eigen::Index rows, Block_coefficients& c)
{
  run_kernel<Add_transposed_product>(v, w, rows, c.data());
}

// `w -= v c` for blocks of `rows` rows.
inline void
subtract_product(double* w, const double* v, Eigen::Index rows, const Block_coefficients& c)
{
  run_kernel<Subtract_product>(w, v, rows, c.data());
}

// `y = D x` with the diagonal matrix D of the factors; y may be x.
inline void multiply_rows(const Row_block& x, const Eigen::VectorXd& factors, Row_block& y)
{
  y.resize(x.rows(), block_width);
  run_kernel<Multiply_rows>(x.data(), factors.data(), x.rows(), y.data());
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_KERNELS_H
