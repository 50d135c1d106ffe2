// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE Reeb_graph_hierarchy

#include "check_Reeb_graph.h"
#include "simplification_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_gap.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Hierarchy = SMRG::Reeb_graph_hierarchy<Graph>;

template <class NamedParameters>
Graph simplified(Graph graph, const NamedParameters& np)
{
  SMRG::simplify_Reeb_graph(Mesh(), Value_map(), graph, np);
  return graph;
}

Graph level_of(const Hierarchy& hierarchy, const double threshold)
{
  Graph result = make_graph({7, 8}, {{0, 1}}); // what is there before is lost
  hierarchy.make_graph(threshold, result);
  return result;
}

// The same nodes and arcs with the same numbers.
bool are_equal(const Graph& a, const Graph& b)
{
  if (arcs_of(a) != arcs_of(b) || num_vertices(a) != num_vertices(b))
    return false;
  for (const auto node : CGAL::make_range(vertices(a)))
    if (a[node].id != b[node].id || a[node].vertex != b[node].vertex ||
        a[node].value != b[node].value || a[node].type != b[node].type)
      return false;
  std::size_t number = 0;
  for (const auto arc : CGAL::make_range(edges(b)))
    if (b[arc].id != number++)
      return false;
  return true;
}

// At and around all persistences, and between them.
std::vector<double> thresholds_of(const Hierarchy& hierarchy)
{
  std::vector<double> result = {0, infinity, std::numeric_limits<double>::denorm_min()};
  for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i)
    result.push_back(hierarchy.threshold(i));
  for (const double persistence : hierarchy.persistences())
    for (const double towards : {0., persistence, infinity})
      result.push_back(std::nextafter(persistence, towards));
  return result;
}

template <class NamedParameters>
void check_all_levels(const Graph& graph, const NamedParameters& np)
{
  const Hierarchy hierarchy(graph, np);
  for (const double threshold : thresholds_of(hierarchy))
    BOOST_TEST_CONTEXT("threshold " << threshold)
    {
      BOOST_TEST(are_equal(level_of(hierarchy, threshold),
                           simplified(graph, np.persistence_threshold(threshold))));
    }
}

const auto relative = SMRG::parameters::threshold_is_absolute(false);
const auto absolute = SMRG::parameters::threshold_is_absolute(true);

// A minimum with a long branch upwards on it: when the turn of the minimum comes, the branch is
// still there.
Graph branch_that_waits()
{
  //  0 -- 3, 1 -- 2 -- 3, 2 -- 4, 3 -- 5
  return make_graph({0, 1, 1.5, 2, 9, 10}, {{0, 3}, {1, 2}, {2, 3}, {2, 4}, {3, 5}});
}

} // namespace

BOOST_AUTO_TEST_CASE(levels_of_a_known_graph)
{
  const Graph graph = branch_that_waits();
  const Hierarchy hierarchy(graph, absolute);
  BOOST_TEST(hierarchy.persistences() == (std::vector<double>{1, 7.5}),
             boost::test_tools::per_element());
  BOOST_TEST(hierarchy.number_of_levels() == 3u);
  BOOST_TEST(hierarchy.threshold(0) == 0);
  BOOST_TEST(hierarchy.threshold(1) == 4.25);
  BOOST_TEST(hierarchy.threshold(2) == infinity);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(hierarchy.level(hierarchy.threshold(i)) == i);
  BOOST_TEST(hierarchy.level(1) == 0u); // a pair of just that persistence stays
  BOOST_TEST(hierarchy.level(7.5) == 1u);
  BOOST_TEST(are_equal(level_of(hierarchy, 1), graph));
  // the maximum hangs on the other branch, at its own height
  const Graph zipped = level_of(hierarchy, 4.25);
  BOOST_TEST(values_of(zipped) == (std::vector<double>{0, 1.5, 9, 10}),
             boost::test_tools::per_element());
  BOOST_TEST((arcs_of(zipped) == std::vector<Rank_pair>{{0, 1}, {1, 2}, {1, 3}}));
  BOOST_TEST(values_of(level_of(hierarchy, 8)) == (std::vector<double>{0, 10}),
             boost::test_tools::per_element());
  check_all_levels(graph, absolute);
  check_all_levels(graph, relative);
}

BOOST_AUTO_TEST_CASE(levels_of_small_graphs)
{
  const Graph empty, node = make_graph({3}, {}), plateau = make_graph({3, 3}, {{0, 1}}),
                     infinite = make_graph({-infinity, 0, 1, 2, infinity, infinity},
                                           {{0, 2}, {1, 2}, {2, 3}, {3, 4}, {3, 5}});
  for (const Graph& graph : {empty, node, plateau, infinite}) {
    check_all_levels(graph, absolute);
    check_all_levels(graph, relative);
  }
  BOOST_TEST(Hierarchy(empty).number_of_levels() == 1u);
  BOOST_TEST(Hierarchy(plateau).number_of_levels() == 1u);
  BOOST_TEST(Hierarchy(infinite, absolute).number_of_levels() == 2u);
}

