// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_BLOCK_LANCZOS_EIGENSOLVER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_BLOCK_LANCZOS_EIGENSOLVER_H

#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_basis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_coefficients.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Default_solver_traits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Shift_inverted_operator.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/block_kernels.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/symmetric_eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Uniform_random_numbers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/huge_pages.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The smallest eigenpairs of *L psi = lambda M psi* by block Lanczos iteration, with shift and invert:
the default eigensolver of `Laplace_Beltrami_eigenbasis`.

The largest eigenvalues of *A = M^1/2 (L + sigma M)^-1 M^1/2* are `1 / (lambda + sigma)` for the
smallest *lambda*. Eight vectors are multiplied by *A* at a time, which takes one pass over the
factor of *L + sigma M*, and are orthogonalized against all others (\cgalCite{grimes_1994}). The
basis has a bounded number of vectors: when it is full, it is replaced by the approximations of the
eigenvectors wanted and some more, and continued (\cgalCite{wu_2000}).

<b>Multiple eigenvalues</b> of any multiplicity are found completely: a Krylov space of eight random
vectors holds up to eight vectors of every eigenspace; if eight eigenvalues coincide, the space
orthogonal to those found is searched from new random vectors. The chance to miss one is below
1e-10.

<b>Complexity.</b> One sparse factorization, and some 250 to 350 solves for 50 pairs on meshes of
any size. Beside the factor and the result it holds about three vectors for every pair wanted, 8
bytes per vertex each.

<b>Example.</b>
\cgalExample{Surface_mesh_Reeb_graph/smallest_eigenpairs.cpp}

\tparam SolverTraits a model of `LaplaceBeltramiFactorizationTraits`; by default one that has
        `Supernodal_Cholesky`

\cgalModels `LaplaceBeltramiEigensolver`

\sa `Spectra_eigensolver`
*/
template <class SolverTraits = internal::Default_solver_traits>
class Block_Lanczos_eigensolver
{
  using Row_block = internal::Row_block;
  using Block_coefficients = internal::Block_coefficients;
  static constexpr Eigen::Index width = internal::block_width;

public:
  /*!
  factors *L + sigma M*.

  \param stiffness *L*: symmetric, positive semi-definite
  \param mass the diagonal of *M*: not negative, not all zero
  \param shift *sigma*: positive, of the order of the smallest non-zero eigenvalue
  \param options seed, tolerance and callback

  \pre the matrices have the same size, and the shift is positive

  \throws Numerical_error if the factorization fails
  \throws Interruption if the callback returns `false`
  */
  Block_Lanczos_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                            const Eigen::VectorXd& mass,
                            double shift,
                            const Eigensolver_options& options = Eigensolver_options())
    : m_options(options)
    , m_random(options.seed)
    , m_tolerance((std::min)((std::max)(1e-3 * options.residual_tolerance, 1e-13), 1e-11))
    , m_operator((options.report_progress(0), stiffness), mass, shift)
  {}

  /*!
  returns the `number` smallest eigenpairs, or all if there are fewer. It may be called several
  times, and uses what it found before.

  \pre `number > 0`

  \throws Numerical_error if a linear system could not be solved, or an iteration did not converge
  \throws Interruption if the callback returns `false`
  */
  Eigenpairs smallest(Eigen::Index number)
  {
    CGAL_precondition(number > 0);
    if (m_operator.is_small_for(number))
      return m_operator.dense_eigenpairs(number);
    const bool have_converged = iterate(number);
    if (!have_converged)
      number = (std::min)(number, number_converged());
    return eigenpairs(number, have_converged);
  }

