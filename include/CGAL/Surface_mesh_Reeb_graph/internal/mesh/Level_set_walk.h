// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_LEVEL_SET_WALK_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_LEVEL_SET_WALK_H

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <array>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A walk along a component of a level set, from crossed edge to crossed edge through the triangles
// between them. The walk stands on the halfedge of the crossed edge that lies in the triangle to be
// entered next. Forward walks hold halfedges that point upwards, backward walks those that point
// downwards: so the two directions are opposite to each other all along the component.
template <class TriangleMesh>
class Level_set_walk
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

public:
  Level_set_walk(halfedge_descriptor h, bool is_forward) : m_halfedge(h), m_is_forward(is_forward)
  {}

  halfedge_descriptor halfedge() const { return m_halfedge; }
  bool is_forward() const { return m_is_forward; }

  bool is_at_border(const TriangleMesh& tmesh) const
  {
    return face(m_halfedge, tmesh) == Graph_traits::null_face();
  }

  // The triangle to be crossed next: its third vertex, and the halfedges by which the walk may
  // leave it.
  struct Crossing
  {
    vertex_descriptor vertex;
    std::array<halfedge_descriptor, 2> ways;
  };

  Crossing crossing(const TriangleMesh& tmesh) const
  {
    const halfedge_descriptor n = next(m_halfedge, tmesh);
    return {target(n, tmesh), {n, next(n, tmesh)}};
  }

  // Crosses it. There is no branch: which way the walk turns cannot be predicted, and a
  // misprediction would stall the other walks that are interleaved with it.
  // \pre the walk is not at the border
  void cross(const Crossing& crossing, bool is_vertex_above, const TriangleMesh& tmesh)
  {
    CGAL_precondition(!is_at_border(tmesh));
    m_halfedge = opposite(crossing.ways[is_vertex_above == m_is_forward ? 1 : 0], tmesh);
  }

  // Both at once; returns the third vertex. `is_above` tells on which side of the level a vertex
  // lies.
  template <class IsAbove>
  vertex_descriptor step(const TriangleMesh& tmesh, const IsAbove& is_above)
  {
    const Crossing next_crossing = crossing(tmesh);
    cross(next_crossing, is_above(next_crossing.vertex), tmesh);
    CGAL_assertion(is_above(target(m_halfedge, tmesh)) == m_is_forward &&
                   is_above(source(m_halfedge, tmesh)) != m_is_forward);
    return next_crossing.vertex;
  }

private:
  halfedge_descriptor m_halfedge;
  bool m_is_forward;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_LEVEL_SET_WALK_H
