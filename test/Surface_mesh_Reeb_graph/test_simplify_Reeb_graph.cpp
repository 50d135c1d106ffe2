// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE simplify_Reeb_graph

#include "persistence_checks.h"
#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_closing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_simplification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/cancel_branches.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

using namespace Reeb_graph_test;
using SMRG::internal::Arc_ends;
using SMRG::internal::Folded_graph;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

using Node_pair = std::pair<std::uint32_t, std::uint32_t>;

void cancel_branches(Folded_graph& folded,
                     const std::vector<double>& values,
                     const double threshold)
{
  SMRG::internal::cancel_branches(folded, values, [&](const SMRG::internal::Extremum_pair& pair) {
    return pair.persistence < threshold;
  });
}

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

// What is left of a graph; its nodes have the numbers that they had in `nodes`.
struct Left
{
  std::vector<std::size_t> nodes;
  std::vector<Rank_pair> arcs;

  std::vector<Extended_pair> pairs() const
  {
    return with_ranks(extended_persistence(ranked_complex_of_graph(nodes.size(), arcs)), nodes);
  }

  // The arcs between the numbers of before, sorted.
  std::vector<Rank_pair> arcs_before() const
  {
    std::vector<Rank_pair> result;
    for (const Rank_pair& arc : arcs)
      result.emplace_back(nodes[arc.first], nodes[arc.second]);
    std::sort(result.begin(), result.end());
    return result;
  }
};

Left left_of(const Folded_graph& folded)
{
  const SMRG::internal::Compacted_graph remaining(folded);
  Left result;
  result.nodes.assign(remaining.nodes.begin(), remaining.nodes.end());
  for (const Arc_ends& arc : remaining.arcs)
    result.arcs.emplace_back(arc.lower, arc.upper);
  return result;
}

std::vector<Arc_ends> arc_ends_of(const Graph& graph)
{
  std::vector<Arc_ends> result;
  for (const Rank_pair& arc : arcs_of(graph))
    result.push_back(
        {static_cast<std::uint32_t>(arc.first), static_cast<std::uint32_t>(arc.second)});
  return result;
}

double persistence_of(const Extended_pair& pair, const std::vector<double>& values)
{
  return std::abs(values[pair.death] - values[pair.birth]);
}

bool is_loop(const Extended_pair& pair)
{
  return pair.kind == EXTENDED && pair.dimension == 1;
}

std::size_t number_of_loops(const std::vector<Extended_pair>& pairs)
{
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), is_loop));
}

// Closes the loops of persistence below the threshold.
SMRG::internal::Loop_simplification
close_loops(Folded_graph& folded, const std::vector<double>& values, const double threshold)
{
  return SMRG::internal::Loop_simplification(folded, [&](const SMRG::internal::Loop_pair& loop) {
    return values[loop.merge] - values[loop.split] < threshold;
  });
}

// The arcs that points of a graph have gone to. A point is an arc and the node just below the
// point.
std::vector<std::uint32_t> images_of(Folded_graph& folded,
                                     const SMRG::internal::Loop_simplification& closed_loops,
                                     const std::vector<Rank_pair>& points)
{
  std::vector<SMRG::internal::Point_on_arc> images;
  for (const Rank_pair& point : points)
    images.emplace_back(static_cast<std::uint32_t>(point.first));
  SMRG::internal::follow(
      folded, closed_loops, images, [&](const std::uint32_t i, const std::uint32_t node) {
        return points[i].second < node;
      });
  std::vector<std::uint32_t> result;
  for (const SMRG::internal::Point_on_arc& image : images)
    result.push_back(image.arc);
  return result;
}

// All points of a graph, from the lowest to the highest of every arc.
std::vector<Rank_pair> points_of(const std::vector<Rank_pair>& arcs)
{
  std::vector<Rank_pair> points;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc)
    for (std::size_t node = arcs[arc].first; node < arcs[arc].second; ++node)
      points.emplace_back(arc, node);
  return points;
}

// The arcs that are left when loops are closed.
std::vector<Rank_pair> closed(const std::vector<double>& values,
                              const std::vector<Rank_pair>& arcs,
                              const double threshold)
{
  Folded_graph folded(values.size(), arc_ends_of(make_graph(values, arcs)));
  close_loops(folded, values, threshold);
  return left_of(folded).arcs_before();
}

// Arcs on the path between two nodes of a graph whose nodes above `highest` and their arcs are left
// out; none if there is no path.
std::vector<std::size_t> path_between(const std::vector<Rank_pair>& arcs,
                                      const std::size_t node,
                                      const std::size_t other,
                                      const std::size_t highest)
{
  std::map<std::size_t, std::size_t> arc_to = {
      {node, arcs.size()}}; // by which arc a node was reached
  std::vector<std::size_t> reached = {node};
  const auto other_end = [&](const std::size_t arc, const std::size_t end) {
    return arcs[arc].first == end ? arcs[arc].second : arcs[arc].first;
  };
  for (std::size_t i = 0; i < reached.size() && arc_to.count(other) == 0; ++i)
    for (std::size_t arc = 0; arc < arcs.size(); ++arc)
      if ((arcs[arc].first == reached[i] || arcs[arc].second == reached[i]) &&
          arcs[arc].second <= highest && arc_to.emplace(other_end(arc, reached[i]), arc).second)
        reached.push_back(other_end(arc, reached[i]));
  std::vector<std::size_t> path;
  if (arc_to.count(other) == 0)
    return path;
  for (std::size_t end = other; end != node; end = other_end(path.back(), end))
    path.push_back(arc_to[end]);
  return path;
}

