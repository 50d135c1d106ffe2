// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_ARC_PROPAGATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_ARC_PROPAGATION_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Level_set_component_finder.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Side.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/upper_wedge.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds the arcs of vertices from those of lower neighbors. Along an edge of the mesh the function is
// monotone, so the edge leads through the Reeb graph on an ascending path: if the arc of its lower
// end reaches above its upper end, both lie on this arc. Where the arc ends between them, the path
// goes on in the arc that begins there. At a node at which several arcs begin, walks along the level
// set just above it tell for all edges that cross it which arc they lead to, but for those in its
// longest component, which is not walked to its end: they are the ones that are left.
//
// The walks take a limited number of steps, so there may be vertices whose neighbors do not tell.
// Which ones these are may depend on the number of threads; the arcs that are found do not.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Arc_propagation
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using FT = typename VertexOrder::FT;
  using Finder = Level_set_component_finder<ConcurrencyTag, TriangleMesh, VertexOrder>;

public:
  Arc_propagation(const TriangleMesh& tmesh,
                  const VertexOrder& order,
                  VertexIndexMap vertex_index_map,
                  const std::vector<Monotone_neighbors<TriangleMesh>>& neighbors,
                  bool has_border,
                  const Arc_list<TriangleMesh>& list)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_neighbors(neighbors)
    , m_has_border(has_border)
    , m_list(list)
    , m_marks(neighbors.size())
  {
    CGAL_precondition(list.arcs.size() < NODE && list.nodes.size() < (LEFT & ~NODE));
    for (std::atomic<std::uint32_t>& mark : m_marks)
      mark.store(UNKNOWN, std::memory_order_relaxed);
    m_arc_above.assign(list.nodes.size(), no_arc);
    for (std::size_t a = list.arcs.size(); a-- > 0;) {
      const std::uint32_t node = list.arcs[a].lower;
      m_arc_above[node] =
          m_arc_above[node] == no_arc ? static_cast<std::uint32_t>(a) : std::uint32_t(SEVERAL);
    }
    m_has_several_below.assign(list.nodes.size(), false);
    std::vector<bool> has_arc_below(list.nodes.size(), false);
    for (const Arc_ends& arc : list.arcs) {
      m_has_several_below[arc.upper] = has_arc_below[arc.upper];
      has_arc_below[arc.upper] = true;
    }
    m_upper_values.reserve(list.arcs.size());
    for (const Arc_ends& arc : list.arcs)
      m_upper_values.push_back(order.value(list.nodes[arc.upper]));
    for (std::uint32_t n = 0; n < list.nodes.size(); ++n) {
      const std::size_t i = index(list.nodes[n]);
      // if several nodes have one vertex, its edges may lead to any of them
      set_mark(i, mark(i) == UNKNOWN ? NODE | n : std::uint32_t(LEFT));
    }
  }

  // Finds the arcs of as many vertices as possible, and returns the other ones that have edges. The
  // walks take `budget` steps at most, or little more.
  std::vector<vertex_descriptor> run(std::size_t budget)
  {
    const auto range = vertices(m_tmesh);
    std::vector<vertex_descriptor> starts(range.begin(), range.end());
    std::vector<Split> found = splits();
    // in noise neighbors tell little that takes no walk to know
    constexpr std::size_t vertices_per_split = 8;
    if (found.size() * vertices_per_split > starts.size()) {
      const auto needs_no_arc = [this](vertex_descriptor v) {
        return mark(index(v)) != UNKNOWN || has_no_edge(v, m_tmesh);
      };
      starts.erase(std::remove_if(starts.begin(), starts.end(), needs_no_arc), starts.end());
      return starts;
    }
    std::vector<vertex_descriptor> left;
    lead_above(std::move(found), budget, left);
    std::mutex mutex;
    for_each_range<ConcurrencyTag>(starts.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<vertex_descriptor> way, left_in_range;
      for (std::size_t i = begin; i < end; ++i)
        if (mark(index(starts[i])) == UNKNOWN)
          descend(starts[i], way, left_in_range);
      const std::lock_guard<std::mutex> lock(mutex);
      left.insert(left.end(), left_in_range.begin(), left_in_range.end());
    });
    return left;
  }

  // To be called for the vertices that were returned.
  void set_arc(vertex_descriptor v, std::uint32_t arc) { set_mark(index(v), arc); }

  // The arc of the vertex with some index, or `no_arc` if it has not been found, or is a node.
  std::uint32_t arc(std::size_t i) const
  {
    const std::uint32_t m = mark(i);
    return m < NODE ? m : no_arc;
  }

