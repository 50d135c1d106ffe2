// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that scalar functions are computed on, and what the tests of these functions have in common.

#ifndef REEB_GRAPH_TEST_FUNCTION_CHECKS_H
#define REEB_GRAPH_TEST_FUNCTION_CHECKS_H

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

inline const double pi = std::acos(-1.);

// A mesh and its vertices in the order of the points that it was made from.
struct Function_mesh
{
  explicit Function_mesh(const Index_mesh& mesh) : input(mesh)
  {
    make_mesh(input, this->mesh, vertices);
  }

  std::vector<vertex_descriptor> descriptors(const std::vector<std::size_t>& numbers) const
  {
    std::vector<vertex_descriptor> result;
    for (const std::size_t number : numbers)
      result.push_back(vertices[number]);
    return result;
  }

  // What `function(map)` writes, in the order of the points; all values have to be written.
  template <class Function>
  std::vector<double> values(const Function& function) const
  {
    std::map<vertex_descriptor, double> map;
    function(boost::make_assoc_property_map(map));
    std::vector<double> result;
    for (const vertex_descriptor v : vertices)
      result.push_back(map.at(v));
    return result;
  }

  Index_mesh input;
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
};

template <class Function>
Index_mesh transformed(Index_mesh mesh, const Function& function)
{
  for (auto& p : mesh.points)
    p = function(p);
  return mesh;
}

inline Index_mesh scaled(const Index_mesh& mesh, const double factor)
{
  return transformed(mesh, [factor](const std::array<double, 3>& p) {
    return std::array<double, 3>{factor * p[0], factor * p[1], factor * p[2]};
  });
}

// A rotation about the axis (1, 1, 1) by 120 degrees, one about the z-axis by 0.7, and a translation.
inline Index_mesh rigidly_moved(const Index_mesh& mesh)
{
  return transformed(mesh, [](const std::array<double, 3>& p) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    return std::array<double, 3>{c * p[1] - s * p[2] + 1, s * p[1] + c * p[2] - 2, p[0] + 0.5};
  });
}

// A sphere with arms along the coordinate axes, up to radius 3.
inline Index_mesh star(const std::size_t subdivisions)
{
  return transformed(sphere(subdivisions), [](const std::array<double, 3>& p) {
    const double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    const double radius = 1 + 2 * std::pow(largest, 20);
    return std::array<double, 3>{radius * p[0], radius * p[1], radius * p[2]};
  });
}

} // namespace Reeb_graph_test

#endif // REEB_GRAPH_TEST_FUNCTION_CHECKS_H
