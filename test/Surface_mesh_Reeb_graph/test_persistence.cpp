// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE persistence

#include "persistence_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>

#include <boost/graph/adjacency_list.hpp>

#if __has_include(<gudhi/reader_utils.h>)
#include <gudhi/reader_utils.h>
#define HAS_GUDHI 1
#endif

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

using namespace Reeb_graph_test;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

std::vector<Extended_pair> pairs_of(const std::vector<Rank_pair>& arcs, const std::size_t n)
{
  return comparable_pairs(Reeb_graph_test::pairs_of(make_graph(std::vector<double>(n, 0.), arcs)));
}

// The vertices of the nodes have these ranks.
std::vector<std::size_t> rank_of_nodes(const Graph& graph, const std::vector<std::size_t>& rank)
{
  std::vector<std::size_t> result;
  for (const auto node : CGAL::make_range(vertices(graph)))
    result.push_back(rank[graph[node].vertex]);
  return result;
}

std::size_t number_of_loops(const Graph& graph)
{
  std::size_t loops = 0;
  for (const Pair& pair : Reeb_graph_test::pairs_of(graph))
    loops += pair.kind == SMRG::Persistence_pair_kind::LOOP ? 1 : 0;
  return loops;
}

} // namespace

BOOST_AUTO_TEST_CASE(small_graphs)
{
  using Pairs = std::vector<Extended_pair>;
  // a path, two nodes alone
  BOOST_TEST(pairs_of({{0, 1}}, 2) == (Pairs{{EXTENDED, 0, 0, 1}}));
  BOOST_TEST(pairs_of({}, 2) == (Pairs{{EXTENDED, 0, 0, 0}, {EXTENDED, 0, 1, 1}}));
  // a torus
  BOOST_TEST(pairs_of({{0, 1}, {1, 2}, {1, 2}, {2, 3}}, 4) ==
             (Pairs{{EXTENDED, 0, 0, 3}, {EXTENDED, 1, 2, 1}}));
  // three arcs side by side
  BOOST_TEST(pairs_of({{0, 1}, {0, 1}, {0, 1}}, 2) ==
             (Pairs{{EXTENDED, 0, 0, 1}, {EXTENDED, 1, 1, 0}, {EXTENDED, 1, 1, 0}}));
  // a branch down, a branch up
  BOOST_TEST(pairs_of({{0, 2}, {1, 2}, {2, 3}, {3, 4}, {3, 5}}, 6) ==
             (Pairs{{ORDINARY, 0, 1, 2}, {RELATIVE, 1, 4, 3}, {EXTENDED, 0, 0, 5}}));
  // two loops that share a side: the inner one is complete first, the other one begins lower
  BOOST_TEST(pairs_of({{0, 1}, {1, 2}, {2, 3}, {2, 3}, {3, 4}, {1, 4}, {4, 5}}, 6) ==
             (Pairs{{EXTENDED, 0, 0, 5}, {EXTENDED, 1, 3, 2}, {EXTENDED, 1, 4, 1}}));
  // two loops side by side that overlap: of the second one the best cycle leaves the first one out
  BOOST_TEST(pairs_of({{0, 1}, {1, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 4}, {4, 5}}, 6) ==
             (Pairs{{EXTENDED, 0, 0, 5}, {EXTENDED, 1, 3, 1}, {EXTENDED, 1, 4, 2}}));
}

BOOST_AUTO_TEST_CASE(an_empty_graph_has_no_pairs)
{
  BOOST_TEST(Reeb_graph_test::pairs_of(Graph()).empty());
}

// A cycle neither side of which is monotone: it goes 2, 5, 3, 7, 4, 6 and back.
BOOST_AUTO_TEST_CASE(a_loop_may_go_up_and_down)
{
  const std::vector<Rank_pair> arcs = {{2, 5},
                                       {3, 5},
                                       {3, 7},
                                       {4, 7},
                                       {4, 6},
                                       {2, 6},
                                       {0, 3},
                                       {1, 4},
                                       {5, 8},
                                       {6, 9},
                                       {7, 10},
                                       {0, 2}};
  const Graph graph = make_graph(std::vector<double>(11, 0.), arcs);
  BOOST_TEST(comparable_pairs(Reeb_graph_test::pairs_of(graph)) == oracle_pairs(graph),
             boost::test_tools::per_element());
}

