// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_GAP_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_GAP_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/persistence_gaps.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

A gap of a persistence diagram: an interval in which no pair has its persistence.

\sa `persistence_gap()`
*/
struct Persistence_gap
{
  /// the largest persistence below the gap, or 0
  double lower = 0;
  /// the smallest persistence above the gap, which is one of a pair; 0 if there is no gap
  double upper = 0;
  /// a threshold in the middle of the gap: all pairs above the gap stay, all below it are cancelled
  double threshold = 0;
  /// how many pairs of minima and maxima have their persistence above the gap
  std::size_t number_of_pairs = 0;

  /// returns `upper - lower`.
  double width() const { return upper - lower; }
};

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

finds the widest gap of the persistence diagram of a Reeb graph, or the `k`-th widest one.

Noise makes many pairs of small persistence, a shape few of large persistence. A threshold between
the two that is the same for all shapes comes near to a pair of one of them, and whether that is
cancelled is chance; the middle of the widest gap is as far from all pairs as a threshold can be.

The pairs are those of minima and maxima that `persistence_pairs()` gives and that
`simplify_Reeb_graph()` can cancel, of all connected components of the mesh together. Their
persistences and 0 are sorted, and the gaps are the differences of neighbors. So there is always a
pair above a gap: of a function with nothing but noise, the largest pairs of noise stay. The pair of
a component (its lowest and its highest node) does not count, since nothing cancels it: its
persistence is the whole range, far above that of all limbs if the function is a distance from a
point. Pairs of loops do not count either, nor infinite persistences. Of equally wide gaps the higher
one comes first. (A gap that comes later may lie higher or lower than one that is wider: the
threshold of a larger `k` need not be smaller.)

<b>Stability.</b> Let the function be changed, let *d* be the difference between the largest and the
smallest of the changes of the vertices' values (if no value changes by more than *e*, *d* is at most
2 *e*), and let persistences be absolute. A constant that is added changes no persistence; so all
changes may be taken to be at most half of *d* in absolute value, and so is the bottleneck distance
of the diagrams, for every kind of pairs (\cgalCite{cohen_steiner_2009}): pairs are matched of which
each value differs by at most half of *d*, the persistence by at most *d*, and a pair without a
partner has a persistence of at most *d*. So the *i*-th largest persistence, 0 if there are fewer
pairs, changes by at most *d*, and the gap below it changes its width by at most 2 *d*. This means:

- A gap wider than 2 *d*, twice the change of the function, does not close, and as many pairs of every
  kind are above it as before.
- The widest gap stays the widest one if it is wider than all others by more than 4 *d*. The graph
  that `simplify_Reeb_graph()` makes with this threshold then has as many minima and as many maxima
  as before.

With relative persistences the same holds for the functions divided by their ranges.

\tparam Graph a model of `VertexListGraph` and `EdgeListGraph` with bundled properties as
        `persistence_pairs()` needs them
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param graph a Reeb graph that `compute_Reeb_graph()` or `simplify_Reeb_graph()` has made
\param k which gap: 1 for the widest one
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{threshold_is_absolute}
    \cgalParamDescription{whether persistences are differences of values rather than fractions of the range of the function on the connected component (of the values of its nodes, those that are infinite left out)}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the gap. If there are fewer than `k`, as in a graph of two nodes, `lower`, `upper` and
        `threshold` are 0: nothing is to be cancelled.

Takes O(m log m) time for a graph with *m* nodes and arcs.

\pre `k` is at least 1

\throws Input_error as `persistence_pairs()`

\sa `persistence_pairs()`
\sa `simplify_Reeb_graph()`
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Persistence_gap persistence_gap(const Graph& graph,
                                std::size_t k = 1,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  CGAL_precondition_msg(k >= 1, "the gaps are numbered from 1");
  std::vector<internal::Node_bundle<Graph>> nodes;
  std::vector<internal::Arc_bundle<Graph>> arcs;
  std::vector<internal::Arc_ends> ends;
  internal::read_graph(graph, nodes, arcs, ends);
  const std::vector<double> persistences = internal::branch_persistences(
      internal::values_of_nodes(nodes),
      ends,
      internal::choose_own_parameter(np, internal::tags::threshold_is_absolute, false));
  const internal::Gap gap = internal::kth_widest_gap(internal::persistence_gaps(persistences), k);
  Persistence_gap result;
  result.lower = gap.lower;
  result.upper = gap.upper;
  result.threshold = gap.threshold();
  result.number_of_pairs = static_cast<std::size_t>(
      std::count_if(persistences.begin(), persistences.end(), [&](double persistence) {
        return persistence > gap.lower;
      }));
  return result;
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_GAP_H
