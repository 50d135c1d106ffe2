// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE cancel_branches

#include "simplification_checks.h"
#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Node_pair = std::pair<std::uint32_t, std::uint32_t>;

// The arcs that are left of a graph, as pairs (lower, upper).
std::multiset<Node_pair>
cancelled(const std::vector<double>& values, const std::vector<Arc_ends>& arcs, double threshold)
{
  Folded_graph folded(values.size(), arcs);
  cancel_branches(folded, values, threshold);
  std::multiset<Node_pair> result;
  for (std::uint32_t a = 0; a < folded.arcs().size(); ++a)
    if (folded.is_arc(a))
      result.emplace(folded.arcs()[a].lower, folded.arcs()[a].upper);
  return result;
}

std::vector<std::size_t> rank_of(const Case& c)
{
  std::vector<double> values;
  for (const Vertex v : c.mesh.vertices())
    values.push_back(c.values[v]);
  return rank_of_values(values);
}

// How many arcs cross the level just above every node of the unsimplified graph.
std::vector<long> arcs_at_levels(const Graph& graph, const std::vector<double>& levels)
{
  std::vector<long> result(levels.size(), 0);
  for (const auto arc : CGAL::make_range(edges(graph))) {
    const double lower = graph[source(arc, graph)].value, upper = graph[target(arc, graph)].value;
    for (std::size_t i = 0; i < levels.size(); ++i)
      result[i] += lower <= levels[i] && levels[i] < upper ? 1 : 0;
  }
  return result;
}

