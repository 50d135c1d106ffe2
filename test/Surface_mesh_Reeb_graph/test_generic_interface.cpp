// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The interface with every kind of argument that it promises to take: mesh types, kernels, property
// maps, graph types, named parameters, and data that cannot be computed with.

#define BOOST_TEST_MODULE test_generic_interface

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Index_mesh.h"
#include "brute_force_Reeb_graph.h"
#include "random_meshes.h"

#include <CGAL/surface_mesh_Reeb_graph.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

namespace {

using Double_kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;
using EPICK = CGAL::Exact_predicates_inexact_constructions_kernel;
using EPECK = CGAL::Exact_predicates_exact_constructions_kernel;

using Mesh = CGAL::Surface_mesh<Double_kernel::Point_3>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Plain_polyhedron = CGAL::Polyhedron_3<EPICK>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Double_kernel, CGAL::Polyhedron_items_with_id_3>;

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

// Coordinates that `float` can represent, so that all kernels have the same points.
Index_mesh with_float_coordinates(Index_mesh mesh)
{
  for (auto& p : mesh.points) {
    for (double& x : p) {
      x = static_cast<double>(static_cast<float>(x));
    }
  }
  return mesh;
}

// A closed shape without symmetry: an ellipsoid with three limbs.
const Index_mesh& shape_with_limbs()
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
const Index_mesh& rough_torus()
{
  static const Index_mesh mesh = with_float_coordinates(torus(16, 8));
  return mesh;
}

std::vector<double> rough_values(const Index_mesh& mesh, const unsigned seed = 5)
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
  int type;

  bool operator==(const Plain_node& other) const
  {
    return vertex == other.vertex && value == other.value && type == other.type;
  }
};

bool operator!=(const Plain_node& a, const Plain_node& b)
{
  return !(a == b);
}

std::ostream& operator<<(std::ostream& out, const Plain_node& node)
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

bool operator!=(const Plain_arc& a, const Plain_arc& b)
{
  return !(a == b);
}

std::ostream& operator<<(std::ostream& out, const Plain_arc& arc)
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
  result.nodes.resize(num_vertices(graph), {std::size_t(-1), -1, -1});
  result.arcs.resize(num_edges(graph), {std::size_t(-1), std::size_t(-1), {}});
  for (auto n : CGAL::make_range(vertices(graph))) {
    const auto& node = nodes[n];
    result.nodes.at(node.id) = {
        input.number.at(node.vertex), CGAL::to_double(node.value), static_cast<int>(node.type)};
  }
  for (auto a : CGAL::make_range(edges(graph))) {
    auto lower = source(a, graph), upper = target(a, graph);
    if (nodes[upper].id < nodes[lower].id) {
      std::swap(lower, upper);
    }
    Plain_arc& arc = result.arcs.at(arcs[a].id);
    arc.lower_vertex = input.number.at(nodes[lower].vertex);
    arc.upper_vertex = input.number.at(nodes[upper].vertex);
    for (auto v : arcs[a].vertices) {
      arc.vertices.push_back(input.number.at(v));
    }
  }
  return result;
}

void check_equal(const std::vector<Plain_node>& a, const std::vector<Plain_node>& b)
{
  BOOST_CHECK_EQUAL_COLLECTIONS(a.begin(), a.end(), b.begin(), b.end());
}

void check_equal(const Plain_graph& a, const Plain_graph& b)
{
  check_equal(a.nodes, b.nodes);
  BOOST_CHECK_EQUAL_COLLECTIONS(a.arcs.begin(), a.arcs.end(), b.arcs.begin(), b.arcs.end());
}

// The same up to the rounding of values, which also decides about the order of nodes with the same
// value.
void check_close(Plain_graph a, Plain_graph b)
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

void check_close(const std::vector<double>& a, const std::vector<double>& b)
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

void check_equal(const Scalar_result& a, const Scalar_result& b)
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
  auto map = values_of_vertices<double>(input, values);
  return scalar_result<SMRG::Reeb_graph<TriangleMesh>, int>(input,
                                                            boost::make_assoc_property_map(map));
}

struct Spectral_result
{
  std::vector<double> eigenvalues, eigenfunction, height, commute_time;
  std::vector<std::size_t> feature_points;
  Plain_graph graph;
  std::vector<long long> arc_of_vertex;
};

// Everything that is computed from the points; `np` holds CGAL's named parameters.
template <class TriangleMesh, class Axis, class NamedParameters>
Spectral_result spectral_result(const Numbered_mesh<TriangleMesh>& input,
                                const Axis& axis,
                                const NamedParameters& np)
{
  using Values = Vertex_values<TriangleMesh, double>;
  auto in_order = [&](const Values& values) {
    std::vector<double> result;
    for (auto v : input.vertices) {
      result.push_back(values.at(v));
    }
    return result;
  };
  Spectral_result result;

  const SMRG::Laplace_Beltrami_eigenbasis<TriangleMesh> basis(input.mesh, np);
  BOOST_REQUIRE_EQUAL(basis.number_of_components(), 1u);
  for (std::size_t k = 1; k <= basis.number_of_eigenpairs(0); ++k) {
    result.eigenvalues.push_back(basis.eigenvalue(0, k));
  }
  std::vector<Vertex_of<TriangleMesh>> points;
  SMRG::feature_points(basis, std::back_inserter(points), np);
  for (auto v : points) {
    result.feature_points.push_back(input.number.at(v));
  }
  Values values;
  SMRG::eigenfunction(basis, 2, boost::make_assoc_property_map(values));
  result.eigenfunction = in_order(values);
  SMRG::height_function(input.mesh, axis, boost::make_assoc_property_map(values), np);
  result.height = in_order(values);

  SMRG::Reeb_graph<TriangleMesh> graph;
  Vertex_values<TriangleMesh, int> arcs;
  Values commute_time;
  std::vector<Vertex_of<TriangleMesh>> points_of_one_call;
  SMRG::commute_time_Reeb_graph(
      input.mesh,
      graph,
      SMRG::parameters::vertex_value_map(boost::make_assoc_property_map(commute_time))
          .persistence_threshold(0.05)
          .vertex_arc_map(boost::make_assoc_property_map(arcs))
          .collect_arc_vertices(true)
          .output_iterator(std::back_inserter(points_of_one_call)));
  if (std::is_same<NamedParameters, CGAL::parameters::Default_named_parameters>::value) {
    BOOST_CHECK(points == points_of_one_call);
    SMRG::commute_time_function(basis, points, boost::make_assoc_property_map(values));
    BOOST_CHECK(values == commute_time);
  }
  result.commute_time = in_order(commute_time);
  result.graph = plain(input, graph);
  result.arc_of_vertex = numbers_of_vertices(input, arcs);
  return result;
}

template <class TriangleMesh, class Axis>
Spectral_result spectral_result(const Numbered_mesh<TriangleMesh>& input, const Axis& axis)
{
  return spectral_result(input, axis, CGAL::parameters::default_values());
}

