// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_HEAT_SOLVER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_HEAT_SOLVER_H

#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A direct solver for the heat method, with the interface of Eigen's solvers, whose heat does not end
// where the numbers do. Heat falls by about 1/e with every edge, so that some 700 edges away from the
// source it is less than the smallest double. Where that happens, the logarithm of the heat is
// returned instead, plus a constant that makes it positive: the method looks only at the directions of
// the gradients, which are those of the heat but for what the faces do not resolve.
class Heat_solver
{
public:
  using Scalar = double;
  using MatrixType = Eigen::SparseMatrix<double>;

  // \pre `a` is symmetric
  Heat_solver& compute(const MatrixType& a)
  {
    CGAL_precondition(a.rows() == a.cols());
    m_matrix = a; // what is given is gone when it is solved
    m_factor.compute(a);
    return *this;
  }

  Eigen::ComputationInfo info() const { return m_factor.info(); }

  template <class RightHandSide>
  Eigen::VectorXd solve(const RightHandSide& right_hand_side) const
  {
    CGAL_precondition(right_hand_side.rows() == m_matrix.rows());
    const Eigen::VectorXd b = right_hand_side;
    const Eigen::VectorXd x = m_factor.solve(b);
    // only heat has sources without sinks
    const bool is_heat = b.size() > 0 && b.minCoeff() >= 0 && b.maxCoeff() > 0;
    return is_heat && x.cwiseAbs().minCoeff() < (std::numeric_limits<double>::min)() ? logarithms(x)
                                                                                     : x;
  }

private:
  // Let the solution be known on a set N and unknown on the rest F. What remains, x on F and zero on N,
  // solves the system with the right-hand side -A_FN x_N on F and A_NF x_F on N, which is not zero
  // only where N and F meet: it is scaled, and solved for the next set.
  Eigen::VectorXd logarithms(Eigen::VectorXd x) const
  {
    constexpr double smallest = 1e-200;
    const Eigen::Index n = x.size();
    double scale = x.cwiseAbs().maxCoeff(), logarithm_of_scale = std::log(scale);
    Eigen::VectorXd result(n);
    constexpr int unknown = -1;
    std::vector<int> turn(static_cast<std::size_t>(n), unknown); // when an entry became known
    const auto turn_of = [&](Eigen::Index i) -> int& { return turn[static_cast<std::size_t>(i)]; };
    Eigen::Index number_of_known = 0;
    for (int i = 0; scale > 0; ++i) {
      x /= scale;
      const Eigen::Index number_before = number_of_known;
      for (Eigen::Index v = 0; v < n; ++v)
        if (turn_of(v) == unknown && std::abs(x[v]) >= smallest) {
          turn_of(v) = i;
          result[v] = std::log(std::abs(x[v])) + logarithm_of_scale;
          ++number_of_known;
        }
      if (number_of_known == n || number_of_known == number_before)
        break;
      Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
      for (Eigen::Index v = 0; v < n; ++v)
        if (turn_of(v) == i)
          for (MatrixType::InnerIterator it(m_matrix, v); it; ++it)
            if (turn_of(it.row()) == unknown) {
              b[it.row()] -= it.value() * x[v] / smallest;
              b[v] += it.value() * x[it.row()] / smallest;
            }
      x = m_factor.solve(b);
      scale = 0;
      for (Eigen::Index v = 0; v < n; ++v)
        if (turn_of(v) == unknown)
          scale = (std::max)(scale, std::abs(x[v]));
      logarithm_of_scale += std::log(smallest) + (scale > 0 ? std::log(scale) : 0);
    }
    double least = (std::numeric_limits<double>::infinity)();
    for (Eigen::Index v = 0; v < n; ++v)
      if (turn_of(v) != unknown)
        least = (std::min)(least, result[v]);
    for (Eigen::Index v = 0; v < n; ++v)
      result[v] = turn_of(v) == unknown ? 1 : result[v] - least + 1;
    return result;
  }

  MatrixType m_matrix;
  Supernodal_Cholesky<MatrixType> m_factor;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_HEAT_SOLVER_H
