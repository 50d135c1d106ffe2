// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODE_FINDER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODE_FINDER_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Critical_nodes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Monotone_paths.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds the critical nodes.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
class Critical_node_finder
{
  using Nodes = Critical_nodes<TriangleMesh>;
  using vertex_descriptor = typename Nodes::vertex_descriptor;
  using halfedge_descriptor = typename Nodes::halfedge_descriptor;
  using Paths = Monotone_paths<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap>;
  using Star = Vertex_star<TriangleMesh>;

public:
  Critical_node_finder(const TriangleMesh& tmesh,
                       const VertexOrder& order,
                       VertexIndexMap vertex_index_map,
                       const Vertex_classification& states,
                       bool unfolds)
    : m_tmesh(tmesh)
    , m_order(order)
    , m_vertex_index_map(vertex_index_map)
    , m_states(states)
    , m_unfolds(unfolds)
  {}

  void find(Nodes& nodes, Paths& descents, Paths& ascents) const
  {
    list_nodes(nodes, descents, ascents);
    {
      // the first edges of the lower wedges are needed for the paths only
      std::vector<halfedge_descriptor> lower_halfedge(nodes.lower_end.size(), null_halfedge());
      for_each_range<ConcurrencyTag>(nodes.size(), [&](std::size_t begin, std::size_t end) {
        Reader reader = {nodes, lower_halfedge, Star(), {}};
        for (std::size_t i = begin; i < end; ++i)
          read_wedges(static_cast<std::uint32_t>(i), reader);
      });
      find_ends(follow(lower_halfedge, descents), descents, nodes.lower_end);
    }
    nodes.upper_path = follow(nodes.upper_halfedge, ascents);
    find_ends(nodes.upper_path, ascents, nodes.upper_end);
    renumber(nodes, sorted_positions<ConcurrencyTag>(nodes.vertex, m_order));
  }

  // Finds the ends of the upward paths again, when there are cuts.
  void cut_ascents(Nodes& nodes, Paths& ascents, std::vector<typename Paths::Cut>&& cuts) const
  {
    ascents.set_cuts(std::move(cuts));
    for (std::size_t w = 0; w < nodes.upper_end.size(); ++w)
      if (nodes.upper_path[w] != Paths::no_path)
        nodes.upper_end[w] = nodes.number_of_end(ascents.end(nodes.upper_path[w]));
  }

private:
  // What reading the wedges of nodes needs, for every thread.
  struct Reader
  {
    Nodes& nodes;
    std::vector<halfedge_descriptor>& lower_halfedge;
    Star star;
    std::vector<Lowest_vertex<vertex_descriptor>> upper_wedges;
  };

  static halfedge_descriptor null_halfedge()
  {
    return boost::graph_traits<TriangleMesh>::null_halfedge();
  }

  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  void list_nodes(Nodes& nodes, Paths& descents, Paths& ascents) const
  {
    nodes.lower_begin.push_back(0);
    nodes.upper_begin.push_back(0);
    Star star;
    for (const vertex_descriptor v : CGAL::make_range(vertices(m_tmesh))) {
      const std::size_t i = index(v);
      if (m_states.is_regular(i))
        continue;
      std::size_t lower = m_states.number_of_changes(i) / 2, upper = lower;
      std::size_t number = 1;
      if (m_states.is_extremum(i) && !has_no_edge(v, m_tmesh)) {
        (m_order(v, source(halfedge(v, m_tmesh), m_tmesh)) ? upper : lower) = 1;
      } else if (m_states.is_on_border(i) || lower == 0 ||
                 !m_states.is_number_of_changes_exact(i) || (m_unfolds && lower > 2))
      {
        if (has_no_edge(v, m_tmesh))
          m_order.check_value(v); // all others are checked by the comparisons
        star.read(v, m_tmesh, m_order);
        lower = star.number_of_wedges(false);
        upper = star.number_of_wedges(true);
        if (lower == 1 && upper == 1)
          continue;
        if (m_unfolds)
          number = star.number_of_simple_saddles();
      }
      const std::uint32_t node = static_cast<std::uint32_t>(nodes.size());
      descents.set_node(v, node);
      ascents.set_node(v, node);
      for (std::size_t k = 0; k < number; ++k) {
        nodes.vertex.push_back(v);
        nodes.lower_begin.push_back(nodes.lower_begin.back() +
                                    static_cast<std::uint32_t>(number > 1 ? 2 : lower));
        nodes.upper_begin.push_back(nodes.upper_begin.back() +
                                    static_cast<std::uint32_t>(number > 1 ? 2 : upper));
      }
    }
    nodes.lower_end.resize(nodes.lower_begin.back());
    nodes.upper_end.resize(nodes.upper_begin.back());
    nodes.upper_halfedge.resize(nodes.upper_begin.back(), null_halfedge());
  }

