// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_GRAPH_UPDATE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_GRAPH_UPDATE_H

#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/write_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Compacted_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Simplification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Simplification_parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What the keys of a map to arcs are: the vertices, or the faces of a mesh. A vertex of the mesh
// stands for each of them.
template <class TriangleMesh>
struct Vertex_keys
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  static constexpr const char* name = "vertex";
  static constexpr bool has_nodes = true; // some keys are nodes, which have arcs of their own

  static auto keys(const TriangleMesh& tmesh) { return vertices(tmesh); }
  template <class Order>
  static vertex_descriptor vertex(vertex_descriptor v, const TriangleMesh&, const Order&)
  {
    return v;
  }
};

template <class TriangleMesh>
struct Face_keys
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  static constexpr const char* name = "face";
  static constexpr bool has_nodes = false;

  static auto keys(const TriangleMesh& tmesh) { return faces(tmesh); }
  template <class Order>
  static vertex_descriptor vertex(face_descriptor f, const TriangleMesh& tmesh, const Order& order)
  {
    return middle_vertex(f, tmesh, order);
  }
};

// A map to arcs that is brought up to date: checked, read, moved and, when nothing can fail any
// more, written.
template <class TriangleMesh, class Keys, class ArcMap>
class Arc_map_update
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  Arc_map_update(const TriangleMesh& tmesh, ArcMap arc_map) : m_tmesh(tmesh), m_arc_map(arc_map) {}

  void check(std::size_t number_of_arcs) const
  {
    check_arc_numbers(Keys::keys(m_tmesh), number_of_arcs, m_arc_map, Keys::name);
  }

  // `move_to_arcs(list, has_nodes)` moves vertices to the arcs that they belong to now.
  template <class Order, class MoveToArcs>
  void move(const Order& order, const MoveToArcs& move_to_arcs)
  {
    m_vertices = read_arc_numbers<vertex_descriptor>(Keys::keys(m_tmesh), m_arc_map, [&](auto key) {
      return Keys::vertex(key, m_tmesh, order);
    });
    move_to_arcs(m_vertices, Keys::has_nodes);
  }

  void write() { write_arc_numbers(Keys::keys(m_tmesh), m_vertices.points, m_arc_map); }

private:
  const TriangleMesh& m_tmesh;
  ArcMap m_arc_map;
  Vertices_on_arcs<vertex_descriptor> m_vertices;
};

// The update of the map that a named parameter gives, in a tuple, which is empty if it gives none.
template <class Keys, class TriangleMesh, class NamedParameters, class Tag>
auto arc_map_update(const TriangleMesh& tmesh, const NamedParameters& np, Tag tag)
{
  if constexpr (CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value) {
    return std::tuple<>();
  } else {
    const auto arc_map = get_own_parameter(np, tag);
    return std::make_tuple(
        Arc_map_update<TriangleMesh, Keys, std::decay_t<decltype(arc_map)>>(tmesh, arc_map));
  }
}

template <class TriangleMesh, class NamedParameters>
auto arc_map_updates(const TriangleMesh& tmesh, const NamedParameters& np)
{
  return std::tuple_cat(arc_map_update<Vertex_keys<TriangleMesh>>(tmesh, np, tags::vertex_arc_map),
                        arc_map_update<Face_keys<TriangleMesh>>(tmesh, np, tags::face_arc_map));
}

// A user's Reeb graph and the maps that belong to it, while the graph is simplified: checks and
// reads all of them, simplifies the graph, moves the vertices of the mesh to the arcs that are
// left, and writes.
template <class TriangleMesh, class VertexScalarMap, class MutableGraph, class NamedParameters>
class Graph_update
{
public:
  // Throws if the graph is none.
  Graph_update(const TriangleMesh& tmesh,
               VertexScalarMap scalar_map,
               MutableGraph& graph,
               const NamedParameters& np)
    : m_tmesh(tmesh)
    , m_scalar_map(scalar_map)
    , m_graph(graph)
    , m_np(np)
    , m_arc_maps(arc_map_updates(tmesh, np))
  {
    read_graph(graph, m_nodes, m_arcs, m_ends);
    m_values = values_of_nodes(m_nodes);
  }

