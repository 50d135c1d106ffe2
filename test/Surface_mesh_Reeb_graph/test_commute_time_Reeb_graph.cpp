// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a mesh to the Reeb graph of its commute-time function, on shapes with limbs made here, in
// several poses and triangulations, and on meshes that come with CGAL.

#define BOOST_TEST_MODULE commute_time_Reeb_graph
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Graph = SMRG::Reeb_graph<Mesh>;
using Value_map = Mesh::Property_map<vertex_descriptor, double>;
using Arc_map = Mesh::Property_map<vertex_descriptor, std::size_t>;

namespace {

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
// tips at different heights of any function, no two critical values alike.
const std::vector<Limb> all_limbs = {
    {0, 1, 9}, {0, -1, 8}, {1, 1, 7}, {1, -1, 10}, {2, 1, 6}, {2, -1, 11}};

std::set<Cube> cubes_of(const std::size_t number_of_limbs)
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
void add_handle(std::set<Cube>& cubes)
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
Index_mesh smooth_surface(const std::set<Cube>& cubes, const Triangulation& triangulation)
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
Vector posed(const Vector& p, const std::vector<double>& bends)
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
const std::vector<std::vector<double>> poses = {
    {0, 0, 0, 0, 0, 0}, {0.6, -0.9, 1.2, 0.4, -1, 0.8}, {-1.5, 1.2, -0.7, 1.5, 1.3, -1.4}};

const std::vector<Triangulation> triangulations = {{2, 1, 0}, {2, 2, 0.3}, {3, 3, 0.2}};

Index_mesh transformed(Index_mesh mesh, const double scale)
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
Index_mesh limbed_mesh(const std::size_t number_of_limbs,
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
int limb_with_tip_at(const Vector& p, const std::size_t number_of_limbs)
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

std::ostream& operator<<(std::ostream& out, const Summary& s)
{
  return out << s.components << " components, " << s.minima << " minima, " << s.maxima
             << " maxima, " << s.splits << " splits, " << s.merges << " merges, " << s.loops
             << " loops";
}

Summary summary(const Graph& graph)
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

Summary tree_of_limbs(const std::size_t number_of_limbs)
{
  return {1, 1, number_of_limbs, number_of_limbs - 1, 0, 0};
}

// What two graphs of the same mesh (or of meshes whose vertices have the same numbers) must share:
// nodes, in the order of their numbers, and arcs.
bool are_equal(const Graph& a, const Graph& b, const double value_tolerance = 0)
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
std::vector<std::vector<vertex_descriptor>> vertices_of_arcs(const Graph& graph)
{
  std::vector<std::vector<vertex_descriptor>> result(num_edges(graph));
  for (const auto e : CGAL::make_range(edges(graph)))
    result.at(graph[e].id) = graph[e].vertices;
  return result;
}

// Every maximum lies at the tip of a limb, every limb has one, and the minimum lies on the body.
void check_places_of_nodes(const Shape& shape, const Graph& graph, const std::size_t limbs)
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
bool read(const std::string& name, Mesh& mesh)
{
  std::ifstream in(CGAL::data_file_path("meshes/" + name));
  if (in && CGAL::IO::read_OFF(in, mesh) && !is_empty(mesh))
    return true;
  BOOST_TEST_MESSAGE("skipped: cannot read " << name);
  return false;
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(shapes_of_the_tests)

BOOST_AUTO_TEST_CASE(shapes_are_closed_surfaces_of_the_genus_meant)
{
  for (const Triangulation& triangulation : triangulations) {
    Index_mesh mesh = smooth_surface(cubes_of(6), triangulation);
    BOOST_TEST(is_valid(mesh));
    BOOST_TEST(is_closed(mesh));
    BOOST_TEST(number_of_components(mesh) == 1);
    BOOST_TEST(genus(mesh) == 0);
    std::set<Cube> cubes = cubes_of(6);
    add_handle(cubes);
    mesh = smooth_surface(cubes, triangulation);
    BOOST_TEST(is_valid(mesh));
    BOOST_TEST(is_closed(mesh));
    BOOST_TEST(genus(mesh) == 1);
  }
}

BOOST_AUTO_TEST_CASE(bending_a_limb_moves_its_tip_and_keeps_its_length)
{
  const Limb& limb = all_limbs[0];
  const Vector tip = {limb.length + 1.5, 0, 0};
  for (const double bend : {1.5, -1.5}) {
    double length = 0;
    Vector previous = {1.5, 0, 0};
    for (int i = 1; i <= 1000; ++i) {
      const Vector p = posed({1.5 + i * limb.length / 1000., 0, 0}, {bend});
      length += std::hypot(p[0] - previous[0], p[1] - previous[1], p[2] - previous[2]);
      previous = p;
    }
    BOOST_CHECK_CLOSE_FRACTION(length, limb.length, 1e-5); // of a polyline of 1000 pieces
    BOOST_TEST(std::abs(previous[0] - tip[0]) > 2);
    BOOST_TEST(previous[1] * bend > 5);
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(limbs)

BOOST_AUTO_TEST_CASE(every_limb_is_an_arc_in_every_pose_and_triangulation)
{
  for (const std::size_t limbs : {2, 3, 4, 5, 6}) {
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      for (std::size_t t = 0; t < triangulations.size(); ++t) {
        // all poses with some triangulation, and all triangulations with some pose
        if (limbs < 6 && (t + pose + limbs) % 3 != 0)
          continue;
        std::vector<Vector> straight;
        const Index_mesh input = limbed_mesh(limbs, poses[pose], triangulations[t], straight);
        const Shape shape(input, straight);
        BOOST_TEST_CONTEXT(limbs << " limbs, pose " << pose << ", triangulation " << t)
        {
          Graph graph;
          std::vector<vertex_descriptor> points;
          SMRG::commute_time_Reeb_graph(
              shape.mesh,
              graph,
              SMRG::parameters::persistence_threshold(0.1).output_iterator(
                  std::back_inserter(points)));
          BOOST_TEST(summary(graph) == tree_of_limbs(limbs));
          check_places_of_nodes(shape, graph, limbs);

          std::set<int> tips;
          for (const vertex_descriptor v : points)
            tips.insert(limb_with_tip_at(shape.straight_point(v), limbs));
          tips.erase(-1);
          BOOST_TEST(tips.size() == limbs);

          Graph finer;
          SMRG::commute_time_Reeb_graph(
              shape.mesh, finer, SMRG::parameters::persistence_threshold(0.05));
          BOOST_TEST(summary(finer) == tree_of_limbs(limbs));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(values_at_tips_do_not_depend_on_pose_and_triangulation)
{
  std::vector<double> first;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Vector> straight;
    const Index_mesh input = limbed_mesh(6, poses[i], triangulations[i], straight);
    const Shape shape(input, straight);
    Graph graph;
    SMRG::commute_time_Reeb_graph(shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1));
    std::vector<double> values(6, 0);
    for (const auto node : CGAL::make_range(vertices(graph))) {
      const int limb = limb_with_tip_at(shape.straight_point(graph[node].vertex), 6);
      if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM && limb >= 0)
        values[static_cast<std::size_t>(limb)] = graph[node].value;
    }
    if (first.empty())
      first = values;
    // bending is not quite isometric on limbs one cube thick, and a refinement of 2 leaves some
    // discretization error: a few percent
    for (std::size_t limb = 0; limb < 6; ++limb)
      BOOST_CHECK_CLOSE_FRACTION(values[limb], first[limb], 0.05);
  }
}

BOOST_AUTO_TEST_CASE(handle_between_two_limbs_is_one_loop)
{
  for (const Triangulation& triangulation : triangulations) {
    for (const std::size_t limbs : {3, 6}) {
      std::set<Cube> cubes = cubes_of(limbs);
      add_handle(cubes);
      const Shape shape(smooth_surface(cubes, triangulation));
      for (const double threshold : {0.1, 0.05}) {
        Graph graph;
        SMRG::commute_time_Reeb_graph(
            shape.mesh, graph, SMRG::parameters::persistence_threshold(threshold));
        BOOST_TEST(summary(graph).loops == 1);
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).minima == 1);
        // every limb ends in a maximum beyond the handle; its corner may be one more
        BOOST_TEST(summary(graph).maxima >= limbs);
        BOOST_TEST(summary(graph).maxima <= limbs + 1);
        BOOST_TEST(summary(graph).splits + 1 == summary(graph).maxima + summary(graph).loops);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(torus_has_one_loop_for_any_function)
{
  const Index_mesh input = torus(40, 16, 3, 1);
  const Shape shape(input);
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1).number_of_eigenpairs(20));
  BOOST_TEST(summary(graph).loops == 1);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(components_of_the_mesh)

BOOST_AUTO_TEST_CASE(every_component_has_the_graph_that_it_has_alone)
{
  std::vector<Vector> straight;
  const Index_mesh four = limbed_mesh(4, poses[1], triangulations[1], straight);
  const Index_mesh three = limbed_mesh(3, poses[2], triangulations[0], straight);
  Index_mesh input = four;
  append(input, three, 40);
  const Index_mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}}, {{0, 1, 2}}};
  append(input, triangle, 80);
  append(input, Index_mesh{{{0, 0, 0}}, {}}, 90);
  Shape shape(input);

  Value_map values = shape.mesh.add_property_map<vertex_descriptor, double>("v:value", -1).first;
  Arc_map arcs = shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:arc", 7777).first;
  Graph graph;
  std::vector<vertex_descriptor> points;
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                graph,
                                SMRG::parameters::persistence_threshold(0.1)
                                    .vertex_value_map(values)
                                    .vertex_arc_map(arcs)
                                    .output_iterator(std::back_inserter(points)));

  Shape four_alone(four), three_alone(three);
  std::size_t offset = 0;
  for (Shape* alone : {&four_alone, &three_alone}) {
    Value_map values_alone =
        alone->mesh.add_property_map<vertex_descriptor, double>("v:value", -1).first;
    Graph graph_alone;
    SMRG::commute_time_Reeb_graph(
        alone->mesh,
        graph_alone,
        SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values_alone));
    BOOST_TEST(summary(graph_alone) == tree_of_limbs(alone == &four_alone ? 4 : 3));
    double difference = 0;
    std::set<std::size_t> nodes_alone, nodes;
    for (std::size_t v = 0; v < alone->vertices.size(); ++v)
      difference = (std::max)(
          difference,
          std::abs(values[shape.vertices[offset + v]] - values_alone[alone->vertices[v]]));
    // the translation rounds coordinates to 1e-14
    BOOST_TEST(difference <= 1e-9);
    for (const auto node : CGAL::make_range(vertices(graph_alone)))
      nodes_alone.insert(offset + graph_alone[node].vertex);
    for (const auto node : CGAL::make_range(vertices(graph))) {
      const std::size_t v = graph[node].vertex;
      if (v >= offset && v < offset + alone->vertices.size())
        nodes.insert(v);
    }
    BOOST_TEST(nodes == nodes_alone, boost::test_tools::per_element());
    offset += alone->vertices.size();
  }

  // the triangle is an arc of two nodes, the isolated vertex a node with value 0 and no arc
  BOOST_TEST(summary(graph) == (Summary{4, 3, 8, 5, 0, 0}));
  const vertex_descriptor isolated = shape.vertices.back();
  BOOST_TEST(values[isolated] == 0);
  BOOST_TEST(arcs[isolated] == SMRG::null_arc);
  std::size_t isolated_nodes = 0;
  for (const auto node : CGAL::make_range(vertices(graph)))
    if (graph[node].type == SMRG::Reeb_node_type::ISOLATED) {
      ++isolated_nodes;
      BOOST_TEST(graph[node].vertex == isolated);
    }
  BOOST_TEST(isolated_nodes == 1);
  BOOST_TEST(std::count(points.begin(), points.end(), isolated) == 0);
}

BOOST_AUTO_TEST_CASE(meshes_without_faces_have_graphs_without_arcs)
{
  Graph graph(5);
  const Shape empty((Index_mesh()));
  SMRG::commute_time_Reeb_graph(empty.mesh, graph);
  BOOST_TEST(num_vertices(graph) == 0);
  BOOST_TEST(num_edges(graph) == 0);
  const Shape points(Index_mesh{{{0, 0, 0}, {1, 0, 0}}, {}});
  SMRG::commute_time_Reeb_graph(points.mesh, graph);
  BOOST_TEST(num_vertices(graph) == 2);
  BOOST_TEST(num_edges(graph) == 0);
}

BOOST_AUTO_TEST_CASE(surface_with_border_has_a_graph)
{
  // a limbed shape without the tip of its last limb
  Index_mesh input = smooth_surface(cubes_of(6), triangulations[0]);
  const auto is_beyond = [&](const std::array<std::size_t, 3>& t) {
    return input.points[t[0]][2] < -11;
  };
  input.triangles.erase(std::remove_if(input.triangles.begin(), input.triangles.end(), is_beyond),
                        input.triangles.end());
  remove_isolated_vertices(input);
  BOOST_REQUIRE(is_valid(input));
  BOOST_REQUIRE(!is_closed(input));
  const Shape shape(input);
  Graph graph;
  SMRG::commute_time_Reeb_graph(shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1));
  BOOST_TEST(summary(graph) == tree_of_limbs(6));
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(outputs_and_parameters)

// A shape with maps for the outputs, filled with sentinels.
struct Fixture
{
  Fixture()
    : shape(limbed_mesh(4, poses[1], triangulations[1], straight))
    , values(shape.mesh.add_property_map<vertex_descriptor, double>("v:value", -5).first)
    , arcs(shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:arc", 12345).first)
    , step_values(shape.mesh.add_property_map<vertex_descriptor, double>("v:step_value", -5).first)
    , step_arcs(
          shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:step_arc", 12345).first)
  {}

  // The same step by step.
  template <class NamedParameters>
  Graph step_by_step(const double threshold, const NamedParameters& np)
  {
    Graph graph;
    const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh, np);
    step_points.clear();
    SMRG::feature_points(basis, std::back_inserter(step_points), np);
    SMRG::commute_time_function(basis, step_points, step_values);
    SMRG::compute_Reeb_graph(
        shape.mesh,
        step_values,
        graph,
        SMRG::parameters::vertex_arc_map(step_arcs).collect_arc_vertices(true));
    SMRG::simplify_Reeb_graph(
        shape.mesh,
        step_values,
        graph,
        SMRG::parameters::vertex_arc_map(step_arcs).persistence_threshold(threshold));
    return graph;
  }

  void check_equal_to_steps(const Graph& graph, const Graph& step_graph) const
  {
    BOOST_TEST(are_equal(graph, step_graph));
    BOOST_TEST(points == step_points, boost::test_tools::per_element());
    BOOST_TEST(std::equal(values.begin(), values.end(), step_values.begin()));
    BOOST_TEST(std::equal(arcs.begin(), arcs.end(), step_arcs.begin()));
    BOOST_TEST((vertices_of_arcs(graph) == vertices_of_arcs(step_graph)));
  }

  std::vector<Vector> straight;
  Shape shape;
  Value_map values;
  Arc_map arcs;
  Value_map step_values;
  Arc_map step_arcs;
  std::vector<vertex_descriptor> points, step_points;
};

BOOST_FIXTURE_TEST_CASE(one_call_gives_what_the_steps_give, Fixture)
{
  for (const double threshold : {0., 0.02, 0.1}) {
    Graph graph;
    points.clear();
    SMRG::commute_time_Reeb_graph(shape.mesh,
                                  graph,
                                  SMRG::parameters::persistence_threshold(threshold)
                                      .vertex_value_map(values)
                                      .vertex_arc_map(arcs)
                                      .collect_arc_vertices(true)
                                      .output_iterator(std::back_inserter(points)));
    check_equal_to_steps(graph, step_by_step(threshold, CGAL::parameters::default_values()));
  }
}

BOOST_FIXTURE_TEST_CASE(parameters_reach_the_steps, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                graph,
                                SMRG::parameters::persistence_threshold(0.05)
                                    .number_of_eigenpairs(20)
                                    .small_time(1.)
                                    .large_time(10.)
                                    .vertex_value_map(values)
                                    .vertex_arc_map(arcs)
                                    .collect_arc_vertices(true)
                                    .output_iterator(std::back_inserter(points)));
  check_equal_to_steps(
      graph,
      step_by_step(0.05,
                   SMRG::parameters::number_of_eigenpairs(20).small_time(1.).large_time(10.)));

  // and make a difference
  const std::vector<double> with_few(values.begin(), values.end());
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::vertex_value_map(values).number_of_eigenpairs(50));
  BOOST_TEST(!std::equal(values.begin(), values.end(), with_few.begin()));
}

BOOST_FIXTURE_TEST_CASE(values_are_those_of_the_nodes_and_the_farthest_distances, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      graph,
      SMRG::parameters::vertex_value_map(values).output_iterator(std::back_inserter(points)));
  for (const auto node : CGAL::make_range(vertices(graph)))
    BOOST_TEST(graph[node].value == values[graph[node].vertex]);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh);
  BOOST_REQUIRE(!points.empty());
  double difference = 0;
  for (const vertex_descriptor v : shape.vertices) {
    double farthest = 0;
    for (const vertex_descriptor p : points)
      farthest = (std::max)(farthest, basis.commute_time_distance(v, p));
    difference = (std::max)(difference, std::abs(values[v] - farthest) / farthest);
  }
  BOOST_TEST(difference <= 1e-13); // sums of 50 squares
}

