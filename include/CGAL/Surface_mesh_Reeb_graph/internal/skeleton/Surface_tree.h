// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_SURFACE_TREE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_SURFACE_TREE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Line_hits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Triangle_tree.h>

#include <CGAL/Polygon_mesh_processing/internal/Side_of_triangle_mesh/Point_inside_vertical_ray_cast.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What a curve asks about the surface around it. The triangles are those of a mesh of any type and
// kernel, in double precision; their degenerate ones, whose points other triangles have as well,
// are left out. Whether a point or a segment is inside is decided exactly.
class Surface_tree
{
  using Kernel = Triangle_tree_types::Kernel;
  using Point = Kernel::Point_3;
  using Triangle = Kernel::Triangle_3;
  // what CGAL::Side_of_triangle_mesh does, which wants a mesh to make the tree of
  using Side = CGAL::internal::Point_inside_vertical_ray_cast<Kernel, Triangle_tree>;

public:
  void add(const Coordinates& p, const Coordinates& q, const Coordinates& r)
  {
    const Triangle triangle(point(p), point(q), point(r));
    if (!triangle.is_degenerate())
      m_triangles.push_back(triangle);
  }

  // To be called when all triangles are there, and before anything is asked.
  void build()
  {
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.do_not_accelerate_distance_queries();
    m_tree.build();
  }

  bool is_empty() const { return m_triangles.empty(); }

  // How far it is to the surface on a line, in both directions.
  Line_hits hits(const Coordinates& origin, const Coordinates& direction, double nearest = 0) const
  {
    Line_hits result(origin, direction, nearest);
    m_tree.traversal(0, result);
    return result;
  }

  // The distance to the surface, 0 if there is none.
  double distance(const Coordinates& p) const
  {
    if (is_empty())
      return 0;
    // a corner of what lies in the direction of an axis is near: the search begins there
    Point hint = m_triangles.front()[0];
    for (int i = 0; i < 3; ++i) {
      Coordinates direction = {0, 0, 0};
      direction[i] = 1;
      const Line_hits line = hits(p, direction);
      for (const auto* triangle : {line.forward_triangle(), line.backward_triangle()})
        if (triangle != nullptr &&
            CGAL::compare_distance(point(p), (*triangle)[0], hint) == CGAL::SMALLER)
          hint = (*triangle)[0];
    }
    return distance_between(p, coordinates(m_tree.closest_point(point(p), hint)));
  }

  // The triangles must be those of closed surfaces.
  bool encloses(const Coordinates& p) const
  {
    return !is_empty() && Side()(point(p), m_tree) == CGAL::ON_BOUNDED_SIDE;
  }

  // Whether a segment meets the surface elsewhere than in an end of its that is a corner there.
  bool is_crossed(const Coordinates& p, const Coordinates& q) const
  {
    if (is_empty() || p == q)
      return false;
    const Point a = point(p), b = point(q);
    std::vector<Triangle_tree::Primitive_id> crossed;
    m_tree.all_intersected_primitives(Kernel::Segment_3(a, b), std::back_inserter(crossed));
    for (const auto& triangle : crossed)
      if (!meets_only_in_corner(*triangle, a, b) && !meets_only_in_corner(*triangle, b, a))
        return true;
    return false;
  }

  // Whether all points between the ends of a segment are inside.
  bool encloses_segment(const Coordinates& p, const Coordinates& q) const
  {
    if (p == q)
      return encloses(p);
    if (is_empty() || is_crossed(p, q))
      return false;
    return encloses(q) || encloses(p) ||
           encloses({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
  }

private:
  static Point point(const Coordinates& p) { return Point(p[0], p[1], p[2]); }

  static bool meets_only_in_corner(const Triangle& triangle, const Point& end, const Point& other)
  {
    for (int i = 0; i < 3; ++i)
      if (triangle[i] == end)
        return CGAL::orientation(triangle[0], triangle[1], triangle[2], other) != CGAL::COPLANAR;
    return false;
  }

  std::vector<Triangle> m_triangles;
  Triangle_tree m_tree;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_SURFACE_TREE_H
