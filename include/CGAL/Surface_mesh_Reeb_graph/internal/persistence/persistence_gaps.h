// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_PERSISTENCE_GAPS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_PERSISTENCE_GAPS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Extremum_pairing.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The persistence of a pair as a fraction of the range of its component, of which the half is given.
inline double relative_persistence(double lower_value, double upper_value, double half_range)
{
  const double half = half_of_difference(lower_value, upper_value);
  return half == 0 ? 0. : half / half_range;
}

inline double relative_persistence(const Extremum_pair& pair,
                                   const std::vector<double>& values,
                                   double half_range)
{
  return pair.side == BELOW
             ? relative_persistence(values[pair.extremum], values[pair.saddle], half_range)
             : relative_persistence(values[pair.saddle], values[pair.extremum], half_range);
}

// The persistences of the pairs of a Reeb graph that can be cancelled, absolute or relative.
inline std::vector<double> branch_persistences(const std::vector<double>& values,
                                               const std::vector<Arc_ends>& ends,
                                               bool is_absolute)
{
  const std::vector<double> half_ranges = fractions_of_component_ranges(values, ends, 0.5);
  std::vector<double> result;
  for (const Extremum_pair& pair :
       Extremum_pairing(values, ends, [](std::uint32_t) { return true; }).run())
    result.push_back(is_absolute ? pair.persistence
                                 : relative_persistence(pair, values, half_ranges[pair.extremum]));
  return result;
}

// A gap between persistences that follow each other, zero included.
struct Gap
{
  double lower = 0, upper = 0;

  double width() const { return upper - lower; }

  // In the middle; between neighboring numbers there is none, and the upper one separates them: what
  // has that persistence is not below it.
  double threshold() const
  {
    const double middle = lower + width() / 2;
    return middle > lower ? middle : upper;
  }
};

// All gaps between finite persistences, from the lowest to the highest.
inline std::vector<Gap> persistence_gaps(std::vector<double> persistences)
{
  std::sort(persistences.begin(), persistences.end());
  std::vector<Gap> result;
  double lower = 0;
  for (const double upper : persistences) {
    if (upper == lower || !std::isfinite(upper))
      continue;
    result.push_back({lower, upper});
    lower = upper;
  }
  return result;
}

// The k-th widest of some gaps, which increase; of equally wide ones the higher one comes first. If
// there are fewer, the empty gap at zero.
inline Gap kth_widest_gap(std::vector<Gap> gaps, std::size_t k)
{
  if (k > gaps.size())
    return {};
  const auto kth = gaps.begin() + static_cast<std::ptrdiff_t>(k - 1);
  std::nth_element(gaps.begin(), kth, gaps.end(), [](const Gap& a, const Gap& b) {
    return a.width() != b.width() ? a.width() > b.width() : a.upper > b.upper;
  });
  return *kth;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_PERSISTENCE_PERSISTENCE_GAPS_H
