// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CLOSE_LOOPS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CLOSE_LOOPS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_sequences.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Folded_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Graph_core.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Loop_closing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Brings a folded graph up to date when loops have been closed.
class Closed_loops
{
public:
  // The loops are those of `core`, a part of the graph.
  Closed_loops(Folded_graph& graph, const Graph_core& core, const Loop_closing& closing)
    : m_graph(graph)
    , m_core(core)
    , m_arcs(closing.arcs())
    , m_sorted_arcs(closing.sorted_arcs())
    , m_parts(closing.glued_parts())
  {}

  // Whether the graph remembers what became of the arcs.
  void write(bool remembers_arcs)
  {
    number_arcs();
    if (remembers_arcs) {
      number_parts();
      glue_arcs();
    } else {
      remove_arcs();
    }
    for (std::uint32_t node = 0; node < m_graph.number_of_nodes(); ++node)
      m_graph.pass_through_if_regular(node);
  }

private:
  bool is_left(std::uint32_t arc) const { return m_arcs[arc].lower < m_arcs[arc].upper; }

  bool is_changed(std::uint32_t arc) const { return m_numbers[arc] != m_core.arc_before(arc); }

  // What is left of an arc is a new one.
  void number_arcs()
  {
    for (std::uint32_t arc = 0; arc < m_arcs.size(); ++arc)
      m_numbers.push_back(m_core.arc_before(arc));
    for (const Glued_part& part : m_parts) {
      const Arc_ends& ends = m_arcs[part.arc];
      if (!is_changed(part.arc))
        m_numbers[part.arc] =
            is_left(part.arc)
                ? m_graph.add_arc({m_core.node_before(ends.lower), m_core.node_before(ends.upper)})
                : no_arc;
    }
  }

  void number_parts()
  {
    std::vector<Arc_ends> ends;
    ends.reserve(m_parts.size());
    for (const Glued_part& part : m_parts)
      ends.push_back({part.lower, part.upper});
    m_numbers_of_parts.resize(m_parts.size());
    Arc_sequences sequences(m_graph, m_core, m_arcs, m_numbers);
    auto arc = m_sorted_arcs.begin();
    for (const std::uint32_t part : sorted_downwards(m_core.number_of_nodes(), ends)) {
      for (; arc != m_sorted_arcs.end() && m_arcs[*arc].lower >= ends[part].lower; ++arc)
        if (is_left(*arc))
          sequences.add(*arc);
      m_numbers_of_parts[part] = sequences.sequence(ends[part].lower, ends[part].upper);
    }
  }

  void glue_arcs()
  {
    std::vector<std::uint32_t> parts(m_parts.size());
    std::iota(parts.begin(), parts.end(), 0);
    std::stable_sort(parts.begin(), parts.end(), [this](std::uint32_t i, std::uint32_t j) {
      return m_parts[i].arc < m_parts[j].arc;
    });
    for (auto begin = parts.begin(), end = begin; begin != parts.end(); begin = end) {
      const std::uint32_t arc = m_parts[*begin].arc;
      end = std::find_if(
          begin, parts.end(), [&](std::uint32_t part) { return m_parts[part].arc != arc; });
      m_sequence.clear();
      if (is_left(arc))
        m_sequence.push_back({m_numbers[arc], m_arcs[arc].upper});
      for (auto part = end; part-- != begin;)
        m_sequence.push_back({m_numbers_of_parts[*part], m_parts[*part].upper});
      m_graph.glue(m_core.arc_before(arc), joined(0, m_sequence.size()));
    }
  }

  void remove_arcs()
  {
    for (std::uint32_t arc = 0; arc < m_numbers.size(); ++arc)
      if (is_changed(arc))
        m_graph.glue(m_core.arc_before(arc), no_arc);
  }

  // One number for a part of m_sequence.
  std::uint32_t joined(std::size_t begin, std::size_t end)
  {
    if (end - begin == 1)
      return m_sequence[begin].number;
    const std::size_t middle = begin + (end - begin) / 2;
    const std::uint32_t lower = joined(begin, middle), upper = joined(middle, end);
    return m_graph.join(lower, m_core.node_before(m_sequence[middle - 1].upper_node), upper);
  }

  struct Part_of_sequence
  {
    std::uint32_t number, upper_node;
  };

  Folded_graph& m_graph;
  const Graph_core& m_core;
  const std::vector<Arc_ends>& m_arcs;
  const std::vector<std::uint32_t>& m_sorted_arcs;
  const std::vector<Glued_part>& m_parts;
  std::vector<std::uint32_t> m_numbers, m_numbers_of_parts; // in the folded graph
  std::vector<Part_of_sequence> m_sequence; // what becomes of the arc that is being glued
};

// Closes the loops of a graph for which `is_small(pair)` holds, see Loop_closing. Returns whether other pairs may have
// changed. Only if the graph is to remember what became of the arcs, Folded_graph::arc_after() may be called afterwards.
template <class IsSmall>
bool close_loops(Folded_graph& graph, bool remembers_arcs, const IsSmall& is_small)
{
  const Graph_core core(
      graph.number_of_nodes(), graph.arcs(), [&](std::uint32_t arc) { return graph.is_arc(arc); });
  if (core.arcs().empty())
    return false;
  Loop_closing closing(core.number_of_nodes(), core.arcs());
  closing.run([&](const Loop_pair& loop) {
    return is_small(Loop_pair{core.node_before(loop.split), core.node_before(loop.merge)});
  });
  if (!closing.glued_parts().empty())
    Closed_loops(graph, core, closing).write(remembers_arcs);
  return closing.have_other_pairs_changed();
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CLOSE_LOOPS_H
