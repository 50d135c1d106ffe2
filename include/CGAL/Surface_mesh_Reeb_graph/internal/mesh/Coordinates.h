// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_COORDINATES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_COORDINATES_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A point or vector of any kernel as three numbers.
using Coordinates = std::array<double, 3>;

template <class Point_3>
Coordinates coordinates(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

inline Coordinates difference_of(const Coordinates& p, const Coordinates& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline double length_of(const Coordinates& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

inline double distance_between(const Coordinates& p, const Coordinates& q)
{
  return length_of(difference_of(p, q));
}

inline double triangle_area(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  const Coordinates a = difference_of(q, p), b = difference_of(r, p);
  return length_of(
             {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}) /
         2;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_COORDINATES_H
