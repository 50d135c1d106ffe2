// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of persistence and of simplification share: random graphs, and pairs in a form
// that compares with the oracle's.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_PERSISTENCE_CHECKS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_PERSISTENCE_CHECKS_H

#include "extended_persistence_oracle.h"
#include "random_meshes.h"
#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace Reeb_graph_test {

using Rank_pair = std::pair<std::size_t, std::size_t>;
using Pair = SMRG::Persistence_pair<Graph>;

// A graph that belongs to no mesh.
inline Graph make_graph(const std::vector<double>& values, const std::vector<Rank_pair>& arcs)
{
  Graph graph(values.size());
  std::vector<std::size_t> down(values.size(), 0), up(values.size(), 0);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    graph[add_edge(arcs[i].first, arcs[i].second, graph).first].id = i;
    ++up[arcs[i].first];
    ++down[arcs[i].second];
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    graph[i].id = i;
    graph[i].vertex = Vertex(static_cast<unsigned>(i));
    graph[i].value = values[i];
    graph[i].type = SMRG::type_of_Reeb_node(down[i], up[i]);
  }
  return graph;
}

inline std::vector<double> values_of(const Graph& graph)
{
  std::vector<double> values;
  for (const auto node : CGAL::make_range(vertices(graph)))
    values.push_back(graph[node].value);
  return values;
}

inline std::vector<Rank_pair> arcs_of(const Graph& graph)
{
  std::vector<Rank_pair> arcs;
  for (const auto arc : CGAL::make_range(edges(graph)))
    arcs.emplace_back(source(arc, graph), target(arc, graph));
  return arcs;
}

// Random arcs between up to 24 nodes, with parallel arcs, degenerate and isolated nodes and several
// components, but no regular nodes; increasing values, with ties if asked for.
inline Graph random_graph(std::mt19937& rng, const bool has_ties)
{
  const std::size_t n = 2 + random_index(23, rng);
  const std::size_t m = random_index(2 * n + 2, rng);
  const std::size_t reach = 1 + random_index(n, rng); // short arcs make many small loops
  std::vector<Rank_pair> arcs;
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t lower = random_index(n - 1, rng);
    arcs.emplace_back(lower, lower + 1 + random_index((std::min)(reach, n - 1 - lower), rng));
  }

  std::vector<std::size_t> number(n, 0); // of the nodes that are left
  std::size_t number_of_nodes = 0;
  for (std::size_t node = 0; node < n; ++node) {
    const auto ends_here = [node](const Rank_pair& arc) { return arc.second == node; };
    const auto begins_here = [node](const Rank_pair& arc) { return arc.first == node; };
    if (std::count_if(arcs.begin(), arcs.end(), ends_here) == 1 &&
        std::count_if(arcs.begin(), arcs.end(), begins_here) == 1)
    {
      const auto above = std::find_if(arcs.begin(), arcs.end(), begins_here);
      std::find_if(arcs.begin(), arcs.end(), ends_here)->second = above->second;
      arcs.erase(above);
    } else {
      number[node] = number_of_nodes++;
    }
  }
  for (Rank_pair& arc : arcs)
    arc = {number[arc.first], number[arc.second]};

  std::vector<double> values(number_of_nodes, 0.);
  for (std::size_t i = 1; i < number_of_nodes; ++i)
    values[i] = values[i - 1] +
                (has_ties ? static_cast<double>(random_index(2, rng)) : 0.01 + random_unit(rng));
  return make_graph(values, arcs);
}

inline std::vector<Pair> pairs_of(const Graph& graph)
{
  std::vector<Pair> pairs;
  SMRG::persistence_pairs(graph, std::back_inserter(pairs));
  return pairs;
}

// In the oracle's words.
inline std::vector<Extended_pair> comparable_pairs(const std::vector<Pair>& pairs)
{
  std::vector<Extended_pair> result;
  for (const Pair& pair : pairs) {
    const Extended_kind kind = pair.kind == SMRG::Persistence_pair_kind::MINIMUM   ? ORDINARY
                               : pair.kind == SMRG::Persistence_pair_kind::MAXIMUM ? RELATIVE
                                                                                   : EXTENDED;
    const int dimension = pair.kind == SMRG::Persistence_pair_kind::MINIMUM ||
                                  pair.kind == SMRG::Persistence_pair_kind::COMPONENT
                              ? 0
                              : 1;
    result.push_back({kind, dimension, pair.birth, pair.death});
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline std::vector<Extended_pair> oracle_pairs(const Graph& graph)
{
  return extended_persistence(ranked_complex_of_graph(num_vertices(graph), arcs_of(graph)));
}

// The numbers of nodes become numbers of vertices, the ranks of which are given.
inline std::vector<Extended_pair>
with_ranks(std::vector<Extended_pair> pairs, const std::vector<std::size_t>& rank_of_node)
{
  for (Extended_pair& pair : pairs) {
    pair.birth = rank_of_node[pair.birth];
    pair.death = rank_of_node[pair.death];
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_PERSISTENCE_CHECKS_H
