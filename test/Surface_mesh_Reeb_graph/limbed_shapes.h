// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes with limbs, in several poses and triangulations, and what is expected of the Reeb graphs of
// their commute-time functions.

#ifndef REEB_GRAPH_TEST_LIMBED_SHAPES_H
#define REEB_GRAPH_TEST_LIMBED_SHAPES_H

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <Eigen/Geometry>

#include <boost/graph/connected_components.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace Reeb_graph_test {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Graph = SMRG::Reeb_graph<Mesh>;
using Value_map = Mesh::Property_map<vertex_descriptor, double>;
using Arc_map = Mesh::Property_map<vertex_descriptor, std::size_t>;

// -------------------------------------------------------------------------------------------------
// Shapes: a few cubes glued together, refined, and smoothed

using Cube = std::array<int, 3>;
using Vector = std::array<double, 3>;

struct Limb
{
  std::size_t axis; // its direction: this axis,
  int sign;         // up or down
  int length;       // in cubes
};

// A body of 3 x 3 x 3 cubes around the origin with limbs one cube thick, all of different lengths:
// tips at different heights of any function, no two critical values equal.
inline const std::vector<Limb> all_limbs = {
    {0, 1, 9}, {0, -1, 8}, {1, 1, 7}, {1, -1, 10}, {2, 1, 6}, {2, -1, 11}};

inline std::set<Cube> cubes_of(const std::size_t number_of_limbs)
{
  std::set<Cube> cubes;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        cubes.insert({x, y, z});
  for (std::size_t i = 0; i < number_of_limbs; ++i) {
    for (int step = 1; step <= all_limbs[i].length; ++step) {
      Cube cube = {0, 0, 0};
      cube[all_limbs[i].axis] = all_limbs[i].sign * (1 + step);
      cubes.insert(cube);
    }
  }
  return cubes;
}

// Joins the first and the third limb (along +x and +y) by a bar: one handle. Both go on beyond it.
inline void add_handle(std::set<Cube>& cubes)
{
  for (int i = 0; i <= 5; ++i) {
    cubes.insert({i, 5, 0});
    cubes.insert({5, i, 0});
  }
}

// The triangles of a shape differ in all that a shape does not determine.
struct Triangulation
{
  int refinement;      // every square of the surface is cut into refinement^2 ones
  unsigned int seed;   // of the diagonals of the squares and of the numbers of the vertices
  double irregularity; // displacement of the vertices along the surface, in edges of squares
};

// The border of the union of the cubes, every square cut into refined ones, these into triangles
// with random diagonals, the whole smoothed by moving vertices to the means of their neighbors:
// limbs become round, with well-shaped triangles. The vertices are not renumbered yet.
inline Index_mesh smooth_surface(const std::set<Cube>& cubes, const Triangulation& triangulation)
{
  const int r = triangulation.refinement;
  std::mt19937 rng(triangulation.seed);
  Index_mesh mesh;
  std::map<Cube, std::size_t> numbers; // coordinates in half edges of the refined squares
  const auto number = [&](const Cube& p) {
    const auto inserted = numbers.emplace(p, mesh.points.size());
    if (inserted.second)
      mesh.points.push_back({p[0] / (2. * r), p[1] / (2. * r), p[2] / (2. * r)});
    return inserted.first->second;
  };
  for (const Cube& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Cube neighbor = cube;
        neighbor[axis] += side;
        if (cubes.count(neighbor) != 0)
          continue;
        const auto at = [&](const int i, const int j) {
          Cube p;
          p[axis] = r * (2 * cube[axis] + side);
          p[(axis + 1) % 3] = r * (2 * cube[(axis + 1) % 3] - 1) + 2 * i;
          p[(axis + 2) % 3] = r * (2 * cube[(axis + 2) % 3] - 1) + 2 * j;
          return number(p);
        };
        for (int i = 0; i < r; ++i) {
          for (int j = 0; j < r; ++j) {
            std::array<std::size_t, 4> square = {
                at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            if (side < 0)
              std::reverse(square.begin(), square.end());
            const std::size_t k = random_index(2, rng);
            mesh.triangles.push_back({square[k], square[k + 1], square[k + 2]});
            mesh.triangles.push_back({square[k], square[k + 2], square[(k + 3) % 4]});
          }
        }
      }
    }
  }

  const std::set<Index_edge> edges = edges_of(mesh);
  const auto smooth = [&] {
    std::vector<Vector> sum(mesh.points.size(), Vector{0, 0, 0});
    std::vector<double> degree(mesh.points.size(), 0);
    for (const Index_edge& e : edges) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[e.first][axis] += mesh.points[e.second][axis];
        sum[e.second][axis] += mesh.points[e.first][axis];
      }
      degree[e.first] += 1;
      degree[e.second] += 1;
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        mesh.points[v][axis] = (mesh.points[v][axis] + sum[v][axis] / degree[v]) / 2;
  };
  for (int i = 0; i < 2 * r * r; ++i)
    smooth();
  // displacements along random edges are (nearly) within the surface
  std::vector<Vector> displaced = mesh.points;
  for (const Index_edge& e : edges) {
    const double t = triangulation.irregularity * (random_unit(rng) - 0.5);
    for (std::size_t axis = 0; axis < 3; ++axis)
      displaced[e.first][axis] += t * (mesh.points[e.second][axis] - mesh.points[e.first][axis]);
  }
  mesh.points = displaced;
  return mesh;
}

