// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models of the concept LaplaceBeltramiEigensolver, with several direct solvers, on meshes and
// on matrices with many multiple eigenvalues, against dense matrices.

#define BOOST_TEST_MODULE eigensolvers
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"
#include "spectral_shapes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/Spectra_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
#include <malloc.h>
#define REEB_GRAPH_TEST_COUNTS_MEMORY
#endif

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

BOOST_AUTO_TEST_SUITE(solvers)

using Eigen_matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
using Cholesky_traits = CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Eigen_matrix>>;
using Lu_traits =
    CGAL::Eigen_solver_traits<Eigen::SparseLU<Eigen_matrix, Eigen::COLAMDOrdering<int>>>;

// A minimal model of `SparseLinearAlgebraWithFactorTraits_d`, with one right-hand side at a time;
// it fails on demand.
template <bool FACTORS = true, bool SOLVES = true>
class Minimal_traits
{
public:
  using NT = double;
  using Matrix = Cholesky_traits::Matrix;
  using Vector = Cholesky_traits::Vector;

  bool factor(const Matrix& matrix, NT& determinant)
  {
    return m_traits.factor(matrix, determinant) && FACTORS;
  }
  bool linear_solver(const Vector& right_hand_side, Vector& solution)
  {
    return m_traits.linear_solver(right_hand_side, solution) && SOLVES;
  }

private:
  Cholesky_traits m_traits;
};

// A solver with Eigen's interface that solves in place, too, and fails on demand.
template <bool IN_PLACE, bool SOLVES>
class Block_solver : public Eigen::SimplicialLLT<Eigen_matrix>
{
  using Base = Eigen::SimplicialLLT<Eigen_matrix>;

public:
  template <class Matrix, bool ENABLED = IN_PLACE, class = std::enable_if_t<ENABLED>>
  void solve_in_place(Matrix& x)
  {
    static_assert(Matrix::IsRowMajor && Matrix::ColsAtCompileTime == 8);
    x = Base::solve(Eigen::MatrixXd(x)).eval();
    ++number_of_solves();
  }
  Eigen::ComputationInfo info() const
  {
    return m_is_factored && !SOLVES ? Eigen::NumericalIssue : Base::info();
  }
  template <class Matrix>
  Block_solver& compute(const Matrix& matrix)
  {
    Base::compute(matrix);
    return *this;
  }
  template <class Right_hand_side>
  auto solve(const Right_hand_side& b)
  {
    m_is_factored = true;
    return Base::solve(b);
  }

  static int& number_of_solves()
  {
    static int number = 0;
    return number;
  }

private:
  bool m_is_factored = false;
};

template <class Eigensolver>
void check_same_basis(const Index_mesh& mesh)
{
  const Shape expected(mesh);
  const Shape_with_solver<Eigensolver> shape(mesh);
  BOOST_TEST(largest_relative_difference(shape.eigenvalues(), expected.eigenvalues()) <=
             eigenvalue_tolerance);
  BOOST_TEST(difference_of_distances(expected, shape, identity(mesh.points.size())) <=
             distance_tolerance);
  BOOST_TEST(shape.basis.residual() <= 1e-8);
}

BOOST_AUTO_TEST_CASE(direct_solvers_give_the_same_basis)
{
  using In_place = Block_solver<true, true>;
  for (const Index_mesh& mesh : {potato(3), sphere(2), grid(12, 9), tetrahedron()}) {
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Cholesky_traits>>(mesh);
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Lu_traits>>(mesh);
    check_same_basis<SMRG::Block_Lanczos_eigensolver<Minimal_traits<>>>(mesh);
    In_place::number_of_solves() = 0;
    check_same_basis<SMRG::Block_Lanczos_eigensolver<CGAL::Eigen_solver_traits<In_place>>>(mesh);
    BOOST_TEST(In_place::number_of_solves() > 0);
    check_same_basis<SMRG::Spectra_eigensolver<>>(mesh);
    check_same_basis<SMRG::Spectra_eigensolver<Minimal_traits<>>>(mesh);
  }
}

template <template <class> class Eigensolver>
void check_failures()
{
  // Lanczos and dense path
  for (const Index_mesh& mesh : {potato(2), tetrahedron()}) {
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Minimal_traits<false, true>>>>(mesh),
                        "factorization"));
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Minimal_traits<true, false>>>>(mesh),
                        "solution of a linear system failed"));
    using Failing = CGAL::Eigen_solver_traits<Block_solver<false, false>>;
    BOOST_TEST(contains(error_of<Shape_with_solver<Eigensolver<Failing>>>(mesh),
                        "solution of a linear system failed"));
    BOOST_TEST(error_of<Shape_with_solver<Eigensolver<Minimal_traits<>>>>(mesh) == "");
  }
}

