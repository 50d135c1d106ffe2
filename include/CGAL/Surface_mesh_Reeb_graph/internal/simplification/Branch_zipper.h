// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_ZIPPER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_ZIPPER_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Zipped_arcs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Zips branches on a side of a Reeb graph together with their neighbors, all at once. (In the
// comments the side is BELOW.)
//
// From every node a way leads down: along any one of its arcs, from there on in the same manner,
// and from a minimum that is cancelled along the way that its branch was zipped to. To cancel a
// pair is to glue the two ways that begin at its saddle, with the arc towards the minimum and with
// the one towards the eldest minimum, down to the height of the minimum. So at every height the
// arcs fall into strands that become one arc each.
//
// One pass over the nodes from the highest to the lowest keeps track of the strands. At a saddle of
// a cancelled pair two of them become one. An arc that ends at a node leaves its strand to the
// node's arc that leads on, if there are others in the strand (otherwise no way that is glued leads
// through it, and the strand ends); so strands that arrive at the same node become one, too. At a
// cancelled minimum the arc is gone, and the others of its strand go on. A node that has but one
// strand above and one below is none any more.
class Branch_zipper
{
public:
  struct Branch
  {
    std::uint32_t saddle;
    std::uint32_t arc, other_arc; // at the saddle, towards the extremum and the eldest one there
  };

  Branch_zipper(Folded_graph& graph, Side side, std::vector<Branch>&& branches)
    : m_graph(graph)
    , m_side(side)
    , m_branches(std::move(branches))
    , m_sets(graph.arcs().size())
    , m_size(graph.arcs().size(), 1)
    , m_strand(graph.arcs().size(), no_arc)
    , m_first(graph.arcs().size(), no_arc)
    , m_next_to(graph.arcs().size(), no_node)
    , m_zipped(side)
  {}

  void run()
  {
    const std::uint32_t size = static_cast<std::uint32_t>(m_graph.number_of_nodes());
    std::vector<Branch> sorted(m_branches.size());
    const std::vector<std::size_t> begin = counting_sort(
        m_branches.size(),
        size,
        [this](std::size_t i) { return m_branches[i].saddle; },
        [&](std::size_t position, std::size_t i) { sorted[position] = m_branches[i]; });
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t node = m_side == BELOW ? size - 1 - i : i;
      CGAL_assertion(m_graph.is_node(node) || begin[node] == begin[node + 1]);
      if (m_graph.is_node(node))
        pass(node, sorted.data() + begin[node], sorted.data() + begin[node + 1]);
    }
    m_graph.replace(std::move(m_zipped), m_first, m_next_to);
    for (std::uint32_t node = 0; node < size; ++node)
      m_graph.pass_through_if_regular(node);
  }