BOOST_FIXTURE_TEST_CASE(arcs_of_vertices_agree_with_vertices_of_arcs, Fixture)
{
  for (const double threshold : {0., 0.1}) {
    Graph graph;
    SMRG::commute_time_Reeb_graph(shape.mesh,
                                  graph,
                                  SMRG::parameters::persistence_threshold(threshold)
                                      .vertex_value_map(values)
                                      .vertex_arc_map(arcs)
                                      .collect_arc_vertices(true));
    std::size_t number = 0;
    bool agrees = true, increases = true, lies_between = true;
    for (const auto e : CGAL::make_range(edges(graph))) {
      const auto& vertices = graph[e].vertices;
      number += vertices.size();
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        agrees = agrees && arcs[vertices[i]] == graph[e].id;
        increases = increases && (i == 0 || values[vertices[i - 1]] <= values[vertices[i]]);
        // Nothing has been cancelled at threshold 0: then an arc's vertices have values between
        // those of its nodes.
        if (threshold == 0) {
          const double s = graph[source(e, graph)].value, t = graph[target(e, graph)].value;
          lies_between = lies_between && (std::min)(s, t) <= values[vertices[i]] &&
                         values[vertices[i]] <= (std::max)(s, t);
        }
      }
    }
    BOOST_TEST(number == shape.vertices.size());
    BOOST_TEST(agrees);
    BOOST_TEST(increases);
    BOOST_TEST(lies_between);

    // the tips of different limbs lie on different arcs
    if (threshold > 0) {
      std::set<std::size_t> arcs_of_tips;
      for (const auto node : CGAL::make_range(vertices(graph)))
        if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM)
          arcs_of_tips.insert(arcs[graph[node].vertex]);
      BOOST_TEST(arcs_of_tips.size() == 4);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(absolute_threshold_is_a_difference_of_values, Fixture)
{
  Graph relative, absolute;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, relative, SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values));
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                absolute,
                                SMRG::parameters::persistence_threshold(0.1 * (*highest - *lowest))
                                    .threshold_is_absolute(true));
  BOOST_TEST(are_equal(relative, absolute));
  Graph nothing_left;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, nothing_left, SMRG::parameters::persistence_threshold(1.1));
  BOOST_TEST(summary(nothing_left) == tree_of_limbs(1));
}

