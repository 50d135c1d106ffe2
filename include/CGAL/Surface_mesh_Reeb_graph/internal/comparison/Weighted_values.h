// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_WEIGHTED_VALUES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_WEIGHTED_VALUES_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A distribution on the line: values with weights that are not negative.
class Weighted_values
{
public:
  void add(double value, double weight) { m_values.emplace_back(value, weight); }

  // The means of the quantile function over `number` intervals of equal length. Means depend
  // continuously on the weights, which single values do not; and where every value changes by at
  // most d, so does every mean.
  std::vector<double> mean_quantiles(std::size_t number)
  {
    CGAL_precondition(number > 0);
    std::sort(m_values.begin(), m_values.end());
    double total = 0;
    for (const auto& value : m_values)
      total += value.second;
    CGAL_precondition(total > 0);
    std::vector<double> means;
    means.reserve(number);
    const double share = total / static_cast<double>(number);
    std::size_t i = 0;
    double rest = m_values[0].second; // of the weight of value i
    for (std::size_t k = 0; k < number; ++k) {
      // relative to the first value, so that a mean of equal values is that value
      const double first = m_values[i].first;
      double missing = share, sum = 0;
      while (rest < missing && i + 1 < m_values.size()) {
        sum += rest * (m_values[i].first - first);
        missing -= rest;
        rest = m_values[++i].second;
      }
      sum += missing * (m_values[i].first - first);
      rest -= missing;
      means.push_back(first + sum / share);
    }
    return means;
  }

private:
  std::vector<std::pair<double, double>> m_values;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_WEIGHTED_VALUES_H
