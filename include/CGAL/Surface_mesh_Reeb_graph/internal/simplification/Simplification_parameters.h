// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_PARAMETERS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_PARAMETERS_H

#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What the user asks for.
struct Simplification_parameters
{
  double threshold, loop_threshold;
  std::size_t gap; // the k-th widest one, instead of the threshold; 0 if the threshold counts
  std::size_t number_of_leaves; // the largest number if there is no limit
  bool is_absolute;
};

// A number that a user may give in any integer type.
template <class Number>
std::size_t checked_number(Number number, const char* message)
{
  static_assert(std::is_integral<Number>::value, "the parameter is an integer");
  if constexpr (std::is_signed<Number>::value)
    CGAL_precondition_msg(number >= 0, message);
  CGAL_USE(message);
  return static_cast<std::size_t>(number);
}

// Reads the named parameters of simplify_Reeb_graph().
template <class NamedParameters>
Simplification_parameters simplification_parameters(const NamedParameters& np)
{
  const Simplification_parameters result = {
      static_cast<double>(choose_own_parameter(np, tags::persistence_threshold, 0.)),
      static_cast<double>(choose_own_parameter(np, tags::loop_persistence_threshold, 0.)),
      checked_number(choose_own_parameter(np, tags::persistence_gap, std::size_t(0)),
                     "the number of the persistence gap is negative"),
      checked_number(choose_own_parameter(
                         np, tags::number_of_leaves, (std::numeric_limits<std::size_t>::max)()),
                     "the number of leaves is negative"),
      choose_own_parameter(np, tags::threshold_is_absolute, false)};
  CGAL_precondition_msg(result.threshold >= 0,
                        "the persistence threshold is negative or not a number");
  CGAL_precondition_msg(result.loop_threshold >= 0,
                        "the persistence threshold of the loops is negative or not a number");
  CGAL_precondition_msg(result.gap == 0 || result.threshold == 0,
                        "a persistence threshold and a persistence gap exclude each other");
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFICATION_PARAMETERS_H