void check_close(const Spectral_result& a, const Spectral_result& b)
{
  check_close(a.eigenvalues, b.eigenvalues);
  check_close(a.eigenfunction, b.eigenfunction);
  check_close(a.height, b.height);
  check_close(a.commute_time, b.commute_time);
  check_equal(a.feature_points, b.feature_points);
  check_close(a.graph, b.graph);
  check_equal(a.arc_of_vertex, b.arc_of_vertex);
}

const Spectral_result& spectral_reference()
{
  static const Numbered_mesh<Mesh> input(shape_with_limbs());
  static const Spectral_result result = spectral_result(input, Double_kernel::Vector_3(1, -2, 4));
  return result;
}

const Scalar_result& scalar_reference()
{
  static const Numbered_mesh<Mesh> input(rough_torus());
  static const Scalar_result result = scalar_result(input, rough_values(rough_torus()));
  return result;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A vertex map that is a lambda.
template <class Key, class Function>
auto function_map(const Function& function)
{
  return boost::make_function_property_map<Key>(function);
}

} // namespace

// ---------------------------------------------------------------------------------------------
// Meshes and kernels

BOOST_AUTO_TEST_SUITE(meshes)

BOOST_AUTO_TEST_CASE(references_are_meaningful)
{
  const Scalar_result& scalar = scalar_reference();
  BOOST_CHECK_GT(scalar.graph.nodes.size(), 20u);
  BOOST_CHECK_GE(scalar.simplified_graph.nodes.size(), 4u);
  BOOST_CHECK_LT(scalar.simplified_graph.nodes.size(), scalar.graph.nodes.size());
  BOOST_CHECK_EQUAL(scalar.graph.arcs.size(), scalar.graph.nodes.size()); // one loop
  BOOST_CHECK_EQUAL(scalar.simplified_graph.arcs.size(), scalar.simplified_graph.nodes.size());

  const Spectral_result& spectral = spectral_reference();
  BOOST_CHECK_GE(spectral.eigenvalues.size(), 50u);
  BOOST_CHECK_GE(spectral.feature_points.size(), 3u);
  BOOST_CHECK_GE(spectral.graph.nodes.size(), 6u);
  BOOST_CHECK_EQUAL(spectral.graph.arcs.size() + 1, spectral.graph.nodes.size());
}

template <class K>
using Surface_mesh_of = CGAL::Surface_mesh<typename K::Point_3>;

using Mesh_types = boost::mpl::list<Surface_mesh_of<Float_kernel>,
                                    Surface_mesh_of<EPICK>,
                                    Surface_mesh_of<EPECK>,
                                    Plain_polyhedron,
                                    Polyhedron_with_ids>;

BOOST_AUTO_TEST_CASE_TEMPLATE(same_graph_of_a_scalar_function, TriangleMesh, Mesh_types)
{
  const Numbered_mesh<TriangleMesh> input(rough_torus());
  check_equal(scalar_result(input, rough_values(rough_torus())), scalar_reference());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(same_spectral_results, TriangleMesh, Mesh_types)
{
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using Vector = typename CGAL::Kernel_traits<Point>::Kernel::Vector_3;

  const Numbered_mesh<TriangleMesh> input(shape_with_limbs());
  check_close(spectral_result(input, Vector(1, -2, 4)), spectral_reference());
}

BOOST_AUTO_TEST_CASE(same_graphs_on_random_meshes)
{
  std::mt19937 rng(11);
  for (int i = 0; i < 60; ++i) {
    BOOST_TEST_CONTEXT("mesh " << i)
    {
      const Index_mesh mesh = random_small_mesh(rng);
      const std::vector<double> values = i % 3 == 0
                                             ? random_values(mesh.points.size(), rng)
                                             : random_integer_values(mesh.points.size(), 6, rng);
      const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(mesh), values);
      check_equal(scalar_result(Numbered_mesh<Plain_polyhedron>(mesh), values), expected);
      check_equal(scalar_result(Numbered_mesh<Polyhedron_with_ids>(mesh), values), expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(polyhedron_with_initialized_ids)
{
  {
    Numbered_mesh<Polyhedron_with_ids> input(rough_torus());
    CGAL::set_halfedgeds_items_id(input.mesh);
    check_equal(scalar_result(input, rough_values(rough_torus())), scalar_reference());
  }
  {
    Numbered_mesh<Polyhedron_with_ids> input(shape_with_limbs());
    CGAL::set_halfedgeds_items_id(input.mesh);
    check_close(spectral_result(input, Double_kernel::Vector_3(1, -2, 4)), spectral_reference());
  }
}

// Valid indices are used as they are; without ties they do not matter.
BOOST_AUTO_TEST_CASE(polyhedron_with_ids_in_another_order)
{
  std::mt19937 rng(12);
  const std::vector<double> values = random_values(rough_torus().points.size(), rng);
  const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(rough_torus()), values);

  Numbered_mesh<Polyhedron_with_ids> input(rough_torus());
  CGAL::set_halfedgeds_items_id(input.mesh);
  const std::vector<std::size_t> ids = random_permutation(input.vertices.size(), rng);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    input.vertices[i]->id() = ids[i];
  }
  check_equal(scalar_result(input, values), expected);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    BOOST_CHECK_EQUAL(input.vertices[i]->id(), ids[i]);
  }
}

// A part of a mesh, with a border where it was cut off, against a mesh that has this part only.
BOOST_AUTO_TEST_CASE(face_filtered_graph)
{
  const Index_mesh& whole = rough_torus();
  std::vector<double> values = rough_values(whole);

  Numbered_mesh<Mesh> whole_input(whole);
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch =
      whole_input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  Index_mesh part;
  part.points = whole.points;
  auto f = faces(whole_input.mesh).begin();
  for (std::size_t i = 0; i < whole.triangles.size(); ++i, ++f) {
    // two pieces with borders, and a few pinched vertices
    const bool is_selected = i % 16 < 11 && i / 32 != 3 && i % 37 != 0;
    patch[*f] = is_selected ? 1 : 0;
    if (is_selected) {
      part.triangles.push_back(whole.triangles[i]);
    }
  }
  std::vector<std::size_t> number(whole.points.size(), std::size_t(-1));
  {
    std::set<std::size_t> used;
    for (const auto& t : part.triangles) {
      used.insert(t.begin(), t.end());
    }
    std::vector<std::array<double, 3>> points;
    std::vector<double> used_values;
    for (const std::size_t v : used) {
      number[v] = points.size();
      points.push_back(part.points[v]);
      used_values.push_back(values[v]);
    }
    part.points = points;
    values = used_values;
    for (auto& t : part.triangles) {
      t = {number[t[0]], number[t[1]], number[t[2]]};
    }
  }

  using Filtered = CGAL::Face_filtered_graph<Mesh>;
  const Filtered filtered(whole_input.mesh, std::size_t(1), patch);
  Vertex_values<Mesh, double> map;
  std::map<Vertex, std::size_t> number_of_vertex;
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    if (number[i] != std::size_t(-1)) {
      map[whole_input.vertices[i]] = values[number[i]];
      number_of_vertex[whole_input.vertices[i]] = number[i];
    }
  }
  BOOST_REQUIRE_EQUAL(
      static_cast<std::size_t>(std::distance(vertices(filtered).begin(), vertices(filtered).end())),
      part.points.size());

  Numbered_mesh<Mesh> names_of_vertices;
  names_of_vertices.number = number_of_vertex;
  SMRG::Reeb_graph<Filtered> graph;
  SMRG::compute_Reeb_graph(filtered,
                           boost::make_assoc_property_map(map),
                           graph,
                           SMRG::parameters::collect_arc_vertices(true));
  const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(part), values);
  check_equal(plain(names_of_vertices, graph), expected.graph);
  SMRG::simplify_Reeb_graph(filtered,
                            boost::make_assoc_property_map(map),
                            graph,
                            SMRG::parameters::persistence_threshold(scalar_threshold));
  check_equal(plain(names_of_vertices, graph), expected.simplified_graph);
}

