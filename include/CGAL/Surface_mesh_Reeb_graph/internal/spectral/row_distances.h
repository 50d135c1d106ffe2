// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_ROW_DISTANCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_ROW_DISTANCES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/prefetch.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/vector_kernels.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A spectral distance is the Euclidean distance of the rows of a matrix: of the eigenfunctions, the
// columns, each multiplied with a factor that follows from its eigenvalue.

inline bool is_diffusion_time(double time)
{
  return time >= 0 && std::isfinite(time);
}

// A function of the eigenvalues divided by the first one. They increase and are not zero; there may
// be none.
template <class Function>
Eigen::VectorXd factors_of(const Eigen::VectorXd& eigenvalues, const Function& function)
{
  Eigen::VectorXd result(eigenvalues.size());
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i)
    result[i] = function(eigenvalues[i] / eigenvalues[0]);
  return result;
}

// Eq. 8 of the paper. The factors of the differences, not of their squares, so that the range of
// numbers ends where that of the distances does.
inline Eigen::VectorXd diffusion_factors(const Eigen::VectorXd& eigenvalues, double time)
{
  return factors_of(eigenvalues, [&](double lambda) { return std::exp(-time * lambda); });
}

// The same without the factor `exp(-t)` that all have in common: the first one is 1 at any time.
inline Eigen::VectorXd relative_diffusion_factors(const Eigen::VectorXd& eigenvalues, double time)
{
  return factors_of(eigenvalues, [&](double lambda) { return std::exp(-time * (lambda - 1)); });
}

// Eq. 9 of the paper.
inline Eigen::VectorXd commute_time_factors(const Eigen::VectorXd& eigenvalues)
{
  return factors_of(eigenvalues, [](double lambda) { return std::sqrt(1 / lambda); });
}

// Lipman, Rustamov, Funkhouser, "Biharmonic distance", 2010, Eq. 4.
inline Eigen::VectorXd biharmonic_factors(const Eigen::VectorXd& eigenvalues)
{
  return factors_of(eigenvalues, [](double lambda) { return 1 / lambda; });
}

// How many of the decreasing factors are more than `negligible`.
inline Eigen::Index number_of_factors_above(const Eigen::VectorXd& factors, double negligible)
{
  return std::count_if(
      factors.data(), factors.data() + factors.size(), [=](double x) { return x > negligible; });
}

// The functions below read the matrix once, in blocks of rows that stay in the cache, at about the
// speed of the memory. The numbers of the matrix may be `float` or `double`; all is computed in
// `double`.

// Some columns of a matrix, all of them or the first ones.
template <class Number>
using Columns = Eigen::Ref<const Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>>;

template <class Number>
Eigen::VectorXd row_of(const Columns<Number>& columns, Eigen::Index i)
{
  Eigen::VectorXd result(columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    result[k] = columns(i, k);
  return result;
}

// `sums[r] += sum_k (factors[k] (column_k[r] - point[k]))^2` for some columns side by side, so that
// the sums are not fetched and stored for every one.
template <class Number, int columns>
struct Add_squared_differences
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(const Number* first_column,
                                                             Eigen::Index stride,
                                                             const double* factors,
                                                             const double* point,
                                                             Eigen::Index rows,
                                                             double* sums)
  {
    Eigen::Index r = 0;
    for (; r + width <= rows; r += width) {
      Vector<double, width> sum, x;
      load(sum, sums + r);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (int k = 0; k < columns; ++k) {
        load_converted<width>(x, first_column + k * stride + r);
        x = factors[k] * (x - point[k]);
        sum += x * x;
      }
      store(sum, sums + r);
    }
    for (; r < rows; ++r)
      for (int k = 0; k < columns; ++k) {
        const double x = factors[k] * (double(first_column[k * stride + r]) - point[k]);
        sums[r] += x * x;
      }
  }
};

