// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SUPERNODAL_CHOLESKY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SUPERNODAL_CHOLESKY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Front_factorization.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Panel_solver.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Register_vector.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Supernodal_structure.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/huge_pages.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

template <class MatrixType_,
          int UpLo_ = Eigen::Lower,
          class Ordering_ = Eigen::AMDOrdering<typename MatrixType_::StorageIndex>>
class Supernodal_Cholesky;

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

namespace Eigen {
namespace internal {

template <class MatrixType_, int UpLo_, class Ordering_>
struct traits<CGAL::Surface_mesh_Reeb_graph::Supernodal_Cholesky<MatrixType_, UpLo_, Ordering_>>
{
  using MatrixType = MatrixType_;
  using OrderingType = Ordering_;
  using Scalar = typename MatrixType::Scalar;
  using StorageIndex = typename MatrixType::StorageIndex;
};

} // namespace internal
} // namespace Eigen

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

A direct solver for sparse symmetric positive definite systems of linear equations, for one or many
right-hand sides.

It computes a Cholesky factorization *P A P^T = L L^T* with a permutation *P* that keeps the factor
sparse, by the multifrontal method on supernodes, which needs no other library than Eigen
(\cgalCite{liu_1992}). Its interface is that of the direct solvers of Eigen, such as
`Eigen::SimplicialLDLT`, so that `CGAL::Eigen_solver_traits<Supernodal_Cholesky<...>>` is a model of
`SparseLinearAlgebraWithFactorTraits_d`.

Like those, it keeps no pointer to the matrix. All functions that are `const`, and `solve()` is one
of them, may be called by several threads at the same time. Results are the same in every run.

<b>Failure.</b> Where a pivot is not positive and finite, because the matrix is not positive
definite or has entries that are not finite, `info()` is `Eigen::NumericalIssue`. Rounding decides
about matrices that are positive semi-definite, or nearly. If the factorization has not succeeded,
solutions are zero.

<b>Complexity.</b> As the number of entries of the factor, *O(n log n)* for a surface mesh with *n*
vertices and a good ordering, in memory and for every solution; as *O(n^1.5)* for the factorization.
Solutions for 8 right-hand sides read the factor once and take little longer than for one.

<b>Example.</b>
\cgalExample{Surface_mesh_Reeb_graph/sparse_linear_system.cpp}

\tparam MatrixType_ an instance of `Eigen::SparseMatrix` with `float` or `double` as number type and
        a signed index type
\tparam UpLo_ `Eigen::Lower` or `Eigen::Upper`: the triangle of the matrix that is read
\tparam Ordering_ a fill-reducing ordering of Eigen for symmetric matrices, such as
        `Eigen::AMDOrdering` or `Eigen::NaturalOrdering`

