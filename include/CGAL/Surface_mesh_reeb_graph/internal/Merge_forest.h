// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MERGE_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MERGE_FOREST_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The forest that tells how the components of the sublevel sets merge as the level rises, or those of the
// superlevel sets as it falls: every node with the next one of its component as its parent. Instead of a list of
// its children a node has their number and the exclusive or of their names, which is the name of the last
// one when one is left.
class Merge_forest
{
public:
  void resize(std::size_t size)
  {
    m_parent.resize(size, no_node);
    m_children.resize(size, 0);
    m_degree.resize(size, 0);
    m_position.resize(size, 0);
  }

  void clear(std::size_t size)
  {
    m_parent.clear();
    m_children.clear();
    m_degree.clear();
    m_position.clear();
    resize(size);
  }

  std::uint32_t parent(std::uint32_t node) const { return m_parent[node]; }
  const std::vector<std::uint32_t>& parents() const { return m_parent; }
  std::uint32_t degree(std::uint32_t node) const { return m_degree[node]; }

  // How many children of its parent came before.
  std::uint32_t position(std::uint32_t node) const { return m_position[node]; }

  // \pre `degree(node) == 1`
  std::uint32_t only_child(std::uint32_t node) const { return m_children[node]; }

  void attach(std::uint32_t child, std::uint32_t node)
  {
    m_parent[child] = node;
    m_position[child] = m_degree[node]++;
    m_children[node] ^= child;
  }

  // \pre `degree(leaf) == 0`, and `leaf` has a parent
  void remove_leaf(std::uint32_t leaf)
  {
    const std::uint32_t node = m_parent[leaf];
    m_children[node] ^= leaf;
    --m_degree[node];
    m_parent[leaf] = no_node;
  }

  // Takes away a node with one child, which takes its place.
  void splice(std::uint32_t node)
  {
    const std::uint32_t child = m_children[node], above = m_parent[node];
    m_parent[child] = above;
    m_position[child] = m_position[node];
    if (above != no_node)
      m_children[above] ^= node ^ child;
    m_degree[node] = 0;
    m_parent[node] = no_node;
  }

private:
  std::vector<std::uint32_t> m_parent;
  std::vector<std::uint32_t> m_children; // exclusive or
  std::vector<std::uint32_t> m_degree;
  std::vector<std::uint32_t> m_position;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MERGE_FOREST_H
