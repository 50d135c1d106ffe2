// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Oracles for small meshes: the Reeb graph and the persistence pairs of the extrema, straight from
// their definitions. Slow and simple on purpose, and sharing nothing with the code under test.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_BRUTE_FORCE_REEB_GRAPH_H
#define SURFACE_MESH_REEB_GRAPH_TEST_BRUTE_FORCE_REEB_GRAPH_H

#include "Index_mesh.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace Reeb_graph_test {

// ---------------------------------------------------------------------------------------------
// Vertex orders. `rank[v]` is the position of vertex `v` in a strict total order, 0 the lowest.

// By value, ties by index.
inline std::vector<std::size_t> rank_of_values(const std::vector<double>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&values](const std::size_t a, const std::size_t b) {
    return values[a] < values[b];
  });
  std::vector<std::size_t> rank(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = k;
  }
  return rank;
}

inline std::vector<std::size_t> reversed_rank(std::vector<std::size_t> rank)
{
  for (std::size_t& r : rank) {
    r = rank.size() - 1 - r;
  }
  return rank;
}

// The inverse: the vertices from the lowest to the highest.
inline std::vector<std::size_t> order_of_rank(const std::vector<std::size_t>& rank)
{
  std::vector<std::size_t> order(rank.size());
  for (std::size_t v = 0; v < rank.size(); ++v) {
    order[rank[v]] = v;
  }
  return order;
}

// ---------------------------------------------------------------------------------------------
// Level sets

// The edges of a mesh, numbered, and which triangle has which.
struct Edge_table
{
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::vector<std::size_t>> triangles_of_edge;
  std::vector<std::array<std::size_t, 3>> edges_of_triangle;

  explicit Edge_table(const Index_mesh& mesh)
  {
    std::map<std::array<std::size_t, 2>, std::size_t> number;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      const auto& t = mesh.triangles[triangle];
      edges_of_triangle.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = t[i];
        const std::size_t b = t[(i + 1) % 3];
        const std::array<std::size_t, 2> edge = {(std::min)(a, b), (std::max)(a, b)};
        const auto inserted = number.emplace(edge, edges.size());
        if (inserted.second) {
          edges.push_back(edge);
          triangles_of_edge.emplace_back();
        }
        edges_of_triangle.back()[i] = inserted.first->second;
        triangles_of_edge[inserted.first->second].push_back(triangle);
      }
    }
  }
};

// A component of a level set: the numbers of its edges, increasing.
using Level_component = std::vector<std::size_t>;

// The components of the level set between the vertices of rank `k` and `k + 1`: the edges with
// one end on either side, two of them connected if they belong to one triangle.
inline std::vector<Level_component> level_set_components(const Edge_table& table,
                                                         const std::vector<std::size_t>& rank,
                                                         const std::size_t k)
{
  const auto is_crossed = [&](const std::size_t edge) {
    return (rank[table.edges[edge][0]] <= k) != (rank[table.edges[edge][1]] <= k);
  };

  std::vector<Level_component> components;
  std::vector<bool> visited(table.edges.size(), false);
  for (std::size_t start = 0; start < table.edges.size(); ++start) {
    if (visited[start] || !is_crossed(start)) {
      continue;
    }
    Level_component component;
    std::queue<std::size_t> queue;
    visited[start] = true;
    queue.push(start);
    while (!queue.empty()) {
      const std::size_t edge = queue.front();
      queue.pop();
      component.push_back(edge);
      for (const std::size_t triangle : table.triangles_of_edge[edge]) {
        for (const std::size_t other : table.edges_of_triangle[triangle]) {
          if (!visited[other] && is_crossed(other)) {
            visited[other] = true;
            queue.push(other);
          }
        }
      }
    }
    std::sort(component.begin(), component.end());
    components.push_back(component);
  }
  return components;
}

// ---------------------------------------------------------------------------------------------
// The Reeb graph

struct Brute_force_Reeb_graph
{
  // `down` and `up`: the numbers of level set components that touch the vertex just below and just
  // above it.
  struct Node
  {
    std::size_t vertex;
    std::size_t down;
    std::size_t up;
  };

  // `vertices`: the regular vertices strictly inside, in increasing order.
  struct Arc
  {
    std::size_t lower_vertex;
    std::size_t upper_vertex;
    std::vector<std::size_t> vertices;
  };

  std::vector<Node> nodes; // in increasing order
  std::vector<Arc> arcs;
};

// Follows the components of the level sets from the lowest vertex to the highest, every level set
// computed from scratch. `rank` is a permutation of 0, ..., number of points - 1.
inline Brute_force_Reeb_graph
brute_force_Reeb_graph(const Index_mesh& mesh, const std::vector<std::size_t>& rank)
{
  const Edge_table table(mesh);
  const std::vector<std::size_t> order = order_of_rank(rank);
  Brute_force_Reeb_graph graph;
  std::map<Level_component, std::size_t> arc_of_component; // just below the current vertex
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t v = order[k];
    // The other end of an edge at `v` is lower if the edge is crossed just below `v`, and higher
    // if it is crossed just above: no need to look at it.
    const auto touches_v = [&](const Level_component& component) {
      return std::any_of(component.begin(), component.end(), [&](const std::size_t edge) {
        return table.edges[edge][0] == v || table.edges[edge][1] == v;
      });
    };

    std::vector<std::size_t> arcs_down;
    for (const auto& below : arc_of_component) {
      if (touches_v(below.first)) {
        arcs_down.push_back(below.second);
      }
    }

    std::vector<Level_component> components_up;
    std::map<Level_component, std::size_t> arc_of_component_above;
    for (const Level_component& component : level_set_components(table, rank, k)) {
      if (touches_v(component)) {
        components_up.push_back(component);
      } else {
        // Same edges as below `v`; `at` throws if that were ever wrong.
        arc_of_component_above.emplace(component, arc_of_component.at(component));
      }
    }

    if (arcs_down.size() == 1 && components_up.size() == 1) {
      graph.arcs[arcs_down.front()].vertices.push_back(v);
      arc_of_component_above.emplace(components_up.front(), arcs_down.front());
    } else {
      graph.nodes.push_back({v, arcs_down.size(), components_up.size()});
      for (const std::size_t arc : arcs_down) {
        graph.arcs[arc].upper_vertex = v;
      }
      for (const Level_component& component : components_up) {
        arc_of_component_above.emplace(component, graph.arcs.size());
        graph.arcs.push_back({v, v, {}}); // the upper vertex is known when the arc ends
      }
    }
    arc_of_component.swap(arc_of_component_above);
  }
  return graph;
}

