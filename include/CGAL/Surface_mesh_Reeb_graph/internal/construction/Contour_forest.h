// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CONTOUR_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CONTOUR_FOREST_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Merge_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Puts together a Reeb graph without loops, the contour trees of all components, from their join
// and split trees (Carr, Snoeyink, Axen, "Computing contour trees in all dimensions", 2003): a leaf
// of one of them is a leaf of the graph, and its arc leads to its parent; leaf and arc are taken
// away, and so on.
class Contour_forest
{
public:
  struct Arc
  {
    std::uint32_t lower, upper;
    std::uint32_t position; // among the arcs that begin at the lower node
  };

  Contour_forest(Merge_forest& sublevel_forest, Merge_forest& superlevel_forest)
    : m_sublevel_forest(sublevel_forest), m_superlevel_forest(superlevel_forest)
  {}

  // `sequence` holds the nodes of both forests. Those for which `is_regular` holds are no nodes of
  // the graph.
  template <class IsRegular>
  void run(const std::vector<std::uint32_t>& sequence, const IsRegular& is_regular)
  {
    m_fates[BELOW].resize(m_sublevel_forest.size());
    m_fates[ABOVE].resize(m_superlevel_forest.size());
    std::size_t number_of_nodes = 0, number_of_components = 0;
    for (const std::uint32_t node : sequence) {
      if (is_regular(node)) {
        splice(m_sublevel_forest, BELOW, node);
        splice(m_superlevel_forest, ABOVE, node);
        continue;
      }
      ++number_of_nodes;
      if (degree(node) == 0) // an isolated vertex
        ++number_of_components;
    }
    arcs.reserve(number_of_nodes);
    std::vector<std::uint32_t> leaves;
    for (const std::uint32_t first : sequence) {
      if (!is_leaf(first))
        continue;
      leaves.push_back(first);
      while (!leaves.empty()) {
        const std::uint32_t leaf = leaves.back();
        leaves.pop_back();
        if (!is_leaf(leaf))
          continue;
        const std::uint32_t neighbor = prune(leaf);
        if (is_leaf(neighbor))
          leaves.push_back(neighbor);
        else if (degree(neighbor) == 0)
          ++number_of_components;
      }
    }
    // the two forests do not fit if the faces around a vertex form a fan that nobody has seen
    if (arcs.size() + number_of_components != number_of_nodes)
      throw_internal_error("the join and the split tree do not fit together");
  }

  // The number of the arc that a point of the surface belongs to which lies above `below` in the
  // forest of sublevel sets, and below `above` in that of superlevel sets: the first one that was
  // taken away.
  std::uint32_t arc(std::uint32_t below, std::uint32_t above)
  {
    return (std::min)(arc_after(BELOW, below), arc_after(ABOVE, above));
  }

  std::vector<Arc> arcs; // in the order in which they were taken away

private:
  // What became of the way from a node to its parent in a forest: an arc, or a part of the way from
  // the child that took the place of the node.
  struct Fate
  {
    std::uint32_t arc = no_arc;
    std::uint32_t child = no_node;
  };

  std::uint32_t degree(std::uint32_t node) const
  {
    return m_sublevel_forest.degree(node) + m_superlevel_forest.degree(node);
  }

  bool is_leaf(std::uint32_t node) const { return degree(node) == 1; }

  void splice(Merge_forest& forest, Side side, std::uint32_t node)
  {
    m_fates[side][node].child = forest.only_child(node);
    forest.splice(node);
  }

  // Returns the node at the other end of the arc.
  std::uint32_t prune(std::uint32_t leaf)
  {
    const bool is_lower = m_sublevel_forest.degree(leaf) == 0;
    Merge_forest& forest = is_lower ? m_sublevel_forest : m_superlevel_forest;
    Merge_forest& other_forest = is_lower ? m_superlevel_forest : m_sublevel_forest;
    const std::uint32_t neighbor = forest.parent(leaf);
    if (neighbor == no_node ||
        (is_lower ? m_superlevel_forest : m_sublevel_forest).degree(leaf) != 1)
      throw_internal_error("a leaf of the join or the split tree has no arc");
    m_fates[is_lower ? BELOW : ABOVE][leaf].arc = static_cast<std::uint32_t>(arcs.size());
    const std::uint32_t lower = is_lower ? leaf : neighbor;
    const std::uint32_t way_up = is_lower ? m_superlevel_forest.only_child(leaf) : leaf;
    arcs.push_back({lower, is_lower ? neighbor : leaf, m_superlevel_forest.position(way_up)});
    forest.remove_leaf(leaf);
    splice(other_forest, is_lower ? ABOVE : BELOW, leaf);
    return neighbor;
  }

  std::uint32_t arc_after(Side side, std::uint32_t node)
  {
    std::vector<Fate>& fates = m_fates[side];
    while (fates[node].child != no_node) {
      Fate& fate = fates[node];
      const Fate next = fates[fate.child];
      if (next.child != no_node)
        fate.child = next.child; // halves the path for later queries
      node = fate.child;
    }
    return fates[node].arc;
  }

  Merge_forest& m_sublevel_forest;
  Merge_forest& m_superlevel_forest;
  std::vector<Fate> m_fates[2]; // by node: of its ways up and down
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CONTOUR_FOREST_H