// Minima and maxima of a graph, nodes without arcs once.
std::size_t number_of_leaves(const Graph& graph)
{
  std::vector<std::size_t> down(num_vertices(graph), 0), up(num_vertices(graph), 0);
  for (const auto arc : CGAL::make_range(edges(graph))) {
    ++up[source(arc, graph)];
    ++down[target(arc, graph)];
  }
  std::size_t result = 0;
  for (std::size_t node = 0; node < down.size(); ++node)
    result += down[node] == 0 || up[node] == 0 ? 1 : 0;
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(leaf_branches_vanish)
{
  // a minimum 1 merges at 2 into the branch of minimum 0
  const std::vector<Arc_ends> y = {{0, 2}, {1, 2}, {2, 3}};
  BOOST_TEST((cancelled({0, 1, 2, 3}, y, 1) == std::multiset<Node_pair>{{0, 2}, {1, 2}, {2, 3}}));
  BOOST_TEST((cancelled({0, 1, 2, 3}, y, 1.5) == std::multiset<Node_pair>{{0, 3}}));
  // upside down
  const std::vector<Arc_ends> reversed = {{0, 1}, {1, 2}, {1, 3}};
  BOOST_TEST((cancelled({0, 1, 2, 3}, reversed, 1.5) == std::multiset<Node_pair>{{0, 3}}));
}

// Minimum 1 has the split 2 on its way up to the merge 3. The branch to the maximum 4 that begins
// there outlives the minimum: it hangs on the other path, at the height of its split.
BOOST_AUTO_TEST_CASE(what_hangs_on_a_branch_hangs_on_its_neighbor)
{
  const std::vector<Arc_ends> arcs = {{0, 3}, {1, 2}, {2, 3}, {2, 4}, {3, 5}};
  BOOST_TEST((cancelled({0, 1, 2, 3, 8, 9}, arcs, 2.5) ==
              std::multiset<Node_pair>{{0, 2}, {2, 4}, {2, 5}}));
}

// The same with a loop between 2 and 3 on the way.
BOOST_AUTO_TEST_CASE(loops_on_a_branch_stay)
{
  const std::vector<Arc_ends> arcs = {{0, 4}, {1, 2}, {2, 3}, {2, 3}, {3, 4}, {4, 5}};
  BOOST_TEST((cancelled({0, 1, 2, 3, 4, 9}, arcs, 3.5) ==
              std::multiset<Node_pair>{{0, 2}, {2, 3}, {2, 3}, {3, 5}}));
}

BOOST_AUTO_TEST_CASE(several_minima_may_die_at_one_node)
{
  const std::vector<Arc_ends> arcs = {{0, 3}, {1, 3}, {2, 3}, {3, 4}};
  BOOST_TEST(
      (cancelled({0, 1, 2, 3, 4}, arcs, 1.5) == std::multiset<Node_pair>{{0, 3}, {1, 3}, {3, 4}}));
  BOOST_TEST((cancelled({0, 1, 2, 3, 4}, arcs, 2.5) == std::multiset<Node_pair>{{0, 4}}));
}

BOOST_AUTO_TEST_CASE(vertices_of_a_cancelled_branch_go_to_the_arc_it_hung_on)
{
  const std::vector<double> values = {0, 1, 2, 3};
  const std::vector<Arc_ends> arcs = {{0, 2}, {1, 2}, {2, 3}};
  Folded_graph folded(values.size(), arcs);
  cancel_branches(folded, values, infinity);
  const auto is_below = [](std::uint32_t) { return false; };
  const std::uint32_t arc = folded.arc_after(0, is_below);
  BOOST_TEST(folded.is_arc(arc));
  BOOST_TEST(folded.arc_after(1, is_below) == arc);
  BOOST_TEST(folded.arc_after(2, is_below) == arc);

  // the arc from 0 to 3 is cut at 2: below and above there its vertices are told apart
  const std::vector<Arc_ends> hanging = {{0, 3}, {1, 2}, {2, 3}, {2, 4}, {3, 5}};
  const std::vector<double> hanging_values = {0, 1, 2, 3, 8, 9};
  Folded_graph cut(hanging_values.size(), hanging);
  cancel_branches(cut, hanging_values, 2.5);
  const std::uint32_t lower = cut.arc_after(0, [](std::uint32_t node) { return 1 < node; });
  const std::uint32_t upper = cut.arc_after(0, [](std::uint32_t node) { return 2 < node; });
  BOOST_TEST(cut.arcs()[lower].lower == 0u);
  BOOST_TEST(cut.arcs()[lower].upper == 2u);
  BOOST_TEST(cut.arcs()[upper].lower == 2u);
  BOOST_TEST(cut.arcs()[upper].upper == 5u);
}

// On random meshes, with distinct and with tied values, for growing thresholds on the same graph
// and at once: the extrema that are left are those that persistence, computed from the mesh alone,
// says; and at every level there are as many arcs less as pairs are cancelled whose two values lie
// around it.
BOOST_AUTO_TEST_CASE(cancels_exactly_the_pairs_below_the_threshold)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      const bool is_tied = seed % 3 == 2;
      Case c(mesh, is_tied ? random_integer_values(n, 12, rng) : random_values(n, rng));
      const double range = is_tied ? 12 : 1;

      Graph graph;
      const auto parameters = SMRG::parameters::vertex_arc_map(c.arcs).collect_arc_vertices(true);
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph, parameters);
      std::vector<double> levels;
      for (const auto node : CGAL::make_range(vertices(graph)))
        levels.push_back(graph[node].value);
      const std::vector<long> arcs_before = arcs_at_levels(graph, levels);
      const std::size_t loops = num_edges(graph) - num_vertices(graph);

      for (const double fraction : {0., 0.1, 0.3, 0.6, 2.}) {
        const double threshold = fraction * range;
        SMRG::simplify_Reeb_graph(
            c.mesh,
            c.values,
            graph,
            parameters.persistence_threshold(threshold).threshold_is_absolute(true));
        check_consistency(c, graph);
        BOOST_TEST(num_edges(graph) - num_vertices(graph) == loops);

        std::vector<long> expected_arcs = arcs_before;
        for (const bool minima : {true, false}) {
          // equal values: any order of theirs gives the same pairs of different values, but which
          // one of several equal extrema survives depends on it
          const Extremum_pairs pairs =
              brute_force_extremum_pairs(mesh, minima ? rank_of(c) : reversed_rank(rank_of(c)));
          std::vector<std::size_t> expected = pairs.unpaired_extrema;
          for (const Extremum_pair& pair : pairs.pairs) {
            const double from = c.values[Vertex(static_cast<unsigned>(pair.extremum))];
            const double to = c.values[Vertex(static_cast<unsigned>(pair.saddle))];
            if (from != to && std::abs(to - from) >= threshold) {
              expected.push_back(pair.extremum);
            } else {
              for (std::size_t i = 0; i < levels.size(); ++i)
                expected_arcs[i] -=
                    (std::min)(from, to) <= levels[i] && levels[i] < (std::max)(from, to) ? 1 : 0;
            }
          }
          std::vector<double> expected_values, values;
          for (const std::size_t v : expected)
            expected_values.push_back(c.values[Vertex(static_cast<unsigned>(v))]);
          for (const std::size_t v : extrema(graph, minima))
            values.push_back(c.values[Vertex(static_cast<unsigned>(v))]);
          std::sort(expected_values.begin(), expected_values.end());
          std::sort(values.begin(), values.end());
          BOOST_TEST(values == expected_values, boost::test_tools::per_element());
          if (!is_tied) {
            std::sort(expected.begin(), expected.end());
            BOOST_TEST(extrema(graph, minima) == expected, boost::test_tools::per_element());
          }
        }
        BOOST_TEST(arcs_at_levels(graph, levels) == expected_arcs,
                   boost::test_tools::per_element());
      }
    }
  }
}