// ---------------------------------------------------------------------------------------------
// What to compare: independent of the numbering of nodes and arcs

// Lower vertex, upper vertex, regular vertices by index.
using Comparable_arc = std::tuple<std::size_t, std::size_t, std::vector<std::size_t>>;

inline Comparable_arc comparable_arc(const std::size_t lower_vertex,
                                     const std::size_t upper_vertex,
                                     std::vector<std::size_t> regular_vertices)
{
  std::sort(regular_vertices.begin(), regular_vertices.end());
  return Comparable_arc(lower_vertex, upper_vertex, std::move(regular_vertices));
}

inline std::vector<Comparable_arc> comparable_arcs(const Brute_force_Reeb_graph& graph)
{
  std::vector<Comparable_arc> arcs;
  for (const Brute_force_Reeb_graph::Arc& arc : graph.arcs) {
    arcs.push_back(comparable_arc(arc.lower_vertex, arc.upper_vertex, arc.vertices));
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

// Vertex, down, up; sorted by vertex.
using Comparable_node = std::tuple<std::size_t, std::size_t, std::size_t>;

inline std::vector<Comparable_node> comparable_nodes(const Brute_force_Reeb_graph& graph)
{
  std::vector<Comparable_node> nodes;
  for (const Brute_force_Reeb_graph::Node& node : graph.nodes) {
    nodes.emplace_back(node.vertex, node.down, node.up);
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

// Arcs - nodes + components of the graph.
inline std::size_t number_of_loops(const Brute_force_Reeb_graph& graph)
{
  std::map<std::size_t, std::size_t> node_number;
  for (const Brute_force_Reeb_graph::Node& node : graph.nodes) {
    node_number.emplace(node.vertex, node_number.size());
  }
  boost::disjoint_sets_with_storage<> sets(graph.nodes.size());
  std::size_t loops = 0;
  for (const Brute_force_Reeb_graph::Arc& arc : graph.arcs) {
    const std::size_t lower = sets.find_set(node_number.at(arc.lower_vertex));
    const std::size_t upper = sets.find_set(node_number.at(arc.upper_vertex));
    if (lower == upper) {
      ++loops;
    } else {
      sets.link(lower, upper);
    }
  }
  return loops;
}

// ---------------------------------------------------------------------------------------------
// Persistence of the minima, from the edges of the mesh instead of from its Reeb graph. For the
// maxima pass `reversed_rank(rank)`.

// A component of the sublevel sets is born at `extremum` and joins an older one at `saddle`.
struct Extremum_pair
{
  std::size_t extremum;
  std::size_t saddle;

  friend bool operator==(const Extremum_pair& a, const Extremum_pair& b)
  {
    return a.extremum == b.extremum && a.saddle == b.saddle;
  }

  friend bool operator<(const Extremum_pair& a, const Extremum_pair& b)
  {
    return std::tie(a.extremum, a.saddle) < std::tie(b.extremum, b.saddle);
  }
};

struct Extremum_pairs
{
  std::vector<Extremum_pair> pairs;          // sorted
  std::vector<std::size_t> unpaired_extrema; // one per component of the mesh, sorted
};

inline Extremum_pairs
brute_force_extremum_pairs(const Index_mesh& mesh, const std::vector<std::size_t>& rank)
{
  const std::vector<std::size_t> order = order_of_rank(rank);
  std::vector<std::set<std::size_t>> neighbors(rank.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      neighbors[t[i]].insert({t[(i + 1) % 3], t[(i + 2) % 3]});
    }
  }

  Extremum_pairs result;
  boost::disjoint_sets_with_storage<> sets(rank.size());
  std::vector<std::size_t> eldest(rank.size()); // of the set with this root
  std::iota(eldest.begin(), eldest.end(), std::size_t(0));
  for (const std::size_t v : order) {
    for (const std::size_t w : neighbors[v]) {
      const std::size_t v_root = sets.find_set(v);
      const std::size_t w_root = sets.find_set(w);
      if (rank[w] > rank[v] || v_root == w_root) {
        continue;
      }
      const bool v_is_elder = rank[eldest[v_root]] < rank[eldest[w_root]];
      const std::size_t survivor = eldest[v_is_elder ? v_root : w_root];
      const std::size_t dying = eldest[v_is_elder ? w_root : v_root];
      // A vertex with a lower neighbour is no minimum: nothing is born there, so nothing dies.
      if (dying != v) {
        result.pairs.push_back({dying, v});
      }
      sets.link(v_root, w_root);
      eldest[sets.find_set(v)] = survivor;
    }
  }

  for (std::size_t v = 0; v < rank.size(); ++v) {
    if (sets.find_set(v) == v) {
      result.unpaired_extrema.push_back(eldest[v]);
    }
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  std::sort(result.unpaired_extrema.begin(), result.unpaired_extrema.end());
  return result;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_BRUTE_FORCE_REEB_GRAPH_H
