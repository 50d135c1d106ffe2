// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors
#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_X86_DISTANCE_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_X86_DISTANCE_KERNELS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/x86_kernels.h>

#include <cstddef>

// Sums over the columns of a matrix, for processors with AVX2 and FMA; see x86_kernels.h. They wait
// for the memory or for the cache: longer registers gain nothing.

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS

namespace avx2 {

// Some columns of a matrix, a factor for each, and a point.
template <class Number>
struct Columns
{
  static constexpr int number = 8;
  const Number* begin[number];
  double factors[number], point[number];
};

// Four points, by coordinates, and the squares of their norms.
struct Sources
{
  static constexpr std::ptrdiff_t rows = 120; // of the blocks that they are multiplied with
  std::ptrdiff_t dimension;
  const double* coordinates;
  const double* squared_norms;
};

// `add_squares()` adds to the sum of every row the squares of its differences to the point,
// multiplied with the factors, and returns the first row left out. `take_largest_sums()` raises the
// entry of every row `x` of a block to the largest of the four sums of squared norm and scalar
// product.

__attribute__((target("avx2,fma"))) inline __m256d load(const double* x)
{
  return _mm256_loadu_pd(x);
}

__attribute__((target("avx2,fma"))) inline __m256d load(const float* x)
{
  return _mm256_cvtps_pd(_mm_loadu_ps(x));
}

template <class Number>
__attribute__((target("avx2,fma"))) inline std::ptrdiff_t
add_squares(const Columns<Number>& columns, std::ptrdiff_t rows, double* sums)
{
  const __m256d p0 = _mm256_set1_pd(columns.point[0]), p1 = _mm256_set1_pd(columns.point[1]),
                p2 = _mm256_set1_pd(columns.point[2]), p3 = _mm256_set1_pd(columns.point[3]);
  const __m256d p4 = _mm256_set1_pd(columns.point[4]), p5 = _mm256_set1_pd(columns.point[5]),
                p6 = _mm256_set1_pd(columns.point[6]), p7 = _mm256_set1_pd(columns.point[7]);
  const __m256d f0 = _mm256_set1_pd(columns.factors[0]), f1 = _mm256_set1_pd(columns.factors[1]),
                f2 = _mm256_set1_pd(columns.factors[2]), f3 = _mm256_set1_pd(columns.factors[3]);
  const __m256d f4 = _mm256_set1_pd(columns.factors[4]), f5 = _mm256_set1_pd(columns.factors[5]),
                f6 = _mm256_set1_pd(columns.factors[6]), f7 = _mm256_set1_pd(columns.factors[7]);
  std::ptrdiff_t row = 0;
  for (; row + 4 <= rows; row += 4) {
    __m256d sum = load(sums + row), other_sum = _mm256_setzero_pd();
    const __m256d d0 = _mm256_mul_pd(f0, _mm256_sub_pd(load(columns.begin[0] + row), p0));
    sum = _mm256_fmadd_pd(d0, d0, sum);
    const __m256d d1 = _mm256_mul_pd(f1, _mm256_sub_pd(load(columns.begin[1] + row), p1));
    other_sum = _mm256_fmadd_pd(d1, d1, other_sum);
    const __m256d d2 = _mm256_mul_pd(f2, _mm256_sub_pd(load(columns.begin[2] + row), p2));
    sum = _mm256_fmadd_pd(d2, d2, sum);
    const __m256d d3 = _mm256_mul_pd(f3, _mm256_sub_pd(load(columns.begin[3] + row), p3));
    other_sum = _mm256_fmadd_pd(d3, d3, other_sum);
    const __m256d d4 = _mm256_mul_pd(f4, _mm256_sub_pd(load(columns.begin[4] + row), p4));
    sum = _mm256_fmadd_pd(d4, d4, sum);
    const __m256d d5 = _mm256_mul_pd(f5, _mm256_sub_pd(load(columns.begin[5] + row), p5));
    other_sum = _mm256_fmadd_pd(d5, d5, other_sum);
    const __m256d d6 = _mm256_mul_pd(f6, _mm256_sub_pd(load(columns.begin[6] + row), p6));
    sum = _mm256_fmadd_pd(d6, d6, sum);
    const __m256d d7 = _mm256_mul_pd(f7, _mm256_sub_pd(load(columns.begin[7] + row), p7));
    other_sum = _mm256_fmadd_pd(d7, d7, other_sum);
    _mm256_storeu_pd(sums + row, _mm256_add_pd(sum, other_sum));
  }
  return row;
}

__attribute__((target("avx2,fma"))) inline void
take_largest_sums(const Sources& sources, const double* x, double* largest)
{
  for (std::ptrdiff_t row = 0; row < Sources::rows; row += 12) {
    __m256d s[4][3];
    for (int j = 0; j < 4; ++j)
      s[j][0] = s[j][1] = s[j][2] = _mm256_set1_pd(sources.squared_norms[j]);
    for (std::ptrdiff_t i = 0; i < sources.dimension; ++i) {
      const double* const column = x + i * Sources::rows + row;
      const __m256d x0 = load(column), x1 = load(column + 4), x2 = load(column + 8);
      for (int j = 0; j < 4; ++j) {
        const __m256d y = _mm256_set1_pd(sources.coordinates[4 * i + j]);
        s[j][0] = _mm256_fmadd_pd(x0, y, s[j][0]);
        s[j][1] = _mm256_fmadd_pd(x1, y, s[j][1]);
        s[j][2] = _mm256_fmadd_pd(x2, y, s[j][2]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      double* const place = largest + row + 4 * k;
      const __m256d of_sources =
          _mm256_max_pd(_mm256_max_pd(s[0][k], s[1][k]), _mm256_max_pd(s[2][k], s[3][k]));
      _mm256_storeu_pd(place, _mm256_max_pd(load(place), of_sources));
    }
  }
}

} // namespace avx2

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_X86_DISTANCE_KERNELS_H
