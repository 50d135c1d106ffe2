// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LEVEL_BAND_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LEVEL_BAND_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Critical_nodes.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Leaf_pruning.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Level_set_walk.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Merge_forest.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Sweep.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/component_merging.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/concurrency.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/in_turn.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/mesh_helpers.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/sorted_vertices.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Computes the Reeb graph of a surface without border on which the nodes below which there may be
// loops lie between two levels: with a sweep from one to the other, and without any walk above and
// below.
//
// The band between the two levels is cut out of the surface. What is left has no loops, and its
// Reeb graph follows from its merge forests (see Leaf_pruning): every component of the lower level
// set is a maximum there, and every one of the upper level set a minimum. The sweep through the
// band begins with the former and ends with the latter, where the arcs are put together.
//
// Two components of the lower (upper) level set never lie in the same component X of the sublevel
// set and in the same component Y of the superlevel set: a node below (above) at which they part
// would be one that may have loops. So they are named by pairs (X, Y), which the forests of the
// whole surface tell.
//
// Takes O(n) time for n vertices, and O(m log m) for m nodes, and vertices and crossed edges in the
// band.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Level_band
{
  using Nodes = Critical_nodes<TriangleMesh, VertexOrder, VertexIndexMap>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;
  using halfedge_descriptor = typename Nodes::halfedge_descriptor;

public:
  // `may_have_loops` holds the nodes below which there may be loops, in increasing order, at least
  // one.
  Level_band(const TriangleMesh& tmesh,
             const VertexOrder& order,
             VertexIndexMap vertex_index_map,
             std::size_t index_bound,
             const Nodes& nodes,
             const std::vector<std::uint32_t>& may_have_loops,
             bool unfolds)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_index_bound(index_bound)
    , m_nodes(nodes)
    , m_first(may_have_loops.front())
    , m_end(may_have_loops.back() + 1)
    , m_unfolds(unfolds)
  {
    while (!nodes.is_first_of_vertex(m_first))
      --m_first;
    while (m_end < nodes.size() && !nodes.is_first_of_vertex(m_end))
      ++m_end;
  }

  // Writes nodes and arcs. The forests are those of the whole surface, and are changed. Returns
  // false if there are more vertices in the band than that.
  bool run(Merge_forest& sublevel_forest,
           Merge_forest& superlevel_forest,
           std::size_t largest_number_of_vertices,
           Arc_list<TriangleMesh>& result)
  {
    std::vector<vertex_descriptor> vertices_of_band;
    if (!find_vertices(largest_number_of_vertices, vertices_of_band))
      return false;
    cut_out(sublevel_forest, superlevel_forest);
    const std::vector<Leaf_pruning::Arc> outer_arcs =
        find_outer_arcs(sublevel_forest, superlevel_forest);

    const auto halfedge_index_map = CGAL::get_initialized_halfedge_index_map(m_tmesh);
    Reeb_graph_request request;
    request.unfolds = m_unfolds;
    request.has_vertex_arcs = false;
    Sweep<TriangleMesh, VertexOrder, VertexIndexMap, std::decay_t<decltype(halfedge_index_map)>>
        sweep(m_tmesh, m_order, m_vertex_index_map, m_index_bound, halfedge_index_map, request);
    add_lower_components(sweep);
    if (sweep.pass_vertices(vertices_of_band) != number_of_edges_around_band())
      throw_several_fans();
    write(outer_arcs, sweep, result);
    return true;
  }

private:
  // A way from a node through one of its wedges across a level. The component of the level set that
  // is crossed lies in one component of the sublevel set and one of the superlevel set, which are
  // named by their last nodes.
  struct Way
  {
    std::uint32_t below, above;
    std::uint32_t wedge;
    std::uint32_t node;
  };

  // ---- the two levels

  bool is_below_band(vertex_descriptor v) const { return m_order(v, m_nodes.vertex[m_first]); }
  bool is_above_band(vertex_descriptor v) const { return m_order(m_nodes.vertex[m_end - 1], v); }

  bool find_vertices(std::size_t largest_number, std::vector<vertex_descriptor>& result) const
  {
    for (const vertex_descriptor v : CGAL::make_range(vertices(m_tmesh))) {
      if (is_below_band(v) || is_above_band(v))
        continue;
      if (result.size() == largest_number)
        return false;
      result.push_back(v);
    }
    sort_vertices<ConcurrencyTag>(result, m_order);
    return true;
  }

  // Counted by the halfedges that point to the vertices: a circulation would not see all of them if
  // the faces around a vertex form several fans.
  std::size_t number_of_edges_around_band() const
  {
    std::size_t result = 0;
    for (const halfedge_descriptor h : CGAL::make_range(halfedges(m_tmesh))) {
      const vertex_descriptor v = target(h, m_tmesh);
      if (!is_below_band(v) && !is_above_band(v))
        ++result;
    }
    return result;
  }

  // For every node below `end` the last one that lies there in its component of the sublevel set.
  static std::vector<std::uint32_t> last_nodes_below(std::uint32_t end, const Merge_forest& forest)
  {
    std::vector<std::uint32_t> result(end);
    for (std::uint32_t node = end; node-- > 0;) {
      const std::uint32_t parent = forest.parent(node);
      result[node] = parent < end ? result[parent] : node;
    }
    return result;
  }

  // For every node from `begin` on the last one that lies there, on the way down, in its component
  // of the superlevel set. The elements before it mean nothing.
  std::vector<std::uint32_t> last_nodes_above(std::uint32_t begin, const Merge_forest& forest) const
  {
    std::vector<std::uint32_t> result(m_nodes.size());
    for (std::uint32_t node = begin; node < m_nodes.size(); ++node) {
      const std::uint32_t parent = forest.parent(node);
      result[node] = parent != no_node && parent >= begin ? result[parent] : node;
    }
    return result;
  }

  // Counting sort by numbers below the number of nodes; keeps the order of equal ones.
  template <class Number>
  void sort_by(std::vector<Way>& ways, const Number& number) const
  {
    std::vector<std::uint32_t> begin(m_nodes.size() + 1, 0);
    for (const Way& way : ways)
      ++begin[number(way) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Way> sorted(ways.size());
    for (const Way& way : ways)
      sorted[begin[number(way)]++] = way;
    ways = std::move(sorted);
  }

  // Returns a way for every component of the level set, and tells every wedge the number of its
  // component.
  template <class SetComponent>
  std::vector<Way> components(std::vector<Way>& ways, const SetComponent& set_component) const
  {
    sort_by(ways, [](const Way& way) { return way.above; });
    sort_by(ways, [](const Way& way) { return way.below; });
    std::vector<Way> result;
    for (const Way& way : ways) {
      if (result.empty() || result.back().below != way.below || result.back().above != way.above)
        result.push_back(way);
      set_component(way.wedge, static_cast<std::uint32_t>(result.size() - 1));
    }
    return result;
  }

  // Finds the components of the lower level set. Returns the ends of the upper wedges of the nodes
  // below the band: those that lead into it, or across, end at a component.
  std::vector<std::uint32_t>
  find_lower_components(const Merge_forest& sublevel_forest, const Merge_forest& superlevel_forest)
  {
    const std::vector<std::uint32_t> last_below = last_nodes_below(m_first, sublevel_forest);
    const std::vector<std::uint32_t> last_above = last_nodes_above(m_first, superlevel_forest);
    std::vector<std::uint32_t> ends(m_nodes.upper_end.begin(),
                                    m_nodes.upper_end.begin() + m_nodes.upper_begin[m_first]);
    std::vector<Way> ways;
    for (std::uint32_t node = 0; node < m_first; ++node)
      for (std::uint32_t w = m_nodes.upper_begin[node]; w < m_nodes.upper_begin[node + 1]; ++w)
        if (ends[w] >= m_first)
          ways.push_back({last_below[node], last_above[ends[w]], w, node});
    m_lower_components = components(
        ways, [&](std::uint32_t wedge, std::uint32_t i) { ends[wedge] = lower_component(i); });
    return ends;
  }

  // The same for the upper level set, and the lower wedges of the nodes above the band; the first
  // elements mean nothing. To be called after `find_lower_components()`.
  std::vector<std::uint32_t>
  find_upper_components(const Merge_forest& sublevel_forest, const Merge_forest& superlevel_forest)
  {
    const std::vector<std::uint32_t> last_below = last_nodes_below(m_end, sublevel_forest);
    const std::vector<std::uint32_t> last_above = last_nodes_above(m_end, superlevel_forest);
    std::vector<std::uint32_t> ends = m_nodes.lower_end;
    std::vector<Way> ways;
    for (std::uint32_t node = m_end; node < m_nodes.size(); ++node)
      for (std::uint32_t w = m_nodes.lower_begin[node]; w < m_nodes.lower_begin[node + 1]; ++w)
        if (ends[w] < m_end)
          ways.push_back({last_below[ends[w]], last_above[node], w, node});
    m_upper_components = components(
        ways, [&](std::uint32_t wedge, std::uint32_t i) { ends[wedge] = upper_component(i); });
    return ends;
  }

  // ---- the surface outside of the band

  // The components of the two level sets as nodes, with numbers beyond those of all nodes.
  std::uint32_t lower_component(std::size_t i) const
  {
    return static_cast<std::uint32_t>(m_nodes.size() + i);
  }
  std::uint32_t upper_component(std::size_t i) const
  {
    return lower_component(m_lower_components.size() + i);
  }
  bool is_lower_component(std::uint32_t node) const
  {
    return node >= m_nodes.size() && node < upper_component(0);
  }
  bool is_upper_component(std::uint32_t node) const { return node >= upper_component(0); }

  // Turns the forests of the whole surface into those of the surface outside of the band. That of
  // sublevel sets stays as it is below the band, and the components of the lower level set follow:
  // where several of them bound one component of the sublevel set, one after the other. Above the
  // band all begins anew. The other forest alike.
  void cut_out(Merge_forest& sublevel_forest, Merge_forest& superlevel_forest)
  {
    const std::vector<std::uint32_t> upper_end =
        find_lower_components(sublevel_forest, superlevel_forest);
    const std::vector<std::uint32_t> lower_end =
        find_upper_components(sublevel_forest, superlevel_forest);
    for (std::uint32_t node = 0; node < m_first; ++node)
      m_sequence.push_back(node);
    for (std::size_t i = 0; i < m_lower_components.size(); ++i)
      m_sequence.push_back(lower_component(i));
    const std::ptrdiff_t number_below_band = static_cast<std::ptrdiff_t>(m_sequence.size());
    for (std::size_t i = 0; i < m_upper_components.size(); ++i)
      m_sequence.push_back(upper_component(i));
    for (std::uint32_t node = m_end; node < m_nodes.size(); ++node)
      m_sequence.push_back(node);

    const std::size_t number_of_names = upper_component(m_upper_components.size());
    sublevel_forest.resize(number_of_names);
    superlevel_forest.resize(number_of_names);
    sublevel_forest.clear(m_first, m_nodes.size());
    superlevel_forest.clear(0, m_end);
    std::vector<std::uint32_t> last(m_nodes.size());
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 0; i < m_lower_components.size(); ++i) {
      std::uint32_t& below = last[m_lower_components[i].below];
      sublevel_forest.attach(below, lower_component(i));
      below = lower_component(i);
    }
    for (std::size_t i = m_upper_components.size(); i-- > 0;) {
      std::uint32_t& above = last[m_upper_components[i].above];
      superlevel_forest.attach(above, upper_component(i));
      above = upper_component(i);
    }
    invoke_both<ConcurrencyTag>(
        [&]() {
          merge_components(m_sequence.begin() + number_below_band,
                           m_sequence.end(),
                           m_nodes.lower_begin,
                           lower_end,
                           sublevel_forest,
                           Ignore_components());
        },
        [&]() {
          merge_components(m_sequence.rend() - number_below_band,
                           m_sequence.rend(),
                           m_nodes.upper_begin,
                           upper_end,
                           superlevel_forest,
                           Ignore_components());
        });
  }

  // Whether the parent of a node outside of the band is a node on the other side of the near level.
  bool is_cut_off(std::uint32_t node, const Merge_forest& forest) const
  {
    const std::uint32_t parent = forest.parent(node);
    return parent < m_nodes.size() && (node < m_first ? parent >= m_first : parent < m_end);
  }

  std::vector<Leaf_pruning::Arc>
  find_outer_arcs(Merge_forest& sublevel_forest, Merge_forest& superlevel_forest)
  {
    m_is_regular.resize(sublevel_forest.size());
    m_number_above.resize(m_nodes.size());
    for (const std::uint32_t node : m_sequence) {
      m_is_regular[node] = sublevel_forest.degree(node) == 1 && superlevel_forest.degree(node) == 1;
      if (node >= m_nodes.size())
        continue;
      m_number_above[node] = superlevel_forest.degree(node);
      // a path from the parent has crossed the level, but none from the node's component has
      if (is_cut_off(node, node < m_first ? sublevel_forest : superlevel_forest))
        throw_several_fans();
    }
    Leaf_pruning pruning(sublevel_forest, superlevel_forest);
    pruning.run(m_sequence, [&](std::uint32_t node) { return m_is_regular[node]; });
    return std::move(pruning.arcs);
  }

  // ---- the sweep through the band

  // Follows the path through the wedge of every component up or down to the level that the
  // component lies in, and finds the edges that cross the level there, as halfedges that point
  // upwards. Such a path was first found as one of Monotone_paths: it goes around the vertices the
  // same way, so it meets no node.
  template <class IsBeyond>
  std::vector<halfedge_descriptor>
  crossed_edges(Side side, const std::vector<Way>& components, const IsBeyond& is_beyond) const
  {
    struct Path
    {
      std::size_t component;
      vertex_descriptor vertex;
      halfedge_descriptor edge; // the next one to be looked at, points to the vertex
      // what is read before the look
      vertex_descriptor neighbor;
      halfedge_descriptor next_edge;
      bool is_neighbor_on_side, is_neighbor_beyond;
    };
    const auto& halfedge_of_wedge = side == ABOVE ? m_nodes.upper_halfedge : m_nodes.lower_halfedge;
    std::vector<halfedge_descriptor> result(components.size());
    std::vector<Path> paths((std::min)(components.size(), number_of_tasks_in_turn));
    std::size_t next_component = 0;
    in_turn(
        paths,
        [&](Path& path) {
          if (next_component == components.size())
            return false;
          path.component = next_component;
          path.vertex = m_nodes.vertex[components[next_component].node];
          path.edge = halfedge_of_wedge[components[next_component].wedge];
          ++next_component;
          return true;
        },
        [&](Path& path) {
          if (!path.is_neighbor_on_side) {
            path.edge = path.next_edge;
          } else if (!path.is_neighbor_beyond) {
            path.vertex = path.neighbor;
            path.edge = halfedge(path.vertex, m_tmesh);
          } else {
            result[path.component] = side == ABOVE ? opposite(path.edge, m_tmesh) : path.edge;
            return false;
          }
          return true;
        },
        [&](Path& path) {
          path.neighbor = source(path.edge, m_tmesh);
          path.next_edge = opposite(next(path.edge, m_tmesh), m_tmesh);
        },
        [&](Path& path) {
          path.is_neighbor_on_side = side == ABOVE ? m_order(path.vertex, path.neighbor)
                                                   : m_order(path.neighbor, path.vertex);
          path.is_neighbor_beyond = is_beyond(path.neighbor);
        });
    return result;
  }

  // Adds the components of the lower level set, all edges of which are walked along.
  template <class Sweep>
  void add_lower_components(Sweep& sweep)
  {
    struct Task
    {
      std::size_t component;
      Level_set_walk<TriangleMesh> walk = Level_set_walk<TriangleMesh>(halfedge_descriptor(), true);
      bool has_upper_end_in_band;
      std::vector<halfedge_descriptor> edges;
      // what is read before a step
      typename Level_set_walk<TriangleMesh>::Crossing crossing;
      bool is_above, is_in_band;
    };
    const std::vector<halfedge_descriptor> first = crossed_edges(
        ABOVE, m_lower_components, [this](vertex_descriptor v) { return !is_below_band(v); });
    m_arc_of_lower_component.resize(first.size());
    std::vector<Task> tasks((std::min)(first.size(), number_of_tasks_in_turn));
    std::size_t next_component = 0;
    in_turn(
        tasks,
        [&](Task& task) {
          if (next_component == first.size())
            return false;
          task.component = next_component++;
          task.walk = Level_set_walk<TriangleMesh>(first[task.component], true);
          task.edges.clear();
          task.has_upper_end_in_band = !is_above_band(target(first[task.component], m_tmesh));
          return true;
        },
        [&](Task& task) {
          if (task.has_upper_end_in_band)
            task.edges.push_back(task.walk.halfedge());
          task.walk.cross(task.crossing, task.is_above, m_tmesh);
          if (task.is_above)
            task.has_upper_end_in_band = task.is_in_band;
          if (task.walk.halfedge() != first[task.component])
            return true;
          if (task.edges.empty()) // the component crosses the band unchanged
            task.edges.push_back(task.walk.halfedge());
          m_arc_of_lower_component[task.component] = sweep.add_component(task.edges);
          return false;
        },
        [&](Task& task) { task.crossing = task.walk.crossing(m_tmesh); },
        [&](Task& task) {
          task.is_above = !is_below_band(task.crossing.vertex);
          task.is_in_band = !is_above_band(task.crossing.vertex);
        });
  }

  // The arcs of the sweep that the components of the upper level set belong to. Each is walked
  // along up to an edge that the sweep knows.
  template <class Sweep>
  std::vector<std::uint32_t> arcs_of_upper_components(Sweep& sweep) const
  {
    struct Task
    {
      std::size_t component;
      Level_set_walk<TriangleMesh> walk = Level_set_walk<TriangleMesh>(halfedge_descriptor(), true);
    };
    const auto is_above = [this](vertex_descriptor v) { return is_above_band(v); };
    const std::vector<halfedge_descriptor> first =
        crossed_edges(BELOW, m_upper_components, [&](vertex_descriptor v) { return !is_above(v); });
    std::vector<std::uint32_t> result(first.size());
    std::vector<Task> tasks((std::min)(first.size(), number_of_tasks_in_turn));
    std::size_t next_component = 0;
    in_turn(
        tasks,
        [&](Task& task) {
          if (next_component == first.size())
            return false;
          task.component = next_component++;
          task.walk = Level_set_walk<TriangleMesh>(first[task.component], true);
          return true;
        },
        [&](Task& task) {
          if (sweep.is_known(task.walk.halfedge())) {
            result[task.component] = sweep.arc(task.walk.halfedge());
            return false;
          }
          task.walk.step(m_tmesh, is_above);
          if (task.walk.halfedge() == first[task.component])
            throw_several_fans();
          return true;
        });
    return result;
  }

  // The node above the band that every arc of the sweep leads to, or the node of the sweep at which
  // it ends.
  template <class Sweep>
  std::vector<std::uint32_t> upper_ends(const std::vector<Leaf_pruning::Arc>& outer_arcs,
                                        const std::vector<std::uint32_t>& number,
                                        std::uint32_t first_number,
                                        Sweep& sweep) const
  {
    std::vector<std::uint32_t> result;
    result.reserve(sweep.result().arcs.size());
    for (const Arc_ends& arc : sweep.result().arcs)
      result.push_back(arc.upper == no_node ? no_node : first_number + arc.upper);
    const std::vector<std::uint32_t> arc_of_upper_component = arcs_of_upper_components(sweep);
    for (const Leaf_pruning::Arc& arc : outer_arcs) {
      if (!is_upper_component(arc.lower))
        continue;
      std::uint32_t& upper = result[arc_of_upper_component[arc.lower - upper_component(0)]];
      if (upper != no_node)
        throw_several_fans();
      upper = number[arc.upper];
    }
    if (std::find(result.begin(), result.end(), no_node) != result.end())
      throw_several_fans();
    return result;
  }

  // ---- the result

  template <class Sweep>
  void write(const std::vector<Leaf_pruning::Arc>& outer_arcs,
             Sweep& sweep,
             Arc_list<TriangleMesh>& result) const
  {
    const Arc_list<TriangleMesh>& inner = sweep.result();
    const std::uint32_t number_of_lower_components =
        static_cast<std::uint32_t>(m_lower_components.size());
    std::vector<std::uint32_t> number(m_nodes.size(), no_node), first_arc(m_nodes.size(), no_arc);
    std::uint32_t number_of_arcs = 0;
    const auto add_outer_node = [&](std::uint32_t node) {
      if (m_is_regular[node])
        return;
      number[node] = static_cast<std::uint32_t>(result.nodes.size());
      result.nodes.push_back(m_nodes.vertex[node]);
      first_arc[node] = number_of_arcs;
      number_of_arcs += m_number_above[node];
    };
    for (std::uint32_t node = 0; node < m_first; ++node)
      add_outer_node(node);
    const std::uint32_t first_inner_number = static_cast<std::uint32_t>(result.nodes.size());
    result.nodes.insert(result.nodes.end(), inner.nodes.begin(), inner.nodes.end());
    // the first arcs of the sweep are those that begin below it
    const std::uint32_t first_inner_arc = number_of_arcs;
    number_of_arcs += static_cast<std::uint32_t>(inner.arcs.size()) - number_of_lower_components;
    for (std::uint32_t node = m_end; node < m_nodes.size(); ++node)
      add_outer_node(node);

    const std::vector<std::uint32_t> upper_end =
        upper_ends(outer_arcs, number, first_inner_number, sweep);
    result.arcs.resize(number_of_arcs);
    for (const Leaf_pruning::Arc& arc : outer_arcs) {
      if (is_upper_component(arc.lower))
        continue;
      const std::uint32_t upper =
          is_lower_component(arc.upper)
              ? upper_end[m_arc_of_lower_component[arc.upper - lower_component(0)]]
              : number[arc.upper];
      result.arcs[first_arc[arc.lower] + arc.position] = {number[arc.lower], upper};
    }
    for (std::uint32_t a = number_of_lower_components; a < inner.arcs.size(); ++a)
      result.arcs[first_inner_arc + a - number_of_lower_components] = {
          first_inner_number + inner.arcs[a].lower, upper_end[a]};
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const std::size_t m_index_bound;
  const Nodes& m_nodes;
  std::uint32_t m_first, m_end; // the nodes in the band
  const bool m_unfolds;
  std::vector<Way> m_lower_components, m_upper_components; // of the two level sets
  std::vector<std::uint32_t> m_arc_of_lower_component;     // in the sweep
  std::vector<std::uint32_t> m_sequence;     // the nodes outside of the band, and these components
  std::vector<bool> m_is_regular;            // of these
  std::vector<std::uint32_t> m_number_above; // of arcs, by node
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LEVEL_BAND_H
