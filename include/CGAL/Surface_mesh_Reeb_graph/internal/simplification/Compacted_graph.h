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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What folding leaves of a Reeb graph, with new numbers: nodes and arcs without gaps, in the order
// that a Reeb graph has them.
struct Compacted_graph
{
  std::vector<std::uint32_t> nodes;             // numbers of the nodes that are left, increasing
  std::vector<Arc_ends> arcs;                   // between positions in `nodes`
  std::vector<std::uint32_t> first_arc_of_node; // begins there, or else ends there; by position
  std::vector<std::uint32_t> position_of_arc;   // by the arcs of the folded graph

  explicit Compacted_graph(const Folded_graph& folded)
    : position_of_arc(folded.arcs().size(), no_arc)
  {
    std::vector<std::uint32_t> position_of_node(folded.number_of_nodes(), no_node);
    for (std::uint32_t node = 0; node < folded.number_of_nodes(); ++node) {
      if (folded.is_node(node)) {
        position_of_node[node] = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back(node);
      }
    }
    std::vector<std::uint32_t> arcs_left;
    for (std::uint32_t arc = 0; arc < folded.arcs().size(); ++arc)
      if (folded.is_arc(arc))
        arcs_left.push_back(arc);

    const auto lower_position = [&](std::size_t i) {
      return position_of_node[folded.arcs()[arcs_left[i]].lower];
    };
    arcs.resize(arcs_left.size());
    counting_sort(
        arcs_left.size(), nodes.size(), lower_position, [&](std::size_t position, std::size_t i) {
          const Arc_ends& ends = folded.arcs()[arcs_left[i]];
          CGAL_assertion(folded.is_node(ends.lower) && folded.is_node(ends.upper));
          arcs[position] = {position_of_node[ends.lower], position_of_node[ends.upper]};
          position_of_arc[arcs_left[i]] = static_cast<std::uint32_t>(position);
        });

    first_arc_of_node.assign(nodes.size(), no_arc);
    for (std::uint32_t i = static_cast<std::uint32_t>(arcs.size()); i-- > 0;)
      first_arc_of_node[arcs[i].upper] = i;
    for (std::uint32_t i = static_cast<std::uint32_t>(arcs.size()); i-- > 0;)
      first_arc_of_node[arcs[i].lower] = i;
  }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPACTED_GRAPH_H
