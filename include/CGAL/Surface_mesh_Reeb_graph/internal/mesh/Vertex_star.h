// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/cold_function.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The lowest vertex that a wedge leads to, or something like a wedge, with a position that tells
// which one it is.
template <class VertexDescriptor>
struct Lowest_vertex
{
  VertexDescriptor vertex;
  std::size_t position;
};

template <class VertexDescriptor, class VertexOrder>
void sort_by_lowest_vertices(std::vector<Lowest_vertex<VertexDescriptor>>& wedges,
                             const VertexOrder& order)
{
  using Lowest = Lowest_vertex<VertexDescriptor>;
  constexpr std::size_t few = 16;
  if (wedges.size() > few) {
    std::vector<VertexDescriptor> vertices;
    for (const Lowest& wedge : wedges)
      vertices.push_back(wedge.vertex);
    std::vector<Lowest> sorted;
    for (const std::uint32_t i : sorted_positions<CGAL::Sequential_tag>(vertices, order))
      sorted.push_back(wedges[i]);
    wedges = std::move(sorted);
    return;
  }
  for (std::size_t i = 1; i < wedges.size(); ++i) // insertion sort
    for (std::size_t k = i; k > 0 && order(wedges[k].vertex, wedges[k - 1].vertex); --k)
      std::swap(wedges[k - 1], wedges[k]);
}

// The edges around a vertex in cyclic order, and their wedges: runs of edges that lead to the same
// side of the level of the vertex, each joined to the next one by a face. A component of the level
// set just below (above) the vertex passes through a lower (upper) wedge from one end to the other.
template <class TriangleMesh>
class Vertex_star
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  struct Wedge
  {
    std::size_t begin, end; // positions of its edges
    bool is_upper;
    bool is_linked; // whether a face joins its last edge to the first edge of the next wedge
  };

  void clear()
  {
    halfedges.clear();
    wedges.clear();
  }

  // Reads the edges around a vertex, and finds their wedges.
  template <class VertexOrder>
  void read(vertex_descriptor v, const TriangleMesh& tmesh, const VertexOrder& order)
  {
    clear();
    for_each_halfedge_to(v, tmesh, [&](halfedge_descriptor h) { halfedges.push_back(h); });
    find_wedges(v, tmesh, order);
  }

  // Finds the wedges when the edges have been read. These are rotated so that no wedge goes across
  // the end of their list.
  template <class VertexOrder>
  void find_wedges(vertex_descriptor v, const TriangleMesh& tmesh, const VertexOrder& order)
  {
    wedges.clear();
    const std::size_t size = halfedges.size();
    if (size == 0)
      return;
    m_is_above.clear();
    for (halfedge_descriptor h : halfedges)
      m_is_above.push_back(order(v, source(h, tmesh)));

    const auto begins_wedge = [&](std::size_t i) {
      const std::size_t previous = i == 0 ? size - 1 : i - 1;
      return m_is_above[previous] != m_is_above[i] || is_border(halfedges[previous], tmesh);
    };
    std::size_t begin = 0;
    while (begin < size && !begins_wedge(begin))
      ++begin;
    if (begin != 0 && begin != size) { // a closed fan that leads to one side begins anywhere
      const auto first = static_cast<std::ptrdiff_t>(begin);
      std::rotate(halfedges.begin(), halfedges.begin() + first, halfedges.end());
      std::rotate(m_is_above.begin(), m_is_above.begin() + first, m_is_above.end());
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (i == 0 || begins_wedge(i))
        wedges.push_back({i, i, m_is_above[i] != 0, false});
      wedges.back().end = i + 1;
      wedges.back().is_linked = !is_border(halfedges[i], tmesh);
    }
  }

  std::size_t number_of_wedges(bool is_upper) const
  {
    return static_cast<std::size_t>(std::count_if(
        wedges.begin(), wedges.end(), [&](const Wedge& w) { return w.is_upper == is_upper; }));
  }

  // Whether the faces form one closed fan.
  bool is_closed() const
  {
    return !wedges.empty() &&
           std::all_of(wedges.begin(), wedges.end(), [](const Wedge& w) { return w.is_linked; });
  }

  // The edge of a wedge whose other end comes first.
  template <class Less>
  halfedge_descriptor
  lowest_edge(const Wedge& wedge, const TriangleMesh& tmesh, const Less& less) const
  {
    CGAL_precondition(wedge.begin < wedge.end && wedge.end <= halfedges.size());
    return *std::min_element(halfedges.begin() + wedge.begin,
                             halfedges.begin() + wedge.end,
                             [&](halfedge_descriptor g, halfedge_descriptor h) {
                               return less(source(g, tmesh), source(h, tmesh));
                             });
  }

  // Rotates a closed fan of alternating lower and upper wedges such that it begins with the lower
  // wedge that has the lowest vertex: a beginning that does not depend on how the data structure
  // circulates.
  template <class Less>
  CGAL_REEB_GRAPH_COLD void begin_at_lowest_vertex(const TriangleMesh& tmesh, const Less& less)
  {
    CGAL_precondition(is_closed() && wedges.size() % 2 == 0);
    std::size_t first = wedges.size();
    halfedge_descriptor lowest = halfedges.front();
    for (std::size_t w = 0; w < wedges.size(); ++w) {
      if (wedges[w].is_upper)
        continue;
      const halfedge_descriptor h = lowest_edge(wedges[w], tmesh, less);
      if (first == wedges.size() || less(source(h, tmesh), source(lowest, tmesh))) {
        first = w;
        lowest = h;
      }
    }
    const std::size_t shift = wedges[first].begin, size = halfedges.size();
    std::rotate(halfedges.begin(), halfedges.begin() + shift, halfedges.end());
    std::rotate(wedges.begin(), wedges.begin() + first, wedges.end());
    for (Wedge& wedge : wedges) {
      const std::size_t length = wedge.end - wedge.begin;
      wedge.begin = (wedge.begin + size - shift) % size;
      wedge.end = wedge.begin + length;
      CGAL_assertion(wedge.end <= size);
    }
    CGAL_postcondition(!wedges.front().is_upper && wedges.front().begin == 0);
  }

  // An option unfolds a vertex with more than two wedges on either side in a closed fan into simple
  // saddles. Returns their number, or 1 if there is nothing to unfold.
  std::size_t number_of_simple_saddles() const
  {
    const std::size_t number = wedges.size() / 2;
    return number > 2 && is_closed() ? number - 1 : 1;
  }

  std::vector<halfedge_descriptor> halfedges; // that point to the vertex
  std::vector<Wedge> wedges;                  // in cyclic order

private:
  std::vector<char> m_is_above;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_STAR_H
