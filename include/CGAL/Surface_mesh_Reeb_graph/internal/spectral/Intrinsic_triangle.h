// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGLE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGLE_H

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A triangle given by the lengths of its edges; edge i lies opposite to corner i.
class Intrinsic_triangle
{
public:
  explicit Intrinsic_triangle(const std::array<double, 3>& lengths)
    : m_lengths(lengths), m_area(stable_area(lengths))
  {}

  double area() const { return m_area; }

  // The cotangent of the angle at corner i.
  double cotangent(int i) const { return twice_dot_product(i) / (4 * m_area); }

  // The sum of the three cotangents; it is smallest, sqrt(3), for equilateral triangles and
  // infinite for those without area.
  double sum_of_cotangents() const
  {
    return (square(m_lengths[0]) + square(m_lengths[1]) + square(m_lengths[2])) / (4 * m_area);
  }

  // The part of the area that belongs to corner i: its Voronoi region, or if the triangle is obtuse
  // half of the area at the obtuse corner and a quarter at the others (Meyer, Desbrun, Schroeder,
  // Barr, "Discrete differential-geometry operators for triangulated 2-manifolds", 2003, Section
  // 3.3).
  double mixed_voronoi_area(int i) const
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (twice_dot_product(i) < 0)
      return m_area / 2;
    if (twice_dot_product(j) < 0 || twice_dot_product(k) < 0)
      return m_area / 4;
    return (cotangent(j) * square(m_lengths[j]) + cotangent(k) * square(m_lengths[k])) / 8;
  }

private:
  static double square(double x) { return x * x; }

  // Of the two edge vectors that leave corner i; negative iff the corner is obtuse.
  double twice_dot_product(int i) const
  {
    return square(m_lengths[(i + 1) % 3]) + square(m_lengths[(i + 2) % 3]) - square(m_lengths[i]);
  }

  // Heron's formula in Kahan's order of operations, exact to rounding for needles too.
  static double stable_area(std::array<double, 3> l)
  {
    std::sort(l.begin(), l.end());
    const double a = l[2], b = l[1], c = l[0];
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return std::sqrt((std::max)(product, 0.)) / 4;
  }

  std::array<double, 3> m_lengths;
  double m_area;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_INTRINSIC_TRIANGLE_H
