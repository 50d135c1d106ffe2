// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_BATCH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_BATCH_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_star.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The stars of several vertices that follow each other in the order. In memory such vertices lie
// far apart, and every step around one of them is a cache miss. So the stars are read interleaved,
// an edge of each, and their misses overlap.
template <class TriangleMesh>
class Vertex_star_batch
{
  using Star = Vertex_star<TriangleMesh>;
  using vertex_descriptor = typename Star::vertex_descriptor;
  using halfedge_descriptor = typename Star::halfedge_descriptor;

public:
  static constexpr std::size_t capacity = 16;

  Star& operator[](std::size_t i) { return m_stars[i]; }

  // Reads the edges around `size` vertices, at most `capacity`.
  void read(const vertex_descriptor* vertices, std::size_t size, const TriangleMesh& tmesh)
  {
    CGAL_precondition(size <= capacity);
    std::array<std::size_t, capacity> active;
    std::size_t number_of_active = 0;
    for (std::size_t i = 0; i < size; ++i) {
      m_stars[i].clear();
      if (!has_no_edge(vertices[i], tmesh)) {
        m_stars[i].halfedges.push_back(halfedge(vertices[i], tmesh));
        active[number_of_active++] = i;
      }
    }
    while (number_of_active > 0) {
      for (std::size_t k = 0; k < number_of_active;) {
        std::vector<halfedge_descriptor>& star = m_stars[active[k]].halfedges;
        const halfedge_descriptor h = opposite(next(star.back(), tmesh), tmesh);
        if (h == star.front()) {
          active[k] = active[--number_of_active];
        } else {
          check_walk(star.size(), tmesh);
          star.push_back(h);
          ++k;
        }
      }
    }
  }

private:
  std::array<Star, capacity> m_stars;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_BATCH_H