  // Follows the paths through the wedges, and returns their numbers. A way from a node to another
  // one of the same vertex has no edge, and no path.
  std::vector<std::uint32_t>
  follow(const std::vector<halfedge_descriptor>& halfedges, Paths& paths) const
  {
    std::vector<std::uint32_t> path_of_wedge(halfedges.size(), Paths::no_path);
    std::vector<vertex_descriptor> starts;
    starts.reserve(halfedges.size());
    for (std::size_t w = 0; w < halfedges.size(); ++w)
      if (halfedges[w] != null_halfedge()) {
        path_of_wedge[w] = static_cast<std::uint32_t>(starts.size()); // these are the first paths
        starts.push_back(source(halfedges[w], m_tmesh));
      }
    paths.follow(starts);
    return path_of_wedge;
  }

  void find_ends(const std::vector<std::uint32_t>& path_of_wedge,
                 Paths& paths,
                 std::vector<std::uint32_t>& ends) const
  {
    for (std::size_t w = 0; w < ends.size(); ++w)
      if (path_of_wedge[w] != Paths::no_path)
        ends[w] = paths.end(path_of_wedge[w]);
  }

  void read_wedges(std::uint32_t node, Reader& reader) const
  {
    Nodes& nodes = reader.nodes;
    Star& star = reader.star;
    if (nodes.is_unfolded(node)) {
      if (nodes.is_first_of_vertex(node))
        read_unfolded_wedges(node, reader);
      return;
    }
    star.read(nodes.vertex[node], m_tmesh, m_order);
    std::uint32_t lower = nodes.lower_begin[node], upper = nodes.upper_begin[node];
    // the pass over the faces may have seen more than one fan
    if (star.number_of_wedges(false) != nodes.lower_begin[node + 1] - lower ||
        star.number_of_wedges(true) != nodes.upper_begin[node + 1] - upper)
      throw_internal_error("the edges around a vertex do not fit its faces");

    const bool sorts = nodes.upper_begin[node + 1] - upper > 1;
    reader.upper_wedges.clear();
    for (const auto& wedge : star.wedges) {
      const halfedge_descriptor h = star.halfedges[wedge.begin];
      if (!wedge.is_upper)
        reader.lower_halfedge[lower++] = h;
      else
        reader.upper_wedges.push_back(
            {source(sorts ? star.lowest_edge(wedge, m_tmesh, m_order) : h, m_tmesh), wedge.begin});
    }
    if (sorts)
      sort_by_lowest_vertices(reader.upper_wedges, m_order);
    for (const auto& wedge : reader.upper_wedges)
      nodes.upper_halfedge[upper++] = star.halfedges[wedge.position];
  }

