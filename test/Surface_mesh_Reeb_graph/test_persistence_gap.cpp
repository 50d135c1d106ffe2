// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE persistence_gap

#include "check_Reeb_graph.h"
#include "simplification_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_gap.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// The persistences of the pairs of minima and maxima, as the boundary matrix gives them, absolute.
std::vector<double> persistences_of(const Graph& graph)
{
  const std::vector<double> values = values_of(graph);
  std::vector<double> result;
  for (const Extended_pair& pair : oracle_pairs(graph))
    if (pair.kind != EXTENDED)
      result.push_back(persistence_of(pair, values));
  std::sort(result.rbegin(), result.rend());
  return result;
}

std::size_t number_above(const std::vector<double>& persistences, const double threshold)
{
  return static_cast<std::size_t>(std::count_if(
      persistences.begin(), persistences.end(), [&](const double p) { return p > threshold; }));
}

// A path with minima and maxima in turns.
Graph zigzag(const std::vector<double>& heights)
{
  std::vector<std::size_t> order(heights.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return heights[a] < heights[b];
  });
  std::vector<std::size_t> rank(order.size());
  std::vector<double> values;
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
    values.push_back(heights[order[i]]);
  }
  std::vector<Rank_pair> arcs;
  for (std::size_t i = 1; i < rank.size(); ++i)
    arcs.push_back(std::minmax(rank[i - 1], rank[i]));
  return make_graph(values, arcs);
}

// A trunk from 0 to `height` with branches of some lengths that end in maxima, all of which begin
// at different heights.
Graph comb(const double height, const std::vector<double>& lengths)
{
  struct Node
  {
    double value;
    std::size_t number;
  };
  std::vector<Node> nodes = {{0, 0}, {height, 1}};
  std::vector<Rank_pair> arcs;
  std::size_t last = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double foot = double(i + 1) / 1024;
    const std::size_t saddle = nodes.size();
    nodes.push_back({foot, saddle});
    nodes.push_back({foot + lengths[i], saddle + 1});
    arcs.emplace_back(last, saddle);
    arcs.emplace_back(saddle, saddle + 1);
    last = saddle;
  }
  arcs.emplace_back(last, 1);
  std::sort(
      nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.value < b.value; });
  std::vector<std::size_t> rank(nodes.size());
  std::vector<double> values;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rank[nodes[i].number] = i;
    values.push_back(nodes[i].value);
  }
  for (Rank_pair& arc : arcs)
    arc = {rank[arc.first], rank[arc.second]};
  return make_graph(values, arcs);
}

std::size_t number_of_leaves(const Graph& graph)
{
  std::vector<std::size_t> degree(num_vertices(graph), 0);
  for (const auto arc : CGAL::make_range(edges(graph))) {
    ++degree[source(arc, graph)];
    ++degree[target(arc, graph)];
  }
  return static_cast<std::size_t>(std::count(degree.begin(), degree.end(), 1));
}

template <class NamedParameters>
Graph simplified(Graph graph, const NamedParameters& np)
{
  SMRG::simplify_Reeb_graph(Mesh(), Value_map(), graph, np);
  return graph;
}

const auto absolute = SMRG::parameters::threshold_is_absolute(true);

} // namespace

BOOST_AUTO_TEST_CASE(gaps_of_known_diagrams)
{
  // persistences 0.125, 0.25 and 0.5 of the range, which is 2: gaps 0 to 0.125 to 0.25 to 0.5, the
  // widest one at the top
  const Graph graph = comb(2, {0.25, 0.5, 1});
  const std::vector<double> persistences = {0, 0.125, 0.25, 0.5};
  for (std::size_t k = 1; k <= 3; ++k) {
    // the two lowest ones are equally wide: the higher one comes first
    const std::size_t i = 3 - k;
    const SMRG::Persistence_gap gap = SMRG::persistence_gap(graph, k);
    BOOST_TEST(gap.lower == persistences[i]);
    BOOST_TEST(gap.upper == persistences[i + 1]);
    BOOST_TEST(gap.threshold == (persistences[i] + persistences[i + 1]) / 2);
    BOOST_TEST(gap.width() == persistences[i + 1] - persistences[i]);
    BOOST_TEST(gap.number_of_pairs == k);
    const SMRG::Persistence_gap double_gap = SMRG::persistence_gap(graph, k, absolute);
    BOOST_TEST(double_gap.lower == 2 * gap.lower);
    BOOST_TEST(double_gap.upper == 2 * gap.upper);
    BOOST_TEST(number_of_leaves(simplified(graph, SMRG::parameters::persistence_gap(k))) == k + 2);
  }
  for (const std::size_t k : {std::size_t(4), (std::numeric_limits<std::size_t>::max)()}) {
    const SMRG::Persistence_gap none = SMRG::persistence_gap(graph, k);
    BOOST_TEST(none.threshold == 0);
    BOOST_TEST(none.width() == 0);
    BOOST_TEST(none.number_of_pairs == 3u);
    BOOST_TEST(number_of_leaves(simplified(graph, SMRG::parameters::persistence_gap(k))) == 5u);
  }
}

