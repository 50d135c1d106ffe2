// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_NETWORK_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_NETWORK_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A point of a curve between two nodes.
struct Curve_point
{
  Coordinates point;
  double diameter;     // of the shape around it
  std::size_t station; // the contour that it comes from, of the route of its arc
};

// The curve of an arc, without the nodes that it joins.
struct Curve
{
  std::size_t lower, upper;
  std::vector<Curve_point> points;
  bool is_in_solid; // whether its component of the surface is closed
};

// A graph of curves in space.
struct Curve_network
{
  struct Node
  {
    Coordinates point;
    bool is_fixed;
  };

  std::vector<Node> nodes;
  std::vector<Curve> curves;

  // The points of a curve from node to node, by position: 0 is the lower node.
  std::size_t size(const Curve& curve) const { return curve.points.size() + 2; }

  const Coordinates& point(const Curve& curve, std::size_t i) const
  {
    CGAL_precondition(i < size(curve));
    if (i == 0)
      return nodes[curve.lower].point;
    return i <= curve.points.size() ? curve.points[i - 1].point : nodes[curve.upper].point;
  }

  std::vector<Coordinates> polyline(const Curve& curve) const
  {
    std::vector<Coordinates> result;
    for (std::size_t i = 0; i < size(curve); ++i)
      result.push_back(point(curve, i));
    return result;
  }
};

// A number of points between those of a polyline, at most, and how dense they are to be: their
// distance is a third of the shape's diameter, within bounds.
class Sampling
{
public:
  // `number` = 0: as many as the distances ask for.
  Sampling(double diagonal, std::size_t number) : m_diagonal(diagonal), m_number(number) {}

  bool has_number() const { return m_number > 0; }

  double distance(double diameter) const
  {
    return (std::min)((std::max)(diameter / 3, m_diagonal / 400), m_diagonal / 60);
  }

  // Places points anew on a curve. The corners that are left out are cut: `is_allowed` tells for a
  // segment whether that may be; where not, the corners stay.
  template <class IsAllowed>
  void resample(const Curve_network& network, Curve& curve, const IsAllowed& is_allowed) const
  {
    if (curve.points.empty())
      return;
    const std::vector<Coordinates> corners = network.polyline(curve);
    const std::size_t n = corners.size();
    // a parameter along the curve that the new points divide evenly
    std::vector<double> parameter(n, 0);
    for (std::size_t i = 1; i < n; ++i) {
      const double length = distance_between(corners[i - 1], corners[i]);
      const double diameter = (diameter_at(curve, i - 1) + diameter_at(curve, i)) / 2;
      parameter[i] = parameter[i - 1] + (m_number > 0 ? length : length / distance(diameter));
    }
    const double end = parameter.back();
    if (!(end > 0))
      return;
    const std::size_t segments =
        m_number > 0 ? m_number + 1 : static_cast<std::size_t>((std::max)(2., std::ceil(end)));
    std::vector<Curve_point> points;
    Coordinates last = corners.front();
    std::size_t last_corner = 0, corner = 0; // the corners not after the last, the new point
    for (std::size_t k = 1; k <= segments; ++k) {
      const double t = end * static_cast<double>(k) / static_cast<double>(segments);
      while (corner + 2 < n && parameter[corner + 1] <= t)
        ++corner;
      const double width = parameter[corner + 1] - parameter[corner];
      const double u = width > 0 ? (std::min)((t - parameter[corner]) / width, 1.) : 1;
      Coordinates next = corners.back();
      if (k < segments)
        for (int i = 0; i < 3; ++i)
          next[i] = (1 - u) * corners[corner][i] + u * corners[corner + 1][i];
      if (!is_allowed(last, next))
        for (std::size_t i = last_corner + 1; i <= corner; ++i)
          points.push_back({corners[i], diameter_at(curve, i), 0});
      if (k < segments)
        points.push_back(
            {next, (1 - u) * diameter_at(curve, corner) + u * diameter_at(curve, corner + 1), 0});
      last = next;
      last_corner = corner;
    }
    curve.points = points;
  }

private:
  // A node's is that of the point next to it.
  static double diameter_at(const Curve& curve, std::size_t i)
  {
    CGAL_precondition(!curve.points.empty());
    const std::size_t position = i == 0 ? 0 : (std::min)(i - 1, curve.points.size() - 1);
    return curve.points[position].diameter;
  }

  double m_diagonal;
  std::size_t m_number;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_NETWORK_H