// Closes loops as the documentation says, node by node, with no other thought. Of the arcs that
// have the same lower node the first ones come first.
std::vector<Rank_pair> closed_node_by_node(const std::vector<double>& values,
                                           std::vector<Rank_pair> arcs_to_come,
                                           const double threshold)
{
  const auto is_higher = [](const Rank_pair& a, const Rank_pair& b) { return a.first > b.first; };
  std::stable_sort(arcs_to_come.begin(), arcs_to_come.end(), is_higher);
  std::vector<Rank_pair> arcs;
  for (const Rank_pair& new_arc : arcs_to_come) {
    std::size_t highest = new_arc.first;
    while (highest + 1 < values.size() && values[highest + 1] - values[new_arc.first] < threshold)
      ++highest;
    std::vector<std::size_t> cycle;
    if (new_arc.second <= highest)
      cycle = path_between(arcs, new_arc.first, new_arc.second, highest);
    arcs.push_back(new_arc);
    if (cycle.empty())
      continue;
    cycle.push_back(arcs.size() - 1);
    for (;;) { // the two arcs at the highest node of the cycle are zipped together
      std::sort(cycle.begin(), cycle.end(), [&](const std::size_t i, const std::size_t j) {
        return std::make_pair(arcs[i].second, arcs[i].first) >
               std::make_pair(arcs[j].second, arcs[j].first);
      });
      const Rank_pair shorter = arcs[cycle[0]];
      Rank_pair& longer = arcs[cycle[1]];
      BOOST_TEST_REQUIRE(shorter.second == longer.second);
      if (shorter.first == longer.first)
        break;
      longer.second = shorter.first;
      cycle.erase(cycle.begin());
    }
    arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(cycle[1]));
  }

  Folded_graph folded(values.size(), arc_ends_of(make_graph(values, arcs)));
  for (std::uint32_t node = 0; node < values.size(); ++node)
    folded.pass_through_if_regular(node);
  return left_of(folded).arcs_before();
}

// Calls `check(graph, values, threshold)` for random graphs and thresholds.
template <class Check>
void for_random_graphs(const unsigned number, const Check& check)
{
  for (unsigned seed = 0; seed < number; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      const std::vector<double> values = values_of(graph);
      check(graph, values, random_unit(rng) * (values.back() + 1));
    }
  }
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

BOOST_AUTO_TEST_CASE(small_loops_are_closed)
{
  using Arcs = std::vector<Rank_pair>;
  // a torus
  const Arcs torus = {{0, 1}, {1, 2}, {1, 2}, {2, 3}};
  BOOST_TEST((closed({0, 1, 2, 3}, torus, 1) == torus));
  BOOST_TEST((closed({0, 1, 2, 3}, torus, 1.5) == Arcs{{0, 3}}));
  // a branch down on one side and one up on the other stay, at their heights
  const Arcs branches = {{0, 1}, {1, 3}, {1, 4}, {3, 5}, {4, 5}, {2, 4}, {3, 6}, {5, 7}};
  BOOST_TEST((closed({0, 1, 2, 3, 4, 5, 6, 7}, branches, 4.5) ==
              Arcs{{0, 3}, {2, 4}, {3, 4}, {3, 6}, {4, 7}}));
  // three arcs side by side are two loops
  BOOST_TEST((closed({0, 1}, {{0, 1}, {0, 1}, {0, 1}}, 2) == Arcs{{0, 1}}));
  // of two loops, one inside the other, the inner one
  const Arcs nested = {{0, 1}, {1, 2}, {2, 3}, {2, 3}, {3, 4}, {1, 4}, {4, 5}};
  BOOST_TEST((closed({0, 1, 2, 3, 4, 5}, nested, 2) == Arcs{{0, 1}, {1, 4}, {1, 4}, {4, 5}}));
}

