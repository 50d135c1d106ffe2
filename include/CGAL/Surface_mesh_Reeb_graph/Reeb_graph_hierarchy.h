// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_HIERARCHY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_HIERARCHY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/persistence_gaps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Branch_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

All graphs that `simplify_Reeb_graph()` makes of a Reeb graph by cancelling branches, from the finest
to the coarsest: for pictures and searches that go through the thresholds.

The simplified graph changes where the threshold passes the persistence of a pair; between two such
persistences it stays the same, and is a *level* here. Level 0 is the graph in which only pairs of
persistence zero are cancelled, the last level the one in which all are that can be.

<b>Loops.</b> The levels are those of the branches, for the threshold `persistence_threshold`. Loops
stay at all levels, as they do unless a `loop_persistence_threshold` is given; cancelling branches
changes no pair of a loop. To close loops changes pairs of extrema, and so the levels: if loops are
to be closed at every level alike, `simplify_Reeb_graph()` is called with a
`loop_persistence_threshold` first, and a hierarchy is made of what is left. If they are to be closed
after the branches, as `simplify_Reeb_graph()` does it, it is called with both thresholds for the
graph of a level. Maps from vertices to arcs belong to no level: where they are wanted,
`simplify_Reeb_graph()` brings them up to date for the threshold of one.

Making a hierarchy takes O(m log m) time, in one pass over the pairs, and O(m) memory, for a graph
with *m* nodes and arcs. Each of its graphs is made in O(s log s + c log m) time for *s* nodes and
arcs and *c* connected components. Here, *s* counts the nodes of the graph that is made, and those
branches below the threshold that are not single arcs when their turn comes, because a pair of larger
persistence hangs on them: these are zipped together with their neighbors for every graph anew.

\tparam Graph a model of `VertexListGraph` and `EdgeListGraph` with bundled properties as
        `persistence_pairs()` needs them

\sa `simplify_Reeb_graph()`
\sa `persistence_gap()`
*/
template <class Graph>
class Reeb_graph_hierarchy
{
public:
  /*!
  makes the hierarchy of a Reeb graph, which is not needed any more afterwards.

  \tparam NamedParameters a sequence of
          \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

  \param graph a Reeb graph that `compute_Reeb_graph()` or `simplify_Reeb_graph()` has made
  \param np an optional sequence of named parameters among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{threshold_is_absolute}
      \cgalParamDescription{as in `simplify_Reeb_graph()`, for all thresholds of this class}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws Input_error as `persistence_pairs()`
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Reeb_graph_hierarchy(const Graph& graph,
                                const NamedParameters& np = CGAL::parameters::default_values())
    : m_branches(read(
          graph, internal::choose_own_parameter(np, internal::tags::threshold_is_absolute, false)))
    , m_persistences(m_branches.persistences())
  {}

  /// returns the persistences of the pairs that can be cancelled, increasing and without
  /// repetitions: where the simplified graph changes. A pair is cancelled if the threshold is larger
  /// than its persistence.
  const std::vector<double>& persistences() const { return m_persistences; }

  /// returns the number of levels, one more than `persistences()`.
  std::size_t number_of_levels() const { return m_persistences.size() + 1; }

  /// returns the level for a threshold: the number of persistences below it.
  /// \pre `threshold` is not negative, and no NaN
  std::size_t level(double threshold) const
  {
    CGAL_precondition_msg(threshold >= 0, "the threshold is negative or not a number");
    return static_cast<std::size_t>(
        std::lower_bound(m_persistences.begin(), m_persistences.end(), threshold) -
        m_persistences.begin());
  }

  /// returns a threshold of a level: 0 for the first, infinity for the last one, and else the middle
  /// between the persistences beside it, which `persistence_gap()` gives, too. (Where two
  /// persistences differ by rounding errors only, their order may be another one for
  /// `simplify_Reeb_graph()`.)
  /// \pre `level < number_of_levels()`
  double threshold(std::size_t level) const
  {
    CGAL_precondition_msg(level < number_of_levels(), "there are not so many levels");
    if (level == 0)
      return 0;
    if (level == m_persistences.size())
      return std::numeric_limits<double>::infinity();
    return internal::Gap{m_persistences[level - 1], m_persistences[level]}.threshold();
  }

  /*!
  makes the graph for a threshold: the same, with the same numbers of nodes and arcs, as
  `simplify_Reeb_graph()` makes with this `persistence_threshold` of the graph of the hierarchy, for
  every threshold. The nodes have their bundles, the arcs have new ones with their numbers.

  \tparam MutableGraph as in `compute_Reeb_graph()`, with the bundle for nodes that `Graph` has

  \param threshold the threshold
  \param graph the simplified graph; what it contained before is lost

  \pre `threshold` is not negative, and no NaN
  */
  template <class MutableGraph>
  void make_graph(double threshold, MutableGraph& graph) const
  {
    CGAL_precondition_msg(threshold >= 0, "the threshold is negative or not a number");
    const internal::Branch_hierarchy::Level level = m_branches.level(threshold);
    internal::write_graph(
        graph,
        level.nodes.size(),
        level.arcs,
        [&](std::size_t i) { return m_nodes[level.nodes[i]]; },
        [](std::size_t) { return internal::Arc_bundle<MutableGraph>(); });
  }

private:
  internal::Branch_hierarchy read(const Graph& graph, bool is_absolute)
  {
    std::vector<internal::Arc_bundle<Graph>> arcs;
    std::vector<internal::Arc_ends> ends;
    internal::read_graph(graph, m_nodes, arcs, ends);
    return internal::Branch_hierarchy(
        internal::values_of_nodes(m_nodes), std::move(ends), is_absolute);
  }

  std::vector<internal::Node_bundle<Graph>> m_nodes;
  internal::Branch_hierarchy m_branches;
  std::vector<double> m_persistences;
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_HIERARCHY_H
