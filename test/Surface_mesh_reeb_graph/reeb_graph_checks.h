// Copyright (c) 2026 The Surface_mesh_reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the Reeb graph share: a random case, and the graph in a form that compares.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CHECKS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CHECKS_H

#include "Index_mesh.h"
#include "brute_force_reeb_graph.h"
#include "random_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_reeb_graph;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<Vertex, double>;
using Arc_map = Mesh::Property_map<Vertex, std::size_t>;
using Graph = SMRG::Reeb_graph<Mesh>;

// How many random cases a test tries: a few thousand, or REEB_GRAPH_TEST_CASES of them.
inline unsigned number_of_random_cases()
{
  const char* const number = std::getenv("REEB_GRAPH_TEST_CASES");
  return number == nullptr ? 2000 : static_cast<unsigned>(std::atol(number));
}

// A mesh with a function. The vertices of the mesh have the indices of the index mesh.
struct Case
{
  Index_mesh index_mesh;
  Mesh mesh;
  Value_map values;
  Arc_map arcs;

  Case(const Index_mesh& im, const std::vector<double>& function) : index_mesh(im)
  {
    std::vector<Vertex> vertices;
    make_mesh(index_mesh, mesh, vertices);
    values = mesh.add_property_map<Vertex, double>("v:value").first;
    arcs = mesh.add_property_map<Vertex, std::size_t>("v:arc", 12345678).first;
    set(function);
  }

  void set(const std::vector<double>& function)
  {
    for (const Vertex v : mesh.vertices())
      values[v] = function[v];
  }
};

// The arcs with their regular vertices, as the oracle gives them.
inline std::vector<Comparable_arc> comparable_arcs(const Graph& graph)
{
  std::vector<std::size_t> node_vertices;
  for (const auto node : CGAL::make_range(vertices(graph)))
    node_vertices.push_back(graph[node].vertex);
  std::sort(node_vertices.begin(), node_vertices.end());

  std::vector<Comparable_arc> result;
  for (const auto arc : CGAL::make_range(edges(graph))) {
    std::vector<std::size_t> regular;
    for (const Vertex v : graph[arc].vertices)
      if (!std::binary_search(node_vertices.begin(), node_vertices.end(), std::size_t(v)))
        regular.push_back(v);
    result.push_back(comparable_arc(
        graph[source(arc, graph)].vertex, graph[target(arc, graph)].vertex, regular));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The extrema on one side: the vertices of the nodes without arcs below (or above).
inline std::vector<std::size_t> extrema(const Graph& graph, const bool minima)
{
  std::vector<bool> has_arc(num_vertices(graph), false);
  for (const auto arc : CGAL::make_range(edges(graph)))
    has_arc[minima ? target(arc, graph) : source(arc, graph)] = true;
  std::vector<std::size_t> result;
  for (const auto node : CGAL::make_range(vertices(graph)))
    if (!has_arc[node])
      result.push_back(graph[node].vertex);
  std::sort(result.begin(), result.end());
  return result;
}

// Everything that the documentation promises of any graph: numbers, order, types, no regular node, and
// the two mappings between vertices and arcs.
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
    BOOST_TEST(graph[node].type == SMRG::reeb_node_type(down[node], up[node]));
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