BOOST_AUTO_TEST_CASE(removed_elements)
{
  // vertices and faces removed at the beginning, in the middle and at the end of the arrays
  Index_mesh with_debris = sphere(0);
  append(with_debris, shape_with_limbs(), 0);
  append(with_debris, sphere(0), 20);
  Numbered_mesh<Mesh> input(with_debris);
  const std::size_t first = sphere(0).points.size();
  const std::size_t last = first + shape_with_limbs().points.size();
  CGAL::Euler::remove_face(halfedge(*faces(input.mesh).begin(), input.mesh), input.mesh);
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    if (i < first || i >= last) {
      const Vertex v = input.vertices[i];
      // a face takes the vertices with it that have no other
      while (!input.mesh.is_removed(v) && halfedge(v, input.mesh) != Mesh::null_halfedge()) {
        auto h = halfedge(v, input.mesh);
        h = is_border(h, input.mesh) ? opposite(h, input.mesh) : h;
        CGAL::Euler::remove_face(h, input.mesh);
      }
      if (!input.mesh.is_removed(v)) {
        remove_vertex(v, input.mesh);
      }
    }
  }
  // an isolated vertex in between and a removed one after everything
  remove_vertex(add_vertex(input.mesh), input.mesh);
  BOOST_REQUIRE(input.mesh.has_garbage());
  BOOST_REQUIRE_EQUAL(input.mesh.number_of_vertices(), last - first);
  input.vertices.assign(input.mesh.vertices().begin(), input.mesh.vertices().end());
  input.number_vertices();

  Numbered_mesh<Mesh> collected;
  collected.mesh = input.mesh;
  collected.mesh.collect_garbage();
  collected.vertices.assign(collected.mesh.vertices().begin(), collected.mesh.vertices().end());
  collected.number_vertices();
  // garbage collection may change the order; the positions tell who is who
  std::map<Double_kernel::Point_3, Vertex> vertex_at;
  for (Vertex v : collected.mesh.vertices()) {
    vertex_at[collected.mesh.point(v)] = v;
  }
  BOOST_REQUIRE_EQUAL(vertex_at.size(), last - first);
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    collected.vertices[i] = vertex_at.at(input.mesh.point(input.vertices[i]));
  }
  collected.number_vertices();

  std::mt19937 rng(13);
  const std::vector<double> values = random_values(last - first, rng);
  check_equal(scalar_result(input, values), scalar_result(collected, values));
  const Double_kernel::Vector_3 axis(1, -2, 4);
  check_close(spectral_result(input, axis), spectral_result(collected, axis));

  // the graph can be written as well
  SMRG::Reeb_graph<Mesh> graph;
  auto map = values_of_vertices<double>(input, values);
  auto arcs = values_of_vertices<int>(input, std::vector<int>(values.size(), 0));
  SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(map), graph);
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_VTP(
      out, input.mesh, boost::make_assoc_property_map(map), boost::make_assoc_property_map(arcs)));
}

BOOST_AUTO_TEST_SUITE_END()

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
  const auto scalar_map =
      function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });

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
  const auto map = function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });
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

BOOST_AUTO_TEST_CASE(user_graph_of_the_whole_method)
{
  const Numbered_mesh<Mesh> input(shape_with_limbs());
  My_graph<boost::vecS, boost::listS, boost::bidirectionalS> graph;
  add_vertex(graph);
  SMRG::commute_time_Reeb_graph(
      input.mesh, graph, SMRG::parameters::persistence_threshold(0.05).collect_arc_vertices(true));
  check_close(plain(input, graph), spectral_reference().graph);

  std::ostringstream graphml, graphviz, polylines;
  BOOST_CHECK(SMRG::IO::write_GraphML(graphml, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_Graphviz(graphviz, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_polylines(polylines, graph, input.mesh));
}

// In the default type the source of an edge is its lower node, and nodes and arcs are in order.
BOOST_AUTO_TEST_CASE(default_graph_is_in_order)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  SMRG::Reeb_graph<Mesh> graph;
  const auto map = function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });
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

// ---------------------------------------------------------------------------------------------
// Named parameters

BOOST_AUTO_TEST_SUITE(named_parameters)

struct Shape_fixture
{
  Numbered_mesh<Mesh> input{shape_with_limbs()};
  SMRG::Reeb_graph<Mesh> graph;
  std::vector<double> values = std::vector<double>(input.vertices.size(), -1);
  std::vector<int> arcs = std::vector<int>(input.vertices.size(), -7);
  std::vector<Vertex> points;

  void check() const
  {
    const Spectral_result& expected = spectral_reference();
    check_close(plain(input, graph), expected.graph);
    check_close(values, expected.commute_time);
    check_equal(std::vector<long long>(arcs.begin(), arcs.end()), expected.arc_of_vertex);
    BOOST_REQUIRE_EQUAL(points.size(), expected.feature_points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      BOOST_CHECK_EQUAL(input.number.at(points[i]), expected.feature_points[i]);
    }
  }
};

BOOST_FIXTURE_TEST_CASE(all_names_in_one_order, Shape_fixture)
{
  SMRG::commute_time_Reeb_graph(input.mesh,
                                graph,
                                SMRG::parameters::number_of_eigenpairs(50)
                                    .residual_tolerance(1e-8)
                                    .small_time(1.5)
                                    .large_time(20)
                                    .minima_as_feature_points(false)
                                    .persistence_threshold(0.05)
                                    .threshold_is_absolute(false)
                                    .vertex_value_map(CGAL::make_property_map(values))
                                    .vertex_arc_map(CGAL::make_property_map(arcs))
                                    .collect_arc_vertices(true)
                                    .vertex_point_map(input.mesh.points())
                                    .vertex_index_map(get(boost::vertex_index, input.mesh))
                                    .sparse_linear_solver(SMRG::internal::Default_solver_traits())
                                    .output_iterator(std::back_inserter(points)));
  check();
}