// One component has ten times the range of the other; infinite values do not count for the range.
BOOST_AUTO_TEST_CASE(relative_thresholds_are_fractions_of_the_range_of_each_component)
{
  Index_mesh mesh = grid(12, 3);
  const std::size_t n = mesh.points.size();
  append(mesh, grid(12, 3), 100);
  // a ridge that goes up and down along the longer side: the dips have a fifth of the range
  const std::array<double, 12> profile = {0, 1, 2, 3, 2.4, 3.5, 4, 3, 2, 3, 2, 1.5};
  std::vector<double> values;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::size_t step = static_cast<std::size_t>(mesh.points[v][0] - (v < n ? 0 : 100));
    values.push_back((v < n ? 1 : 10) * profile[(std::min)(step, std::size_t(11))]);
  }
  Case c(mesh, values);
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
  const std::size_t minima = extrema(graph, true).size();
  BOOST_TEST(minima > 2u);
  Graph relative = graph, absolute = graph;
  SMRG::simplify_Reeb_graph(
      c.mesh, c.values, relative, SMRG::parameters::persistence_threshold(0.16));
  // 0.16 of the range 4 is 0.64: the dip of depth 0.6 goes, the one of depth 1 stays, in both
  BOOST_TEST(extrema(relative, true).size() == minima - 2);
  SMRG::simplify_Reeb_graph(
      c.mesh,
      c.values,
      absolute,
      SMRG::parameters::threshold_is_absolute(true).persistence_threshold(0.64));
  BOOST_TEST(extrema(absolute, true).size() == minima - 1);

  for (std::size_t v = 0; v < n; ++v)
    if (values[v] == 4)
      values[v] = std::numeric_limits<double>::infinity();
  c.set(values);
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
  // the highest finite node is the merge at 3 now, and 0.16 of the range 3 is 0.48
  SMRG::simplify_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::persistence_threshold(0.16));
  BOOST_TEST(extrema(graph, true).size() == minima - 1);
}

BOOST_AUTO_TEST_CASE(pairs_are_cancelled_until_few_leaves_are_left)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      Case c(mesh, random_values(mesh.points.size(), rng));
      Graph original;
      SMRG::compute_Reeb_graph(c.mesh, c.values, original);
      const std::size_t leaves = number_of_leaves(original);
      Graph smallest = original;
      SMRG::simplify_Reeb_graph(c.mesh, c.values, smallest, SMRG::parameters::number_of_leaves(0));
      const std::size_t fewest = number_of_leaves(smallest);
      std::vector<double> persistence;
      std::size_t expected_fewest = 0;
      for (const Pair& pair : pairs_of(original)) {
        if (pair.kind == SMRG::Persistence_pair_kind::COMPONENT)
          expected_fewest += pair.birth == pair.death ? 1 : 2;
        else if (pair.kind != SMRG::Persistence_pair_kind::LOOP)
          persistence.push_back(pair.persistence());
      }
      BOOST_TEST(fewest == expected_fewest);
      BOOST_TEST(leaves == fewest + persistence.size());
      std::sort(persistence.begin(), persistence.end());

      for (std::size_t number = fewest; number <= leaves + 1; number += 1 + random_index(5, rng)) {
        for (const bool is_absolute : {true, false}) {
          Graph graph = original;
          SMRG::compute_Reeb_graph(
              c.mesh,
              c.values,
              graph,
              SMRG::parameters::vertex_arc_map(c.arcs).collect_arc_vertices(true));
          SMRG::simplify_Reeb_graph(c.mesh,
                                    c.values,
                                    graph,
                                    SMRG::parameters::number_of_leaves(static_cast<int>(number))
                                        .threshold_is_absolute(is_absolute)
                                        .vertex_arc_map(c.arcs));
          check_consistency(c, graph);
          BOOST_TEST(number_of_leaves(graph) == (std::min)(number, leaves));
          if (!is_absolute)
            continue;
          // the same as all pairs below a threshold
          Graph by_threshold = original;
          const std::size_t number_of_cancelled = leaves - (std::min)(number, leaves);
          const double threshold =
              number_of_cancelled < persistence.size() ? persistence[number_of_cancelled] : 2;
          SMRG::simplify_Reeb_graph(
              c.mesh,
              c.values,
              by_threshold,
              SMRG::parameters::threshold_is_absolute(true).persistence_threshold(threshold));
          BOOST_TEST((arcs_of(graph) == arcs_of(by_threshold)));
        }
      }
    }
  }
}

