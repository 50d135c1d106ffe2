// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_LOOP_PAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_LOOP_PAIRS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Minimum_spanning_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Two_core.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// An essential pair of a Reeb graph: a loop that is complete at `merge` and begins at `split`.
struct Loop_pair
{
  std::uint32_t split, merge;
};

// All loop pairs of a Reeb graph, from the highest split to the lowest one.
inline std::vector<Loop_pair>
loop_pairs(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
{
  const Two_core core(number_of_nodes, arcs, [](std::uint32_t) { return true; });
  Minimum_spanning_forest<> forest(core.number_of_nodes(), core.arcs());
  std::vector<Loop_pair> pairs;
  for (const std::uint32_t arc : sorted_downwards(core.number_of_nodes(), core.arcs())) {
    const std::uint32_t highest = forest.add(arc).highest_arc;
    if (highest != no_arc)
      pairs.push_back(
          {core.node_before(core.arcs()[arc].lower), core.node_before(core.arcs()[highest].upper)});
  }
  return pairs;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_LOOP_PAIRS_H