BOOST_FIXTURE_TEST_CASE(all_names_in_another_order, Shape_fixture)
{
  SMRG::commute_time_Reeb_graph(input.mesh,
                                graph,
                                SMRG::parameters::collect_arc_vertices(true)
                                    .vertex_arc_map(CGAL::make_property_map(arcs))
                                    .vertex_value_map(CGAL::make_property_map(values))
                                    .threshold_is_absolute(false)
                                    .persistence_threshold(0.05f)
                                    .minima_as_feature_points(false)
                                    .large_time(20.)
                                    .small_time(1.5f)
                                    .residual_tolerance(1e-8)
                                    .number_of_eigenpairs(std::size_t(50))
                                    .output_iterator(std::back_inserter(points))
                                    .vertex_index_map(get(boost::vertex_index, input.mesh))
                                    .vertex_point_map(input.mesh.points()));
  check();
}

// The points of the mesh itself are all the same.
BOOST_AUTO_TEST_CASE(points_outside_the_mesh)
{
  using Point = EPICK::Point_3;
  Index_mesh collapsed = shape_with_limbs();
  std::vector<Point> points;
  for (auto& p : collapsed.points) {
    points.emplace_back(p[0], p[1], p[2]);
    p = {1, 1, 1};
  }
  Numbered_mesh<Mesh> input(collapsed);
  const auto point_map = CGAL::make_property_map(points);
  BOOST_CHECK_THROW(SMRG::Laplace_Beltrami_eigenbasis<Mesh>(input.mesh), SMRG::Error);

  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(
      input.mesh, CGAL::parameters::vertex_point_map(point_map));
  std::vector<double> eigenvalues;
  for (std::size_t k = 1; k <= basis.number_of_eigenpairs(0); ++k) {
    eigenvalues.push_back(basis.eigenvalue(0, k));
  }
  check_close(eigenvalues, spectral_reference().eigenvalues);

  std::vector<double> height(points.size());
  SMRG::height_function(input.mesh,
                        EPICK::Vector_3(1, -2, 4),
                        CGAL::make_property_map(height),
                        CGAL::parameters::vertex_point_map(point_map));
  check_close(height, spectral_reference().height);

  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(
      input.mesh,
      graph,
      SMRG::parameters::persistence_threshold(0.05).collect_arc_vertices(true).vertex_point_map(
          point_map));
  check_close(plain(input, graph), spectral_reference().graph);
  std::ostringstream out;
  SMRG::IO::write_polylines(out, graph, input.mesh, CGAL::parameters::vertex_point_map(point_map));
  BOOST_CHECK(out.str().find(" 1 1 1") == std::string::npos);

  // CGAL's names alone
  SMRG::Reeb_graph<Mesh> full_graph, graph_by_default;
  SMRG::commute_time_Reeb_graph(
      input.mesh, full_graph, CGAL::parameters::vertex_point_map(point_map));
  const Numbered_mesh<Mesh> original(shape_with_limbs());
  SMRG::commute_time_Reeb_graph(original.mesh, graph_by_default);
  check_close(plain(input, full_graph), plain(original, graph_by_default));
  BOOST_CHECK_GE(num_vertices(full_graph), num_vertices(graph));
}

template <class VertexIndexMap>
void check_index_map(const Numbered_mesh<Mesh>& input,
                     const std::vector<double>& values,
                     const Scalar_result& expected,
                     VertexIndexMap vertex_index_map)
{
  const auto scalar_map =
      function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });
  Vertex_values<Mesh, int> arcs;
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(input.mesh,
                           scalar_map,
                           graph,
                           SMRG::parameters::vertex_arc_map(boost::make_assoc_property_map(arcs))
                               .collect_arc_vertices(true)
                               .vertex_index_map(vertex_index_map));
  check_equal(plain(input, graph), expected.graph);
  check_equal(numbers_of_vertices(input, arcs), expected.arc_of_vertex);
  SMRG::simplify_Reeb_graph(input.mesh,
                            scalar_map,
                            graph,
                            SMRG::parameters::vertex_arc_map(boost::make_assoc_property_map(arcs))
                                .persistence_threshold(scalar_threshold)
                                .vertex_index_map(vertex_index_map));
  check_equal(plain(input, graph), expected.simplified_graph);
  check_equal(numbers_of_vertices(input, arcs), expected.simplified_arc_of_vertex);

  std::ostringstream out;
  SMRG::IO::write_GraphML(
      out, graph, input.mesh, CGAL::parameters::vertex_index_map(vertex_index_map));
  BOOST_CHECK(out.good());
}

BOOST_AUTO_TEST_CASE(index_maps_of_the_user)
{
  std::mt19937 rng(15);
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = random_values(input.vertices.size(), rng);
  const Scalar_result expected = scalar_result(input, values);

  const std::vector<std::size_t> permutation = random_permutation(values.size(), rng);
  check_index_map(input, values, expected, CGAL::make_property_map(permutation));
  auto reversed = values_of_vertices<int>(input, std::vector<int>(values.size(), 0));
  int index = static_cast<int>(values.size());
  for (auto& entry : reversed) {
    entry.second = --index;
  }
  check_index_map(input, values, expected, boost::make_assoc_property_map(reversed));
#ifdef CGAL_NDEBUG
  // CGAL's assertions want the indices to be dense.
  check_index_map(input, values, expected, function_map<Vertex>([&](Vertex v) {
                    return 3 * permutation[input.number.at(v)] + 7;
                  }));
#endif
}

// Ties are broken by the indices that the user gives.
BOOST_AUTO_TEST_CASE(index_map_breaks_ties)
{
  Index_mesh mesh = sphere(1);
  append(mesh, sphere(1), 10);
  const Numbered_mesh<Mesh> input(mesh);
  const std::size_t n = input.vertices.size();
  const auto constant = function_map<Vertex>([](Vertex) { return 4; });
  SMRG::Reeb_graph<Mesh, int> graph;
  SMRG::compute_Reeb_graph(input.mesh, constant, graph);
  BOOST_REQUIRE_EQUAL(num_vertices(graph), 4u);
  BOOST_REQUIRE_EQUAL(num_edges(graph), 2u);
  BOOST_CHECK_EQUAL(input.number.at(graph[0].vertex), 0u);
  SMRG::compute_Reeb_graph(input.mesh,
                           constant,
                           graph,
                           CGAL::parameters::vertex_index_map(function_map<Vertex>(
                               [&](Vertex v) { return n - 1 - input.number.at(v); })));
  BOOST_REQUIRE_EQUAL(num_vertices(graph), 4u);
  BOOST_CHECK_GE(input.number.at(graph[0].vertex), n / 2);
}

