// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors
#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_X86_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_X86_KERNELS_H

#include <cstddef>

// Products of blocks with eight numbers of type double in every row, or column, for processors with
// AVX2 and FMA, and for those with AVX-512, where such a row is one register. They take half and a
// quarter of the time of what compilers make for any 64-bit processor of this kind.
//
// Compilers of the GNU family compile single functions for instructions that not all processors
// have, and tell whether the one at hand has them.
#if defined(__GNUC__) && defined(__x86_64__)
#define CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
#include <immintrin.h>
#endif

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS

namespace avx2 {

// `c += v^T w`, c with eight rows
__attribute__((target("avx2,fma"))) inline void
add_transposed_product(const double* v, const double* w, std::ptrdiff_t rows, double* c)
{
  for (int i = 0; i < 8; i += 4, v += 4, c += 32) {
    __m256d s00 = _mm256_loadu_pd(c), s01 = _mm256_loadu_pd(c + 4);
    __m256d s10 = _mm256_loadu_pd(c + 8), s11 = _mm256_loadu_pd(c + 12);
    __m256d s20 = _mm256_loadu_pd(c + 16), s21 = _mm256_loadu_pd(c + 20);
    __m256d s30 = _mm256_loadu_pd(c + 24), s31 = _mm256_loadu_pd(c + 28);
    for (std::ptrdiff_t row = 0; row < 8 * rows; row += 8) {
      const __m256d x0 = _mm256_loadu_pd(w + row), x1 = _mm256_loadu_pd(w + row + 4);
      const __m256d v0 = _mm256_broadcast_sd(v + row), v1 = _mm256_broadcast_sd(v + row + 1);
      s00 = _mm256_fmadd_pd(v0, x0, s00);
      s01 = _mm256_fmadd_pd(v0, x1, s01);
      s10 = _mm256_fmadd_pd(v1, x0, s10);
      s11 = _mm256_fmadd_pd(v1, x1, s11);
      const __m256d v2 = _mm256_broadcast_sd(v + row + 2), v3 = _mm256_broadcast_sd(v + row + 3);
      s20 = _mm256_fmadd_pd(v2, x0, s20);
      s21 = _mm256_fmadd_pd(v2, x1, s21);
      s30 = _mm256_fmadd_pd(v3, x0, s30);
      s31 = _mm256_fmadd_pd(v3, x1, s31);
    }
    _mm256_storeu_pd(c, s00);
    _mm256_storeu_pd(c + 4, s01);
    _mm256_storeu_pd(c + 8, s10);
    _mm256_storeu_pd(c + 12, s11);
    _mm256_storeu_pd(c + 16, s20);
    _mm256_storeu_pd(c + 20, s21);
    _mm256_storeu_pd(c + 24, s30);
    _mm256_storeu_pd(c + 28, s31);
  }
}

// `y -= v c` for the rows from `row` on that make a multiple of four, c with eight rows; returns
// the first row left out.
__attribute__((target("avx2,fma"))) inline std::ptrdiff_t
subtract_product(double* y, const double* v, std::ptrdiff_t rows, const double* c)
{
  std::ptrdiff_t row = 0;
  for (; row + 4 <= rows; row += 4, y += 32, v += 32) {
    __m256d s00 = _mm256_loadu_pd(y), s01 = _mm256_loadu_pd(y + 4);
    __m256d s10 = _mm256_loadu_pd(y + 8), s11 = _mm256_loadu_pd(y + 12);
    __m256d s20 = _mm256_loadu_pd(y + 16), s21 = _mm256_loadu_pd(y + 20);
    __m256d s30 = _mm256_loadu_pd(y + 24), s31 = _mm256_loadu_pd(y + 28);
    for (int k = 0; k < 8; ++k) {
      const __m256d x0 = _mm256_loadu_pd(c + 8 * k), x1 = _mm256_loadu_pd(c + 8 * k + 4);
      const __m256d v0 = _mm256_broadcast_sd(v + k), v1 = _mm256_broadcast_sd(v + 8 + k);
      s00 = _mm256_fnmadd_pd(v0, x0, s00);
      s01 = _mm256_fnmadd_pd(v0, x1, s01);
      s10 = _mm256_fnmadd_pd(v1, x0, s10);
      s11 = _mm256_fnmadd_pd(v1, x1, s11);
      const __m256d v2 = _mm256_broadcast_sd(v + 16 + k), v3 = _mm256_broadcast_sd(v + 24 + k);
      s20 = _mm256_fnmadd_pd(v2, x0, s20);
      s21 = _mm256_fnmadd_pd(v2, x1, s21);
      s30 = _mm256_fnmadd_pd(v3, x0, s30);
      s31 = _mm256_fnmadd_pd(v3, x1, s31);
    }
    _mm256_storeu_pd(y, s00);
    _mm256_storeu_pd(y + 4, s01);
    _mm256_storeu_pd(y + 8, s10);
    _mm256_storeu_pd(y + 12, s11);
    _mm256_storeu_pd(y + 16, s20);
    _mm256_storeu_pd(y + 20, s21);
    _mm256_storeu_pd(y + 24, s30);
    _mm256_storeu_pd(y + 28, s31);
  }
  return row;
}

// Both for two blocks, one after the other: there are not enough registers for more.
inline void add_transposed_products(
    const double* v, const double* w, const double* x, std::ptrdiff_t rows, double* c, double* d)
{
  add_transposed_product(v, w, rows, c);
  add_transposed_product(v, x, rows, d);
}

inline std::ptrdiff_t subtract_products(
    double* y, double* z, const double* v, std::ptrdiff_t rows, const double* c, const double* d)
{
  subtract_product(y, v, rows, c);
  return subtract_product(z, v, rows, d);
}

// `y -= l x` for `columns` columns of l, `stride` apart, and as many rows of x
template <int columns>
__attribute__((target("avx2,fma"))) void subtract_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* x, double* y)
{
  __m256d x_rows[2 * columns];
#pragma GCC unroll 8
  for (int k = 0; k < 2 * columns; ++k)
    x_rows[k] = _mm256_loadu_pd(x + 4 * k);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    __m256d s0 = _mm256_loadu_pd(y), s1 = _mm256_loadu_pd(y + 4);
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k) {
      const __m256d l_k = _mm256_broadcast_sd(l + k * stride);
      s0 = _mm256_fnmadd_pd(l_k, x_rows[2 * k], s0);
      s1 = _mm256_fnmadd_pd(l_k, x_rows[2 * k + 1], s1);
    }
    _mm256_storeu_pd(y, s0);
    _mm256_storeu_pd(y + 4, s1);
  }
}

