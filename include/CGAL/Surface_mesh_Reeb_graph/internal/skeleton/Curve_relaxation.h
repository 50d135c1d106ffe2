// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_RELAXATION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_RELAXATION_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Curve_energy.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Curve_network.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Line_hits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Moves the points of curves to where they are centered in the shape and the curves turn little.
//
// In the plane normal to the curve, lines through a point meet the surface at the distances a and b
// on either side. The point is to be in the middle: what is off it counts in parts of a + b, with
// the slope that min(a, b) / max(a, b) has, which is steep near the middle, so that a few lines that
// leave through an armpit count little. Against that counts what the curve turns: the square of the
// curvature as long as it is small, so that it is even, and the curvature itself beyond that, so
// that it is not spread where the shape has a bend. Neither term depends on the unit, or on how dense
// the points are. The weights of the last step make both a sum of squares, whose minimum is where the
// points want to go.
//
// Inside of a solid a point goes there only as far as the segments to its neighbors do not cross the
// surface: curves that are inside stay inside.
class Curve_relaxation
{
public:
  Curve_relaxation(Curve_network& network,
                   const Surface_tree& surface,
                   const Surface_tree& solid,
                   double diagonal,
                   double smoothing,
                   bool keeps_inside)
    : m_network(network)
    , m_surface(surface)
    , m_solid(solid)
    , m_diagonal(diagonal)
    , m_smoothing(smoothing)
    , m_keeps_inside(keeps_inside)
  {}

  // One step; returns the largest move, in parts of the diameter.
  double relax()
  {
    number_points();
    Curve_energy energy(m_points, m_is_fixed);
    for (std::size_t c = 0; c < m_network.curves.size(); ++c)
      add_terms(c, energy);
    return accept(energy.minimum());
  }

  // Smooths the curves only, with every point held where it is.
  std::vector<Coordinates> smooth()
  {
    number_points();
    Curve_energy energy(m_points, m_is_fixed);
    for (std::size_t c = 0; c < m_network.curves.size(); ++c) {
      add_bending(c, energy);
      for (std::size_t i = 1; i + 1 < m_numbers[c].size(); ++i) {
        const std::size_t number = m_numbers[c][i];
        // a contour of no length is a point of degenerate faces
        if (diameter(c, i) > 0)
          energy.add_target(number, m_points[number], weight(c, i) / square(diameter(c, i)));
      }
    }
    return energy.minimum();
  }

  // Takes the points as they come from `smooth()`.
  void set_points(const std::vector<Coordinates>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      set_point(i, points[i]);
  }

private:
  static double square(double x) { return x * x; }

