// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_MESH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_MESH_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Checks of the mesh itself, which name what is wrong with it. They take a pass over the mesh, and
// are for where something does not fit, which a valid mesh rules out.

template <class VertexDescriptor, class VertexIndexMap>
[[noreturn]] void
throw_at_vertex(const char* what, VertexDescriptor v, VertexIndexMap vertex_index_map)
{
  throw Input_error(what + (" (vertex " + std::to_string(get(vertex_index_map, v))) + ')');
}

// Whether what a halfedge refers to refers back to it as it must.
template <class TriangleMesh>
bool is_valid_halfedge(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                       const TriangleMesh& tmesh)
{
  const auto null = boost::graph_traits<TriangleMesh>::null_halfedge();
  const auto n = next(h, tmesh), p = prev(h, tmesh), o = opposite(h, tmesh);
  return n != null && p != null && o != null && o != h && opposite(o, tmesh) == h &&
         prev(n, tmesh) == h && next(p, tmesh) == h && face(n, tmesh) == face(h, tmesh) &&
         source(n, tmesh) == target(h, tmesh) && halfedge(target(h, tmesh), tmesh) != null;
}

template <class TriangleMesh, class VertexIndexMap>
void check_halfedges(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
{
  for (const auto h : CGAL::make_range(halfedges(tmesh)))
    if (!is_valid_halfedge<TriangleMesh>(h, tmesh))
      throw_at_vertex("the halfedge data structure of the mesh is not valid",
                      target(h, tmesh),
                      vertex_index_map);
  for (const auto f : CGAL::make_range(faces(tmesh)))
    if (face(halfedge(f, tmesh), tmesh) != f)
      throw_at_vertex("the halfedge of a face belongs to another one",
                      target(halfedge(f, tmesh), tmesh),
                      vertex_index_map);
  for (const auto v : CGAL::make_range(vertices(tmesh)))
    if (!has_no_edge(v, tmesh) && target(halfedge(v, tmesh), tmesh) != v)
      throw_at_vertex("the halfedge of a vertex does not point to it", v, vertex_index_map);
}

// Whether each triangle has three halfedges: a halfedge that no face refers to leaves others out.
template <class TriangleMesh, class VertexIndexMap>
void check_faces(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
{
  for (const auto h : CGAL::make_range(halfedges(tmesh))) {
    if (is_border(h, tmesh))
      continue;
    const auto first = halfedge(face(h, tmesh), tmesh);
    if (h != first && h != next(first, tmesh) && h != prev(first, tmesh))
      throw_at_vertex(
          "a face has more halfedges than a triangle", target(h, tmesh), vertex_index_map);
  }
}

// A circulation around a vertex sees all open fans of faces, but only one closed fan: there are
// several if more halfedges point to the vertex than it sees. `tmesh` has valid halfedges.
template <class TriangleMesh, class VertexIndexMap>
void check_fans(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
{
  std::vector<std::size_t> number_of_unseen(index_bound(tmesh, vertex_index_map), 0);
  for (const auto h : CGAL::make_range(halfedges(tmesh)))
    ++number_of_unseen[static_cast<std::size_t>(get(vertex_index_map, target(h, tmesh)))];
  for (const auto v : CGAL::make_range(vertices(tmesh))) {
    std::size_t& unseen = number_of_unseen[static_cast<std::size_t>(get(vertex_index_map, v))];
    for_each_halfedge_to(v, tmesh, [&](auto) { --unseen; });
    if (unseen != 0)
      throw_at_vertex("the mesh is not a 2-manifold: the faces around a vertex form several fans",
                      v,
                      vertex_index_map);
  }
}

template <class TriangleMesh, class VertexIndexMap>
CGAL_REEB_GRAPH_COLD void check_mesh(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
{
  check_halfedges(tmesh, vertex_index_map);
  check_faces(tmesh, vertex_index_map);
  check_fans(tmesh, vertex_index_map);
}

// Calls `function()`. If what it meets is ruled out for valid meshes, the mesh is checked: if it is
// at fault, the error says so, and not that it is an internal one.
template <class TriangleMesh, class VertexIndexMap, class Function>
auto check_mesh_on_internal_error(const TriangleMesh& tmesh,
                                  VertexIndexMap vertex_index_map,
                                  const Function& function) -> decltype(function())
{
  try {
    return function();
  } catch (const Internal_error&) {
    check_mesh(tmesh, vertex_index_map);
    throw;
  }
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_CHECK_MESH_H