// Bends every limb: the part beyond the body turns by `bend[limb]` in the whole, evenly along the
// limb, towards the axis after its own. Lengths along the middle of the limb stay.
inline Vector posed(const Vector& p, const std::vector<double>& bends)
{
  Vector result = p;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const Limb& limb = all_limbs[i];
    const std::size_t side = (limb.axis + 1) % 3;
    const double along = limb.sign * p[limb.axis] - 1.5;
    const bool is_of_limb = along > 0 && std::abs(p[side]) < 1 && std::abs(p[(side + 1) % 3]) < 1;
    if (!is_of_limb || bends[i] == 0)
      continue;
    const double curvature = bends[i] / limb.length;
    const double radius = 1 / curvature - p[side];
    result[limb.axis] = limb.sign * (1.5 + radius * std::sin(curvature * along));
    result[side] = 1 / curvature - radius * std::cos(curvature * along);
  }
  return result;
}

// None, moderate, and strong ones, the latter by up to 90 degrees.
inline const std::vector<std::vector<double>> poses = {
    {0, 0, 0, 0, 0, 0}, {0.6, -0.9, 1.2, 0.4, -1, 0.8}, {-1.5, 1.2, -0.7, 1.5, 1.3, -1.4}};

inline const std::vector<Triangulation> triangulations = {{2, 1, 0}, {2, 2, 0.3}, {3, 3, 0.2}};

inline Index_mesh transformed(Index_mesh mesh, const double scale)
{
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  for (auto& p : mesh.points) {
    const Eigen::Vector3d q =
        scale * (rotation * Eigen::Vector3d(p[0], p[1], p[2]) + Eigen::Vector3d(3, 1, -2));
    p = {q[0], q[1], q[2]};
  }
  return mesh;
}

// A mesh, its points in the straight pose, and its vertices in the order of the points.
struct Shape
{
  Shape(const Index_mesh& input, const std::vector<Vector>& straight_points)
    : straight(straight_points)
  {
    make_mesh(input, mesh, vertices);
  }
  explicit Shape(const Index_mesh& input) : Shape(input, input.points) {}

  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;

  const Vector& straight_point(const vertex_descriptor v) const
  {
    return straight[static_cast<std::size_t>(v)];
  }

  std::vector<Vector> straight;
  std::vector<vertex_descriptor> vertices;
  Mesh mesh;
};

// Renumbered at random; `straight` follows the numbers.
inline Index_mesh limbed_mesh(const std::size_t number_of_limbs,
                              const std::vector<double>& bends,
                              const Triangulation& triangulation,
                              std::vector<Vector>& straight)
{
  Index_mesh mesh = smooth_surface(cubes_of(number_of_limbs), triangulation);
  std::mt19937 rng(triangulation.seed);
  relabel_randomly(mesh, rng);
  straight = mesh.points;
  for (auto& p : mesh.points)
    p = posed(p,
              std::vector<double>(bends.begin(),
                                  bends.begin() + static_cast<std::ptrdiff_t>(number_of_limbs)));
  return mesh;
}

// The limb at whose tip a point of the straight pose lies: within the last one and a half cubes.
// All others have none: -1.
inline int limb_with_tip_at(const Vector& p, const std::size_t number_of_limbs)
{
  for (std::size_t i = 0; i < number_of_limbs; ++i)
    if (all_limbs[i].sign * p[all_limbs[i].axis] > all_limbs[i].length)
      return static_cast<int>(i);
  return -1;
}

// -------------------------------------------------------------------------------------------------
// Graphs

