// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_RANK_UPDATE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_RANK_UPDATE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/panel_kernels.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Subtracts products of a dense matrix and its transpose, with memory that is used again from one
// to the next. All matrices are stored by columns.
template <class Scalar>
class Rank_update
{
  using Index = Eigen::Index;

public:
  // `C -= A B^T`, where B are the first `columns` rows of A, which has `rows >= columns` rows and
  // `depth` columns. What is above the diagonal of C is undefined afterwards.
  void subtract(const Scalar* a,
                const Index stride,
                const Index rows,
                const Index columns,
                const Index depth,
                Scalar* c,
                const Index c_stride)
  {
    CGAL_precondition(rows >= columns && stride >= rows && c_stride >= rows);
    for (Index k = 0; k < depth; k += largest_depth)
      subtract_part(
          a + k * stride, stride, rows, columns, (std::min)(largest_depth, depth - k), c, c_stride);
  }

private:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  // A part of A of so many rows and columns stays in the second-level cache, and `tile_columns`
  // rows of B in the first-level one.
  static constexpr Index largest_depth = 192;
  static constexpr Index rows_in_cache = 8 * tile_rows;

  void subtract_part(const Scalar* a,
                     const Index stride,
                     const Index rows,
                     const Index columns,
                     const Index depth,
                     Scalar* c,
                     const Index c_stride)
  {
    pack<tile_columns>(a, stride, columns, depth, m_b);
    for (Index begin = 0; begin < rows; begin += rows_in_cache) {
      const Index size = (std::min)(rows_in_cache, rows - begin);
      pack<tile_rows>(a + begin, stride, size, depth, m_a);
      for (Index j = 0; j < (std::min)(columns, begin + size); j += tile_columns) {
        // the first tile that is not above the diagonal
        const Index first = (std::max)(j - begin, Index(0)) / tile_rows * tile_rows;
        for (Index i = first; i < size; i += tile_rows)
          subtract_tile(m_a.data() + i * depth,
                        m_b.data() + j * depth,
                        depth,
                        (std::min)(tile_rows, size - i),
                        (std::min)(tile_columns, columns - j),
                        c + begin + i + j * c_stride,
                        c_stride);
      }
    }
  }

  // Copies rows in groups, which the last one is filled up to with zeros: those of a column side by
  // side.
  template <Index group>
  static void
  pack(const Scalar* a, const Index stride, const Index rows, const Index depth, Vector& packed)
  {
    const Index size = (rows + group - 1) / group * group * depth;
    if (packed.size() < size)
      packed.resize(size);
    Scalar* to = packed.data();
    for (Index i = 0; i < rows; i += group) {
      const Index number = (std::min)(group, rows - i);
      if (number == group) {
        for (Index k = 0; k < depth; ++k, to += group)
          std::copy_n(a + i + k * stride, group, to);
      } else {
        for (Index k = 0; k < depth; ++k, to += group)
          std::fill(std::copy_n(a + i + k * stride, number, to), to + group, Scalar(0));
      }
    }
  }

  static void subtract_tile(const Scalar* a,
                            const Scalar* b,
                            const Index depth,
                            const Index rows,
                            const Index columns,
                            Scalar* c,
                            const Index c_stride)
  {
    if (rows == tile_rows && columns == tile_columns) {
      run_kernel<Subtract_tile<Scalar>>(a, b, depth, c, c_stride);
      return;
    }
    Scalar tile[tile_rows * tile_columns];
    for (Index j = 0; j < columns; ++j)
      std::copy_n(c + j * c_stride, rows, tile + j * tile_rows);
    run_kernel<Subtract_tile<Scalar>>(a, b, depth, tile, tile_rows);
    for (Index j = 0; j < columns; ++j)
      std::copy_n(tile + j * tile_rows, rows, c + j * c_stride);
  }

  Vector m_a, m_b; // packed
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_RANK_UPDATE_H