// Against the matrix, and what the documentation says of every node.
BOOST_AUTO_TEST_CASE(pairs_of_random_graphs_are_those_of_the_matrix)
{
  for (unsigned seed = 0; seed < 5 * number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      const std::vector<Pair> pairs = Reeb_graph_test::pairs_of(graph);
      BOOST_TEST(comparable_pairs(pairs) == oracle_pairs(graph), boost::test_tools::per_element());

      const std::size_t n = num_vertices(graph);
      std::vector<std::size_t> down(n, 0), up(n, 0), from_below(n, 0), from_above(n, 0);
      for (const auto arc : CGAL::make_range(edges(graph))) {
        ++up[source(arc, graph)];
        ++down[target(arc, graph)];
      }
      std::size_t components = 0, loops = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Pair& pair = pairs[i];
        BOOST_TEST(pair.birth_value == graph[pair.birth].value);
        BOOST_TEST(pair.death_value == graph[pair.death].value);
        BOOST_TEST(pair.persistence() == graph[pair.upper()].value - graph[pair.lower()].value);
        BOOST_TEST(pair.lower() <= pair.upper());
        if (i > 0)
          BOOST_TEST((std::make_tuple(pairs[i - 1].kind, pairs[i - 1].birth, pairs[i - 1].death) <=
                      std::make_tuple(pair.kind, pair.birth, pair.death)));
        switch (pair.kind) {
        case SMRG::Persistence_pair_kind::MINIMUM:
          BOOST_TEST(down[pair.birth] == 0u);
          ++from_below[pair.death];
          break;
        case SMRG::Persistence_pair_kind::MAXIMUM:
          BOOST_TEST(up[pair.birth] == 0u);
          ++from_above[pair.death];
          break;
        case SMRG::Persistence_pair_kind::COMPONENT:
          BOOST_TEST(down[pair.birth] == 0u);
          BOOST_TEST(up[pair.death] == 0u);
          ++components;
          break;
        case SMRG::Persistence_pair_kind::LOOP:
          ++from_below[pair.birth];
          ++from_above[pair.death];
          ++loops;
          break;
        }
      }
      BOOST_TEST(loops + n == num_edges(graph) + components);
      for (std::size_t node = 0; node < n; ++node) {
        BOOST_TEST(from_below[node] == (std::max)(down[node], std::size_t(1)) - 1);
        BOOST_TEST(from_above[node] == (std::max)(up[node], std::size_t(1)) - 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(pairs_of_the_reversed_graph_are_mirrored)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      const std::size_t n = num_vertices(graph);
      std::vector<double> values = values_of(graph);
      std::reverse(values.begin(), values.end());
      for (double& value : values)
        value = -value;
      std::vector<Rank_pair> arcs;
      for (const Rank_pair& arc : arcs_of(graph))
        arcs.emplace_back(n - 1 - arc.second, n - 1 - arc.first);

      std::vector<Extended_pair> mirrored;
      for (const Extended_pair& pair : comparable_pairs(Reeb_graph_test::pairs_of(graph))) {
        const std::size_t birth = n - 1 - pair.birth, death = n - 1 - pair.death;
        if (pair.kind == EXTENDED)
          mirrored.push_back({EXTENDED, pair.dimension, death, birth});
        else if (pair.kind == ORDINARY)
          mirrored.push_back({RELATIVE, 1, birth, death});
        else
          mirrored.push_back({ORDINARY, 0, birth, death});
      }
      std::sort(mirrored.begin(), mirrored.end());
      BOOST_TEST(comparable_pairs(Reeb_graph_test::pairs_of(make_graph(values, arcs))) == mirrored,
                 boost::test_tools::per_element());
    }
  }
}

// Only the order of the values counts; the numbers of arcs do not.
BOOST_AUTO_TEST_CASE(monotone_maps_and_renumbered_arcs_change_nothing)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      std::vector<double> values = values_of(graph);
      for (double& value : values)
        value = std::exp(value / 10) - 3;
      std::vector<Rank_pair> arcs = arcs_of(graph);
      shuffle(arcs, rng);
      BOOST_TEST(comparable_pairs(Reeb_graph_test::pairs_of(make_graph(values, arcs))) ==
                     comparable_pairs(Reeb_graph_test::pairs_of(graph)),
                 boost::test_tools::per_element());
    }
  }
}

