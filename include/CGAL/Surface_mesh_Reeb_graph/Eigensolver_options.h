// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_EIGENSOLVER_OPTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_EIGENSOLVER_OPTIONS_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <cstdint>
#include <functional>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

What a model of `LaplaceBeltramiEigensolver` is told beside its matrices.
*/
struct Eigensolver_options
{
  /// the relative residual `||L psi - lambda M psi|| / (lambda ||M psi||)` that no eigenpair may
  /// exceed (the caller verifies it)
  double residual_tolerance = 1e-8;
  /// seed of all random numbers: equal seeds give equal results
  std::uint64_t seed = 0;
  /// receives the progress, in [0,1], and returns whether to go on; may be empty
  std::function<bool(double)> callback;

  /// tells the callback, if there is one, that the part `progress` of the work is done.
  /// \throws Interruption if it does not want to go on
  void report_progress(double progress) const
  {
    if (callback && !callback(progress))
      throw Interruption();
  }
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_EIGENSOLVER_OPTIONS_H
