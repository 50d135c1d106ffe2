// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the time of an eigensolver goes: a direct solver with a watch.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEASURED_SOLVER_TRAITS_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEASURED_SOLVER_TRAITS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Block_basis.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Shift_inverted_operator.h>

#include <Eigen/Core>

#include <cstddef>
#include <ctime>
#include <utility>

namespace Reeb_graph_benchmark {

// Seconds of processor time, of all threads: what other programs do meanwhile counts little.
template <class Task>
double processor_seconds_for(const Task& task)
{
  const std::clock_t start = std::clock();
  task();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// What the direct solvers took since it was last set to zero.
struct Direct_solver_times
{
  double factorization_seconds = 0;
  double solution_seconds = 0;
  std::size_t right_hand_sides = 0;
};
inline Direct_solver_times direct_solver_times;

// Does what `Traits`, a model of `SparseLinearAlgebraWithFactorTraits_d`, does, and takes the time.
// Blocks of right-hand sides go where the eigensolvers send them.
template <class Traits>
class Measured_solver_traits
{
  using Row_block = CGAL::Surface_mesh_Reeb_graph::internal::Row_block;

public:
  using NT = typename Traits::NT;
  using Matrix = typename Traits::Matrix;
  using Vector = typename Traits::Vector;

  bool factor(const Matrix& a, NT& determinant)
  {
    bool success = false;
    direct_solver_times.factorization_seconds +=
        processor_seconds_for([&]() { success = m_traits.factor(a, determinant); });
    return success;
  }

  bool linear_solver(const Vector& b, Vector& x)
  {
    bool success = false;
    take_time(1, [&]() { success = m_traits.linear_solver(b, x); });
    return success;
  }

  Measured_solver_traits& solver() { return *this; }

  void solve_in_place(Row_block& x)
  {
    take_time(std::size_t(x.cols()), [&]() {
      if constexpr (CGAL::Surface_mesh_Reeb_graph::internal::Solves_in_place<Traits>::value) {
        m_traits.solver().solve_in_place(x);
      } else {
        m_right_hand_sides = x;
        m_solutions = m_traits.solver().solve(m_right_hand_sides);
        x = m_solutions;
      }
    });
  }

  // Only where there is the same.
  template <class T = Traits>
  auto permutationP() -> decltype(std::declval<T&>().solver().permutationP())
  {
    return m_traits.solver().permutationP();
  }
  template <class T = Traits>
  auto solve_permuted_in_place(Row_block& x)
      -> decltype(std::declval<T&>().solver().solve_permuted_in_place(x))
  {
    take_time(std::size_t(x.cols()), [&]() { m_traits.solver().solve_permuted_in_place(x); });
  }

  Eigen::ComputationInfo info() { return m_traits.solver().info(); }

private:
  template <class Task>
  static void take_time(const std::size_t number, const Task& task)
  {
    direct_solver_times.solution_seconds += processor_seconds_for(task);
    direct_solver_times.right_hand_sides += number;
  }

  Traits m_traits;
  Eigen::MatrixXd m_right_hand_sides, m_solutions;
};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEASURED_SOLVER_TRAITS_H