// Writes the squared distances of the rows from `begin` on to a point, one per entry of `result`.
// The point consists of numbers of the matrix, not yet multiplied with the factors.
template <class Number>
void write_squared_distances(const Columns<Number>& columns,
                             const Eigen::VectorXd& factors,
                             const Eigen::VectorXd& point,
                             Eigen::Index begin,
                             Eigen::Ref<Eigen::VectorXd> result)
{
  CGAL_precondition(columns.cols() == factors.size() && point.size() == factors.size());
  CGAL_precondition(0 <= begin && begin + result.size() <= columns.rows());
  constexpr int side_by_side = 4;
  result.setZero();
  Eigen::Index k = 0;
  const auto add = [&](auto kernel) {
    run_kernel<decltype(kernel)>(columns.data() + k * columns.outerStride() + begin,
                                 columns.outerStride(),
                                 factors.data() + k,
                                 point.data() + k,
                                 result.size(),
                                 result.data());
  };
  for (; k + side_by_side <= factors.size(); k += side_by_side)
    add(Add_squared_differences<Number, side_by_side>());
  for (; k < factors.size(); ++k)
    add(Add_squared_differences<Number, 1>());
}

template <class Number>
Eigen::VectorXd squared_distances(const Columns<Number>& columns,
                                  const Eigen::VectorXd& factors,
                                  const Eigen::VectorXd& point)
{
  // The sums stay in the first-level cache, and the parts of the columns are so long that the
  // hardware prefetches them.
  constexpr Eigen::Index rows_per_block = 4096;
  Eigen::VectorXd result(columns.rows());
  for (Eigen::Index begin = 0; begin < result.size(); begin += rows_per_block) {
    const Eigen::Index size = (std::min)(rows_per_block, result.size() - begin);
    write_squared_distances<Number>(columns, factors, point, begin, result.segment(begin, size));
  }
  return result;
}

// `x[r] = factor (column[r] - origin)`, and the square of that is added to `sums[r]`.
template <class Number>
struct Move_column
{
  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(const Number* column,
                                                             double factor,
                                                             double origin,
                                                             Eigen::Index rows,
                                                             double* x,
                                                             double* sums)
  {
    Eigen::Index r = 0;
    for (; r + width <= rows; r += width) {
      Vector<double, width> sum, moved;
      load(sum, sums + r);
      load_converted<width>(moved, column + r);
      moved = factor * (moved - origin);
      sum += moved * moved;
      store(moved, x + r);
      store(sum, sums + r);
    }
    for (; r < rows; ++r) {
      x[r] = factor * (double(column[r]) - origin);
      sums[r] += x[r] * x[r];
    }
  }
};

// `largest[r]` becomes at least `constants[j] + sum_k coefficients[k][j] column_k[r]` for all j.
// The number of rows is a multiple of all widths of vectors.
template <std::size_t size>
struct Raise_to_affine_functions
{
  using Group = std::array<double, size>;

  template <int width>
  static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(const double* first_column,
                                                             Eigen::Index stride,
                                                             const Group* constants,
                                                             const Group* coefficients,
                                                             Eigen::Index columns,
                                                             Eigen::Index rows,
                                                             double* largest)
  {
    for (Eigen::Index r = 0; r < rows; r += width) {
      Vector<double, width> sum[size], x;
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (std::size_t j = 0; j < size; ++j)
        fill(sum[j], (*constants)[j]);
      for (Eigen::Index k = 0; k < columns; ++k) {
        load(x, first_column + k * stride + r);
        CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
        for (std::size_t j = 0; j < size; ++j)
          sum[j] += coefficients[k][j] * x;
      }
      load(x, largest + r);
      CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
      for (std::size_t j = 0; j < size; ++j)
        raise(x, sum[j]);
      store(x, largest + r);
    }
  }
};

