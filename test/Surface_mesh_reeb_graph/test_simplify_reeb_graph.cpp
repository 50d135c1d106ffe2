// Copyright (c) 2026 The Surface_mesh_reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE simplify_reeb_graph

#include "reeb_graph_checks.h"

#include <CGAL/Surface_mesh_reeb_graph/compute_reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Branch_cancellation.h>
#include <CGAL/Surface_mesh_reeb_graph/simplify_reeb_graph.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

using namespace Reeb_graph_test;
using SMRG::internal::Arc_ends;
using SMRG::internal::Branch_cancellation;

namespace {

using Node_pair = std::pair<std::uint32_t, std::uint32_t>;

// The arcs that are left of a graph, as pairs (lower, upper).
std::multiset<Node_pair>
cancelled(const std::vector<double>& values, const std::vector<Arc_ends>& arcs, double threshold)
{
  Branch_cancellation cancellation(values, arcs);
  cancellation.run(
      [&](const SMRG::internal::Extremum_pair& pair) { return pair.persistence < threshold; });
  std::multiset<Node_pair> result;
  for (std::uint32_t a = 0; a < cancellation.arcs().size(); ++a)
    if (cancellation.is_arc(a))
      result.emplace(cancellation.arcs()[a].lower, cancellation.arcs()[a].upper);
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
  Branch_cancellation cancellation(values, arcs);
  cancellation.run([](const SMRG::internal::Extremum_pair&) { return true; });
  const auto is_below = [](std::uint32_t) { return false; };
  const std::uint32_t arc = cancellation.arc_after(0, is_below);
  BOOST_TEST(cancellation.is_arc(arc));
  BOOST_TEST(cancellation.arc_after(1, is_below) == arc);
  BOOST_TEST(cancellation.arc_after(2, is_below) == arc);

  // the arc from 0 to 3 is cut at 2: below and above there its vertices are told apart
  const std::vector<Arc_ends> hanging = {{0, 3}, {1, 2}, {2, 3}, {2, 4}, {3, 5}};
  const std::vector<double> hanging_values = {0, 1, 2, 3, 8, 9};
  Branch_cancellation cut(hanging_values, hanging);
  cut.run([](const SMRG::internal::Extremum_pair& pair) { return pair.persistence < 2.5; });
  const std::uint32_t lower = cut.arc_after(0, [](std::uint32_t node) { return 1 < node; });
  const std::uint32_t upper = cut.arc_after(0, [](std::uint32_t node) { return 2 < node; });
  BOOST_TEST(cut.arcs()[lower].lower == 0u);
  BOOST_TEST(cut.arcs()[lower].upper == 2u);
  BOOST_TEST(cut.arcs()[upper].lower == 2u);
  BOOST_TEST(cut.arcs()[upper].upper == 5u);
}

// On random meshes, with distinct and with tied values, for growing thresholds on the same graph and at
// once: the extrema that are left are those that persistence, computed from the mesh alone, says; and at
// every level there are as many arcs less as pairs are cancelled whose two values lie around it.
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
      SMRG::compute_reeb_graph(c.mesh, c.values, graph, parameters);
      std::vector<double> levels;
      for (const auto node : CGAL::make_range(vertices(graph)))
        levels.push_back(graph[node].value);
      const std::vector<long> arcs_before = arcs_at_levels(graph, levels);
      const std::size_t loops = num_edges(graph) - num_vertices(graph);

      for (const double fraction : {0., 0.1, 0.3, 0.6, 2.}) {
        const double threshold = fraction * range;
        SMRG::simplify_reeb_graph(
            c.mesh,
            c.values,
            graph,
            parameters.persistence_threshold(threshold).threshold_is_absolute(true));
        check_consistency(c, graph);
        BOOST_TEST(num_edges(graph) - num_vertices(graph) == loops);

        std::vector<long> expected_arcs = arcs_before;
        for (const bool minima : {true, false}) {
          // equal values: any order of theirs gives the same pairs of different values, but which one of
          // several equal extrema survives depends on it
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
  SMRG::compute_reeb_graph(c.mesh, c.values, graph);
  const std::size_t minima = extrema(graph, true).size();
  BOOST_TEST(minima > 2u);
  Graph relative = graph, absolute = graph;
  SMRG::simplify_reeb_graph(
      c.mesh, c.values, relative, SMRG::parameters::persistence_threshold(0.16));
  // 0.16 of the range 4 is 0.64: the dip of depth 0.6 goes, the one of depth 1 stays, in both
  BOOST_TEST(extrema(relative, true).size() == minima - 2);
  SMRG::simplify_reeb_graph(
      c.mesh,
      c.values,
      absolute,
      SMRG::parameters::threshold_is_absolute(true).persistence_threshold(0.64));
  BOOST_TEST(extrema(absolute, true).size() == minima - 1);

  for (std::size_t v = 0; v < n; ++v)
    if (values[v] == 4)
      values[v] = std::numeric_limits<double>::infinity();
  c.set(values);
  SMRG::compute_reeb_graph(c.mesh, c.values, graph);
  // the highest finite node is the merge at 3 now, and 0.16 of the range 3 is 0.48
  SMRG::simplify_reeb_graph(c.mesh, c.values, graph, SMRG::parameters::persistence_threshold(0.16));
  BOOST_TEST(extrema(graph, true).size() == minima - 1);
}

BOOST_AUTO_TEST_CASE(bad_thresholds_are_errors_and_change_nothing)
{
  std::mt19937 rng(3);
  const Index_mesh mesh = sphere(2);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  SMRG::compute_reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));
  const std::size_t nodes = num_vertices(graph);
  for (const double threshold : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(
        SMRG::simplify_reeb_graph(
            c.mesh, c.values, graph, SMRG::parameters::persistence_threshold(threshold)),
        SMRG::Reeb_graph_error);
    BOOST_TEST(num_vertices(graph) == nodes);
  }
  // everything goes but one arc
  SMRG::simplify_reeb_graph(c.mesh,
                            c.values,
                            graph,
                            SMRG::parameters::vertex_arc_map(c.arcs).persistence_threshold(
                                std::numeric_limits<double>::infinity()));
  BOOST_TEST(num_edges(graph) == 1u);
  for (const Vertex v : c.mesh.vertices())
    BOOST_TEST(c.arcs[v] == 0u);
}
