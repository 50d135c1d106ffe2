// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_TWO_CORE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_TWO_CORE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The 2-core of a graph: what is left when leaves are taken away as long as there are any, that is,
// all cycles, and what lies between them. Nodes and arcs have new numbers, in the same order.
class Two_core
{
public:
  Two_core() = default;

  // Of `arcs` those count for which `is_arc(arc)` holds.
  template <class IsArc>
  Two_core(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs, const IsArc& is_arc)
  {
    // by node: how many arcs are left there, and the exclusive or of their numbers, which is that
    // of the last one
    std::vector<std::uint32_t> degree(number_of_nodes, 0), last_arc(number_of_nodes, 0);
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
      if (!is_arc(arc))
        continue;
      for (const std::uint32_t node : {arcs[arc].lower, arcs[arc].upper}) {
        ++degree[node];
        last_arc[node] ^= arc;
      }
    }
    std::vector<bool> is_pruned(arcs.size(), false);
    for (std::uint32_t first = 0; first < number_of_nodes; ++first) {
      for (std::uint32_t node = first; degree[node] == 1;) {
        const std::uint32_t arc = last_arc[node];
        is_pruned[arc] = true;
        degree[node] = 0;
        node = arcs[arc].lower == node ? arcs[arc].upper : arcs[arc].lower;
        --degree[node];
        last_arc[node] ^= arc;
      }
    }

    std::vector<std::uint32_t>& number = last_arc; // is not needed any more
    for (std::uint32_t node = 0; node < number_of_nodes; ++node) {
      if (degree[node] == 0)
        continue;
      number[node] = static_cast<std::uint32_t>(m_nodes.size());
      m_nodes.push_back(node);
    }
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
      if (!is_arc(arc) || is_pruned[arc])
        continue;
      CGAL_assertion(degree[arcs[arc].lower] >= 2 && degree[arcs[arc].upper] >= 2);
      m_arcs.push_back({number[arcs[arc].lower], number[arcs[arc].upper]});
      m_numbers_of_arcs.push_back(arc);
    }
  }

  std::size_t number_of_nodes() const { return m_nodes.size(); }

  const std::vector<Arc_ends>& arcs() const { return m_arcs; }

  // The numbers of before.
  std::uint32_t node_before(std::uint32_t node) const { return m_nodes[node]; }
  std::uint32_t arc_before(std::uint32_t arc) const { return m_numbers_of_arcs[arc]; }

private:
  std::vector<std::uint32_t> m_nodes, m_numbers_of_arcs;
  std::vector<Arc_ends> m_arcs;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_TWO_CORE_H
