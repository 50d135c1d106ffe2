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

inline double scalar_product(const Coordinates& u, const Coordinates& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline Coordinates cross_product_of(const Coordinates& u, const Coordinates& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// The point p + t v.
inline Coordinates moved(const Coordinates& p, double t, const Coordinates& v)
{
  return {p[0] + t * v[0], p[1] + t * v[1], p[2] + t * v[2]};
}

inline double triangle_area(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  return length_of(cross_product_of(difference_of(q, p), difference_of(r, p))) / 2;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_COORDINATES_H
