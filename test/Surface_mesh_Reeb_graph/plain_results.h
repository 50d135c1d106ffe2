// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the interface share: meshes of any type with numbered vertices, and graphs and
// results as plain data, which can be compared whatever the types that they come from.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_PLAIN_RESULTS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_PLAIN_RESULTS_H

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Double_kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Double_kernel::Point_3>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;

// ---------------------------------------------------------------------------------------------
// Meshes with numbered vertices

template <class TriangleMesh>
using Vertex_of = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

template <class TriangleMesh>
struct Numbered_mesh
{
  TriangleMesh mesh;
  std::vector<Vertex_of<TriangleMesh>> vertices;
  std::map<Vertex_of<TriangleMesh>, std::size_t> number;

  Numbered_mesh() = default;
  explicit Numbered_mesh(const Index_mesh& input)
  {
    make_mesh(input, mesh, vertices);
    number_vertices();
  }
  // Descriptors may point into the mesh.
  Numbered_mesh(const Numbered_mesh&) = delete;
  Numbered_mesh& operator=(const Numbered_mesh&) = delete;

  void number_vertices()
  {
    number.clear();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      number[vertices[i]] = i;
    }
  }
};

template <class TriangleMesh, class Value>
using Vertex_values = std::map<Vertex_of<TriangleMesh>, Value>;

template <class Value, class TriangleMesh, class Values>
Vertex_values<TriangleMesh, Value>
values_of_vertices(const Numbered_mesh<TriangleMesh>& input, const Values& values)
{
  Vertex_values<TriangleMesh, Value> result;
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    result[input.vertices[i]] = Value(values[i]);
  }
  return result;
}

// The values of the vertices by their numbers, as a map. A lambda in its place would be another type
// in every test, and all algorithms would be compiled again for it.
template <class TriangleMesh>
struct Value_of_vertex
{
  const Numbered_mesh<TriangleMesh>* input;
  const std::vector<double>* values;

  double operator()(Vertex_of<TriangleMesh> v) const { return (*values)[input->number.at(v)]; }
};

template <class TriangleMesh>
auto values_as_map(const Numbered_mesh<TriangleMesh>& input, const std::vector<double>& values)
{
  return boost::make_function_property_map<Vertex_of<TriangleMesh>>(
      Value_of_vertex<TriangleMesh>{&input, &values});
}

// Coordinates that `float` can represent, so that all kernels have the same points.
inline Index_mesh with_float_coordinates(Index_mesh mesh)
{
  for (auto& p : mesh.points) {
    for (double& x : p) {
      x = static_cast<double>(static_cast<float>(x));
    }
  }
  return mesh;
}

// A closed shape without symmetry: an ellipsoid with three limbs.
inline const Index_mesh& shape_with_limbs()
{
  static const Index_mesh mesh = []() {
    Index_mesh result = sphere(3);
    const std::vector<std::array<double, 5>> limbs = {// direction, length, width
                                                      {0.9, 0.1, 0.42, 2.6, 0.08},
                                                      {-0.8, 0.55, -0.2, 2.3, 0.07},
                                                      {0.05, -0.9, -0.43, 2.4, 0.09}};
    for (auto& p : result.points) {
      double radius = 1;
      for (const auto& limb : limbs) {
        const double norm = std::hypot(limb[0], limb[1], limb[2]);
        const double cosine = (p[0] * limb[0] + p[1] * limb[1] + p[2] * limb[2]) / norm;
        radius += limb[3] * std::exp((cosine - 1) / limb[4]);
      }
      p = {radius * p[0], 0.85 * radius * p[1], 0.7 * radius * p[2]};
    }
    return with_float_coordinates(result);
  }();
  return mesh;
}

// A torus on its edge with a strange function: one loop, many extrema.
inline const Index_mesh& rough_torus()
{
  static const Index_mesh mesh = with_float_coordinates(torus(16, 8));
  return mesh;
}

inline std::vector<double> rough_values(const Index_mesh& mesh, const unsigned seed = 5)
{
  std::mt19937 rng(seed);
  std::vector<double> values;
  for (const auto& p : mesh.points) {
    // multiples of 1/1024, exact in all number types
    values.push_back(std::floor((p[0] + 0.3 * p[1] + 0.5 * random_unit(rng)) * 1024) / 1024);
  }
  return values;
}

