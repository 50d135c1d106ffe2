// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_SOLVER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_SOLVER_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/Register_vector.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/cholesky/panel_kernels.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Substitution with the columns of one supernode of a Cholesky factor, stored as a panel by
// columns, for `Columns` right-hand sides stored by rows. `x` are the rows of the pivots, `y` those
// below.
template <class Scalar, int Columns>
class Panel_solver
{
  using Index = Eigen::Index;
  using Row = Register_vector<Scalar, Columns>;

  static constexpr bool has_kernels = Columns == kernel_columns;

public:
  Panel_solver(const Scalar* panel, const Index width, const Index below)
    : m_panel(panel), m_width(width), m_below(below), m_rows(width + below)
  {}

  // x := L11^-1 x, y := y - L21 x
  void forward(Scalar* x, Scalar* y) const
  {
    Index j = 0;
    for (; j + 4 <= m_width; j += 4)
      forward_columns<4>(j, x, y);
    switch (m_width - j) {
    case 3:
      forward_columns<3>(j, x, y);
      break;
    case 2:
      forward_columns<2>(j, x, y);
      break;
    case 1:
      forward_columns<1>(j, x, y);
    }
  }

  // x := L11^-T (x - L21^T y)
  void backward(Scalar* x, const Scalar* y) const
  {
    Index j = m_width;
    for (; j >= 4; j -= 4)
      backward_columns<4>(j - 4, x, y);
    switch (j) {
    case 3:
      backward_columns<3>(0, x, y);
      break;
    case 2:
      backward_columns<2>(0, x, y);
      break;
    case 1:
      backward_columns<1>(0, x, y);
    }
  }

private:
  const Scalar* column(const Index j) const { return m_panel + j * m_rows; }

  template <int Number>
  void forward_columns(const Index j, Scalar* x, Scalar* y) const
  {
    Scalar* const x_j = x + j * Columns;
    if constexpr (has_kernels) {
      run_kernel<Substitute_forward<Scalar, Number>>(
          column(j) + j, m_rows, m_width - j - Number, m_below, x_j, y);
    } else {
      forward_columns_by_rows<Number>(j, x_j, y);
    }
  }

  template <int Number>
  void forward_columns_by_rows(const Index j, Scalar* x_j, Scalar* y) const
  {
    for (int k = 0; k < Number; ++k) {
      const Scalar* const l = column(j + k) + j;
      Row row = Row::load(x_j + k * Columns);
      row.multiply(1 / l[k]);
      row.store(x_j + k * Columns);
      for (int i = k + 1; i < Number; ++i) {
        Row next = Row::load(x_j + i * Columns);
        next.subtract(l[i], row);
        next.store(x_j + i * Columns);
      }
    }
    const Scalar* const l = column(j);
    subtract<Number>(l + j + Number, m_width - j - Number, x_j, x_j + Number * Columns);
    subtract<Number>(l + m_width, m_below, x_j, y);
  }

  // Subtracts from the rows at `to` the product of the panel at `l` with the rows at `x`.
  template <int Number>
  void subtract(const Scalar* l, const Index rows, const Scalar* x, Scalar* to) const
  {
    if constexpr (Columns == 1) {
      using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
      Eigen::Map<Vector> result(to, rows);
      const auto term = [&](const int k) {
        return Eigen::Map<const Vector>(l + k * m_rows, rows) * x[k];
      };
      if constexpr (Number == 4)
        result -= (term(0) + term(1)) + (term(2) + term(3));
      else if constexpr (Number == 3)
        result -= term(0) + term(1) + term(2);
      else if constexpr (Number == 2)
        result -= term(0) + term(1);
      else
        result -= term(0);
      return;
    }
    for (Index i = 0; i < rows; ++i, ++l, to += Columns) {
      Row row = Row::load(to);
      row.subtract(l[0], Row::load(x));
      if constexpr (Number > 1)
        row.subtract(l[m_rows], Row::load(x + Columns));
      if constexpr (Number > 2)
        row.subtract(l[2 * m_rows], Row::load(x + 2 * Columns));
      if constexpr (Number > 3)
        row.subtract(l[3 * m_rows], Row::load(x + 3 * Columns));
      row.store(to);
    }
  }

  template <int Number>
  void backward_columns(const Index j, Scalar* x, const Scalar* y) const
  {
    Scalar* const x_j = x + j * Columns;
    if constexpr (has_kernels) {
      run_kernel<Substitute_backward<Scalar, Number>>(
          column(j) + j, m_rows, m_width - j - Number, m_below, x_j, y);
    } else {
      backward_columns_by_rows<Number>(j, x_j, y);
    }
  }

  template <int Number>
  void backward_columns_by_rows(const Index j, Scalar* x_j, const Scalar* y) const
  {
    const Scalar* const l = column(j);
    subtract_transposed<Number>(l + m_width, m_below, y, x_j);
    subtract_transposed<Number>(l + j + Number, m_width - j - Number, x_j + Number * Columns, x_j);
    for (int k = Number - 1; k >= 0; --k) {
      const Scalar* const l_k = column(j + k) + j;
      Row row = Row::load(x_j + k * Columns);
      for (int i = k + 1; i < Number; ++i)
        row.subtract(l_k[i], Row::load(x_j + i * Columns));
      row.multiply(1 / l_k[k]);
      row.store(x_j + k * Columns);
    }
  }

  // Subtracts from the rows at `to` the product of the transposed panel at `l` with the rows at
  // `y`.
  template <int Number>
  void subtract_transposed(const Scalar* l, const Index rows, const Scalar* y, Scalar* to) const
  {
    if constexpr (Columns == 1) {
      using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
      const Eigen::Map<const Vector> rhs(y, rows);
      for (int k = 0; k < Number; ++k)
        to[k] -= Eigen::Map<const Vector>(l + k * m_rows, rows).dot(rhs);
      return;
    }
    if constexpr (Number > 2) { // more do not fit into the registers
      subtract_transposed<2>(l, rows, y, to);
      subtract_transposed<Number - 2>(l + 2 * m_rows, rows, y, to + 2 * Columns);
      return;
    }
    Row first = Row::load(to);
    Row last = Row::load(to + (Number - 1) * Columns);
    for (Index i = 0; i < rows; ++i, ++l, y += Columns) {
      const Row row = Row::load(y);
      first.subtract(l[0], row);
      if constexpr (Number > 1)
        last.subtract(l[m_rows], row);
    }
    first.store(to);
    if constexpr (Number > 1)
      last.store(to + Columns);
  }

  const Scalar* m_panel;
  Index m_width, m_below, m_rows;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_PANEL_SOLVER_H
