// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_EIGENPAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_EIGENPAIRS_H

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

Solutions of *L psi = lambda M psi*: what a model of `LaplaceBeltramiEigensolver` returns.
*/
struct Eigenpairs
{
  /// the eigenvalues *lambda*, increasing
  Eigen::VectorXd values;
  /// the eigenvectors *psi*: a column for every value, *M*-orthonormal
  Eigen::MatrixXd vectors;
  /// `false` if the solver gave up; the pairs are then the smallest ones as far as they converged
  bool have_converged = true;
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_EIGENPAIRS_H
