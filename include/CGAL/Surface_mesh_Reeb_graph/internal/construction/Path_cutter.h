// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_PATH_CUTTER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_PATH_CUTTER_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>

#include <CGAL/assertions.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds where cuts of the surface cut the upward paths from the wedges of the critical nodes, and on
// demand all ways up that paths may take later. What is known of a vertex is kept for the next edge:
// a cut crosses many edges of the same vertex one after the other.
template <class TriangleMesh, class Nodes, class Paths>
class Path_cutter
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  using Cut = typename Paths::Cut;

  Path_cutter(const TriangleMesh& tmesh,
              const Nodes& nodes,
              const Paths& ascents,
              bool cuts_later_paths)
    : m_tmesh(tmesh), m_nodes(nodes), m_ascents(ascents), m_cuts_later_paths(cuts_later_paths)
  {}

  // Cuts what goes up through an edge that a cut crosses, which most edges do not matter for; `h`
  // points to its lower end.
  void cut(halfedge_descriptor h, std::uint32_t leaf)
  {
    const vertex_descriptor v = target(h, m_tmesh);
    CGAL_precondition(m_nodes.size() <= leaf);
    if (!m_has_vertex || v != m_vertex)
      set_vertex(v);
    if (m_has_way_out) {
      if (m_way_out == h)
        cuts.push_back({m_path, leaf, v});
    } else if (!m_path_through_edge.empty()) {
      const auto found = m_path_through_edge.find(h);
      if (found != m_path_through_edge.end())
        cuts.push_back({found->second, leaf, v});
    }
  }

  std::vector<Cut> cuts;

private:
  void set_vertex(vertex_descriptor v)
  {
    m_has_vertex = true;
    m_vertex = v;
    if (!m_path_through_edge.empty())
      m_path_through_edge.clear();
    m_path = m_ascents.path_through(v);
    const std::uint32_t node_at_v = m_ascents.node_at(v);
    m_has_way_out = node_at_v == no_node && (m_path != Paths::no_path || m_cuts_later_paths);
    if (m_has_way_out)
      m_way_out = m_ascents.way_out(v);
    if (node_at_v == no_node)
      return;
    // the first edges of wedges
    for (std::uint32_t node = m_nodes.number_of_end(node_at_v);
         node < m_nodes.size() && m_nodes.vertex[node] == v;
         ++node)
      for (std::uint32_t w = m_nodes.upper_begin[node]; w < m_nodes.upper_begin[node + 1]; ++w)
        if (m_nodes.upper_path[w] != Paths::no_path)
          m_path_through_edge.emplace(m_nodes.upper_halfedge[w], m_nodes.upper_path[w]);
  }

  const TriangleMesh& m_tmesh;
  const Nodes& m_nodes;
  const Paths& m_ascents;
  const bool m_cuts_later_paths;
  bool m_has_vertex = false, m_has_way_out = false;
  vertex_descriptor m_vertex;
  std::uint32_t m_path = Paths::no_path;
  halfedge_descriptor m_way_out;
  std::unordered_map<halfedge_descriptor, std::uint32_t, boost::hash<halfedge_descriptor>>
      m_path_through_edge;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_PATH_CUTTER_H