// Relative thresholds are fractions of the range of the component, without what is infinite; loops
// of infinite persistence are never small.
BOOST_AUTO_TEST_CASE(loop_thresholds_are_those_of_the_component)
{
  const Mesh no_mesh;
  const Value_map no_values;
  const auto number_of_arcs_left = [&](const std::vector<double>& values,
                                       const std::vector<Rank_pair>& arcs,
                                       const double threshold) {
    Graph graph = make_graph(values, arcs);
    SMRG::simplify_Reeb_graph(
        no_mesh, no_values, graph, SMRG::parameters::loop_persistence_threshold(threshold));
    return num_edges(graph);
  };
  // two tori, the loop of one a third of its range, that of the other four fifths
  const std::vector<Rank_pair> tori = {
      {0, 1}, {1, 2}, {1, 2}, {2, 3}, {4, 5}, {5, 6}, {5, 6}, {6, 7}};
  const std::vector<double> values = {0, 1, 2, 3, 100, 110, 190, 200};
  BOOST_TEST(number_of_arcs_left(values, tori, 0.3) == 8u);
  BOOST_TEST(number_of_arcs_left(values, tori, 0.5) == 5u);
  BOOST_TEST(number_of_arcs_left(values, tori, 0.9) == 2u);
  // the range of the finite values is that of the loop
  const std::vector<Rank_pair> torus = {{0, 1}, {1, 2}, {1, 2}, {2, 3}};
  BOOST_TEST(number_of_arcs_left({-infinity, 0, 1, infinity}, torus, 0.9) == 4u);
  BOOST_TEST(number_of_arcs_left({-infinity, 0, 1, infinity}, torus, 1.1) == 1u);
  BOOST_TEST(number_of_arcs_left({0, 1, infinity, infinity}, torus, infinity) == 4u);
}

// Loops on their own, with the extrema that there are: if the cycles have monotone sides, exactly
// the small loops go and nothing else changes. If not, no small loop is left either, and the
// branches of extrema get shorter, by less than the threshold for every closed loop.
BOOST_AUTO_TEST_CASE(closing_loops_changes_as_little_as_promised)
{
  std::size_t number_of_exact_cases = 0, number_of_other_cases = 0;
  const auto check =
      [&](const Graph& graph, const std::vector<double>& values, const double threshold) {
        const std::vector<Extended_pair> before = oracle_pairs(graph);

        Folded_graph folded(values.size(), arc_ends_of(graph));
        const bool have_other_pairs_changed =
            close_loops(folded, values, threshold).have_other_pairs_changed();
        const Left left = left_of(folded);
        const std::vector<Extended_pair> after = left.pairs();
        for (const Extended_pair& pair : after)
          if (is_loop(pair))
            BOOST_TEST(persistence_of(pair, values) >= threshold);

        const auto is_small_loop = [&](const Extended_pair& pair) {
          return is_loop(pair) && persistence_of(pair, values) < threshold;
        };
        if (!have_other_pairs_changed) {
          std::vector<Extended_pair> expected = before;
          expected.erase(std::remove_if(expected.begin(), expected.end(), is_small_loop),
                         expected.end());
          BOOST_TEST(after == expected, boost::test_tools::per_element());
          number_of_exact_cases += expected.size() < before.size() ? 1 : 0;
          return;
        }
        ++number_of_other_cases;
        const std::size_t number_of_closed_loops = number_of_loops(before) - number_of_loops(after);
        BOOST_TEST(number_of_closed_loops > 0u);
        const auto with_same_birth = [](const std::vector<Extended_pair>& pairs,
                                        const Extended_pair& pair) {
          return std::find_if(pairs.begin(), pairs.end(), [&pair](const Extended_pair& other) {
            return other.kind == pair.kind && other.dimension == pair.dimension &&
                   other.birth == pair.birth;
          });
        };
        for (const Extended_pair& pair : before) {
          if (is_loop(pair))
            continue;
          const auto found = with_same_birth(after, pair);
          const double persistence = found == after.end() ? 0 : persistence_of(*found, values);
          BOOST_TEST(persistence <= persistence_of(pair, values));
          BOOST_TEST(persistence >= persistence_of(pair, values) -
                                        static_cast<double>(number_of_closed_loops) * threshold);
          if (pair.kind == EXTENDED) // a component
            BOOST_TEST(persistence == persistence_of(pair, values));
        }
        for (const Extended_pair& pair : after)
          BOOST_TEST((is_loop(pair) || with_same_birth(before, pair) != before.end()));
      };
  for_random_graphs(5 * number_of_random_cases(), check);
  if (number_of_random_cases() >= 100) {
    BOOST_TEST(number_of_exact_cases > 0u);
    BOOST_TEST(number_of_other_cases > 0u);
  }
}

