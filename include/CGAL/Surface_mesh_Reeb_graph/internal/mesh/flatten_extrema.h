// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_FLATTEN_EXTREMA_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_FLATTEN_EXTREMA_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Raises values by the least amounts such that from every vertex of a component a path on which they
// never increase leads to one of the kept vertices: then no minimum, and no plateau that is one, is
// elsewhere. This is the priority flood (Barnes, Lehman, Mulla, "Priority-flood: an optimal
// depression-filling and watershed-labeling algorithm for digital elevation models", 2014). It makes
// no new maximum. Values and kept vertices are given by positions in the component.
template <class TriangleMesh>
void flatten_minima(const TriangleMesh& tmesh,
                    const Mesh_components<TriangleMesh>& components,
                    std::size_t component_number,
                    const std::vector<std::size_t>& kept,
                    std::vector<double>& values)
{
  const auto& component_vertices = components[component_number].vertices;
  CGAL_precondition(values.size() == component_vertices.size());
  using Entry = std::pair<double, std::size_t>; // value, position
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
  std::vector<bool> is_reached(values.size(), false);
  for (const std::size_t i : kept) {
    is_reached[i] = true;
    front.emplace(values[i], i);
  }
  while (!front.empty()) {
    const Entry lowest = front.top();
    front.pop();
    for_each_neighbor(component_vertices[lowest.second], tmesh, [&](auto neighbor) {
      const std::size_t i = components.position_of(neighbor);
      if (is_reached[i])
        return;
      is_reached[i] = true;
      if (values[i] < lowest.first)
        values[i] = lowest.first;
      front.emplace(values[i], i);
    });
  }
}

// The same with maxima, which are lowered. If there was no minimum but the kept ones before, there is
// none afterwards.
template <class TriangleMesh>
void flatten_maxima(const TriangleMesh& tmesh,
                    const Mesh_components<TriangleMesh>& components,
                    std::size_t component_number,
                    const std::vector<std::size_t>& kept,
                    std::vector<double>& values)
{
  const auto turn_upside_down = [&]() {
    for (double& value : values)
      value = 0 - value; // no negative zeros
  };
  turn_upside_down();
  flatten_minima(tmesh, components, component_number, kept, values);
  turn_upside_down();
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_FLATTEN_EXTREMA_H
