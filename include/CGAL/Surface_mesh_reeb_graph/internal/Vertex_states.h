// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_VERTEX_STATES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_VERTEX_STATES_H

#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/concurrency.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// What one pass over the faces tells of every vertex, in a byte: of how many faces it is the middle vertex,
// up to a bound, and whether it lies on the border. A vertex in the interior is regular if and only if it is the
// middle vertex of two faces: around it the edges change from lower to upper ones and back once.
class Vertex_states
{
public:
  explicit Vertex_states(std::size_t index_bound) : m_states(index_bound, 0) {}

  // Makes the pass. `key(v)` gives what vertices are compared by. Returns false if the keys of a face are
  // not distinct; the states mean nothing then.
  template <class ConcurrencyTag, class TriangleMesh, class VertexIndexMap, class Key>
  bool classify(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map, const Key& key)
  {
    std::fill(m_states.begin(), m_states.end(), std::uint8_t(0));
    m_has_border = m_has_faceless_edges = false;
    const auto range = faces(tmesh);
    std::vector<Part> parts(number_of_parts<ConcurrencyTag>(m_states.size()));
    const std::size_t number_of_faces =
        static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    for_each_part<ConcurrencyTag>(parts.size(), [&](std::size_t p) {
      Part& part = parts[p];
      if (p > 0) // the first part works in place
        part.states.assign(m_states.size(), 0);
      auto begin = std::next(range.begin(), difference(number_of_faces * p / parts.size()));
      auto end = std::next(range.begin(), difference(number_of_faces * (p + 1) / parts.size()));
      pass(tmesh, begin, end, vertex_index_map, key, part, p > 0 ? part.states : m_states);
    });

    bool is_strict = true, have_three_edges = true;
    for (const Part& part : parts) {
      is_strict = is_strict && part.is_strict;
      have_three_edges = have_three_edges && part.has_three_edges;
      for (std::size_t i = 0; i < part.states.size(); ++i)
        m_states[i] = sum(m_states[i], part.states[i]);
    }
    // if no face has less than three edges, the number of all edges tells whether one has more
    const auto all_halfedges = halfedges(tmesh);
    std::size_t number_of_inner_halfedges =
        static_cast<std::size_t>(std::distance(all_halfedges.begin(), all_halfedges.end()));
    if (number_of_inner_halfedges != 3 * number_of_faces)
      number_of_inner_halfedges -= mark_border(tmesh, vertex_index_map);
    if (!have_three_edges || number_of_inner_halfedges != 3 * number_of_faces)
      throw Reeb_graph_error("the mesh has a face that is not a triangle");
    return is_strict;
  }

  // Whether a face has an edge that no other one has, or an edge has no face.
  bool has_border() const { return m_has_border; }
  bool has_faceless_edges() const { return m_has_faceless_edges; }

  // Whether the pass shows that a vertex is regular; all others need a closer look.
  bool is_regular(std::size_t i) const
  {
    const std::uint8_t state = m_states[i];
    return state == 2 || (state == (BORDER | 1) && !m_has_faceless_edges);
  }

  // Whether all edges of a vertex lead to the same side.
  bool is_extremum(std::size_t i) const
  {
    return number_of_changes(i) == 0 && (m_states[i] & PINCHED) == 0 && !m_has_faceless_edges;
  }

  bool is_on_border(std::size_t i) const { return (m_states[i] & BORDER) != 0; }

  // How often the edges around a vertex change from lower to upper ones or back.
  std::size_t number_of_changes(std::size_t i) const { return m_states[i] & LARGEST_NUMBER; }
  bool is_number_of_changes_exact(std::size_t i) const
  {
    return number_of_changes(i) < LARGEST_NUMBER;
  }

private:
  enum : std::uint8_t { LARGEST_NUMBER = 15, BORDER = 16, PINCHED = 32 };

  struct Part
  {
    std::vector<std::uint8_t> states;
    bool is_strict = true;
    bool has_three_edges = true; // every face, at least
  };

  static std::ptrdiff_t difference(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  static std::uint8_t sum(std::uint8_t a, std::uint8_t b)
  {
    return static_cast<std::uint8_t>((std::min)(int(a) + int(b), int(LARGEST_NUMBER)));
  }

  template <class TriangleMesh, class FaceIterator, class VertexIndexMap, class Key>
  static void pass(const TriangleMesh& tmesh,
                   FaceIterator begin,
                   FaceIterator end,
                   VertexIndexMap vertex_index_map,
                   const Key& key,
                   Part& part,
                   std::vector<std::uint8_t>& states)
  {
    // numbers in the place of truth values: no branches, which could not be predicted where the function is noisy
    unsigned is_strict = 1, has_three_edges = 1;
    for (FaceIterator f = begin; f != end; ++f) {
      // no need to read the third halfedge: the pass takes the time of its accesses to the memory
      const auto h0 = halfedge(*f, tmesh), h1 = next(h0, tmesh);
      const auto v0 = target(h0, tmesh), v1 = target(h1, tmesh), v2 = source(h0, tmesh);
      const auto k0 = key(v0), k1 = key(v1), k2 = key(v2);
      const unsigned a = k0 < k1, b = k1 < k2, c = k2 < k0;
      // values that are not numbers are not distinct either
      is_strict &= (a | unsigned(k1 < k0)) & (b | unsigned(k2 < k1)) & (c | unsigned(k0 < k2));
      has_three_edges &= unsigned(h1 != h0) & unsigned(next(h1, tmesh) != h0);
      const std::array<std::size_t, 3> indices = {
          static_cast<std::size_t>(get(vertex_index_map, v0)),
          static_cast<std::size_t>(get(vertex_index_map, v1)),
          static_cast<std::size_t>(get(vertex_index_map, v2))};
      // of the three comparisons two are alike; the middle vertex takes part in both
      std::uint8_t& state =
          states[indices[unsigned(a == b) + 2 * (unsigned(b == c) & unsigned(a != b))]];
      state = static_cast<std::uint8_t>(state + unsigned(state != LARGEST_NUMBER));
    }
    part.is_strict = is_strict != 0;
    part.has_three_edges = has_three_edges != 0;
  }

  // Returns the number of border halfedges.
  template <class TriangleMesh, class VertexIndexMap>
  std::size_t mark_border(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map)
  {
    std::size_t number_of_border_halfedges = 0;
    for (const auto h : CGAL::make_range(halfedges(tmesh))) {
      if (!is_border(h, tmesh))
        continue;
      ++number_of_border_halfedges;
      if (is_border(opposite(h, tmesh), tmesh))
        m_has_faceless_edges = true;
      // one border halfedge points to a vertex in every open fan
      std::uint8_t& state = m_states[get(vertex_index_map, target(h, tmesh))];
      state = static_cast<std::uint8_t>(state | ((state & BORDER) != 0 ? PINCHED : BORDER));
    }
    m_has_border = number_of_border_halfedges > 0;
    return number_of_border_halfedges;
  }

  std::vector<std::uint8_t> m_states; // by vertex index
  bool m_has_border = false, m_has_faceless_edges = false;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_VERTEX_STATES_H