// Branches and loops together through the user's function, for growing thresholds: what persistence
// says is small goes, and the numbers of nodes, arcs, components and loops fit at every step.
BOOST_AUTO_TEST_CASE(branches_and_loops_of_random_graphs_are_simplified)
{
  const Mesh no_mesh;
  const Value_map no_values;
  for (unsigned seed = 0; seed < 2 * number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Graph graph = random_graph(rng, seed % 2 == 1);
      const double range = values_of(graph).back() + 1;
      for (const double fraction : {0., 0.1, 0.3, 0.6, 2.}) {
        const double loop_threshold = fraction * range;
        const double threshold = random_unit(rng) * loop_threshold;
        const std::vector<Extended_pair> before = oracle_pairs(graph);
        const std::vector<double> values_before = values_of(graph);
        SMRG::simplify_Reeb_graph(no_mesh,
                                  no_values,
                                  graph,
                                  SMRG::parameters::threshold_is_absolute(true)
                                      .persistence_threshold(threshold)
                                      .loop_persistence_threshold(loop_threshold));
        const std::vector<Extended_pair> after = oracle_pairs(graph);
        const std::vector<double> values = values_of(graph);
        std::size_t components = 0;
        for (const Extended_pair& pair : after) {
          if (is_loop(pair))
            BOOST_TEST(persistence_of(pair, values) >= loop_threshold);
          else if (pair.kind == EXTENDED)
            ++components;
          else
            BOOST_TEST(persistence_of(pair, values) >= threshold);
        }
        BOOST_TEST(num_edges(graph) + components == num_vertices(graph) + number_of_loops(after));
        std::vector<std::size_t> down(num_vertices(graph), 0), up(num_vertices(graph), 0);
        for (const auto arc : CGAL::make_range(edges(graph))) {
          BOOST_TEST(source(arc, graph) < target(arc, graph));
          ++up[source(arc, graph)];
          ++down[target(arc, graph)];
        }
        for (const auto node : CGAL::make_range(vertices(graph))) {
          BOOST_TEST(graph[node].type == SMRG::type_of_Reeb_node(down[node], up[node]));
          BOOST_TEST(!(down[node] == 1 && up[node] == 1));
        }
        if (fraction == 0) { // the loops stay, even those in plateaus
          std::vector<double> persistence_before, persistence;
          for (const Extended_pair& pair : before)
            if (is_loop(pair))
              persistence_before.push_back(persistence_of(pair, values_before));
          for (const Extended_pair& pair : after)
            if (is_loop(pair))
              persistence.push_back(persistence_of(pair, values));
          std::sort(persistence_before.begin(), persistence_before.end());
          std::sort(persistence.begin(), persistence.end());
          BOOST_TEST(persistence == persistence_before, boost::test_tools::per_element());
        }
      }
      for (const Extended_pair& pair : oracle_pairs(graph))
        BOOST_TEST(!is_loop(pair));
    }
  }
}