BOOST_AUTO_TEST_CASE(thresholds)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  const auto map = function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });
  const auto computed = [&]() {
    SMRG::Reeb_graph<Mesh> graph;
    SMRG::compute_Reeb_graph(input.mesh, map, graph, SMRG::parameters::collect_arc_vertices(true));
    return graph;
  };
  const auto simplified = [&](const double threshold, const bool is_absolute) {
    SMRG::Reeb_graph<Mesh> graph = computed();
    SMRG::simplify_Reeb_graph(
        input.mesh,
        map,
        graph,
        SMRG::parameters::threshold_is_absolute(is_absolute).persistence_threshold(threshold));
    return plain(input, graph);
  };
  const double range = *std::max_element(values.begin(), values.end()) -
                       *std::min_element(values.begin(), values.end());
  check_equal(simplified(scalar_threshold, false), scalar_reference().simplified_graph);
  check_equal(simplified(scalar_threshold * range, true), scalar_reference().simplified_graph);
  check_equal(simplified(0, true), scalar_reference().graph);
  SMRG::Reeb_graph<Mesh> by_default = computed();
  SMRG::simplify_Reeb_graph(input.mesh, map, by_default);
  check_equal(plain(input, by_default), scalar_reference().graph);

  // nothing but the global extrema and the loop
  const Plain_graph least = simplified(2, false);
  BOOST_CHECK_EQUAL(least.nodes.size(), 4u);
  check_equal(simplified(std::numeric_limits<double>::infinity(), true), least);
  check_equal(simplified(std::numeric_limits<double>::infinity(), false), least);
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Data that cannot be computed with, and data at the edge

BOOST_AUTO_TEST_SUITE(errors)

template <class Float>
void check_nan()
{
  Numbered_mesh<Mesh> input(rough_torus());
  std::vector<double> doubles = rough_values(rough_torus());
  std::vector<Float> values(doubles.begin(), doubles.end());
  const auto value_map = CGAL::make_property_map(values);
  SMRG::Reeb_graph<Mesh, Float> graph;
  SMRG::compute_Reeb_graph(
      input.mesh, value_map, graph, SMRG::parameters::collect_arc_vertices(true));
  const Plain_graph before = plain(input, graph);
  std::vector<int> arcs(values.size(), 77);

  values[29] = std::numeric_limits<Float>::quiet_NaN();
  const auto names_the_vertex = [](const SMRG::Error& error) {
    return contains(error.what(), " 29 ");
  };
  BOOST_CHECK_EXCEPTION(
      SMRG::compute_Reeb_graph(input.mesh,
                               value_map,
                               graph,
                               SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs))),
      SMRG::Error,
      names_the_vertex);
  check_equal(plain(input, graph), before);
  BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));

  BOOST_CHECK_EXCEPTION(
      SMRG::simplify_Reeb_graph(input.mesh,
                                value_map,
                                graph,
                                SMRG::parameters::persistence_threshold(scalar_threshold)
                                    .vertex_arc_map(CGAL::make_property_map(arcs))),
      SMRG::Error,
      names_the_vertex);
  check_equal(plain(input, graph), before);
  BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));
}

BOOST_AUTO_TEST_CASE(value_that_is_not_a_number)
{
  check_nan<double>();
  check_nan<float>();
}

BOOST_AUTO_TEST_CASE(coordinate_that_is_not_finite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Index_mesh mesh = rough_torus();
    mesh.points[31][1] = bad;
    const Numbered_mesh<Mesh> input(mesh);
    SMRG::Reeb_graph<Mesh> graph;
    add_vertex(graph);
    std::vector<double> values(mesh.points.size(), 77);
    std::vector<int> arcs(mesh.points.size(), 77);
    std::vector<Vertex> points;
    BOOST_CHECK_EXCEPTION(SMRG::commute_time_Reeb_graph(
                              input.mesh,
                              graph,
                              SMRG::parameters::vertex_value_map(CGAL::make_property_map(values))
                                  .vertex_arc_map(CGAL::make_property_map(arcs))
                                  .output_iterator(std::back_inserter(points))),
                          SMRG::Error,
                          [](const SMRG::Error& error) { return contains(error.what(), " 31 "); });
    BOOST_CHECK_EQUAL(num_vertices(graph), 1u);
    BOOST_CHECK_EQUAL(std::count(values.begin(), values.end(), 77),
                      static_cast<long>(values.size()));
    BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));
    BOOST_CHECK(points.empty());
  }
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range)
{
  const Numbered_mesh<Mesh> input(sphere(1));
  std::vector<double> values(input.vertices.size(), 77);
  std::vector<int> arcs(input.vertices.size(), 77);
  SMRG::Reeb_graph<Mesh> graph;
  add_vertex(graph);
  const auto outputs = SMRG::parameters::vertex_value_map(CGAL::make_property_map(values))
                           .vertex_arc_map(CGAL::make_property_map(arcs));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto check_throws = [&](const auto& np) {
    BOOST_CHECK_THROW(SMRG::commute_time_Reeb_graph(input.mesh, graph, np), SMRG::Error);
    BOOST_CHECK_EQUAL(num_vertices(graph), 1u);
    BOOST_CHECK_EQUAL(std::count(values.begin(), values.end(), 77),
                      static_cast<long>(values.size()));
    BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));
  };
  check_throws(outputs.persistence_threshold(-0.1));
  check_throws(outputs.persistence_threshold(nan));
  check_throws(outputs.number_of_eigenpairs(0));
  check_throws(outputs.number_of_eigenpairs(-5));
  check_throws(outputs.small_time(nan));
  check_throws(outputs.large_time(-1.));
  check_throws(outputs.residual_tolerance(0.));

  const auto map = CGAL::make_property_map(values);
  BOOST_CHECK_THROW(SMRG::height_function(input.mesh, Double_kernel::Vector_3(0, 0, 0), map),
                    SMRG::Error);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(input.mesh,
                                                      SMRG::parameters::number_of_eigenpairs(5));
  BOOST_CHECK_THROW(SMRG::eigenfunction(basis, 0, map), SMRG::Error);
  BOOST_CHECK_THROW(SMRG::eigenfunction(basis, 1000, map), SMRG::Error);
  BOOST_CHECK_EQUAL(std::count(values.begin(), values.end(), 77), static_cast<long>(values.size()));
}

BOOST_AUTO_TEST_CASE(empty_mesh)
{
  const Mesh mesh;
  const auto map = function_map<Vertex>([](Vertex) { return 0.; });
  SMRG::Reeb_graph<Mesh> graph;
  add_vertex(graph);
  SMRG::compute_Reeb_graph(mesh, map, graph);
  BOOST_CHECK_EQUAL(num_vertices(graph), 0u);
  SMRG::simplify_Reeb_graph(
      mesh,
      map,
      graph,
      SMRG::parameters::persistence_threshold(0.5).vertex_arc_map(boost::dummy_property_map()));
  BOOST_CHECK_EQUAL(num_vertices(graph), 0u);

  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(mesh);
  BOOST_CHECK_EQUAL(basis.number_of_components(), 0u);
  std::vector<Vertex> points;
  SMRG::feature_points(basis, std::back_inserter(points));
  BOOST_CHECK(points.empty());

  add_vertex(graph);
  SMRG::commute_time_Reeb_graph(mesh, graph);
  BOOST_CHECK_EQUAL(num_vertices(graph), 0u);

  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_polylines(out, graph, mesh));
  BOOST_CHECK(out.str().empty());
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, mesh));
  BOOST_CHECK(SMRG::IO::write_Graphviz(out, graph, mesh));
  BOOST_CHECK(SMRG::IO::write_VTP(out, mesh, map, map));
}

