// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_CLASSIFICATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_CLASSIFICATION_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/concurrency.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A neighbor of a vertex that is lower and one that is higher; null if they are not known.
template <class TriangleMesh>
struct Monotone_neighbors
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  typename Graph_traits::vertex_descriptor below = Graph_traits::null_vertex();
  typename Graph_traits::vertex_descriptor above = Graph_traits::null_vertex();
};

// What one pass over the faces tells of every vertex, in a byte: of how many faces it is the middle
// vertex, up to a bound, and whether it lies on the border. A vertex in the interior is regular if
// and only if it is the middle vertex of two faces: around it the edges change from lower to upper
// ones and back once.
class Vertex_classification
{
public:
  explicit Vertex_classification(std::size_t index_bound) : m_states(index_bound, 0) {}

  std::size_t index_bound() const { return m_states.size(); }

  // Makes the pass. `key(v)` gives what vertices are compared by. Returns false if the keys of a
  // face are not distinct; the states mean nothing then. If there is a place for them, by vertex
  // index, the neighbors below and above are found for all vertices that are the middle ones of a
  // face.
  template <class ConcurrencyTag, class TriangleMesh, class VertexIndexMap, class Key>
  bool classify(const TriangleMesh& tmesh,
                VertexIndexMap vertex_index_map,
                const Key& key,
                std::vector<Monotone_neighbors<TriangleMesh>>* neighbors = nullptr)
  {
    using Neighbors = Monotone_neighbors<TriangleMesh>;

    std::fill(m_states.begin(), m_states.end(), std::uint8_t(0));
    if (neighbors != nullptr)
      neighbors->assign(m_states.size(), Neighbors());
    m_has_border = m_has_faceless_edges = false;
    const auto range = faces(tmesh);
    std::vector<Part> parts(number_of_parts<ConcurrencyTag>(m_states.size()));
    std::vector<std::vector<Neighbors>> neighbors_of_part(parts.size());
    const std::size_t number_of_faces =
        static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    for_each_part<ConcurrencyTag>(parts.size(), [&](std::size_t p) {
      Part& part = parts[p];
      if (p > 0) // the first part works in place
        part.states.assign(m_states.size(), 0);
      const std::size_t begin = number_of_faces * p / parts.size(),
                        end = number_of_faces * (p + 1) / parts.size();
      const auto pass_over = [&](auto* neighbors_found) {
        pass(tmesh,
             std::next(range.begin(), static_cast<std::ptrdiff_t>(begin)),
             end - begin,
             vertex_index_map,
             key,
             part,
             p > 0 ? part.states : m_states,
             neighbors_found);
      };
      if (neighbors == nullptr) {
        pass_over(static_cast<No_neighbors*>(nullptr));
        return;
      }
      if (p > 0)
        neighbors_of_part[p].assign(m_states.size(), Neighbors());
      pass_over(p > 0 ? &neighbors_of_part[p] : neighbors);
    });
    for (std::size_t p = 1; p < parts.size(); ++p)
      for (std::size_t i = 0; i < neighbors_of_part[p].size(); ++i)
        if ((*neighbors)[i].below == boost::graph_traits<TriangleMesh>::null_vertex())
          (*neighbors)[i] = neighbors_of_part[p][i];

    bool have_three_edges = true;
    std::size_t number_of_rising_halfedges = 0;
    for (const Part& part : parts) {
      have_three_edges = have_three_edges && part.have_three_edges;
      number_of_rising_halfedges += part.number_of_rising_halfedges;
      for (std::size_t i = 0; i < part.states.size(); ++i)
        m_states[i] = sum(m_states[i], part.states[i]);
    }
    // if no face has less than three edges, the number of all edges tells whether one has more
    const auto all_halfedges = halfedges(tmesh);
    const std::size_t number_of_halfedges =
        static_cast<std::size_t>(std::distance(all_halfedges.begin(), all_halfedges.end()));
    Border border;
    if (number_of_halfedges != 3 * number_of_faces)
      border = mark_border(tmesh, vertex_index_map, key);
    if (!have_three_edges ||
        number_of_halfedges != 3 * number_of_faces + border.number_of_halfedges)
      throw Input_error("the mesh has a face that is not a triangle");
    // Of the two halfedges of an edge one rises, or none if its values are equal, or one of them is
    // not a number.
    const std::size_t number_of_edges = number_of_halfedges / 2 - border.number_of_faceless_edges;
    return number_of_rising_halfedges + border.number_of_rising_halfedges == number_of_edges;
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

  struct No_neighbors // are wanted
  {
  };

  struct Part
  {
    std::vector<std::uint8_t> states;
    std::size_t number_of_rising_halfedges = 0;
    bool have_three_edges = true; // all faces, at least
  };

  struct Border
  {
    std::size_t number_of_halfedges = 0;
    std::size_t number_of_rising_halfedges = 0; // without those of edges that have no face
    std::size_t number_of_faceless_edges = 0;
  };

  static std::uint8_t sum(std::uint8_t a, std::uint8_t b)
  {
    return static_cast<std::uint8_t>((std::min)(int(a) + int(b), int(LARGEST_NUMBER)));
  }

  // Goes over `number` faces from `face` on, a few at a time: their middle vertices first, which
  // depend on nothing but the mesh, and then the counts, of which neighboring faces often share one
  // (each would depend on the one before).
  template <class TriangleMesh,
            class FaceIterator,
            class VertexIndexMap,
            class Key,
            class NeighborTable>
  static void pass(const TriangleMesh& tmesh,
                   FaceIterator face,
                   std::size_t number,
                   VertexIndexMap vertex_index_map,
                   const Key& key,
                   Part& part,
                   std::vector<std::uint8_t>& states,
                   NeighborTable* neighbors)
  {
    constexpr bool has_neighbors = !std::is_same<NeighborTable, No_neighbors>::value;
    using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

    constexpr std::size_t few = 16;
    std::array<std::size_t, few> middle;
    [[maybe_unused]] std::array<vertex_descriptor, few> lowest, highest;
    // numbers in the place of truth values: no branches, which could not be predicted where the
    // function is noisy
    unsigned have_three_edges = 1;
    while (number > 0) {
      const std::size_t size = (std::min)(number, middle.size());
      number -= size;
      unsigned number_of_rising_halfedges = 0;
      for (std::size_t i = 0; i < size; ++i, ++face) {
        // no need to read the third halfedge: the time of the pass is that of its cache misses
        const auto h0 = halfedge(*face, tmesh), h1 = next(h0, tmesh);
        have_three_edges &= unsigned(next(h1, tmesh) != h0);
        const auto v0 = target(h0, tmesh), v1 = target(h1, tmesh), v2 = source(h0, tmesh);
        const auto k0 = key(v0), k1 = key(v1), k2 = key(v2);
        const unsigned a = k0 < k1, b = k1 < k2, c = k2 < k0;
        number_of_rising_halfedges += a + b + c;
        const std::size_t i0 = static_cast<std::size_t>(get(vertex_index_map, v0)),
                          i1 = static_cast<std::size_t>(get(vertex_index_map, v1)),
                          i2 = static_cast<std::size_t>(get(vertex_index_map, v2));
        // of the three comparisons two agree; the middle vertex takes part in both
        const std::size_t other = b == c ? i2 : i0;
        middle[i] = a == b ? i1 : other;
        if constexpr (has_neighbors) {
          // by the comparisons: which corner is the lowest, and which one the highest
          constexpr std::array<std::uint8_t, 8> lowest_corner = {0, 0, 1, 0, 2, 2, 1, 0};
          constexpr std::array<std::uint8_t, 8> highest_corner = {0, 1, 2, 2, 0, 1, 0, 0};
          const std::array<vertex_descriptor, 3> corners = {v0, v1, v2};
          const unsigned comparisons = a + 2 * b + 4 * c;
          lowest[i] = corners[lowest_corner[comparisons]];
          highest[i] = corners[highest_corner[comparisons]];
        }
      }
      part.number_of_rising_halfedges += number_of_rising_halfedges;
      for (std::size_t i = 0; i < size; ++i) {
        std::uint8_t& state = states[middle[i]];
        state = static_cast<std::uint8_t>(state + unsigned(state != LARGEST_NUMBER));
        if constexpr (has_neighbors)
          (*neighbors)[middle[i]] = {lowest[i], highest[i]};
      }
    }
    part.have_three_edges = have_three_edges != 0;
  }

  template <class TriangleMesh, class VertexIndexMap, class Key>
  Border mark_border(const TriangleMesh& tmesh, VertexIndexMap vertex_index_map, const Key& key)
  {
    Border border;
    std::size_t number_of_faceless_halfedges = 0;
    for (const auto h : CGAL::make_range(halfedges(tmesh))) {
      if (!is_border(h, tmesh))
        continue;
      ++border.number_of_halfedges;
      if (is_border(opposite(h, tmesh), tmesh))
        ++number_of_faceless_halfedges;
      else if (key(source(h, tmesh)) < key(target(h, tmesh)))
        ++border.number_of_rising_halfedges;
      // one border halfedge points to a vertex in every open fan
      std::uint8_t& state = m_states[get(vertex_index_map, target(h, tmesh))];
      state = static_cast<std::uint8_t>(state | ((state & BORDER) != 0 ? PINCHED : BORDER));
    }
    border.number_of_faceless_edges = number_of_faceless_halfedges / 2;
    m_has_border = border.number_of_halfedges > 0;
    m_has_faceless_edges = number_of_faceless_halfedges > 0;
    return border;
  }

  std::vector<std::uint8_t> m_states; // by vertex index
  bool m_has_border = false, m_has_faceless_edges = false;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_VERTEX_CLASSIFICATION_H
