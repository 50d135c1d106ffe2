// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_LOGARITHMIC_DIFFERENCE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_LOGARITHMIC_DIFFERENCE_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The mean of |x - y| over the entries of two lists of the same length.
inline double mean_difference(const std::vector<double>& x, const std::vector<double>& y)
{
  CGAL_precondition(x.size() == y.size() && !x.empty());
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += std::abs(x[i] - y[i]);
  return sum / static_cast<double>(x.size());
}

// The mean of |s log(1 + x/s) - s log(1 + y/s)| for entries that are not negative: about |x - y| for
// those below the scale s, less above, and never more.
inline double mean_logarithmic_difference(const std::vector<double>& x,
                                          const std::vector<double>& y,
                                          double scale)
{
  CGAL_precondition(x.size() == y.size() && !x.empty());
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] != y[i]) // rounded in the same way for y and x
      sum += std::log((scale + (std::max)(x[i], y[i])) / (scale + (std::min)(x[i], y[i])));
  return scale * sum / static_cast<double>(x.size());
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_LOGARITHMIC_DIFFERENCE_H
