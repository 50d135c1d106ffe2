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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The places of vertices in the two merge forests: for each the last node below in its component of
// the sublevel set, and the first one above in that of the superlevel set.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Vertex_assignment
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using Cuts = Loop_cuts<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Paths = Monotone_paths<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;

public:
  // Keeps what it needs of the forests, which may be changed afterwards. `sequence` holds the nodes
  // and leaves in increasing order.
  Vertex_assignment(const VertexOrder& order,
                    const Nodes& nodes,
                    const Cuts& cuts,
                    const std::vector<std::uint32_t>& sequence,
                    const Merge_forest& sublevel_forest,
                    const Merge_forest& superlevel_forest)
    : m_order(order), m_nodes(nodes), m_cuts(cuts), m_sequence(sequence)
  {
    m_sublevel_parents.reserve(sequence.size());
    m_superlevel_parents.reserve(sequence.size());
    for (std::uint32_t node = 0; node < sequence.size(); ++node) {
      m_sublevel_parents.push_back(sublevel_forest.parent(node));
      m_superlevel_parents.push_back(superlevel_forest.parent(node));
    }
  }

  // Finds the places of some vertices that have edges.
  void find(const std::vector<vertex_descriptor>& vertices, Paths& descents, Paths& ascents)
  {
    m_vertices = &vertices;
    descents.follow(vertices);
    ascents.follow(vertices);
    find_ends(descents, node_below);
    find_ends(ascents, node_above);
    count_nodes_below();
    // in the order of the numbers, so that the ways along the parents can be shortened for all that
    // follow
    const std::vector<std::uint32_t> sorted = items_sorted_by_counting(
        vertices.size(), m_sequence.size() + 1, [&](std::size_t i) { return m_number[i]; });
    m_position.resize(m_sequence.size());
    for (std::size_t i = 0; i < m_sequence.size(); ++i)
      m_position[m_sequence[i]] = static_cast<std::uint32_t>(i);
    invoke_both<ConcurrencyTag>(
        [&]() {
          climb(
              m_sublevel_parents,
              sorted.begin(),
              sorted.end(),
              [&](std::uint32_t node, std::uint32_t i) { return m_position[node] < m_number[i]; },
              node_below);
        },
        [&]() {
          climb(
              m_superlevel_parents,
              sorted.rbegin(),
              sorted.rend(),
              [&](std::uint32_t node, std::uint32_t i) { return m_position[node] >= m_number[i]; },
              node_above);
        });
  }

  std::vector<std::uint32_t> node_below, node_above; // by position among the vertices

private:
  vertex_descriptor vertex_of_node(std::uint32_t node) const
  {
    return m_nodes.vertex[m_cuts.is_leaf(node) ? m_cuts.saddle_of_leaf(node) : node];
  }

  // A monotone path leads from every vertex to a node in its component.
  void find_ends(Paths& paths, std::vector<std::uint32_t>& ends) const
  {
    ends.resize(m_vertices->size());
    paths.find_ends();
    for_each_range<ConcurrencyTag>(ends.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        ends[i] = m_nodes.number_of_end(paths.end_from((*m_vertices)[i]));
    });
  }

  // Numbers every vertex by the nodes that are not above it.
  void count_nodes_below()
  {
    // side by side, since reading them through property maps would miss the cache at every step
    std::vector<typename VertexOrder::FT> values;
    values.reserve(m_sequence.size());
    for (const std::uint32_t node : m_sequence)
      values.push_back(m_order.value(vertex_of_node(node)));
    m_number.resize(m_vertices->size());
    for_each_range<ConcurrencyTag>(m_number.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const vertex_descriptor v = (*m_vertices)[i];
        const auto range = std::equal_range(values.begin(), values.end(), m_order.value(v));
        const auto above = std::partition_point(
            m_sequence.begin() + (range.first - values.begin()),
            m_sequence.begin() + (range.second - values.begin()),
            [&](std::uint32_t node) { return !m_order(v, vertex_of_node(node)); });
        m_number[i] = static_cast<std::uint32_t>(above - m_sequence.begin());
      }
    });
  }

  // Leads every vertex from a node along its parents, which it may shorten, as far as they lie on the
  // near side of the vertex.
  template <class Iterator, class IsNear>
  void climb(std::vector<std::uint32_t>& parents,
             Iterator begin,
             Iterator end,
             const IsNear& is_near,
             std::vector<std::uint32_t>& node_of_vertex) const
  {
    for (Iterator i = begin; i != end; ++i) {
      std::uint32_t& node = node_of_vertex[*i];
      CGAL_assertion(is_near(node, *i) || vertex_of_node(node) == (*m_vertices)[*i]);
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

  const VertexOrder& m_order;
  const Nodes& m_nodes;
  const Cuts& m_cuts;
  const std::vector<std::uint32_t>& m_sequence;
  std::vector<std::uint32_t> m_sublevel_parents, m_superlevel_parents; // by node
  const std::vector<vertex_descriptor>* m_vertices = nullptr;
  std::vector<std::uint32_t> m_number;   // of the vertices, the number of nodes that are not above
  std::vector<std::uint32_t> m_position; // of nodes, in the sequence
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_VERTEX_ASSIGNMENT_H