// `x -= l^T y` for `columns` columns of l, `stride` apart, and as many rows of x
template <int columns>
__attribute__((target("avx2,fma"))) void subtract_transposed_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* y, double* x)
{
  __m256d s[2 * columns];
#pragma GCC unroll 8
  for (int k = 0; k < 2 * columns; ++k)
    s[k] = _mm256_loadu_pd(x + 4 * k);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    const __m256d y0 = _mm256_loadu_pd(y), y1 = _mm256_loadu_pd(y + 4);
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k) {
      const __m256d l_k = _mm256_broadcast_sd(l + k * stride);
      s[2 * k] = _mm256_fnmadd_pd(l_k, y0, s[2 * k]);
      s[2 * k + 1] = _mm256_fnmadd_pd(l_k, y1, s[2 * k + 1]);
    }
  }
#pragma GCC unroll 8
  for (int k = 0; k < 2 * columns; ++k)
    _mm256_storeu_pd(x + 4 * k, s[k]);
}

// Both substitutions for `columns` columns of a panel of a triangular factor, `stride` apart, the
// first of which begins on the diagonal at l. The triangle has `inside` rows below those columns,
// and there are `below` rows below the triangle. x are the rows of the right-hand sides from the
// first of the columns on, y those below the triangle.
template <int columns>
__attribute__((target("avx2,fma"))) void substitute_forward(const double* l,
                                                            std::ptrdiff_t stride,
                                                            std::ptrdiff_t inside,
                                                            std::ptrdiff_t below,
                                                            double* x,
                                                            double* y)
{
  for (int half = 0; half < 8; half += 4) {
    __m256d r[columns];
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k)
      r[k] = _mm256_loadu_pd(x + 8 * k + half);
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k) {
      r[k] = _mm256_mul_pd(r[k], _mm256_set1_pd(1 / l[k + k * stride]));
#pragma GCC unroll 4
      for (int i = k + 1; i < columns; ++i)
        r[i] = _mm256_fnmadd_pd(_mm256_set1_pd(l[i + k * stride]), r[k], r[i]);
      _mm256_storeu_pd(x + 8 * k + half, r[k]);
    }
  }
  subtract_columns<columns>(l + columns, stride, inside, x, x + 8 * columns);
  subtract_columns<columns>(l + columns + inside, stride, below, x, y);
}