// On meshes with and without borders and pinched vertices, several components and any genus.
// Extended persistence of the mesh has pairs of dimension 1 of two sorts: cycles that run along the
// function have their birth above their death, cycles in level sets the other way round. The former
// are the loops of the Reeb graph. (Cycles of birth and death at one vertex are handles that a
// multiple saddle hides.)
BOOST_AUTO_TEST_CASE(pairs_of_random_meshes_are_those_of_the_matrix)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 4; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::vector<double> values = random_values(mesh.points.size(), rng);
      Case c(mesh, values);
      Graph graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      const std::vector<std::size_t> rank = rank_of_values(values);
      const std::vector<Extended_pair> pairs = with_ranks(
          comparable_pairs(Reeb_graph_test::pairs_of(graph)), rank_of_nodes(graph, rank));

      std::vector<Extended_pair> expected;
      for (const Extended_pair& pair : extended_persistence(ranked_complex_of_mesh(mesh, rank)))
        if (pair.dimension == 0 || (pair.dimension == 1 && pair.kind == RELATIVE) ||
            (pair.dimension == 1 && pair.kind == EXTENDED && pair.birth > pair.death))
          expected.push_back(pair);
      BOOST_TEST(pairs == expected, boost::test_tools::per_element());
    }
  }
}

// Values that are no floating-point numbers, bundles and a graph type of the user's own.
BOOST_AUTO_TEST_CASE(any_graph_type_will_do)
{
  struct My_node
  {
    std::size_t id = 0;
    Vertex vertex = {};
    std::int64_t value = 0;
    SMRG::Reeb_node_type type = SMRG::Reeb_node_type::ISOLATED;
    std::string name = {};
  };
  struct My_arc
  {
    std::size_t id = 0;
    std::vector<Vertex> vertices = {};
  };
  using My_graph =
      boost::adjacency_list<boost::listS, boost::listS, boost::bidirectionalS, My_node, My_arc>;
  My_graph graph;
  const std::int64_t least = (std::numeric_limits<std::int64_t>::min)();
  const std::int64_t largest = (std::numeric_limits<std::int64_t>::max)();
  std::vector<My_graph::vertex_descriptor> nodes;
  for (const std::int64_t value : {largest, least, std::int64_t(0), std::int64_t(1)}) {
    nodes.push_back(add_vertex(graph));
    graph[nodes.back()].value = value;
  }
  graph[nodes[1]].id = 0;
  graph[nodes[2]].id = 1;
  graph[nodes[3]].id = 2;
  graph[nodes[0]].id = 3;
  std::size_t id = 0;
  // arcs may point up or down
  for (const auto& arc : {std::make_pair(1, 2), {2, 3}, {3, 2}, {0, 3}})
    graph[add_edge(nodes[arc.first], nodes[arc.second], graph).first].id = id++;

  std::vector<SMRG::Persistence_pair<My_graph>> pairs;
  SMRG::persistence_pairs(graph, std::back_inserter(pairs));
  BOOST_REQUIRE(pairs.size() == 2u);
  BOOST_TEST((pairs[0].kind == SMRG::Persistence_pair_kind::COMPONENT));
  BOOST_TEST((pairs[0].birth == nodes[1] && pairs[0].death == nodes[0]));
  BOOST_TEST(pairs[0].persistence() == std::ldexp(1., 64));
  BOOST_TEST((pairs[1].kind == SMRG::Persistence_pair_kind::LOOP));
  BOOST_TEST((pairs[1].birth == nodes[3] && pairs[1].death == nodes[2]));
  BOOST_TEST((pairs[1].upper() == nodes[3] && pairs[1].lower() == nodes[2]));
  BOOST_TEST(pairs[1].persistence() == 1);
}

BOOST_AUTO_TEST_CASE(equal_infinite_values_have_difference_0)
{
  const Graph graph =
      make_graph({-infinity, -infinity, 0, infinity, infinity}, {{0, 2}, {1, 2}, {2, 3}, {2, 4}});
  const std::vector<Pair> pairs = Reeb_graph_test::pairs_of(graph);
  BOOST_REQUIRE(pairs.size() == 3u);
  for (const Pair& pair : pairs)
    BOOST_TEST(pair.persistence() == infinity);
  const Graph flat = make_graph({infinity, infinity}, {{0, 1}});
  BOOST_TEST(Reeb_graph_test::pairs_of(flat).front().persistence() == 0);
}

BOOST_AUTO_TEST_CASE(bad_graphs_are_errors)
{
  const Graph good = make_graph({0, 1, 2, 3}, {{0, 1}, {1, 2}, {1, 2}, {2, 3}});
  const auto check_throws = [](const Graph& graph) {
    std::vector<Pair> pairs;
    BOOST_CHECK_THROW(SMRG::persistence_pairs(graph, std::back_inserter(pairs)), SMRG::Error);
    BOOST_TEST(pairs.empty());
    std::ostringstream out;
    BOOST_CHECK_THROW(SMRG::IO::write_persistence_diagram(out, graph), SMRG::Error);
    BOOST_TEST(out.str().empty());
  };
  Graph bad = good;
  bad[1].id = 0;
  check_throws(bad);
  bad = good;
  bad[*edges(bad).first].id = 7;
  check_throws(bad);
  bad = good;
  bad[2].value = std::numeric_limits<double>::quiet_NaN();
  check_throws(bad);
  bad = good;
  bad[2].value = 0.5;
  check_throws(bad);
  bad = good;
  bad[add_edge(1, 1, bad).first].id = 4;
  check_throws(bad);
}

