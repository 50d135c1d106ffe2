// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_VERTEX_ASSIGNMENT_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_VERTEX_ASSIGNMENT_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_nodes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Loop_cuts.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Merge_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Monotone_paths.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The places of all vertices in the two merge forests: for each the last node below in its
// component of the sublevel set, and the first one above in that of the superlevel set.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Vertex_assignment
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using Cuts = Loop_cuts<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Paths = Monotone_paths<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;

public:
  Vertex_assignment(const TriangleMesh& tmesh,
                    const VertexOrder& order,
                    VertexIndexMap vertex_index_map,
                    std::size_t index_bound,
                    const Nodes& nodes,
                    const Cuts& cuts)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_index_bound(index_bound)
    , m_nodes(nodes)
    , m_cuts(cuts)
  {}

  // Follows the paths from all vertices. This must be done before the upward ones are cut.
  void follow_paths(Paths& descents, Paths& ascents)
  {
    for (const vertex_descriptor v : CGAL::make_range(vertices(m_tmesh)))
      if (!has_no_edge(v, m_tmesh))
        m_vertices.push_back(v);
    descents.follow(m_vertices);
    ascents.follow(m_vertices);
  }

  // To be called then. `sequence` holds the nodes and leaves in increasing order.
  void find(const std::vector<std::uint32_t>& sequence,
            const Merge_forest& sublevel_forest,
            const Merge_forest& superlevel_forest,
            Paths& descents,
            Paths& ascents)
  {
    find_ends(descents, node_below);
    find_ends(ascents, node_above);
    count_nodes_below(sequence);
    // in the order of the numbers, so that the ways along the parents can be shortened for all that
    // follow
    const std::vector<std::uint32_t> sorted = items_sorted_by_counting(
        m_vertices.size(), sequence.size() + 1, [&](std::size_t i) { return m_number[i]; });
    m_position.resize(sequence.size());
    for (std::size_t i = 0; i < sequence.size(); ++i)
      m_position[sequence[i]] = static_cast<std::uint32_t>(i);
    invoke_both<ConcurrencyTag>(
        [&]() {
          climb(
              sublevel_forest,
              sorted.begin(),
              sorted.end(),
              [&](std::uint32_t node, std::uint32_t i) { return m_position[node] < m_number[i]; },
              node_below);
        },
        [&]() {
          climb(
              superlevel_forest,
              sorted.rbegin(),
              sorted.rend(),
              [&](std::uint32_t node, std::uint32_t i) { return m_position[node] >= m_number[i]; },
              node_above);
        });
  }

  std::vector<std::uint32_t> node_below, node_above; // by vertex index; no_node without edges

private:
  std::size_t index(std::size_t i) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, m_vertices[i]));
  }

  vertex_descriptor vertex_of_node(std::uint32_t node) const
  {
    return m_nodes.vertex[m_cuts.is_leaf(node) ? m_cuts.saddle_of_leaf(node) : node];
  }

  // A monotone path leads from every vertex to a node in its component.
  void find_ends(Paths& paths, std::vector<std::uint32_t>& ends) const
  {
    ends.assign(m_index_bound, no_node);
    paths.find_ends();
    for_each_range<ConcurrencyTag>(m_vertices.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        ends[index(i)] = m_nodes.number_of_end(paths.end_from(m_vertices[i]));
    });
  }

  // Numbers every vertex by the nodes that are not above it.
  void count_nodes_below(const std::vector<std::uint32_t>& sequence)
  {
    // side by side, since reading them through property maps would miss the cache at every step
    std::vector<typename VertexOrder::FT> values;
    values.reserve(sequence.size());
    for (const std::uint32_t node : sequence)
      values.push_back(m_order.value(vertex_of_node(node)));
    m_number.resize(m_vertices.size());
    for_each_range<ConcurrencyTag>(m_vertices.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const vertex_descriptor v = m_vertices[i];
        const auto range = std::equal_range(values.begin(), values.end(), m_order.value(v));
        const auto above = std::partition_point(
            sequence.begin() + (range.first - values.begin()),
            sequence.begin() + (range.second - values.begin()),
            [&](std::uint32_t node) { return !m_order(v, vertex_of_node(node)); });
        m_number[i] = static_cast<std::uint32_t>(above - sequence.begin());
      }
    });
  }

  // Leads every vertex from a node along its parents as far as they lie on the near side of the
  // vertex.
  template <class Iterator, class IsNear>
  void climb(const Merge_forest& forest,
             Iterator begin,
             Iterator end,
             const IsNear& is_near,
             std::vector<std::uint32_t>& node_of_vertex) const
  {
    std::vector<std::uint32_t> parents(m_position.size());
    for (std::uint32_t node = 0; node < parents.size(); ++node)
      parents[node] = forest.parent(node);
    for (Iterator i = begin; i != end; ++i) {
      std::uint32_t& node = node_of_vertex[index(*i)];
      CGAL_assertion(is_near(node, *i) || vertex_of_node(node) == m_vertices[*i]);
      for (;;) {
        const std::uint32_t parent = parents[node];
        if (parent == no_node || !is_near(parent, *i))
          break;
        const std::uint32_t next = parents[parent];
        if (next != no_node && is_near(next, *i))
          parents[node] = next;
        node = parents[node];
      }
    }
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const std::size_t m_index_bound;
  const Nodes& m_nodes;
  const Cuts& m_cuts;
  std::vector<vertex_descriptor> m_vertices; // that have edges
  std::vector<std::uint32_t> m_number;       // of these, the number of nodes that are not above
  std::vector<std::uint32_t> m_position;     // of nodes, in the sequence
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_VERTEX_ASSIGNMENT_H
