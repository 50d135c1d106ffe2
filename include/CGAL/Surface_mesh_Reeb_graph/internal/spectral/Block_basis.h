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

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/block_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/huge_pages.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// `v^T w`
inline Block_coefficients transposed_product(const Row_block& v, const Row_block& w)
{
  Block_coefficients result;
  add_transposed_product(v.data(), w.data(), w.rows(), result);
  return result;
}

// `w = w c`; returns `w^T w` of the result.
inline Block_coefficients multiply_from_right(Row_block& w, const Block_coefficients& c)
{
  const Block_coefficients minus_c = -c;
  Block_coefficients square;
  std::vector<double> product(static_cast<std::size_t>(block_width * rows_in_cache));
  for (Eigen::Index row = 0; row < w.rows(); row += rows_in_cache) {
    const Eigen::Index size = (std::min)(rows_in_cache, w.rows() - row);
    double* const part = w.data() + block_width * row;
    std::fill(product.begin(), product.end(), 0.);
    subtract_product(product.data(), part, size, minus_c);
    add_transposed_product(product.data(), product.data(), size, square);
    std::copy_n(product.data(), block_width * size, part);
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
    CGAL_precondition(0 <= position && position <= size());
    m_blocks.insert(m_blocks.begin() + position, std::move(block));
  }
  void erase(Eigen::Index begin, Eigen::Index end)
  {
    CGAL_precondition(0 <= begin && begin <= end && end <= size());
    for (Eigen::Index i = begin; i < end; ++i)
      m_spare.push_back(std::move(m_blocks[static_cast<std::size_t>(i)]));
    m_blocks.erase(m_blocks.begin() + begin, m_blocks.begin() + end);
  }

  // A block to be filled. Memory of blocks that were erased is used again: the system takes longer
  // to clear new memory than most products take.
  Row_block new_block(Eigen::Index rows)
  {
    CGAL_precondition(m_blocks.empty() || m_blocks.front().rows() == rows);
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
    CGAL_precondition(0 <= begin && begin <= size());
    std::vector<Block_coefficients> products(m_blocks.size());
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
    CGAL_precondition(loose < size());
    std::vector<Block_coefficients> c(m_blocks.size()), d = c;
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (Eigen::Index i = 0; i < this->size(); ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        add_transposed_product(chunk(i, row), chunk(w, row), size, c[k]);
        if (loose >= 0 && i != loose)
          add_transposed_product(chunk(i, row), chunk(loose, row), size, d[k]);
      }
    });
    Block_coefficients square;
    for_chunks(w.rows(), [&](Eigen::Index row, Eigen::Index size) {
      for (Eigen::Index i = 0; i < this->size(); ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        subtract_product(chunk(w, row), chunk(i, row), size, c[k]);
        if (loose >= 0 && i != loose)
          subtract_product(chunk(loose, row), chunk(i, row), size, d[k]);
      }
      add_transposed_product(chunk(w, row), chunk(w, row), size, square);
    });
    return square;
  }

  // Replaces the first blocks, as many as `q` has rows for, by their product with `q`, which has a
  // multiple of eight columns, not more than rows.
  void multiply_from_right(const Eigen::MatrixXd& q)
  {
    CGAL_precondition(q.rows() % block_width == 0 && q.cols() % block_width == 0);
    CGAL_precondition(q.cols() <= q.rows() && q.rows() <= block_width * size());
    const Eigen::Index number = q.rows() / block_width, number_of_products = q.cols() / block_width;
    // by the block of the product, with the sign that the kernel wants
    std::vector<Block_coefficients> minus_q(static_cast<std::size_t>(number * number_of_products));
    for (Eigen::Index column = 0; column < q.cols(); ++column)
      for (Eigen::Index row = 0; row < q.rows(); ++row)
        minus_q[static_cast<std::size_t>(column / block_width * number + row / block_width)](
            static_cast<int>(row % block_width), static_cast<int>(column % block_width)) =
            -q(row, column);
    std::vector<double> products(
        static_cast<std::size_t>(number_of_products * block_width * rows_in_cache));
    const auto product = [&](Eigen::Index j) {
      return products.data() + block_width * rows_in_cache * j;
    };
    for_chunks(m_blocks.front().rows(), [&](Eigen::Index row, Eigen::Index size) {
      std::fill(products.begin(), products.end(), 0.);
      for (Eigen::Index j = 0; j < number_of_products; ++j)
        for (Eigen::Index i = 0; i < number; ++i)
          subtract_product(
              product(j), chunk(i, row), size, minus_q[static_cast<std::size_t>(j * number + i)]);
      for (Eigen::Index j = 0; j < number_of_products; ++j)
        std::copy_n(product(j), block_width * size, chunk(j, row));
    });
    erase(number_of_products, number);
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
