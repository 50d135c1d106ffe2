// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_MAPS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_MAPS_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Point_on_arc.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Throws if the value type of the map cannot hold the numbers of the arcs and that of no arc.
template <class ArcMap>
void check_arc_number_type(std::size_t number_of_arcs, const ArcMap&, const std::string& item)
{
  using Number = typename boost::property_traits<ArcMap>::value_type;
  using Limits = std::numeric_limits<Number>;
  const std::size_t largest = static_cast<std::size_t>((Limits::max)());
  if (number_of_arcs > (Limits::is_signed ? largest + 1 : largest))
    throw Input_error("the value type of the " + item + " arc map is too small to number the arcs");
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

// Throws if a map from vertices or faces to arcs has a number in it that no arc has.
template <class Range, class ArcMap>
void check_arc_numbers(const Range& keys,
                       std::size_t number_of_arcs,
                       const ArcMap& arc_map,
                       const char* name)
{
  using Number = typename boost::property_traits<ArcMap>::value_type;
  for (const auto key : CGAL::make_range(keys)) {
    const Number arc = get(arc_map, key);
    if (arc != static_cast<Number>(null_arc) && static_cast<std::size_t>(arc) >= number_of_arcs)
      throw Input_error(std::string("the ") + name + " arc map does not belong to the Reeb graph");
  }
}

// Throws if the values of the nodes are not those of a function.
template <class Node, class VertexScalarMap>
void check_function(const std::vector<Node>& nodes, VertexScalarMap scalar_map)
{
  for (const Node& node : nodes) {
    auto value = node.value;
    value = get(scalar_map, node.vertex); // as compute_Reeb_graph() does
    if (!(value == node.value))
      throw Input_error("the Reeb graph is not that of the function");
  }
}

// Vertices on their way from arc to arc.
template <class Vertex>
struct Vertices_on_arcs
{
  void add(Vertex v, std::size_t arc)
  {
    vertices.push_back(v);
    points.emplace_back(static_cast<std::uint32_t>(arc));
  }

  std::vector<Vertex> vertices;
  std::vector<Point_on_arc> points;
};

// The vertices `vertex(key)` of all vertices or faces that have an arc in a map.
template <class Vertex, class Range, class ArcMap, class VertexOfKey>
Vertices_on_arcs<Vertex>
read_arc_numbers(const Range& keys, ArcMap arc_map, const VertexOfKey& vertex)
{
  using Number = typename boost::property_traits<ArcMap>::value_type;
  Vertices_on_arcs<Vertex> result;
  for (const auto key : CGAL::make_range(keys)) {
    const Number arc = get(arc_map, key);
    if (arc != static_cast<Number>(null_arc))
      result.add(vertex(key), static_cast<std::size_t>(arc));
  }
  return result;
}

// Writes the arcs of all vertices or faces that have had one, in the same order.
template <class Range, class ArcMap>
void write_arc_numbers(const Range& keys, const std::vector<Point_on_arc>& points, ArcMap arc_map)
{
  using Number = typename boost::property_traits<ArcMap>::value_type;
  auto point = points.begin();
  for (const auto key : CGAL::make_range(keys)) {
    if (get(arc_map, key) == static_cast<Number>(null_arc))
      continue;
    CGAL_assertion(point != points.end());
    put(arc_map, key, static_cast<Number>((point++)->arc));
  }
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_ARC_MAPS_H
