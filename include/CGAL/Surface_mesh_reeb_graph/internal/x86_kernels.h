// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors
#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_X86_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_X86_KERNELS_H

#include <cstddef>

// Products of blocks with eight numbers of type double in every row, for processors with AVX2 and FMA, and for those
// with AVX-512, where such a row is one register. They take half and a quarter of the time of what compilers make for
// any 64-bit processor of this kind.
//
// Compilers of the GNU family compile single functions for instructions that not all processors have, and tell whether
// the one at hand has them.
#if defined(__GNUC__) && defined(__x86_64__)
#define CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
#include <immintrin.h>
#endif

namespace CGAL {
namespace Surface_mesh_reeb_graph {
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

// `y -= v c` for the rows from `row` on that make a multiple of four, c with eight rows; returns the first row left
// out.
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

// `y -= l x` for four columns of l, `stride` apart, and four rows of x
__attribute__((target("avx2,fma"))) inline void subtract_four_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* x, double* y)
{
  const __m256d x00 = _mm256_loadu_pd(x), x01 = _mm256_loadu_pd(x + 4);
  const __m256d x10 = _mm256_loadu_pd(x + 8), x11 = _mm256_loadu_pd(x + 12);
  const __m256d x20 = _mm256_loadu_pd(x + 16), x21 = _mm256_loadu_pd(x + 20);
  const __m256d x30 = _mm256_loadu_pd(x + 24), x31 = _mm256_loadu_pd(x + 28);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    __m256d s0 = _mm256_loadu_pd(y), s1 = _mm256_loadu_pd(y + 4);
    const __m256d l0 = _mm256_broadcast_sd(l), l1 = _mm256_broadcast_sd(l + stride);
    s0 = _mm256_fnmadd_pd(l0, x00, s0);
    s1 = _mm256_fnmadd_pd(l0, x01, s1);
    s0 = _mm256_fnmadd_pd(l1, x10, s0);
    s1 = _mm256_fnmadd_pd(l1, x11, s1);
    const __m256d l2 = _mm256_broadcast_sd(l + 2 * stride),
                  l3 = _mm256_broadcast_sd(l + 3 * stride);
    s0 = _mm256_fnmadd_pd(l2, x20, s0);
    s1 = _mm256_fnmadd_pd(l2, x21, s1);
    s0 = _mm256_fnmadd_pd(l3, x30, s0);
    s1 = _mm256_fnmadd_pd(l3, x31, s1);
    _mm256_storeu_pd(y, s0);
    _mm256_storeu_pd(y + 4, s1);
  }
}

// `x -= l^T y` for four columns of l, `stride` apart, and four rows of x
__attribute__((target("avx2,fma"))) inline void subtract_four_transposed_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* y, double* x)
{
  __m256d s00 = _mm256_loadu_pd(x), s01 = _mm256_loadu_pd(x + 4);
  __m256d s10 = _mm256_loadu_pd(x + 8), s11 = _mm256_loadu_pd(x + 12);
  __m256d s20 = _mm256_loadu_pd(x + 16), s21 = _mm256_loadu_pd(x + 20);
  __m256d s30 = _mm256_loadu_pd(x + 24), s31 = _mm256_loadu_pd(x + 28);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    const __m256d y0 = _mm256_loadu_pd(y), y1 = _mm256_loadu_pd(y + 4);
    const __m256d l0 = _mm256_broadcast_sd(l), l1 = _mm256_broadcast_sd(l + stride);
    s00 = _mm256_fnmadd_pd(l0, y0, s00);
    s01 = _mm256_fnmadd_pd(l0, y1, s01);
    s10 = _mm256_fnmadd_pd(l1, y0, s10);
    s11 = _mm256_fnmadd_pd(l1, y1, s11);
    const __m256d l2 = _mm256_broadcast_sd(l + 2 * stride),
                  l3 = _mm256_broadcast_sd(l + 3 * stride);
    s20 = _mm256_fnmadd_pd(l2, y0, s20);
    s21 = _mm256_fnmadd_pd(l2, y1, s21);
    s30 = _mm256_fnmadd_pd(l3, y0, s30);
    s31 = _mm256_fnmadd_pd(l3, y1, s31);
  }
  _mm256_storeu_pd(x, s00);
  _mm256_storeu_pd(x + 4, s01);
  _mm256_storeu_pd(x + 8, s10);
  _mm256_storeu_pd(x + 12, s11);
  _mm256_storeu_pd(x + 16, s20);
  _mm256_storeu_pd(x + 20, s21);
  _mm256_storeu_pd(x + 24, s30);
  _mm256_storeu_pd(x + 28, s31);
}

} // namespace avx2

namespace avx512 {

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

// `y -= v c` for the rows from `row` on that make a multiple of eight, c with eight rows; returns the first row left
// out.
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

// `y -= l x` for four columns of l, `stride` apart, and four rows of x
__attribute__((target("avx512f"))) inline void subtract_four_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* x, double* y)
{
  const __m512d x0 = _mm512_loadu_pd(x), x1 = _mm512_loadu_pd(x + 8), x2 = _mm512_loadu_pd(x + 16),
                x3 = _mm512_loadu_pd(x + 24);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    __m512d s = _mm512_fnmadd_pd(_mm512_set1_pd(l[0]), x0, _mm512_loadu_pd(y));
    s = _mm512_fnmadd_pd(_mm512_set1_pd(l[stride]), x1, s);
    s = _mm512_fnmadd_pd(_mm512_set1_pd(l[2 * stride]), x2, s);
    s = _mm512_fnmadd_pd(_mm512_set1_pd(l[3 * stride]), x3, s);
    _mm512_storeu_pd(y, s);
  }
}

// `x -= l^T y` for four columns of l, `stride` apart, and four rows of x
__attribute__((target("avx512f"))) inline void subtract_four_transposed_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* y, double* x)
{
  __m512d s0 = _mm512_loadu_pd(x), s1 = _mm512_loadu_pd(x + 8), s2 = _mm512_loadu_pd(x + 16),
          s3 = _mm512_loadu_pd(x + 24);
  for (std::ptrdiff_t i = 0; i < rows; ++i, ++l, y += 8) {
    const __m512d row = _mm512_loadu_pd(y);
    s0 = _mm512_fnmadd_pd(_mm512_set1_pd(l[0]), row, s0);
    s1 = _mm512_fnmadd_pd(_mm512_set1_pd(l[stride]), row, s1);
    s2 = _mm512_fnmadd_pd(_mm512_set1_pd(l[2 * stride]), row, s2);
    s3 = _mm512_fnmadd_pd(_mm512_set1_pd(l[3 * stride]), row, s3);
  }
  _mm512_storeu_pd(x, s0);
  _mm512_storeu_pd(x + 8, s1);
  _mm512_storeu_pd(x + 16, s2);
  _mm512_storeu_pd(x + 24, s3);
}

} // namespace avx512

// The best of both that the processor has, if it has one.
namespace x86 {

inline bool has_avx512()
{
  static const bool result = __builtin_cpu_supports("avx512f");
  return result;
}

inline bool has_kernels()
{
  static const bool result =
      has_avx512() || (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
  return result;
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

inline void subtract_four_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* x, double* y)
{
  (has_avx512() ? avx512::subtract_four_columns
                : avx2::subtract_four_columns)(l, stride, rows, x, y);
}

inline void subtract_four_transposed_columns(
    const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, const double* y, double* x)
{
  (has_avx512() ? avx512::subtract_four_transposed_columns
                : avx2::subtract_four_transposed_columns)(l, stride, rows, y, x);
}

} // namespace x86

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_X86_KERNELS_H