BOOST_AUTO_TEST_CASE(only_isolated_vertices)
{
  const Index_mesh mesh{{{0, 0, 0}, {1, 0, 0}}, {}};
  const Numbered_mesh<Mesh> input(mesh);
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(input.mesh, graph);
  BOOST_CHECK_EQUAL(num_vertices(graph), 2u);
  BOOST_CHECK_EQUAL(num_edges(graph), 0u);
  BOOST_CHECK_EQUAL(graph[0].type, SMRG::Reeb_node_type::ISOLATED);
}

// Infinite values are ordered as such: like very large ones.
BOOST_AUTO_TEST_CASE(infinite_values)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Numbered_mesh<Mesh> input(rough_torus());
  std::mt19937 rng(16);
  for (int i = 0; i < 20; ++i) {
    std::vector<double> infinite = random_values(input.vertices.size(), rng);
    std::vector<double> finite = infinite;
    for (std::size_t k = 0; k < infinite.size(); ++k) {
      if (random_index(8, rng) == 0) {
        infinite[k] = random_index(2, rng) == 0 ? infinity : -infinity;
        finite[k] = infinite[k] > 0 ? 1e6 : -1e6;
      }
    }
    auto infinite_map = values_of_vertices<double>(input, infinite);
    auto finite_map = values_of_vertices<double>(input, finite);
    SMRG::Reeb_graph<Mesh> graph, expected;
    const auto np = SMRG::parameters::collect_arc_vertices(true);
    SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(infinite_map), graph, np);
    SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(finite_map), expected, np);
    for (int round = 0; round < 2; ++round) {
      Plain_graph expected_graph = plain(input, expected);
      for (Plain_node& node : expected_graph.nodes) {
        BOOST_CHECK_EQUAL(node.value, finite[node.vertex]);
        node.value = infinite[node.vertex];
      }
      check_equal(plain(input, graph), expected_graph);
      // cancels pairs of finite values only
      const auto threshold =
          SMRG::parameters::persistence_threshold(0.4).threshold_is_absolute(true);
      SMRG::simplify_Reeb_graph(
          input.mesh, boost::make_assoc_property_map(infinite_map), graph, threshold);
      SMRG::simplify_Reeb_graph(
          input.mesh, boost::make_assoc_property_map(finite_map), expected, threshold);
    }
  }
}

// Two closed surfaces that share a vertex are no manifold, and a vertex of a halfedge data
// structure leads to the faces of one of them only.
void check_several_fans(const Index_mesh& index_mesh, const Numbered_mesh<Mesh>& input)
{
  std::mt19937 rng(17);
  std::size_t number_of_errors = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<double> values = i % 3 == 0
                                           ? random_integer_values(index_mesh.points.size(), 3, rng)
                                           : random_values(index_mesh.points.size(), rng);
    const auto map = function_map<Vertex>([&](Vertex v) { return values[input.number.at(v)]; });
    std::vector<int> arcs(values.size() + 9, 77);
    SMRG::Reeb_graph<Mesh> graph;
    add_vertex(graph);
    try {
      SMRG::compute_Reeb_graph(
          input.mesh, map, graph, SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)));
    } catch (const SMRG::Error&) {
      ++number_of_errors;
      BOOST_CHECK_EQUAL(num_vertices(graph), 1u);
      BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));
      continue;
    }
    if (i % 3 != 0) { // the oracle does not know plateaus
      const Brute_force_Reeb_graph expected =
          brute_force_Reeb_graph(index_mesh, rank_of_values(values));
      BOOST_REQUIRE_EQUAL(num_vertices(graph), expected.nodes.size());
      BOOST_CHECK_EQUAL(num_edges(graph), expected.arcs.size());
      for (std::size_t k = 0; k < expected.nodes.size(); ++k) {
        BOOST_CHECK_EQUAL(input.number.at(graph[k].vertex), expected.nodes[k].vertex);
      }
    }
  }
  BOOST_TEST_MESSAGE(number_of_errors << " errors of 300");

  SMRG::Reeb_graph<Mesh> graph;
  try {
    SMRG::commute_time_Reeb_graph(input.mesh, graph);
  } catch (const SMRG::Error&) {
    BOOST_CHECK_EQUAL(num_vertices(graph), 0u);
  }
}

BOOST_AUTO_TEST_CASE(several_closed_fans_by_add_face)
{
  // the two tetrahedra 0123 and 0456; the faces that close the fans at 0 come last
  const Index_mesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {4, 6, 5}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 6, 4}, {0, 1, 3}, {0, 5, 6}}};
  Numbered_mesh<Mesh> input;
  try {
    make_mesh(mesh, input.mesh, input.vertices);
  } catch (const std::runtime_error&) {
    BOOST_TEST_MESSAGE("CGAL refuses to make this mesh");
    return;
  }
  input.number_vertices();
  check_several_fans(mesh, input);
}

BOOST_AUTO_TEST_CASE(several_closed_fans_by_gluing)
{
  Index_mesh mesh = sphere(0);
  const std::size_t n = mesh.points.size();
  append(mesh, sphere(0), 3);
  Numbered_mesh<Mesh> input(mesh);
  // vertex n becomes vertex 0
  std::vector<Mesh::Halfedge_index> star;
  for (auto h : CGAL::halfedges_around_target(input.vertices[n], input.mesh)) {
    star.push_back(h);
  }
  for (auto h : star) {
    set_target(h, input.vertices[0], input.mesh);
  }
  set_halfedge(input.vertices[n], Mesh::null_halfedge(), input.mesh);
  remove_vertex(input.vertices[n], input.mesh);
  input.vertices.erase(input.vertices.begin() + static_cast<std::ptrdiff_t>(n));
  input.number_vertices();

  mesh.points.erase(mesh.points.begin() + static_cast<std::ptrdiff_t>(n));
  for (auto& t : mesh.triangles) {
    for (std::size_t& v : t) {
      v = v == n ? 0 : v > n ? v - 1 : v;
    }
  }
  check_several_fans(mesh, input);
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Files

BOOST_AUTO_TEST_SUITE(files)

struct Graph_fixture
{
  Numbered_mesh<Mesh> input;
  std::vector<double> values;
  std::vector<int> arcs;
  SMRG::Reeb_graph<Mesh> graph;

  Graph_fixture()
  {
    Index_mesh mesh = rough_torus();
    mesh.points.push_back({9, 9, 1. / 3}); // isolated
    make_mesh(mesh, input.mesh, input.vertices);
    input.number_vertices();
    std::mt19937 rng(18);
    for (const auto& p : mesh.points) {
      values.push_back(1e-5 * (p[0] + random_unit(rng) / 3));
    }
    arcs.resize(values.size());
    SMRG::compute_Reeb_graph(
        input.mesh,
        CGAL::make_property_map(values),
        graph,
        SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)).collect_arc_vertices(true));
  }
};

