// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_EXTREMUM_PAIRING_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_EXTREMUM_PAIRING_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/counting_sort.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A persistence pair: on the side BELOW a minimum and the node where its component of the sublevel
// set merges into one with a lower minimum; on the side ABOVE a maximum and a node, upside down.
struct Extremum_pair
{
  std::uint32_t extremum, saddle;
  std::uint32_t arc, other_arc; // at the saddle, towards the extremum and the eldest one there
  Side side;
  double persistence;
};

// Finds the pairs of a Reeb graph: on every side, the components of the sublevel (superlevel) sets
// grow node by node, and where some merge, all but the one with the eldest extremum end.
class Extremum_pairing
{
public:
  // `values` increase with the nodes. Of `arcs`, those for which `is_arc(arc)` holds are the arcs
  // of a Reeb graph.
  template <class IsArc>
  Extremum_pairing(const std::vector<double>& values,
                   const std::vector<Arc_ends>& arcs,
                   const IsArc& is_arc)
    : m_values(values), m_arcs(arcs)
  {
    CGAL_precondition(std::is_sorted(values.begin(), values.end()));
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc)
      if (is_arc(arc))
        m_arc_numbers.push_back(arc);
  }

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
    // the arcs of every node on the side
    std::vector<std::uint32_t> sorted(m_arc_numbers.size());
    const std::vector<std::size_t> begin = counting_sort(
        m_arc_numbers.size(),
        n,
        [&](std::size_t i) { return end_on(opposite_side(side), m_arcs[m_arc_numbers[i]]); },
        [&](std::size_t position, std::size_t i) { sorted[position] = m_arc_numbers[i]; });

    m_sets = Disjoint_sets(n);
    m_extremum.resize(n);
    std::iota(m_extremum.begin(), m_extremum.end(), 0);
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t node = static_cast<std::uint32_t>(side == BELOW ? k : n - 1 - k);
      const std::size_t number_of_pairs = m_pairs.size();
      for (std::size_t i = begin[node]; i < begin[node + 1]; ++i)
        add_arc(side, node, sorted[i]);
      for (std::size_t i = number_of_pairs; i < m_pairs.size(); ++i)
        m_pairs[i].other_arc = m_elder_arc;
    }
  }

  void add_arc(Side side, std::uint32_t node, std::uint32_t arc)
  {
    const std::uint32_t a = m_sets.root(node), b = m_sets.root(end_on(side, m_arcs[arc]));
    if (a == b)
      return;
    m_sets.join(a, b);
    if (m_extremum[a] == node) { // the first neighbor: nothing merges yet
      m_elder_arc = arc;
      return;
    }
    if (lies_towards(side, m_extremum[b], m_extremum[a])) {
      add_pair(side, m_extremum[a], node, m_elder_arc);
      m_elder_arc = arc;
    } else {
      add_pair(side, m_extremum[b], node, arc);
      m_extremum[b] = m_extremum[a];
    }
  }

  void add_pair(Side side, std::uint32_t extremum, std::uint32_t saddle, std::uint32_t arc)
  {
    const double persistence = side == BELOW ? difference(m_values[extremum], m_values[saddle])
                                             : difference(m_values[saddle], m_values[extremum]);
    m_pairs.push_back({extremum, saddle, arc, no_arc, side, persistence});
  }

  const std::vector<double>& m_values;
  const std::vector<Arc_ends>& m_arcs;
  std::vector<std::uint32_t> m_arc_numbers;
  std::uint32_t m_elder_arc = no_arc; // at the current node, towards the extremum of its component
  Disjoint_sets m_sets;               // the components so far, of nodes
  std::vector<std::uint32_t> m_extremum; // of a component, at its root
  std::vector<Extremum_pair> m_pairs;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_EXTREMUM_PAIRING_H
