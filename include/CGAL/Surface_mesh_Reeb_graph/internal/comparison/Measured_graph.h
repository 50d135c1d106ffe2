// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_MEASURED_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_MEASURED_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A Reeb graph with the area of the surface on it: its points are the nodes and the vertices of the
// mesh, those of an arc a chain between its ends. The masses sum to 1.
struct Measured_graph
{
  std::vector<double> values;
  std::vector<double> masses;
  std::vector<Arc_ends> edges; // between consecutive points
};

// A third of the area of the faces of every vertex, in the order of the vertices.
template <class TriangleMesh, class VertexPointMap, class VertexIndexMap>
std::vector<double> barycentric_areas(const TriangleMesh& tmesh,
                                      VertexPointMap vertex_point_map,
                                      VertexIndexMap vertex_index_map)
{
  std::vector<double> areas(index_bound(tmesh, vertex_index_map), 0.);
  for (const auto f : CGAL::make_range(faces(tmesh))) {
    const auto h = halfedge(f, tmesh);
    const auto u = source(h, tmesh), v = target(h, tmesh), w = target(next(h, tmesh), tmesh);
    const auto& p = get(vertex_point_map, u);
    const auto& q = get(vertex_point_map, v);
    const auto& r = get(vertex_point_map, w);
    const double ax = CGAL::to_double(q.x() - p.x()), ay = CGAL::to_double(q.y() - p.y()),
                 az = CGAL::to_double(q.z() - p.z());
    const double bx = CGAL::to_double(r.x() - p.x()), by = CGAL::to_double(r.y() - p.y()),
                 bz = CGAL::to_double(r.z() - p.z());
    const double area =
        std::hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / 6; // of the corner
    for (const auto x : {u, v, w})
      areas[static_cast<std::size_t>(get(vertex_index_map, x))] += area;
  }
  return areas;
}

// The vertices of a simplified graph's arc may lie outside of it: they count at its nearer end.
template <class TriangleMesh, class VertexScalarMap, class Graph, class VertexArcMap>
class Measured_graph_builder
{
public:
  template <class VertexIndexMap>
  static Measured_graph build(const TriangleMesh& tmesh,
                              VertexScalarMap scalar_map,
                              const Graph& graph,
                              VertexArcMap vertex_arc_map,
                              const std::vector<double>& areas,
                              VertexIndexMap vertex_index_map)
  {
    using Number = typename boost::property_traits<VertexArcMap>::value_type;
    std::vector<Node_bundle<Graph>> nodes;
    std::vector<Arc_bundle<Graph>> arcs;
    std::vector<Arc_ends> ends;
    read_graph(graph, nodes, arcs, ends);
    check_function(nodes, scalar_map);
    check_arc_numbers(vertices(tmesh), ends.size(), vertex_arc_map, "vertex");

    Measured_graph result;
    for (const auto& node : nodes)
      result.values.push_back(finite(CGAL::to_double(node.value)));
    result.masses.assign(nodes.size(), 0.);

    std::vector<std::vector<std::pair<double, double>>> points(ends.size()); // values, areas
    double total = 0;
    for (const auto v : CGAL::make_range(vertices(tmesh))) {
      const double area = areas[static_cast<std::size_t>(get(vertex_index_map, v))];
      const double value = finite(CGAL::to_double(get(scalar_map, v)));
      const Number number = get(vertex_arc_map, v);
      if (number == static_cast<Number>(null_arc)) {
        if (area > 0)
          throw Input_error("the vertex arc map does not belong to the Reeb graph");
        continue; // an isolated vertex
      }
      total += area;
      points[static_cast<std::size_t>(number)].emplace_back(value, area);
    }
    if (!(total > 0 && std::isfinite(total)))
      throw Input_error("the area of the surface is zero or not finite");

    for (std::size_t arc = 0; arc < ends.size(); ++arc) {
      std::sort(points[arc].begin(), points[arc].end());
      const Arc_ends& e = ends[arc];
      const double lowest = result.values[e.lower], highest = result.values[e.upper];
      std::uint32_t last = e.lower;
      for (const auto& point : points[arc]) {
        if (point.first <= lowest) {
          result.masses[e.lower] += point.second / total;
        } else if (point.first >= highest) {
          result.masses[e.upper] += point.second / total;
        } else if (last != e.lower && result.values[last] == point.first) {
          result.masses[last] += point.second / total;
        } else {
          if (result.values.size() >= (std::numeric_limits<std::uint32_t>::max)())
            throw Input_error("the mesh has too many vertices");
          const auto next = static_cast<std::uint32_t>(result.values.size());
          result.values.push_back(point.first);
          result.masses.push_back(point.second / total);
          result.edges.push_back({last, next});
          last = next;
        }
      }
      result.edges.push_back({last, e.upper});
    }
    return result;
  }

private:
  static double finite(double value)
  {
    if (!std::isfinite(value))
      throw Input_error("a value of the function is not a finite number");
    return value;
  }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_MEASURED_GRAPH_H
