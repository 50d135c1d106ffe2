// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_LINE_HITS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_LINE_HITS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Triangle_tree.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// How far it is from a point to the surface in a direction and in the opposite one: the traits of a
// traversal of a tree of triangles. One traversal finds both, in double precision, which is several
// times faster than two rays with intersections that are decided exactly; and where to move a point
// needs no more.
class Line_hits
{
  using Triangle = Triangle_tree_types::Kernel::Triangle_3;

public:
  static constexpr double none = (std::numeric_limits<double>::infinity)();

  // What lies nearer than `nearest` is passed over.
  Line_hits(const Coordinates& origin, const Coordinates& direction, double nearest = 0)
    : m_origin(origin), m_direction(direction), m_nearest(nearest)
  {}

  double forward() const { return m_forward; }
  double backward() const { return m_backward; }

  // The triangles met there; null if there is none.
  const Triangle* forward_triangle() const { return m_forward_triangle; }
  const Triangle* backward_triangle() const { return m_backward_triangle; }

  bool go_further() const { return true; }

  template <class Query, class Primitive>
  void intersection(const Query&, const Primitive& primitive)
  {
    const Triangle& triangle = *primitive.id();
    const Coordinates a = coordinates(triangle[0]);
    const Coordinates u = difference_of(coordinates(triangle[1]), a);
    const Coordinates v = difference_of(coordinates(triangle[2]), a);
    const Coordinates p = cross_product_of(m_direction, v);
    const double determinant = scalar_product(u, p);
    if (determinant == 0)
      return;
    const Coordinates s = difference_of(m_origin, a);
    const double x = scalar_product(s, p) / determinant;
    if (!(x >= 0 && x <= 1))
      return;
    const Coordinates q = cross_product_of(s, u);
    const double y = scalar_product(m_direction, q) / determinant;
    if (!(y >= 0 && x + y <= 1))
      return;
    const double t = scalar_product(v, q) / determinant;
    if (t > m_nearest && t < m_forward) {
      m_forward = t;
      m_forward_triangle = &triangle;
    }
    if (-t > m_nearest && -t < m_backward) {
      m_backward = -t;
      m_backward_triangle = &triangle;
    }
  }

  template <class Query, class Node>
  bool do_intersect(const Query&, const Node& node) const
  {
    const auto& box = node.bbox();
    double begin = -m_backward, end = m_forward;
    for (int i = 0; i < 3; ++i) {
      const double lower = box.min(i) - m_origin[i], upper = box.max(i) - m_origin[i];
      if (m_direction[i] == 0) {
        if (lower > 0 || upper < 0)
          return false;
        continue;
      }
      double first = lower / m_direction[i], last = upper / m_direction[i];
      if (last < first)
        std::swap(first, last);
      begin = first > begin ? first : begin;
      end = last < end ? last : end;
    }
    return begin <= end;
  }

private:
  Coordinates m_origin, m_direction;
  double m_nearest, m_forward = none, m_backward = none;
  const Triangle *m_forward_triangle = nullptr, *m_backward_triangle = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_LINE_HITS_H
