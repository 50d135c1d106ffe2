// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_SEQUENCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_SEQUENCES_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Folded_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Graph_core.h>

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Paths upwards in a graph as sequences of arcs, such as Folded_graph::join() makes.
//
// Every sequence is a balanced tree: it is divided at the arc of least priority, and priorities are as good as random.
// So sequences for paths that have a part in common share the trees of this part, but for O(log m) of their nodes.
class Arc_sequences
{
public:
  // The arcs are those of `core`, shortened; `numbers` holds by arc the number that it has in `graph`.
  Arc_sequences(Folded_graph& graph,
                const Graph_core& core,
                const std::vector<Arc_ends>& arcs,
                const std::vector<std::uint32_t>& numbers)
    : m_graph(graph)
    , m_core(core)
    , m_arcs(arcs)
    , m_numbers(numbers)
    , m_forest(core.number_of_nodes(), arcs)
  {}

  // Adds an arc. They must be added from the highest lower node to the lowest one.
  void add(std::uint32_t arc) { m_forest.add(arc); }

  // The number of the sequence of arcs on the path upwards between two nodes. It must be the only path between them at
  // heights between theirs, and the arcs must have been added down to the lower node, no others.
  std::uint32_t sequence(std::uint32_t lower, std::uint32_t upper)
  {
    const std::uint32_t arc = m_forest.sum_on_path(lower, upper).first.arc;
    const Arc_ends& ends = m_arcs[arc];
    if (ends.lower == lower && ends.upper == upper)
      return m_numbers[arc];
    const std::uint64_t key = (std::uint64_t(upper) << 32) | lower;
    const auto found = m_sequences.find(key);
    if (found != m_sequences.end())
      return found->second;

    std::uint32_t result = m_numbers[arc];
    if (ends.upper != upper)
      result = m_graph.join(result, m_core.node_before(ends.upper), sequence(ends.upper, upper));
    if (ends.lower != lower)
      result = m_graph.join(sequence(lower, ends.lower), m_core.node_before(ends.lower), result);
    m_sequences.emplace(key, result);
    return result;
  }

private:
  struct Arc_of_priority
  {
    std::uint64_t priority = (std::numeric_limits<std::uint64_t>::max)();
    std::uint32_t arc = no_arc;
  };

  struct Summary : Highest_arc
  {
    Summary() = default;
    Summary(std::uint32_t arc, const Arc_ends& ends)
      : Highest_arc(arc, ends), first{priority(arc), arc}
    {}

    friend Summary operator+(const Summary& a, const Summary& b)
    {
      Summary result;
      static_cast<Highest_arc&>(result) = static_cast<const Highest_arc&>(a) + b;
      result.first = b.first.priority < a.first.priority ? b.first : a.first;
      return result;
    }

    Arc_of_priority first;
  };

  // A permutation of the 64-bit numbers (the output function of the generator SplitMix64).
  static std::uint64_t priority(std::uint64_t number)
  {
    number = (number + 1) * 0x9e3779b97f4a7c15u;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
    return number ^ (number >> 31);
  }

  Folded_graph& m_graph;
  const Graph_core& m_core;
  const std::vector<Arc_ends>& m_arcs;
  const std::vector<std::uint32_t>& m_numbers;
  Arc_forest<Summary> m_forest;
  std::unordered_map<std::uint64_t, std::uint32_t> m_sequences; // by upper and lower node
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_SEQUENCES_H
