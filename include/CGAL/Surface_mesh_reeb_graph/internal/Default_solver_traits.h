// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_DEFAULT_SOLVER_TRAITS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_DEFAULT_SOLVER_TRAITS_H

#include <CGAL/Surface_mesh_reeb_graph/Supernodal_cholesky.h>

#include <CGAL/Eigen_solver_traits.h>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The direct solver that is used if the user chooses none; it is named here only.
using Default_solver_traits =
    CGAL::Eigen_solver_traits<Supernodal_cholesky<CGAL::Eigen_sparse_matrix<double>::EigenType>>;

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_DEFAULT_SOLVER_TRAITS_H
