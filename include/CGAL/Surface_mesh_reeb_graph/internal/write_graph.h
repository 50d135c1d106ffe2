// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

template <class MutableGraph>
using Node_bundle = typename boost::vertex_bundle_type<MutableGraph>::type;

template <class MutableGraph>
using Arc_bundle = typename boost::edge_bundle_type<MutableGraph>::type;

// The numbers of arcs below and above a node.
struct Node_degrees
{
  std::uint32_t down = 0, up = 0;
};

inline std::vector<Node_degrees>
degrees_of_nodes(std::size_t number_of_nodes, const std::vector<Arc_ends>& ends)
{
  std::vector<Node_degrees> result(number_of_nodes);
  for (const Arc_ends& arc : ends) {
    ++result[arc.lower].up;
    ++result[arc.upper].down;
  }
  return result;
}

// Boost's adjacency lists let the memory for the edges of a vertex be allocated at once. Where a function is
// noisy, half of all time would go into letting it grow.
template <class MutableGraph>
auto reserve_edges(typename boost::graph_traits<MutableGraph>::vertex_descriptor v,
                   std::size_t number,
                   MutableGraph& graph) -> decltype(graph.out_edge_list(v).reserve(number))
{
  graph.out_edge_list(v).reserve(number);
}

template <class... Any>
void reserve_edges(const Any&...)
{}

// A graph type whose nodes can be made all at once.
template <class MutableGraph>
struct Makes_nodes_at_once : std::false_type
{
};

template <class OutEdges, class Directed, class Node, class Arc, class Graph, class Edges>
struct Makes_nodes_at_once<
    boost::adjacency_list<OutEdges, boost::vecS, Directed, Node, Arc, Graph, Edges>>
  : std::true_type
{
};

// Makes a graph; `node(i)` and `arc(i)` give the bundles, whose numbers and types are set here.
template <class MutableGraph, class Node, class Arc>
MutableGraph make_graph(std::size_t number_of_nodes,
                        const std::vector<Arc_ends>& ends,
                        const Node& node,
                        const Arc& arc)
{
  using Graph_traits = boost::graph_traits<MutableGraph>;
  static_assert(std::is_convertible<typename Graph_traits::edge_parallel_category,
                                    boost::allow_parallel_edge_tag>::value,
                "a Reeb graph needs a graph type that allows parallel edges");

  const std::vector<Node_degrees> degrees = degrees_of_nodes(number_of_nodes, ends);
  const auto set_node = [&](auto v, std::size_t i, MutableGraph& graph) {
    reserve_edges(v, std::size_t(degrees[i].down) + degrees[i].up, graph);
    Node_bundle<MutableGraph>& bundle = get(boost::vertex_bundle, graph)[v];
    bundle = node(i);
    bundle.id = i;
    bundle.type = reeb_node_type(degrees[i].down, degrees[i].up);
  };
  const auto add_arcs = [&](MutableGraph& graph, const auto& descriptor) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto e = add_edge(descriptor(ends[i].lower), descriptor(ends[i].upper), graph).first;
      Arc_bundle<MutableGraph>& bundle = get(boost::edge_bundle, graph)[e];
      bundle = arc(i);
      bundle.id = i;
    }
  };

  if constexpr (Makes_nodes_at_once<MutableGraph>::value) {
    MutableGraph graph(number_of_nodes);
    for (std::size_t i = 0; i < number_of_nodes; ++i)
      set_node(i, i, graph);
    add_arcs(graph, [](std::size_t i) { return i; });
    return graph;
  } else {
    MutableGraph graph;
    std::vector<typename Graph_traits::vertex_descriptor> descriptors;
    descriptors.reserve(number_of_nodes);
    for (std::size_t i = 0; i < number_of_nodes; ++i) {
      descriptors.push_back(add_vertex(graph));
      set_node(descriptors.back(), i, graph);
    }
    add_arcs(graph, [&](std::size_t i) { return descriptors[i]; });
    return graph;
  }
}

// Throws if the value type of the map cannot hold the numbers of the arcs and that of no arc.
template <class VertexArcMap>
void check_arc_number_type(std::size_t number_of_arcs, const VertexArcMap&)
{
  using Number = typename boost::property_traits<VertexArcMap>::value_type;
  using Limits = std::numeric_limits<Number>;
  const std::size_t largest = static_cast<std::size_t>((Limits::max)());
  if (number_of_arcs > (Limits::is_signed ? largest + 1 : largest))
    throw Reeb_graph_error("the value type of the vertex arc map is too small to number the arcs");
}

// Writes the number of every vertex's arc to the user's map.
template <class TriangleMesh, class VertexIndexMap, class VertexArcMap>
void write_arc_numbers(const TriangleMesh& tmesh,
                       VertexIndexMap vertex_index_map,
                       const std::vector<std::uint32_t>& arc_of_vertex,
                       VertexArcMap vertex_arc_map)
{
  using Number = typename boost::property_traits<VertexArcMap>::value_type;
  for (const auto v : CGAL::make_range(vertices(tmesh))) {
    const std::uint32_t arc = arc_of_vertex[get(vertex_index_map, v)];
    put(vertex_arc_map, v, static_cast<Number>(arc == no_arc ? null_arc : std::size_t(arc)));
  }
}

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H
