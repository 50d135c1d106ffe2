// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ALGORITHM_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ALGORITHM_H

namespace CGAL {
namespace Surface_mesh_reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The algorithms of `compute_reeb_graph()`, for its named parameter `algorithm`. All of them give the
same graph.
*/
enum class Reeb_graph_algorithm {
  /// `CUTTING`, unless that would take too long: then `SWEEP`; on a mesh without border, and if
  /// neither a map nor `Reeb_arc::vertices` is filled, only through the levels between which loops
  /// may be closed, as long as these hold no more than half of the vertices
  AUTOMATIC,
  /// goes from the critical vertices along monotone paths, and cuts the surface where loops are
  /// closed. Takes O(*n* + *t* log *t*) time for *n* vertices, *t* of which are critical, plus the
  /// lengths of the components of level sets that are cut, for which there is no good bound if
  /// there are many loops
  CUTTING,
  /// follows the components of the level set from the lowest vertex to the highest. Takes O(*n* log
  /// *n*) time, whatever the surface and the function
  SWEEP
};

} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ALGORITHM_H
