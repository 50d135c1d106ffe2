// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The types of property maps and of graphs that the interface promises to take.

#define BOOST_TEST_MODULE test_generic_interface

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Index_mesh.h"
#include "plain_results.h"
#include "random_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using EPECK = CGAL::Exact_predicates_exact_constructions_kernel;

} // namespace

// ---------------------------------------------------------------------------------------------
// Property maps

BOOST_AUTO_TEST_SUITE(property_maps)

struct Torus_fixture
{
  Numbered_mesh<Mesh> input{rough_torus()};
  std::vector<double> values = rough_values(rough_torus());
};

// `scale` makes the values whole numbers.
template <class Value>
void check_values_of_type(const double scale)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  std::vector<double> values = rough_values(rough_torus());
  for (double& x : values) {
    x *= scale;
  }
  Scalar_result expected = scalar_result(input, values);
  auto map = values_of_vertices<Value>(input, values);
  check_equal(
      scalar_result<SMRG::Reeb_graph<Mesh, Value>, int>(input, boost::make_assoc_property_map(map)),
      expected);
}

BOOST_AUTO_TEST_CASE(types_of_values)
{
  check_values_of_type<float>(1);
  check_values_of_type<int>(1024);
  check_values_of_type<long long>(1024);
  check_values_of_type<EPECK::FT>(1);
}

BOOST_FIXTURE_TEST_CASE(values_and_nodes_of_different_types, Torus_fixture)
{
  auto map = values_of_vertices<float>(input, values);
  check_equal(
      scalar_result<SMRG::Reeb_graph<Mesh>, int>(input, boost::make_assoc_property_map(map)),
      scalar_reference());
}

template <class VertexScalarMap>
void check_scalar_map(const Numbered_mesh<Mesh>& input, const VertexScalarMap& scalar_map)
{
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(
      input.mesh, scalar_map, graph, SMRG::parameters::collect_arc_vertices(true));
  check_equal(plain(input, graph), scalar_reference().graph);
}

BOOST_FIXTURE_TEST_CASE(kinds_of_scalar_maps, Torus_fixture)
{
  auto internal_map = input.mesh.add_property_map<Vertex, double>("v:values", 0).first;
  for (Vertex v : input.vertices) {
    internal_map[v] = values[input.number[v]];
  }
  check_scalar_map(input, internal_map);

  const auto const_map = values_of_vertices<double>(input, values);
  check_scalar_map(input,
                   boost::const_associative_property_map<Vertex_values<Mesh, double>>(const_map));

  check_scalar_map(input,
                   function_map<Vertex>([this](Vertex v) { return values[input.number.at(v)]; }));

  // vertex descriptors of Surface_mesh convert to numbers
  check_scalar_map(input, CGAL::make_property_map(values));
  const std::vector<double>& const_values = values;
  check_scalar_map(input, CGAL::make_property_map(const_values));

  const auto index_map = get(boost::vertex_index, input.mesh);
  check_scalar_map(input, boost::make_iterator_property_map(values.begin(), index_map));
}

// Differences that `double` cannot represent.
BOOST_AUTO_TEST_CASE(large_whole_values)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  std::mt19937 rng(14);
  const std::vector<std::size_t> ranks = random_permutation(input.vertices.size(), rng);
  std::vector<double> small;
  std::vector<long long> large;
  for (const std::size_t rank : ranks) {
    small.push_back(static_cast<double>(rank));
    large.push_back((1LL << 60) + static_cast<long long>(rank));
  }
  auto small_map = values_of_vertices<double>(input, small);
  auto large_map = values_of_vertices<long long>(input, large);
  SMRG::Reeb_graph<Mesh> expected;
  SMRG::Reeb_graph<Mesh, long long> graph;
  SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(small_map), expected);
  SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(large_map), graph);
  BOOST_REQUIRE_EQUAL(num_vertices(graph), num_vertices(expected));
  for (std::size_t i = 0; i < num_vertices(graph); ++i) {
    BOOST_CHECK(graph[i].vertex == expected[i].vertex);
    BOOST_CHECK_EQUAL(graph[i].value - (1LL << 60), static_cast<long long>(expected[i].value));
  }
  // no pair has persistence 0
  SMRG::simplify_Reeb_graph(input.mesh, boost::make_assoc_property_map(large_map), graph);
  BOOST_CHECK_EQUAL(num_vertices(graph), num_vertices(expected));
}