// For every row the largest of the squared distances to the rows of the sources; 0 if there are
// none.
//
// With the first source y as origin, that to another one z is
// |x - y|^2 + |z - y|^2 - 2 (x - y) (z - y), and these scalar products are a product of matrices.
// The result r^2 is at least |x - y|^2, and |z - y| <= |x - z| + |x - y| <= 2 r. So no term is much
// larger than the result, and nothing is lost in their sum, near sources or not.
template <class Matrix>
Eigen::VectorXd largest_squared_distances(const Matrix& eigenfunctions,
                                          const Eigen::VectorXd& factors,
                                          const std::vector<std::size_t>& sources)
{
  using Number = typename Matrix::Scalar;
  CGAL_precondition(eigenfunctions.cols() == factors.size());
  if (sources.empty())
    return Eigen::VectorXd::Zero(eigenfunctions.rows());
  const Columns<Number> columns(eigenfunctions);
  const auto row = [&](std::size_t source) {
    CGAL_precondition(static_cast<Eigen::Index>(source) < columns.rows());
    return row_of<Number>(columns, static_cast<Eigen::Index>(source));
  };
  const Eigen::VectorXd origin = row(sources.front());
  if (sources.size() == 1)
    return squared_distances<Number>(columns, factors, origin);

  // In groups of so many sources that all sums of a group stay in registers. Repeating the last
  // source fills the last group.
  constexpr std::size_t group_size = 4;
  using Raise = Raise_to_affine_functions<group_size>;
  using Group = Raise::Group;
  const std::size_t number_of_groups = (sources.size() - 2) / group_size + 1;
  std::vector<Group> squared_norms(number_of_groups);
  std::vector<std::vector<Group>> others(number_of_groups);
  for (std::size_t g = 0; g < number_of_groups; ++g) {
    others[g].resize(static_cast<std::size_t>(factors.size()));
    for (std::size_t j = 0; j < group_size; ++j) {
      const std::size_t other = (std::min)(1 + g * group_size + j, sources.size() - 1);
      const Eigen::VectorXd moved = factors.cwiseProduct(row(sources[other]) - origin);
      squared_norms[g][j] = moved.squaredNorm();
      for (Eigen::Index i = 0; i < factors.size(); ++i)
        others[g][static_cast<std::size_t>(i)][j] = -2 * moved[i];
    }
  }

  // All columns of a block stay in the cache; by the odd number of cache lines they share no place
  // in it.
  constexpr Eigen::Index rows_per_block = 120;
  static_assert(rows_per_block % 4 == 0, "the kernel takes whole vectors");
  Eigen::VectorXd result = Eigen::VectorXd::Zero(columns.rows());
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(rows_per_block, factors.size());
  std::array<double, rows_per_block> excess; // over the squared distance to the first source
  for (Eigen::Index begin = 0; begin < result.size(); begin += rows_per_block) {
    const Eigen::Index size = (std::min)(rows_per_block, result.size() - begin);
    for (Eigen::Index i = 0; i < factors.size(); ++i) {
      // the part that follows in the column: the parts are too short for the hardware prefetcher
      constexpr Eigen::Index numbers_per_line = 64 / static_cast<Eigen::Index>(sizeof(Number));
      const Eigen::Index end = (std::min)(begin + 2 * rows_per_block, result.size());
      for (Eigen::Index r = begin + rows_per_block; r < end; r += numbers_per_line)
        prefetch(&columns.coeffRef(r, i));
      run_kernel<Move_column<Number>>(
          &columns.coeffRef(begin, i), factors[i], origin[i], size, &moved(0, i), &result[begin]);
    }
    excess.fill(0);
    for (std::size_t g = 0; g < number_of_groups; ++g)
      run_kernel<Raise>(static_cast<const double*>(moved.data()),
                        rows_per_block,
                        static_cast<const Group*>(&squared_norms[g]),
                        static_cast<const Group*>(others[g].data()),
                        factors.size(),
                        rows_per_block,
                        excess.data());
    for (Eigen::Index r = 0; r < size; ++r)
      result[begin + r] += excess[static_cast<std::size_t>(r)];
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_ROW_DISTANCES_H
