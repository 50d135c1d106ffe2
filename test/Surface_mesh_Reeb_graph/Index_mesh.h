// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangle mesh as two plain arrays: what the generators make and the oracles read, so that
// neither depends on a mesh data structure nor on the code under test.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_INDEX_MESH_H
#define SURFACE_MESH_REEB_GRAPH_TEST_INDEX_MESH_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Reeb_graph_test {

// A consistently oriented 2-manifold with or without border. A point that no triangle uses is an
// isolated vertex.
struct Index_mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// Adds `input` to `mesh`, any model of `MutableFaceGraph`; `vertices[i]` becomes the descriptor of
// `input.points[i]`. Vertices and faces are added in the order of `input`.
//
// The faces are added one by one because the conversions from polygon soups drop isolated vertices
// and split pinched ones.
template <class Mesh>
void make_mesh(const Index_mesh& input,
               Mesh& mesh,
               std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>& vertices)
{
  using Graph_traits = boost::graph_traits<Mesh>;
  using Vertex_point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Vertex_point_map>::value_type;

  Vertex_point_map vertex_point_map = get(CGAL::vertex_point, mesh);
  vertices.clear();
  vertices.reserve(input.points.size());
  for (const std::array<double, 3>& p : input.points) {
    vertices.push_back(add_vertex(mesh));
    put(vertex_point_map, vertices.back(), Point(p[0], p[1], p[2]));
  }

  for (const std::array<std::size_t, 3>& t : input.triangles) {
    const std::array<typename Graph_traits::vertex_descriptor, 3> corners = {
        vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    if (CGAL::Euler::add_face(corners, mesh) == Graph_traits::null_face()) {
      throw std::runtime_error("make_mesh: the triangles are not an oriented 2-manifold");
    }
  }
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_INDEX_MESH_H
