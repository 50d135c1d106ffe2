// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ROW_BLOCK_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ROW_BLOCK_H

#include <CGAL/Surface_mesh_reeb_graph/internal/avx2_kernels.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Eight vectors side by side: a row of them is one cache line, which every kernel below uses at
// once.
constexpr int block_width = 8;
using Row_block = Eigen::Matrix<double, Eigen::Dynamic, block_width, Eigen::RowMajor>;
using Block_coefficients = Eigen::Matrix<double, block_width, block_width, Eigen::RowMajor>;

// Rows of a block that stay in the cache while they meet all other blocks.
constexpr Eigen::Index rows_in_cache = 512;

// Four by four sums at a time: all registers that every 64-bit processor has, and no more.
constexpr int tile_width = block_width / 2;
using Tile_row = Eigen::Array<double, tile_width, 1>;

// `c += v^T w` for blocks of `rows` rows.
inline void
add_transposed_product(const double* v, const double* w, Eigen::Index rows, Block_coefficients& c)
{
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_AVX2_KERNELS
  if (has_avx2()) {
    avx2::add_transposed_product(v, w, rows, c.data());
    return;
  }
#endif
  static_assert(tile_width == 4, "the loop is unrolled for four columns of v");
  for (int i = 0; i < block_width; i += tile_width) {
    for (int j = 0; j < block_width; j += tile_width) {
      Tile_row sum_0 = Tile_row::Zero(), sum_1 = sum_0, sum_2 = sum_0, sum_3 = sum_0;
      const double* v_row = v + i;
      const double* w_row = w + j;
      for (Eigen::Index row = 0; row < rows; ++row) {
        const Tile_row x = Eigen::Map<const Tile_row, Eigen::Aligned16>(w_row);
        sum_0 += v_row[0] * x;
        sum_1 += v_row[1] * x;
        sum_2 += v_row[2] * x;
        sum_3 += v_row[3] * x;
        v_row += block_width;
        w_row += block_width;
      }
      c.block<1, tile_width>(i, j) += sum_0.matrix().transpose();
      c.block<1, tile_width>(i + 1, j) += sum_1.matrix().transpose();
      c.block<1, tile_width>(i + 2, j) += sum_2.matrix().transpose();
      c.block<1, tile_width>(i + 3, j) += sum_3.matrix().transpose();
    }
  }
}

// `w -= v c` for blocks of `rows` rows.
inline void
subtract_product(double* w, const double* v, Eigen::Index rows, const Block_coefficients& c)
{
  using Row = Eigen::Map<Tile_row, Eigen::Aligned16>;
  using Const_row = Eigen::Map<const Tile_row, Eigen::Aligned16>;
  Eigen::Index row = 0;
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_AVX2_KERNELS
  if (has_avx2())
    row = avx2::subtract_product(w, v, rows, c.data());
#endif
  for (; row + 2 <= rows; row += 2) {
    const double* v_row = v + block_width * row;
    for (int j = 0; j < block_width; j += tile_width) {
      Row first(w + block_width * row + j), second(w + block_width * (row + 1) + j);
      Tile_row sum_0 = first, sum_1 = second;
      for (int k = 0; k < block_width; ++k) {
        const Tile_row x = Const_row(c.data() + block_width * k + j);
        sum_0 -= v_row[k] * x;
        sum_1 -= v_row[block_width + k] * x;
      }
      first = sum_0;
      second = sum_1;
    }
  }
  if (row < rows)
    Eigen::Map<Row_block>(w + block_width * row, 1, block_width).noalias() -=
        Eigen::Map<const Row_block>(v + block_width * row, 1, block_width) * c;
}

// `v^T w`
inline Block_coefficients transposed_product(const Row_block& v, const Row_block& w)
{
  Block_coefficients result = Block_coefficients::Zero();
  for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache)
    add_transposed_product(v.data() + block_width * row,
                           w.data() + block_width * row,
                           (std::min)(rows_in_cache, w.rows() - row),
                           result);
  return result;
}

// `w = w c`
inline void multiply_from_right(Row_block& w, const Block_coefficients& c)
{
  Row_block rows;
  for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache) {
    auto part = w.middleRows(row, (std::min)(rows_in_cache, w.rows() - row));
    rows.noalias() = part * c;
    part = rows;
  }
}