// V1 and V2 are the ends of the longest limbs; the other feature points are told from all other
// vertices by their neighbors.
BOOST_FIXTURE_TEST_CASE(feature_points_are_local_extrema_of_distances_from_the_ends, Fixture)
{
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh);
  const auto ends = SMRG::internal::farthest_pair(
      basis.basis(0).eigenfunctions,
      SMRG::internal::relative_diffusion_factors(basis.basis(0).eigenvalues, 20));
  std::map<bool, std::set<vertex_descriptor>> points_found;
  for (const bool minima : {false, true}) {
    const double sign = minima ? -1 : 1;
    points.clear();
    Graph graph;
    SMRG::commute_time_Reeb_graph(
        shape.mesh,
        graph,
        SMRG::parameters::minima_as_feature_points(minima).output_iterator(
            std::back_inserter(points)));
    points_found[minima].insert(points.begin(), points.end());
    BOOST_TEST(points_found[minima].size() == points.size());

    std::set<vertex_descriptor> extrema;
    for (const std::size_t end : {ends.first, ends.second}) {
      const vertex_descriptor from = basis.component_vertices(0)[end];
      for (const vertex_descriptor v : shape.vertices) {
        const double distance = basis.diffusion_distance(from, v, 1.5);
        bool is_extremum = true;
        for (const vertex_descriptor u :
             CGAL::vertices_around_target(halfedge(v, shape.mesh), shape.mesh))
          is_extremum =
              is_extremum && sign * basis.diffusion_distance(from, u, 1.5) < sign * distance;
        if (is_extremum)
          extrema.insert(v);
      }
    }
    // of neighbors only one has been kept
    for (const vertex_descriptor v : points)
      BOOST_TEST(extrema.count(v) == 1);
    for (const vertex_descriptor v : extrema) {
      std::size_t kept = points_found[minima].count(v);
      for (const vertex_descriptor u :
           CGAL::vertices_around_target(halfedge(v, shape.mesh), shape.mesh))
        kept += points_found[minima].count(u);
      BOOST_TEST(kept >= 1);
    }
  }

  // maxima at all tips; the ends have distance 0 to themselves, and are minima with all that the
  // trunk has
  std::set<int> tips;
  for (const vertex_descriptor v : points_found[false])
    tips.insert(limb_with_tip_at(straight[v], 4));
  tips.erase(-1);
  BOOST_TEST(tips.size() == 4);
  std::size_t minima_at_tips = 0;
  for (const vertex_descriptor v : points_found[true])
    minima_at_tips += limb_with_tip_at(straight[v], 4) >= 0 ? 1 : 0;
  BOOST_TEST(minima_at_tips == 2);
  BOOST_TEST(points_found[true].count(basis.component_vertices(0)[ends.first]) == 1);
  BOOST_TEST(points_found[true].count(basis.component_vertices(0)[ends.second]) == 1);
}