// With parallel arcs, degenerate and isolated nodes, several components and ties.
BOOST_AUTO_TEST_CASE(levels_of_random_graphs)
{
  for_random_graphs(number_of_random_cases(), [](const Graph& graph, const auto&, double) {
    check_all_levels(graph, absolute);
    check_all_levels(graph, relative);
  });
}

// The levels are all graphs that there are: between two persistences nothing changes, and at a
// persistence something does. The middle of a gap is the threshold of a level.
BOOST_AUTO_TEST_CASE(levels_are_all_that_there_are)
{
  for_random_graphs(number_of_random_cases(), [](const Graph& graph, const auto&, double) {
    const Hierarchy hierarchy(graph, absolute);
    std::vector<double> persistences;
    const std::vector<double> values = values_of(graph);
    for (const Extended_pair& pair : oracle_pairs(graph))
      if (pair.kind != EXTENDED && persistence_of(pair, values) > 0)
        persistences.push_back(persistence_of(pair, values));
    std::sort(persistences.begin(), persistences.end());
    persistences.erase(std::unique(persistences.begin(), persistences.end()), persistences.end());
    BOOST_TEST(hierarchy.persistences() == persistences, boost::test_tools::per_element());
    for (std::size_t i = 0; i < persistences.size(); ++i) {
      const Graph before = level_of(hierarchy, persistences[i]),
                  after = level_of(hierarchy, std::nextafter(persistences[i], infinity));
      BOOST_TEST(hierarchy.level(persistences[i]) == i);
      BOOST_TEST(are_equal(before, level_of(hierarchy, hierarchy.threshold(i))));
      BOOST_TEST(are_equal(after, level_of(hierarchy, hierarchy.threshold(i + 1))));
      BOOST_TEST(!are_equal(before, after));
    }
    const SMRG::Persistence_gap gap = SMRG::persistence_gap(graph, 1, absolute);
    BOOST_TEST(are_equal(level_of(hierarchy, gap.threshold),
                         simplified(graph, absolute.persistence_gap(1))));
  });
}

BOOST_AUTO_TEST_CASE(levels_of_random_meshes)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      Case c(mesh, seed % 3 == 2 ? random_integer_values(n, 12, rng) : random_values(n, rng));
      Graph graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      check_all_levels(graph, absolute);
      check_all_levels(graph, relative);
      // loops are closed after the branches
      const Hierarchy hierarchy(graph);
      const double threshold = random_unit(rng);
      const auto both =
          relative.persistence_threshold(threshold).loop_persistence_threshold(random_unit(rng));
      BOOST_TEST(
          are_equal(simplified(level_of(hierarchy, threshold), both), simplified(graph, both)));
    }
  }
}

// Graphs of functions on a real shape, one of them with much noise.
BOOST_AUTO_TEST_CASE(levels_of_large_graphs)
{
  Mesh mesh;
  const std::string filename = CGAL::data_file_path("meshes/elephant.off");
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    BOOST_TEST_MESSAGE("there is no " << filename);
    return;
  }
  const auto heights = mesh.add_property_map<Vertex, double>("v:height").first;
  const auto noise = mesh.add_property_map<Vertex, double>("v:noise").first;
  std::mt19937 rng(1);
  for (const Vertex v : mesh.vertices()) {
    heights[v] = mesh.point(v).y();
    noise[v] = heights[v] + 0.3 * random_unit(rng);
  }
  for (const Value_map& values : {heights, noise}) {
    Graph graph;
    SMRG::compute_Reeb_graph(mesh, values, graph);
    const Hierarchy hierarchy(graph);
    BOOST_TEST(hierarchy.number_of_levels() > 10u);
    // the graphs of all levels, and what simplify_Reeb_graph() makes of some of them
    std::size_t number_of_nodes = num_vertices(graph) + 1;
    const std::size_t step = 1 + hierarchy.number_of_levels() / 100;
    for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i) {
      const Graph level = level_of(hierarchy, hierarchy.threshold(i));
      BOOST_TEST(num_vertices(level) < number_of_nodes);
      number_of_nodes = num_vertices(level);
      if (i % step == 0 || i + 1 == hierarchy.number_of_levels())
        BOOST_TEST(are_equal(
            level,
            simplified(graph, SMRG::parameters::persistence_threshold(hierarchy.threshold(i)))));
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_arguments_and_graphs)
{
  Graph graph = branch_that_waits();
  const Hierarchy hierarchy(graph);
  BOOST_CHECK_THROW(hierarchy.threshold(3), CGAL::Precondition_exception);
  BOOST_CHECK_THROW(hierarchy.level(-1), CGAL::Precondition_exception);
  BOOST_CHECK_THROW(hierarchy.make_graph(-1, graph), CGAL::Precondition_exception);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(hierarchy.make_graph(no_number, graph), CGAL::Precondition_exception);
  BOOST_TEST(num_vertices(graph) == 6u);
  graph[2].value = no_number;
  BOOST_CHECK_THROW(Hierarchy{graph}, SMRG::Input_error);
}