// Points of the arcs, at all heights between the nodes, go to arcs that are left; if no branch was
// cancelled as a whole the height is right.
BOOST_AUTO_TEST_CASE(points_of_arcs_keep_their_heights)
{
  for (unsigned seed = 0; seed < 2 * number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Graph graph = random_graph(rng, seed % 2 == 1);
      const std::vector<double> values = values_of(graph);
      Folded_graph folded(values.size(), arc_ends_of(graph));
      const bool has_only_loops = seed % 3 == 0;
      const double threshold = random_unit(rng) * (values.back() + 1);
      if (!has_only_loops)
        cancel_branches(folded, values, threshold);
      const SMRG::internal::Loop_simplification closed_loops =
          close_loops(folded, values, seed % 3 == 1 ? 0 : random_unit(rng) * (values.back() + 1));

      std::vector<Rank_pair> points = points_of(arcs_of(graph));
      shuffle(points, rng);
      const std::vector<std::uint32_t> images = images_of(folded, closed_loops, points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        BOOST_TEST(folded.is_arc(images[i]));
        if (has_only_loops) {
          BOOST_TEST(folded.arcs()[images[i]].lower <= points[i].second);
          BOOST_TEST(folded.arcs()[images[i]].upper > points[i].second);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(loops_are_closed_as_node_by_node)
{
  std::size_t number_of_cases_with_loops = 0;
  const auto check =
      [&](const Graph& graph, const std::vector<double>& values, const double threshold) {
        const std::vector<Rank_pair> arcs = arcs_of(graph);
        const std::vector<Rank_pair> result = closed(values, arcs, threshold);
        BOOST_TEST((result == closed_node_by_node(values, arcs, threshold)));
        number_of_cases_with_loops += result.size() < arcs.size() ? 1 : 0;
      };
  for_random_graphs(5 * number_of_random_cases(), check);
  BOOST_TEST(number_of_cases_with_loops >= number_of_random_cases());
}

// The fold is a continuous map to the graph that is left, and onto it: what meets at a node meets
// afterwards, at the same height, at a node or within an arc; and points of an arc that are next to
// each other stay so.
BOOST_AUTO_TEST_CASE(the_fold_of_loops_is_a_quotient)
{
  const auto check = [&](const Graph& graph,
                         const std::vector<double>& values,
                         const double threshold) {
    Folded_graph folded(values.size(), arc_ends_of(graph));
    const SMRG::internal::Loop_simplification closed_loops = close_loops(folded, values, threshold);
    const std::vector<Rank_pair> arcs = arcs_of(graph), points = points_of(arcs);
    const std::vector<std::uint32_t> images = images_of(folded, closed_loops, points);

    // by node: the images of the ends of the arcs there
    std::vector<std::set<std::uint32_t>> images_at_node(values.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Rank_pair& arc = arcs[points[i].first];
      const std::size_t node = points[i].second;
      if (node == arc.first)
        images_at_node[node].insert(images[i]);
      else if (images[i] != images[i - 1]) {
        BOOST_TEST(folded.arcs()[images[i - 1]].upper == node);
        BOOST_TEST(folded.arcs()[images[i]].lower == node);
      }
      if (node + 1 == arc.second)
        images_at_node[node + 1].insert(images[i]);
    }
    for (std::uint32_t node = 0; node < values.size(); ++node) {
      const auto has_end_here = [&](const std::uint32_t image) {
        return folded.arcs()[image].lower == node || folded.arcs()[image].upper == node;
      };
      const std::set<std::uint32_t>& here = images_at_node[node];
      BOOST_TEST((here.size() <= 1 || std::all_of(here.begin(), here.end(), has_end_here)));
    }
    const std::set<std::uint32_t> all_images(images.begin(), images.end());
    BOOST_TEST(all_images.size() == left_of(folded).arcs.size());
  };
  for_random_graphs(2 * number_of_random_cases(), check);
}

// On meshes: the maps to the arcs follow, and the branches and loops that are left have the heights
// that they had.
BOOST_AUTO_TEST_CASE(maps_follow_when_loops_are_closed)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      Case c(mesh, seed % 3 == 2 ? random_integer_values(n, 12, rng) : random_values(n, rng));
      Graph graph;
      const auto parameters = SMRG::parameters::vertex_arc_map(c.arcs).collect_arc_vertices(true);
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph, parameters);

      // a face goes with its middle vertex, if that is no node; the others have no arc here
      auto face_arcs =
          c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc", SMRG::null_arc).first;
      std::vector<bool> is_node(n, false);
      for (const auto node : CGAL::make_range(vertices(graph)))
        is_node[graph[node].vertex] = true;
      const SMRG::
          Vertex_order<Mesh, Value_map, boost::property_map<Mesh, boost::vertex_index_t>::type>
              order(c.mesh, c.values, get(boost::vertex_index, c.mesh));
      const auto middle_vertex = [&](const Mesh::Face_index f) {
        std::vector<Vertex> corners;
        for (const Vertex v : CGAL::vertices_around_face(c.mesh.halfedge(f), c.mesh))
          corners.push_back(v);
        std::sort(corners.begin(), corners.end(), order);
        return corners[1];
      };
      for (const auto f : c.mesh.faces())
        if (!is_node[middle_vertex(f)])
          face_arcs[f] = c.arcs[middle_vertex(f)];

      for (const double fraction : {0.1, 0.4, 2.}) {
        SMRG::simplify_Reeb_graph(c.mesh,
                                  c.values,
                                  graph,
                                  parameters.face_arc_map(face_arcs)
                                      .persistence_threshold(fraction / 2)
                                      .loop_persistence_threshold(fraction));
        check_consistency(c, graph);
        for (const auto f : c.mesh.faces()) {
          const Vertex v = middle_vertex(f);
          BOOST_TEST(face_arcs[f] == (is_node[v] ? SMRG::null_arc : c.arcs[v]));
        }
      }
      for (const Extended_pair& pair : oracle_pairs(graph))
        BOOST_TEST(!is_loop(pair));
    }
  }
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
        if (pair.kind == SMRG::COMPONENT_PAIR)
          expected_fewest += pair.birth == pair.death ? 1 : 2;
        else if (pair.kind != SMRG::LOOP_PAIR)
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
          return pair.kind == SMRG::MINIMUM_PAIR || pair.kind == SMRG::MAXIMUM_PAIR;
        };
        return is_branch(p) != is_branch(q) ? is_branch(p) : p.persistence() < q.persistence();
      };
      const Pair least = *std::min_element(pairs.begin(), pairs.end(), is_less);
      // a branch that is an arc at a simple saddle
      const auto saddle_type = graph[least.death].type;
      if (saddle_type != SMRG::SPLIT_SADDLE && saddle_type != SMRG::MERGE_SADDLE)
        continue;
      if (!edge(least.lower(), least.upper(), graph).second || out_degree(least.birth, graph) != 1)
        continue;
      ++number_of_cases;

      const bool is_maximum = least.kind == SMRG::MAXIMUM_PAIR;
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