private:
  // What is known of a vertex: its arc, or its node, beside NODE.
  enum Mark : std::uint32_t {
    NODE = std::uint32_t(1) << 31,
    LEFT = no_arc - 1, // its neighbors have not told
    UNKNOWN = no_arc
  };

  // In the place of an arc, if several begin at a node.
  static constexpr std::uint32_t SEVERAL = no_arc - 1;

  // A node at which several arcs begin.
  struct Split
  {
    std::uint32_t node;
    std::size_t wedges_begin, wedges_end; // in the list of wedges
    std::uint32_t longest; // the arc of the vertices that the level set above does not tell of
  };

  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  std::uint32_t mark(std::size_t i) const { return m_marks[i].load(std::memory_order_relaxed); }
  void set_mark(std::size_t i, std::uint32_t mark)
  {
    m_marks[i].store(mark, std::memory_order_relaxed);
  }

  // ---- what a neighbor tells

  bool is_below_upper_end(vertex_descriptor v, const FT& value, std::uint32_t arc) const
  {
    const FT& upper = m_upper_values[arc];
    if (value < upper)
      return true;
    return !(upper < value) && m_order(v, m_list.nodes[m_list.arcs[arc].upper]);
  }

  // So many nodes on the way along one edge are passed: there may be many on steep ones.
  static constexpr int longest_way = 64;

  // The arc of a vertex if an edge leads to it from an arc below.
  std::uint32_t arc_from(std::uint32_t arc, vertex_descriptor v) const
  {
    const FT value = m_order.value(v);
    for (int i = 0; arc < SEVERAL && i < longest_way; ++i) {
      if (is_below_upper_end(v, value, arc))
        return arc;
      arc = m_arc_above[m_list.arcs[arc].upper];
    }
    return no_arc;
  }

  // Notes the arc of a vertex to which an edge leads from an arc below.
  void lead(std::uint32_t arc, vertex_descriptor v, std::vector<vertex_descriptor>& left)
  {
    const std::size_t i = index(v);
    if (mark(i) != UNKNOWN) {
      CGAL_assertion(mark(i) >= NODE || mark(i) == arc ||
                     !is_below_upper_end(v, m_order.value(v), arc));
      return;
    }
    arc = arc_from(arc, v);
    if (arc == no_arc)
      left.push_back(v);
    set_mark(i, arc == no_arc ? std::uint32_t(LEFT) : arc);
  }

  // ---- spreading

  std::vector<Split> splits() const
  {
    std::vector<Split> result;
    const auto& wedges = m_list.upper_wedges;
    for (std::size_t begin = 0, end; begin < wedges.size(); begin = end) {
      const vertex_descriptor v = target(wedges[begin].halfedge, m_tmesh);
      for (end = begin + 1; end < wedges.size() && target(wedges[end].halfedge, m_tmesh) == v;)
        ++end;
      const std::uint32_t m = mark(index(v));
      if (m < LEFT)
        result.push_back({m & ~NODE, begin, end, SEVERAL});
    }
    return result;
  }

  // Finds the arcs of the vertices that edges lead to from below the splits, but for those in the
  // longest components of the level sets.
  void
  lead_above(std::vector<Split> splits, std::size_t budget, std::vector<vertex_descriptor>& left)
  {
    std::vector<vertex_descriptor> vertices(splits.size());
    for_each_range<ConcurrencyTag>(splits.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<vertex_descriptor> waiting;
      for (std::size_t i = begin; i < end; ++i)
        vertices[i] =
            flood(splits[i], waiting) ? Graph_traits::null_vertex() : m_list.nodes[splits[i].node];
    });
    Finder finder(ABOVE, m_tmesh, m_order, m_has_border);
    std::int64_t steps = static_cast<std::int64_t>(budget);
    finder.find(vertices, steps);
    // from the highest one on: where an edge crosses the level sets of several, the last one counts
    for (std::size_t k = splits.size(); k-- > 0;) {
      Split& split = splits[k];
      const auto& found = finder.components[k];
      std::vector<std::uint32_t> arcs; // by wedge
      if (!found.component_of_wedge.empty())
        arcs = arcs_of_wedges(split);
      CGAL_assertion(arcs.size() == found.component_of_wedge.size());
      if (found.longest != no_node)
        split.longest = arcs[found.longest];
      m_arc_above[split.node] = split.longest;
      for (std::size_t i = split.wedges_begin; i < split.wedges_end; ++i) {
        const auto& wedge = m_list.upper_wedges[i];
        for_each_edge_of_upper_wedge(wedge.halfedge, m_tmesh, m_order, [&](halfedge_descriptor h) {
          lead(wedge.arc, source(h, m_tmesh), left);
        });
      }
      for (std::size_t i = found.crossed_begin; i < found.crossed_end; ++i)
        lead(arcs[finder.crossed[i].component], target(finder.crossed[i].halfedge, m_tmesh), left);
    }
  }

  // The arcs of the upper wedges of a split, in the order around its vertex.
  std::vector<std::uint32_t> arcs_of_wedges(const Split& split)
  {
    std::vector<std::uint32_t> result;
    m_star.read(m_list.nodes[split.node], m_tmesh, m_order);
    for (const auto& wedge : m_star.wedges)
      for (std::size_t i = split.wedges_begin; wedge.is_upper && i < split.wedges_end; ++i)
        if (m_list.upper_wedges[i].halfedge == m_star.halfedges[wedge.begin])
          result.push_back(m_list.upper_wedges[i].arc);
    return result;
  }

  // Above splits that noise makes there is often a peak of few vertices: these are found from the
  // peak down faster than by a walk. Returns false if two arcs are left above the split.
  bool flood(Split& split, std::vector<vertex_descriptor>& waiting)
  {
    std::uint32_t rest = no_arc;
    for (std::size_t i = split.wedges_begin; i < split.wedges_end; ++i) {
      const std::uint32_t arc = m_list.upper_wedges[i].arc;
      if (arc == rest || (is_peak(arc) && flood(arc, waiting)))
        continue;
      if (rest != no_arc)
        return false;
      rest = arc;
    }
    split.longest = rest;
    return true;
  }

  bool flood(std::uint32_t arc, std::vector<vertex_descriptor>& waiting)
  {
    constexpr std::size_t few = 16;
    const vertex_descriptor split = m_list.nodes[m_list.arcs[arc].lower];
    waiting.assign(1, m_list.nodes[m_list.arcs[arc].upper]);
    std::size_t size = 0;
    while (!waiting.empty() && size < few) {
      const vertex_descriptor v = waiting.back();
      waiting.pop_back();
      for_each_neighbor(v, m_tmesh, [&](vertex_descriptor neighbor) {
        const std::size_t i = index(neighbor);
        if (mark(i) != UNKNOWN || !m_order(split, neighbor))
          return;
        set_mark(i, arc);
        waiting.push_back(neighbor);
        ++size;
      });
    }
    return waiting.empty();
  }

  bool is_peak(std::uint32_t arc) const
  {
    const std::uint32_t upper = m_list.arcs[arc].upper;
    return m_arc_above[upper] == no_arc && !m_has_several_below[upper];
  }

  // Goes down from a vertex as far as nothing is known, and back.
  void descend(vertex_descriptor v,
               std::vector<vertex_descriptor>& way,
               std::vector<vertex_descriptor>& left)
  {
    std::uint32_t m = UNKNOWN;
    while (m == UNKNOWN) {
      way.push_back(v);
      v = m_neighbors[index(v)].below;
      m = v == Graph_traits::null_vertex() ? std::uint32_t(LEFT) : mark(index(v));
    }
    std::uint32_t arc = m < NODE ? m : m < LEFT ? m_arc_above[m & ~NODE] : no_arc;
    for (; !way.empty(); way.pop_back()) {
      v = way.back();
      arc = arc_from(arc, v);
      if (arc == no_arc && !has_no_edge(v, m_tmesh))
        left.push_back(v);
      set_mark(index(v), arc == no_arc ? std::uint32_t(LEFT) : arc);
    }
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const std::vector<Monotone_neighbors<TriangleMesh>>& m_neighbors; // by vertex index
  const bool m_has_border;
  const Arc_list<TriangleMesh>& m_list;
  std::vector<std::uint32_t> m_arc_above; // the node, if there is one, or all others are known
  std::vector<bool> m_has_several_below;  // by node: arcs
  std::vector<FT> m_upper_values;         // by arc
  std::vector<std::atomic<std::uint32_t>> m_marks; // by vertex index
  Vertex_star<TriangleMesh> m_star;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_ARC_PROPAGATION_H