// Soon after the start the heat that remains at a vertex counts for more than the way to the ends:
// it is least on the body.
BOOST_FIXTURE_TEST_CASE(minima_at_small_times_lie_on_the_trunk, Fixture)
{
  for (const bool minima : {false, true}) {
    Graph graph;
    points.clear();
    SMRG::commute_time_Reeb_graph(
        shape.mesh,
        graph,
        SMRG::parameters::minima_as_feature_points(minima).small_time(0.1).output_iterator(
            std::back_inserter(points)));
    std::size_t on_body = 0;
    for (const vertex_descriptor v : points) {
      const Vector& p = straight[v];
      on_body += (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) < 2 ? 1 : 0;
    }
    BOOST_TEST((on_body > 0) == minima);
  }
}

BOOST_FIXTURE_TEST_CASE(solver_is_the_one_asked_for, Fixture)
{
  using Cholesky_traits =
      CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
  Graph expected, graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      expected,
      SMRG::parameters::persistence_threshold(0.1).vertex_value_map(step_values));
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      graph,
      SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values).sparse_linear_solver(
          Cholesky_traits()));
  BOOST_TEST(are_equal(graph, expected, 1e-9));
  double difference = 0;
  for (const vertex_descriptor v : shape.vertices)
    difference = (std::max)(difference, std::abs(values[v] / step_values[v] - 1));
  BOOST_TEST(difference <= 1e-9);

  // a solver that refuses to work shows that it is asked
  struct Refusing_traits : Cholesky_traits
  {
    bool factor(const Matrix&, double&) { return false; }
  };
  BOOST_CHECK_THROW(
      SMRG::commute_time_Reeb_graph(
          shape.mesh, graph, CGAL::parameters::sparse_linear_solver(Refusing_traits())),
      SMRG::Error);
}

