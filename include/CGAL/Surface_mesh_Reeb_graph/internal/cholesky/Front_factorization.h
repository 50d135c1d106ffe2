// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_FRONT_FACTORIZATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_FRONT_FACTORIZATION_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Rank_update.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Register_vector.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Dense work on the fronts of a multifrontal Cholesky factorization. A front is a panel, the
// columns that are eliminated, by columns, and the lower triangle of the update that remains for
// the other rows. Most fronts of a surface mesh are so small that general products spend their time
// on preparations; blocks of 4 x 4 entries, which fit into registers, do better there.
template <class Scalar>
class Front_factorization
{
  using Index = Eigen::Index;
  static constexpr int block = 4;

public:
  // Replaces the `width` columns of `panel`, whose first `width` rows are symmetric and stored in
  // the lower triangle, by those of the Cholesky factor. Returns whether all pivots are positive
  // and finite.
  bool eliminate(Scalar* panel, const Index rows, const Index width)
  {
    CGAL_precondition(0 < width && width <= rows);
    constexpr Index block_width = 48;
    for (Index j = 0; j < width; j += block_width) {
      const Index end = (std::min)(j + block_width, width);
      if (j > 0)
        m_update.subtract(panel + j, rows, rows - j, end - j, j, panel + j + j * rows, rows);
      if (!eliminate_narrow(panel + j + j * rows, rows, rows - j, end - j))
        return false;
    }
    return true;
  }

  // Subtracts `B B^T` from the lower triangle of the square matrix `update` of order `below`, where
  // B is the last `below` rows of `panel`. What is above the diagonal is undefined afterwards.
  void subtract_square(
      const Scalar* panel, const Index rows, const Index width, Scalar* update, const Index below)
  {
    CGAL_precondition(0 < width && width + below <= rows);
    constexpr Index large_below = 48, large_width = 8;
    const Scalar* b = panel + (rows - below);
    if (below >= large_below && width >= large_width) {
      m_update.subtract(b, rows, below, below, width, update, below);
      return;
    }
    for (Index j = 0; j < below; j += block)
      with_columns(below - j, [&](auto c) {
        for_rows(j, below, [&](Index i, auto r) {
          subtract_product<r.value, c.value>(
              b + i, b + j, rows, width, update + i + j * below, below);
        });
      });
  }

private:
  template <int Size>
  struct Size_constant
  {
    static constexpr int value = Size;
  };

  // Calls `f` with the constant of min(size, 4).
  template <class Function>
  static void with_columns(const Index size, const Function& f)
  {
    switch (size) {
    case 1:
      f(Size_constant<1>());
      break;
    case 2:
      f(Size_constant<2>());
      break;
    case 3:
      f(Size_constant<3>());
      break;
    default:
      f(Size_constant<4>());
    }
  }

  // Calls `f` for four rows at a time, and for every one of the last ones. Tiles of two and three rows
  // would make small fronts a little faster, and compilers a second slower.
  template <class Function>
  static void for_rows(Index begin, const Index end, const Function& f)
  {
    for (; begin + block <= end; begin += block)
      f(begin, Size_constant<block>());
    for (; begin < end; ++begin)
      f(begin, Size_constant<1>());
  }

  // A block of up to 4 x 4 entries in registers.
  template <int Rows, int Columns>
  struct Tile
  {
    using Column = Register_vector<Scalar, Rows>;

    EIGEN_STRONG_INLINE Tile(const Scalar* a, const Index stride)
      : c0(Column::load(a))
      , c1(Column::load(a + (Columns > 1 ? stride : 0)))
      , c2(Column::load(a + (Columns > 2 ? 2 * stride : 0)))
      , c3(Column::load(a + (Columns > 3 ? 3 * stride : 0)))
    {}

    // Subtracts the product of `Rows` rows at `a` and the transposed `Columns` rows at `b`.
    EIGEN_STRONG_INLINE void
    subtract_product(const Scalar* a, const Scalar* b, const Index stride, const Index depth)
    {
      for (Index k = 0; k < depth; ++k, a += stride, b += stride) {
        const Column x = Column::load(a);
        c0.subtract(b[0], x);
        if constexpr (Columns > 1)
          c1.subtract(b[1], x);
        if constexpr (Columns > 2)
          c2.subtract(b[2], x);
        if constexpr (Columns > 3)
          c3.subtract(b[3], x);
      }
    }

