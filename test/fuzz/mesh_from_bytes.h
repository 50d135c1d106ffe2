// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small triangle mesh and a function from any bytes: few pieces, changed step by step, each step
// keeping the mesh valid. What a fuzzer changes in the bytes changes little in the mesh.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_MESH_FROM_BYTES_H
#define SURFACE_MESH_REEB_GRAPH_TEST_MESH_FROM_BYTES_H

#include "../Surface_mesh_Reeb_graph/random_Reeb_graph_cases.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace Reeb_graph_test {

// Zeros follow the last byte.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_next(data), m_end(data + size) {}

  bool empty() const { return m_next == m_end; }
  std::size_t next() { return empty() ? 0 : *m_next++; }
  std::size_t below(std::size_t n) { return next() % n; }

private:
  const std::uint8_t* m_next;
  const std::uint8_t* m_end;
};

class Mesh_from_bytes
{
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;

public:
  // The oracles are slow.
  static constexpr std::size_t largest_number_of_vertices = 32;

  // One mesh in three stays closed, because most of what is known of Reeb graphs holds there.
  Mesh_from_bytes(Bytes& bytes, Mesh& mesh)
    : m_bytes(bytes), m_mesh(mesh), m_stays_closed(bytes.below(3) == 0)
  {
    append_piece();
    for (std::size_t steps = m_bytes.next(); steps > 0 && !m_bytes.empty() && m_is_manifold;
         --steps)
      step();
  }

  // `false` if the last step has closed the faces around a vertex where others touch it: these are
  // out of reach from there, and the mesh is an error.
  bool is_manifold() const { return m_is_manifold; }

private:
  bool has_room_for(const std::size_t number_of_vertices) const
  {
    return m_mesh.number_of_vertices() + number_of_vertices <= largest_number_of_vertices;
  }

  template <class Range>
  auto any_of(const Range& range)
  {
    return *std::next(range.begin(), m_bytes.below(range.size()));
  }

  void step()
  {
    switch (m_bytes.below(m_stays_closed ? 6 : 10)) {
    case 0:
      return append_piece();
    case 1:
      return append_isolated_vertex();
    case 2:
      return remove_isolated_vertex();
    case 3:
      return split_face();
    case 4:
      return collapse_edge();
    case 5:
      return flip_edge();
    case 6:
      return remove_face();
    case 7: // to the next border edge: closes holes
      return add_face_to_border([this](Halfedge h) { return m_mesh.target(m_mesh.next(h)); });
    case 8: // grows the border
      return add_face_to_border([this](Halfedge) { return m_mesh.add_vertex(); });
    default: // to any vertex: pinched vertices, new handles, one component out of two
      return add_face_to_border([this](Halfedge) { return any_of(m_mesh.vertices()); });
    }
  }

  void append_piece()
  {
    Index_mesh piece;
    switch (m_bytes.below(m_stays_closed ? 5 : 8)) {
    case 0:
      piece.points.resize(4);
      piece.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
      break;
    case 1:
      piece = sphere(0);
      break;
    case 2:
      piece = torus(3, 3);
      break;
    case 3:
      piece = closed_surface(2);
      break;
    case 4: // two triangles, back to back
      piece.points.resize(3);
      piece.triangles = {{0, 1, 2}, {0, 2, 1}};
      break;
    case 5:
      piece.points.resize(3);
      piece.triangles = {{0, 1, 2}};
      break;
    case 6:
      piece = grid(2, 2);
      break;
    default:
      piece = cylinder(3, 2);
      break;
    }
    if (!has_room_for(piece.points.size()))
      return;
    std::vector<Vertex> added;
    make_mesh(piece, m_mesh, added);
  }

  void append_isolated_vertex()
  {
    if (has_room_for(1))
      m_mesh.add_vertex();
  }

  void remove_isolated_vertex()
  {
    for (const Vertex v : m_mesh.vertices()) {
      if (m_mesh.is_isolated(v)) {
        m_mesh.remove_vertex(v);
        return;
      }
    }
  }