BOOST_FIXTURE_TEST_CASE(vertex_point_map_replaces_the_points_of_the_mesh, Fixture)
{
  Graph expected, graph;
  SMRG::commute_time_Reeb_graph(shape.mesh, expected);
  auto points_elsewhere =
      shape.mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:elsewhere").first;
  for (const vertex_descriptor v : shape.vertices) {
    points_elsewhere[v] = shape.mesh.point(v);
    shape.mesh.point(v) = CGAL::ORIGIN;
  }
  BOOST_CHECK_THROW(SMRG::commute_time_Reeb_graph(shape.mesh, graph), SMRG::Error);
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, CGAL::parameters::vertex_point_map(points_elsewhere));
  BOOST_TEST(are_equal(graph, expected));
}

BOOST_FIXTURE_TEST_CASE(errors_leave_all_outputs_as_they_were, Fixture)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Graph graph(3);
  add_edge(0, 2, graph);
  graph[1].value = 42;
  const auto fails = [&](const auto& np) {
    points.assign(2, shape.vertices[7]);
    bool failed = false;
    try {
      SMRG::commute_time_Reeb_graph(shape.mesh,
                                    graph,
                                    np.vertex_value_map(values)
                                        .vertex_arc_map(arcs)
                                        .collect_arc_vertices(true)
                                        .output_iterator(std::back_inserter(points)));
    } catch (const SMRG::Error& error) {
      failed = !std::string(error.what()).empty();
    }
    return failed;
  };
  const auto is_untouched = [&] {
    return num_vertices(graph) == 3 && num_edges(graph) == 1 && graph[1].value == 42 &&
           points == std::vector<vertex_descriptor>(2, shape.vertices[7]) &&
           std::all_of(values.begin(), values.end(), [](double x) { return x == -5; }) &&
           std::all_of(arcs.begin(), arcs.end(), [](std::size_t x) { return x == 12345; });
  };

  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(-0.1)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(nan)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::small_time(-1.)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::large_time(nan)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::number_of_eigenpairs(0)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::residual_tolerance(0)));
  BOOST_TEST(is_untouched());
  shape.mesh.point(shape.vertices[11]) = Kernel::Point_3(0, nan, 0);
  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(0.1)));
  BOOST_TEST(is_untouched());
}

