// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_EXTREMUM_PAIRS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_EXTREMUM_PAIRS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Number_sets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// The two directions along a Reeb graph. What is said of minima holds for maxima with the graph upside
// down, so the code says it once, for a side.
enum Side { BELOW = 0, ABOVE = 1 };

inline bool lies_towards(Side side, std::uint32_t i, std::uint32_t j)
{
  return side == BELOW ? i < j : j < i;
}

inline std::uint32_t end_on(Side side, const Arc_ends& arc)
{
  return side == BELOW ? arc.lower : arc.upper;
}

// A persistence pair: on the side BELOW a minimum and the node where its component of the sublevel set
// merges into one with a lower minimum; on the side ABOVE a maximum and a node, upside down.
struct Extremum_pair
{
  std::uint32_t extremum, saddle;
  Side side;
  double persistence;
};

// The difference of two values, also of infinite ones: equal values have difference 0.
inline double persistence_between(double lower, double upper)
{
  return lower == upper ? 0. : upper - lower;
}

class Extremum_pairing
{
public:
  // `values` increase with the nodes, `arcs` are those of a Reeb graph.
  Extremum_pairing(const std::vector<double>& values, const std::vector<Arc_ends>& arcs)
    : m_values(values), m_arcs(arcs)
  {}

  // All pairs, such that a pair comes after the pairs inside its branch.
  std::vector<Extremum_pair> run()
  {
    find_pairs(BELOW);
    find_pairs(ABOVE);
    std::sort(m_pairs.begin(), m_pairs.end(), [](const Extremum_pair& a, const Extremum_pair& b) {
      auto key = [](const Extremum_pair& p) {
        // equal persistences: inner pairs first, which have saddles nearer to the side, and at the
        // same saddle extrema nearer to it
        const std::int64_t sign = p.side == BELOW ? 1 : -1;
        return std::make_tuple(
            p.persistence, p.side, sign * std::int64_t(p.saddle), -sign * std::int64_t(p.extremum));
      };
      return key(a) < key(b);
    });
    return std::move(m_pairs);
  }

private:
  void find_pairs(Side side)
  {
    const std::size_t n = m_values.size();
    // the arcs of every node on the side, by counting sort
    const Side other_side = side == BELOW ? ABOVE : BELOW;
    std::vector<std::size_t> begin(n + 1, 0);
    for (const Arc_ends& arc : m_arcs)
      ++begin[end_on(other_side, arc) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> neighbors(m_arcs.size());
    std::vector<std::size_t> position(begin.begin(), begin.end() - 1);
    for (const Arc_ends& arc : m_arcs)
      neighbors[position[end_on(other_side, arc)]++] = end_on(side, arc);

    m_sets = Number_sets(n);
    m_extremum.resize(n);
    std::iota(m_extremum.begin(), m_extremum.end(), 0);
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t node = static_cast<std::uint32_t>(side == BELOW ? k : n - 1 - k);
      for (std::size_t i = begin[node]; i < begin[node + 1]; ++i)
        add_neighbor(side, node, neighbors[i]);
    }
  }

  void add_neighbor(Side side, std::uint32_t node, std::uint32_t neighbor)
  {
    const std::uint32_t a = m_sets.root(node), b = m_sets.root(neighbor);
    if (a == b)
      return;
    m_sets.join(a, b);
    if (m_extremum[a] == node) // the first neighbor: nothing merges yet
      return;
    const bool is_a_younger = lies_towards(side, m_extremum[b], m_extremum[a]);
    add_pair(side, is_a_younger ? m_extremum[a] : m_extremum[b], node);
    if (!is_a_younger)
      m_extremum[b] = m_extremum[a];
  }

  void add_pair(Side side, std::uint32_t extremum, std::uint32_t saddle)
  {
    const double persistence = side == BELOW
                                   ? persistence_between(m_values[extremum], m_values[saddle])
                                   : persistence_between(m_values[saddle], m_values[extremum]);
    m_pairs.push_back({extremum, saddle, side, persistence});
  }

  const std::vector<double>& m_values;
  const std::vector<Arc_ends>& m_arcs;
  Number_sets m_sets;                    // the components so far, of nodes
  std::vector<std::uint32_t> m_extremum; // of a component, at its root
  std::vector<Extremum_pair> m_pairs;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_EXTREMUM_PAIRS_H