// A tall matrix `V` as a sequence of blocks. What walks it, walks rows that stay in the cache and
// within them all blocks: Eigen's products of a tall matrix and a narrow one copy the tall one
// first.
class Block_basis
{
public:
  Eigen::Index size() const { return static_cast<Eigen::Index>(m_blocks.size()); }
  const Row_block& operator[](Eigen::Index i) const
  {
    return m_blocks[static_cast<std::size_t>(i)];
  }

  void insert(Eigen::Index position, Row_block&& block)
  {
    m_blocks.insert(m_blocks.begin() + position, std::move(block));
  }
  void erase(Eigen::Index begin, Eigen::Index end)
  {
    m_blocks.erase(m_blocks.begin() + begin, m_blocks.begin() + end);
  }

  // `w -= V (V^T w)`; returns `V^T w`.
  Eigen::MatrixXd project_out_of(Row_block& w) const
  {
    std::vector<Block_coefficients> c(m_blocks.size(), Block_coefficients::Zero());
    for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache)
      for (std::size_t i = 0; i < m_blocks.size(); ++i)
        add_transposed_product(m_blocks[i].data() + block_width * row,
                               w.data() + block_width * row,
                               (std::min)(rows_in_cache, w.rows() - row),
                               c[i]);
    for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache)
      for (std::size_t i = 0; i < m_blocks.size(); ++i)
        subtract_product(w.data() + block_width * row,
                         m_blocks[i].data() + block_width * row,
                         (std::min)(rows_in_cache, w.rows() - row),
                         c[i]);
    Eigen::MatrixXd result(block_width * size(), block_width);
    for (std::size_t i = 0; i < c.size(); ++i)
      result.middleRows<block_width>(block_width * static_cast<Eigen::Index>(i)) = c[i];
    return result;
  }

  // The product of the first blocks, as many as `q` has rows for, with `q`.
  Eigen::MatrixXd product(const Eigen::MatrixXd& q) const
  {
    Eigen::MatrixXd result(m_blocks.front().rows(), q.cols());
    for_products(q, [&result](Eigen::Index row, Eigen::Index block, const Row_block& rows) {
      const Eigen::Index column = block_width * block,
                         width = (std::min)(Eigen::Index(block_width), result.cols() - column);
      result.block(row, column, rows.rows(), width) = rows.leftCols(width);
    });
    return result;
  }

  // Replaces them by it, in place.
  void multiply_from_right(const Eigen::MatrixXd& q)
  {
    const Eigen::Index number = q.cols() / block_width;
    for_products(q, [this](Eigen::Index row, Eigen::Index block, const Row_block& rows) {
      m_blocks[static_cast<std::size_t>(block)].middleRows(row, rows.rows()) = rows;
    });
    erase(number, q.rows() / block_width);
  }

private:
  // Calls `function` with rows of a block of the product, the number of the first row and that of the block, until it
  // has seen all. The blocks of the same rows come one after the other.
  template <class Function>
  void for_products(const Eigen::MatrixXd& q, const Function& function) const
  {
    const Eigen::Index number = q.rows() / block_width, n = m_blocks.front().rows();
    // the coefficients of every block of the product, with the sign that the kernel wants
    const Eigen::Index number_of_products = (q.cols() + block_width - 1) / block_width;
    std::vector<Block_coefficients> minus_q(static_cast<std::size_t>(number * number_of_products),
                                            Block_coefficients::Zero());
    for (Eigen::Index j = 0; j < number_of_products; ++j)
      for (Eigen::Index i = 0; i < number; ++i) {
        const Eigen::Index width =
            (std::min)(Eigen::Index(block_width), q.cols() - block_width * j);
        minus_q[static_cast<std::size_t>(j * number + i)].leftCols(width) =
            -q.block(block_width * i, block_width * j, block_width, width);
      }
    std::vector<Row_block> products(static_cast<std::size_t>(number_of_products));
    for (Eigen::Index row = 0; row < n; row += rows_in_cache) {
      const Eigen::Index size = (std::min)(rows_in_cache, n - row);
      for (Eigen::Index j = 0; j < number_of_products; ++j) {
        Row_block& product = products[static_cast<std::size_t>(j)];
        product.setZero(size, block_width);
        for (Eigen::Index i = 0; i < number; ++i)
          subtract_product(product.data(),
                           (*this)[i].data() + block_width * row,
                           size,
                           minus_q[static_cast<std::size_t>(j * number + i)]);
      }
      // not before: the product may take the place of what it is made from
      for (Eigen::Index j = 0; j < number_of_products; ++j)
        function(row, j, products[static_cast<std::size_t>(j)]);
    }
  }

  std::vector<Row_block> m_blocks;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ROW_BLOCK_H