BOOST_AUTO_TEST_CASE(solver_that_fails_is_an_error)
{
  check_failures<SMRG::Block_Lanczos_eigensolver>();
  check_failures<SMRG::Spectra_eigensolver>();
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(eigensolvers)

// Stiffness and mass matrix without a mesh.
struct Pencil
{
  // Of the eigenvalues up to the last one given: all there are, with multiplicity.
  Eigen::VectorXd smallest_eigenvalues(const Eigen::Index number) const
  {
    // Vertices without mass are eliminated: the Schur complement.
    std::vector<Eigen::Index> heavy, light;
    for (Eigen::Index i = 0; i < mass.size(); ++i)
      (mass[i] > 0 ? heavy : light).push_back(i);
    const Eigen::MatrixXd l = stiffness.toDense();
    Eigen::MatrixXd schur = l(heavy, heavy);
    if (!light.empty())
      schur -= l(heavy, light) * l(light, light).llt().solve(l(light, heavy).eval());
    const Eigen::VectorXd scale = mass(heavy).cwiseSqrt().cwiseInverse();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
               scale.asDiagonal() * schur * scale.asDiagonal(), Eigen::EigenvaluesOnly)
        .eigenvalues()
        .head(number);
  }

  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd mass;
  double shift;
};

Pencil pencil_of(const Index_mesh& mesh)
{
  const Reference_operator reference(mesh);
  return {reference.stiffness, reference.mass, 2 * pi / reference.mass.sum()};
}

// The graph Laplacian of the hypercube: the eigenvalue 2 k has multiplicity "dimension over k".
Pencil hypercube(const int dimension)
{
  const int n = 1 << dimension;
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) {
    triplets.emplace_back(i, i, dimension);
    for (int k = 0; k < dimension; ++k)
      triplets.emplace_back(i, i ^ (1 << k), -1);
  }
  Pencil result{{n, n}, Eigen::VectorXd::Ones(n), 1};
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

Pencil copies(const Pencil& pencil, const int number)
{
  const Eigen::Index n = pencil.mass.size();
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < number; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(pencil.stiffness, j); it; ++it)
        triplets.emplace_back(i * n + it.row(), i * n + it.col(), it.value());
  Pencil result{{number * n, number * n}, pencil.mass.replicate(number, 1), pencil.shift};
  result.stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

void check_pairs(const Pencil& pencil,
                 const SMRG::Eigenpairs& pairs,
                 const Eigen::VectorXd& expected)
{
  BOOST_TEST(pairs.have_converged);
  BOOST_REQUIRE_EQUAL(pairs.values.size(), expected.size());
  BOOST_REQUIRE_EQUAL(pairs.vectors.cols(), expected.size());
  BOOST_TEST(
      ((pairs.values - expected).array().abs() / (pencil.shift + expected.array())).maxCoeff() <=
      eigenvalue_tolerance);
  const Eigen::MatrixXd m_psi = pencil.mass.asDiagonal() * pairs.vectors;
  BOOST_TEST((pairs.vectors.transpose() * m_psi -
              Eigen::MatrixXd::Identity(expected.size(), expected.size()))
                 .cwiseAbs()
                 .maxCoeff() <= 1e-10);
  const Eigen::MatrixXd residual =
      pencil.stiffness * pairs.vectors - m_psi * pairs.values.asDiagonal();
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    BOOST_TEST(residual.col(i).norm() <=
               1e-10 * (pencil.shift + expected[i]) * m_psi.col(i).norm());
}

template <class Eigensolver>
void check_eigensolver(const Pencil& pencil,
                       const std::vector<Eigen::Index>& numbers,
                       const Eigen::VectorXd& expected,
                       const SMRG::Eigensolver_options& options = SMRG::Eigensolver_options())
{
  for (const Eigen::Index number : numbers) {
    BOOST_TEST_CONTEXT(number << " eigenpairs of " << pencil.mass.size())
    {
      Eigensolver solver(pencil.stiffness, pencil.mass, pencil.shift, options);
      check_pairs(pencil, solver.smallest(number), expected.head(number));
    }
  }
}

