// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_PAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_PAIRS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/loop_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The kinds of pairs of extended persistence that a Reeb graph has. Birth and death are those of
\cgalCite{cohen_steiner_2009}: first the sublevel sets grow, then the superlevel sets are filled
from the top.
*/
enum class Persistence_pair_kind {
  /// A minimum, and the node where its component of the sublevel set merges into one with a lower
  /// minimum (ordinary pair of dimension 0).
  MINIMUM,
  /// A maximum, and the node where its component of the superlevel set merges into one with a
  /// higher maximum, that is, where it splits off (relative pair of dimension 1).
  MAXIMUM,
  /// The lowest and the highest node of a connected component (extended pair of dimension 0). They
  /// are the same one if the component is an isolated node.
  COMPONENT,
  /// The merge that completes a loop, and the split where the loop begins (extended pair of
  /// dimension 1).
  LOOP
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

A persistence pair of a Reeb graph. `birth` is the minimum, maximum, minimum or merge, `death` the
merge, split, maximum or split, for the kinds of pairs in the order of `Persistence_pair_kind`.

\tparam Graph the type of the Reeb graph

\sa `persistence_pairs()`
*/
template <class Graph>
struct Persistence_pair
{
  /// a node of the graph
  using node_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  /// the type of the function's values
  using FT = std::decay_t<decltype(std::declval<internal::Node_bundle<Graph>>().value)>;

  /// the kind of the pair
  Persistence_pair_kind kind = Persistence_pair_kind::MINIMUM;
  /// the first node
  node_descriptor birth = {};
  /// the second node
  node_descriptor death = {};
  /// the value at the first node
  FT birth_value = FT(0);
  /// the value at the second node
  FT death_value = FT(0);

  /// returns the node of the two that lies lower.
  node_descriptor lower() const { return is_birth_lower() ? birth : death; }

  /// returns the node of the two that lies higher.
  node_descriptor upper() const { return is_birth_lower() ? death : birth; }