BOOST_AUTO_TEST_CASE(types_of_arc_numbers)
{
  Index_mesh mesh = rough_torus();
  mesh.points.push_back({9, 9, 9}); // isolated
  std::vector<double> values = rough_values(rough_torus());
  values.push_back(0.5);
  const Numbered_mesh<Mesh> input(mesh);
  using Graph = SMRG::Reeb_graph<Mesh>;
  const auto scalar_map = values_as_map(input, values);

  const Scalar_result expected = scalar_result<Graph, std::size_t>(input, scalar_map);
  BOOST_CHECK_EQUAL(expected.arc_of_vertex.back(), -1);
  BOOST_CHECK_EQUAL(expected.simplified_arc_of_vertex.back(), -1);
  BOOST_CHECK_EQUAL(std::count(expected.arc_of_vertex.begin(), expected.arc_of_vertex.end(), -1),
                    1);
  const Plain_graph& graph = expected.simplified_graph;
  BOOST_CHECK_EQUAL(std::count_if(graph.nodes.begin(),
                                  graph.nodes.end(),
                                  [&](const Plain_node& node) {
                                    return node.vertex + 1 == mesh.points.size() &&
                                           node.type == SMRG::Reeb_node_type::ISOLATED;
                                  }),
                    1);
  check_equal(scalar_result<Graph, int>(input, scalar_map), expected);
  check_equal(scalar_result<Graph, unsigned>(input, scalar_map), expected);
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Graph types

BOOST_AUTO_TEST_SUITE(graph_types)

struct My_node
{
  std::string name = "unset";
  Vertex vertex;
  std::size_t id = 99;
  SMRG::Reeb_node_type type = SMRG::Reeb_node_type::DEGENERATE;
  double value = -99;
  std::vector<int> more;
};

struct My_arc
{
  double weight = 2.5;
  std::vector<Vertex> vertices;
  std::size_t id = 99;
};

template <class OutEdgeList, class VertexList, class Directed>
using My_graph = boost::adjacency_list<OutEdgeList, VertexList, Directed, My_node, My_arc>;

using Graph_types = boost::mpl::list<My_graph<boost::listS, boost::vecS, boost::directedS>,
                                     My_graph<boost::vecS, boost::listS, boost::undirectedS>,
                                     My_graph<boost::listS, boost::listS, boost::bidirectionalS>,
                                     My_graph<boost::multisetS, boost::vecS, boost::undirectedS>>;

BOOST_AUTO_TEST_CASE_TEMPLATE(user_graph, Graph, Graph_types)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  const auto map = values_as_map(input, values);
  // the graph is not empty before
  Graph graph;
  const auto a = add_vertex(graph), b = add_vertex(graph);
  add_edge(a, b, graph);
  add_edge(a, b, graph);
  const auto set_own_members = [&]() {
    const auto nodes = get(boost::vertex_bundle, graph);
    for (auto n : CGAL::make_range(vertices(graph))) {
      BOOST_CHECK_EQUAL(nodes[n].name, "unset");
      nodes[n].name = std::to_string(input.number.at(nodes[n].vertex));
      nodes[n].more = {static_cast<int>(nodes[n].id), 1};
    }
  };
  check_equal(scalar_result<int>(input, map, graph, set_own_members), scalar_reference());

  // the members that the package does not know
  for (auto n : CGAL::make_range(vertices(graph))) {
    const My_node& node = get(boost::vertex_bundle, graph)[n];
    BOOST_CHECK_EQUAL(node.name, std::to_string(input.number.at(node.vertex)));
    BOOST_REQUIRE_EQUAL(node.more.size(), 2u);
    BOOST_CHECK(scalar_reference().graph.nodes[static_cast<std::size_t>(node.more[0])].vertex ==
                input.number.at(node.vertex));
  }
  for (auto e : CGAL::make_range(edges(graph))) {
    BOOST_CHECK_EQUAL(get(boost::edge_bundle, graph)[e].weight, 2.5);
  }
}

// The ends of an arc are told apart whatever its source is: that of out_edges() is the node asked.
template <class Graph>
void check_ends_of_arcs()
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  Graph graph;
  SMRG::compute_Reeb_graph(input.mesh, values_as_map(input, values), graph);
  const auto nodes = get(boost::vertex_bundle, graph);
  std::size_t number_of_reversed_arcs = 0;
  for (auto n : CGAL::make_range(vertices(graph))) {
    for (auto arc : CGAL::make_range(out_edges(n, graph))) {
      const auto lower = SMRG::lower_node(arc, graph), upper = SMRG::upper_node(arc, graph);
      BOOST_CHECK_LT(nodes[lower].id, nodes[upper].id);
      BOOST_CHECK((n == lower && target(arc, graph) == upper) ||
                  (n == upper && target(arc, graph) == lower));
      number_of_reversed_arcs += n == upper ? 1 : 0;
    }
  }
  BOOST_CHECK_EQUAL(number_of_reversed_arcs, num_edges(graph));
  for (auto arc : CGAL::make_range(edges(graph))) {
    BOOST_CHECK_LT(nodes[SMRG::lower_node(arc, graph)].id, nodes[SMRG::upper_node(arc, graph)].id);
  }
}

BOOST_AUTO_TEST_CASE(ends_of_arcs)
{
  check_ends_of_arcs<SMRG::Reeb_graph<Mesh>>();
  check_ends_of_arcs<My_graph<boost::vecS, boost::listS, boost::undirectedS>>();
}

// In the default type the source of an edge is its lower node, and nodes and arcs are in order.
BOOST_AUTO_TEST_CASE(default_graph_is_in_order)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  SMRG::Reeb_graph<Mesh> graph;
  const auto map = values_as_map(input, values);
  for (int round = 0; round < 2; ++round) {
    if (round == 0) {
      SMRG::compute_Reeb_graph(input.mesh, map, graph);
    } else {
      SMRG::simplify_Reeb_graph(
          input.mesh, map, graph, SMRG::parameters::persistence_threshold(scalar_threshold));
    }
    std::size_t id = 0, last_lower = 0;
    for (auto e : CGAL::make_range(edges(graph))) {
      BOOST_CHECK_EQUAL(graph[e].id, id++);
      BOOST_CHECK_LT(source(e, graph), target(e, graph));
      BOOST_CHECK_LE(last_lower, source(e, graph));
      last_lower = source(e, graph);
    }
    for (auto n : CGAL::make_range(vertices(graph))) {
      BOOST_CHECK_EQUAL(graph[n].id, n);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
