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

// Sets the number and the type of every node and the number of every arc, which follow from the arcs.
template <class NodeBundle, class ArcBundle>
void number_and_classify(std::vector<NodeBundle>& nodes,
                         std::vector<ArcBundle>& arcs,
                         const std::vector<Arc_ends>& ends)
{
  std::vector<std::size_t> down(nodes.size(), 0), up(nodes.size(), 0);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ++up[ends[i].lower];
    ++down[ends[i].upper];
    arcs[i].id = i;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].id = i;
    nodes[i].type = reeb_node_type(down[i], up[i]);
  }
}

// Replaces the content of `graph`.
template <class MutableGraph>
void write_graph(MutableGraph& graph,
                 std::vector<Node_bundle<MutableGraph>>&& nodes,
                 std::vector<Arc_bundle<MutableGraph>>&& arcs,
                 const std::vector<Arc_ends>& ends)
{
  using Graph_traits = boost::graph_traits<MutableGraph>;
  static_assert(std::is_convertible<typename Graph_traits::edge_parallel_category,
                                    boost::allow_parallel_edge_tag>::value,
                "a Reeb graph needs a graph type that allows parallel edges");

  graph = MutableGraph();

  std::vector<typename Graph_traits::vertex_descriptor> descriptors;
  descriptors.reserve(nodes.size());
  for (Node_bundle<MutableGraph>& node : nodes) {
    descriptors.push_back(add_vertex(graph));
    get(boost::vertex_bundle, graph)[descriptors.back()] = std::move(node);
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto e = add_edge(descriptors[ends[i].lower], descriptors[ends[i].upper], graph).first;
    get(boost::edge_bundle, graph)[e] = std::move(arcs[i]);
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
