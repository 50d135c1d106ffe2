// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_ZERO_PERSISTENCE_PAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_ZERO_PERSISTENCE_PAIRS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Cancels the pairs of persistence zero, which only plateaus produce.
template <class TriangleMesh, class VertexIndexMap, class VertexOrder>
CGAL_REEB_GRAPH_COLD void cancel_zero_persistence_pairs(Arc_list<TriangleMesh>& list,
                                                        const TriangleMesh& tmesh,
                                                        VertexIndexMap vertex_index_map,
                                                        const VertexOrder& order)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  // only equality of values matters here: they are numbered in increasing order
  std::vector<double> values(list.nodes.size(), 0.);
  for (std::size_t i = 1; i < values.size(); ++i)
    values[i] =
        values[i - 1] + (order.value(list.nodes[i - 1]) < order.value(list.nodes[i]) ? 1. : 0.);

  Folded_graph folded(values.size(), list.arcs);
  cancel_branches(folded, values, [](const Extremum_pair&) { return false; });
  const Compacted_graph remaining(folded);

  const auto arc_after = [&](std::uint32_t arc, vertex_descriptor v) {
    return remaining.position_of_arc[folded.arc_after(
        arc, [&](std::uint32_t node) { return order(v, list.nodes[node]); })];
  };
  if (!list.arc_of_vertex.empty()) {
    for (const vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
      std::uint32_t& arc = list.arc_of_vertex[get(vertex_index_map, v)];
      if (arc != no_arc)
        arc = arc_after(arc, v);
    }
  }
  for (auto& wedge : list.upper_wedges)
    wedge.arc = arc_after(wedge.arc, target(wedge.halfedge, tmesh));

  std::vector<vertex_descriptor> nodes;
  nodes.reserve(remaining.nodes.size());
  for (const std::uint32_t node : remaining.nodes)
    nodes.push_back(list.nodes[node]);
  list.nodes = std::move(nodes);
  list.arcs = remaining.arcs;
  if (!list.arc_of_vertex.empty())
    list.set_arcs_of_nodes(vertex_index_map);
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_ZERO_PERSISTENCE_PAIRS_H