\sa `Laplace_Beltrami_eigenbasis`
*/
template <class MatrixType_, int UpLo_, class Ordering_>
class Supernodal_Cholesky
  : public Eigen::SparseSolverBase<Supernodal_Cholesky<MatrixType_, UpLo_, Ordering_>>
{
  using Base = Eigen::SparseSolverBase<Supernodal_Cholesky>;
  using Base::m_isInitialized;

public:
  /// \name Types
  /// @{

  /// the type of the matrix
  using MatrixType = MatrixType_;
  /// the type of the ordering
  using OrderingType = Ordering_;
  /// the number type
  using Scalar = typename MatrixType::Scalar;
  /// the type of differences of numbers
  using RealScalar = typename MatrixType::RealScalar;
  /// the type of the indices that the matrix stores
  using StorageIndex = typename MatrixType::StorageIndex;
  /// the type of sizes
  using Index = Eigen::Index;
  /// the type of the permutation
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, StorageIndex>;

  /// @}

  enum {
    UpLo = UpLo_,
    ColsAtCompileTime = MatrixType::ColsAtCompileTime,
    MaxColsAtCompileTime = MatrixType::MaxColsAtCompileTime
  };

  static_assert(std::is_floating_point<Scalar>::value, "the factorization is for real numbers");

  /// \name Factorization
  /// @{

  /// constructs a solver without a matrix.
  Supernodal_Cholesky() = default;

  /// constructs the solver of systems with the matrix `a`, as `compute(a)` does.
  explicit Supernodal_Cholesky(const MatrixType& a) { compute(a); }

  /// factors the matrix `a`: `analyzePattern(a)` followed by `factorize(a)`.
  Supernodal_Cholesky& compute(const MatrixType& a)
  {
    analyzePattern(a);
    if (m_info == Eigen::Success)
      factorize(a);
    return *this;
  }

  /// finds the permutation and the pattern of the factor of a matrix whose entries are where
  /// those of `a` are. The values of the entries do not count. `info()` is `Eigen::InvalidInput` if
  /// the matrix is not square.
  void analyzePattern(const MatrixType& a)
  {
    reset();
    m_size = a.rows();
    if (a.rows() != a.cols()) {
      m_info = Eigen::InvalidInput;
      return;
    }
    Column_matrix full;
    full = a.template selfadjointView<UpLo>();
    Permutation inverse;
    if (m_size > 0) {
      // what AMD is given otherwise is added to its transpose, with several copies
      if constexpr (std::is_same_v<OrderingType, Eigen::AMDOrdering<StorageIndex>>)
        OrderingType()(full.template selfadjointView<Eigen::Lower>(), inverse);
      else
        OrderingType()(full, inverse);
    }
    std::vector<StorageIndex> position(static_cast<std::size_t>(m_size));
    for (Index i = 0; i < m_size; ++i) {
      // an empty permutation is Eigen's natural ordering
      const Index column = inverse.size() == 0 ? i : inverse.indices()[i];
      position[static_cast<std::size_t>(column)] = static_cast<StorageIndex>(i);
    }
    m_structure = Structure(full, std::move(position));
    m_permutation.indices() = Eigen::Map<const Eigen::Matrix<StorageIndex, Eigen::Dynamic, 1>>(
        m_structure.positions().data(), m_size);
    m_analyzed = true;
    m_info = Eigen::Success;
  }

  /// factors the matrix `a`, whose entries are where those of the matrix of the last call of
  /// `analyzePattern()` or `compute()` are, or at some of these positions. `info()` is
  /// `Eigen::InvalidInput` if the pattern is another one, and `Eigen::NumericalIssue` if the matrix
  /// is not positive definite.
  void factorize(const MatrixType& a)
  {
    m_factored = false;
    m_isInitialized = true;
    m_info = Eigen::InvalidInput;
    if (!m_analyzed || a.rows() != m_size || a.cols() != m_size)
      return;
    Column_matrix permuted(m_size, m_size);
    permuted.template selfadjointView<Eigen::Lower>() =
        a.template selfadjointView<UpLo>().twistedBy(m_permutation);
    m_factor.resize(m_structure.size());
    internal::prefer_huge_pages(m_factor.data(), static_cast<std::size_t>(m_factor.size()));
    m_info = factorize_fronts(permuted);
    m_factored = m_info == Eigen::Success;
    if (!m_factored)
      m_factor.resize(0);
  }

  /// returns whether the last step has succeeded: `Eigen::Success`, or what is wrong.
  Eigen::ComputationInfo info() const { return m_info; }

  /// @}

  /// \name Access
  /// @{

  /// returns the number of rows of the matrix.
  Index rows() const { return m_size; }
  /// returns the number of columns of the matrix.
  Index cols() const { return m_size; }

  /// returns the permutation *P*: row `i` of the matrix is row `permutationP().indices()[i]` of the
  /// factor.
  const Permutation& permutationP() const { return m_permutation; }

  /// returns the determinant of the matrix. It easily is beyond the range of the number type.
  /// \pre `info()` is `Eigen::Success` after a factorization.
  Scalar determinant() const
  {
    CGAL_precondition(m_factored);
    Scalar root(1);
    for (Index s = 0; s < m_structure.number_of_supernodes(); ++s) {
      const Index width = m_structure.width(s);
      const Scalar* const panel = m_factor.data() + m_structure.offset(s);
      const Index rows = width + m_structure.number_of_rows_below(s);
      for (Index j = 0; j < width; ++j)
        root *= panel[j + j * rows];
    }
    return root * root;
  }

  /// returns the number of entries of the lower triangular factor, with the zeros that are stored,
  /// too.
  Index nonZeros() const { return m_structure.number_of_entries(); }

  /// returns the number of bytes that the solver holds for the factor and its pattern.
  std::size_t memory() const
  {
    return sizeof(Scalar) * static_cast<std::size_t>(m_factor.size()) +
           sizeof(StorageIndex) * static_cast<std::size_t>(m_permutation.size()) +
           m_structure.memory();
  }

  /// @}

  /// \name Solution
  /// @{

#ifdef DOXYGEN_RUNNING
  /// returns the solution *X* of *A X = B*, as an expression of Eigen. `b` is a vector or a matrix,
  /// dense or sparse. Blocks of 8 columns are solved together.
  /// \pre `info()` is `Eigen::Success` after a factorization, and `b.rows() == rows()`.
  template <class Rhs>
  unspecified_type solve(const Rhs& b) const;
#endif

  /// replaces the right-hand sides, the columns of `x`, by the solutions. It holds a copy of `x`
  /// meanwhile.
  /// \tparam Columns the number of right-hand sides; 8 make the best of a cache line
  /// \pre `info()` is `Eigen::Success` after a factorization, and `x.rows() == rows()`.
  template <int Columns>
  void solve_in_place(Eigen::Matrix<Scalar,
                                    Eigen::Dynamic,
                                    Columns,
                                    Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>& x) const
  {
    static_assert(Columns > 0, "the number of right-hand sides is fixed");
    CGAL_precondition(x.rows() == m_size);
    solve_columns<Columns>(x, 0, x);
  }

  /// replaces the rows of `x`, which are those of a right-hand side in the order of the factor, by
  /// the solution in the same order: *P A P^T X = B*. Nothing of the size of `x` is copied or
  /// allocated.
  /// \tparam Columns the number of right-hand sides; 8 make the best of a cache line
  /// \pre `info()` is `Eigen::Success` after a factorization, and `x.rows() == rows()`.
  template <int Columns>
  void
  solve_permuted_in_place(Eigen::Matrix<Scalar,
                                        Eigen::Dynamic,
                                        Columns,
                                        Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>& x) const
  {
    static_assert(Columns > 0, "the number of right-hand sides is fixed");
    CGAL_precondition(x.rows() == m_size);
    if (!m_factored) {
      x.setZero();
      return;
    }
    Block<Columns> below(m_structure.largest_number_of_rows_below(), Columns);
    substitute<Columns>(x.data(), below.data());
  }

  /// @}

  /// \cond SKIP_IN_MANUAL
  using Base::_solve_impl;

  template <class Rhs, class Dest>
  void _solve_impl(const Eigen::MatrixBase<Rhs>& b, Eigen::MatrixBase<Dest>& x) const
  {
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    CGAL_precondition(b.rows() == m_size);
    x.derived().resize(b.rows(), b.cols());
    // evaluates what is no matrix in memory
    const Eigen::Ref<const Matrix, 0, Eigen::OuterStride<>> rhs(b.derived());
    for (Index j = 0; j < b.cols();) {
      const Index remaining = b.cols() - j;
      if (remaining >= 5)
        j += solve_columns<8>(rhs, j, x);
      else if (remaining >= 2)
        j += solve_columns<4>(rhs, j, x);
      else
        j += solve_columns<1>(rhs, j, x);
    }
  }
  /// \endcond

private:
  using Structure = internal::Supernodal_structure<StorageIndex>;
  using Column_matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, StorageIndex>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  template <int Columns>
  using Block = Eigen::
      Matrix<Scalar, Eigen::Dynamic, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

  void reset()
  {
    m_analyzed = false;
    m_factored = false;
    m_isInitialized = false;
    m_size = 0;
    m_structure = Structure();
    m_permutation.resize(0);
    m_factor.resize(0);
  }

  // An update of a front on the stack.
  struct Update
  {
    Index supernode;
    Scalar* triangle; // columns of the lower triangle, one after the other
  };

  // What the work on all fronts shares, so that none of them allocates memory.
  struct Workspace
  {
    explicit Workspace(const Structure& structure, const Index size)
      : stack(structure.stack_size())
      , square(structure.largest_number_of_rows_below() * structure.largest_number_of_rows_below())
      , row_in_front(static_cast<std::size_t>(size))
      , row_in_parent(static_cast<std::size_t>(structure.largest_number_of_rows_below()))
    {
      internal::prefer_huge_pages(stack.data(), static_cast<std::size_t>(stack.size()));
      internal::prefer_huge_pages(square.data(), static_cast<std::size_t>(square.size()));
    }

    Vector stack;
    Vector square; // the update of the current front
    std::vector<Update> updates;
    std::vector<StorageIndex> row_in_front;
    std::vector<StorageIndex> row_in_parent;
  };

  Eigen::ComputationInfo factorize_fronts(const Column_matrix& a)
  {
    internal::Front_factorization<Scalar> front;
    Workspace work(m_structure, m_size);
    Scalar* top = work.stack.data();
    for (Index s = 0; s < m_structure.number_of_supernodes(); ++s) {
      const Index width = m_structure.width(s);
      const Index below = m_structure.number_of_rows_below(s);
      Scalar* const panel = m_factor.data() + m_structure.offset(s);
      Scalar* const square = work.square.data();
      std::fill_n(panel, width * (width + below), Scalar(0));
      for (Index j = 0; j < below; ++j)
        std::fill_n(square + j + j * below, below - j, Scalar(0));
      number_rows(s, work.row_in_front);
      if (!add_matrix(a, s, work.row_in_front, panel))
        return Eigen::InvalidInput;
      for (StorageIndex c = 0; c < m_structure.number_of_children(s); ++c) {
        CGAL_assertion(!work.updates.empty());
        add_update(s, work, panel, square);
        top = work.updates.back().triangle;
        work.updates.pop_back();
      }
      if (!front.eliminate(panel, width + below, width))
        return Eigen::NumericalIssue;
      if (below > 0) {
        front.subtract_square(panel, width + below, width, square, below);
        work.updates.push_back({s, top});
        for (Index j = 0; j < below; ++j)
          top = std::copy_n(square + j + j * below, below - j, top);
        CGAL_assertion(top <= work.stack.data() + work.stack.size());
      }
    }
    return Eigen::Success;
  }

  // Numbers the rows of a front.
  void number_rows(const Index s, std::vector<StorageIndex>& row_in_front) const
  {
    StorageIndex number = 0;
    for (StorageIndex j = m_structure.first_column(s); j < m_structure.first_column(s + 1); ++j)
      row_in_front[static_cast<std::size_t>(j)] = number++;
    const StorageIndex* const rows = m_structure.rows_below(s);
    for (Index i = 0; i < m_structure.number_of_rows_below(s); ++i)
      row_in_front[static_cast<std::size_t>(rows[i])] = number++;
  }

  // Adds the entries of the matrix. Returns false if there is one where the front has no row.
  bool add_matrix(const Column_matrix& a,
                  const Index s,
                  const std::vector<StorageIndex>& row_in_front,
                  Scalar* panel) const
  {
    const StorageIndex first = m_structure.first_column(s);
    const Index width = m_structure.width(s);
    const Index below = m_structure.number_of_rows_below(s);
    const StorageIndex* const rows = m_structure.rows_below(s);
    for (Index j = 0; j < width; ++j, panel += width + below)
      for (typename Column_matrix::InnerIterator it(a, first + j); it; ++it) {
        const Index i = row_in_front[static_cast<std::size_t>(it.row())];
        const bool is_row = it.row() < first + width
                                ? i == it.row() - first
                                : i >= width && i < width + below && rows[i - width] == it.row();
        if (!is_row)
          return false;
        panel[i] += it.value();
      }
    return true;
  }

  // Adds the update on the top of the stack to its parent, the supernode `s`.
  void add_update(const Index s, Workspace& work, Scalar* panel, Scalar* square) const
  {
    const Index width = m_structure.width(s);
    const Index below = m_structure.number_of_rows_below(s);
    const Index child = work.updates.back().supernode;
    const Scalar* from = work.updates.back().triangle;
    const Index size = m_structure.number_of_rows_below(child);
    const StorageIndex* const rows = m_structure.rows_below(child);
    StorageIndex* const row = work.row_in_parent.data();
    for (Index i = 0; i < size; ++i) {
      row[i] = work.row_in_front[static_cast<std::size_t>(rows[i])];
      // the parent has all rows of its children, in the same order
      CGAL_assertion(row[i] < width + below && (i == 0 || row[i - 1] < row[i]));
    }
    for (Index j = 0; j < size; ++j) {
      Scalar* const to = row[j] < width ? panel + row[j] * (width + below)
                                        : square + (row[j] - width) * below - width;
      for (Index i = j; i < size; ++i)
        to[row[i]] += *from++;
    }
  }

  template <int Columns, class Rhs, class Dest>
  Index solve_columns(const Rhs& b, const Index j, Dest& x) const
  {
    const Index number = (std::min)(b.cols() - j, Index(Columns));
    if (!m_factored) {
      x.middleCols(j, number).setZero();
      return number;
    }
    Block<Columns> block(m_size, Columns);
    if (number < Columns)
      block.setZero();
    const StorageIndex* const position = m_permutation.indices().data();
    for (Index i = 0; i < m_size; ++i)
      block.row(position[i]).head(number) = b.row(i).segment(j, number);
    solve_permuted_in_place<Columns>(block);
    for (Index i = 0; i < m_size; ++i)
      x.row(i).segment(j, number) = block.row(position[i]).head(number);
    return number;
  }

  // Both substitutions, on rows in the order of the factor. `below` has room for the rows of a
  // front.
  template <int Columns>
  void substitute(Scalar* x, Scalar* below) const
  {
    using Row = internal::Register_vector<Scalar, Columns>;
    const Index number = m_structure.number_of_supernodes();
    const auto panel = [this](const Index s) {
      return internal::Panel_solver<Scalar, Columns>(m_factor.data() + m_structure.offset(s),
                                                     m_structure.width(s),
                                                     m_structure.number_of_rows_below(s));
    };
    const auto gather = [&](const Index s) {
      const StorageIndex* const rows = m_structure.rows_below(s);
      for (Index i = 0; i < m_structure.number_of_rows_below(s); ++i)
        Row::load(x + rows[i] * Index(Columns)).store(below + i * Columns);
    };
    for (Index s = 0; s < number; ++s) {
      gather(s);
      panel(s).forward(x + m_structure.first_column(s) * Index(Columns), below);
      const StorageIndex* const rows = m_structure.rows_below(s);
      for (Index i = 0; i < m_structure.number_of_rows_below(s); ++i)
        Row::load(below + i * Columns).store(x + rows[i] * Index(Columns));
    }
    for (Index s = number - 1; s >= 0; --s) {
      gather(s);
      panel(s).backward(x + m_structure.first_column(s) * Index(Columns), below);
    }
  }

  Index m_size = 0;
  Eigen::ComputationInfo m_info = Eigen::InvalidInput;
  bool m_analyzed = false;
  bool m_factored = false;
  Structure m_structure;
  Permutation m_permutation;
  Vector m_factor; // the columns of the supernodes, one panel after the other
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SUPERNODAL_CHOLESKY_H