  // Vertices that are left alone go too.
  void remove_face()
  {
    if (m_mesh.number_of_faces() > 0)
      CGAL::Euler::remove_face(m_mesh.halfedge(any_of(m_mesh.faces())), m_mesh);
  }

  void split_face()
  {
    if (m_mesh.number_of_faces() > 0 && has_room_for(1))
      CGAL::Euler::add_center_vertex(m_mesh.halfedge(any_of(m_mesh.faces())), m_mesh);
  }

  void collapse_edge()
  {
    if (m_mesh.number_of_edges() == 0)
      return;
    const Edge e = any_of(m_mesh.edges());
    // Where surfaces touch in a vertex only, the condition does not see all of them.
    if (!is_pinched(m_mesh.vertex(e, 0)) && !is_pinched(m_mesh.vertex(e, 1)) &&
        CGAL::Euler::does_satisfy_link_condition(e, m_mesh))
      CGAL::Euler::collapse_edge(e, m_mesh);
  }

  void flip_edge()
  {
    if (m_mesh.number_of_edges() == 0)
      return;
    const Halfedge h = m_mesh.halfedge(any_of(m_mesh.edges())), opposite = m_mesh.opposite(h);
    if (m_mesh.is_border(h) || m_mesh.is_border(opposite))
      return;
    const Vertex u = m_mesh.target(m_mesh.next(h)), v = m_mesh.target(m_mesh.next(opposite));
    if (u != v && !m_mesh.halfedge(u, v).is_valid())
      CGAL::Euler::flip_edge(h, m_mesh);
  }

  // `third_vertex` gives the third corner from the border halfedge that the face is to have.
  template <class Third_vertex>
  void add_face_to_border(const Third_vertex& third_vertex)
  {
    std::vector<Halfedge> border;
    for (const Halfedge h : m_mesh.halfedges())
      if (m_mesh.is_border(h))
        border.push_back(h);
    if (border.empty() || !has_room_for(1))
      return;
    const Halfedge h = any_of(border);
    const std::array<Vertex, 3> corners = {m_mesh.source(h), m_mesh.target(h), third_vertex(h)};
    // It adds nothing where an edge would have three faces.
    if (CGAL::Euler::add_face(corners, m_mesh) == Mesh::null_face())
      return;
    for (const Vertex v : corners) {
      const auto reached = m_mesh.halfedges_around_target(m_mesh.halfedge(v));
      m_is_manifold =
          m_is_manifold && std::distance(reached.begin(), reached.end()) ==
                               std::count_if(m_mesh.halfedges().begin(),
                                             m_mesh.halfedges().end(),
                                             [&](Halfedge k) { return m_mesh.target(k) == v; });
    }
  }

  bool is_pinched(const Vertex v) const
  {
    std::size_t number_of_borders = 0;
    for (const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      number_of_borders += m_mesh.is_border(h);
    return number_of_borders > 1;
  }

  Bytes& m_bytes;
  Mesh& m_mesh;
  bool m_stays_closed;
  bool m_is_manifold = true;
};

// The values of `n` vertices: small whole numbers with many ties, or distinct ones, or what
// floating point numbers can be at worst, NaN excepted.
inline std::vector<double> values_from_bytes(Bytes& bytes, const std::size_t n)
{
  using Limits = std::numeric_limits<double>;
  static const std::array<double, 9> extreme_values = {-Limits::infinity(),
                                                       Limits::lowest(),
                                                       -1,
                                                       -Limits::denorm_min(),
                                                       -0.,
                                                       0.,
                                                       Limits::denorm_min(),
                                                       (Limits::max)(),
                                                       Limits::infinity()};
  std::vector<double> values(n);
  const std::size_t kind = bytes.below(4);
  std::mt19937 rng(static_cast<unsigned>(bytes.next()));
  switch (kind) {
  case 0:
    for (double& value : values)
      value = double(bytes.next());
    break;
  case 1:
    for (double& value : values)
      value = extreme_values[bytes.below(extreme_values.size())];
    break;
  case 2:
    values = random_integer_values(n, 1 + bytes.below(8), rng);
    break;
  default:
    values = random_values(n, rng);
    break;
  }
  return values;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_MESH_FROM_BYTES_H
