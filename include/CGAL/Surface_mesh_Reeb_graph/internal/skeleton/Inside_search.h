// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_INSIDE_SEARCH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_INSIDE_SEARCH_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Contours.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Curve_network.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Line_hits.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Surface_tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Finds curves inside of a solid. Where the centroid of a contour is outside, or cannot be reached
// from the one before, other points compete: those in the middle of the solid as seen from points of
// the contour, inwards. The shortest way through one point of every contour is taken. If there is
// none, more contours are put in between.
class Inside_search
{
public:
  Inside_search(const Surface_tree& surface, double diagonal)
    : m_surface(surface), m_diagonal(diagonal)
  {}

  // Points inside that belong to a contour, its centroid first.
  std::vector<Coordinates> inner_points(const Contour& contour) const
  {
    constexpr std::size_t most_rays = 12;
    std::vector<Coordinates> result;
    const auto add = [&](const Coordinates& p) {
      if (m_surface.encloses(p))
        result.push_back(p);
    };
    add(contour.centroid);
    const std::size_t n = contour.normals.size();
    const std::size_t rays = (std::min)(most_rays, n);
    for (std::size_t k = 0; k < rays; ++k) {
      const std::size_t i = k * n / rays;
      const double length = length_of(contour.normals[i]);
      if (!(length > 0))
        continue;
      const Coordinates direction = moved({}, 1 / length, contour.normals[i]);
      const Coordinates& p = contour.points[i];
      const Line_hits hits = m_surface.hits(p, direction, 1e-9 * m_diagonal);
      if (hits.backward() != Line_hits::none)
        add(moved(p, -hits.backward() / 2, direction));
      else if (hits.forward() != Line_hits::none) // a surface that is oriented inwards
        add(moved(p, hits.forward() / 2, direction));
    }
    return result;
  }

  // The point with most room around it among those that see the most of `others`.
  bool place_node(const std::vector<Contour>& contours,
                  const std::vector<Coordinates>& others,
                  Coordinates& point) const
  {
    std::vector<Coordinates> candidates;
    if (m_surface.encloses(point))
      candidates.push_back(point);
    for (const Contour& contour : contours)
      for (const Coordinates& p : inner_points(contour))
        candidates.push_back(p);
    std::size_t most = 0;
    double widest = -1;
    for (const Coordinates& p : candidates) {
      std::size_t seen = 0;
      for (const Coordinates& other : others)
        seen += m_surface.is_crossed(p, other) ? 0 : 1;
      const double room = m_surface.distance(p);
      if (seen > most || (seen == most && room > widest)) {
        most = seen;
        widest = room;
        point = p;
      }
    }
    return !candidates.empty();
  }

  // Puts the points of a curve inside; returns whether all of its segments are then.
  template <class Contours>
  bool put_inside(const Contours& contours,
                  const Arc_routes::Route& route,
                  Curve_network& network,
                  Curve& curve) const
  {
    constexpr int most_rounds = 5;
    std::vector<bool> is_bad = bad_segments(network, curve);
    for (int round = 0; round < most_rounds && contains_bad(is_bad); ++round) {
      if (round > 0) {
        // without more contours the choice would be the same again
        if (!insert_contours(contours, route, is_bad, curve))
          break;
        is_bad = bad_segments(network, curve);
      }
      choose_points(contours, route, is_bad, network, curve);
      is_bad = bad_segments(network, curve);
    }
    return !contains_bad(is_bad);
  }

private:
  static bool contains_bad(const std::vector<bool>& is_bad)
  {
    return std::find(is_bad.begin(), is_bad.end(), true) != is_bad.end();
  }

  std::vector<bool> bad_segments(const Curve_network& network, const Curve& curve) const
  {
    std::vector<bool> result;
    for (std::size_t i = 1; i < network.size(curve); ++i)
      result.push_back(
          !m_surface.encloses_segment(network.point(curve, i - 1), network.point(curve, i)));
    return result;
  }

