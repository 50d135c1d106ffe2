// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ERROR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ERROR_H

#include <stdexcept>

namespace CGAL {
namespace Surface_mesh_reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The exception thrown when the *data* make a computation impossible: faces that are not triangles, a
value or a coordinate that is not a number, a surface without area, a factorization that failed, an
eigensolver that did not converge, a parameter out of its range. It is thrown in every build mode;
`what()` says what was found and where. All outputs of the function that throws are left as they
were.

Wrong use of a function that its caller can rule out (for example a number out of range for
`Laplace_beltrami_eigenbasis::eigenvalue()`) is a violated precondition instead, as everywhere in
\cgal.
*/
class Reeb_graph_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_ERROR_H