template <int columns>
__attribute__((target("avx2,fma"))) void substitute_backward(const double* l,
                                                             std::ptrdiff_t stride,
                                                             std::ptrdiff_t inside,
                                                             std::ptrdiff_t below,
                                                             double* x,
                                                             const double* y)
{
  subtract_transposed_columns<columns>(l + columns + inside, stride, below, y, x);
  subtract_transposed_columns<columns>(l + columns, stride, inside, x + 8 * columns, x);
  for (int half = 0; half < 8; half += 4) {
    __m256d r[columns];
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k)
      r[k] = _mm256_loadu_pd(x + 8 * k + half);
#pragma GCC unroll 4
    for (int k = columns - 1; k >= 0; --k) {
      r[k] = _mm256_mul_pd(r[k], _mm256_set1_pd(1 / l[k + k * stride]));
#pragma GCC unroll 4
      for (int i = 0; i < k; ++i)
        r[i] = _mm256_fnmadd_pd(_mm256_set1_pd(l[k + i * stride]), r[k], r[i]);
      _mm256_storeu_pd(x + 8 * k + half, r[k]);
    }
  }
}

// `c -= a b^T` for a tile of 16 x 8 entries of c, whose columns are `stride` apart, where the
// columns of a and b follow each other.
__attribute__((target("avx2,fma"))) inline void subtract_tile(
    const double* a, const double* b, std::ptrdiff_t depth, double* c, std::ptrdiff_t stride)
{
  for (int j = 0; j < 8; j += 4) {
    for (int i = 0; i < 16; i += 8) {
      double* const to = c + i + j * stride;
      __m256d s[8];
#pragma GCC unroll 4
      for (int q = 0; q < 4; ++q) {
        s[2 * q] = _mm256_loadu_pd(to + q * stride);
        s[2 * q + 1] = _mm256_loadu_pd(to + q * stride + 4);
      }
      const double *a_k = a + i, *b_k = b + j;
      for (std::ptrdiff_t k = 0; k < depth; ++k, a_k += 16, b_k += 8) {
        const __m256d a_0 = _mm256_loadu_pd(a_k), a_1 = _mm256_loadu_pd(a_k + 4);
#pragma GCC unroll 4
        for (int q = 0; q < 4; ++q) {
          const __m256d b_q = _mm256_broadcast_sd(b_k + q);
          s[2 * q] = _mm256_fnmadd_pd(a_0, b_q, s[2 * q]);
          s[2 * q + 1] = _mm256_fnmadd_pd(a_1, b_q, s[2 * q + 1]);
        }
      }
#pragma GCC unroll 4
      for (int q = 0; q < 4; ++q) {
        _mm256_storeu_pd(to + q * stride, s[2 * q]);
        _mm256_storeu_pd(to + q * stride + 4, s[2 * q + 1]);
      }
    }
  }
}

} // namespace avx2