  /// returns the difference of the values, not negative, also for number types other than
  /// floating point. It is 0 for equal infinite values.
  double persistence() const
  {
    return is_birth_lower() ? internal::difference(birth_value, death_value)
                            : internal::difference(death_value, birth_value);
  }

private:
  bool is_birth_lower() const
  {
    return kind == Persistence_pair_kind::MINIMUM || kind == Persistence_pair_kind::COMPONENT;
  }
};

namespace internal {

// The same with numbers of nodes.
struct Numbered_persistence_pair
{
  Persistence_pair_kind kind;
  std::uint32_t birth, death;
};

// All pairs, sorted by kind, birth and death.
inline std::vector<Numbered_persistence_pair>
persistence_pairs(const std::vector<double>& values, const std::vector<Arc_ends>& arcs)
{
  const std::size_t n = values.size();
  std::vector<Numbered_persistence_pair> pairs;
  for (const Extremum_pair& pair :
       Extremum_pairing(values, arcs, [](std::uint32_t) { return true; }).run())
    pairs.push_back(
        {pair.side == BELOW ? Persistence_pair_kind::MINIMUM : Persistence_pair_kind::MAXIMUM,
         pair.extremum,
         pair.saddle});
  CGAL_assertion_code(const std::size_t first_loop = pairs.size());
  for (const Loop_pair& pair : loop_pairs(n, arcs))
    pairs.push_back({Persistence_pair_kind::LOOP, pair.merge, pair.split});

  CGAL_assertion_code(const std::size_t first_component = pairs.size());
  Disjoint_sets components(n);
  for (const Arc_ends& ends : arcs)
    components.join(components.root(ends.lower), components.root(ends.upper));
  std::vector<std::uint32_t> pair_of_component(n, no_node);
  for (std::uint32_t node = 0; node < n; ++node) {
    std::uint32_t& pair = pair_of_component[components.root(node)];
    if (pair == no_node) {
      pair = static_cast<std::uint32_t>(pairs.size());
      pairs.push_back({Persistence_pair_kind::COMPONENT, node, node});
    }
    pairs[pair].death = node;
  }
  CGAL_assertion((first_component - first_loop) + n ==
                 arcs.size() + (pairs.size() - first_component));

  std::sort(pairs.begin(),
            pairs.end(),
            [](const Numbered_persistence_pair& p, const Numbered_persistence_pair& q) {
              return std::tie(p.kind, p.birth, p.death) < std::tie(q.kind, q.birth, q.death);
            });
  return pairs;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the persistence pairs of a Reeb graph: its extended persistence
(\cgalCite{cohen_steiner_2009}).

Every node without arcs below is the birth of a pair of a minimum, or the lowest one of its
component; every node without arcs above is the birth of a pair of a maximum, or the highest one of
its component; a node with *d* > 1 arcs below is the second node of pairs of minima and the first
node of pairs of loops, *d* - 1 together; one with *d* > 1 arcs above is the second node of pairs of
maxima and of loops, *d* - 1 together. There are as many pairs of loops as the graph has independent
loops (arcs - nodes + components). So every node of one of the types minimum, maximum, merge and
split is in exactly one pair.

The nodes are compared by their numbers, a strict total order also where values are equal; the
values are only reported. They are pairs of the extended persistence of the function on the mesh:
its ordinary and extended pairs of dimension 0, its relative ones of dimension 1, and those extended
ones of dimension 1 that have their birth above their death (\cgalCite{bauer_2014}). As
`compute_Reeb_graph()` cancels them, no pair of an extremum has persistence 0; such loops are
reported.

If the function is reversed, the graph is upside down: the pairs of minima and maxima change places,
and those of components and loops their ends.

The loops are found in one pass downwards, in amortized O(log m) time each: by a spanning forest of
the arcs so far that is a minimum one with respect to their upper nodes, in a link-cut tree
(\cgalCite{sleator_1985}). (Without such a tree, and upside down, it is the pass of
\cgalCite{tu_2019}.)

\tparam Graph a model of `VertexListGraph` and `EdgeListGraph` with bundled properties that have (at
        least) the members `id` and `value` of `Reeb_node` and `id` of `Reeb_arc`; for example any
        graph that `compute_Reeb_graph()` fills
\tparam OutputIterator a model of `OutputIterator` with value type `Persistence_pair<Graph>`

\param graph a Reeb graph that `compute_Reeb_graph()` or `simplify_Reeb_graph()` has made
\param out receives the pairs, sorted by kind, then by the numbers of their first and second nodes

\return `out` after the last pair

Takes O(m log m) time for a graph with *m* nodes and arcs.

\throws Input_error if a value is not a number, if nodes or arcs are not numbered from 0
        without gaps, or if the values do not increase with the numbers; nothing is written to `out`
        then

\sa `IO::write_persistence_diagram()`
\sa `simplify_Reeb_graph()`
*/
template <class Graph, class OutputIterator>
OutputIterator persistence_pairs(const Graph& graph, OutputIterator out)
{
  using node_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;

  std::vector<internal::Node_bundle<Graph>> nodes;
  std::vector<internal::Arc_bundle<Graph>> arcs;
  std::vector<internal::Arc_ends> ends;
  internal::read_graph(graph, nodes, arcs, ends);
  const auto pairs = internal::persistence_pairs(internal::values_of_nodes(nodes), ends);

  const auto node_map = get(boost::vertex_bundle, graph);
  std::vector<node_descriptor> descriptors(nodes.size());
  for (const node_descriptor node : CGAL::make_range(vertices(graph)))
    descriptors[node_map[node].id] = node;

  for (const internal::Numbered_persistence_pair& pair : pairs) {
    Persistence_pair<Graph> result;
    result.kind = pair.kind;
    result.birth = descriptors[pair.birth];
    result.death = descriptors[pair.death];
    result.birth_value = nodes[pair.birth].value;
    result.death_value = nodes[pair.death].value;
    *out++ = result;
  }
  return out;
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_PERSISTENCE_PAIRS_H
