// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_REEB_GRAPH_CURVES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_REEB_GRAPH_CURVES_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/compute_arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Reeb_graph_request.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/arc_maps.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Arc_routes.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Contours.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Curve_network.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Curve_relaxation.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Inside_search.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Surface_tree.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The curves of a Reeb graph in space: first through the centroids of contours, then on demand
// moved inside, centered and smoothed.
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexPointMap,
          class VertexIndexMap,
          class Graph>
class Reeb_graph_curves
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Point_3 = std::remove_cv_t<typename boost::property_traits<VertexPointMap>::value_type>;
  using Mesh_contours = Contours<TriangleMesh, VertexScalarMap, VertexPointMap, VertexIndexMap>;
  using Station = typename Mesh_contours::Station;

public:
  Reeb_graph_curves(const TriangleMesh& tmesh,
                    VertexScalarMap scalar_map,
                    VertexPointMap vertex_point_map,
                    VertexIndexMap vertex_index_map,
                    const Graph& graph,
                    std::size_t number_of_samples)
    : m_tmesh(tmesh)
    , m_vertex_point_map(vertex_point_map)
    , m_vertex_index_map(vertex_index_map)
    , m_components(tmesh)
    , m_sampling(0, 0)
    , m_final_sampling(0, 0)
  {
    check_triangles(tmesh);
    check_mesh(tmesh, vertex_index_map);
    check_coordinates(tmesh, vertex_point_map);
    read_graph(graph, m_nodes, m_arcs, m_ends);
    check_function(m_nodes, scalar_map);
    read_surface(number_of_samples);
    find_routes(scalar_map);
    make_curves();
  }

  // Through the centroids of the contours.
  void embed()
  {
    if (m_final_sampling.has_number())
      for (Curve& curve : m_network.curves)
        m_final_sampling.resample(
            m_network, curve, [](const Coordinates&, const Coordinates&) { return true; });
  }

  void make_skeleton(double smoothing, bool keeps_inside)
  {
    constexpr int most_steps = 24, steps_between_samplings = 4;
    constexpr double least_move = 0.01;
    Curve_relaxation relaxation(m_network, m_surface, solid(), m_diagonal, smoothing, keeps_inside);
    relaxation.set_points(relaxation.smooth());
    if (keeps_inside)
      put_inside();
    const auto is_allowed = [&](const Curve& curve) {
      return [&, is_checked = keeps_inside && curve.is_in_solid](const Coordinates& p,
                                                                 const Coordinates& q) {
        return !is_checked || !solid().is_crossed(p, q);
      };
    };
    for (int step = 0; step < most_steps; ++step) {
      if (step % steps_between_samplings == 0)
        for (Curve& curve : m_network.curves)
          m_sampling.resample(m_network, curve, is_allowed(curve));
      const double move = relaxation.relax();
      if (move < least_move)
        break;
    }
    const Sampling& sampling = m_final_sampling.has_number() ? m_final_sampling : m_sampling;
    for (Curve& curve : m_network.curves)
      sampling.resample(m_network, curve, is_allowed(curve));
  }

  template <class Skeleton>
  void write(Skeleton& skeleton) const
  {
    Skeleton result;
    using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
    const auto bundles = get(boost::vertex_bundle, result);
    const auto add_point = [&](const Coordinates& p, double radius) {
      const Vertex v = add_vertex(result);
      bundles[v].point = Point_3(p[0], p[1], p[2]);
      bundles[v].radius = radius;
      return v;
    };
    std::vector<Vertex> nodes;
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
      const Coordinates& p = m_network.nodes[n].point;
      const Vertex v = add_point(p, m_network.nodes[n].is_fixed ? 0 : m_surface.distance(p));
      if (m_network.nodes[n].is_fixed)
        bundles[v].point = get(m_vertex_point_map, m_nodes[n].vertex);
      nodes.push_back(v);
    }
    for (std::size_t n = 0; n < m_nodes.size(); ++n)
      if (has_no_edge(m_nodes[n].vertex, m_tmesh))
        bundles[nodes[n]].vertices.push_back(m_nodes[n].vertex);
    for (std::size_t a = 0; a < m_network.curves.size(); ++a) {
      const Curve& curve = m_network.curves[a];
      std::vector<Vertex> row = {nodes[curve.lower]};
      for (const Curve_point& p : curve.points)
        row.push_back(add_point(p.point, m_surface.distance(p.point)));
      row.push_back(nodes[curve.upper]);
      for (std::size_t i = 1; i < row.size(); ++i) {
        const auto edge = add_edge(row[i - 1], row[i], result).first;
        auto& bundle = get(boost::edge_bundle, result)[edge];
        bundle.arc = a;
        bundle.is_inside =
            curve.is_in_solid &&
            solid().encloses_segment(m_network.point(curve, i - 1), m_network.point(curve, i));
      }
      const std::vector<Coordinates> polyline = m_network.polyline(curve);
      for (const vertex_descriptor v : m_arcs[a].vertices)
        bundles[row[nearest(polyline, coordinates(get(m_vertex_point_map, v)))]].vertices.push_back(
            v);
    }
    skeleton = std::move(result);
  }