// ---------------------------------------------------------------------------------------------
// Graphs as plain data

struct Plain_node
{
  std::size_t vertex;
  double value;
  SMRG::Reeb_node_type type;

  bool operator==(const Plain_node& other) const
  {
    return vertex == other.vertex && value == other.value && type == other.type;
  }
};

inline bool operator!=(const Plain_node& a, const Plain_node& b)
{
  return !(a == b);
}

inline std::ostream& operator<<(std::ostream& out, const Plain_node& node)
{
  return out << node.vertex << ' ' << node.value << ' ' << node.type;
}

struct Plain_arc
{
  std::size_t lower_vertex, upper_vertex;
  std::vector<std::size_t> vertices;

  bool operator==(const Plain_arc& other) const
  {
    return lower_vertex == other.lower_vertex && upper_vertex == other.upper_vertex &&
           vertices == other.vertices;
  }
};

inline bool operator!=(const Plain_arc& a, const Plain_arc& b)
{
  return !(a == b);
}

inline std::ostream& operator<<(std::ostream& out, const Plain_arc& arc)
{
  return out << arc.lower_vertex << '-' << arc.upper_vertex << " (" << arc.vertices.size() << ')';
}

// Nodes and arcs at the positions of their numbers.
struct Plain_graph
{
  std::vector<Plain_node> nodes;
  std::vector<Plain_arc> arcs;
};

template <class TriangleMesh, class Graph>
Plain_graph plain(const Numbered_mesh<TriangleMesh>& input, const Graph& graph)
{
  const auto nodes = get(boost::vertex_bundle, graph);
  const auto arcs = get(boost::edge_bundle, graph);
  Plain_graph result;
  result.nodes.resize(num_vertices(graph), {std::size_t(-1), -1, SMRG::Reeb_node_type::DEGENERATE});
  result.arcs.resize(num_edges(graph), {std::size_t(-1), std::size_t(-1), {}});
  for (auto n : CGAL::make_range(vertices(graph))) {
    const auto& node = nodes[n];
    result.nodes.at(node.id) = {
        input.number.at(node.vertex), CGAL::to_double(node.value), node.type};
  }
  for (auto a : CGAL::make_range(edges(graph))) {
    Plain_arc& arc = result.arcs.at(arcs[a].id);
    arc.lower_vertex = input.number.at(nodes[SMRG::lower_node(a, graph)].vertex);
    arc.upper_vertex = input.number.at(nodes[SMRG::upper_node(a, graph)].vertex);
    for (auto v : arcs[a].vertices) {
      arc.vertices.push_back(input.number.at(v));
    }
  }
  return result;
}

inline void check_equal(const std::vector<Plain_node>& a, const std::vector<Plain_node>& b)
{
  BOOST_CHECK_EQUAL_COLLECTIONS(a.begin(), a.end(), b.begin(), b.end());
}

inline void check_equal(const Plain_graph& a, const Plain_graph& b)
{
  check_equal(a.nodes, b.nodes);
  BOOST_CHECK_EQUAL_COLLECTIONS(a.arcs.begin(), a.arcs.end(), b.arcs.begin(), b.arcs.end());
}

// The same up to the rounding of values, which also decides about the order of nodes with the same
// value.
inline void check_close(Plain_graph a, Plain_graph b)
{
  for (Plain_graph* graph : {&a, &b}) {
    std::sort(graph->nodes.begin(),
              graph->nodes.end(),
              [](const Plain_node& u, const Plain_node& v) { return u.vertex < v.vertex; });
    std::sort(graph->arcs.begin(), graph->arcs.end(), [](const Plain_arc& u, const Plain_arc& v) {
      return std::tie(u.lower_vertex, u.upper_vertex, u.vertices) <
             std::tie(v.lower_vertex, v.upper_vertex, v.vertices);
    });
  }
  BOOST_REQUIRE_EQUAL(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    BOOST_CHECK_EQUAL(a.nodes[i].vertex, b.nodes[i].vertex);
    BOOST_CHECK_EQUAL(a.nodes[i].type, b.nodes[i].type);
    BOOST_CHECK_CLOSE_FRACTION(a.nodes[i].value, b.nodes[i].value, 1e-6);
  }
  BOOST_CHECK_EQUAL_COLLECTIONS(a.arcs.begin(), a.arcs.end(), b.arcs.begin(), b.arcs.end());
}