namespace avx512 {

// How far ahead of the work to ask for what comes from the memory. The processor's own prediction
// begins anew with every block of the basis.
constexpr std::ptrdiff_t rows_ahead = 32;

// `c += v^T w`, c with eight rows
__attribute__((target("avx512f"))) inline void
add_transposed_product(const double* v, const double* w, std::ptrdiff_t rows, double* c)
{
  __m512d s0 = _mm512_loadu_pd(c), s1 = _mm512_loadu_pd(c + 8), s2 = _mm512_loadu_pd(c + 16),
          s3 = _mm512_loadu_pd(c + 24), s4 = _mm512_loadu_pd(c + 32), s5 = _mm512_loadu_pd(c + 40),
          s6 = _mm512_loadu_pd(c + 48), s7 = _mm512_loadu_pd(c + 56);
  for (std::ptrdiff_t row = 0; row < rows; ++row, v += 8, w += 8) {
    const __m512d x = _mm512_loadu_pd(w);
    s0 = _mm512_fmadd_pd(_mm512_set1_pd(v[0]), x, s0);
    s1 = _mm512_fmadd_pd(_mm512_set1_pd(v[1]), x, s1);
    s2 = _mm512_fmadd_pd(_mm512_set1_pd(v[2]), x, s2);
    s3 = _mm512_fmadd_pd(_mm512_set1_pd(v[3]), x, s3);
    s4 = _mm512_fmadd_pd(_mm512_set1_pd(v[4]), x, s4);
    s5 = _mm512_fmadd_pd(_mm512_set1_pd(v[5]), x, s5);
    s6 = _mm512_fmadd_pd(_mm512_set1_pd(v[6]), x, s6);
    s7 = _mm512_fmadd_pd(_mm512_set1_pd(v[7]), x, s7);
  }
  _mm512_storeu_pd(c, s0);
  _mm512_storeu_pd(c + 8, s1);
  _mm512_storeu_pd(c + 16, s2);
  _mm512_storeu_pd(c + 24, s3);
  _mm512_storeu_pd(c + 32, s4);
  _mm512_storeu_pd(c + 40, s5);
  _mm512_storeu_pd(c + 48, s6);
  _mm512_storeu_pd(c + 56, s7);
}

// `y -= v c` for the rows from `row` on that make a multiple of eight, c with eight rows; returns
// the first row left out.
__attribute__((target("avx512f"))) inline std::ptrdiff_t
subtract_product(double* y, const double* v, std::ptrdiff_t rows, const double* c)
{
  std::ptrdiff_t row = 0;
  for (; row + 8 <= rows; row += 8, y += 64, v += 64) {
    __m512d s0 = _mm512_loadu_pd(y), s1 = _mm512_loadu_pd(y + 8), s2 = _mm512_loadu_pd(y + 16),
            s3 = _mm512_loadu_pd(y + 24), s4 = _mm512_loadu_pd(y + 32),
            s5 = _mm512_loadu_pd(y + 40), s6 = _mm512_loadu_pd(y + 48),
            s7 = _mm512_loadu_pd(y + 56);
    for (int k = 0; k < 8; ++k) {
      const __m512d x = _mm512_loadu_pd(c + 8 * k);
      s0 = _mm512_fnmadd_pd(_mm512_set1_pd(v[k]), x, s0);
      s1 = _mm512_fnmadd_pd(_mm512_set1_pd(v[8 + k]), x, s1);
      s2 = _mm512_fnmadd_pd(_mm512_set1_pd(v[16 + k]), x, s2);
      s3 = _mm512_fnmadd_pd(_mm512_set1_pd(v[24 + k]), x, s3);
      s4 = _mm512_fnmadd_pd(_mm512_set1_pd(v[32 + k]), x, s4);
      s5 = _mm512_fnmadd_pd(_mm512_set1_pd(v[40 + k]), x, s5);
      s6 = _mm512_fnmadd_pd(_mm512_set1_pd(v[48 + k]), x, s6);
      s7 = _mm512_fnmadd_pd(_mm512_set1_pd(v[56 + k]), x, s7);
    }
    _mm512_storeu_pd(y, s0);
    _mm512_storeu_pd(y + 8, s1);
    _mm512_storeu_pd(y + 16, s2);
    _mm512_storeu_pd(y + 24, s3);
    _mm512_storeu_pd(y + 32, s4);
    _mm512_storeu_pd(y + 40, s5);
    _mm512_storeu_pd(y + 48, s6);
    _mm512_storeu_pd(y + 56, s7);
  }
  return row;
}

// `c += v^T w` and `d += v^T x`, which reads v once.
__attribute__((target("avx512f"))) inline void add_transposed_products(
    const double* v, const double* w, const double* x, std::ptrdiff_t rows, double* c, double* d)
{
  __m512d s[8], t[8];
#pragma GCC unroll 8
  for (int k = 0; k < 8; ++k) {
    s[k] = _mm512_loadu_pd(c + 8 * k);
    t[k] = _mm512_loadu_pd(d + 8 * k);
  }
  for (std::ptrdiff_t row = 0; row < rows; ++row, v += 8, w += 8, x += 8) {
    _mm_prefetch(v + rows_ahead * 8, _MM_HINT_T0);
    const __m512d w_row = _mm512_loadu_pd(w), x_row = _mm512_loadu_pd(x);
#pragma GCC unroll 8
    for (int k = 0; k < 8; ++k) {
      const __m512d v_k = _mm512_set1_pd(v[k]);
      s[k] = _mm512_fmadd_pd(v_k, w_row, s[k]);
      t[k] = _mm512_fmadd_pd(v_k, x_row, t[k]);
    }
  }
#pragma GCC unroll 8
  for (int k = 0; k < 8; ++k) {
    _mm512_storeu_pd(c + 8 * k, s[k]);
    _mm512_storeu_pd(d + 8 * k, t[k]);
  }
}

// `y -= v c` and `z -= v d` for the rows that make a multiple of four; returns the first row left
// out.
__attribute__((target("avx512f"))) inline std::ptrdiff_t subtract_products(
    double* y, double* z, const double* v, std::ptrdiff_t rows, const double* c, const double* d)
{
  __m512d c_rows[8], d_rows[8];
#pragma GCC unroll 8
  for (int k = 0; k < 8; ++k) {
    c_rows[k] = _mm512_loadu_pd(c + 8 * k);
    d_rows[k] = _mm512_loadu_pd(d + 8 * k);
  }
  std::ptrdiff_t row = 0;
  for (; row + 4 <= rows; row += 4, v += 32, y += 32, z += 32) {
    __m512d s[4], t[4];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      _mm_prefetch(v + (rows_ahead + i) * 8, _MM_HINT_T0);
      s[i] = _mm512_loadu_pd(y + 8 * i);
      t[i] = _mm512_loadu_pd(z + 8 * i);
    }
#pragma GCC unroll 8
    for (int k = 0; k < 8; ++k) {
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) {
        const __m512d v_ik = _mm512_set1_pd(v[8 * i + k]);
        s[i] = _mm512_fnmadd_pd(v_ik, c_rows[k], s[i]);
        t[i] = _mm512_fnmadd_pd(v_ik, d_rows[k], t[i]);
      }
    }
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      _mm512_storeu_pd(y + 8 * i, s[i]);
      _mm512_storeu_pd(z + 8 * i, t[i]);
    }
  }
  return row;
}

