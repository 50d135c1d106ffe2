// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_EDGE_NUMBERS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_EDGE_NUMBERS_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Numbers of the edges, by the indices of their halfedges. (CGAL's own initialized index map of
// edges cannot be used for a polyhedron without ids.)
template <class TriangleMesh, class HalfedgeIndexMap>
class Edge_numbers
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  Edge_numbers(const TriangleMesh& tmesh, HalfedgeIndexMap halfedge_index_map)
    : m_tmesh(tmesh), m_halfedge_index_map(halfedge_index_map)
  {
    // the halfedges of an edge usually have the numbers 2 i and 2 i + 1
    for (const auto e : CGAL::make_range(edges(tmesh))) {
      const halfedge_descriptor h = halfedge(e, tmesh);
      const std::size_t i = halfedge_index(h), j = halfedge_index(opposite(h, tmesh));
      m_are_halfedges_paired = m_are_halfedges_paired && i / 2 == j / 2;
      m_bound = (std::max)(m_bound, (std::max)(i, j) + 1);
    }
    if (m_bound >= (std::numeric_limits<std::uint32_t>::max)())
      throw Input_error("the mesh has more than 2^32 - 2 halfedges");
    if (m_are_halfedges_paired)
      m_bound = (m_bound + 1) / 2;
  }

  // One more than the largest number.
  std::size_t bound() const { return m_bound; }

  std::size_t operator()(halfedge_descriptor h) const
  {
    const std::size_t i = halfedge_index(h);
    const std::size_t number =
        m_are_halfedges_paired ? i / 2 : (std::min)(i, halfedge_index(opposite(h, m_tmesh)));
    CGAL_assertion(number < m_bound);
    return number;
  }

private:
  std::size_t halfedge_index(halfedge_descriptor h) const
  {
    return static_cast<std::size_t>(get(m_halfedge_index_map, h));
  }

  const TriangleMesh& m_tmesh;
  HalfedgeIndexMap m_halfedge_index_map;
  bool m_are_halfedges_paired = true;
  std::size_t m_bound = 0;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_EDGE_NUMBERS_H
