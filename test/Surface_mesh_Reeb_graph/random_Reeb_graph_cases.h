// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A random case, and the Reeb graph in a form that compares: for the tests and for the fuzzer,
// which does without Boost.Test.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CASES_H
#define SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CASES_H

#include "Index_mesh.h"
#include "brute_force_Reeb_graph.h"
#include "random_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <type_traits>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<Vertex, double>;
using Arc_map = Mesh::Property_map<Vertex, std::size_t>;
using Graph = SMRG::Reeb_graph<Mesh>;

// How many random cases a test tries: as many as find bugs in seconds, or REEB_GRAPH_TEST_CASES of
// them.
inline unsigned number_of_random_cases()
{
  const char* const number = std::getenv("REEB_GRAPH_TEST_CASES");
  return number == nullptr ? 500 : static_cast<unsigned>(std::atol(number));
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

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_REEB_GRAPH_CASES_H