  // Throws before anything is written if the graph, its maps and the function do not belong
  // together.
  void run(const Simplification_parameters& parameters)
  {
    Simplification simplification(m_values, m_ends, parameters);
    simplification.run();
    const Compacted_graph compacted(simplification.folded_graph());

    std::vector<Arc> new_arcs(compacted.arcs.size());
    const bool has_arc_vertices = std::any_of(
        m_arcs.begin(), m_arcs.end(), [](const Arc& arc) { return !arc.vertices.empty(); });
    if (has_arc_vertices || std::tuple_size<Arc_maps>::value != 0)
      move_vertices(simplification, compacted, has_arc_vertices, new_arcs);

    write_graph(
        m_graph,
        compacted.nodes.size(),
        compacted.arcs,
        [&](std::size_t i) { return std::move(m_nodes[compacted.nodes[i]]); },
        [&](std::size_t i) { return std::move(new_arcs[i]); });
    // nothing can fail any more
    for_each_arc_map([](auto& arc_map) { arc_map.write(); });
  }

private:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertices = Vertices_on_arcs<vertex_descriptor>;
  using Node = Node_bundle<MutableGraph>;
  using Arc = Arc_bundle<MutableGraph>;
  using Arc_maps = decltype(arc_map_updates(std::declval<const TriangleMesh&>(),
                                            std::declval<const NamedParameters&>()));

  template <class Function>
  void for_each_arc_map(const Function& function)
  {
    std::apply([&](auto&... arc_maps) { (function(arc_maps), ...); }, m_arc_maps);
  }

  // Moves the vertices of `Reeb_arc::vertices` and of the maps.
  void move_vertices(Simplification& simplification,
                     const Compacted_graph& compacted,
                     bool has_arc_vertices,
                     std::vector<Arc>& new_arcs)
  {
    check_function(m_nodes, m_scalar_map);
    const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(m_tmesh, m_np);
    const Vertex_order<TriangleMesh, VertexScalarMap, std::decay_t<decltype(vertex_index_map)>>
        order(m_tmesh, m_scalar_map, vertex_index_map);
    for_each_arc_map([&](const auto& arc_map) { arc_map.check(m_arcs.size()); });
    const std::vector<std::uint32_t> arc_of_node = arcs_of_nodes(compacted, vertex_index_map);
    const auto move_to_arcs = [&](Vertices& list, bool has_nodes) {
      simplification.follow(list.points, [&](std::uint32_t i, std::uint32_t node) {
        return order(list.vertices[i], m_nodes[node].vertex);
      });
      for (std::size_t i = 0; i < list.points.size(); ++i) {
        std::uint32_t& arc = list.points[i].arc;
        arc = compacted.position_of_arc[arc];
        if (arc == no_arc)
          throw_internal_error("a vertex has gone to an arc that is not left");
        if (has_nodes && arc_of_node[get(vertex_index_map, list.vertices[i])] != no_arc)
          arc = arc_of_node[get(vertex_index_map, list.vertices[i])];
      }
    };
    if (has_arc_vertices)
      move_arc_vertices(order, move_to_arcs, new_arcs);
    for_each_arc_map([&](auto& arc_map) { arc_map.move(order, move_to_arcs); });
  }

  // The vertices of the nodes that stay belong to an arc of the node whatever their old arc became.
  // Several nodes may lie at one vertex: it belongs to an arc of the first one. By vertex index.
  template <class VertexIndexMap>
  std::vector<std::uint32_t>
  arcs_of_nodes(const Compacted_graph& compacted, VertexIndexMap vertex_index_map) const
  {
    std::vector<std::uint32_t> result(index_bound(m_tmesh, vertex_index_map), no_arc);
    for (std::size_t i = 0; i < compacted.nodes.size(); ++i) {
      std::uint32_t& arc = result[get(vertex_index_map, m_nodes[compacted.nodes[i]].vertex)];
      if (arc == no_arc)
        arc = compacted.first_arc_of_node[i];
    }
    return result;
  }

  template <class Order, class MoveToArcs>
  void
  move_arc_vertices(const Order& order, const MoveToArcs& move_to_arcs, std::vector<Arc>& new_arcs)
  {
    Vertices list;
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      for (const vertex_descriptor v : m_arcs[i].vertices)
        list.add(v, i);
    move_to_arcs(list, true);
    for (std::size_t i = 0; i < list.points.size(); ++i)
      new_arcs[list.points[i].arc].vertices.push_back(list.vertices[i]);
    for (Arc& arc : new_arcs)
      sort_vertices<CGAL::Sequential_tag>(arc.vertices, order);
  }

  const TriangleMesh& m_tmesh;
  VertexScalarMap m_scalar_map;
  MutableGraph& m_graph;
  const NamedParameters& m_np;
  Arc_maps m_arc_maps;
  std::vector<Node> m_nodes;
  std::vector<Arc> m_arcs;
  std::vector<Arc_ends> m_ends;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_GRAPH_UPDATE_H