// What stands out stays, whatever the noise below it.
BOOST_AUTO_TEST_CASE(noise_goes_and_features_stay)
{
  for (const double height : {1., 4.}) {
    const Graph limbs = comb(height, {0.01, 0.6, 0.03, 0.7, 0.02, 0.65, 0.04});
    BOOST_TEST(SMRG::persistence_gap(limbs).number_of_pairs == 3u);
    BOOST_TEST(number_of_leaves(simplified(limbs, SMRG::parameters::persistence_gap(1))) == 5u);
  }
  const Graph no_noise = comb(1, {0.6, 0.7, 0.65});
  BOOST_TEST(SMRG::persistence_gap(no_noise).lower == 0);
  BOOST_TEST(number_of_leaves(simplified(no_noise, SMRG::parameters::persistence_gap(1))) == 5u);
}

BOOST_AUTO_TEST_CASE(graphs_with_few_pairs)
{
  const Graph empty, node = make_graph({3}, {}), plateau = make_graph({3, 3}, {{0, 1}}),
                     arc = make_graph({3, 5}, {{0, 1}}); // its own pair is the only one
  for (const Graph& graph : {empty, node, plateau, arc}) {
    const SMRG::Persistence_gap gap = SMRG::persistence_gap(graph);
    BOOST_TEST(gap.threshold == 0);
    BOOST_TEST(gap.upper == 0);
    BOOST_TEST(gap.number_of_pairs == 0u);
    const Graph result = simplified(graph, SMRG::parameters::persistence_gap(1));
    BOOST_TEST(num_vertices(result) == num_vertices(graph));
  }
  // one pair stays, however small it is
  const Graph small = comb(1, {0.25});
  const SMRG::Persistence_gap gap = SMRG::persistence_gap(small);
  BOOST_TEST(gap.lower == 0);
  BOOST_TEST(gap.upper == 0.25);
  BOOST_TEST(gap.threshold == 0.125);
  BOOST_TEST(gap.number_of_pairs == 1u);
  BOOST_TEST(number_of_leaves(simplified(small, SMRG::parameters::persistence_gap(1))) == 3u);
}

// Between neighboring numbers there is none in the middle: the threshold separates them all the
// same.
BOOST_AUTO_TEST_CASE(narrow_gaps_and_extreme_values)
{
  const double epsilon = std::numeric_limits<double>::epsilon();
  const Graph narrow = zigzag({0, 1, 0, 1 + epsilon, 0, 3});
  SMRG::Persistence_gap gap = SMRG::persistence_gap(narrow, 1, absolute);
  BOOST_TEST(gap.lower == 0);
  BOOST_TEST(gap.upper == 1);
  gap = SMRG::persistence_gap(narrow, 2, absolute);
  BOOST_TEST(gap.lower == 1);
  BOOST_TEST(gap.threshold == 1 + epsilon);
  const Graph result = simplified(narrow, absolute.persistence_gap(2));
  BOOST_TEST(persistences_of(result).back() == 1 + epsilon);

  const double tiny = std::numeric_limits<double>::denorm_min();
  BOOST_TEST(SMRG::persistence_gap(zigzag({0, tiny, 0, 1}), 1, absolute).threshold == tiny);

  // infinite pairs are above every threshold, the others have their gaps
  const Graph infinite = zigzag({-infinity, 1, 0, 1.5, 1, 2, 0, infinity});
  gap = SMRG::persistence_gap(infinite, 1, absolute);
  BOOST_TEST(gap.lower == 1);
  BOOST_TEST(gap.upper == 2);
  const double large = std::numeric_limits<double>::max();
  gap = SMRG::persistence_gap(zigzag({-large, 0, -large / 2, large}));
  BOOST_TEST(gap.upper == 0.25);
  BOOST_TEST(gap.lower == 0);
}

// The gaps are those of the pairs of the boundary matrix, and the graph is that of the threshold.
BOOST_AUTO_TEST_CASE(gaps_of_random_graphs)
{
  for_random_graphs(number_of_random_cases(), [](const Graph& graph, const auto&, double) {
    std::vector<double> persistences = persistences_of(graph);
    persistences.push_back(0);
    std::vector<double> widths;
    for (std::size_t i = 1; i < persistences.size(); ++i)
      if (persistences[i - 1] > persistences[i])
        widths.push_back(persistences[i - 1] - persistences[i]);
    std::sort(widths.rbegin(), widths.rend());
    widths.push_back(0);
    for (std::size_t k = 1; k <= widths.size(); ++k) {
      const SMRG::Persistence_gap gap = SMRG::persistence_gap(graph, k, absolute);
      BOOST_TEST(gap.width() == widths[k - 1]);
      BOOST_TEST(gap.number_of_pairs == number_above(persistences, gap.lower));
      BOOST_TEST(number_above(persistences, gap.lower) ==
                 static_cast<std::size_t>(
                     std::count_if(persistences.begin(), persistences.end(), [&](const double p) {
                       return p > 0 && p >= gap.threshold;
                     })));
      const Graph by_gap = simplified(graph, absolute.persistence_gap(k)),
                  by_threshold = simplified(graph, absolute.persistence_threshold(gap.threshold));
      BOOST_TEST((arcs_of(by_gap) == arcs_of(by_threshold)));
      BOOST_TEST(values_of(by_gap) == values_of(by_threshold), boost::test_tools::per_element());
      const Graph relative_by_gap = simplified(graph, SMRG::parameters::persistence_gap(k)),
                  relative_by_threshold =
                      simplified(graph,
                                 SMRG::parameters::persistence_threshold(
                                     SMRG::persistence_gap(graph, k).threshold));
      BOOST_TEST((arcs_of(relative_by_gap) == arcs_of(relative_by_threshold)));
    }
  });
}

