// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE Reeb_graph_signature

#include "random_Reeb_graph_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_signature.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#if __has_include(<hera/bottleneck/bottleneck.h>)
#include <CGAL/Surface_mesh_Reeb_graph/bottleneck_distance.h>
#define HAS_HERA 1
#endif

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Signature = SMRG::Reeb_graph_signature;

const double rounding = 1e-12;

Signature signature_of(Case& c)
{
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));
  return SMRG::compute_Reeb_graph_signature(c.mesh, c.values, graph, c.arcs);
}

Signature signature_of(const Index_mesh& mesh, const std::vector<double>& values)
{
  Case c(mesh, values);
  return signature_of(c);
}

Index_mesh random_mesh(std::mt19937& rng)
{
  return random_small_mesh(rng);
}

double largest_change(const std::vector<double>& f, const std::vector<double>& g)
{
  double change = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    change = (std::max)(change, std::abs(f[i] - g[i]));
  return change;
}

// The persistence of the components that have at least branch_masses[k], at one level.
std::vector<double> branches(const std::vector<double>& persistences, std::size_t k)
{
  const auto first = persistences.begin() +
                     static_cast<std::ptrdiff_t>(k * (1 + SMRG::internal::number_of_branches));
  std::vector<double> result(first, first + 1 + SMRG::internal::number_of_branches);
  result.erase(std::find(result.begin(), result.end(), 0.), result.end());
  return result;
}

std::vector<double>
branch_persistences(const SMRG::internal::Measured_graph& graph, const std::vector<double>& h)
{
  std::vector<double> result;
  SMRG::internal::Growing_components(graph, h).append_branch_persistences(result);
  return result;
}

// The quantiles of the values at which points reach component_masses[k].
std::vector<double> component_quantiles(const SMRG::internal::Measured_graph& graph,
                                        const std::vector<double>& h,
                                        std::size_t k)
{
  std::vector<double> all;
  SMRG::internal::Growing_components(graph, h).append_component_quantiles(all);
  const std::size_t n = SMRG::internal::number_of_quantiles;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>((k + 1) * n);
  return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(n));
}

} // namespace

BOOST_AUTO_TEST_CASE(quantiles)
{
  using Values = std::vector<double>;
  SMRG::internal::Weighted_values values;
  values.add(1, 3);
  values.add(0, 3);
  BOOST_TEST(values.mean_quantiles(1) == Values({.5}));
  BOOST_TEST(values.mean_quantiles(2) == Values({0, 1}));
  BOOST_TEST(values.mean_quantiles(3) == Values({0, .5, 1}));
  values.add(7, 0); // without weight
  BOOST_TEST(values.mean_quantiles(2) == Values({0, 1}));
}

BOOST_AUTO_TEST_CASE(loop)
{
  // 0 -- 1 splits into two sides with 30 percent of the mass each, which meet in 3
  SMRG::internal::Measured_graph graph;
  graph.values = {0, 1, 2, 2, 3, 4};
  graph.masses = {.1, .1, .3, .3, .1, .1};
  graph.edges = {{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}, {4, 5}};

  // sublevel sets grow without branches
  const std::vector<double> sublevel = branch_persistences(graph, graph.values);
  BOOST_TEST(branches(sublevel, 0) == std::vector<double>({4}), boost::test_tools::per_element());

  // around the middle there are two components until 1 and 4 come
  const std::vector<double> distance = {2, 1, 0, 0, 1, 2};
  const std::vector<double> interlevel = branch_persistences(graph, distance);
  for (const std::size_t mass : {std::size_t(0), SMRG::internal::branch_masses.size() - 1})
    BOOST_TEST(branches(interlevel, mass) == std::vector<double>({2, 1}),
               boost::test_tools::per_element());

  // 30 percent are there at once for 60 percent of the points, and at t = 1 for what joins then
  const std::size_t n = SMRG::internal::number_of_quantiles;
  const std::vector<double> reached = component_quantiles(graph, distance, 4);
  BOOST_TEST(SMRG::internal::component_masses[4] == .3);
  for (std::size_t i = 0; i < n; ++i) {
    const double fraction = (static_cast<double>(i) + .5) / static_cast<double>(n);
    if (std::abs(fraction - .6) > .5 / static_cast<double>(n) &&
        std::abs(fraction - .8) > .5 / static_cast<double>(n))
    {
      BOOST_TEST(reached[i] == (fraction < .6   ? 0
                                : fraction < .8 ? 1
                                                : 2),
                 boost::test_tools::tolerance(rounding));
    }
  }
}