BOOST_AUTO_TEST_CASE(diagrams_are_text)
{
  const Graph graph =
      make_graph({-infinity, 0.1, 0.25, 1, 2, 3}, {{0, 2}, {1, 2}, {2, 3}, {2, 3}, {3, 4}, {3, 5}});
  std::ostringstream out;
  out.precision(2);
  BOOST_TEST(SMRG::IO::write_persistence_diagram(out, graph));
  BOOST_TEST(out.str() == "# dimension, lower value, higher value\n"
                          "# minimum, merge\n"
                          "0 0.10000000000000001 0.25\n"
                          "# component: minimum, maximum\n"
                          "0 -inf 3\n"
                          "# split, maximum\n"
                          "1 1 2\n"
                          "# loop: split, merge\n"
                          "1 0.25 1\n");
  BOOST_TEST(out.precision() == 2);

  BOOST_TEST(!SMRG::IO::write_persistence_diagram("/no such folder/diagram.pers", graph));
  out.setstate(std::ios_base::failbit);
  BOOST_TEST(!SMRG::IO::write_persistence_diagram(out, graph));
}

#ifdef HAS_GUDHI

BOOST_AUTO_TEST_CASE(gudhi_reads_diagrams)
{
  using Intervals = std::vector<std::pair<double, double>>;
  const std::string filename = "test_persistence_diagram.pers";
  for (unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Graph graph = random_graph(rng, seed % 2 == 1);
      if (seed % 3 == 0)
        graph[num_vertices(graph) - 1].value = infinity;
      Intervals expected[2];
      for (const Pair& pair : Reeb_graph_test::pairs_of(graph)) {
        const bool is_of_dimension_0 = pair.kind == SMRG::Persistence_pair_kind::MINIMUM ||
                                       pair.kind == SMRG::Persistence_pair_kind::COMPONENT;
        expected[is_of_dimension_0 ? 0 : 1].emplace_back(graph[pair.lower()].value,
                                                         graph[pair.upper()].value);
      }
      BOOST_REQUIRE(SMRG::IO::write_persistence_diagram(filename, graph));
      auto grouped = Gudhi::read_persistence_intervals_grouped_by_dimension(filename);
      for (const int dimension : {0, 1}) {
        Intervals intervals = Gudhi::read_persistence_intervals_in_dimension(filename, dimension);
        BOOST_TEST((intervals == grouped[dimension]));
        std::sort(intervals.begin(), intervals.end());
        std::sort(expected[dimension].begin(), expected[dimension].end());
        BOOST_TEST((intervals == expected[dimension]));
      }
      BOOST_TEST(grouped.size() == 2u);
    }
  }
  std::remove(filename.c_str());
}

#endif

// A long ladder: every rung closes a loop with a path of any length through the forest. With paths
// that are followed arc by arc this would take hours.
BOOST_AUTO_TEST_CASE(large_graphs_take_no_quadratic_time)
{
  const std::size_t n = 200000;
  std::vector<Rank_pair> arcs;
  for (std::size_t i = 0; i + 2 < n; ++i) {
    arcs.emplace_back(i, i + 2);
    if (i % 2 == 0)
      arcs.emplace_back(i, i + 1);
  }
  const Graph ladder = make_graph(std::vector<double>(n, 0.), arcs);
  BOOST_TEST(number_of_loops(ladder) == num_edges(ladder) - n + 1);

  // two long sides from one node, and arches of arcs between their upper ends
  arcs.clear();
  for (std::size_t i = 1; i < n; ++i)
    arcs.emplace_back(i < 3 ? 0 : i - 2, i);
  for (std::size_t i = 0; i < n; ++i)
    arcs.emplace_back(n - 1 - i % 2, n + i);
  for (std::size_t i = 0; i + 2 < n; i += 2) {
    arcs.emplace_back(n + i, 2 * n + i);
    arcs.emplace_back(n + i + 1, 2 * n + i);
  }
  const Graph fan = make_graph(std::vector<double>(3 * n, 0.), arcs);
  BOOST_TEST(number_of_loops(fan) == n / 2 - 1);
}