// Nodes with very many arcs, very many branches along an arc, branches on branches: with work in
// proportion to the square of the size these would take hours.
BOOST_AUTO_TEST_CASE(large_graphs_take_no_quadratic_time)
{
  const Mesh no_mesh;
  const Value_map no_values;
  const std::size_t n = 100000;
  const auto simplified = [&](const std::size_t number_of_nodes,
                              const std::vector<Rank_pair>& arcs) {
    std::vector<double> values(number_of_nodes);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>(i);
    Graph graph = make_graph(values, arcs);
    SMRG::simplify_Reeb_graph(no_mesh,
                              no_values,
                              graph,
                              SMRG::parameters::threshold_is_absolute(true)
                                  .persistence_threshold(infinity)
                                  .loop_persistence_threshold(infinity));
    return arcs_of(graph);
  };
  const std::vector<Rank_pair> one_arc = {{0, 1}};

  std::vector<Rank_pair> arcs; // a node with n arcs to minima and n arcs to maxima
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(i, n);
    arcs.emplace_back(n, n + 1 + i);
  }
  BOOST_TEST((simplified(2 * n + 1, arcs) == one_arc));

  arcs.clear(); // two nodes and n arcs between them
  for (std::size_t i = 0; i < n; ++i)
    arcs.emplace_back(0, 1);
  BOOST_TEST((simplified(2, arcs) == one_arc));

  arcs.clear(); // a node where n minima merge, on the arc of each of which a maximum hangs
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(i, n + i);
    arcs.emplace_back(n + i, 2 * n);
    arcs.emplace_back(n + i, 2 * n + 2 + i);
  }
  arcs.emplace_back(2 * n, 2 * n + 1);
  BOOST_TEST((simplified(3 * n + 2, arcs) == one_arc));

  // the same, but that the maxima stay: one after the other, upwards, they are hung on the last
  // branch
  arcs.clear();
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(i, 2 * n - 1 - i);
    arcs.emplace_back(n + i, 2 * n);
    arcs.emplace_back(n + i, 2 * n + 1 + i);
  }
  for (std::size_t i = 0; i < 3 * n + 1; ++i)
    values.push_back(static_cast<double>(i <= 2 * n ? i : 10 * n + i));
  Graph graph = make_graph(values, arcs);
  SMRG::simplify_Reeb_graph(no_mesh,
                            no_values,
                            graph,
                            SMRG::parameters::threshold_is_absolute(true).persistence_threshold(
                                3 * static_cast<double>(n)));
  BOOST_TEST(num_edges(graph) == 2 * n - 1);

  // maxima that stay hang on the highest minimum, and would move on whenever the next minimum is
  // cancelled
  arcs.clear();
  values.clear();
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(n - 1 + i, n + i);
    arcs.emplace_back(n + i, 3 * n - 1 + i);
  }
  for (std::size_t i = 1; i < n; ++i) {
    arcs.emplace_back(n - 1 - i, 2 * n - 1 + i);
    arcs.emplace_back(2 * n - 1 + i, i + 1 < n ? 2 * n + i : 4 * n - 1);
  }
  arcs.emplace_back(2 * n - 1, 2 * n);
  for (std::size_t i = 0; i < 4 * n; ++i)
    values.push_back(static_cast<double>(i < 3 * n - 1 ? i : 10 * n + i));
  graph = make_graph(values, arcs);
  SMRG::simplify_Reeb_graph(no_mesh,
                            no_values,
                            graph,
                            SMRG::parameters::threshold_is_absolute(true).persistence_threshold(
                                4 * static_cast<double>(n)));
  BOOST_TEST(num_edges(graph) == 2 * n + 1);

  arcs.clear(); // a comb
  arcs.emplace_back(0, n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(1 + i, n + 1 + i);
    arcs.emplace_back(n + 1 + i, n + 2 + i);
  }
  BOOST_TEST((simplified(2 * n + 2, arcs) == one_arc));

  arcs.clear(); // branches on branches: the minimum i merges into the branch of the minimum i - 1
  arcs.emplace_back(0, 2 * n - 2);
  for (std::size_t i = 1; i < n; ++i) {
    arcs.emplace_back(i, i + 1 < n ? 2 * n - 2 - i : 2 * n - 1 - i);
    if (i + 1 < n)
      arcs.emplace_back(2 * n - 2 - i, 2 * n - 1 - i);
  }
  arcs.emplace_back(2 * n - 2, 2 * n - 1);
  BOOST_TEST((simplified(2 * n, arcs) == one_arc));

  arcs.clear(); // a ladder
  for (std::size_t i = 0; i + 2 < n; ++i) {
    arcs.emplace_back(i, i + 2);
    if (i % 2 == 0)
      arcs.emplace_back(i, i + 1);
  }
  BOOST_TEST((simplified(n, arcs) == one_arc));

  arcs.clear(); // a chain of loops
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = 0; k < 1 + i % 2; ++k)
      arcs.emplace_back(i, i + 1);
  BOOST_TEST((simplified(n, arcs) == one_arc));
}