// The proof in the documentation of persistence_gap(), on random meshes: the function is changed at
// every vertex, and d is the range of the changes.
BOOST_AUTO_TEST_CASE(wide_gaps_are_stable)
{
  std::size_t number_of_stable_gaps = 0, number_of_widest_gaps = 0;
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      const std::vector<double> values = random_values(n, rng);
      Case c(mesh, values);
      Graph graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      const std::vector<double> before = persistences_of(graph);
      const double change = std::pow(random_unit(rng), 4), offset = random_unit(rng);
      std::vector<double> changed = values;
      double least = infinity, largest = -infinity;
      for (std::size_t i = 0; i < n; ++i) {
        changed[i] += offset + change * random_unit(rng);
        least = (std::min)(least, changed[i] - values[i]);
        largest = (std::max)(largest, changed[i] - values[i]);
      }
      const double rounding = 8 * std::numeric_limits<double>::epsilon();
      const double d = largest - least + rounding;
      c.set(changed);
      Graph changed_graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, changed_graph);
      const std::vector<double> after = persistences_of(changed_graph);

      for (std::size_t i = 0; i < (std::max)(before.size(), after.size()); ++i)
        BOOST_TEST(
            std::abs((i < before.size() ? before[i] : 0) - (i < after.size() ? after[i] : 0)) <= d);
      SMRG::Persistence_gap gap;
      for (std::size_t k = 1; (gap = SMRG::persistence_gap(graph, k, absolute)).width() > 2 * d;
           ++k) {
        ++number_of_stable_gaps;
        BOOST_TEST(number_above(after, gap.threshold) == gap.number_of_pairs);
        const auto threshold = absolute.persistence_threshold(gap.threshold);
        const Graph one = simplified(graph, threshold),
                    other = simplified(changed_graph, threshold);
        for (const bool minima : {true, false})
          BOOST_TEST(extrema(one, minima).size() == extrema(other, minima).size());
      }
      const SMRG::Persistence_gap widest = SMRG::persistence_gap(graph, 1, absolute),
                                  second = SMRG::persistence_gap(graph, 2, absolute);
      if (widest.width() > second.width() + 4 * d) {
        ++number_of_widest_gaps;
        BOOST_TEST(SMRG::persistence_gap(changed_graph, 1, absolute).number_of_pairs ==
                   widest.number_of_pairs);
        const Graph one = simplified(graph, absolute.persistence_gap(1)),
                    other = simplified(changed_graph, absolute.persistence_gap(1));
        for (const bool minima : {true, false})
          BOOST_TEST(extrema(one, minima).size() == extrema(other, minima).size());
      }
    }
  }
  BOOST_TEST(number_of_stable_gaps > number_of_random_cases());
  BOOST_TEST(number_of_widest_gaps > number_of_random_cases() / 20);
}

// The gap is that of the graph as it is given, and holds also for what closed loops bring up.
BOOST_AUTO_TEST_CASE(gaps_together_with_loops_and_leaves)
{
  for_random_graphs(
      number_of_random_cases(), [](const Graph& graph, const auto&, const double loops) {
        const double threshold = SMRG::persistence_gap(graph, 1, absolute).threshold;
        const auto others = absolute.loop_persistence_threshold(loops).number_of_leaves(6);
        BOOST_TEST((arcs_of(simplified(graph, others.persistence_gap(1))) ==
                    arcs_of(simplified(graph, others.persistence_threshold(threshold)))));
      });
}

BOOST_AUTO_TEST_CASE(wrong_arguments_and_graphs)
{
  const Graph graph = comb(2, {0.25, 0.5, 1});
  BOOST_CHECK_THROW(SMRG::persistence_gap(graph, 0), CGAL::Precondition_exception);
  BOOST_CHECK_THROW(simplified(graph, SMRG::parameters::persistence_gap(-1)),
                    CGAL::Precondition_exception);
  BOOST_CHECK_THROW(
      simplified(graph, SMRG::parameters::persistence_gap(1).persistence_threshold(0.1)),
      CGAL::Precondition_exception);
  BOOST_TEST(number_of_leaves(simplified(
                 graph, SMRG::parameters::persistence_gap(0).persistence_threshold(0.2))) == 4u);
  Graph wrong = graph;
  wrong[0].value = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(SMRG::persistence_gap(wrong), SMRG::Input_error);
}
