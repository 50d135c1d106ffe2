// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_INTERRUPTED_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_INTERRUPTED_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>

namespace CGAL {
namespace Surface_mesh_reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The exception thrown when the function that the user gave by the named parameter `callback` returned
`false`. Nothing is wrong with the data then. All outputs are left as they were.
*/
class Reeb_graph_interrupted : public Reeb_graph_error
{
public:
  using Reeb_graph_error::Reeb_graph_error;
};

} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_INTERRUPTED_H