// Long cycles side by side, with something that stays on all of their nodes: if every node of every
// cycle was passed, or every arc was cut into pieces one after the other, these would take hours,
// too. The points of all arcs are asked for at some heights, those of the longest arc at all.
BOOST_AUTO_TEST_CASE(long_cycles_are_closed_in_no_quadratic_time)
{
  const std::size_t n = 100000;
  // all graphs are connected, and trees are left; returns how many nodes
  const auto number_of_nodes_left = [](const std::size_t number_of_nodes,
                                       const std::vector<Rank_pair>& arcs) {
    std::vector<double> values(number_of_nodes);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>(i);
    Folded_graph folded(number_of_nodes, arc_ends_of(make_graph(values, arcs)));
    const SMRG::internal::Loop_simplification closed_loops = close_loops(folded, values, infinity);
    const Left left = left_of(folded);
    BOOST_TEST(left.arcs.size() + 1 == left.nodes.size());

    std::mt19937 rng(1);
    std::vector<Rank_pair> points;
    for (std::size_t arc = 0; arc < arcs.size(); ++arc)
      for (std::size_t i = 0; i < 3; ++i)
        points.emplace_back(
            arc, arcs[arc].first + random_index(arcs[arc].second - arcs[arc].first, rng));
    const auto is_shorter = [](const Rank_pair& a, const Rank_pair& b) {
      return a.second - a.first < b.second - b.first;
    };
    const auto longest = std::max_element(arcs.begin(), arcs.end(), is_shorter);
    for (std::size_t node = longest->first; node < longest->second; ++node)
      points.emplace_back(static_cast<std::size_t>(longest - arcs.begin()), node);
    const std::vector<std::uint32_t> images = images_of(folded, closed_loops, points);
    std::size_t number_of_wrong_heights = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Arc_ends& ends = folded.arcs()[images[i]];
      const std::size_t node = points[i].second;
      number_of_wrong_heights +=
          folded.is_arc(images[i]) && ends.lower <= node && node < ends.upper ? 0 : 1;
    }
    BOOST_TEST(number_of_wrong_heights == 0u);
    return left.nodes.size();
  };
  // arcs to minima below the nodes 0, 1, ..., or to maxima above them, and some arcs from a node to
  // another
  const auto hang_on = [](std::vector<Rank_pair>& arcs,
                          const std::size_t first_node,
                          const std::size_t number,
                          const std::size_t first_extremum) {
    for (std::size_t i = 0; i < number; ++i)
      arcs.emplace_back((std::minmax)(first_node + i, first_extremum + i));
  };
  const auto put_side_by_side = [](std::vector<Rank_pair>& arcs,
                                   const std::size_t number,
                                   const std::size_t lower,
                                   const std::size_t upper) {
    arcs.insert(arcs.end(), number, {lower, upper});
  };

  std::vector<Rank_pair> arcs; // a path upwards
  for (std::size_t i = 0; i <= n; ++i)
    arcs.emplace_back(i, i + 1);
  hang_on(arcs, 1, n, n + 2);
  put_side_by_side(arcs, n, 0, n + 1);
  BOOST_TEST(number_of_nodes_left(2 * n + 2, arcs) == 2 * n + 2);

  arcs = {{0, 1}, {0, 2}}; // two paths upwards, one with the odd nodes and one with the even ones
  for (std::size_t i = 1; i <= n; ++i)
    arcs.emplace_back(i, (std::min)(i + 2, n + 1));
  hang_on(arcs, 1, n, n + 2);
  put_side_by_side(arcs, n, 0, n + 1);
  BOOST_TEST(number_of_nodes_left(2 * n + 2, arcs) == 2 * n + 2);

  // a path from n up to 2 n + 1, down to n + 1, and so on, at last to 3 n + 1, with minima below
  // its valleys and maxima above its peaks; what is left are these, both ends, and the valleys,
  // from which the peaks rise now
  arcs = {{n, 2 * n + 1}, {3 * n + 1, 3 * n + 2}};
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(n + 1 + i, 2 * n + 1 + i);
    arcs.emplace_back(n + 1 + i, 2 * n + 2 + i);
  }
  hang_on(arcs, n + 1, n, 0);
  hang_on(arcs, 2 * n + 1, n, 3 * n + 3);
  put_side_by_side(arcs, n, n, 3 * n + 1);
  BOOST_TEST(number_of_nodes_left(4 * n + 3, arcs) == 3 * n + 2);

  arcs.clear(); // arcs of very different lengths between random nodes
  std::mt19937 rng(1);
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const double length = std::exp(random_unit(rng) * std::log(static_cast<double>(n)));
      arcs.emplace_back(i, (std::min)(n - 1, i + 1 + static_cast<std::size_t>(length)));
    }
  BOOST_TEST(number_of_nodes_left(n, arcs) <= n);
}