// Saddles counted by their arcs: a degenerate node is as many saddles as it has arcs too many.
struct Summary
{
  std::size_t components, minima, maxima, splits, merges, loops;

  bool operator==(const Summary& other) const
  {
    return components == other.components && minima == other.minima && maxima == other.maxima &&
           splits == other.splits && merges == other.merges && loops == other.loops;
  }
};

inline std::ostream& operator<<(std::ostream& out, const Summary& s)
{
  return out << s.components << " components, " << s.minima << " minima, " << s.maxima
             << " maxima, " << s.splits << " splits, " << s.merges << " merges, " << s.loops
             << " loops";
}

inline Summary summary(const Graph& graph)
{
  Summary result = {0, 0, 0, 0, 0, 0};
  std::vector<std::size_t> down(num_vertices(graph), 0), up(num_vertices(graph), 0);
  for (const auto e : CGAL::make_range(edges(graph))) {
    ++up[lower_node(e, graph)];
    ++down[upper_node(e, graph)];
  }
  for (const auto node : CGAL::make_range(vertices(graph))) {
    result.minima += down[node] == 0 && up[node] > 0 ? 1 : 0;
    result.maxima += up[node] == 0 && down[node] > 0 ? 1 : 0;
    result.splits += up[node] > 1 ? up[node] - 1 : 0;
    result.merges += down[node] > 1 ? down[node] - 1 : 0;
  }
  std::vector<std::size_t> component(num_vertices(graph));
  result.components = boost::connected_components(
      graph, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
  result.loops = num_edges(graph) + result.components - num_vertices(graph);
  return result;
}

inline Summary tree_of_limbs(const std::size_t number_of_limbs)
{
  return {1, 1, number_of_limbs, number_of_limbs - 1, 0, 0};
}

// What two graphs of the same mesh (or of meshes whose vertices have the same numbers) must share:
// nodes, in the order of their numbers, and arcs.
inline bool are_equal(const Graph& a, const Graph& b, const double value_tolerance = 0)
{
  if (num_vertices(a) != num_vertices(b) || num_edges(a) != num_edges(b))
    return false;
  for (const auto node : CGAL::make_range(vertices(a)))
    if (a[node].id != b[node].id || a[node].vertex != b[node].vertex ||
        a[node].type != b[node].type ||
        !(std::abs(a[node].value - b[node].value) <= value_tolerance * std::abs(a[node].value)))
      return false;
  std::multiset<std::array<std::size_t, 3>> arcs;
  for (const auto e : CGAL::make_range(edges(a)))
    arcs.insert({source(e, a), target(e, a), a[e].id});
  for (const auto e : CGAL::make_range(edges(b))) {
    const auto arc = arcs.find({source(e, b), target(e, b), b[e].id});
    if (arc == arcs.end())
      return false;
    arcs.erase(arc);
  }
  return arcs.empty();
}

// The bundles of the edges, by number.
inline std::vector<std::vector<vertex_descriptor>> vertices_of_arcs(const Graph& graph)
{
  std::vector<std::vector<vertex_descriptor>> result(num_edges(graph));
  for (const auto e : CGAL::make_range(edges(graph)))
    result.at(graph[e].id) = graph[e].vertices;
  return result;
}

// Every maximum lies at the tip of a limb, every limb has one, and the minimum lies on the body.
inline void check_places_of_nodes(const Shape& shape, const Graph& graph, const std::size_t limbs)
{
  std::multiset<int> tips;
  for (const auto node : CGAL::make_range(vertices(graph))) {
    const Vector& p = shape.straight_point(graph[node].vertex);
    if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM)
      tips.insert(limb_with_tip_at(p, limbs));
    if (graph[node].type == SMRG::Reeb_node_type::MINIMUM)
      // less than half of the way to the nearest tip
      BOOST_TEST((std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) < 3.5);
  }
  BOOST_TEST(tips.size() == limbs);
  for (std::size_t i = 0; i < limbs; ++i)
    BOOST_TEST(tips.count(static_cast<int>(i)) == 1);
}

// Reads a mesh of CGAL's collection; tells the reader of the log if it is not there.
inline bool read(const std::string& name, Mesh& mesh)
{
  std::ifstream in(CGAL::data_file_path("meshes/" + name));
  if (in && CGAL::IO::read_OFF(in, mesh) && !is_empty(mesh))
    return true;
  BOOST_TEST_MESSAGE("skipped: cannot read " << name);
  return false;
}

} // namespace Reeb_graph_test

#endif // REEB_GRAPH_TEST_LIMBED_SHAPES_H