private:
  std::uint32_t strand(std::uint32_t arc) { return m_strand[m_sets.root(arc)]; }

  // Whether an arc lies in a strand with others.
  bool has_others(std::uint32_t arc) { return m_size[m_sets.root(arc)] > 1; }

  void read_arcs(Side side, std::uint32_t node, std::vector<std::uint32_t>& result) const
  {
    result.clear();
    for (std::uint32_t arc = m_graph.first_arc(side, node); arc != no_arc;
         arc = m_graph.next_arc(side, arc))
      result.push_back(arc);
  }

  // Makes one set of those of two arcs.
  void join(std::uint32_t arc, std::uint32_t other)
  {
    arc = m_sets.root(arc);
    other = m_sets.root(other);
    if (arc == other)
      return;
    m_size[arc] += m_size[other];
    m_sets.join(other, arc);
  }

  void pass(std::uint32_t node, const Branch* begin, const Branch* end)
  {
    read_arcs(opposite_side(m_side), node, m_incoming);
    read_arcs(m_side, node, m_outgoing);
    arrive(node);
    if (m_arc_that_goes_on != no_arc)
      lead_on();
    for (const Branch* branch = begin; branch != end; ++branch)
      join(branch->other_arc, branch->arc);
    if (m_arriving.size() == 1 && !m_has_arcs_that_end && are_one_set(m_outgoing))
      pass_by(node);
    else
      leave(node);
  }

  // Tells the strands that end at a node from those that go on, and ends them.
  void arrive(std::uint32_t node)
  {
    m_arriving.clear();
    m_arc_that_goes_on = no_arc;
    m_has_arcs_that_end = false;
    for (const std::uint32_t arc : m_incoming) {
      if (has_others(arc)) {
        m_arriving.push_back(strand(arc));
        m_arc_that_goes_on = arc;
      } else {
        m_has_arcs_that_end = true;
        if (strand(arc) != no_arc)
          m_zipped.end_arc(strand(arc), node);
      }
    }
    std::sort(m_arriving.begin(), m_arriving.end());
    m_arriving.erase(std::unique(m_arriving.begin(), m_arriving.end()), m_arriving.end());
  }

  // Makes one set of the strands that go on. The arcs that end leave it, one that leads on enters.
  void lead_on()
  {
    std::uint32_t number_of_arcs = 0;
    for (const std::uint32_t arc : m_incoming) {
      if (!has_others(arc))
        continue;
      join(m_arc_that_goes_on, arc);
      ++number_of_arcs;
    }
    CGAL_assertion(m_size[m_sets.root(m_arc_that_goes_on)] >= number_of_arcs);
    m_size[m_sets.root(m_arc_that_goes_on)] -= number_of_arcs;
    if (!m_outgoing.empty())
      join(m_arc_that_goes_on, m_outgoing.front());
  }

  // Lets the only strand at a node go on.
  void pass_by(std::uint32_t node)
  {
    const std::uint32_t position = m_arriving.front();
    m_strand[m_sets.root(m_arc_that_goes_on)] = position;
    for (const std::uint32_t arc : m_outgoing)
      m_first[arc] = position;
    if (m_outgoing.empty())
      for (const std::uint32_t arc : m_incoming)
        m_next_to[arc] = end_on(opposite_side(m_side), m_graph.arcs()[arc]);
    m_graph.remove_node(node);
  }

  // Begins new arcs at a node.
  void leave(std::uint32_t node)
  {
    if (m_arc_that_goes_on != no_arc) {
      const std::uint32_t position = m_zipped.begin_arc(node);
      m_strand[m_sets.root(m_arc_that_goes_on)] = position;
      for (const std::uint32_t arriving : m_arriving) {
        m_zipped.end_arc(arriving, node);
        m_zipped.set_next(arriving, position);
      }
    }
    for (const std::uint32_t arc : m_outgoing) {
      if (!has_others(arc))
        continue;
      std::uint32_t& position = m_strand[m_sets.root(arc)];
      if (position == no_arc)
        position = m_zipped.begin_arc(node);
      m_first[arc] = position;
    }
  }

  bool are_one_set(const std::vector<std::uint32_t>& arcs)
  {
    return std::all_of(arcs.begin(), arcs.end(), [&](std::uint32_t arc) {
      return m_sets.root(arc) == m_sets.root(arcs.front());
    });
  }

  Folded_graph& m_graph;
  const Side m_side;
  std::vector<Branch> m_branches;
  Disjoint_sets m_sets; // of arcs: those of a strand, and those that have left it
  // by the root of the set: how many arcs are in the strand, and the new arc that the strand
  // becomes
  std::vector<std::uint32_t> m_size, m_strand;
  // by arc, if it is zipped: the new arc where its points begin their way, and the node that they
  // go next to if they do not keep their heights
  std::vector<std::uint32_t> m_first, m_next_to;
  Zipped_arcs m_zipped;
  // at a node: the arcs, the new arcs that arrive, any arc of the strands that go on
  std::vector<std::uint32_t> m_incoming, m_outgoing, m_arriving;
  std::uint32_t m_arc_that_goes_on = no_arc;
  bool m_has_arcs_that_end = false;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_BRANCH_ZIPPER_H
