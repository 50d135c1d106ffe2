// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random functions on random meshes, and the components of their level sets as lists.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_LEVEL_SET_CASES_H
#define SURFACE_MESH_REEB_GRAPH_TEST_LEVEL_SET_CASES_H

#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>

#include <CGAL/property_map.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace Reeb_graph_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Halfedge = Mesh::Halfedge_index;
using Component = SMRG::Level_set_component<Mesh>;
using Components = SMRG::Level_set_components<Mesh, Value_map>;

constexpr double infinity = std::numeric_limits<double>::infinity();

inline std::vector<Component> below(const Components& components, const Vertex v)
{
  std::vector<Component> result;
  components.below(v, std::back_inserter(result));
  return result;
}

inline std::vector<Component> above(const Components& components, const Vertex v)
{
  std::vector<Component> result;
  components.above(v, std::back_inserter(result));
  return result;
}

inline std::vector<std::size_t> ranks_of(const Case& c)
{
  std::vector<std::size_t> rank(c.mesh.num_vertices());
  SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(rank));
  return rank;
}

inline void set_random_points(Case& c, std::mt19937& rng)
{
  for (const Vertex v : c.mesh.vertices())
    c.mesh.point(v) = Point(random_unit(rng), random_unit(rng), random_unit(rng));
}

// Values without ties, with many ties, and, if wanted, with infinite ones.
inline std::vector<double>
values_for_seed(const unsigned seed, const std::size_t n, std::mt19937& rng)
{
  if (seed % 3 == 0)
    return random_values(n, rng);
  std::vector<double> values = random_integer_values(n, 1 + random_index(9, rng), rng);
  if (seed % 3 == 1)
    for (double& value : values)
      value = value == 0 ? -infinity : value == 5 ? infinity : value;
  return values;
}

template <class Function>
void for_random_cases(const Function& function)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      Case c(mesh, values_for_seed(seed, mesh.points.size(), rng));
      set_random_points(c, rng);
      function(c);
    }
  }
}

inline std::vector<double> heights(const Index_mesh& mesh, const std::array<double, 3>& direction)
{
  std::vector<double> result;
  for (const auto& p : mesh.points)
    result.push_back(p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2]);
  return result;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_LEVEL_SET_CASES_H
