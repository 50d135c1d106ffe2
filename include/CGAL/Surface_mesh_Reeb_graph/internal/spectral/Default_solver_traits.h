// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DEFAULT_SOLVER_TRAITS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DEFAULT_SOLVER_TRAITS_H

#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Direct_solver_traits.h>

#include <Eigen/SparseCore>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The direct solver that is used if the user chooses none; it is named here only.
using Default_solver_traits =
    Direct_solver_traits<Supernodal_Cholesky<Eigen::SparseMatrix<double>>>;

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_DEFAULT_SOLVER_TRAITS_H
