// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_NODE_VALUES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_NODE_VALUES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

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
  Disjoint_sets components(n);
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
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_NODE_VALUES_H
