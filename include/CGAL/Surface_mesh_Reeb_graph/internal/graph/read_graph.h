// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Reads nodes and arcs, each at the position of its number.
template <class Graph>
void read_graph(const Graph& graph,
                std::vector<Node_bundle<Graph>>& nodes,
                std::vector<Arc_bundle<Graph>>& arcs,
                std::vector<Arc_ends>& ends)
{
  const auto node_map = get(boost::vertex_bundle, graph);
  const auto arc_map = get(boost::edge_bundle, graph);
  nodes.resize(num_vertices(graph));
  arcs.resize(num_edges(graph));
  ends.resize(arcs.size());
  std::vector<bool> is_node_read(nodes.size(), false), is_arc_read(arcs.size(), false);
  for (auto n : CGAL::make_range(vertices(graph))) {
    const std::size_t i = node_map[n].id;
    if (i >= nodes.size() || is_node_read[i])
      throw Input_error("the nodes of the Reeb graph are not numbered from 0 without gaps");
    if (!CGAL::is_valid(node_map[n].value))
      throw Input_error("the value of node " + std::to_string(i) + " is not a number");
    nodes[i] = node_map[n];
    is_node_read[i] = true;
  }
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i].value < nodes[i - 1].value)
      throw Input_error("the values of the nodes of the Reeb graph do not increase with their "
                        "numbers");
  for (auto e : CGAL::make_range(edges(graph))) {
    const std::size_t i = arc_map[e].id;
    if (i >= arcs.size() || is_arc_read[i])
      throw Input_error("the arcs of the Reeb graph are not numbered from 0 without gaps");
    arcs[i] = arc_map[e];
    is_arc_read[i] = true;
    const std::pair<std::size_t, std::size_t> ids =
        std::minmax({node_map[source(e, graph)].id, node_map[target(e, graph)].id});
    if (ids.first == ids.second)
      throw Input_error("an arc of the Reeb graph begins and ends at the same node");
    ends[i] = {static_cast<std::uint32_t>(ids.first), static_cast<std::uint32_t>(ids.second)};
  }
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H