  // All points in one row, the nodes first.
  void number_points()
  {
    m_points.clear();
    m_is_fixed.clear();
    m_owners.clear();
    m_numbers.clear();
    m_neighbors.clear();
    for (std::size_t n = 0; n < m_network.nodes.size(); ++n) {
      m_points.push_back(m_network.nodes[n].point);
      m_is_fixed.push_back(m_network.nodes[n].is_fixed);
      m_owners.push_back({none, n});
    }
    for (std::size_t c = 0; c < m_network.curves.size(); ++c) {
      const Curve& curve = m_network.curves[c];
      m_numbers.push_back({curve.lower});
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        m_numbers.back().push_back(m_points.size());
        m_points.push_back(curve.points[i].point);
        m_is_fixed.push_back(false);
        m_owners.push_back({c, i});
      }
      m_numbers.back().push_back(curve.upper);
    }
    m_neighbors.resize(m_points.size());
    for (std::size_t c = 0; c < m_numbers.size(); ++c)
      for (std::size_t i = 1; i < m_numbers[c].size(); ++i) {
        const std::size_t a = m_numbers[c][i - 1], b = m_numbers[c][i];
        m_neighbors[a].push_back({b, m_network.curves[c].is_in_solid});
        m_neighbors[b].push_back({a, m_network.curves[c].is_in_solid});
      }
  }

  // The length of curve that a point stands for.
  double weight(std::size_t c, std::size_t i) const
  {
    return (distance_between(m_points[m_numbers[c][i - 1]], m_points[m_numbers[c][i]]) +
            distance_between(m_points[m_numbers[c][i]], m_points[m_numbers[c][i + 1]])) /
           2;
  }

  // The change of direction at a point per length.
  double curvature(std::size_t c, std::size_t i) const
  {
    const Coordinates& p = m_points[m_numbers[c][i]];
    const Coordinates a = difference_of(p, m_points[m_numbers[c][i - 1]]);
    const Coordinates b = difference_of(m_points[m_numbers[c][i + 1]], p);
    const double turn = std::atan2(length_of(cross_product_of(a, b)), scalar_product(a, b));
    return weight(c, i) > 0 ? turn / weight(c, i) : 0;
  }

  double diameter(std::size_t c, std::size_t i) const
  {
    return m_network.curves[c].points[i - 1].diameter;
  }

  void add_bending(std::size_t c, Curve_energy& energy) const
  {
    // on the way of this length, in radians: beyond it a turn counts in proportion
    constexpr double gentle_turn = 0.1;
    const double scale = m_diagonal / 12;
    // with it, most curves are centered as well as those of a mean curvature flow, and turn half as
    // much
    constexpr double usual = 0.9;
    const std::vector<std::size_t>& numbers = m_numbers[c];
    for (std::size_t i = 1; i + 1 < numbers.size(); ++i) {
      const double turn = scale * curvature(c, i);
      energy.add_bending(numbers[i - 1],
                         numbers[i],
                         numbers[i + 1],
                         usual * m_smoothing * weight(c, i) * square(scale) /
                             (std::max)(1., turn / gentle_turn));
    }
  }

  // A node counts for each of its curves with the first segment.
  void add_terms(std::size_t c, Curve_energy& energy)
  {
    const std::vector<std::size_t>& numbers = m_numbers[c];
    std::vector<Curve_point>& points = m_network.curves[c].points;
    if (points.empty())
      return;
    for (std::size_t i = 1; i + 1 < numbers.size(); ++i)
      points[i - 1].diameter =
          add_centering(numbers[i],
                        difference_of(m_points[numbers[i + 1]], m_points[numbers[i - 1]]),
                        weight(c, i),
                        points[i - 1].diameter,
                        energy);
    const auto add_node = [&](std::size_t node, std::size_t next, double width) {
      const Coordinates direction = difference_of(m_points[next], m_points[node]);
      if (!m_is_fixed[node])
        add_centering(node, direction, length_of(direction), width, energy);
    };
    add_node(numbers.front(), numbers[1], points.front().diameter);
    add_node(numbers.back(), numbers[numbers.size() - 2], points.back().diameter);
    add_bending(c, energy);
  }

  // Adds the terms of a point at which the curve has a direction. Returns how wide the shape is
  // there, or what it has been thought to be if that cannot be seen.
  double add_centering(std::size_t number,
                       const Coordinates& tangent,
                       double length,
                       double width,
                       Curve_energy& energy) const
  {
    constexpr std::size_t number_of_lines = 8;
    // how much it counts that a point stays: there is nothing else along the curve
    constexpr double inertia = 0.5;
    const Coordinates p = m_points[number];
    if (length_of(tangent) > 0) {
      const std::array<Coordinates, 2> plane = plane_normal_to(tangent);
      std::array<Line, number_of_lines> lines;
      double sum_of_inverses = 0;
      std::size_t met = 0;
      for (std::size_t k = 0; k < number_of_lines; ++k) {
        const double angle = CGAL_PI * static_cast<double>(k) / number_of_lines;
        const Coordinates v =
            moved(moved({}, std::cos(angle), plane[0]), std::sin(angle), plane[1]);
        const Line_hits hits = m_surface.hits(p, v);
        if (hits.forward() == Line_hits::none || hits.backward() == Line_hits::none)
          continue;
        lines[met++] = {v, hits.forward() - hits.backward(), hits.forward() + hits.backward()};
        sum_of_inverses += 1 / (hits.forward() + hits.backward());
      }
      if (met > 0 && std::isfinite(sum_of_inverses))
        width = static_cast<double>(met) / sum_of_inverses;
      for (std::size_t k = 0; k < met; ++k) {
        constexpr double least = 0.1;
        const double off = (std::max)(std::abs(lines[k].difference) / lines[k].sum, least);
        energy.add_offset(number,
                          lines[k].direction,
                          lines[k].difference / 2,
                          4 * length / number_of_lines / square(lines[k].sum) /
                              (off * square(1 + off)));
      }
    }
    if (width > 0)
      energy.add_target(number, p, inertia * length / square(width));
    return width;
  }

  // What a line through a point meets on either side: the difference and the sum of the distances.
  struct Line
  {
    Coordinates direction;
    double difference, sum;
  };

  static std::array<Coordinates, 2> plane_normal_to(const Coordinates& v)
  {
    const std::size_t least = static_cast<std::size_t>(
        std::min_element(
            v.begin(), v.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }) -
        v.begin());
    Coordinates axis = {};
    axis[least] = 1;
    const Coordinates u = cross_product_of(v, axis), w = cross_product_of(v, u);
    return {moved({}, 1 / length_of(u), u), moved({}, 1 / length_of(w), w)};
  }

  double accept(const std::vector<Coordinates>& wanted)
  {
    double largest = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (m_is_fixed[i] || m_neighbors[i].empty())
        continue;
      const Coordinates p = m_points[i], step = difference_of(wanted[i], p);
      const std::size_t crossings = number_of_crossings(i, p);
      for (const double part : {1., 0.5, 0.25, 0.125}) {
        const Coordinates q = moved(p, part, step);
        if (number_of_crossings(i, q) > crossings)
          continue;
        set_point(i, q);
        if (m_owners[i].first != none) {
          const double width =
              m_network.curves[m_owners[i].first].points[m_owners[i].second].diameter;
          largest = (std::max)(largest, width > 0 ? part * length_of(step) / width : 0);
        }
        break;
      }
    }
    return largest;
  }

  // Among the segments to the neighbors in solids.
  std::size_t number_of_crossings(std::size_t i, const Coordinates& p) const
  {
    std::size_t result = 0;
    if (m_keeps_inside)
      for (const auto& neighbor : m_neighbors[i])
        if (neighbor.second && m_solid.is_crossed(p, m_points[neighbor.first]))
          ++result;
    return result;
  }

  void set_point(std::size_t i, const Coordinates& p)
  {
    m_points[i] = p;
    if (m_owners[i].first == none)
      m_network.nodes[m_owners[i].second].point = p;
    else
      m_network.curves[m_owners[i].first].points[m_owners[i].second].point = p;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Curve_network& m_network;
  const Surface_tree &m_surface, &m_solid;
  double m_diagonal, m_smoothing;
  bool m_keeps_inside;

  std::vector<Coordinates> m_points;
  std::vector<bool> m_is_fixed;
  std::vector<std::pair<std::size_t, std::size_t>> m_owners; // curve, or none, and place there
  std::vector<std::vector<std::size_t>> m_numbers;           // of the points of each curve
  std::vector<std::vector<std::pair<std::size_t, bool>>> m_neighbors; // and whether in a solid
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_CURVE_RELAXATION_H
