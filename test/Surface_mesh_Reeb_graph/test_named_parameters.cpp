// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named parameters, in any order, and what they do.

#define BOOST_TEST_MODULE test_named_parameters

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Index_mesh.h"
#include "plain_results.h"
#include "random_meshes.h"
#include "spectral_results.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/Graphviz.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/mp11/algorithm.hpp>
#include <boost/mp11/list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using EPICK = CGAL::Exact_predicates_inexact_constructions_kernel;

} // namespace

// ---------------------------------------------------------------------------------------------
// Named parameters

BOOST_AUTO_TEST_SUITE(named_parameters)

// Every name as a type, from the list that the package makes its parameters of.
#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  struct Name_##Z                                                                                  \
  {                                                                                                \
    static auto first(int value) { return SMRG::parameters::Z(value); }                            \
    template <class NamedParameters>                                                               \
    static auto next(const NamedParameters& np, int value)                                         \
    {                                                                                              \
      return np.Z(value);                                                                          \
    }                                                                                              \
    template <class NamedParameters>                                                               \
    static int get(const NamedParameters& np)                                                      \
    {                                                                                              \
      return CGAL::parameters::get_parameter(np, SMRG::internal::tags::X());                       \
    }                                                                                              \
  };
#define CGAL_reuse_named_parameter CGAL_add_named_parameter
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter

using Own_names = boost::mp11::mp_list<void
#define CGAL_add_named_parameter(X, Y, Z) , Name_##Z
#define CGAL_reuse_named_parameter(X, Y, Z)
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter
                                       >;
using CGAL_names = boost::mp11::mp_list<void
#define CGAL_add_named_parameter(X, Y, Z)
#define CGAL_reuse_named_parameter(X, Y, Z) , Name_##Z
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter
                                        >;

// Whether each name of the first list can be followed by each other one of the second.
template <class First_names, class Second_names>
bool can_follow()
{
  using namespace boost::mp11;
  bool result = true;
  mp_for_each<mp_transform<mp_identity, mp_pop_front<First_names>>>([&result](auto first) {
    using First = typename decltype(first)::type;
    const auto one = First::first(1);
    using Others = mp_remove<mp_pop_front<Second_names>, First>;
    mp_for_each<mp_transform<mp_identity, Others>>([&result, &one](auto second) {
      using Second = typename decltype(second)::type;
      const auto two = Second::next(one, 2);
      result = result && First::get(two) == 1 && Second::get(two) == 2;
    });
  });
  return result;
}

// What may follow a name does not depend on what came before it, so that pairs stand for chains of
// any length.
BOOST_AUTO_TEST_CASE(names_in_any_order)
{
  BOOST_CHECK_GE(boost::mp11::mp_size<Own_names>::value, 17u);
  BOOST_CHECK_GE(boost::mp11::mp_size<CGAL_names>::value, 8u);
  BOOST_CHECK((can_follow<Own_names, CGAL_names>()));
  BOOST_CHECK((can_follow<CGAL_names, Own_names>()));
  BOOST_CHECK((can_follow<CGAL_names, CGAL_names>()));
}

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

// CGAL's names come first, last and in between.
BOOST_FIXTURE_TEST_CASE(all_names, Shape_fixture)
{
  SMRG::commute_time_Reeb_graph(
      input.mesh,
      graph,
      SMRG::parameters::vertex_index_map(get(boost::vertex_index, input.mesh))
          .collect_arc_vertices(true)
          .vertex_arc_map(CGAL::make_property_map(arcs))
          .vertex_value_map(CGAL::make_property_map(values))
          .output_iterator(std::back_inserter(points))
          .threshold_is_absolute(false)
          .sparse_linear_solver(SMRG::internal::Default_solver_traits())
          .persistence_threshold(0.05f)
          .minima_as_feature_points(false)
          .random_seed(0)
          .large_time(20.)
          .small_time(1.5f)
          .algorithm(SMRG::Reeb_graph_algorithm::SWEEP)
          .residual_tolerance(1e-8)
          .number_of_eigenpairs(std::size_t(50))
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
}

template <class VertexIndexMap>
void check_index_map(const Numbered_mesh<Mesh>& input,
                     const std::vector<double>& values,
                     const Scalar_result& expected,
                     VertexIndexMap vertex_index_map)
{
  const auto scalar_map = values_as_map(input, values);
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
  const std::vector<double> constant(n, 4);
  const auto map = values_as_map(input, constant);
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(input.mesh, map, graph);
  BOOST_REQUIRE_EQUAL(num_vertices(graph), 4u);
  BOOST_REQUIRE_EQUAL(num_edges(graph), 2u);
  BOOST_CHECK_EQUAL(input.number.at(graph[0].vertex), 0u);

  std::vector<std::size_t> reversed(n);
  for (std::size_t i = 0; i < n; ++i) {
    reversed[i] = n - 1 - i;
  }
  const std::vector<std::size_t>& const_reversed = reversed;
  SMRG::compute_Reeb_graph(
      input.mesh,
      map,
      graph,
      CGAL::parameters::vertex_index_map(CGAL::make_property_map(const_reversed)));
  BOOST_REQUIRE_EQUAL(num_vertices(graph), 4u);
  BOOST_CHECK_GE(input.number.at(graph[0].vertex), n / 2);
}

BOOST_AUTO_TEST_CASE(thresholds)
{
  const Numbered_mesh<Mesh> input(rough_torus());
  const std::vector<double> values = rough_values(rough_torus());
  const auto map = values_as_map(input, values);
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
// The whole method, with a graph of the user

BOOST_AUTO_TEST_SUITE(whole_method)

struct My_node
{
  Vertex vertex;
  std::size_t id = 99;
  SMRG::Reeb_node_type type = SMRG::Reeb_node_type::DEGENERATE;
  double value = -99;
};

struct My_arc
{
  std::vector<Vertex> vertices;
  std::size_t id = 99;
};

BOOST_AUTO_TEST_CASE(user_graph_of_the_whole_method)
{
  const Numbered_mesh<Mesh> input(shape_with_limbs());
  boost::adjacency_list<boost::vecS, boost::listS, boost::bidirectionalS, My_node, My_arc> graph;
  add_vertex(graph);
  SMRG::commute_time_Reeb_graph(
      input.mesh, graph, SMRG::parameters::persistence_threshold(0.05).collect_arc_vertices(true));
  check_close(plain(input, graph), spectral_reference().graph);

  std::ostringstream graphml, graphviz, polylines;
  BOOST_CHECK(SMRG::IO::write_GraphML(graphml, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_Graphviz(graphviz, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_polylines(polylines, graph, input.mesh));
}

BOOST_AUTO_TEST_SUITE_END()
