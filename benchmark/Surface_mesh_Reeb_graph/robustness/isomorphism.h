// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two Reeb graphs are the same but for the heights of their nodes.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ISOMORPHISM_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ISOMORPHISM_H

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Robustness {

// The nodes with their types and the arcs from their lower to their upper ends.
struct Typed_graph
{
  std::vector<int> types;
  std::vector<std::pair<std::size_t, std::size_t>> arcs;
};

// Colors of the nodes of two graphs, refined by the colors of their neighbors below and above until
// nothing changes: nodes that an isomorphism maps to each other have the same color.
inline std::array<std::vector<std::size_t>, 2>
refined_colors(const Typed_graph& a, const Typed_graph& b)
{
  const std::array<const Typed_graph*, 2> graphs = {&a, &b};
  std::array<std::vector<std::size_t>, 2> colors;
  for (std::size_t i = 0; i < 2; ++i)
    colors[i].assign(graphs[i]->types.begin(), graphs[i]->types.end());
  for (std::size_t number = 0;;) {
    using Signature = std::pair<std::size_t, std::array<std::vector<std::size_t>, 2>>;
    std::map<Signature, std::size_t> numbers;
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<Signature> signatures(colors[i].size());
      for (std::size_t v = 0; v < signatures.size(); ++v)
        signatures[v].first = colors[i][v];
      for (const auto& [lower, upper] : graphs[i]->arcs) {
        signatures[lower].second[1].push_back(colors[i][upper]);
        signatures[upper].second[0].push_back(colors[i][lower]);
      }
      for (std::size_t v = 0; v < signatures.size(); ++v) {
        for (std::vector<std::size_t>& neighbors : signatures[v].second)
          std::sort(neighbors.begin(), neighbors.end());
        colors[i][v] = numbers.emplace(signatures[v], numbers.size()).first->second;
      }
    }
    if (numbers.size() == number)
      return colors;
    number = numbers.size();
  }
}

inline bool are_isomorphic(const Typed_graph& a, const Typed_graph& b)
{
  if (a.types.size() != b.types.size() || a.arcs.size() != b.arcs.size())
    return false;
  const auto colors = refined_colors(a, b);
  auto sorted = colors;
  for (std::vector<std::size_t>& list : sorted)
    std::sort(list.begin(), list.end());
  if (sorted[0] != sorted[1])
    return false;

  using Digraph = boost::adjacency_list<boost::vecS,
                                        boost::vecS,
                                        boost::bidirectionalS,
                                        boost::property<boost::vertex_index_t, std::size_t>,
                                        boost::property<boost::edge_weight_t, std::size_t>>;
  // parallel arcs become one that knows their number
  const auto digraph = [](const Typed_graph& graph) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    for (const auto& arc : graph.arcs)
      ++numbers[arc];
    Digraph result(graph.types.size());
    for (const auto& [arc, number] : numbers)
      add_edge(arc.first, arc.second, number, result);
    return result;
  };
  const Digraph one = digraph(a), other = digraph(b);
  return boost::vf2_graph_iso(
      one,
      other,
      [](const auto&, const auto&) { return false; }, // one isomorphism suffices
      get(boost::vertex_index, one),
      get(boost::vertex_index, other),
      boost::vertex_order_by_mult(one),
      [&](const auto e, const auto f) {
        return get(boost::edge_weight, one, e) == get(boost::edge_weight, other, f);
      },
      [&](const auto v, const auto w) { return colors[0][v] == colors[1][w]; });
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_ISOMORPHISM_H
