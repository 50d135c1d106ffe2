// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_SIMPLIFICATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_SIMPLIFICATION_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Point_on_arc.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Minimum_spanning_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Two_core.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_closing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The loops of a folded graph that have been closed, and where the points of the graph went
// thereby.
class Loop_simplification
{
public:
  // No loops.
  Loop_simplification() = default;

  // Closes the loops of a graph for which `is_small(pair)` holds, see Loop_closing.
  template <class IsSmall>
  Loop_simplification(Folded_graph& graph, const IsSmall& is_small)
    : m_core(graph.number_of_nodes(), graph.arcs(), [&](std::uint32_t arc) {
      return graph.is_arc(arc);
    })
  {
    Loop_closing closing(m_core.number_of_nodes(), m_core.arcs());
    closing.run([&](const Loop_pair& loop) {
      return is_small(Loop_pair{m_core.node_before(loop.split), m_core.node_before(loop.merge)});
    });
    m_have_other_pairs_changed = closing.have_other_pairs_changed();
    m_arcs = closing.arcs();
    sort_parts(closing.glued_parts());
    if (!m_parts.empty())
      write(graph);
  }

  // Whether other pairs may have changed.
  bool have_other_pairs_changed() const { return m_have_other_pairs_changed; }

  // Moves points of arcs that are glued along paths to the arcs of the paths: those at some
  // positions. `is_below(i, node)` tells whether the vertex at `points[i]` lies below a node. Takes
  // O((n + m) log m) time for n points and m arcs.
  template <class IsBelow>
  void move(const Folded_graph& graph,
            std::vector<Point_on_arc>& points,
            const std::vector<std::uint32_t>& positions,
            const IsBelow& is_vertex_below) const
  {
    const auto is_below = [&](std::uint32_t i, std::uint32_t node) {
      const auto is_this_vertex_below = [&](std::uint32_t other) {
        return is_vertex_below(i, other);
      };
      return Point_height(points[i], is_this_vertex_below).is_below(node);
    };
    // of those that do not lie in what is left of their arc, and the parts that they lie in
    std::vector<std::uint32_t> positions_in_parts;
    std::vector<Arc_ends> parts;
    for (const std::uint32_t i : positions) {
      const std::uint32_t arc = graph.number_of_glued_arc(points[i].arc);
      const auto begin = m_parts.begin() + static_cast<std::ptrdiff_t>(m_first_part[arc]),
                 end = m_parts.begin() + static_cast<std::ptrdiff_t>(m_first_part[arc + 1]),
                 last = is_left(arc) ? end : end - 1; // also for points below the whole arc
      const auto part = std::partition_point(begin, last, [&](const Arc_ends& ends) {
        return is_below(i, m_core.node_before(ends.lower));
      });
      if (part == end) {
        points[i].arc = m_numbers[arc];
      } else {
        positions_in_parts.push_back(i);
        parts.push_back(*part);
      }
    }
    if (parts.empty())
      return;

    // Two nodes of a part are joined by one path only at heights between theirs; so, when the
    // forest has the arcs down to the lower one, by that in the forest.
    Minimum_spanning_forest<> forest(m_core.number_of_nodes(), m_arcs);
    const std::vector<std::uint32_t> sorted_arcs =
        sorted_downwards(m_core.number_of_nodes(), m_arcs);
    auto arc = sorted_arcs.begin();
    for (const std::uint32_t k : sorted_downwards(m_core.number_of_nodes(), parts)) {
      const Arc_ends& part = parts[k];
      for (; arc != sorted_arcs.end() && m_arcs[*arc].lower >= part.lower; ++arc)
        if (is_left(*arc))
          forest.add(*arc);
      const std::uint32_t i = positions_in_parts[k];
      const auto last = forest.last_on_path_down(part.upper, part.lower, [&](std::uint32_t node) {
        return node == part.upper || (node != part.lower && is_below(i, m_core.node_before(node)));
      });
      points[i].arc = m_numbers[last.next_arc];
    }
  }

private:
  bool is_left(std::uint32_t arc) const { return m_arcs[arc].lower < m_arcs[arc].upper; }

  void sort_parts(const std::vector<Glued_part>& parts)
  {
    m_parts.resize(parts.size());
    m_first_part = counting_sort(
        parts.size(),
        m_arcs.size(),
        [&](std::size_t i) { return parts[i].arc; },
        [&](std::size_t position, std::size_t i) {
          m_parts[position] = {parts[i].lower, parts[i].upper};
        });
  }

  // What is left of an arc is a new one.
  void write(Folded_graph& graph)
  {
    m_numbers.resize(m_arcs.size());
    for (std::uint32_t arc = 0; arc < m_arcs.size(); ++arc) {
      m_numbers[arc] = m_core.arc_before(arc);
      if (m_first_part[arc] == m_first_part[arc + 1])
        continue;
      graph.glue_along_paths(m_core.arc_before(arc), arc);
      m_numbers[arc] = is_left(arc) ? graph.add_arc({m_core.node_before(m_arcs[arc].lower),
                                                     m_core.node_before(m_arcs[arc].upper)})
                                    : no_arc;
    }
    for (std::uint32_t node = 0; node < graph.number_of_nodes(); ++node)
      graph.pass_through_if_regular(node);
  }

  Two_core m_core;
  bool m_have_other_pairs_changed = false;
  std::vector<Arc_ends> m_arcs;          // of the core: what is left of them
  std::vector<std::uint32_t> m_numbers;  // by arc: that of what is left, in the folded graph
  std::vector<Arc_ends> m_parts;         // by arc, from the highest part to the lowest one
  std::vector<std::size_t> m_first_part; // by arc, and the number of all parts
};

// Moves points to the arcs that they belong to after the graph has been simplified, with some loops
// closed in between. `is_below(i, node)` tells whether the vertex at `points[i]` lies below a node.
template <class IsBelow>
void follow(Folded_graph& graph,
            const Loop_simplification& loops,
            std::vector<Point_on_arc>& points,
            const IsBelow& is_below)
{
  std::vector<std::uint32_t> glued; // positions
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    graph.follow(points[i], [&](std::uint32_t node) { return is_below(i, node); });
    if (graph.is_glued_along_paths(points[i].arc))
      glued.push_back(i);
  }
  if (glued.empty())
    return;
  loops.move(graph, points, glued, is_below);
  for (const std::uint32_t i : glued)
    graph.follow(points[i], [&](std::uint32_t node) { return is_below(i, node); });
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_SIMPLIFICATION_H