// Two trees with the same diagram: the branch that splits at 4 and ends at 5 hangs on the trunk, or
// on the branch that splits at 2 and ends at 8.
BOOST_AUTO_TEST_CASE(structure_beyond_the_diagram)
{
  SMRG::internal::Measured_graph on_trunk, on_branch;
  on_trunk.values = {0, 2, 4, 4, 5, 8, 10};
  on_trunk.masses = {.1, .1, .2, .1, .2, .1, .2};
  on_branch = on_trunk;
  on_trunk.edges = {{0, 1}, {1, 2}, {1, 3}, {2, 6}, {3, 5}, {2, 4}};
  on_branch.edges = {{0, 1}, {1, 2}, {1, 3}, {2, 6}, {3, 5}, {3, 4}};
  std::vector<double> h;
  for (const double value : on_trunk.values)
    h.push_back(10 - value);
  BOOST_TEST(branches(branch_persistences(on_trunk, h), 0) ==
                 branches(branch_persistences(on_branch, h), 0),
             boost::test_tools::per_element());
  const SMRG::internal::Interlevel_features a = SMRG::internal::interlevel_features(on_trunk),
                                            b = SMRG::internal::interlevel_features(on_branch);
  BOOST_TEST(SMRG::internal::mean_difference(a.function_quantiles, b.function_quantiles) == 0);
  BOOST_TEST(SMRG::internal::mean_difference(a.component_quantiles, b.component_quantiles) > 1e-3);
  BOOST_TEST(SMRG::internal::mean_difference(a.branch_persistences, b.branch_persistences) > 1e-3);
}

BOOST_AUTO_TEST_CASE(pseudo_metric)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 5; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      std::vector<Signature> s;
      for (int i = 0; i < 3; ++i) {
        const Index_mesh mesh = random_mesh(rng);
        s.push_back(signature_of(mesh, random_values(mesh.points.size(), rng)));
      }
      const auto check = [&](const auto& distance) {
        for (const Signature& signature : s)
          BOOST_TEST(distance(signature, signature) == 0);
        const double ab = distance(s[0], s[1]), bc = distance(s[1], s[2]),
                     ac = distance(s[0], s[2]);
        BOOST_TEST(ab > 0);
        BOOST_TEST(ab == distance(s[1], s[0]));
        BOOST_TEST(ac <= (ab + bc) * (1 + rounding));
        BOOST_TEST(ab <= (ac + bc) * (1 + rounding));
        BOOST_TEST(bc <= (ab + ac) * (1 + rounding));
      };
      check(SMRG::Reeb_graph_distance);
      check(SMRG::persistence_distance);
#ifdef HAS_HERA
      check(SMRG::bottleneck_distance);
      for (const Signature& a : s)
        for (const Signature& b : s)
          BOOST_TEST(SMRG::persistence_distance(a, b) <=
                     2 * SMRG::bottleneck_distance(a, b) + rounding);
#endif
    }
  }
}

BOOST_AUTO_TEST_CASE(zero_after_renumbering)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 5; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_mesh(rng);
      const std::size_t n = mesh.points.size();
      const std::vector<double> values = random_values(n, rng);
      const std::vector<std::size_t> number = random_permutation(n, rng);
      Index_mesh renumbered = mesh;
      std::vector<double> renumbered_values(n);
      for (std::size_t v = 0; v < n; ++v) {
        renumbered.points[number[v]] = mesh.points[v];
        renumbered_values[number[v]] = values[v];
      }
      for (auto& t : renumbered.triangles)
        t = {number[t[1]], number[t[2]], number[t[0]]};
      shuffle(renumbered.triangles, rng);
      BOOST_TEST(SMRG::Reeb_graph_distance(signature_of(mesh, values),
                                           signature_of(renumbered, renumbered_values)) <=
                 rounding);
    }
  }
}

// Scaling the points changes nothing, nor does what makes areas no larger than masses.
BOOST_AUTO_TEST_CASE(zero_after_scaling_the_surface)
{
  std::mt19937 rng(1);
  const Index_mesh mesh = torus(12, 8);
  Index_mesh scaled = mesh;
  for (auto& p : scaled.points)
    p = {1000 * p[0], 1000 * p[2], 1000 * p[1]};
  const std::vector<double> values = random_values(mesh.points.size(), rng);
  BOOST_TEST(SMRG::Reeb_graph_distance(signature_of(mesh, values), signature_of(scaled, values)) <=
             rounding);
}

// The proof is in the manual: no more than the largest change of the function.
BOOST_AUTO_TEST_CASE(stability)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 2; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_mesh(rng);
      const std::size_t n = mesh.points.size();
      const std::vector<double> f = random_values(n, rng);
      const double size = std::pow(10., -static_cast<double>(random_index(4, rng)));
      std::vector<double> g = f;
      for (double& value : g)
        value += size * (2 * random_unit(rng) - 1);
      const double change = largest_change(f, g);
      const Signature a = signature_of(mesh, f), b = signature_of(mesh, g);
      BOOST_TEST(SMRG::Reeb_graph_distance(a, b) <= change * (1 + rounding));
      BOOST_TEST(SMRG::persistence_distance(a, b) <= 2 * change * (1 + rounding));

      // and each part by its own constant, which the weighted sum would hide
      const auto check_part =
          [change](const std::vector<double>& x, const std::vector<double>& y, double constant) {
            BOOST_REQUIRE_EQUAL(x.size(), y.size());
            BOOST_TEST(largest_change(x, y) <= constant * change * (1 + rounding) + rounding);
          };
      check_part(a.function_quantiles, b.function_quantiles, 1);
      check_part(a.component_quantiles, b.component_quantiles, 2);
      check_part(a.branch_persistences, b.branch_persistences, 4);
      check_part(SMRG::internal::largest_persistences(a.diagram),
                 SMRG::internal::largest_persistences(b.diagram),
                 2);
