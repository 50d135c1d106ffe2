// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vertex order as a user gets it: as ranks and as values. (Its definition is tested with the
// Reeb graph.)

#define BOOST_TEST_MODULE vertex_order

#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// The vertices as the class sorts them.
std::vector<Vertex> sorted_vertices(const Case& c)
{
  const auto indices = get(boost::vertex_index, c.mesh);
  const SMRG::Vertex_order<Mesh, Value_map, std::decay_t<decltype(indices)>> order(
      c.mesh, c.values, indices);
  std::vector<Vertex> sorted(c.mesh.vertices().begin(), c.mesh.vertices().end());
  std::sort(sorted.begin(), sorted.end(), order);
  return sorted;
}

// Some cases with plateaus and some without.
template <class Function>
void for_random_cases(const Function& function)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      function(mesh,
               seed % 3 == 0 ? random_values(n, rng)
                             : random_integer_values(n, 1 + random_index(6, rng), rng));
    }
  }
}

bool is_too_small(const SMRG::Error& error)
{
  return std::string(error.what()).find("too small") != std::string::npos;
}

} // namespace

BOOST_AUTO_TEST_CASE(ranks_are_positions_in_the_order)
{
  for_random_cases([](const Index_mesh& mesh, const std::vector<double>& values) {
    const Case c(mesh, values);
    std::vector<int> ranks(values.size(), -1);
    SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(ranks));
    const std::vector<Vertex> sorted = sorted_vertices(c);
    for (std::size_t i = 0; i < sorted.size(); ++i)
      BOOST_TEST(ranks[sorted[i]] == static_cast<int>(i));
  });
}

BOOST_AUTO_TEST_CASE(values_are_distinct_and_have_the_same_order)
{
  for_random_cases([](const Index_mesh& mesh, const std::vector<double>& values) {
    Case c(mesh, values);
    const double n = static_cast<double>(values.size());
    const std::vector<Vertex> sorted = sorted_vertices(c);
    // in the place of the function itself
    SMRG::vertex_order_values(c.mesh, c.values, c.values);
    for (std::size_t i = 0; i < sorted.size(); ++i)
      BOOST_TEST(c.values[sorted[i]] == static_cast<double>(i) / n);
    BOOST_TEST((sorted_vertices(c) == sorted));

    std::vector<std::size_t> ranks(values.size());
    SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(ranks));
    for (std::size_t i = 0; i < sorted.size(); ++i)
      BOOST_TEST(ranks[sorted[i]] == i);
  });
}

BOOST_AUTO_TEST_CASE(ties_are_broken_by_the_given_indices)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  std::mt19937 rng(3);
  const Index_mesh mesh = torus(6, 5);
  const std::size_t n = mesh.points.size();
  // the number of edges to a vertex: all plateaus have a lower border, only indices break ties
  std::vector<double> values(n, static_cast<double>(n));
  values[4] = 0;
  for (std::size_t round = 0; round < n; ++round) {
    for (const auto& e : edges_of(mesh)) {
      values[e.first] = (std::min)(values[e.first], values[e.second] + 1);
      values[e.second] = (std::min)(values[e.second], values[e.first] + 1);
    }
  }
  const std::vector<std::size_t> index = random_permutation(n, rng);

  // the same numbering by the indices of a Surface_mesh
  Index_mesh renumbered = mesh;
  std::vector<double> renumbered_values(n);
  for (std::size_t i = 0; i < n; ++i) {
    renumbered.points[index[i]] = mesh.points[i];
    renumbered_values[index[i]] = values[i];
  }
  for (auto& triangle : renumbered.triangles)
    for (std::size_t& v : triangle)
      v = index[v];
  const Case expected(renumbered, renumbered_values);
  std::vector<unsigned> expected_ranks(n);
  SMRG::vertex_ranks(expected.mesh, expected.values, CGAL::make_property_map(expected_ranks));

  Polyhedron polyhedron;
  std::vector<Polyhedron::Vertex_handle> vertices;
  make_mesh(mesh, polyhedron, vertices);
  using Key = boost::graph_traits<Polyhedron>::vertex_descriptor;
  std::map<Key, float> function;
  std::map<Key, std::size_t> index_of_vertex;
  for (std::size_t i = 0; i < n; ++i) {
    function[vertices[i]] = static_cast<float>(values[i]);
    index_of_vertex[vertices[i]] = index[i];
  }
  const boost::associative_property_map<std::map<Key, float>> function_map(function);
  const auto np =
      CGAL::parameters::vertex_index_map(boost::make_assoc_property_map(index_of_vertex));
  std::map<Key, short> ranks;
  std::map<Key, double> order_values;
  SMRG::vertex_ranks(polyhedron, function_map, boost::make_assoc_property_map(ranks), np);
  SMRG::vertex_order_values(
      polyhedron, function_map, boost::make_assoc_property_map(order_values), np);
  for (std::size_t i = 0; i < n; ++i) {
    BOOST_TEST(ranks.at(vertices[i]) == static_cast<int>(expected_ranks[index[i]]));
    BOOST_TEST(order_values.at(vertices[i]) == expected_ranks[index[i]] / static_cast<double>(n));
  }

  // without indices: any order of ties, but a numbering
  SMRG::vertex_ranks(polyhedron, function_map, boost::make_assoc_property_map(ranks));
  std::vector<bool> is_used(n, false);
  for (const auto& rank : ranks)
    is_used.at(static_cast<std::size_t>(rank.second)) = true;
  BOOST_TEST(std::count(is_used.begin(), is_used.end(), true) == static_cast<long>(n));
}

