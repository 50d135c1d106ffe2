// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_THROW_INTERNAL_ERROR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_THROW_INTERNAL_ERROR_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>

#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What the algorithms rule out has happened. That may be the fault of a mesh that no algorithm can
// see through, or of this package: who has the mesh checks it before the error goes on to the user.
[[noreturn]] CGAL_REEB_GRAPH_COLD inline void throw_internal_error(const char* what)
{
  throw Internal_error(std::string("internal error: ") + what + "; please report this as a bug");
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_THROW_INTERNAL_ERROR_H
