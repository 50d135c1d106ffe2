// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE simplification_time

#include "simplification_checks.h"

#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_closing.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// Whether more cases than usual are asked for: then graphs are larger, too.
bool is_long_run()
{
  return number_of_random_cases() > 2000;
}

} // namespace

// Nodes with very many arcs, very many branches along an arc, branches on branches: with work in
// proportion to the square of the size these would take minutes, or hours.
BOOST_AUTO_TEST_CASE(large_graphs_take_no_quadratic_time)
{
  const Mesh no_mesh;
  const Value_map no_values;
  const std::size_t n = is_long_run() ? 100000 : 30000;
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
  const std::size_t n = is_long_run() ? 100000 : 30000;
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
  // bundles of paths whose nodes alternate, joined in pairs, the pairs in pairs, and so on
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
    const std::size_t n = is_long_run() ? 1 << 13 : 1 << 11;
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
