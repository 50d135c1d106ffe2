// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Graph_update.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

simplifies a Reeb graph by cancelling its branches, and on demand its loops, of small persistence.

<b>Branches.</b> The pairs are those that `persistence_pairs()` gives: a minimum with the node where
its component of the sublevel set merges into one that has a lower minimum, and a maximum with a
node, upside down. The persistence of a pair is the difference of the two values. Pairs are
cancelled in the order of their persistence, those below the threshold and then as many more as the
number of leaves asks for. Every cancellation takes away one branch and changes no other pair and no
loop: what hung on a cancelled branch hangs on its neighbor afterwards, at the same height
(\cgalCite{agarwal_2006}). Pairs of persistence zero are always cancelled. The lowest minimum and
the highest maximum of a component always stay.

<b>Loops</b> stay unless `loop_persistence_threshold` is given. Then, after the branches, the loops
below that threshold are closed, those with the highest splits first: the cycle of the pair of split
and merge (of those that the split completes one whose highest node, the merge, lies lowest) is
folded flat, from its highest node downwards, so that points of the same height become one; what
hung on the cycle hangs on the fold, at the same height. Every closed loop makes the number of loops
smaller by exactly one, and none of persistence below the threshold is left. (Loops of infinite
persistence stay.)

- If the function is monotone on both sides of the cycle, from the merge to the split, then closing
  the loop takes away its pair and changes no other pair, neither of extrema nor of loops.
- Otherwise the cycle has peaks and valleys: nodes on it where branches or other loops leave in the
  wrong direction, and no fold is that exact. One peak after the other is folded down to the higher
  one of the valleys that are beside it then, and what is above that valley stays as a branch
  upwards. The pairs of extrema may then change, each by at most the persistence of the
  loop, and always towards smaller persistence; other loops may change as well. Loops and branches
  that fall below their thresholds thereby are taken away, too.

The nodes that stay keep their bundles, only `id` and `type` are brought up to date; the arcs are
new.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type
\tparam MutableGraph as in `compute_Reeb_graph()`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph a Reeb graph that `compute_Reeb_graph()` or this function has made from `tmesh` and
       `scalar_map`
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{persistence_threshold}
    \cgalParamDescription{pairs whose persistence is less than this are cancelled}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`}
    \cgalParamExtra{a fraction of the range of the function, for each connected component on its own (of the values of its nodes, those that are infinite left out), unless `threshold_is_absolute` is `true`}
  \cgalParamNEnd
  \cgalParamNBegin{persistence_gap}
    \cgalParamDescription{if it is a number *k* > 0, pairs are cancelled as with the `persistence_threshold` in the middle of the *k*-th widest gap of the persistence diagram, see `persistence_gap()`}
    \cgalParamType{an integer type, not negative}
    \cgalParamDefault{`0`: `persistence_threshold` counts}
    \cgalParamExtra{The gap is that of the graph before it is simplified. If there are fewer gaps, only pairs of persistence zero are cancelled.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_leaves}
    \cgalParamDescription{if more leaves, nodes without an arc below or without one above, than this number are left, pairs are cancelled until no more are, or until those are left that always stay: two for every component that is not a single node}
    \cgalParamType{an integer type, not negative}
    \cgalParamDefault{no limit}
    \cgalParamExtra{Pairs of different components are compared by their persistence as a fraction of the range of their component, unless `threshold_is_absolute` is `true`. The pairs below `persistence_threshold`, 0 if it is not given, or below the gap are cancelled in any case.}
  \cgalParamNEnd
  \cgalParamNBegin{loop_persistence_threshold}
    \cgalParamDescription{loops whose persistence is less than this are closed}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`: loops are never closed, not even those in a plateau}
    \cgalParamExtra{a fraction of the range of the function, as `persistence_threshold`, unless `threshold_is_absolute` is `true`}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_is_absolute}
    \cgalParamDescription{whether `persistence_threshold` and `loop_persistence_threshold` are differences of values rather than fractions of their range}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{the map that `compute_Reeb_graph()` has filled; it is brought up to date: the vertices of a cancelled branch that is a single arc go to an arc of the node that it hung on, whatever their values; those of other branches and of loops to the points of the same height}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
    \cgalParamExtra{`Reeb_arc::vertices` is brought up to date as well if it has been filled.}
  \cgalParamNEnd
  \cgalParamNBegin{face_arc_map}
    \cgalParamDescription{the map that `compute_Reeb_graph()` has filled; it is brought up to date: a face goes where a point of its old arc goes that lies as high as its middle vertex}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`, the same as for `compute_Reeb_graph()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(m log m) time for a graph with *m* nodes and arcs. To close loops, too, is proven to take
O((m + p) log<sup>2</sup> m) time at most, however long the cycles are (\cgalCite{georgiadis_2011}),
if they have *p* peaks beside the merges, which are O(m log m). No graphs are known that take more
than O(m log m), not even those that let merging change sides as often as it can. If there is
anything to bring up to date for *n* vertices or faces, O(n log m) more, or O(n log n) if
`Reeb_arc::vertices` has been filled.

\pre `persistence_threshold`, `persistence_gap`, `loop_persistence_threshold` and `number_of_leaves`
     are not negative, and no NaN
\pre not both `persistence_threshold` and `persistence_gap` are given and different from 0

\throws Input_error if a value is not a number, if the nodes or arcs of the graph are not numbered
        or the values of the nodes not sorted as `compute_Reeb_graph()` does it, or, where maps or
        `Reeb_arc::vertices` are brought up to date, if they, graph and function do not belong
        together; `graph` and the maps are then left as they were. (If there is not enough memory,
        `std::bad_alloc` is thrown, and the maps are left as they were, the graph too or empty.)

\sa `compute_Reeb_graph()`
\sa `persistence_pairs()`
\sa `persistence_gap()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void simplify_Reeb_graph(const TriangleMesh& tmesh,
                         VertexScalarMap scalar_map,
                         MutableGraph& graph,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Simplification_parameters parameters = internal::simplification_parameters(np);
  internal::Graph_update<TriangleMesh, VertexScalarMap, MutableGraph, NamedParameters>(
      tmesh, scalar_map, graph, np)
      .run(parameters);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SIMPLIFY_REEB_GRAPH_H