// Multiplicities far beyond the number of vectors that are iterated at a time, cut at all places.
BOOST_AUTO_TEST_CASE(multiple_eigenvalues_are_complete)
{
  for (const int dimension : {8, 10}) {
    const Pencil pencil = hypercube(dimension);
    std::vector<double> eigenvalues;
    for (Eigen::Index i = 0; i < pencil.mass.size(); ++i) {
      int bits = 0;
      for (Eigen::Index j = i; j > 0; j /= 2)
        bits += j % 2;
      eigenvalues.push_back(2 * bits);
    }
    std::sort(eigenvalues.begin(), eigenvalues.end());
    const Eigen::VectorXd expected =
        Eigen::Map<const Eigen::VectorXd>(eigenvalues.data(), pencil.mass.size());
    const std::vector<Eigen::Index> numbers = {1, 2, 8, 9, 10, 11, 12, 37, 38, 55, 56, 57, 64};
    check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, numbers, expected);
    check_eigensolver<SMRG::Spectra_eigensolver<>>(pencil, {1, 12, 38}, expected);
  }
}

BOOST_AUTO_TEST_CASE(identical_copies_have_identical_eigenvalues)
{
  // eigenvalue zero included
  for (const int number : {2, 5, 8, 9, 20}) {
    const Pencil pencil = copies(pencil_of(potato(1)), number);
    const Eigen::VectorXd expected = pencil.smallest_eigenvalues(60);
    check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
        pencil, {1, number, number + 1, 3 * number - 1, 60}, expected);
  }
}

// What is missing may lie in the vectors that are pending when all others have converged.
BOOST_AUTO_TEST_CASE(missing_eigenvalues_are_found_with_any_seed)
{
  const Pencil pencil = copies(pencil_of(potato(1)), 20);
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(60);
  SMRG::Eigensolver_options options;
  for (options.seed = 0; options.seed < 10; ++options.seed)
    BOOST_TEST_CONTEXT("seed " << options.seed)
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
      pencil, {17, 20, 21, 26, 45}, expected, options);
}

// As many copies as there are eigenpairs, in a space that has just room for the search for missing
// ones.
BOOST_AUTO_TEST_CASE(multiplicities_may_fill_small_spaces)
{
  constexpr Eigen::Index size = 221, multiplicity = 52, number = 49;
  Pencil pencil{{size, size}, Eigen::VectorXd::Ones(size), 1};
  Eigen::VectorXd expected(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    expected[i] = i < multiplicity ? 1 : 2 + 0.01 * static_cast<double>(i);
    pencil.stiffness.insert(i, i) = expected[i];
  }
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, {number}, expected);
}

// Wherever it was stopped, the first step and the search for missing eigenvalues included.
BOOST_AUTO_TEST_CASE(interrupted_solvers_go_on)
{
  const Pencil pencil = copies(pencil_of(potato(1)), 9);
  constexpr Eigen::Index number = 26;
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(number);
  int calls = 0, last_call = 0;
  SMRG::Eigensolver_options options;
  options.callback = [&](double) { return calls++ != last_call; };
  for (bool is_interrupted = true; is_interrupted; ++last_call) {
    BOOST_TEST_CONTEXT("interrupted at call " << last_call)
    {
      calls = 0;
      is_interrupted = false;
      try {
        SMRG::Block_Lanczos_eigensolver<> solver(
            pencil.stiffness, pencil.mass, pencil.shift, options);
        try {
          solver.smallest(number);
        } catch (const SMRG::Interruption&) {
          is_interrupted = true;
          check_pairs(pencil, solver.smallest(number), expected);
        }
      } catch (const SMRG::Interruption&) {
        is_interrupted = true; // by the constructor
      }
    }
  }
  BOOST_TEST(last_call > 20);
}