// Not even where merging takes most changes of side, or where cycles have peaks, do loops take more
// than O(m log m) steps: from a size to the 16-fold one, a second logarithm would let the steps per
// m log m grow by a factor of 1.3 or 1.4. Steps are counted, not timed.
BOOST_AUTO_TEST_CASE(loops_are_closed_in_m_log_m_steps)
{
  // bundles of paths whose nodes take turns, joined in pairs, the pairs in pairs, and so on
  const auto nested_paths = [](const std::size_t n) {
    const std::size_t length = 8, number = n / length;
    std::vector<Rank_pair> arcs;
    for (std::size_t i = 0; i < n; ++i)
      arcs.emplace_back(number + i, (std::min)(2 * number + i, number + n));
    for (std::size_t i = 1; i < number; ++i)
      for (std::size_t k = 2 * i; k < 2 * i + 2; ++k) {
        std::size_t path = 0; // of number k, its digits in reverse order
        for (std::size_t bit = 1; bit < number; bit *= 2)
          path = 2 * path + (k / bit) % 2;
        arcs.emplace_back(i, k < number ? k : number + path);
      }
    return arcs;
  };
  // arcs of very different lengths, `up` upwards from every node
  const auto random_arcs = [](const std::size_t n, const std::size_t up, std::mt19937& rng) {
    std::vector<Rank_pair> arcs;
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t k = 0; k < up; ++k) {
        const double length = std::exp(random_unit(rng) * std::log(static_cast<double>(n)));
        arcs.emplace_back(i, (std::min)(n - 1, i + 1 + static_cast<std::size_t>(length)));
      }
    return arcs;
  };
  // the same between any nodes, with as many arcs down and up on average
  const auto peaks_and_valleys = [](const std::size_t n, std::mt19937& rng) {
    std::vector<Rank_pair> arcs;
    for (std::size_t i = 0; i < 3 * n / 2; ++i) {
      const double length = std::exp(random_unit(rng) * std::log(static_cast<double>(n)));
      const std::size_t lower = random_index(n - 1, rng);
      arcs.emplace_back(lower, (std::min)(n - 1, lower + 1 + static_cast<std::size_t>(length)));
    }
    return arcs;
  };
  // loops go that are lower than a part of the height of the graph, or all
  const auto steps_per_m_log_m = [](const std::vector<Rank_pair>& arcs, const std::size_t parts) {
    std::vector<Arc_ends> ends;
    std::size_t number_of_nodes = 0;
    for (const Rank_pair& arc : arcs) {
      ends.push_back(
          {static_cast<std::uint32_t>(arc.first), static_cast<std::uint32_t>(arc.second)});
      number_of_nodes = (std::max)(number_of_nodes, arc.second + 1);
    }
    SMRG::internal::Loop_closing closing(number_of_nodes, ends);
    closing.run([&](const SMRG::internal::Loop_pair& pair) {
      return (pair.merge - pair.split) * parts <= number_of_nodes;
    });
    const double m = static_cast<double>(number_of_nodes + ends.size());
    return static_cast<double>(closing.number_of_steps()) / (m * std::log2(m));
  };
  const auto check = [&](const char* name, const auto& make, const std::size_t parts) {
    const std::size_t n = 1 << 13;
    std::mt19937 rng(1);
    const double small = steps_per_m_log_m(make(n, rng), parts),
                 large = steps_per_m_log_m(make(16 * n, rng), parts);
    BOOST_TEST_MESSAGE(name << ", loops up to 1/" << parts << " of the height: " << small << ", "
                            << large << " steps per m log m");
    BOOST_TEST(large < 1.15 * small, name);
  };
  check(
      "nested paths", [&](std::size_t n, std::mt19937&) { return nested_paths(n); }, 1);
  for (const std::size_t parts : {1, 4, 16}) {
    for (const std::size_t up : {2, 4})
      check(
          "random arcs upwards",
          [&](std::size_t n, std::mt19937& rng) { return random_arcs(n, up, rng); },
          parts);
    check("peaks and valleys", peaks_and_valleys, parts);
  }
}

BOOST_AUTO_TEST_CASE(bad_thresholds_are_errors_and_change_nothing)
{
  std::mt19937 rng(3);
  const Index_mesh mesh = sphere(2);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));
  const std::size_t nodes = num_vertices(graph);
  for (const double threshold : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(
        SMRG::simplify_Reeb_graph(
            c.mesh, c.values, graph, SMRG::parameters::persistence_threshold(threshold)),
        SMRG::Error);
    BOOST_TEST(num_vertices(graph) == nodes);
  }
  for (const double threshold : {-1., std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(
        SMRG::simplify_Reeb_graph(
            c.mesh, c.values, graph, SMRG::parameters::loop_persistence_threshold(threshold)),
        SMRG::Error);
  BOOST_CHECK_THROW(
      SMRG::simplify_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::number_of_leaves(-1)),
      SMRG::Error);
  // a map of faces that belongs to another graph; the map of the vertices is left as it was, too
  auto face_arcs = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc", 1000000).first;
  const std::vector<std::size_t> arcs_before(c.arcs.begin(), c.arcs.end());
  BOOST_CHECK_THROW(
      SMRG::simplify_Reeb_graph(
          c.mesh,
          c.values,
          graph,
          SMRG::parameters::vertex_arc_map(c.arcs).face_arc_map(face_arcs).persistence_threshold(
              infinity)),
      SMRG::Error);
  BOOST_TEST(std::vector<std::size_t>(c.arcs.begin(), c.arcs.end()) == arcs_before,
             boost::test_tools::per_element());
  BOOST_TEST(num_vertices(graph) == nodes);
  // another function
  auto other_values = c.mesh.add_property_map<Vertex, double>("v:other").first;
  for (const Vertex v : c.mesh.vertices())
    other_values[v] = 1 - c.values[v];
  BOOST_CHECK_THROW(SMRG::simplify_Reeb_graph(
                        c.mesh, other_values, graph, SMRG::parameters::vertex_arc_map(c.arcs)),
                    SMRG::Error);
  BOOST_TEST(std::vector<std::size_t>(c.arcs.begin(), c.arcs.end()) == arcs_before,
             boost::test_tools::per_element());
  // everything goes but one arc
  SMRG::simplify_Reeb_graph(c.mesh,
                            c.values,
                            graph,
                            SMRG::parameters::vertex_arc_map(c.arcs).persistence_threshold(
                                std::numeric_limits<double>::infinity()));
  BOOST_TEST(num_edges(graph) == 1u);
  for (const Vertex v : c.mesh.vertices())
    BOOST_TEST(c.arcs[v] == 0u);
}
