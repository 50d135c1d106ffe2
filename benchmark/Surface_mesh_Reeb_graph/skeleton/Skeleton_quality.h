// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How good a curve skeleton is, whoever has made it.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/skeleton/Surface_tree.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Reeb_graph_benchmark {

using Point = CGAL::Surface_mesh_Reeb_graph::internal::Coordinates;
using Polyline = std::vector<Point>;

// A visitor that collects the polylines of a graph whose vertices have a member `point`.
template <class Skeleton>
struct Polyline_collector
{
  const Skeleton& skeleton;
  std::vector<Polyline>& polylines;

  void start_new_polyline() { polylines.emplace_back(); }
  void add_node(typename boost::graph_traits<Skeleton>::vertex_descriptor v)
  {
    polylines.back().push_back(
        CGAL::Surface_mesh_Reeb_graph::internal::coordinates(skeleton[v].point));
  }
  void end_polyline() {}
};

template <class Skeleton>
std::vector<Polyline> polylines_of(const Skeleton& skeleton)
{
  std::vector<Polyline> result;
  Polyline_collector<Skeleton> collector{skeleton, result};
  CGAL::split_graph_into_polylines(skeleton, collector);
  return result;
}

struct Skeleton_quality
{
  double inside;   // the part of the length
  double centered; // the mean of shorter / longer distance to the surface in the normal plane
  double turning;  // degrees for every diagonal of length

  // Points are looked at every 500th of the diagonal, in eight directions and the opposite ones.
  static Skeleton_quality
  measure(const std::vector<Polyline>& polylines,
          const CGAL::Surface_mesh_Reeb_graph::internal::Surface_tree& surface,
          double diagonal)
  {
    using namespace CGAL::Surface_mesh_Reeb_graph::internal;
    constexpr int directions = 8;
    double length = 0, inside = 0, centered = 0, seen = 0, turning = 0;
    for (const Polyline& polyline : polylines)
      for (std::size_t i = 1; i < polyline.size(); ++i) {
        const Point d = difference_of(polyline[i], polyline[i - 1]);
        const double segment = length_of(d);
        if (segment == 0)
          continue;
        if (i + 1 < polyline.size()) {
          const Point e = difference_of(polyline[i + 1], polyline[i]);
          turning += std::atan2(length_of(cross_product_of(d, e)), scalar_product(d, e));
        }
        Point axis = {};
        axis[std::abs(d[0]) < 0.9 * segment ? 0 : 1] = 1;
        const Point u = normalized(cross_product_of(d, axis)),
                    w = normalized(cross_product_of(d, u));
        const int n = (std::max)(1, static_cast<int>(500 * segment / diagonal));
        for (int k = 0; k < n; ++k) {
          const Point p = moved(polyline[i - 1], (k + 0.5) / n, d);
          length += segment / n;
          if (!surface.encloses(p))
            continue;
          inside += segment / n;
          double sum = 0;
          int met = 0;
          for (int j = 0; j < directions; ++j) {
            const double angle = CGAL_PI * j / directions;
            const Line_hits hits =
                surface.hits(p, moved(moved({}, std::cos(angle), u), std::sin(angle), w));
            const double a = hits.forward(), b = hits.backward();
            if (a == Line_hits::none || b == Line_hits::none)
              continue;
            sum += (std::min)(a, b) / (std::max)(a, b);
            ++met;
          }
          if (met > 0) {
            centered += segment / n * sum / met;
            seen += segment / n;
          }
        }
      }
    return {inside / length, centered / seen, turning * 180 / CGAL_PI / (length / diagonal)};
  }

private:
  static Point normalized(const Point& v)
  {
    return CGAL::Surface_mesh_Reeb_graph::internal::moved(
        {}, 1 / CGAL::Surface_mesh_Reeb_graph::internal::length_of(v), v);
  }
};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H
