// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_BRANCHES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_BRANCHES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Branch_zipper.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Folded_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The pairs of a graph as it is now, in an order in which they can be cancelled. `values` increase
// with the nodes.
inline std::vector<Extremum_pair>
extremum_pairs(const Folded_graph& graph, const std::vector<double>& values)
{
  return Extremum_pairing(
             values, graph.arcs(), [&](std::uint32_t arc) { return graph.is_arc(arc); })
      .run();
}

// Cancels a pair if its branch is a single arc: it goes into the arc that it hangs on. Returns
// whether it was one.
inline bool cancel_leaf(Folded_graph& graph, const Extremum_pair& pair)
{
  const Side side = pair.side, other_side = opposite_side(side);
  const std::uint32_t arc = graph.heir(other_side, pair.arc);
  const std::uint32_t node = end_on(side, graph.arcs()[arc]);
  if (graph.number_of_arcs(side, node) != 0 || graph.number_of_arcs(other_side, node) != 1)
    return false;
  CGAL_assertion(node == pair.extremum);
  const std::uint32_t other_arc = graph.heir(other_side, pair.other_arc);
  graph.set_heir(other_side, arc, other_arc);
  graph.glue(arc, other_arc);
  graph.remove_node(node);
  graph.pass_through_if_regular(pair.saddle);
  return true;
}

// Cancels the pairs of some extrema on a side, all at once.
inline void zip_branches(Folded_graph& graph,
                         const std::vector<double>& values,
                         Side side,
                         const std::vector<bool>& is_extremum_of_pair)
{
  std::vector<Branch_zipper::Branch> branches;
  for (const Extremum_pair& pair : extremum_pairs(graph, values))
    if (pair.side == side && is_extremum_of_pair[pair.extremum])
      branches.push_back({pair.saddle, pair.arc, pair.other_arc});
  Branch_zipper(graph, side, std::move(branches)).run();
}

// Cancels (minimum, merge) and (maximum, split) pairs of a Reeb graph: some of its
// `extremum_pairs()`, in their order. Of every component these must be the first ones.
//
// To cancel a minimum, two paths are zipped together that descend from its saddle, one to the
// minimum, the other past its height: points of the same height become one (Agarwal, Edelsbrunner,
// Harer, Wang, "Extreme elevation on a 2-manifold", 2006). If the branch is a single arc, the zip
// just takes it away; if other arcs hang on it, they hang on the other path afterwards, at their
// own heights. A zip removes its pair and leaves all other extended persistence pairs as they are,
// loops included.
//
// What hangs on a branch would move from branch to branch, if one was zipped after the other. So
// only branches that are single arcs are taken away one by one; then all others on a side are
// zipped at once, see Branch_zipper. The pairs on the other side do not change thereby. All takes
// O(m log m) time for m nodes and arcs.
//
// Vertices of the mesh follow their arcs: those of a branch that is a single arc go to the arc that
// it hung on, others to the points of the same height. (The end of a branch on which nothing hangs
// any more goes to the arc next to the last node that something hangs on.)
inline void cancel_pairs(Folded_graph& graph,
                         const std::vector<double>& values,
                         const std::vector<Extremum_pair>& pairs)
{
  std::array<std::vector<bool>, 2> is_left; // by side and extremum
  for (const Extremum_pair& pair : pairs) {
    if (cancel_leaf(graph, pair))
      continue;
    is_left[pair.side].resize(graph.number_of_nodes(), false);
    is_left[pair.side][pair.extremum] = true;
  }
  for (const Side side : {BELOW, ABOVE})
    if (!is_left[side].empty())
      zip_branches(graph, values, side, is_left[side]);
}

// Cancels all pairs of persistence 0, and those for which `is_small(pair)` holds; if it holds for
// a pair, it must hold for all pairs of smaller persistence in the same component. `values`
// increase with the nodes.
template <class IsSmall>
void cancel_branches(Folded_graph& graph,
                     const std::vector<double>& values,
                     const IsSmall& is_small)
{
  CGAL_precondition(values.size() == graph.number_of_nodes());
  CGAL_precondition(std::is_sorted(values.begin(), values.end()));
  std::vector<Extremum_pair> pairs = extremum_pairs(graph, values);
  pairs.erase(std::remove_if(pairs.begin(),
                             pairs.end(),
                             [&](const Extremum_pair& pair) {
                               return pair.persistence != 0 && !is_small(pair);
                             }),
              pairs.end());
  cancel_pairs(graph, values, pairs);
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_CANCEL_BRANCHES_H