// Two grids, one of them with a hundred times the range: the small one has the dip that is deeper
// in proportion, the large one the dip that is deeper.
BOOST_AUTO_TEST_CASE(leaves_of_components_compare_by_relative_persistence)
{
  const std::array<double, 8> small = {0, 4, 2, 5, 6, 7, 8, 9};
  const std::array<double, 8> large = {0, 400, 390, 500, 600, 700, 800, 900};
  Index_mesh mesh = grid(7, 1);
  append(mesh, grid(7, 1), 100);
  std::vector<double> values;
  for (const auto& p : mesh.points)
    values.push_back(p[0] < 50 ? small[static_cast<std::size_t>(p[0])]
                               : large[static_cast<std::size_t>(p[0] - 100)]);
  Case c(mesh, values);
  for (const bool is_absolute : {true, false}) {
    Graph graph;
    SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
    BOOST_TEST(number_of_leaves(graph) == 8u);
    SMRG::simplify_Reeb_graph(
        c.mesh,
        c.values,
        graph,
        SMRG::parameters::number_of_leaves(7u).threshold_is_absolute(is_absolute));
    double largest_minimum = 0;
    for (const std::size_t v : extrema(graph, true))
      largest_minimum = (std::max)(largest_minimum, values[v]);
    BOOST_TEST(number_of_leaves(graph) == 7u);
    BOOST_TEST(largest_minimum == (is_absolute ? 390 : 2));
  }
}

// The function is cut off at the saddle of its least pair: what remains is the simplified graph.
BOOST_AUTO_TEST_CASE(the_simplified_graph_is_that_of_the_simplified_function)
{
  std::size_t number_of_cases = 0;
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Index_mesh mesh = seed % 2 == 0 ? sphere(1) : grid(5, 5);
      flip_random_edges(mesh, random_index(100, rng), rng);
      std::vector<double> values = random_values(mesh.points.size(), rng);
      Case c(mesh, values);
      Graph graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      const std::vector<Pair> pairs = pairs_of(graph);
      const auto is_less = [](const Pair& p, const Pair& q) {
        const auto is_branch = [](const Pair& pair) {
          return pair.kind == SMRG::Persistence_pair_kind::MINIMUM ||
                 pair.kind == SMRG::Persistence_pair_kind::MAXIMUM;
        };
        return is_branch(p) != is_branch(q) ? is_branch(p) : p.persistence() < q.persistence();
      };
      const Pair least = *std::min_element(pairs.begin(), pairs.end(), is_less);
      // a branch that is an arc at a simple saddle
      const auto saddle_type = graph[least.death].type;
      if (saddle_type != SMRG::Reeb_node_type::SPLIT_SADDLE &&
          saddle_type != SMRG::Reeb_node_type::MERGE_SADDLE)
        continue;
      if (!edge(least.lower(), least.upper(), graph).second || out_degree(least.birth, graph) != 1)
        continue;
      ++number_of_cases;

      const bool is_maximum = least.kind == SMRG::Persistence_pair_kind::MAXIMUM;
      const double level = least.death_value;
      std::vector<std::size_t> branch = {std::size_t(graph[least.birth].vertex)};
      const std::set<Index_edge> mesh_edges = edges_of(mesh);
      for (std::size_t i = 0; i < branch.size(); ++i) {
        for (std::size_t v = 0; v < values.size(); ++v)
          if ((is_maximum ? values[v] > level : values[v] < level) &&
              mesh_edges.count(undirected(branch[i], v)) != 0)
          {
            values[v] = level;
            branch.push_back(v);
          }
        values[branch[i]] = level;
      }

      SMRG::simplify_Reeb_graph(c.mesh,
                                c.values,
                                graph,
                                SMRG::parameters::threshold_is_absolute(true).persistence_threshold(
                                    std::nextafter(least.persistence(), 2.)));
      c.set(values);
      Graph graph_of_simplified;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph_of_simplified);
      const auto arcs_between_vertices = [](const Graph& g) {
        std::multiset<Rank_pair> result;
        for (const auto arc : CGAL::make_range(edges(g)))
          result.emplace(std::size_t(g[source(arc, g)].vertex),
                         std::size_t(g[target(arc, g)].vertex));
        return result;
      };
      BOOST_TEST((arcs_between_vertices(graph) == arcs_between_vertices(graph_of_simplified)));
    }
  }
  BOOST_TEST(number_of_cases > number_of_random_cases() / 2);
}
