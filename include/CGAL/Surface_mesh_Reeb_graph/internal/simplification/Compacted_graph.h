// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPACTED_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPACTED_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What folding leaves of a Reeb graph, in terms of the graph before.
struct Compacted_graph
{
  std::vector<std::uint32_t> nodes;             // numbers of the nodes that are left, increasing
  std::vector<Arc_ends> arcs;                   // between positions in `nodes`
  std::vector<std::uint32_t> first_arc_of_node; // begins there, or else ends there; by position
  std::vector<std::uint32_t> position_of_arc;   // by the arcs of the folded graph
};

inline Compacted_graph compacted_graph(const Folded_graph& folded, std::size_t number_of_nodes)
{
  Compacted_graph result;
  std::vector<std::uint32_t> position_of_node(number_of_nodes, no_node);
  for (std::uint32_t node = 0; node < number_of_nodes; ++node) {
    if (folded.is_node(node)) {
      position_of_node[node] = static_cast<std::uint32_t>(result.nodes.size());
      result.nodes.push_back(node);
    }
  }

  // arcs in the order of their lower nodes, stable, by counting sort
  const std::vector<Arc_ends>& arcs = folded.arcs();
  std::vector<std::uint32_t> begin(number_of_nodes + 1, 0);
  for (std::uint32_t arc = 0; arc < arcs.size(); ++arc)
    if (folded.is_arc(arc))
      ++begin[arcs[arc].lower + 1];
  for (std::size_t i = 0; i < number_of_nodes; ++i)
    begin[i + 1] += begin[i];
  result.arcs.resize(begin[number_of_nodes]);
  result.position_of_arc.assign(arcs.size(), no_arc);
  result.first_arc_of_node.assign(result.nodes.size(), no_arc);
  for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
    if (!folded.is_arc(arc))
      continue;
    const std::uint32_t position = begin[arcs[arc].lower]++;
    result.arcs[position] = {position_of_node[arcs[arc].lower], position_of_node[arcs[arc].upper]};
    result.position_of_arc[arc] = position;
  }
  for (std::uint32_t i = 0; i < result.arcs.size(); ++i) {
    std::uint32_t& first = result.first_arc_of_node[result.arcs[i].upper];
    if (first == no_arc)
      first = i;
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(result.arcs.size()); i-- > 0;)
    result.first_arc_of_node[result.arcs[i].lower] = i;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPACTED_GRAPH_H
