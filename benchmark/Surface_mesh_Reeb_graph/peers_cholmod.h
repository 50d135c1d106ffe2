// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The supernodal Cholesky factorization of SuiteSparse.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_CHOLMOD_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_CHOLMOD_H

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/CholmodSupport>

namespace Reeb_graph_benchmark {

class Cholmod_solver
  : public Eigen::CholmodSupernodalLLT<CGAL::Eigen_sparse_matrix<double>::EigenType>
{
public:
  Cholmod_solver()
  {
    // Others give less fill here, but take longer than that saves in a single factorization.
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().postorder = 1;
  }
};

using Cholmod_solver_traits = CGAL::Eigen_solver_traits<Cholmod_solver>;

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_CHOLMOD_H
