// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data that cannot be computed with, and data at the edge.

#define BOOST_TEST_MODULE test_invalid_data

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Index_mesh.h"
#include "brute_force_Reeb_graph.h"
#include "plain_results.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/Graphviz.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/VTP.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

using namespace Reeb_graph_test;

// ---------------------------------------------------------------------------------------------
// Data that cannot be computed with, and data at the edge

BOOST_AUTO_TEST_SUITE(errors)

// `value_map` reads `values`.
template <class Float, class VertexScalarMap>
void check_nan(const Numbered_mesh<Mesh>& input,
               std::vector<Float>& values,
               VertexScalarMap value_map)
{
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
  const Numbered_mesh<Mesh> input(rough_torus());
  std::vector<double> doubles = rough_values(rough_torus());
  std::vector<float> floats(doubles.begin(), doubles.end());
  check_nan(input, doubles, values_as_map(input, doubles));
  check_nan(input, floats, CGAL::make_property_map(floats));
}

struct Arguments
{
  double persistence_threshold = 0;
  int number_of_eigenpairs = 5;
  double residual_tolerance = 1e-8;
  double small_time = 1.5;
  double large_time = 20;
};

// All outputs of the whole method, and whether they are as they were.
struct Outputs
{
  SMRG::Reeb_graph<Mesh> graph{1};
  std::vector<double> values;
  std::vector<int> arcs;
  std::vector<Vertex> points;

  explicit Outputs(std::size_t number_of_vertices)
    : values(number_of_vertices, 77), arcs(number_of_vertices, 77)
  {}

  void compute(const Mesh& mesh, const Arguments& arguments)
  {
    SMRG::commute_time_Reeb_graph(
        mesh,
        graph,
        SMRG::parameters::vertex_value_map(CGAL::make_property_map(values))
            .vertex_arc_map(CGAL::make_property_map(arcs))
            .output_iterator(std::back_inserter(points))
            .persistence_threshold(arguments.persistence_threshold)
            .number_of_eigenpairs(arguments.number_of_eigenpairs)
            .residual_tolerance(arguments.residual_tolerance)
            .small_time(arguments.small_time)
            .large_time(arguments.large_time));
  }

  void check_untouched() const
  {
    BOOST_CHECK_EQUAL(num_vertices(graph), 1u);
    BOOST_CHECK_EQUAL(std::count(values.begin(), values.end(), 77),
                      static_cast<long>(values.size()));
    BOOST_CHECK_EQUAL(std::count(arcs.begin(), arcs.end(), 77), static_cast<long>(arcs.size()));
    BOOST_CHECK(points.empty());
  }
};

BOOST_AUTO_TEST_CASE(coordinate_that_is_not_finite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Index_mesh mesh = rough_torus();
    mesh.points[31][1] = bad;
    const Numbered_mesh<Mesh> input(mesh);
    Outputs outputs(mesh.points.size());
    BOOST_CHECK_EXCEPTION(outputs.compute(input.mesh, Arguments()),
                          SMRG::Error,
                          [](const SMRG::Error& error) { return contains(error.what(), " 31 "); });
    outputs.check_untouched();
  }
}

// What the programmer can check is a precondition; what only the computation finds out is an error.
BOOST_AUTO_TEST_CASE(arguments_out_of_range)
{
  const Numbered_mesh<Mesh> input(sphere(1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Outputs outputs(input.vertices.size());
  for (const Arguments& arguments : {Arguments{-0.1, 5, 1e-8, 1.5, 20},
                                     Arguments{nan, 5, 1e-8, 1.5, 20},
                                     Arguments{0, 0, 1e-8, 1.5, 20},
                                     Arguments{0, -5, 1e-8, 1.5, 20},
                                     Arguments{0, 5, 1e-8, nan, 20},
                                     Arguments{0, 5, 1e-8, 1.5, -1}})
  {
    BOOST_CHECK_THROW(outputs.compute(input.mesh, arguments), CGAL::Precondition_exception);
    outputs.check_untouched();
  }
  BOOST_CHECK_THROW(outputs.compute(input.mesh, Arguments{0, 5, 0, 1.5, 20}),
                    SMRG::Numerical_error);
  outputs.check_untouched();

  const auto map = CGAL::make_property_map(outputs.values);
  BOOST_CHECK_THROW(SMRG::height_function(input.mesh, Double_kernel::Vector_3(0, 0, 0), map),
                    CGAL::Precondition_exception);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(input.mesh,
                                                      SMRG::parameters::number_of_eigenpairs(5));
  BOOST_CHECK_THROW(SMRG::eigenfunction(basis, 0, map), CGAL::Precondition_exception);
  BOOST_CHECK_THROW(SMRG::eigenfunction(basis, 1000, map), CGAL::Precondition_exception);
  outputs.check_untouched();
}

BOOST_AUTO_TEST_CASE(empty_mesh)
{
  const Numbered_mesh<Mesh> input;
  const Mesh& mesh = input.mesh;
  const std::vector<double> values;
  const auto map = values_as_map(input, values);
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

  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(mesh,
                                                      SMRG::parameters::number_of_eigenpairs(5));
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
    const auto infinite_map = values_as_map(input, infinite);
    const auto finite_map = values_as_map(input, finite);
    SMRG::Reeb_graph<Mesh> graph, expected;
    const auto np = SMRG::parameters::collect_arc_vertices(true);
    SMRG::compute_Reeb_graph(input.mesh, infinite_map, graph, np);
    SMRG::compute_Reeb_graph(input.mesh, finite_map, expected, np);
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
      SMRG::simplify_Reeb_graph(input.mesh, infinite_map, graph, threshold);
      SMRG::simplify_Reeb_graph(input.mesh, finite_map, expected, threshold);
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
    const auto map = values_as_map(input, values);
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
