// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_READ_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_READ_GRAPH_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Extremum_pairs.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Number_sets.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/write_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>
#include <CGAL/utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Reads nodes and arcs, each at the position of its number.
template <class Graph>
void read_graph(const Graph& graph,
                std::vector<Node_bundle<Graph>>& nodes,
                std::vector<Arc_bundle<Graph>>& arcs,
                std::vector<Arc_ends>& ends)
{
  const auto node_map = get(boost::vertex_bundle, graph);
  const auto arc_map = get(boost::edge_bundle, graph);
  nodes.resize(num_vertices(graph));
  arcs.resize(num_edges(graph));
  ends.resize(arcs.size());
  std::vector<bool> is_node_read(nodes.size(), false), is_arc_read(arcs.size(), false);
  for (auto n : CGAL::make_range(vertices(graph))) {
    const std::size_t i = node_map[n].id;
    if (i >= nodes.size() || is_node_read[i])
      throw Reeb_graph_error("the nodes of the Reeb graph are not numbered from 0 without gaps");
    if (!CGAL::is_valid(node_map[n].value))
      throw Reeb_graph_error("the value of node " + std::to_string(i) + " is not a number");
    nodes[i] = node_map[n];
    is_node_read[i] = true;
  }
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i].value < nodes[i - 1].value)
      throw Reeb_graph_error("the values of the nodes of the Reeb graph do not increase with their "
                             "numbers");
  for (auto e : CGAL::make_range(edges(graph))) {
    const std::size_t i = arc_map[e].id;
    if (i >= arcs.size() || is_arc_read[i])
      throw Reeb_graph_error("the arcs of the Reeb graph are not numbered from 0 without gaps");
    arcs[i] = arc_map[e];
    is_arc_read[i] = true;
    const std::pair<std::size_t, std::size_t> ids =
        std::minmax({node_map[source(e, graph)].id, node_map[target(e, graph)].id});
    if (ids.first == ids.second)
      throw Reeb_graph_error("an arc of the Reeb graph begins and ends at the same node");
    ends[i] = {static_cast<std::uint32_t>(ids.first), static_cast<std::uint32_t>(ids.second)};
  }
}

// The difference of two values in `double`, also of infinite ones: equal values have difference 0.
// Numbers that are not floating-point ones may have more digits: what is converted is the
// difference, exactly or nearly.
template <class FT>
double difference(const FT& lower, const FT& upper)
{
  if constexpr (std::is_floating_point<FT>::value) {
    return persistence_between(lower, upper);
  } else if constexpr (std::is_integral<FT>::value) {
    // in unsigned numbers the difference cannot overflow
    using Unsigned = std::make_unsigned_t<FT>;
    return static_cast<double>(
        static_cast<Unsigned>(static_cast<Unsigned>(upper) - static_cast<Unsigned>(lower)));
  } else {
    return CGAL::to_double(upper - lower);
  }
}

// The values of the nodes for differences in `double`: floating-point numbers as they are, others
// less the lowest one.
template <class Node>
std::vector<double> values_of_nodes(const std::vector<Node>& nodes)
{
  using FT = std::decay_t<decltype(nodes.front().value)>;
  std::vector<double> values;
  values.reserve(nodes.size());
  for (const Node& node : nodes) {
    if constexpr (std::is_floating_point<FT>::value)
      values.push_back(static_cast<double>(node.value));
    else
      values.push_back(difference(nodes.front().value, node.value));
  }
  return values;
}

// For every node the fraction of the range of finite values of the nodes in its connected
// component.
inline std::vector<double> fractions_of_component_ranges(const std::vector<double>& values,
                                                         const std::vector<Arc_ends>& ends,
                                                         double fraction)
{
  const std::size_t n = values.size();
  if (std::isinf(fraction))
    return std::vector<double>(n, fraction);
  Number_sets components(n);
  for (const Arc_ends& e : ends)
    components.join(components.root(e.lower), components.root(e.upper));

  // values increase with the nodes: the first finite one of a component is its least
  std::vector<double> least(n, std::numeric_limits<double>::quiet_NaN()), range(n, 0.);
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(values[i]))
      continue;
    const std::uint32_t c = components.root(static_cast<std::uint32_t>(i));
    if (std::isnan(least[c]))
      least[c] = values[i];
    // scaled before the difference, which may overflow
    range[c] = fraction * values[i] - fraction * least[c];
  }
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = range[components.root(static_cast<std::uint32_t>(i))];
  return result;
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_READ_GRAPH_H