BOOST_AUTO_TEST_CASE(random_weights_agree_with_dense_matrices)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Pencil pencil = pencil_of(transformed(potato(2), [&rng](const std::array<double, 3>& p) {
        return std::array<double, 3>{p[0] + 0.05 * random_unit(rng),
                                     p[1] + 0.05 * random_unit(rng),
                                     p[2] + 0.05 * random_unit(rng)};
      }));
      // masses that differ by ten thousand, and none at some vertices
      for (Eigen::Index i = 0; i < pencil.mass.size(); ++i)
        pencil.mass[i] *= random_index(8, rng) == 0 ? 0 : std::pow(10., -4 * random_unit(rng));
      pencil.shift = 2 * pi / pencil.mass.sum();
      const std::vector<Eigen::Index> numbers = {
          static_cast<Eigen::Index>(1 + random_index(20, rng)), 22};
      const Eigen::VectorXd expected = pencil.smallest_eigenvalues(22);
      check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(pencil, numbers, expected);
      check_eigensolver<SMRG::Spectra_eigensolver<>>(pencil, numbers, expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(numbers_may_change_from_call_to_call)
{
  const Pencil pencil = pencil_of(sphere(3));
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(300);
  SMRG::Block_Lanczos_eigensolver<> solver(pencil.stiffness, pencil.mass, pencil.shift);
  for (const Eigen::Index number : {1, 9, 30, 5, 31, 80, 300, 40})
    check_pairs(pencil, solver.smallest(number), expected.head(number));
}

// Spherical harmonics of degrees 1 to 7: clusters of 3 to 15 eigenvalues that split into the
// smaller multiplicities of the icosahedron.
BOOST_AUTO_TEST_CASE(clusters_of_spheres_are_those_of_dense_matrices)
{
  const Pencil pencil = pencil_of(sphere(3));
  const Eigen::VectorXd expected = pencil.smallest_eigenvalues(64);
  check_eigensolver<SMRG::Block_Lanczos_eigensolver<>>(
      pencil, {4, 7, 16, 23, 25, 36, 40, 49, 64}, expected);
}

BOOST_AUTO_TEST_CASE(seeds_decide_about_rounding_only)
{
  const Index_mesh mesh = potato(3);
  const Shape shape(mesh, 20);
  const Shape same(mesh, SMRG::parameters::number_of_eigenpairs(20).random_seed(0));
  const Shape other(mesh, SMRG::parameters::number_of_eigenpairs(20).random_seed(1));
  BOOST_TEST((shape.eigenvalues() == same.eigenvalues()));
  BOOST_TEST((shape.eigenfunctions() == same.eigenfunctions()));
  BOOST_TEST((shape.eigenfunctions() != other.eigenfunctions()));
  BOOST_TEST(largest_relative_difference(shape.eigenvalues(), other.eigenvalues()) <=
             eigenvalue_tolerance);
  BOOST_TEST(difference_of_distances(shape, other, identity(mesh.points.size())) <=
             distance_tolerance);
}

BOOST_AUTO_TEST_CASE(certificates_are_what_the_test_computes)
{
  for (const Index_mesh& mesh : {potato(3), sphere(3), grid(20, 15), tetrahedron()}) {
    const Shape shape(mesh, 20);
    const Eigen::VectorXd mass = Reference_operator(mesh).mass;
    const Eigen::MatrixXd psi = shape.eigenfunctions();
    const Eigen::MatrixXd gram = psi.transpose() * mass.asDiagonal() * psi;
    const double error =
        (gram - Eigen::MatrixXd::Identity(psi.cols(), psi.cols())).cwiseAbs().maxCoeff();
    BOOST_TEST(shape.basis.orthonormality_error() <= 1e-10);
    // it has the constant function in addition; the rest is rounding
    BOOST_TEST(error <= shape.basis.orthonormality_error() + 1e-13);
    BOOST_TEST(shape.basis.null_space_residual() <= 4 * epsilon);
  }
}

BOOST_AUTO_TEST_CASE(extension_to_the_gap_can_be_turned_off)
{
  for (const Index_mesh& mesh : {sphere(2), symmetric_cube(), grid(9, 9), potato(2)}) {
    const Eigen::VectorXd all = Reference_operator(mesh).eigenvalues();
    for (const int number : {1, 2, 5, 10, 24}) {
      const Shape shape(mesh, SMRG::parameters::number_of_eigenpairs(number).extend_to_gap(false));
      BOOST_TEST(shape.basis.number_of_eigenpairs(0) == static_cast<std::size_t>(number));
      BOOST_TEST(largest_relative_difference(shape.eigenvalues(), all.segment(1, number)) <=
                 eigenvalue_tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(callback_is_told_the_progress)
{
  Index_mesh mesh = potato(3);
  append(mesh, tetrahedron(), 9);
  append(mesh, sphere(2), 20);
  std::vector<double> progress;
  const auto callback = [&progress](const double part) {
    progress.push_back(part);
    return true;
  };
  const Shape shape(mesh, SMRG::parameters::number_of_eigenpairs(12).callback(callback));
  BOOST_REQUIRE(progress.size() > 10);
  BOOST_TEST(progress.front() == 0);
  BOOST_TEST(progress.back() == 1);
  BOOST_TEST(std::is_sorted(progress.begin(), progress.end()));
}

template <class Eigensolver>
void check_interruption(const int number_of_calls)
{
  for (int last = 0; last < number_of_calls; ++last) {
    int calls = 0;
    const auto callback = [&calls, last](double) { return calls++ < last; };
    BOOST_CHECK_THROW(
        (Shape_with_solver<Eigensolver>(
            potato(3), SMRG::parameters::number_of_eigenpairs(12).callback(callback))),
        SMRG::Interruption);
    BOOST_TEST(calls == last + 1); // not called again
  }
}

BOOST_AUTO_TEST_CASE(callback_interrupts)
{
  check_interruption<SMRG::Block_Lanczos_eigensolver<>>(8);
  check_interruption<SMRG::Spectra_eigensolver<>>(8);
}

// A minimal model of `LaplaceBeltramiEigensolver`. It is told by the first pair that it spoils, and
// by the number of pairs that it finds at most, how to fail.
struct Dense_eigensolver
{
  Dense_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                    const Eigen::VectorXd& mass,
                    double,
                    const SMRG::Eigensolver_options&)
    : solver(stiffness.toDense(), mass.asDiagonal().toDenseMatrix())
  {}

  SMRG::Eigenpairs smallest(Eigen::Index number)
  {
    number = (std::min)(number, solver.eigenvalues().size());
    SMRG::Eigenpairs pairs;
    pairs.have_converged = number <= found;
    number = (std::min)(number, found);
    pairs.values = solver.eigenvalues().head(number);
    pairs.vectors = solver.eigenvectors().leftCols(number);
    if (spoiled < number)
      pairs.vectors(0, spoiled) += 1e-3;
    return pairs;
  }

  Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  static Eigen::Index found, spoiled;
};

Eigen::Index Dense_eigensolver::found = std::numeric_limits<Eigen::Index>::max();
Eigen::Index Dense_eigensolver::spoiled = std::numeric_limits<Eigen::Index>::max();

BOOST_AUTO_TEST_CASE(eigensolver_of_the_user_gives_the_same_basis)
{
  for (const Index_mesh& mesh : {potato(2), sphere(2), grid(12, 9), tetrahedron()})
    solvers::check_same_basis<Dense_eigensolver>(mesh);
}

BOOST_AUTO_TEST_CASE(converged_part_is_accepted_on_request)
{
  using Dense_shape = Shape_with_solver<Dense_eigensolver>;
  const Index_mesh mesh = potato(2);
  const Shape expected(mesh, 20);
  const auto strict = SMRG::parameters::number_of_eigenpairs(20);
  const auto lenient = strict.accept_converged_part(true);
  const Eigen::Index all = std::numeric_limits<Eigen::Index>::max();
  for (const auto& [found, spoiled, number] : {std::array<Eigen::Index, 3>{12, all, 11},
                                               std::array<Eigen::Index, 3>{all, 5, 4},
                                               std::array<Eigen::Index, 3>{12, 5, 4},
                                               std::array<Eigen::Index, 3>{all, 1, 0},
                                               std::array<Eigen::Index, 3>{1, all, 0},
                                               std::array<Eigen::Index, 3>{0, all, 0}})
  {
    Dense_eigensolver::found = found;
    Dense_eigensolver::spoiled = spoiled;
    const std::string message = error_of<Dense_shape>(mesh, strict);
    if (found < all)
      BOOST_TEST(contains(message,
                          "found " + std::to_string((std::max)(found - 1, Eigen::Index(0))) +
                              " of 20 eigenpairs"));
    else
      BOOST_TEST(contains(message, "eigenpair " + std::to_string(spoiled) + " has"));
    const Dense_shape shape(mesh, lenient);
    BOOST_TEST(is_sound(shape));
    BOOST_TEST(
        largest_relative_difference(shape.eigenvalues(), expected.eigenvalues().head(number)) <=
        eigenvalue_tolerance);
  }
  Dense_eigensolver::found = Dense_eigensolver::spoiled = all;
}

#ifdef REEB_GRAPH_TEST_COUNTS_MEMORY
// Counted whenever the solver reports its progress. Where malloc() is not that of glibc, as with a
// sanitizer, the count is zero.
BOOST_AUTO_TEST_CASE(memory_is_bounded)
{
  const Pencil pencil = pencil_of(potato(5));
  const auto allocated = [] {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  const double before = allocated();
  double most = 0;
  SMRG::Eigensolver_options options;
  options.callback = [&](double) {
    most = (std::max)(most, allocated() - before);
    return true;
  };
  SMRG::Block_Lanczos_eigensolver<> solver(pencil.stiffness, pencil.mass, pencil.shift, options);
  const SMRG::Eigenpairs pairs = solver.smallest(52);
  BOOST_TEST(pairs.have_converged);
  // of what a component has in all, 2500 bytes for every vertex, the mesh and its matrices need 200
  BOOST_TEST(most <= 2300. * static_cast<double>(pencil.mass.size()));
}
#endif

BOOST_AUTO_TEST_SUITE_END()
