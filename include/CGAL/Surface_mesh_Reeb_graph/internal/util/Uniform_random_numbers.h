// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_UNIFORM_RANDOM_NUMBERS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_UNIFORM_RANDOM_NUMBERS_H

#include <cstdint>
#include <random>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Uniform numbers of [-1/2, 1/2). Those of the distributions of the standard library differ between
// its implementations; the generator itself does not.
class Uniform_random_numbers
{
public:
  explicit Uniform_random_numbers(std::uint64_t seed) : m_generator(seed) {}

  double next()
  {
    constexpr double unit = 1. / 9007199254740992.; // 2^-53
    return static_cast<double>(m_generator() >> 11) * unit - 0.5;
  }

private:
  std::mt19937_64 m_generator;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_UNIFORM_RANDOM_NUMBERS_H