template <class T>
void check_equal(const std::vector<T>& a, const std::vector<T>& b)
{
  BOOST_CHECK_EQUAL_COLLECTIONS(a.begin(), a.end(), b.begin(), b.end());
}

inline void check_close(const std::vector<double>& a, const std::vector<double>& b)
{
  BOOST_REQUIRE_EQUAL(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    BOOST_CHECK_SMALL(a[i] - b[i], 1e-6 * (1 + std::abs(a[i])));
  }
}

// ---------------------------------------------------------------------------------------------
// Results as plain data

struct Scalar_result
{
  Plain_graph graph, simplified_graph;
  std::vector<long long> arc_of_vertex, simplified_arc_of_vertex;
};

inline void check_equal(const Scalar_result& a, const Scalar_result& b)
{
  check_equal(a.graph, b.graph);
  check_equal(a.simplified_graph, b.simplified_graph);
  check_equal(a.arc_of_vertex, b.arc_of_vertex);
  check_equal(a.simplified_arc_of_vertex, b.simplified_arc_of_vertex);
}

constexpr double scalar_threshold = 0.25;

template <class Number, class TriangleMesh>
std::vector<long long> numbers_of_vertices(const Numbered_mesh<TriangleMesh>& input,
                                           const Vertex_values<TriangleMesh, Number>& map)
{
  std::vector<long long> result;
  for (auto v : input.vertices) {
    result.push_back(
        map.at(v) == static_cast<Number>(SMRG::null_arc) ? -1 : static_cast<long long>(map.at(v)));
  }
  return result;
}

// The results for any scalar map, graph type and type of arc numbers. What is in `graph` gets lost;
// `before_simplification()` is called when it has been computed.
template <class Arc_number, class Graph, class TriangleMesh, class VertexScalarMap, class Function>
Scalar_result scalar_result(const Numbered_mesh<TriangleMesh>& input,
                            VertexScalarMap scalar_map,
                            Graph& graph,
                            const Function& before_simplification)
{
  Scalar_result result;
  Vertex_values<TriangleMesh, Arc_number> arcs;
  const boost::associative_property_map<Vertex_values<TriangleMesh, Arc_number>> arc_map(arcs);
  SMRG::compute_Reeb_graph(input.mesh,
                           scalar_map,
                           graph,
                           SMRG::parameters::vertex_arc_map(arc_map).collect_arc_vertices(true));
  result.graph = plain(input, graph);
  result.arc_of_vertex = numbers_of_vertices(input, arcs);
  before_simplification();
  SMRG::simplify_Reeb_graph(
      input.mesh,
      scalar_map,
      graph,
      SMRG::parameters::persistence_threshold(scalar_threshold).vertex_arc_map(arc_map));
  result.simplified_graph = plain(input, graph);
  result.simplified_arc_of_vertex = numbers_of_vertices(input, arcs);
  return result;
}

template <class Graph, class Arc_number, class TriangleMesh, class VertexScalarMap>
Scalar_result scalar_result(const Numbered_mesh<TriangleMesh>& input, VertexScalarMap scalar_map)
{
  Graph graph;
  return scalar_result<Arc_number>(input, scalar_map, graph, []() {});
}

template <class TriangleMesh>
Scalar_result
scalar_result(const Numbered_mesh<TriangleMesh>& input, const std::vector<double>& values)
{
  return scalar_result<SMRG::Reeb_graph<TriangleMesh>, int>(input, values_as_map(input, values));
}

inline const Scalar_result& scalar_reference()
{
  static const Numbered_mesh<Mesh> input(rough_torus());
  static const Scalar_result result = scalar_result(input, rough_values(rough_torus()));
  return result;
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A vertex map that is a lambda.
template <class Key, class Function>
auto function_map(const Function& function)
{
  return boost::make_function_property_map<Key>(function);
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_PLAIN_RESULTS_H
