// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_COORDINATES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_COORDINATES_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

template <class TriangleMesh, class VertexPointMap>
void check_coordinates(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  std::size_t number = 0;
  for (auto v : CGAL::make_range(vertices(tmesh))) {
    const auto& p = get(vertex_point_map, v);
    if (!std::isfinite(CGAL::to_double(p.x())) || !std::isfinite(CGAL::to_double(p.y())) ||
        !std::isfinite(CGAL::to_double(p.z())))
      throw Input_error("a coordinate of vertex " + std::to_string(number) +
                        " is not a finite number");
    ++number;
  }
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_COORDINATES_H
