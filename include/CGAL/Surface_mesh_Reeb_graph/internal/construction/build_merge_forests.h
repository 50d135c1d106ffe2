// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_BUILD_MERGE_FORESTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_BUILD_MERGE_FORESTS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Merge_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Makes a forest that is empty and has room for all names: visits the nodes in the given order, for
// the side ABOVE in the reverse one, and merges the components that their wedges lead to, which are
// told by nodes in them, the ends of the wedges. The sequence may hold more names than there are
// nodes: those of leaves, which are components of their own. If `component_of_wedge` is given, it
// receives for every wedge the last node of its component, the child that the component has in the
// forest.
inline void merge_components(Side side,
                             const std::vector<std::uint32_t>& sequence,
                             const std::vector<std::uint32_t>& wedge_begin,
                             const std::vector<std::uint32_t>& wedge_end,
                             Merge_forest& forest,
                             std::vector<std::uint32_t>* component_of_wedge = nullptr)
{
  const std::size_t number_of_nodes = wedge_begin.size() - 1;
  Disjoint_sets sets(forest.size()); // the last node visited is the root
  std::vector<std::uint32_t> components;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::uint32_t node = sequence[side == BELOW ? i : sequence.size() - 1 - i];
    if (node >= number_of_nodes)
      continue;
    components.clear();
    for (std::uint32_t w = wedge_begin[node]; w < wedge_begin[node + 1]; ++w)
      components.push_back(sets.root(wedge_end[w]));
    for (std::size_t k = 0; k < components.size(); ++k) {
      const std::uint32_t component = components[k];
      CGAL_assertion(component != node); // the ends of the wedges have been visited before
      if (component_of_wedge != nullptr)
        (*component_of_wedge)[wedge_begin[node] + k] = component;
      if (forest.parent(component) == node)
        continue;
      forest.attach(component, node);
      sets.join(component, node);
    }
  }
}

// The forest of sublevel sets of `nodes`, which are Critical_nodes.
template <class Nodes>
void merge_sublevel_sets(const Nodes& nodes,
                         const std::vector<std::uint32_t>& sequence,
                         Merge_forest& forest)
{
  forest.clear(sequence.size());
  merge_components(BELOW, sequence, nodes.lower_begin, nodes.lower_end, forest);
}

// The forest of superlevel sets.
template <class Nodes>
void merge_superlevel_sets(const Nodes& nodes,
                           const std::vector<std::uint32_t>& sequence,
                           Merge_forest& forest,
                           std::vector<std::uint32_t>* component_of_wedge = nullptr)
{
  forest.clear(sequence.size());
  if (component_of_wedge != nullptr)
    component_of_wedge->resize(nodes.upper_end.size());
  merge_components(ABOVE, sequence, nodes.upper_begin, nodes.upper_end, forest, component_of_wedge);
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_BUILD_MERGE_FORESTS_H
