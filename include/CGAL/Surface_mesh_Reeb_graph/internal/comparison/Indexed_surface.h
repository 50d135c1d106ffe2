// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INDEXED_SURFACE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INDEXED_SURFACE_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/Weighted_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// How many numbers describe the geometry. All are part of the format of signatures.
constexpr std::size_t number_of_section_levels = 32;
constexpr std::size_t number_of_sections = 6; // per level
constexpr std::size_t number_of_bands = 4;
constexpr std::size_t number_of_distance_quantiles = 16;

// A triangle mesh with a function, scaled to area 1. The level sets are those of the function that
// is linear on the faces, at levels that are no values of vertices.
class Indexed_surface
{
public:
  Indexed_surface(std::vector<Eigen::Vector3d> points,
                  std::vector<std::array<std::uint32_t, 3>> faces,
                  std::vector<double> values,
                  std::vector<double> areas)
    : m_points(std::move(points))
    , m_faces(std::move(faces))
    , m_values(std::move(values))
    , m_areas(std::move(areas))
    , m_order(m_values.size())
  {
    const double area = std::accumulate(m_areas.begin(), m_areas.end(), 0.);
    CGAL_precondition(area > 0);
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (std::size_t v = 0; v < m_points.size(); ++v)
      center += m_areas[v] / area * m_points[v];
    for (Eigen::Vector3d& point : m_points)
      point = (point - center) / std::sqrt(area);
    for (double& a : m_areas)
      a /= area;
    std::iota(m_order.begin(), m_order.end(), 0);
    std::stable_sort(m_order.begin(), m_order.end(), [this](std::uint32_t v, std::uint32_t w) {
      return m_values[v] < m_values[w];
    });
  }

  // For every one of the levels that halve bands of equal area, the lengths of the longest
  // components of the level set in decreasing order, or zeros.
  std::vector<double> section_lengths() const
  {
    std::vector<double> result;
    for (const std::uint32_t v : vertices_at_equal_areas(number_of_section_levels)) {
      std::vector<double> lengths = component_lengths(m_values[v]);
      std::sort(lengths.begin(), lengths.end(), std::greater<double>());
      lengths.resize(number_of_sections, 0.);
      result.insert(result.end(), lengths.begin(), lengths.end());
    }
    return result;
  }

  // For every pair of the bands between the quartiles of the function the quantiles of the distance
  // in space of a point in one and a point in the other one.
  std::vector<double> band_distances() const
  {
    constexpr std::size_t number_of_samples = 120; // per band
    const std::vector<std::uint32_t> samples =
        vertices_at_equal_areas(number_of_bands * number_of_samples);
    std::vector<double> result;
    for (std::size_t a = 0; a < number_of_bands; ++a) {
      for (std::size_t b = a; b < number_of_bands; ++b) {
        Weighted_values distances;
        for (std::size_t i = 0; i < number_of_samples; ++i)
          for (std::size_t j = 0; j < number_of_samples; ++j)
            distances.add((m_points[samples[a * number_of_samples + i]] -
                           m_points[samples[b * number_of_samples + j]])
                              .norm(),
                          1.);
        const std::vector<double> quantiles =
            distances.mean_quantiles(number_of_distance_quantiles);
        result.insert(result.end(), quantiles.begin(), quantiles.end());
      }
    }
    return result;
  }

  // The volume, for a surface with a border that of the cones over its center.
  double volume() const
  {
    double sum = 0;
    for (const auto& f : m_faces)
      sum += m_points[f[0]].dot(m_points[f[1]].cross(m_points[f[2]]));
    return std::abs(sum) / 6;
  }

private:
  // The vertices at the middles of `number` parts of equal area, in the order of the function.
  std::vector<std::uint32_t> vertices_at_equal_areas(std::size_t number) const
  {
    std::vector<std::uint32_t> result;
    double area = 0;
    for (const std::uint32_t v : m_order) {
      area += m_areas[v];
      while (result.size() < number &&
             area >= (static_cast<double>(result.size()) + .5) / static_cast<double>(number))
        result.push_back(v);
    }
    CGAL_assertion(result.size() == number);
    return result;
  }

  // The level is just above `level`.
  std::vector<double> component_lengths(double level) const
  {
    std::unordered_map<std::uint64_t, std::uint32_t> number_of_edge;
    Disjoint_sets components;
    std::vector<double> lengths;
    for (const auto& f : m_faces) {
      const std::array<bool, 3> is_above = {
          {m_values[f[0]] > level, m_values[f[1]] > level, m_values[f[2]] > level}};
      if (is_above[0] == is_above[1] && is_above[1] == is_above[2])
        continue;
      std::array<std::uint32_t, 2> ends = {};
      std::array<Eigen::Vector3d, 2> points;
      std::size_t number_of_ends = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (is_above[i] == is_above[j])
          continue;
        const std::uint32_t v = is_above[i] ? f[j] : f[i], w = is_above[i] ? f[i] : f[j];
        const auto entry = number_of_edge.emplace(std::uint64_t(v) << 32 | w,
                                                  static_cast<std::uint32_t>(lengths.size()));
        if (entry.second) {
          components.add();
          lengths.push_back(0.);
        }
        ends[number_of_ends] = entry.first->second;
        const double t = (level - m_values[v]) / (m_values[w] - m_values[v]);
        points[number_of_ends++] = m_points[v] + t * (m_points[w] - m_points[v]);
      }
      CGAL_assertion(number_of_ends == 2);
      const std::uint32_t u = components.root(ends[0]), w = components.root(ends[1]);
      if (u != w) {
        components.join(u, w);
        lengths[w] += lengths[u];
        lengths[u] = 0;
      }
      lengths[w] += (points[0] - points[1]).norm();
    }
    return lengths;
  }

  std::vector<Eigen::Vector3d> m_points;
  std::vector<std::array<std::uint32_t, 3>> m_faces;
  std::vector<double> m_values;
  std::vector<double> m_areas;
  std::vector<std::uint32_t> m_order; // the vertices by increasing values
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INDEXED_SURFACE_H