  // Puts contours into the segments that are not inside; returns whether there were any to put.
  template <class Contours>
  bool insert_contours(const Contours& contours,
                       const Arc_routes::Route& route,
                       const std::vector<bool>& is_bad,
                       Curve& curve) const
  {
    constexpr std::size_t parts = 4;
    const std::size_t stations = contours.number_of_stations(route);
    std::vector<Curve_point> points;
    for (std::size_t s = 0; s < is_bad.size(); ++s) {
      if (is_bad[s]) {
        // the stations between the ends of the segment
        const std::size_t begin = s == 0 ? 0 : curve.points[s - 1].station + 1;
        const std::size_t end = s < curve.points.size() ? curve.points[s].station : stations;
        const std::size_t n = end > begin ? end - begin : 0;
        const std::size_t number = (std::min)(n, parts);
        for (std::size_t k = 0; k < number; ++k) {
          const std::size_t station = begin + (2 * k + 1) * n / (2 * number);
          const Contour contour = contours.contour(route, station);
          points.push_back({contour.centroid, contour.diameter(), station});
        }
      }
      if (s < curve.points.size())
        points.push_back(curve.points[s]);
    }
    const bool has_more = points.size() > curve.points.size();
    curve.points = points;
    return has_more;
  }

  template <class Contours>
  void choose_points(const Contours& contours,
                     const Arc_routes::Route& route,
                     const std::vector<bool>& is_bad,
                     const Curve_network& network,
                     Curve& curve) const
  {
    constexpr std::size_t reach = 2; // how far from a bad segment points may change
    const std::size_t n = network.size(curve);
    std::vector<std::vector<Coordinates>> candidates(n);
    for (std::size_t i = 0; i < n; ++i) {
      candidates[i].push_back(network.point(curve, i));
      if (i == 0 || i + 1 == n)
        continue;
      const std::size_t first = i > reach ? i - reach : 0;
      const std::size_t last = (std::min)(i + reach, is_bad.size());
      const bool is_near = std::find(is_bad.begin() + static_cast<std::ptrdiff_t>(first),
                                     is_bad.begin() + static_cast<std::ptrdiff_t>(last),
                                     true) != is_bad.begin() + static_cast<std::ptrdiff_t>(last);
      if (!is_near)
        continue;
      std::vector<Coordinates> inner =
          inner_points(contours.contour(route, curve.points[i - 1].station));
      if (m_surface.encloses(candidates[i].front()))
        inner.push_back(candidates[i].front());
      if (!inner.empty())
        candidates[i] = inner;
    }
    const std::vector<std::size_t> chosen = shortest_way(candidates);
    for (std::size_t i = 1; i + 1 < n; ++i)
      curve.points[i - 1].point = candidates[i][chosen[i]];
  }

  // One candidate of each, such that as few segments as possible are not inside, and then that the
  // way is short.
  std::vector<std::size_t>
  shortest_way(const std::vector<std::vector<Coordinates>>& candidates) const
  {
    const double penalty = 10 * m_diagonal * static_cast<double>(candidates.size());
    std::vector<std::vector<double>> cost(candidates.size());
    std::vector<std::vector<std::size_t>> before(candidates.size());
    cost[0].assign(candidates[0].size(), 0);
    before[0].assign(candidates[0].size(), 0);
    for (std::size_t i = 1; i < candidates.size(); ++i)
      for (const Coordinates& p : candidates[i]) {
        double least = (std::numeric_limits<double>::infinity)();
        std::size_t best = 0;
        for (std::size_t k = 0; k < candidates[i - 1].size(); ++k) {
          const Coordinates& q = candidates[i - 1][k];
          double sum = cost[i - 1][k] + distance_between(p, q);
          if (sum < least)
            sum += m_surface.encloses_segment(q, p) ? 0 : penalty;
          if (sum < least) {
            least = sum;
            best = k;
          }
        }
        cost[i].push_back(least);
        before[i].push_back(best);
      }
    std::vector<std::size_t> result(candidates.size(), 0);
    result.back() = static_cast<std::size_t>(
        std::min_element(cost.back().begin(), cost.back().end()) - cost.back().begin());
    for (std::size_t i = candidates.size() - 1; i > 0; --i)
      result[i - 1] = before[i][result[i]];
    return result;
  }

  const Surface_tree& m_surface;
  double m_diagonal;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_INSIDE_SEARCH_H
