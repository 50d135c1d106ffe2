// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DIRECT_SOLVER_TRAITS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DIRECT_SOLVER_TRAITS_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A model of `LaplaceBeltramiFactorizationTraits` with a solver that has Eigen's interface.
//
// `CGAL::Eigen_solver_traits` with the same solver would do, but its header brings the iterative
// solvers of Eigen along, and its matrices are assembled entry by entry.
template <class Solver>
class Direct_solver_traits
{
public:
  using NT = double;
  using Matrix = Eigen::SparseMatrix<double>;

  class Vector : public Eigen::VectorXd
  {
  public:
    using Eigen::VectorXd::VectorXd;
    void set(Eigen::Index i, double value) { (*this)[i] = value; }
  };

  bool factor(const Matrix& matrix, NT&)
  {
    m_solver->compute(matrix);
    return m_solver->info() == Eigen::Success;
  }

  bool linear_solver(const Vector& right_hand_side, Vector& solution)
  {
    static_cast<Eigen::VectorXd&>(solution) = m_solver->solve(right_hand_side);
    return m_solver->info() == Eigen::Success;
  }

  Solver& solver() { return *m_solver; }

private:
  // shared by copies, as these traits are arguments, whose type only counts
  std::shared_ptr<Solver> m_solver = std::make_shared<Solver>();
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DIRECT_SOLVER_TRAITS_H