boost::property_tree::ptree parse_xml(const std::string& text)
{
  std::istringstream in(text);
  boost::property_tree::ptree tree;
  read_xml(in, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree;
}

template <class T>
std::vector<T> numbers(const std::string& text)
{
  std::istringstream in(text);
  std::vector<T> result((std::istream_iterator<T>(in)), std::istream_iterator<T>());
  BOOST_CHECK(in.eof());
  return result;
}

BOOST_FIXTURE_TEST_CASE(polylines, Graph_fixture)
{
  for (const int number_of_samples : {0, 1, 10, 1000}) {
    std::ostringstream out;
    out.precision(3);
    BOOST_CHECK(SMRG::IO::write_polylines(
        out, graph, input.mesh, CGAL::parameters::number_of_samples(number_of_samples)));
    BOOST_CHECK_EQUAL(out.precision(), 3);

    std::istringstream in(out.str());
    std::string line;
    for (auto e : CGAL::make_range(edges(graph))) {
      BOOST_REQUIRE(std::getline(in, line));
      const std::vector<double> row = numbers<double>(line);
      const std::vector<Mesh::Point> polyline = SMRG::arc_polyline(
          e, graph, input.mesh, CGAL::parameters::number_of_samples(number_of_samples));
      BOOST_CHECK_LE(polyline.size(), static_cast<std::size_t>(number_of_samples) + 2);
      BOOST_REQUIRE_EQUAL(row[0], static_cast<double>(polyline.size()));
      BOOST_REQUIRE_EQUAL(row.size(), 3 * polyline.size() + 1);
      for (std::size_t i = 0; i < polyline.size(); ++i) {
        BOOST_CHECK(polyline[i] == Mesh::Point(row[3 * i + 1], row[3 * i + 2], row[3 * i + 3]));
      }
      BOOST_CHECK(polyline.front() == input.mesh.point(graph[source(e, graph)].vertex));
      BOOST_CHECK(polyline.back() == input.mesh.point(graph[target(e, graph)].vertex));
    }
    BOOST_CHECK(!std::getline(in, line));
  }
}

// Files hold what streams get.
BOOST_FIXTURE_TEST_CASE(files, Graph_fixture)
{
  const auto scalar_map = CGAL::make_property_map(values);
  const auto arc_map = CGAL::make_property_map(arcs);
  const auto check = [&](const auto& write) {
    std::string file = (std::filesystem::temp_directory_path() /
                        ("reeb_graph_" + std::to_string(std::random_device()())))
                           .string();
    std::ofstream(file) << "what was there before";
    std::ostringstream out;
    BOOST_CHECK(write(out));
    BOOST_CHECK(write(file));
    std::ifstream in(file, std::ios_base::binary);
    BOOST_CHECK(out.str() == std::string(std::istreambuf_iterator<char>(in), {}));
    in.close();
    std::filesystem::remove(file);
    file += "/of/no/folder";
    BOOST_CHECK(!write(file));
  };
  check([&](auto& out) { return SMRG::IO::write_polylines(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_GraphML(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_Graphviz(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_persistence_diagram(out, graph); });
  check([&](auto& out) { return SMRG::IO::write_VTP(out, input.mesh, scalar_map, arc_map); });

  const SMRG::Reeb_graph<Mesh> empty;
  check([&](auto& out) { return SMRG::IO::write_polylines(out, empty, input.mesh); });
}

// As XML has them.
BOOST_FIXTURE_TEST_CASE(graphml_with_infinite_values, Graph_fixture)
{
  const double infinity = std::numeric_limits<double>::infinity();
  *std::min_element(values.begin(), values.end()) = -infinity;
  *std::max_element(values.begin(), values.end()) = infinity;
  SMRG::compute_Reeb_graph(input.mesh, CGAL::make_property_map(values), graph);
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(out.str().find(">INF<") != std::string::npos);
  BOOST_CHECK(out.str().find(">-INF<") != std::string::npos);
  BOOST_CHECK(out.str().find(">inf<") == std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(polylines_with_an_error, Graph_fixture)
{
  std::ostringstream out;
  out.precision(3);
  BOOST_CHECK_THROW(
      SMRG::IO::write_polylines(out, graph, input.mesh, CGAL::parameters::number_of_samples(-1)),
      SMRG::Error);
  BOOST_CHECK(out.str().empty());
  BOOST_CHECK_EQUAL(out.precision(), 3);
}

BOOST_FIXTURE_TEST_CASE(graphml, Graph_fixture)
{
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  const boost::property_tree::ptree tree = parse_xml(out.str());

  std::map<std::string, std::string> node_property, arc_property; // names by key
  std::vector<std::map<std::string, std::string>> nodes, arcs_read;
  auto read_data = [](const boost::property_tree::ptree& element,
                      const std::map<std::string, std::string>& property) {
    std::map<std::string, std::string> data;
    for (const auto& child : element) {
      if (child.first == "data") {
        data[property.at(child.second.get<std::string>("<xmlattr>.key"))] = child.second.data();
      }
    }
    return data;
  };
  for (const auto& child : tree.get_child("graphml")) {
    if (child.first == "key") {
      const bool is_node = child.second.get<std::string>("<xmlattr>.for") == "node";
      (is_node ? node_property : arc_property)[child.second.get<std::string>("<xmlattr>.id")] =
          child.second.get<std::string>(
              "<xmlattr>.attr.name",
              child.second.get_child("<xmlattr>").count("attr.name")
                  ? child.second.get_child("<xmlattr>").find("attr.name")->second.data()
                  : "");
    }
  }
  for (const auto& child : tree.get_child("graphml.graph")) {
    if (child.first == "node") {
      nodes.push_back(read_data(child.second, node_property));
    } else if (child.first == "edge") {
      arcs_read.push_back(read_data(child.second, arc_property));
    }
  }
  BOOST_REQUIRE_EQUAL(nodes.size(), num_vertices(graph));
  BOOST_REQUIRE_EQUAL(arcs_read.size(), num_edges(graph));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& node = graph[i];
    const Mesh::Point p = input.mesh.point(node.vertex);
    std::ostringstream type;
    type << node.type;
    BOOST_CHECK_EQUAL(nodes[i].at("id"), std::to_string(i));
    BOOST_CHECK_EQUAL(nodes[i].at("mesh_vertex"), std::to_string(input.number.at(node.vertex)));
    BOOST_CHECK_EQUAL(nodes[i].at("type"), type.str());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("value")), node.value);
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("x")), p.x());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("y")), p.y());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("z")), p.z());
  }
  std::size_t i = 0;
  for (auto e : CGAL::make_range(edges(graph))) {
    BOOST_CHECK_EQUAL(arcs_read[i].at("id"), std::to_string(i));
    BOOST_CHECK_EQUAL(arcs_read[i].at("number_of_vertices"),
                      std::to_string(graph[e].vertices.size()));
    ++i;
  }
}