  // Around the vertex there are the wedges L1 U1 L2 U2 ... Lk Uk. The first simple saddle joins L1
  // and L2 across U1 to one strand that passes by the vertex; saddle i joins that strand and L(i +
  // 1) across U(i); what passes by the last one is Uk.
  CGAL_REEB_GRAPH_COLD void read_unfolded_wedges(std::uint32_t first, Reader& reader) const
  {
    Nodes& nodes = reader.nodes;
    Star& star = reader.star;
    star.read(nodes.vertex[first], m_tmesh, m_order);
    star.begin_at_lowest_vertex(m_tmesh, m_order);
    const auto edge = [&](std::size_t wedge) { return star.halfedges[star.wedges[wedge].begin]; };
    const auto lowest = [&](std::size_t wedge) {
      return source(star.lowest_edge(star.wedges[wedge], m_tmesh, m_order), m_tmesh);
    };
    const std::size_t number = star.number_of_simple_saddles();
    CGAL_assertion(star.wedges.size() == 2 * (number + 1));
    for (std::size_t i = 1; i <= number; ++i) {
      const std::uint32_t node = first + static_cast<std::uint32_t>(i - 1);
      std::uint32_t lower = nodes.lower_begin[node], upper = nodes.upper_begin[node];
      if (i > 1)
        nodes.lower_end[lower++] = node - 1;
      else
        reader.lower_halfedge[lower++] = edge(0);
      reader.lower_halfedge[lower] = edge(2 * i);
      std::size_t wedge = 2 * i - 1, other = 2 * i + 1;
      if (i < number) {
        nodes.upper_end[upper++] = node + 1;
        nodes.upper_halfedge[upper] = edge(wedge);
      } else {
        if (m_order(lowest(other), lowest(wedge)))
          std::swap(wedge, other);
        nodes.upper_halfedge[upper++] = edge(wedge);
        nodes.upper_halfedge[upper] = edge(other);
      }
    }
  }

  // The passes over the nodes are much faster if nodes that follow each other lie side by side.
  // `mesh_number` holds their numbers in the order of the mesh.
  void renumber(Nodes& nodes, const std::vector<std::uint32_t>& mesh_number) const
  {
    const std::size_t size = nodes.size();
    nodes.number.resize(size);
    std::vector<vertex_descriptor> vertex(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      nodes.number[mesh_number[i]] = i;
      vertex[i] = nodes.vertex[mesh_number[i]];
      CGAL_assertion(i == 0 || vertex[i - 1] == vertex[i] || m_order(vertex[i - 1], vertex[i]));
    }
    nodes.vertex = std::move(vertex);
    for (std::uint32_t& end : nodes.lower_end)
      end = nodes.number[end];
    for (std::uint32_t& end : nodes.upper_end)
      end = nodes.number[end];
    renumber_wedges(mesh_number, nodes.upper_begin, nodes.upper_halfedge);
    renumber_wedges(mesh_number, nodes.upper_begin, nodes.upper_path);
    std::vector<std::uint32_t> begin =
        renumber_wedges(mesh_number, nodes.upper_begin, nodes.upper_end);
    nodes.upper_begin = std::move(begin);
    begin = renumber_wedges(mesh_number, nodes.lower_begin, nodes.lower_end);
    nodes.lower_begin = std::move(begin);
  }

  // Returns the new beginnings.
  template <class T>
  static std::vector<std::uint32_t> renumber_wedges(const std::vector<std::uint32_t>& mesh_number,
                                                    const std::vector<std::uint32_t>& begin,
                                                    std::vector<T>& of_wedge)
  {
    std::vector<std::uint32_t> new_begin(1, 0);
    new_begin.reserve(begin.size());
    std::vector<T> new_of_wedge;
    new_of_wedge.reserve(of_wedge.size());
    for (const std::uint32_t i : mesh_number) {
      for (std::uint32_t w = begin[i]; w < begin[i + 1]; ++w)
        new_of_wedge.push_back(of_wedge[w]);
      new_begin.push_back(static_cast<std::uint32_t>(new_of_wedge.size()));
    }
    of_wedge = std::move(new_of_wedge);
    return new_begin;
  }

  const TriangleMesh& m_tmesh;
  const VertexOrder& m_order;
  VertexIndexMap m_vertex_index_map;
  const Vertex_classification& m_states;
  const bool m_unfolds;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_CRITICAL_NODE_FINDER_H