private:
  // The basis V has `m_processed` blocks that were multiplied by A, and after them one pending
  // block or several, with `A V_processed = V T_processed`: T is the projection `V^T A V` of A on
  // V, and what it has below the processed blocks is the rest that the eigenpairs of its upper part
  // leave. An additional random pending block, orthogonal to all others, leaves this as it is.

  Eigen::Index number_of_pending_blocks() const { return m_basis.size() - m_processed; }

  // Until the `number` largest eigenvalues of A are found; returns whether that was possible.
  bool iterate(Eigen::Index number)
  {
    constexpr int max_restarts = 300;
    // More vectors would save few solves only, and take memory. A few steps have room in any case.
    const Eigen::Index capacity = (std::max)(3 * number, number + 56) / width;
    m_progress = 0;
    if (m_basis.size() == 0) {
      insert_random_block(0);
      m_number_of_random_vectors = width;
    } else if (m_processed > 0 && has_converged(number) && is_complete(number)) {
      return true;
    }
    // A test of convergence costs as much as a step on small meshes. So the next one is when the
    // eigenpairs will have converged, if the error goes on to decrease as it did since the last
    // one.
    Eigen::Index steps = 0, last_look = 0,
                 next_look = (std::max)(m_processed, 3 * capacity / 4) - m_processed;
    double last_error = 0;
    for (int restarts = 0; restarts < max_restarts; ++restarts) {
      while (m_processed < capacity && has_room_for_block()) {
        multiply_next();
        ++steps;
        if (steps < next_look && m_processed < capacity && has_room_for_block())
          continue;
        if (has_converged(number) && is_complete(number))
          return true;
        const double error = std::log(largest_relative_coupling(number));
        const double decrease = (last_error - error) / static_cast<double>(steps - last_look);
        const bool is_known = last_look > 0 && decrease > 0 && error > 0;
        next_look = steps + (is_known ? static_cast<Eigen::Index>((std::min)(error / decrease, 1e3))
                                      : Eigen::Index(2));
        last_look = steps;
        last_error = error;
      }
      keep_largest((std::max)(number / width + 1, (number / width + capacity) / 2));
    }
    return false;
  }

  bool has_room_for_block() const { return width * (m_basis.size() + 1) <= m_operator.rows(); }

  bool has_converged(Eigen::Index number)
  {
    compute_Ritz_pairs();
    const Eigen::Index converged = (std::min)(number, number_converged());
    m_progress =
        (std::max)(m_progress, static_cast<double>(converged) / static_cast<double>(number));
    return converged == number;
  }

  // Multiplies the first pending block by A, and adds what is orthogonal to the basis to it.
  //
  // What T says about the product is subtracted anyway, and leaves errors of rounding, which grow
  // by the ratio of the largest eigenvalues to the coupling of the blocks from step to step. So
  // every other block stays loose: it is made orthogonal to all others together with the next one,
  // which reads the basis only once for both (\cgalCite{grimes_1994}). Its errors influence its
  // norm and T by their square only, which is nothing unless the coupling is tiny.
  void multiply_next()
  {
    constexpr double smallest_coupling = 1e-6;
    m_options.report_progress(m_progress);
    const Eigen::Index p = m_processed;
    CGAL_precondition(number_of_pending_blocks() > 0);
    CGAL_assertion(m_projected.rows() == width * m_basis.size());
    Row_block w = m_basis.new_block(m_operator.rows());
    multiply(p, w);
    Block_coefficients rest = Block_coefficients::identity();
    const bool is_loose = !m_is_loose && p + 1 == m_basis.size() &&
                          normalize(w, internal::transposed_product(w, w), rest) &&
                          internal::smallest_on_diagonal(rest) >= smallest_coupling * m_scale;
    if (!is_loose)
      rest = orthonormalize(w) * rest;
    m_is_loose = is_loose;
    ++m_processed;
    insert(m_basis.size(), std::move(w));
    set_coefficients(m_basis.size() - 1, p, rest);
  }

  // `w = A V_p`, without what is in the blocks that T tells about and in the pending ones, whose
  // coefficients become known.
  void multiply(Eigen::Index p, Row_block& w)
  {
    m_operator.apply(m_basis[p], w);
    // What T says already goes first, and then what cancels most: the coefficients of the pending
    // blocks.
    std::vector<std::pair<Eigen::Index, Block_coefficients>> known;
    for (Eigen::Index i = 0; i < p; ++i) {
      const Block_coefficients c = coefficients(i, p);
      if (!c.is_zero())
        known.emplace_back(i, c);
    }
    const std::vector<Block_coefficients> c = m_basis.subtract_and_project(known, p, w);
    for (Eigen::Index i = p; i < m_basis.size(); ++i)
      set_coefficients(i, p, c[static_cast<std::size_t>(i)]);
    m_scale = (std::max)(m_scale, internal::largest_on_diagonal(coefficients(p, p)));
  }

  // Makes the columns of w orthonormal and orthogonal to the basis, and the loose block as well.
  // Returns B such that the old w is the new one times B, up to what was in the basis.
  //
  // A block that is nearly dependent, as when an invariant space is exhausted, is rotated, such
  // that its columns are orthogonal; those that are nothing but rounding are replaced by random
  // ones, which B multiplies by zero.
  Block_coefficients orthonormalize(Row_block& w)
  {
    constexpr int max_passes = 6;
    constexpr double negligible = 1e-14;
    Block_coefficients b = Block_coefficients::identity();
    for (int pass = 0; pass < max_passes; ++pass) {
      const Block_coefficients square = m_basis.project_out_of(w, m_is_loose ? m_processed : -1);
      m_is_loose = false;
      if (normalize(w, square, b))
        return b;
      const Block_coefficients q = rotation(internal::transposed_product(w, w));
      const Block_coefficients squared_norms = internal::multiply_from_right(w, q);
      b = q.transposed() * b;
      for (int j = 0; j < width; ++j) {
        const double norm = std::sqrt(squared_norms(j, j));
        const bool is_negligible = !(norm > negligible * m_scale);
        if (is_negligible)
          make_random(w, j);
        const double factor = is_negligible ? 1 / column_norm(w, j) : 1 / norm;
        for (Eigen::Index i = 0; i < w.rows(); ++i)
          w(i, j) *= factor;
        for (int k = 0; k < width; ++k)
          b(j, k) = is_negligible ? 0 : norm * b(j, k);
      }
    }
    throw Numerical_error("the Lanczos vectors could not be made orthogonal");
  }

  // Makes the columns of w orthonormal, whose products `w^T w` are given, if they are not nearly
  // dependent; returns whether that is so. With the Cholesky factorization `w^T w = R^T R`,
  // `w = w R^-1` and `b = R b`. Twice, since the first time leaves errors of the square of the
  // condition number.
  static bool normalize(Row_block& w, const Block_coefficients& square, Block_coefficients& b)
  {
    constexpr double well_conditioned = 1e-2;
    Block_coefficients next_square = square;
    for (int i = 0; i < 2; ++i) {
      Block_coefficients r;
      if (!internal::factor_symmetric(next_square, r) ||
          !(internal::smallest_on_diagonal(r) >=
            well_conditioned * internal::largest_on_diagonal(r)))
        return false;
      next_square = internal::multiply_from_right(w, internal::inverse_of_upper_triangle(r));
      b = r * b;
    }
    return true;
  }

  // The eigenvectors of a symmetric matrix, as columns.
  static Block_coefficients rotation(const Block_coefficients& square)
  {
    const internal::Symmetric_eigenpairs pairs = internal::symmetric_eigenpairs(
        Eigen::Map<const Eigen::MatrixXd>(square.data(), width, width));
    if (!pairs.have_converged)
      throw Numerical_error("the eigenvectors of the products of a block did not converge");
    Block_coefficients result;
    for (int i = 0; i < width; ++i)
      for (int j = 0; j < width; ++j)
        result(i, j) = pairs.vectors(i, j);
    return result;
  }

  static double column_norm(const Row_block& w, int j)
  {
    double sum = 0;
    for (Eigen::Index i = 0; i < w.rows(); ++i)
      sum += w(i, j) * w(i, j);
    return std::sqrt(sum);
  }

  void make_random(Row_block& w, int j)
  {
    for (Eigen::Index i = 0; i < w.rows(); ++i)
      w(i, j) = m_random.next();
  }

  void insert_random_block(Eigen::Index position)
  {
    Row_block w = m_basis.new_block(m_operator.rows());
    for (Eigen::Index i = 0; i < w.rows(); ++i)
      for (Eigen::Index j = 0; j < width; ++j)
        w(i, j) = m_random.next();
    orthonormalize(w);
    insert(position, std::move(w));
  }

  void insert(Eigen::Index position, Row_block&& w)
  {
    m_basis.insert(position, std::move(w));
    const Eigen::Index old_size = m_projected.rows(), before = width * position,
                       after = old_size - before;
    Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(old_size + width, old_size + width);
    projected.topLeftCorner(before, before) = m_projected.topLeftCorner(before, before);
    projected.topRightCorner(before, after) = m_projected.topRightCorner(before, after);
    projected.bottomLeftCorner(after, before) = m_projected.bottomLeftCorner(after, before);
    projected.bottomRightCorner(after, after) = m_projected.bottomRightCorner(after, after);
    m_projected.swap(projected);
  }

  Block_coefficients coefficients(Eigen::Index i, Eigen::Index j) const
  {
    Block_coefficients result;
    for (int k = 0; k < width; ++k)
      for (int l = 0; l < width; ++l)
        result(k, l) = m_projected(width * i + k, width * j + l);
    return result;
  }

  // Of blocks i and j, and of j and i. Those of a block with itself are symmetric up to rounding.
  void set_coefficients(Eigen::Index i, Eigen::Index j, const Block_coefficients& c)
  {
    for (int k = 0; k < width; ++k)
      for (int l = 0; l < width; ++l) {
        const double x = i == j ? (c(k, l) + c(l, k)) / 2 : c(k, l);
        m_projected(width * i + k, width * j + l) = x;
        m_projected(width * j + l, width * i + k) = x;
      }
  }

  // The eigenpairs of the projection of A on the processed part of the basis, with decreasing
  // eigenvalues.
  void compute_Ritz_pairs()
  {
    const Eigen::Index size = width * m_processed;
    CGAL_precondition(m_processed > 0);
    const internal::Symmetric_eigenpairs pairs =
        internal::symmetric_eigenpairs(m_projected.topLeftCorner(size, size));
    if (!pairs.have_converged)
      throw Numerical_error("the eigenvalues of the projected matrix did not converge");
    const Eigen::Index pending = m_projected.rows() - size;
    // new matrices, since Eigen's frees its memory again if there is none for another size
    m_Ritz_values = Eigen::VectorXd(size);
    m_Ritz_vectors = Eigen::MatrixXd(size, size);
    m_Ritz_couplings = Eigen::MatrixXd(pending, size);
    m_Ritz_couplings.setZero();
    for (Eigen::Index j = 0; j < size; ++j) {
      m_Ritz_values[j] = pairs.values[size - 1 - j];
      m_Ritz_vectors.col(j) = pairs.vectors.col(size - 1 - j);
      double* const coupling = m_Ritz_couplings.data() + pending * j;
      for (Eigen::Index k = 0; k < size; ++k)
        for (Eigen::Index i = 0; i < pending; ++i)
          coupling[i] += m_projected(size + i, k) * m_Ritz_vectors(k, j);
    }
  }

  Eigen::Index number_converged() const
  {
    Eigen::Index number = 0;
    while (number < m_Ritz_values.size() &&
           m_Ritz_couplings.col(number).norm() <= m_tolerance * m_Ritz_values[number])
      ++number;
    return number;
  }

  // How far the worst of the `number` largest eigenpairs is from its tolerance.
  double largest_relative_coupling(Eigen::Index number) const
  {
    double result = 0;
    for (Eigen::Index i = 0; i < (std::min)(number, m_Ritz_values.size()); ++i)
      result = (std::max)(
          result, m_Ritz_couplings.col(i).norm() / (m_tolerance * std::abs(m_Ritz_values[i])));
    return result;
  }

  // Replaces the processed part of the basis by the first Ritz vectors, as many as fill `blocks`.
  void keep_largest(Eigen::Index blocks)
  {
    blocks = (std::min)(blocks, m_processed);
    const Eigen::Index kept = width * blocks, pending = width * number_of_pending_blocks();
    m_Ritz_values.conservativeResize(kept);
    m_Ritz_vectors.conservativeResize(Eigen::NoChange, kept);
    m_Ritz_couplings.conservativeResize(Eigen::NoChange, kept);
    m_basis.multiply_from_right(m_Ritz_vectors);
    m_processed = blocks;
    m_projected = Eigen::MatrixXd(Eigen::MatrixXd::Zero(kept + pending, kept + pending));
    m_projected.diagonal().head(kept) = m_Ritz_values;
    m_projected.bottomLeftCorner(pending, kept) = m_Ritz_couplings;
    m_projected.topRightCorner(kept, pending) = m_Ritz_couplings.transpose();
    m_Ritz_vectors = Eigen::MatrixXd(Eigen::MatrixXd::Identity(kept, kept));
  }

  // Whether no eigenvalue is missing among those found, which have all converged.
  //
  // A Krylov space of b random vectors holds all vectors of an eigenspace of dimension up to b,
  // with probability 1, and b vectors of a larger one. So only where b eigenvalues coincide, can
  // there be more of them. Where that is so, a space is searched that begins with another block of
  // random vectors, and with what was pending: it may hold a part of a missing vector. If one is
  // missing, the space has an eigenvalue more than were known that is as large. It would be seen as
  // soon as k steps, a Chebyshev polynomial of degree k, have made its component larger than those
  // of the next eigenvalues by about `exp(k acosh(2 / r - 1)) / 2`, if r is their ratio to it. At
  // the start the component of the best of eight random vectors of dimension n is less than `0.1 /
  // sqrt(n)` with a probability of 1e-11.
  bool is_complete(Eigen::Index number)
  {
    CGAL_precondition(0 < number && number <= number_converged());
    constexpr double coincidence = 1e-6;
    const double smallest = m_Ritz_values[number - 1];
    double suspect = 0; // the smallest eigenvalue of which there may be more
    for (Eigen::Index i = 0; i + m_number_of_random_vectors <= number; ++i) {
      const double last = m_Ritz_values[i + m_number_of_random_vectors - 1];
      // further ones of the last eigenvalue may be missing: there are as many as were wanted
      if (m_Ritz_values[i] - last <= coincidence * m_Ritz_values[i] &&
          last > (1 + coincidence) * smallest)
        suspect = last;
    }
    if (suspect == 0)
      return true;
    const double least = (1 - coincidence) * suspect;
    const Eigen::Index number_known = std::count_if(m_Ritz_values.data(),
                                                    m_Ritz_values.data() + number,
                                                    [=](double nu) { return nu >= least; });

    const Eigen::Index kept = 2 * number / width + 1;
    keep_largest(kept);
    // one may be there already, of a search that was interrupted
    if (width * number_of_pending_blocks() <= m_number_of_random_vectors)
      insert_random_block(m_processed);
    const double amplification = std::log(40 * std::sqrt(static_cast<double>(m_operator.rows())));
    Eigen::Index begin = m_processed;
    double next = 0; // the largest eigenvalue of what is searched, as far as it is known
    for (int degree = 0;; ++degree) {
      const Eigen::Index pending = number_of_pending_blocks();
      for (Eigen::Index i = 0; i < pending; ++i)
        multiply_next();
      const Eigen::VectorXd eigenvalues = eigenvalues_from(0);
      const bool is_missing = eigenvalues[eigenvalues.size() - 1 - number_known] >= least;
      const Eigen::VectorXd searched = eigenvalues_from(width * begin); // they increase
      next = (std::min)((std::max)(next, searched[searched.size() - 1]), least);
      // the other eigenvalues hide a missing one from the space, if they are close
      const double hiding = std::log((std::max)(1., next / (suspect - next))) / 2;
      const bool is_excluded =
          degree * std::acosh(2 * suspect / next - 1) >= amplification + hiding;
      const bool is_full =
          m_processed >= kept + 8 || width * (m_basis.size() + pending) > m_operator.rows();
      if (is_missing || is_excluded || is_full)
        compute_Ritz_pairs();
      if (is_missing || is_excluded) {
        m_number_of_random_vectors += width;
        return !is_missing && number_converged() >= number;
      }
      if (is_full) {
        keep_largest(kept);
        begin = m_processed;
      }
    }
  }

  // Of A restricted to what the vectors of the processed part of the basis from `first` on span,
  // increasing.
  Eigen::VectorXd eigenvalues_from(Eigen::Index first) const
  {
    const Eigen::Index size = width * m_processed - first;
    internal::Symmetric_eigenpairs pairs =
        internal::symmetric_eigenpairs(m_projected.block(first, first, size, size), false);
    if (!pairs.have_converged)
      throw Numerical_error("the eigenvalues of the projected matrix did not converge");
    return std::move(pairs.values);
  }

  Eigenpairs eigenpairs(Eigen::Index number, bool have_converged)
  {
    Eigenpairs result;
    result.have_converged = have_converged;
    result.values.resize(number);
    for (Eigen::Index i = 0; i < number; ++i)
      result.values[i] = m_operator.to_eigenvalue(m_Ritz_values[i]);
    if (number > 0) {
      keep_largest((number + width - 1) / width); // the basis itself has the eigenvectors then
      Row_block y = m_basis.new_block(m_operator.rows());
      m_basis.free_spare_memory(); // before there is more
      result.vectors.resize(m_operator.rows(), number);
      internal::prefer_huge_pages(result.vectors.data(),
                                  static_cast<std::size_t>(result.vectors.size()));
      for (Eigen::Index j = 0; j < number; j += width) {
        const Eigen::Index size = (std::min)(width, number - j);
        y = m_basis[j / width];
        m_operator.to_eigenfunctions(
            y, m_Ritz_values.data() + j, result.vectors.middleCols(j, size));
      }
    }
    m_options.report_progress(1);
    return result;
  }

  Eigensolver_options m_options;
  internal::Uniform_random_numbers m_random;
  double m_tolerance; // of an eigenpair (nu, y) of A: ||A y - nu y|| <= m_tolerance * nu
  internal::Shift_inverted_operator<SolverTraits> m_operator;
  internal::Block_basis m_basis;
  Eigen::Index m_processed = 0;
  Eigen::Index m_number_of_random_vectors = 0;
  Eigen::MatrixXd m_projected;
  double m_scale = 0; // about the largest eigenvalue of A
  Eigen::VectorXd m_Ritz_values;
  Eigen::MatrixXd m_Ritz_vectors;
  Eigen::MatrixXd m_Ritz_couplings; // the parts of `A y` in the pending blocks
  double m_progress = 0;
  bool m_is_loose = false; // whether the first pending block is not quite orthogonal to the others
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_BLOCK_LANCZOS_EIGENSOLVER_H
