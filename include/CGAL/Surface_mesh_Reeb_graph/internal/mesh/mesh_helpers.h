// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_HELPERS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_HELPERS_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// One more than the largest index: the size of an array over the vertices. Indices need not be
// dense (a `Surface_mesh` keeps those of removed vertices).
template <class TriangleMesh, class VertexIndexMap>
std::size_t index_bound(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
{
  std::size_t bound = 0;
  for (auto v : CGAL::make_range(vertices(tmesh)))
    bound = (std::max)(bound, static_cast<std::size_t>(get(vertex_index_map, v)) + 1);
  return bound;
}

template <class TriangleMesh>
bool has_no_edge(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                 const TriangleMesh& tmesh)
{
  return halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge();
}

// A circulation sees one closed fan of faces around a vertex. If there are several, the data
// structure cannot show them all, and sooner or later something does not fit.
[[noreturn]] inline void throw_several_fans()
{
  throw Input_error("the mesh is not a 2-manifold: the faces around a vertex form several fans");
}

// Checked in every build mode: what follows may not end, or read outside of arrays.
template <class TriangleMesh>
void check_triangles(const TriangleMesh& tmesh)
{
  if (!CGAL::is_triangle_mesh(tmesh))
    throw Input_error("the mesh has a face that is not a triangle");
}

template <class TriangleMesh, class Function>
void for_each_neighbor(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                       const TriangleMesh& tmesh,
                       Function function)
{
  if (has_no_edge(v, tmesh))
    return;
  for (auto h : CGAL::halfedges_around_target(v, tmesh))
    function(source(h, tmesh));
}

// The middle one of the vertices of a face.
template <class TriangleMesh, class Less>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
middle_vertex(typename boost::graph_traits<TriangleMesh>::face_descriptor f,
              const TriangleMesh& tmesh,
              const Less& less)
{
  const auto h = halfedge(f, tmesh);
  const auto u = source(h, tmesh), v = target(h, tmesh), w = target(next(h, tmesh), tmesh);
  const bool is_u_below_v = less(u, v), is_v_below_w = less(v, w);
  if (is_u_below_v == is_v_below_w)
    return v;
  return less(w, u) == is_u_below_v ? u : w;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_HELPERS_H
