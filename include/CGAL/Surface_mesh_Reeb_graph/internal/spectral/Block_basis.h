// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_BASIS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_BASIS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/huge_pages.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/x86_kernels.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
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
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
  if (x86::has_kernels()) {
    x86::add_transposed_product(v, w, rows, c.data());
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

// `w -= v c` for the rows from `row` on, without kernels.
inline void subtract_rows(
    double* w, const double* v, Eigen::Index row, Eigen::Index rows, const Block_coefficients& c)
{
  using Row = Eigen::Map<Tile_row, Eigen::Aligned16>;
  using Const_row = Eigen::Map<const Tile_row, Eigen::Aligned16>;
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

// `w -= v c` for blocks of `rows` rows.
inline void
subtract_product(double* w, const double* v, Eigen::Index rows, const Block_coefficients& c)
{
  Eigen::Index row = 0;
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
  if (x86::has_kernels())
    row = x86::subtract_product(w, v, rows, c.data());
#endif
  subtract_rows(w, v, row, rows, c);
}

// Both of these for two blocks w and x at once: `c += v^T w`, `d += v^T x`; `w -= v c`, `x -= v d`.
inline void add_transposed_products(const double* v,
                                    const double* w,
                                    const double* x,
                                    Eigen::Index rows,
                                    Block_coefficients& c,
                                    Block_coefficients& d)
{
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
  if (x86::has_kernels()) {
    x86::add_transposed_products(v, w, x, rows, c.data(), d.data());
    return;
  }
#endif
  add_transposed_product(v, w, rows, c);
  add_transposed_product(v, x, rows, d);
}

inline void subtract_products(double* w,
                              double* x,
                              const double* v,
                              Eigen::Index rows,
                              const Block_coefficients& c,
                              const Block_coefficients& d)
{
  Eigen::Index row = 0;
#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_HAS_X86_KERNELS
  if (x86::has_kernels())
    row = x86::subtract_products(w, x, v, rows, c.data(), d.data());
#endif
  subtract_rows(w, v, row, rows, c);
  subtract_rows(x, v, row, rows, d);
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

// `w = w c`; returns `w^T w` of the result.
inline Block_coefficients multiply_from_right(Row_block& w, const Block_coefficients& c)
{
  const Block_coefficients minus_c = -c;
  Block_coefficients square = Block_coefficients::Zero();
  Row_block product((std::min)(rows_in_cache, w.rows()), block_width);
  for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache) {
    auto part = w.middleRows(row, (std::min)(rows_in_cache, w.rows() - row));
    product.setZero();
    subtract_product(product.data(), w.data() + block_width * row, part.rows(), minus_c);
    add_transposed_product(product.data(), product.data(), part.rows(), square);
    part = product.topRows(part.rows());
  }
  return square;
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
    for (Eigen::Index i = begin; i < end; ++i)
      m_spare.push_back(std::move(m_blocks[static_cast<std::size_t>(i)]));
    m_blocks.erase(m_blocks.begin() + begin, m_blocks.begin() + end);
  }

  // A block to be filled. Memory of blocks that were erased is used again: the system takes longer
  // to clear new memory than most products take.
  Row_block new_block(Eigen::Index rows)
  {
    if (m_spare.empty()) {
      Row_block block(rows, block_width);
      prefer_huge_pages(block.data(), static_cast<std::size_t>(block.size()));
      return block;
    }
    Row_block result = std::move(m_spare.back());
    m_spare.pop_back();
    return result;
  }
  void free_spare_memory() { m_spare.clear(); }

  // `w -= sum_i V_i c_i`, and then `w -= sum_i V_i (V_i^T w)` for the blocks from `begin` on.
  // Returns the latter coefficients.
  std::vector<Block_coefficients>
  subtract_and_project(const std::vector<std::pair<Eigen::Index, Block_coefficients>>& c,
                       Eigen::Index begin,
                       Row_block& w) const
  {
    std::vector<Block_coefficients> products(m_blocks.size(), Block_coefficients::Zero());
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (const auto& [i, coefficients] : c)
        subtract_product(chunk(w, row), chunk(i, row), size, coefficients);
      for (Eigen::Index i = begin; i < this->size(); ++i)
        add_transposed_product(
            chunk(i, row), chunk(w, row), size, products[static_cast<std::size_t>(i)]);
    });
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (Eigen::Index i = begin; i < this->size(); ++i)
        subtract_product(chunk(w, row), chunk(i, row), size, products[static_cast<std::size_t>(i)]);
    });
    return products;
  }

  // `w -= V (V^T w)`; returns `w^T w` of the result.
  //
  // The block `loose`, if it is not negative, is not quite orthogonal to the others yet, and is
  // made so on the way, while these are in the cache.
  Block_coefficients project_out_of(Row_block& w, Eigen::Index loose)
  {
    std::vector<Block_coefficients> c(m_blocks.size(), Block_coefficients::Zero()), d = c;
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (Eigen::Index i = 0; i < this->size(); ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        if (loose >= 0 && i != loose)
          add_transposed_products(
              chunk(i, row), chunk(w, row), chunk(loose, row), size, c[k], d[k]);
        else
          add_transposed_product(chunk(i, row), chunk(w, row), size, c[k]);
      }
    });
    Block_coefficients square = Block_coefficients::Zero();
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (Eigen::Index i = 0; i < this->size(); ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        if (loose >= 0 && i != loose)
          subtract_products(chunk(w, row), chunk(loose, row), chunk(i, row), size, c[k], d[k]);
        else
          subtract_product(chunk(w, row), chunk(i, row), size, c[k]);
      }
      add_transposed_product(chunk(w, row), chunk(w, row), size, square);
    });
    return square;
  }

  // Replaces the first blocks, as many as `q` has rows for, by their product with `q`, which has a
  // multiple of eight columns, not more than rows.
  void multiply_from_right(const Eigen::MatrixXd& q)
  {
    const std::size_t number = static_cast<std::size_t>(q.rows() / block_width),
                      number_of_products = static_cast<std::size_t>(q.cols() / block_width);
    // by the block of the product, with the sign that the kernel wants
    std::vector<Block_coefficients> minus_q;
    for (std::size_t j = 0; j < number_of_products; ++j)
      for (std::size_t i = 0; i < number; ++i)
        minus_q.push_back(
            -q.block<block_width, block_width>(block_width * static_cast<Eigen::Index>(i),
                                               block_width * static_cast<Eigen::Index>(j)));
    const Eigen::Index n = m_blocks.front().rows();
    std::vector<Row_block> products(number_of_products,
                                    Row_block((std::min)(rows_in_cache, n), block_width));
    for (Eigen::Index row = 0; row < n; row += rows_in_cache) {
      const Eigen::Index size = (std::min)(rows_in_cache, n - row);
      for (std::size_t j = 0; j < number_of_products; ++j)
        products[j].setZero();
      for (std::size_t j = 0; j < number_of_products; j += 2) {
        for (std::size_t i = 0; i < number; ++i) {
          const double* const v = m_blocks[i].data() + block_width * row;
          const Block_coefficients& c = minus_q[j * number + i];
          if (j + 1 < number_of_products)
            subtract_products(products[j].data(),
                              products[j + 1].data(),
                              v,
                              size,
                              c,
                              minus_q[(j + 1) * number + i]);
          else
            subtract_product(products[j].data(), v, size, c);
        }
      }
      for (std::size_t j = 0; j < number_of_products; ++j)
        m_blocks[j].middleRows(row, size) = products[j].topRows(size);
    }
    erase(static_cast<Eigen::Index>(number_of_products), static_cast<Eigen::Index>(number));
  }

private:
  // Calls `f` with the first row and the number of rows of parts that stay in the cache.
  template <class Function>
  static void for_chunks(Eigen::Index rows, const Function& f)
  {
    for (Eigen::Index row = 0; row < rows; row += rows_in_cache)
      f(row, (std::min)(rows_in_cache, rows - row));
  }

  static double* chunk(Row_block& w, Eigen::Index row) { return w.data() + block_width * row; }
  double* chunk(Eigen::Index i, Eigen::Index row)
  {
    return m_blocks[static_cast<std::size_t>(i)].data() + block_width * row;
  }
  const double* chunk(Eigen::Index i, Eigen::Index row) const
  {
    return m_blocks[static_cast<std::size_t>(i)].data() + block_width * row;
  }

  std::vector<Row_block> m_blocks;
  std::vector<Row_block> m_spare;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_BLOCK_BASIS_H
