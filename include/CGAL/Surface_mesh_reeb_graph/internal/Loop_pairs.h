// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_PAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_PAIRS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Link_cut_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Number_sets.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// An essential pair of a Reeb graph: a loop that is complete at `merge` and begins at `split`.
struct Loop_pair
{
  std::uint32_t split, merge;
};

// A spanning forest of a Reeb graph, its arcs given one by one in the order of their upper nodes,
// that is kept a maximum one with respect to the lower nodes of the arcs. So of all paths between
// two nodes the one in the forest goes down least.
//
// The loops of extended persistence fall out. A pair has its merge at or below m and its split at
// or above s for every independent cycle of the arcs between the heights s and m. Of these arcs the
// forest of the arcs up to m holds a spanning forest, so the independent cycles are as many as the
// arcs that have left the forest, or not entered it, by then: one at every merge that completes a
// cycle, and its split is the lower node of the arc. It does not matter which one leaves of several
// arcs with the same lower node, nor in which order those with the same upper node come.
class Arc_forest
{
public:
  explicit Arc_forest(std::size_t number_of_nodes)
    : m_number_of_nodes(number_of_nodes), m_components(number_of_nodes)
  {
    for (std::size_t i = 0; i < number_of_nodes; ++i)
      m_forest.add(no_node);
  }

  bool are_connected(std::uint32_t node, std::uint32_t other)
  {
    return m_components.root(node) == m_components.root(other);
  }

  // The arc of least lower node on the path between two nodes.
  std::uint32_t lowest_arc(std::uint32_t node, std::uint32_t other)
  {
    return arc_of(m_forest.least_on_path(node, other));
  }

  // The arcs on the path between two nodes, in order.
  std::vector<std::uint32_t> path(std::uint32_t node, std::uint32_t other)
  {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t item : m_forest.path(node, other))
      if (item >= m_number_of_nodes)
        result.push_back(arc_of(item));
    return result;
  }

  void insert(std::uint32_t arc, const Arc_ends& ends)
  {
    while (m_forest.size() <= item_of(arc))
      m_forest.add(no_node);
    m_forest.set_key(item_of(arc), ends.lower);
    m_forest.link(item_of(arc), ends.lower);
    m_forest.link(item_of(arc), ends.upper);
    m_components.join(m_components.root(ends.lower), m_components.root(ends.upper));
  }

  // The nodes that it connects must be connected again before the next question.
  void remove(std::uint32_t arc, const Arc_ends& ends)
  {
    m_forest.cut(item_of(arc), ends.lower);
    m_forest.cut(item_of(arc), ends.upper);
  }

private:
  std::uint32_t item_of(std::uint32_t arc) const
  {
    return static_cast<std::uint32_t>(m_number_of_nodes + arc);
  }
  std::uint32_t arc_of(std::uint32_t item) const
  {
    return static_cast<std::uint32_t>(item - m_number_of_nodes);
  }

  std::size_t m_number_of_nodes;
  Link_cut_forest m_forest; // the nodes, then the arcs, each between its ends
  Number_sets m_components;
};

// All loop pairs of a Reeb graph, by merge.
inline std::vector<Loop_pair>
loop_pairs(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
{
  // the arcs by upper node, by counting sort
  std::vector<std::size_t> position(number_of_nodes + 1, 0);
  for (const Arc_ends& ends : arcs)
    ++position[ends.upper + 1];
  std::partial_sum(position.begin(), position.end(), position.begin());
  std::vector<std::uint32_t> sorted(arcs.size());
  for (std::uint32_t arc = 0; arc < arcs.size(); ++arc)
    sorted[position[arcs[arc].upper]++] = arc;

  Arc_forest forest(number_of_nodes);
  std::vector<Loop_pair> pairs;
  for (const std::uint32_t arc : sorted) {
    const Arc_ends& ends = arcs[arc];
    if (forest.are_connected(ends.lower, ends.upper)) {
      const std::uint32_t lowest = forest.lowest_arc(ends.lower, ends.upper);
      if (ends.lower <= arcs[lowest].lower) {
        pairs.push_back({ends.lower, ends.upper});
        continue;
      }
      pairs.push_back({arcs[lowest].lower, ends.upper});
      forest.remove(lowest, arcs[lowest]);
    }
    forest.insert(arc, ends);
  }
  return pairs;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LOOP_PAIRS_H
