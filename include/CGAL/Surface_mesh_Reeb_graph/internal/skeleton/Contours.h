// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CONTOURS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CONTOURS_H

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Arc_routes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Line_hits.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A component of a level set as a polyline.
struct Contour
{
  std::vector<Coordinates> points;  // if it is closed, the first one comes again at the end
  std::vector<Coordinates> normals; // of a face at each point, of any length; 0 if there is none
  Coordinates centroid;             // of the line
  double length;

  // That of the circle of the same length.
  double diameter() const { return length / CGAL_PI; }
};

// The centroid of line segments, or that of their ends if they have no length.
class Centroid
{
public:
  void add(const std::vector<Coordinates>& polyline)
  {
    for (const Coordinates& p : polyline)
      add(p, 1, m_points, m_number);
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      const Coordinates &p = polyline[i - 1], &q = polyline[i];
      add({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2},
          distance_between(p, q),
          m_lines,
          m_length);
    }
  }

  double length() const { return m_length; }

  Coordinates point() const
  {
    CGAL_precondition(m_number > 0);
    const Coordinates& sum = m_length > 0 ? m_lines : m_points;
    const double weight = m_length > 0 ? m_length : m_number;
    return {sum[0] / weight, sum[1] / weight, sum[2] / weight};
  }

private:
  static void add(const Coordinates& p, double weight, Coordinates& sum, double& sum_of_weights)
  {
    for (int c = 0; c < 3; ++c)
      sum[c] += weight * p[c];
    sum_of_weights += weight;
  }

  Coordinates m_lines = {}, m_points = {};
  double m_length = 0, m_number = 0;
};

// The contours of the arcs of a Reeb graph of all details: for every arc some above its vertices, one
// at least. Along a route they are the stations, numbered from its beginning.
template <class TriangleMesh, class VertexScalarMap, class VertexPointMap, class VertexIndexMap>
class Contours
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Components = Level_set_components<TriangleMesh, VertexScalarMap, VertexIndexMap>;
  using Component = Level_set_component<TriangleMesh>;
  using Route = Arc_routes::Route;

public:
  // The contour above a vertex. At a node several arcs begin, and so many contours.
  struct Station
  {
    vertex_descriptor vertex;
    std::size_t place;
  };

  Contours(const TriangleMesh& tmesh,
           VertexScalarMap scalar_map,
           VertexPointMap vertex_point_map,
           VertexIndexMap vertex_index_map,
           std::vector<std::vector<Station>> stations)
    : m_tmesh(tmesh)
    , m_components(tmesh, scalar_map, CGAL::parameters::vertex_index_map(vertex_index_map))
    , m_vertex_point_map(vertex_point_map)
    , m_stations(std::move(stations))
  {}

  std::size_t number_of_stations(const Route& route) const
  {
    std::size_t result = 0;
    for (const Arc_routes::Step& step : route)
      result += m_stations[step.arc].size();
    return result;
  }

  Contour contour(const Route& route, std::size_t station) const
  {
    for (const Arc_routes::Step& step : route) {
      const std::vector<Station>& stations = m_stations[step.arc];
      if (station < stations.size())
        return contour_above(stations[step.is_upward ? station : stations.size() - 1 - station]);
      station -= stations.size();
    }
    CGAL_assertion(false);
    return {};
  }

  // The centroid of all contours just below and just above a vertex that touch it.
  Coordinates center(vertex_descriptor v) const
  {
    std::vector<Component> components;
    m_components.below(v, std::back_inserter(components));
    m_components.above(v, std::back_inserter(components));
    Centroid centroid;
    for (const Component& component : components)
      centroid.add(polyline(component));
    return components.empty() ? coordinates(get(m_vertex_point_map, v)) : centroid.point();
  }

  std::vector<Contour> contours_at(vertex_descriptor v) const
  {
    std::vector<Component> components;
    m_components.below(v, std::back_inserter(components));
    m_components.above(v, std::back_inserter(components));
    std::vector<Contour> result;
    for (const Component& component : components)
      result.push_back(contour(component));
    return result;
  }

private:
  Contour contour_above(const Station& station) const
  {
    std::vector<Component> components;
    m_components.above(station.vertex, std::back_inserter(components));
    CGAL_assertion(station.place < components.size());
    return contour(components[station.place]);
  }

  Contour contour(const Component& component) const
  {
    Contour result;
    result.points = polyline(component);
    for (const auto h : component.halfedges)
      result.normals.push_back(normal(h));
    Centroid centroid;
    centroid.add(result.points);
    result.centroid = centroid.point();
    result.length = centroid.length();
    return result;
  }

  Coordinates normal(typename Graph_traits::halfedge_descriptor h) const
  {
    const auto inner = CGAL::is_border(h, m_tmesh) ? opposite(h, m_tmesh) : h;
    const auto corner = [&](auto g) {
      return coordinates(get(m_vertex_point_map, target(g, m_tmesh)));
    };
    const Coordinates p = corner(inner);
    return cross_product_of(difference_of(corner(next(inner, m_tmesh)), p),
                            difference_of(corner(prev(inner, m_tmesh)), p));
  }

  std::vector<Coordinates> polyline(const Component& component) const
  {
    std::vector<Coordinates> result;
    for (const auto& p :
         m_components.polyline(component, CGAL::parameters::vertex_point_map(m_vertex_point_map)))
      result.push_back(coordinates(p));
    return result;
  }

  const TriangleMesh& m_tmesh;
  Components m_components;
  VertexPointMap m_vertex_point_map;
  std::vector<std::vector<Station>> m_stations; // by arc, in increasing order
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CONTOURS_H