// `y -= l x` for `columns` columns of l, `stride` apart, and as many rows of x
template <int columns>
__attribute__((target("avx512f"))) void subtract_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* x, double* y)
{
  __m512d x_rows[columns];
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k)
    x_rows[k] = _mm512_loadu_pd(x + 8 * k);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    __m512d s = _mm512_loadu_pd(y);
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k)
      s = _mm512_fnmadd_pd(_mm512_set1_pd(l[k * stride]), x_rows[k], s);
    _mm512_storeu_pd(y, s);
  }
}

// `x -= l^T y` for `columns` columns of l, `stride` apart, and as many rows of x
template <int columns>
__attribute__((target("avx512f"))) void subtract_transposed_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* y, double* x)
{
  __m512d s[columns];
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k)
    s[k] = _mm512_loadu_pd(x + 8 * k);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    const __m512d row = _mm512_loadu_pd(y);
#pragma GCC unroll 4
    for (int k = 0; k < columns; ++k)
      s[k] = _mm512_fnmadd_pd(_mm512_set1_pd(l[k * stride]), row, s[k]);
  }
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k)
    _mm512_storeu_pd(x + 8 * k, s[k]);
}

// Both substitutions for `columns` columns of a panel of a triangular factor, as above.
template <int columns>
__attribute__((target("avx512f"))) void substitute_forward(const double* l,
                                                           std::ptrdiff_t stride,
                                                           std::ptrdiff_t inside,
                                                           std::ptrdiff_t below,
                                                           double* x,
                                                           double* y)
{
  __m512d r[columns];
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k)
    r[k] = _mm512_loadu_pd(x + 8 * k);
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k) {
    r[k] = _mm512_mul_pd(r[k], _mm512_set1_pd(1 / l[k + k * stride]));
#pragma GCC unroll 4
    for (int i = k + 1; i < columns; ++i)
      r[i] = _mm512_fnmadd_pd(_mm512_set1_pd(l[i + k * stride]), r[k], r[i]);
    _mm512_storeu_pd(x + 8 * k, r[k]);
  }
  subtract_columns<columns>(l + columns, stride, inside, x, x + 8 * columns);
  subtract_columns<columns>(l + columns + inside, stride, below, x, y);
}

template <int columns>
__attribute__((target("avx512f"))) void substitute_backward(const double* l,
                                                            std::ptrdiff_t stride,
                                                            std::ptrdiff_t inside,
                                                            std::ptrdiff_t below,
                                                            double* x,
                                                            const double* y)
{
  subtract_transposed_columns<columns>(l + columns + inside, stride, below, y, x);
  subtract_transposed_columns<columns>(l + columns, stride, inside, x + 8 * columns, x);
  __m512d r[columns];
#pragma GCC unroll 4
  for (int k = 0; k < columns; ++k)
    r[k] = _mm512_loadu_pd(x + 8 * k);
#pragma GCC unroll 4
  for (int k = columns - 1; k >= 0; --k) {
    r[k] = _mm512_mul_pd(r[k], _mm512_set1_pd(1 / l[k + k * stride]));
#pragma GCC unroll 4
    for (int i = 0; i < k; ++i)
      r[i] = _mm512_fnmadd_pd(_mm512_set1_pd(l[k + i * stride]), r[k], r[i]);
    _mm512_storeu_pd(x + 8 * k, r[k]);
  }
}

