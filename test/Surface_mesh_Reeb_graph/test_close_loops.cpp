// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE close_loops

#include "simplification_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

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

} // namespace

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
