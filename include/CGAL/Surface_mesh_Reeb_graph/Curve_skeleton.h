// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_CURVE_SKELETON_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_CURVE_SKELETON_H

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The vertex bundle of `Curve_skeleton`: a point of the skeleton. `point` and `vertices` are those of
`CGAL::Mean_curvature_flow_skeletonization::Vmap`.

\tparam TriangleMesh the type of the mesh
\tparam Point_3 the type of the points
*/
template <class TriangleMesh, class Point_3>
struct Curve_skeleton_vertex
{
  /// where it is
  Point_3 point = {};
  /// the vertices of the mesh that belong to it: of those of its arc (`Reeb_arc::vertices`) the ones
  /// that are nearer to it than to the other points of the arc. Every vertex of the mesh that
  /// belongs to an arc is in one list, and so is every isolated vertex.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices = {};
  /// the distance to the surface (to the faces that have an area); 0 at extrema and isolated vertices
  double radius = 0;
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The edge bundle of `Curve_skeleton`: a segment of the polyline of an arc.
*/
struct Curve_skeleton_edge
{
  /// the number of the arc, `Reeb_arc::id`
  std::size_t arc = 0;
  /// whether all points between its ends lie inside the surface, checked exactly. It is never `true`
  /// where there is no inside: for components of the mesh that have a border.
  bool is_inside = false;
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The type of curve skeletons: a Reeb graph whose arcs are polylines in space. It has a vertex for
every node of the Reeb graph, in the order of `Reeb_node::id`, and then the points of one arc after
the other, from its lower to its upper node.

Its vertices have the members `point` and `vertices` of
`CGAL::Mean_curvature_flow_skeletonization::Skeleton`, so that what has been written for that type
(`CGAL::split_graph_into_polylines()`, for instance) can be used.

\tparam TriangleMesh the type of the mesh
\tparam Point_3 the type of the points, that of the vertices of the mesh

\sa `compute_curve_skeleton()`
\sa `embed_Reeb_graph()`
*/
template <
    class TriangleMesh,
    class Point_3 = typename boost::property_traits<
        typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::value_type>
using Curve_skeleton = boost::adjacency_list<boost::vecS,
                                             boost::vecS,
                                             boost::undirectedS,
                                             Curve_skeleton_vertex<TriangleMesh, Point_3>,
                                             Curve_skeleton_edge>;

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_CURVE_SKELETON_H
