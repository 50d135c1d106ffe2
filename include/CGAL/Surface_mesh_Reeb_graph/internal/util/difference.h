// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DIFFERENCE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DIFFERENCE_H

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The difference `upper - lower` of two values in `double`, also of infinite ones: equal values have
// difference 0. Numbers that are not floating-point ones may have more digits: what is converted is
// the difference, exactly or nearly.
template <class FT>
double difference(const FT& lower, const FT& upper)
{
  CGAL_precondition(!(upper < lower));
  if constexpr (std::is_floating_point<FT>::value) {
    return lower == upper ? 0. : static_cast<double>(upper - lower);
  } else if constexpr (std::is_integral<FT>::value) {
    // in unsigned numbers, modulo a power of two, the difference does not overflow
    return static_cast<double>(static_cast<std::uintmax_t>(upper) -
                               static_cast<std::uintmax_t>(lower));
  } else {
    return CGAL::to_double(upper - lower);
  }
}

// The half of it, which does not overflow: for quotients.
template <class FT>
double half_of_difference(const FT& lower, const FT& upper)
{
  if constexpr (std::is_floating_point<FT>::value)
    return lower == upper ? 0. : static_cast<double>(upper / 2 - lower / 2);
  else
    return difference(lower, upper) / 2;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_DIFFERENCE_H
