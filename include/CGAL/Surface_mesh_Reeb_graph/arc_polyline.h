// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_ARC_POLYLINE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_ARC_POLYLINE_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns a polyline in space for an arc of a Reeb graph: from the lower node, a point of the surface,
through the barycenters of the arc's vertices, in groups of increasing value and equal size, to the
upper node. Where level sets are round, the barycenters lie inside the shape. (The arc's vertices
include that of the lower node if this is its first arc, and after a simplification those of
branches that hung on the arc, which may lie above the upper node, or below the lower one.)

\tparam Graph a graph filled by `compute_Reeb_graph()`
\tparam TriangleMesh a model of `VertexListGraph`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param arc the arc
\param graph the Reeb graph; without the vertices of its arcs (see the named parameter
       `collect_arc_vertices` of `compute_Reeb_graph()`) polylines are straight
\param tmesh the mesh
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_samples}
    \cgalParamDescription{the largest number of barycenters; arcs of few vertices have fewer, half the square root of the number of vertices at most, so that a group reaches around the shape}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{`10`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes time in proportion to the number of the arc's vertices.

\return the points, at least two, as a `std::vector` of the value type of the vertex point map

\pre the number of samples is not negative
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
auto arc_polyline(typename boost::graph_traits<Graph>::edge_descriptor arc,
                  const Graph& graph,
                  const TriangleMesh& tmesh,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  using Point_3 =
      typename boost::property_traits<std::decay_t<decltype(vertex_point_map)>>::value_type;
  const auto number_of_samples = static_cast<long long>(
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_samples), 10));
  CGAL_precondition(number_of_samples >= 0);

  const auto nodes = get(boost::vertex_bundle, graph);
  const auto& vertices = get(boost::edge_bundle, graph)[arc].vertices;

  std::vector<Point_3> polyline;
  polyline.push_back(get(vertex_point_map, nodes[lower_node(arc, graph)].vertex));
  // in a part of a tube that is as long as wide, n vertices make about sqrt(n) rings: smaller
  // groups would not reach around
  const std::size_t groups =
      (std::min)(static_cast<std::size_t>(number_of_samples),
                 static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices.size())) / 2));
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t begin = g * vertices.size() / groups;
    const std::size_t end = (g + 1) * vertices.size() / groups;
    double x = 0, y = 0, z = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto& p = get(vertex_point_map, vertices[i]);
      x += CGAL::to_double(p.x());
      y += CGAL::to_double(p.y());
      z += CGAL::to_double(p.z());
    }
    const double size = static_cast<double>(end - begin);
    polyline.push_back(Point_3(x / size, y / size, z / size));
  }
  polyline.push_back(get(vertex_point_map, nodes[upper_node(arc, graph)].vertex));
  return polyline;
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_ARC_POLYLINE_H