private:
  static std::size_t nearest(const std::vector<Coordinates>& points, const Coordinates& p)
  {
    std::size_t result = 0;
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Coordinates d = difference_of(points[i], p);
      const double distance = scalar_product(d, d);
      if (distance < least) {
        least = distance;
        result = i;
      }
    }
    return result;
  }

  const Surface_tree& solid() const { return m_is_all_closed ? m_surface : m_solid; }

  // The faces, and which components are closed.
  void read_surface(std::size_t number_of_samples)
  {
    m_is_closed.assign(m_components.size(), true);
    for (const auto h : CGAL::make_range(halfedges(m_tmesh)))
      if (CGAL::is_border(h, m_tmesh))
        m_is_closed[m_components.component_of(target(h, m_tmesh))] = false;
    m_is_all_closed = std::find(m_is_closed.begin(), m_is_closed.end(), false) == m_is_closed.end();
    CGAL::Bbox_3 box;
    for (const auto f : CGAL::make_range(faces(m_tmesh))) {
      const auto h = halfedge(f, m_tmesh);
      const auto corner = [&](auto g) {
        return coordinates(get(m_vertex_point_map, target(g, m_tmesh)));
      };
      const Coordinates p = corner(h), q = corner(next(h, m_tmesh)), r = corner(prev(h, m_tmesh));
      m_surface.add(p, q, r);
      if (!m_is_all_closed && m_is_closed[m_components.component_of(target(h, m_tmesh))])
        m_solid.add(p, q, r);
      for (const Coordinates& x : {p, q, r})
        box += CGAL::Bbox_3(x[0], x[1], x[2], x[0], x[1], x[2]);
    }
    m_surface.build();
    m_solid.build();
    if (faces(m_tmesh).begin() != faces(m_tmesh).end())
      m_diagonal =
          std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    m_sampling = Sampling(m_diagonal, 0);
    m_final_sampling = Sampling(m_diagonal, number_of_samples);
  }

  // The Reeb graph of all details, and how the arcs run in it.
  void find_routes(VertexScalarMap scalar_map)
  {
    const std::size_t bound = index_bound(m_tmesh, m_vertex_index_map);
    Vertex_classification states(bound);
    std::vector<Monotone_neighbors<TriangleMesh>> neighbors;
    const auto order = classify_vertices<CGAL::Sequential_tag>(
        m_tmesh, scalar_map, m_vertex_index_map, states, &neighbors);
    const Arc_list<TriangleMesh> details = compute_arc_list<CGAL::Sequential_tag>(
        m_tmesh, order, m_vertex_index_map, states, neighbors, Reeb_graph_request());
    m_details = details.nodes;
    std::vector<std::uint32_t> node_of_vertex(bound, no_node);
    for (std::size_t n = 0; n < m_details.size(); ++n)
      node_of_vertex[index(m_details[n])] = static_cast<std::uint32_t>(n);
    // a multiple saddle that has been unfolded may be an inner vertex of an arc: it parts the arc
    for (const auto& node : m_nodes) {
      std::uint32_t& n = node_of_vertex[index(node.vertex)];
      if (n == no_node) {
        if (details.arc_of_vertex[index(node.vertex)] == no_arc)
          throw Input_error("the Reeb graph is not that of the function");
        n = static_cast<std::uint32_t>(m_details.size());
        m_details.push_back(node.vertex);
      }
      m_place.push_back(n);
    }

    std::vector<std::size_t> arc_of_vertex(bound, m_arcs.size());
    std::size_t number_of_vertices = 0;
    for (std::size_t a = 0; a < m_arcs.size(); ++a)
      for (const vertex_descriptor v : m_arcs[a].vertices) {
        arc_of_vertex[index(v)] = a;
        ++number_of_vertices;
      }
    if (number_of_vertices == 0 && !m_arcs.empty())
      throw Input_error("the Reeb graph has been made without the vertices of its arcs, which "
                        "collect_arc_vertices asks for");

    const auto vertices =
        vertices_of_arcs<CGAL::Sequential_tag>(details, m_tmesh, m_vertex_index_map, order);
    std::vector<std::map<std::size_t, std::size_t>> shares;
    std::vector<std::vector<Station>> stations;
    std::vector<Station> row;
    const auto end_arc = [&](std::size_t upper) {
      const std::size_t lower = node_of_vertex[index(row.front().vertex)];
      m_detailed_ends.push_back({lower, upper});
      shares.emplace_back();
      for (const Station& station : row) {
        const std::size_t arc = arc_of_vertex[index(station.vertex)];
        if (node_of_vertex[index(station.vertex)] == no_node && arc < m_arcs.size())
          ++shares.back()[arc];
      }
      stations.push_back(levels_between_values(scalar_map, row, m_details[upper]));
    };
    std::size_t place = 0;
    for (std::size_t a = 0; a < details.arcs.size(); ++a) {
      const Arc_ends& ends = details.arcs[a];
      place = a > 0 && details.arcs[a - 1].lower == ends.lower ? place + 1 : 0;
      row = {{details.nodes[ends.lower], place}};
      for (const vertex_descriptor v : vertices[a]) {
        const std::uint32_t n = node_of_vertex[index(v)];
        if (n != no_node && n >= details.nodes.size()) {
          end_arc(n);
          row.clear();
        }
        if (n == no_node || n >= details.nodes.size())
          row.push_back({v, 0});
      }
      end_arc(ends.upper);
    }
    m_contours = std::make_unique<Mesh_contours>(
        m_tmesh, scalar_map, m_vertex_point_map, m_vertex_index_map, std::move(stations));
    std::vector<Arc_routes::Ends> ends;
    for (const Arc_ends& e : m_ends)
      ends.push_back({e.lower, e.upper});
    m_routes = Arc_routes(m_details.size(), m_detailed_ends, shares).find(ends, m_place);
  }

  // The stations above which the next vertex of the arc has a higher value: levels inside of plateaus
  // follow the order of the vertices rather than the function. If there is none, all.
  static std::vector<Station> levels_between_values(VertexScalarMap scalar_map,
                                                    const std::vector<Station>& row,
                                                    vertex_descriptor upper)
  {
    std::vector<Station> result;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (get(scalar_map, row[i].vertex) <
          get(scalar_map, i + 1 < row.size() ? row[i + 1].vertex : upper))
        result.push_back(row[i]);
    return result.empty() ? row : result;
  }

  void make_curves()
  {
    std::vector<bool> has_lower(m_details.size(), false), has_upper = has_lower;
    for (const Arc_routes::Ends& ends : m_detailed_ends)
      has_lower[ends.second] = has_upper[ends.first] = true;
    for (const std::size_t n : m_place) {
      const vertex_descriptor v = m_details[n];
      const bool is_fixed = !has_lower[n] || !has_upper[n];
      m_network.nodes.push_back(
          {is_fixed ? coordinates(get(m_vertex_point_map, v)) : m_contours->center(v), is_fixed});
    }
    for (std::size_t a = 0; a < m_arcs.size(); ++a) {
      Curve curve;
      curve.lower = m_ends[a].lower;
      curve.upper = m_ends[a].upper;
      curve.is_in_solid = m_is_closed[m_components.component_of(m_nodes[curve.lower].vertex)];
      sample(m_routes[a], curve);
      m_network.curves.push_back(curve);
    }
  }

  // Contours as dense as the sampling asks for, or as there are vertices.
  void sample(const Arc_routes::Route& route, Curve& curve) const
  {
    constexpr std::size_t first_parts = 8;
    const std::size_t stations = m_contours->number_of_stations(route);
    const std::size_t parts = (std::min)(stations, first_parts);
    std::vector<Curve_point> row;
    for (std::size_t k = 0; k < parts; ++k)
      row.push_back(curve_point(route, (2 * k + 1) * stations / (2 * parts)));
    const Curve_point begin = {m_network.nodes[curve.lower].point, 0, 0};
    const Curve_point end = {m_network.nodes[curve.upper].point, 0, stations};
    for (std::size_t k = 0; k < parts; ++k) {
      add_between(route, k == 0 ? begin : row[k - 1], k == 0, row[k], curve.points);
      curve.points.push_back(row[k]);
    }
    if (parts > 0)
      add_between(route, row.back(), false, end, curve.points);
  }

  Curve_point curve_point(const Arc_routes::Route& route, std::size_t station) const
  {
    const Contour contour = m_contours->contour(route, station);
    return {contour.centroid, contour.diameter(), station};
  }

  // Halves the interval between two stations; the first one itself counts as free if it stands for
  // the node there.
  void add_between(const Arc_routes::Route& route,
                   const Curve_point& lower,
                   bool is_lower_free,
                   const Curve_point& upper,
                   std::vector<Curve_point>& points) const
  {
    const std::size_t begin = is_lower_free ? 0 : lower.station + 1;
    const double diameter = (std::max)(lower.diameter, upper.diameter);
    if (begin >= upper.station ||
        distance_between(lower.point, upper.point) <= m_sampling.distance(diameter))
      return;
    const Curve_point middle = curve_point(route, begin + (upper.station - begin) / 2);
    add_between(route, lower, is_lower_free, middle, points);
    points.push_back(middle);
    add_between(route, middle, false, upper, points);
  }

  // The nodes first: the curves begin there.
  void put_inside()
  {
    const Inside_search search(solid(), m_diagonal);
    std::vector<std::vector<Coordinates>> next_points(m_network.nodes.size()); // of their curves
    for (const Curve& curve : m_network.curves)
      if (!curve.points.empty()) {
        next_points[curve.lower].push_back(curve.points.front().point);
        next_points[curve.upper].push_back(curve.points.back().point);
      }
    for (std::size_t n = 0; n < m_network.nodes.size(); ++n) {
      Curve_network::Node& node = m_network.nodes[n];
      if (node.is_fixed || !m_is_closed[m_components.component_of(m_nodes[n].vertex)])
        continue;
      const std::vector<Coordinates>& others = next_points[n];
      const bool is_seen = std::all_of(others.begin(), others.end(), [&](const Coordinates& other) {
        return solid().encloses_segment(node.point, other);
      });
      if (!is_seen)
        search.place_node(m_contours->contours_at(m_details[m_place[n]]), others, node.point);
    }
    for (std::size_t a = 0; a < m_network.curves.size(); ++a)
      if (m_network.curves[a].is_in_solid)
        search.put_inside(*m_contours, m_routes[a], m_network, m_network.curves[a]);
  }

  std::size_t index(vertex_descriptor v) const
  {
    return static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  const TriangleMesh& m_tmesh;
  VertexPointMap m_vertex_point_map;
  VertexIndexMap m_vertex_index_map;

  std::vector<Node_bundle<Graph>> m_nodes;
  std::vector<Arc_bundle<Graph>> m_arcs;
  std::vector<Arc_ends> m_ends;

  Mesh_components<TriangleMesh> m_components;
  std::vector<bool> m_is_closed; // by component
  bool m_is_all_closed = true;
  Surface_tree m_surface, m_solid; // all faces; those of closed components, if there are others
  double m_diagonal = 0;
  Sampling m_sampling, m_final_sampling;

  // the graph before anything has been cancelled: the vertices of its nodes, the ends of its arcs
  std::vector<vertex_descriptor> m_details;
  std::vector<Arc_routes::Ends> m_detailed_ends;
  std::vector<std::size_t> m_place; // of the nodes, among those of the details
  std::vector<Arc_routes::Route> m_routes;
  std::unique_ptr<Mesh_contours> m_contours;
  Curve_network m_network;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_REEB_GRAPH_CURVES_H