// `c -= a b^T` for a tile of 16 x 8 entries of c, whose columns are `stride` apart, where the
// columns of a and b follow each other.
__attribute__((target("avx512f"))) inline void subtract_tile(
    const double* a, const double* b, std::ptrdiff_t depth, double* c, std::ptrdiff_t stride)
{
  __m512d s[16];
#pragma GCC unroll 8
  for (int j = 0; j < 8; ++j) {
    s[2 * j] = _mm512_loadu_pd(c + j * stride);
    s[2 * j + 1] = _mm512_loadu_pd(c + j * stride + 8);
  }
  for (std::ptrdiff_t k = 0; k < depth; ++k, a += 16, b += 8) {
    const __m512d a_0 = _mm512_loadu_pd(a), a_1 = _mm512_loadu_pd(a + 8);
#pragma GCC unroll 8
    for (int j = 0; j < 8; ++j) {
      const __m512d b_j = _mm512_set1_pd(b[j]);
      s[2 * j] = _mm512_fnmadd_pd(a_0, b_j, s[2 * j]);
      s[2 * j + 1] = _mm512_fnmadd_pd(a_1, b_j, s[2 * j + 1]);
    }
  }
#pragma GCC unroll 8
  for (int j = 0; j < 8; ++j) {
    _mm512_storeu_pd(c + j * stride, s[2 * j]);
    _mm512_storeu_pd(c + j * stride + 8, s[2 * j + 1]);
  }
}

} // namespace avx512

// The best of both that the processor has, if it has one.
namespace x86 {

inline bool has_avx512()
{
  static const bool result = __builtin_cpu_supports("avx512f");
  return result;
}

inline bool has_avx2()
{
  static const bool result = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return result;
}

inline bool has_kernels()
{
  return has_avx512() || has_avx2();
}

inline void add_transposed_product(const double* v, const double* w, std::ptrdiff_t rows, double* c)
{
  (has_avx512() ? avx512::add_transposed_product : avx2::add_transposed_product)(v, w, rows, c);
}

inline std::ptrdiff_t
subtract_product(double* y, const double* v, std::ptrdiff_t rows, const double* c)
{
  return (has_avx512() ? avx512::subtract_product : avx2::subtract_product)(y, v, rows, c);
}

inline void add_transposed_products(
    const double* v, const double* w, const double* x, std::ptrdiff_t rows, double* c, double* d)
{
  (has_avx512() ? avx512::add_transposed_products
                : avx2::add_transposed_products)(v, w, x, rows, c, d);
}

inline std::ptrdiff_t subtract_products(
    double* y, double* z, const double* v, std::ptrdiff_t rows, const double* c, const double* d)
{
  return (has_avx512() ? avx512::subtract_products : avx2::subtract_products)(y, z, v, rows, c, d);
}

template <int columns>
void substitute_forward(const double* l,
                        std::ptrdiff_t stride,
                        std::ptrdiff_t inside,
                        std::ptrdiff_t below,
                        double* x,
                        double* y)
{
  (has_avx512() ? avx512::substitute_forward<columns>
                : avx2::substitute_forward<columns>)(l, stride, inside, below, x, y);
}

template <int columns>
void substitute_backward(const double* l,
                         std::ptrdiff_t stride,
                         std::ptrdiff_t inside,
                         std::ptrdiff_t below,
                         double* x,
                         const double* y)
{
  (has_avx512() ? avx512::substitute_backward<columns>
                : avx2::substitute_backward<columns>)(l, stride, inside, below, x, y);
}

constexpr std::ptrdiff_t tile_rows = 16, tile_columns = 8;

inline void subtract_tile(
    const double* a, const double* b, std::ptrdiff_t depth, double* c, std::ptrdiff_t stride)
{
  (has_avx512() ? avx512::subtract_tile : avx2::subtract_tile)(a, b, depth, c, stride);
}

} // namespace x86

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_X86_KERNELS_H
