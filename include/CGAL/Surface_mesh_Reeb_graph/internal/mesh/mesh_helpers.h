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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

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

// To be called for every step of a walk that visits a halfedge once at most, with the number of
// steps: in a halfedge structure that is not valid it may not come back to where it began.
template <class TriangleMesh>
void check_walk(std::size_t number_of_steps, const TriangleMesh& tmesh)
{
  // rarely, as the number of halfedges may take long to find
  constexpr std::size_t first_check = 1024;
  const bool is_power_of_2 = (number_of_steps & (number_of_steps - 1)) == 0;
  if (is_power_of_2 && number_of_steps >= first_check && number_of_steps > num_halfedges(tmesh))
    throw_internal_error("a walk over the mesh does not end");
}

// Calls `function(h)` for the halfedges that point to a vertex.
template <class TriangleMesh, class Function>
void for_each_halfedge_to(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                          const TriangleMesh& tmesh,
                          const Function& function)
{
  const auto first = halfedge(v, tmesh);
  if (first == boost::graph_traits<TriangleMesh>::null_halfedge())
    return;
  auto h = first;
  std::size_t number_of_steps = 0;
  do {
    function(h);
    check_walk(++number_of_steps, tmesh);
    h = opposite(next(h, tmesh), tmesh);
  } while (h != first);
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
  for_each_halfedge_to(v, tmesh, [&](auto h) { function(source(h, tmesh)); });
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
