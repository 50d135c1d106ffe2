// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MERGE_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MERGE_FOREST_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The join trees of the components of a mesh, which tell how the components of the sublevel sets
// merge as the level rises, or their split trees, those of the superlevel sets as it falls: every
// node with the next one of its component as its parent. Instead of a list of its children a node
// has their number and the exclusive or of their names, which is the name of the last one when one
// is left.
class Merge_forest
{
public:
  std::size_t size() const { return m_nodes.size(); }

  void resize(std::size_t size) { m_nodes.resize(size); }

  void clear(std::size_t size) { m_nodes.assign(size, Node()); }

  std::uint32_t parent(std::uint32_t node) const { return m_nodes[node].parent; }
  std::uint32_t degree(std::uint32_t node) const { return m_nodes[node].degree; }

  // How many children of its parent came before.
  std::uint32_t position(std::uint32_t node) const { return m_nodes[node].position; }

  std::uint32_t only_child(std::uint32_t node) const
  {
    CGAL_precondition(degree(node) == 1);
    return m_nodes[node].children;
  }

  void attach(std::uint32_t child, std::uint32_t node)
  {
    CGAL_precondition(child != node && parent(child) == no_node);
    m_nodes[child].parent = node;
    m_nodes[child].position = m_nodes[node].degree++;
    m_nodes[node].children ^= child;
  }

  // Takes away a node without children from its parent.
  void remove_leaf(std::uint32_t leaf)
  {
    CGAL_precondition(degree(leaf) == 0 && parent(leaf) != no_node);
    const std::uint32_t node = m_nodes[leaf].parent;
    m_nodes[node].children ^= leaf;
    --m_nodes[node].degree;
    m_nodes[leaf].parent = no_node;
  }

  // Takes away a node with one child, which takes its place.
  void splice(std::uint32_t node)
  {
    const std::uint32_t child = only_child(node), parent = m_nodes[node].parent;
    CGAL_assertion(this->parent(child) == node);
    m_nodes[child].parent = parent;
    m_nodes[child].position = m_nodes[node].position;
    if (parent != no_node)
      m_nodes[parent].children ^= node ^ child;
    m_nodes[node].degree = 0;
    m_nodes[node].parent = no_node;
  }

private:
  struct Node
  {
    std::uint32_t parent = no_node;
    std::uint32_t children = 0; // exclusive or
    std::uint32_t degree = 0;
    std::uint32_t position = 0;
  };

  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_MERGE_FOREST_H
