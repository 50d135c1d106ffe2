// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_POINT_MAP_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_POINT_MAP_H

#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The named parameter `vertex_point_map`, by default the map of the mesh.
template <class TriangleMesh, class NamedParameters>
auto vertex_point_map(const TriangleMesh& tmesh, const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
      CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_POINT_MAP_H