BOOST_AUTO_TEST_CASE(removed_vertices_do_not_count)
{
  Case c(sphere(1), std::vector<double>(42, 1.));
  const Vertex first(0), last(41);
  CGAL::Euler::remove_center_vertex(c.mesh.halfedge(first), c.mesh);
  CGAL::Euler::remove_center_vertex(c.mesh.halfedge(last), c.mesh);
  std::vector<int> ranks(42, -1);
  std::vector<double> values(42, -1.);
  SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(ranks));
  SMRG::vertex_order_values(c.mesh, c.values, CGAL::make_property_map(values));
  for (const Vertex v : {first, last}) {
    BOOST_TEST(ranks[v] == -1);
    BOOST_TEST(values[v] == -1.);
  }
  std::sort(ranks.begin(), ranks.end());
  std::sort(values.begin(), values.end());
  for (int i = 0; i < 40; ++i) {
    BOOST_TEST(ranks[static_cast<std::size_t>(i + 2)] == i);
    BOOST_TEST(values[static_cast<std::size_t>(i + 2)] == i / 40.);
  }
}

template <class Number>
void check_ranks_of_type(const std::size_t n, const bool fit)
{
  // `n` vertices without edges are a mesh as well
  Index_mesh points;
  points.points.resize(n);
  std::vector<double> values(n);
  std::iota(values.rbegin(), values.rend(), 0.);
  const Case c(points, values);
  std::map<Vertex, Number> ranks;
  const auto write = [&]() {
    SMRG::vertex_ranks(c.mesh, c.values, boost::make_assoc_property_map(ranks));
  };
  if (fit) {
    write();
    BOOST_TEST(ranks.size() == n);
    for (const auto& rank : ranks)
      BOOST_TEST((rank.second == static_cast<Number>(n - 1 - rank.first)));
  } else {
    BOOST_CHECK_EXCEPTION(write(), SMRG::Error, is_too_small);
    BOOST_TEST(ranks.empty());
  }
}

BOOST_AUTO_TEST_CASE(types_of_ranks)
{
  check_ranks_of_type<signed char>(128, true);
  check_ranks_of_type<signed char>(129, false);
  check_ranks_of_type<std::uint8_t>(256, true);
  check_ranks_of_type<std::uint8_t>(257, false);
  check_ranks_of_type<short>(32769, false);
  check_ranks_of_type<bool>(2, true);
  check_ranks_of_type<bool>(3, false);
  check_ranks_of_type<float>(300, true);
  check_ranks_of_type<double>(300, true);
  check_ranks_of_type<std::uint64_t>(300, true);
  check_ranks_of_type<CGAL::Exact_predicates_exact_constructions_kernel::FT>(30, true);
  check_ranks_of_type<int>(0, true);
}

template <class Number>
void check_values_of_type()
{
  const std::size_t n = 1000;
  Index_mesh points;
  points.points.resize(n);
  std::vector<double> function(n);
  std::iota(function.begin(), function.end(), -3.);
  const Case c(points, function);
  std::map<Vertex, Number> values;
  SMRG::vertex_order_values(c.mesh, c.values, boost::make_assoc_property_map(values));
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST((values.at(Vertex(static_cast<unsigned>(i))) ==
                Number(static_cast<double>(i)) / Number(static_cast<double>(n))));
}

BOOST_AUTO_TEST_CASE(types_of_values)
{
  check_values_of_type<float>();
  check_values_of_type<double>();
  check_values_of_type<CGAL::Exact_predicates_exact_constructions_kernel::FT>();
}

// Which numbers of vertices a type can bear, without meshes of that size.
BOOST_AUTO_TEST_CASE(float_is_enough_for_2_to_the_24_vertices)
{
  const std::size_t n = std::size_t(1) << 24;
  BOOST_TEST(SMRG::internal::has_distinct_numbers<float>(n));
  BOOST_TEST(!SMRG::internal::has_distinct_numbers<float>(n + 1));
  BOOST_TEST(SMRG::internal::has_distinct_numbers<double>(n << 8));
  float previous = -1;
  bool are_distinct = true;
  for (std::size_t i = 0; i < n; ++i) {
    const float value = static_cast<float>(i) / static_cast<float>(n);
    are_distinct = are_distinct && previous < value;
    previous = value;
  }
  BOOST_TEST(are_distinct);
}

BOOST_AUTO_TEST_CASE(nan_is_an_error_that_names_the_vertex)
{
  std::mt19937 rng(5);
  Case c(sphere(1), random_values(42, rng));
  c.values[Vertex(17)] = std::numeric_limits<double>::quiet_NaN();
  std::vector<int> ranks(42, 77);
  std::vector<double> values(42, 77.);
  const auto names_the_vertex = [](const SMRG::Error& error) {
    return std::string(error.what()).find("vertex 17 ") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(ranks)),
                        SMRG::Error,
                        names_the_vertex);
  BOOST_CHECK_EXCEPTION(
      SMRG::vertex_order_values(c.mesh, c.values, CGAL::make_property_map(values)),
      SMRG::Error,
      names_the_vertex);
  BOOST_TEST(std::count(ranks.begin(), ranks.end(), 77) == 42);
  BOOST_TEST(std::count(values.begin(), values.end(), 77.) == 42);
}
