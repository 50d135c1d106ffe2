// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a Reeb graph must fulfil, whatever the mesh and the function.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CHECKS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CHECKS_H

#include "random_Reeb_graph_cases.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <vector>

namespace Reeb_graph_test {

// Everything that the documentation promises of any graph: numbers, order, types, no regular node,
// and the two mappings between vertices and arcs.
inline void check_consistency(const Case& c, const Graph& graph)
{
  const std::size_t n = num_vertices(graph), m = num_edges(graph);
  std::vector<std::size_t> down(n, 0), up(n, 0);
  std::vector<std::size_t> first_arc(n, SMRG::null_arc), last_arc(n, SMRG::null_arc);
  std::size_t number = 0;
  for (const auto arc : CGAL::make_range(edges(graph))) {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    BOOST_TEST(graph[arc].id == number);
    BOOST_TEST(lower < upper);
    ++up[lower];
    ++down[upper];
    if (first_arc[lower] == SMRG::null_arc)
      first_arc[lower] = number;
    if (last_arc[upper] == SMRG::null_arc)
      last_arc[upper] = number;
    ++number;
  }
  BOOST_TEST(number == m);

  std::vector<std::size_t> node_of_vertex(c.mesh.num_vertices(), n);
  for (std::size_t node = 0; node < n; ++node) {
    BOOST_TEST(graph[node].id == node);
    BOOST_TEST(graph[node].value == c.values[graph[node].vertex]);
    BOOST_TEST(graph[node].type == SMRG::type_of_Reeb_node(down[node], up[node]));
    BOOST_TEST(!(down[node] == 1 && up[node] == 1));
    if (node > 0)
      BOOST_TEST(graph[node - 1].value <= graph[node].value);
    BOOST_TEST(node_of_vertex[graph[node].vertex] == n);
    node_of_vertex[graph[node].vertex] = node;
  }

  std::vector<std::size_t> size_of_arc(m, 0);
  for (const Vertex v : c.mesh.vertices()) {
    const std::size_t arc = c.arcs[v];
    if (c.mesh.is_isolated(v)) {
      BOOST_TEST(arc == SMRG::null_arc);
      BOOST_TEST(node_of_vertex[v] < n);
      continue;
    }
    BOOST_REQUIRE(arc < m);
    ++size_of_arc[arc];
    const std::size_t node = node_of_vertex[v];
    if (node < n)
      BOOST_TEST(arc == (up[node] > 0 ? first_arc[node] : last_arc[node]));
  }
  for (const auto arc : CGAL::make_range(edges(graph))) {
    const std::vector<Vertex>& members = graph[arc].vertices;
    BOOST_TEST(members.size() == size_of_arc[graph[arc].id]);
    for (std::size_t i = 0; i < members.size(); ++i) {
      BOOST_TEST(c.arcs[members[i]] == graph[arc].id);
      if (i > 0)
        BOOST_TEST(c.values[members[i - 1]] <= c.values[members[i]]);
    }
  }
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CHECKS_H