    // Multiplies by the inverse of the transposed lower triangle at `d`, whose diagonal is inverted
    // in `inverse`.
    EIGEN_STRONG_INLINE void solve(const Scalar* d, const Index stride, const Scalar* inverse)
    {
      c0.multiply(inverse[0]);
      if constexpr (Columns > 1) {
        c1.subtract(d[1], c0);
        c1.multiply(inverse[1]);
      }
      if constexpr (Columns > 2) {
        c2.subtract(d[2], c0);
        c2.subtract(d[2 + stride], c1);
        c2.multiply(inverse[2]);
      }
      if constexpr (Columns > 3) {
        c3.subtract(d[3], c0);
        c3.subtract(d[3 + stride], c1);
        c3.subtract(d[3 + 2 * stride], c2);
        c3.multiply(inverse[3]);
      }
    }

    EIGEN_STRONG_INLINE void store(Scalar* a, const Index stride) const
    {
      c0.store(a);
      if constexpr (Columns > 1)
        c1.store(a + stride);
      if constexpr (Columns > 2)
        c2.store(a + 2 * stride);
      if constexpr (Columns > 3)
        c3.store(a + 3 * stride);
    }

    Column c0, c1, c2, c3;
  };

  template <int Rows, int Columns>
  static void subtract_product(const Scalar* a,
                               const Scalar* b,
                               const Index stride,
                               const Index depth,
                               Scalar* to,
                               const Index to_stride)
  {
    Tile<Rows, Columns> tile(to, to_stride);
    tile.subtract_product(a, b, stride, depth);
    tile.store(to, to_stride);
  }

  static bool
  eliminate_narrow(Scalar* panel, const Index stride, const Index rows, const Index width)
  {
    bool positive = true;
    for (Index j = 0; j < width && positive; j += block)
      with_columns(width - j, [&](auto c) {
        constexpr int columns = decltype(c)::value;
        Scalar* const diagonal = panel + j + j * stride;
        subtract_product<columns, columns>(panel + j, panel + j, stride, j, diagonal, stride);
        Scalar inverse[columns];
        positive = eliminate_block<columns>(diagonal, stride, inverse);
        if (positive)
          for_rows(j + columns, rows, [&](Index i, auto r) {
            eliminate_rows<decltype(r)::value, columns>(
                panel + i, panel + j, stride, j, diagonal, inverse);
          });
      });
    return positive;
  }

  template <int Columns>
  static bool eliminate_block(Scalar* a, const Index stride, Scalar* inverse)
  {
    for (Index j = 0; j < Columns; ++j) {
      Scalar pivot = a[j + j * stride];
      for (Index k = 0; k < j; ++k)
        pivot -= a[j + k * stride] * a[j + k * stride];
      if (!(pivot > 0) || !(std::isfinite)(pivot))
        return false;
      a[j + j * stride] = std::sqrt(pivot);
      inverse[j] = 1 / a[j + j * stride];
      for (Index i = j + 1; i < Columns; ++i) {
        Scalar sum = a[i + j * stride];
        for (Index k = 0; k < j; ++k)
          sum -= a[i + k * stride] * a[j + k * stride];
        a[i + j * stride] = sum * inverse[j];
      }
    }
    return true;
  }

  // The columns of L next to the first `depth` ones, in `Rows` rows at `a` below the diagonal block
  // `d`, which starts a row at `b`.
  template <int Rows, int Columns>
  static void eliminate_rows(Scalar* a,
                             const Scalar* b,
                             const Index stride,
                             const Index depth,
                             const Scalar* d,
                             const Scalar* inverse)
  {
    Tile<Rows, Columns> tile(a + depth * stride, stride);
    tile.subtract_product(a, b, stride, depth);
    tile.solve(d, stride, inverse);
    tile.store(a + depth * stride, stride);
  }

  Rank_update<Scalar> m_update;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_FRONT_FACTORIZATION_H
