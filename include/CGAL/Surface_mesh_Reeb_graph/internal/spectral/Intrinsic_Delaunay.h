// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_DELAUNAY_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_DELAUNAY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangulation.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Makes an intrinsic triangulation Delaunay by flipping edges within the surface: the cotangents of
// the two angles opposite to every edge that is not on a border then have a sum that is not
// negative (Bobenko and Springborn, "A discrete Laplace-Beltrami operator for simplicial surfaces",
// 2007). The surface stays the same, its metric included; on borders nothing changes. Vertices may
// get edges to themselves, and several edges in common.
//
// Every flip decreases the sum of the cotangents of all angles (the harmonic index). Only flips are
// made that decrease the computed sum by more than what rounding can do to it, so that no
// triangulation comes back and the algorithm ends. Triangles that rounding would leave without area
// have an infinite sum and never come into being.
//
// On the meshes in use it takes O(n) flips; no polynomial bound is known.
class Intrinsic_Delaunay
{
public:
  // `glued` as made by `glued_sides()`; both are changed in place by `flip_all()`.
  Intrinsic_Delaunay(Intrinsic_triangulation& triangulation, std::vector<Triangle_side>& glued)
    : m_triangulation(triangulation), m_glued(glued)
  {
    CGAL_precondition(glued.size() == 3 * triangulation.triangles.size());
  }

  // Flips edges until none is left to flip; returns the number of flips.
  std::size_t flip_all()
  {
    std::vector<Triangle_side> waiting;
    std::vector<bool> is_waiting(m_glued.size(), false);
    const auto add = [&](Triangle_side side) {
      if (m_glued[side] == no_triangle_side || is_waiting[side] || is_waiting[m_glued[side]])
        return;
      is_waiting[side] = true;
      waiting.push_back(side);
    };
    for (std::size_t side = m_glued.size(); side > 0; --side)
      add(static_cast<Triangle_side>(side - 1));

    std::size_t number_of_flips = 0;
    while (!waiting.empty()) {
      const Triangle_side side = waiting.back();
      waiting.pop_back();
      is_waiting[side] = false;
      const Triangle_side other = m_glued[side];
      if (!flip(side))
        continue;
      ++number_of_flips;
      for (Triangle_side s : {side, following(following(side)), other, following(following(other))})
        add(s);
    }
    return number_of_flips;
  }

private:
  // The next side of the same triangle.
  static Triangle_side following(Triangle_side side) { return side % 3 == 2 ? side - 2 : side + 1; }

  double& length(Triangle_side side)
  {
    return m_triangulation.triangles[side / 3].lengths[side % 3];
  }

  Intrinsic_triangle triangle(Triangle_side side) const
  {
    return Intrinsic_triangle(m_triangulation.triangles[side / 3].lengths);
  }

  // Flips the edge of the side, which is not on a border, if it is not Delaunay; returns whether it
  // did.
  bool flip(Triangle_side side)
  {
    const Triangle_side other = m_glued[side];
    CGAL_precondition(other != no_triangle_side);
    CGAL_assertion(m_glued[other] == side && length(other) == length(side));
    // A triangle that is glued to itself has equal angles at the edge: it is Delaunay.
    if (side / 3 == other / 3)
      return false;

    // In the order of the triangle with `side` the corners are c, a, b, the other's are d, b, a:
    // the edge from a to b is to become one from c to d.
    const Triangle_side side_bc = following(side), side_ca = following(side_bc);
    const Triangle_side side_ad = following(other), side_db = following(side_ad);
    const double ab = length(side), bc = length(side_bc), ca = length(side_ca);
    const double ad = length(side_ad), db = length(side_db);
    const Intrinsic_triangle abc = triangle(side), bad = triangle(other);

    // The rounding errors of cotangents are in proportion to the sum of all.
    const double sum = abc.sum_of_cotangents() + bad.sum_of_cotangents();
    constexpr double tolerance = 32 * std::numeric_limits<double>::epsilon();
    if (!(abc.cotangent(static_cast<int>(side % 3)) + bad.cotangent(static_cast<int>(other % 3)) <
          -tolerance * sum))
      return false;

    // both triangles laid out in the plane, on both sides of the edge
    const double x = ((ca - bc) * (ca + bc) - (ad - db) * (ad + db)) / (2 * ab);
    const double y = 2 * (abc.area() + bad.area()) / ab;
    const double cd = std::hypot(x, y);
    const Intrinsic_triangle cad({ca, ad, cd}), dbc({db, bc, cd});
    if (!(cad.sum_of_cotangents() + dbc.sum_of_cotangents() < (1 - tolerance) * sum))
      return false;

    // The sides ca and db keep their numbers, bc and ad take those of the sides of the edge.
    m_triangulation.triangles[side / 3].corners[side_ca % 3] =
        m_triangulation.triangles[other / 3].corners[other % 3];
    m_triangulation.triangles[other / 3].corners[side_db % 3] =
        m_triangulation.triangles[side / 3].corners[side % 3];
    length(side) = ad;
    length(other) = bc;
    length(side_bc) = cd;
    length(side_ad) = cd;
    const auto moved = [&](Triangle_side s) {
      return s == side_bc ? other : s == side_ad ? side : s;
    };
    const Triangle_side beyond_bc = moved(m_glued[side_bc]), beyond_ad = moved(m_glued[side_ad]);
    glue(side, beyond_ad);
    glue(other, beyond_bc);
    glue(side_bc, side_ad);
    return true;
  }

  void glue(Triangle_side side, Triangle_side other)
  {
    m_glued[side] = other;
    if (other != no_triangle_side)
      m_glued[other] = side;
  }

  Intrinsic_triangulation& m_triangulation;
  std::vector<Triangle_side>& m_glued;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_DELAUNAY_H