#ifdef HAS_HERA
      BOOST_TEST(SMRG::bottleneck_distance(a, b) <= change * (1 + rounding));
#endif
    }
  }
}

// A constant that is added matters only to the quantiles; upside down, levels change places.
BOOST_AUTO_TEST_CASE(shifted_function)
{
  std::mt19937 rng(3);
  const Index_mesh mesh = torus(10, 7);
  const std::vector<double> f = random_values(mesh.points.size(), rng);
  std::vector<double> g = f;
  for (double& value : g)
    value += 1000;
  const Signature a = signature_of(mesh, f), b = signature_of(mesh, g);
  BOOST_TEST(largest_change(a.component_quantiles, b.component_quantiles) <= 1e-10);
  BOOST_TEST(largest_change(a.branch_persistences, b.branch_persistences) <= 1e-10);
  BOOST_TEST(largest_change(a.function_quantiles, b.function_quantiles) == 1000,
             boost::test_tools::tolerance(rounding));
}

// The same function on the torus and on the sphere cannot be compared, but standing on their ends
// they have graphs with and without a loop.
BOOST_AUTO_TEST_CASE(a_loop_is_far_from_none)
{
  const auto heights = [](const Index_mesh& mesh) {
    double length = 0;
    for (const auto& p : mesh.points)
      length = (std::max)(length, std::abs(p[0]));
    std::vector<double> result;
    for (const auto& p : mesh.points)
      result.push_back((p[0] + 1e-6 * p[1] + 1e-7 * p[2]) / length);
    return result;
  };
  const Index_mesh ring = torus(40, 20), coarse_ring = torus(32, 16), ball = sphere(3);
  const Signature a = signature_of(ring, heights(ring)),
                  b = signature_of(coarse_ring, heights(coarse_ring)),
                  c = signature_of(ball, heights(ball));
  BOOST_TEST(SMRG::Reeb_graph_distance(a, b) * 5 < SMRG::Reeb_graph_distance(a, c));
}

// Vertices of cancelled branches count at the nearer end of their arc, so that no mass is lost.
BOOST_AUTO_TEST_CASE(simplified_graph)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 10; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_mesh(rng);
      Case c(mesh, random_values(mesh.points.size(), rng));
      Graph graph;
      const auto np = SMRG::parameters::vertex_arc_map(c.arcs);
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph, np);
      SMRG::simplify_Reeb_graph(c.mesh, c.values, graph, np.persistence_threshold(.5));
      const Signature s = SMRG::compute_Reeb_graph_signature(c.mesh, c.values, graph, c.arcs);
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const auto node : CGAL::make_range(vertices(graph))) {
        lowest = (std::min)(lowest, graph[node].value);
        highest = (std::max)(highest, graph[node].value);
      }
      BOOST_TEST(s.function_quantiles.front() >= lowest);
      BOOST_TEST(s.function_quantiles.back() <= highest);
      // all mass is there in the end: 95 percent are reached by everything
      for (const double t : s.component_quantiles)
        BOOST_TEST(t <= highest - lowest);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_data)
{
  std::mt19937 rng(4);
  const Index_mesh mesh = torus(6, 5);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));
  const auto compute = [&]() {
    return SMRG::compute_Reeb_graph_signature(c.mesh, c.values, graph, c.arcs);
  };
  BOOST_CHECK_NO_THROW(compute());

  const Vertex v(3);
  const std::size_t arc = c.arcs[v];
  for (const std::size_t wrong : {num_edges(graph), SMRG::null_arc}) {
    c.arcs[v] = wrong;
    BOOST_CHECK_THROW(compute(), SMRG::Input_error);
  }
  c.arcs[v] = arc;

  // of a node, and of another vertex
  for (const Vertex w : {graph[*vertices(graph).first].vertex, Vertex(3)}) {
    const double value = c.values[w];
    c.values[w] = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(compute(), SMRG::Input_error);
    c.values[w] = std::numeric_limits<double>::infinity();
    BOOST_CHECK_THROW(compute(), SMRG::Input_error);
    c.values[w] = value;
  }

  const auto points = c.mesh.points();
  std::vector<Mesh::Point> old_points;
  for (const Vertex w : c.mesh.vertices()) {
    old_points.push_back(points[w]);
    c.mesh.point(w) = Mesh::Point(1, 2, 3);
  }
  BOOST_CHECK_THROW(compute(), SMRG::Input_error); // no area
  for (const Vertex w : c.mesh.vertices())
    c.mesh.point(w) = old_points[w];
  BOOST_CHECK_NO_THROW(compute());

  Mesh empty;
  const auto values = empty.add_property_map<Vertex, double>("v:value").first;
  const auto arcs = empty.add_property_map<Vertex, std::size_t>("v:arc").first;
  Graph no_graph;
  BOOST_CHECK_THROW(SMRG::compute_Reeb_graph_signature(empty, values, no_graph, arcs),
                    SMRG::Input_error);
}
