// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_MINIMUM_SPANNING_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_MINIMUM_SPANNING_FOREST_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Link_cut_forest.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The numbers of arcs, from the highest lower node to the lowest one.
inline std::vector<std::uint32_t>
sorted_downwards(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
{
  return items_sorted_by_counting(arcs.size(), number_of_nodes, [&](std::size_t arc) {
    return number_of_nodes - 1 - arcs[arc].lower;
  });
}

// What is known of a set of arcs: the one with the highest upper node.
struct Highest_arc
{
  Highest_arc() = default;
  Highest_arc(std::uint32_t arc, const Arc_ends& ends) : upper(ends.upper), arc(arc) {}

  friend Highest_arc operator+(const Highest_arc& a, const Highest_arc& b)
  {
    return a.upper < b.upper ? b : a;
  }

  std::uint32_t upper = 0, arc = no_arc; // the upper node of an arc is not 0
};

// A spanning forest of a Reeb graph, its arcs given one by one from the highest lower node to the
// lowest one, that is kept a minimum one with respect to the upper nodes of the arcs. So of all
// paths between two nodes the one in the forest goes up least.
//
// The loops of extended persistence fall out. A pair has its merge at or below m and its split at
// or above s for every independent cycle of the arcs between the heights s and m. Of these arcs the
// forest of the arcs down to s holds a spanning forest, so the independent cycles are as many as
// the arcs that have left the forest, or not entered it, by then: one at every split that completes
// a cycle, and its merge is the upper node of the arc. It does not matter which one leaves of
// several arcs with the same upper node, nor in which order those with the same lower node come.
//
// `Summary` says what is known of the arcs on a path: a Highest_arc, and what others want to know.
template <class Summary = Highest_arc>
class Minimum_spanning_forest
{
public:
  // The ends of an arc must not change while it is in the forest.
  Minimum_spanning_forest(std::size_t number_of_nodes, const std::vector<Arc_ends>& arcs)
    : m_number_of_nodes(number_of_nodes)
    , m_arcs(arcs)
    , m_forest(number_of_nodes + arcs.size())
    , m_components(number_of_nodes)
  {}

  // A part of a path; it may be empty. It goes from node to node, or begins or ends with an arc.
  using Path = typename Link_cut_forest<Summary>::Root;
  static constexpr Path empty_path = Link_cut_forest<Summary>::no_item;

  struct Cycle
  {
    std::uint32_t highest_arc; // that has left the forest, or not entered it; `no_arc`: no cycle
    Path path;                 // of the others, from the upper end of that arc to the lower one
  };

  // See Splay_sequences.
  std::uint64_t number_of_steps() const { return m_forest.number_of_steps(); }

  // Gives the forest the next arc. Returns the cycle that it completes, if any.
  Cycle add(std::uint32_t arc)
  {
    const Arc_ends& ends = m_arcs[arc];
    CGAL_assertion(ends.lower < ends.upper && ends.upper < m_number_of_nodes);
    CGAL_assertion(ends.lower <= m_lowest_node);
    m_lowest_node = ends.lower;
    const std::uint32_t lower_component = m_components.root(ends.lower),
                        upper_component = m_components.root(ends.upper);
    if (lower_component != upper_component) {
      m_components.join(lower_component, upper_component);
      set_summary(arc);
      m_forest.insert(item_of(arc), ends.lower, ends.upper);
      return {no_arc, empty_path};
    }
    const Path path = m_forest.path(ends.lower, ends.upper);
    const Highest_arc highest = m_forest.sum(path);
    CGAL_assertion(highest.arc != no_arc);
    if (highest.upper <= ends.upper)
      return {arc, reversed(path)};
    auto [first, last] = m_forest.cut_out(item_of(highest.arc));
    const std::uint32_t end_of_first = cut_off_last_node(first);
    first = join_by_node(first, end_of_first, empty_path);
    if (end_of_first == highest.upper)
      return {highest.arc, join_by_arc(reversed(first), arc, reversed(last))};
    return {highest.arc, join_by_arc(last, arc, first)};
  }

  struct Node_on_path
  {
    std::uint32_t node, next_arc; // `no_arc` at the end of the path
  };

  // The last node on a path downwards from one node to another one for which `holds(node)` is true.
  // It must be true for the first one, and for no node below one for which it is not.
  template <class Holds>
  Node_on_path last_on_path_down(std::uint32_t node, std::uint32_t lower_node, const Holds& holds)
  {
    const auto last =
        m_forest.last_on_path(node, lower_node, [&](std::uint32_t item, const Summary&) {
          return holds(lower_end(item));
        });
    CGAL_assertion(last.item != Link_cut_forest<Summary>::no_item);
    return {last.item, last.item == lower_node ? no_arc : arc_of(last.next)};
  }

  // The path of a cycle can be changed. Its arcs and nodes must be put together again before
  // anything else is done with the forest; arcs may be left out.

  static Path path_of_node(std::uint32_t node) { return node; }

  Path reversed(Path path)
  {
    m_forest.reverse(path);
    return path;
  }

  // One path after the other, with an arc, or a node, between them.
  Path join_by_arc(Path first, std::uint32_t arc, Path last)
  {
    set_summary(arc);
    return m_forest.join(first, item_of(arc), last);
  }
  Path join_by_node(Path first, std::uint32_t node, Path last)
  {
    return m_forest.join(first, node, last);
  }

  std::uint32_t cut_off_first_node(Path& path) { return m_forest.cut_off_first(path); }
  std::uint32_t cut_off_last_node(Path& path) { return m_forest.cut_off_last(path); }
  std::uint32_t cut_off_first_arc(Path& path) { return arc_of(m_forest.cut_off_first(path)); }

  // The nodes above another one at the beginning of a path downwards, and the arcs between them.
  Path cut_off_above(std::uint32_t node, Path& path)
  {
    return m_forest.cut_off_while(
        path, [&](std::uint32_t item, const Summary&) { return lower_end(item) > node; });
  }

  // The part of a path up to where it turns that begins downwards, or upwards, at a node, which it
  // contains or follows. `length` is a part of the summary, the sum over all arcs of the
  // differences of their ends.
  Path cut_off_monotone_part(bool begins_downwards, std::uint32_t node, Path& path)
  {
    return m_forest.cut_off_while(path, [&](std::uint32_t item, const Summary& sum) {
      const std::uint32_t end = begins_downwards ? lower_end(item) : upper_end(item);
      return begins_downwards ? end <= node && sum.length == node - end
                              : node <= end && sum.length == end - node;
    });
  }

  // Hangs a path on a node, a path of its own, that its first arc ends at.
  void hang(Path path, std::uint32_t node) { m_forest.hang(path, node); }

private:
  // the nodes, then the arcs, each between its ends
  bool is_node(std::uint32_t item) const { return item < m_number_of_nodes; }
  std::uint32_t item_of(std::uint32_t arc) const
  {
    return static_cast<std::uint32_t>(m_number_of_nodes + arc);
  }
  std::uint32_t arc_of(std::uint32_t item) const
  {
    return static_cast<std::uint32_t>(item - m_number_of_nodes);
  }

  void set_summary(std::uint32_t arc)
  {
    m_forest.set_summary(item_of(arc), Summary(arc, m_arcs[arc]));
  }

  std::uint32_t lower_end(std::uint32_t item) const
  {
    return is_node(item) ? item : m_arcs[arc_of(item)].lower;
  }
  std::uint32_t upper_end(std::uint32_t item) const
  {
    return is_node(item) ? item : m_arcs[arc_of(item)].upper;
  }

  std::size_t m_number_of_nodes;
  const std::vector<Arc_ends>& m_arcs;
  Link_cut_forest<Summary> m_forest;
  Disjoint_sets m_components;
  std::uint32_t m_lowest_node = no_node; // of the arcs so far
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_MINIMUM_SPANNING_FOREST_H