BOOST_FIXTURE_TEST_CASE(scale_and_rigid_motion_drop_out, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values));
  const Index_mesh input = limbed_mesh(4, poses[1], triangulations[1], straight);
  for (const double scale : {1e-100, 1e-3, 1., 1e100}) {
    Shape other(transformed(input, scale));
    Value_map other_values =
        other.mesh.add_property_map<vertex_descriptor, double>("v:value", -5).first;
    Graph other_graph;
    SMRG::commute_time_Reeb_graph(
        other.mesh,
        other_graph,
        SMRG::parameters::persistence_threshold(0.1).vertex_value_map(other_values));
    double difference = 0;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
      difference = (std::max)(
          difference, std::abs(other_values[other.vertices[v]] / values[shape.vertices[v]] - 1));
    BOOST_TEST(difference <= 1e-9);
    BOOST_TEST(are_equal(graph, other_graph, 1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(meshes_of_cgal)

BOOST_AUTO_TEST_CASE(camel_has_head_tail_and_legs)
{
  Mesh mesh;
  if (!read("camel.off", mesh))
    return;
  Graph graph;
  SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1));
  BOOST_TEST(summary(graph) == tree_of_limbs(6));
}

BOOST_AUTO_TEST_CASE(loops_are_the_genus_of_closed_surfaces)
{
  for (const auto& [name, genus] : {std::pair<std::string, std::size_t>("elephant.off", 3),
                                    std::pair<std::string, std::size_t>("eight.off", 2),
                                    std::pair<std::string, std::size_t>("knot1.off", 1)})
  {
    Mesh mesh;
    if (!read(name, mesh))
      continue;
    BOOST_TEST_CONTEXT(name)
    {
      // closed and connected, hence V - E + F = 2 - 2 genus
      BOOST_REQUIRE(CGAL::is_closed(mesh));
      BOOST_REQUIRE(num_vertices(mesh) + num_faces(mesh) + 2 * genus == num_edges(mesh) + 2);
      for (const double threshold : {0., 0.1}) {
        Graph graph;
        SMRG::commute_time_Reeb_graph(
            mesh, graph, SMRG::parameters::persistence_threshold(threshold));
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).loops == genus);
      }
      Value_map height = mesh.add_property_map<vertex_descriptor, double>("v:height", 0).first;
      for (const Kernel::Vector_3& axis :
           {Kernel::Vector_3(0.31, -0.52, 0.79), Kernel::Vector_3(0.83, 0.44, -0.19)})
      {
        SMRG::height_function(mesh, axis, height);
        Graph graph;
        SMRG::compute_Reeb_graph(mesh, height, graph);
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).loops == genus);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