BOOST_FIXTURE_TEST_CASE(graphviz, Graph_fixture)
{
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_Graphviz(out, graph, input.mesh));
  const std::string text = out.str();
  BOOST_CHECK_EQUAL(text.compare(0, 7, "graph G"), 0);
  std::istringstream in(text);
  std::string line;
  std::size_t number_of_nodes = 0, number_of_arcs = 0;
  while (std::getline(in, line)) {
    if (line.find("--") != std::string::npos) {
      ++number_of_arcs;
    } else if (line.find('[') != std::string::npos) {
      const std::string name = " value=";
      const std::size_t begin = line.find(name);
      BOOST_REQUIRE(begin != std::string::npos);
      std::string value = line.substr(begin + name.size());
      value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
      const std::size_t id = static_cast<std::size_t>(std::stoul(line));
      BOOST_REQUIRE_LT(id, num_vertices(graph));
      BOOST_CHECK_EQUAL(std::stod(value), graph[id].value);
      ++number_of_nodes;
    }
  }
  BOOST_CHECK_EQUAL(number_of_nodes, num_vertices(graph));
  BOOST_CHECK_EQUAL(number_of_arcs, num_edges(graph));
}

BOOST_FIXTURE_TEST_CASE(vtp, Graph_fixture)
{
  std::ostringstream out;
  out.precision(3);
  BOOST_CHECK(SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs)));
  BOOST_CHECK_EQUAL(out.precision(), 3);
  const boost::property_tree::ptree tree = parse_xml(out.str());
  const auto& piece = tree.get_child("VTKFile.PolyData.Piece");
  BOOST_CHECK_EQUAL(piece.get<std::size_t>("<xmlattr>.NumberOfPoints"), input.vertices.size());
  BOOST_CHECK_EQUAL(piece.get<std::size_t>("<xmlattr>.NumberOfPolys"), num_faces(input.mesh));

  std::map<std::string, std::string> arrays;
  for (const char* section : {"PointData", "Points", "Polys"}) {
    for (const auto& child : piece.get_child(section)) {
      if (child.first == "DataArray") {
        arrays[child.second.get<std::string>("<xmlattr>.Name", section)] = child.second.data();
      }
    }
  }
  check_equal(numbers<double>(arrays.at("value")), values);
  check_equal(numbers<int>(arrays.at("arc")), arcs);
  BOOST_CHECK_EQUAL(arcs.back(), -1);
  const std::vector<double> coordinates = numbers<double>(arrays.at("Points"));
  BOOST_REQUIRE_EQUAL(coordinates.size(), 3 * input.vertices.size());
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    BOOST_CHECK(input.mesh.point(input.vertices[i]) ==
                Mesh::Point(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]));
  }
  const std::vector<std::size_t> corners = numbers<std::size_t>(arrays.at("connectivity"));
  BOOST_REQUIRE_EQUAL(corners.size(), 3 * rough_torus().triangles.size());
  for (std::size_t i = 0; i < rough_torus().triangles.size(); ++i) {
    // the same triangle, whatever its first corner
    std::array<std::size_t, 3> read = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
    std::rotate(read.begin(), std::min_element(read.begin(), read.end()), read.end());
    std::array<std::size_t, 3> expected = rough_torus().triangles[i];
    std::rotate(
        expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
    BOOST_CHECK(read == expected);
  }
  const std::vector<std::size_t> offsets = numbers<std::size_t>(arrays.at("offsets"));
  BOOST_REQUIRE_EQUAL(offsets.size(), num_faces(input.mesh));
  BOOST_CHECK_EQUAL(offsets.back(), corners.size());
}

// A vertex without an arc has the number -1 in the file, whatever the type of the numbers.
template <class Number>
void check_vtp_of_isolated_vertex()
{
  const Numbered_mesh<Mesh> input(Index_mesh{{{0, 0, 0}}, {}});
  const std::vector<double> values(1, 0.);
  std::vector<Number> arcs(1, Number(77));
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(input.mesh,
                           CGAL::make_property_map(values),
                           graph,
                           SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)));
  std::ostringstream out;
  SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs));
  BOOST_CHECK(contains(out.str(), "Name=\"arc\" format=\"ascii\">\n-1\n<"));
}

BOOST_AUTO_TEST_CASE(vtp_of_isolated_vertex)
{
  check_vtp_of_isolated_vertex<int>();
  check_vtp_of_isolated_vertex<std::size_t>();
  check_vtp_of_isolated_vertex<unsigned>();
}

BOOST_FIXTURE_TEST_CASE(stream_that_fails, Graph_fixture)
{
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  BOOST_CHECK(!SMRG::IO::write_polylines(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_Graphviz(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs)));
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Threads

BOOST_AUTO_TEST_SUITE(threads)

// The mesh is the only thing that the threads share.
template <class TriangleMesh>
void check_threads(const Index_mesh& mesh)
{
  const Numbered_mesh<TriangleMesh> input(mesh);
  constexpr std::size_t rounds = 20;
  std::vector<std::vector<double>> values;
  std::vector<Scalar_result> expected, found(2 * rounds);
  for (unsigned i = 0; i < 2 * rounds; ++i) {
    values.push_back(rough_values(mesh, i));
    expected.push_back(scalar_result(input, values.back()));
  }
  auto work = [&](const std::size_t first) {
    for (std::size_t i = first; i < values.size(); i += 2) {
      found[i] = scalar_result(input, values[i]);
    }
  };
  std::thread odd(work, 1);
  work(0);
  odd.join();
  for (std::size_t i = 0; i < values.size(); ++i) {
    check_equal(found[i], expected[i]);
  }
}

BOOST_AUTO_TEST_CASE(one_mesh_two_threads)
{
  check_threads<Mesh>(rough_torus());
  check_threads<Plain_polyhedron>(rough_torus());
}

BOOST_AUTO_TEST_CASE(one_mesh_two_threads_whole_method)
{
  const Numbered_mesh<Mesh> input(shape_with_limbs());
  std::array<SMRG::Reeb_graph<Mesh>, 2> graphs;
  auto work = [&](const std::size_t i) {
    SMRG::commute_time_Reeb_graph(
        input.mesh,
        graphs[i],
        SMRG::parameters::persistence_threshold(0.05).collect_arc_vertices(true));
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  check_close(plain(input, graphs[0]), spectral_reference().graph);
  check_close(plain(input, graphs[1]), spectral_reference().graph);
}

BOOST_AUTO_TEST_SUITE_END()
