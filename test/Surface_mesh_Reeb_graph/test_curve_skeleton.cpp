// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE curve_skeleton

#include "level_set_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/SWC.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_curve_skeleton.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/property_map.h>

#include <boost/graph/connected_components.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Skeleton = SMRG::Curve_skeleton<Mesh>;
using Skeleton_vertex = boost::graph_traits<Skeleton>::vertex_descriptor;
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;
using Graph = SMRG::Reeb_graph<Mesh>;

enum class Kind { EMBEDDING, SKELETON, FREE };

Graph graph_of(const Case& c, const double persistence_threshold = 0, const bool unfolds = false)
{
  Graph graph;
  const auto parameters =
      SMRG::parameters::collect_arc_vertices(true).unfold_multiple_saddles(unfolds);
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, parameters);
  SMRG::simplify_Reeb_graph(
      c.mesh, c.values, graph, SMRG::parameters::persistence_threshold(persistence_threshold));
  return graph;
}

Skeleton skeleton_of(const Case& c, const Graph& graph, const Kind kind)
{
  Skeleton skeleton;
  if (kind == Kind::EMBEDDING)
    SMRG::embed_Reeb_graph(c.mesh, c.values, graph, skeleton);
  else
    SMRG::compute_curve_skeleton(
        c.mesh, c.values, graph, skeleton, SMRG::parameters::keep_inside(kind == Kind::SKELETON));
  return skeleton;
}

template <class Any_graph>
std::size_t number_of_loops(const Any_graph& graph)
{
  std::vector<std::size_t> component(num_vertices(graph));
  const auto components = boost::connected_components(graph, component.data());
  return num_edges(graph) + static_cast<std::size_t>(components) - num_vertices(graph);
}

// A closed tube around the z-axis, with apexes at its ends, and all heights different from ring to
// ring.
Index_mesh tube(const std::size_t m, const std::size_t n, const double height)
{
  Index_mesh mesh = cylinder(m, n, height);
  const std::size_t bottom = mesh.points.size(), top = bottom + 1;
  mesh.points.push_back({0, 0, -0.5});
  mesh.points.push_back({0, 0, height + 0.5});
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t a = i * (n + 1), b = (i + 1) % m * (n + 1);
    mesh.triangles.push_back({b, a, bottom});
    mesh.triangles.push_back({a + n, b + n, top});
  }
  return mesh;
}

// As many points as nodes and as the arcs have inside; the nodes come first, extrema at their
// vertices; the segments of an arc lead from its lower to its upper node.
void check_structure(const Case& c, const Graph& graph, const Skeleton& skeleton)
{
  const std::size_t nodes = num_vertices(graph);
  BOOST_REQUIRE(num_vertices(skeleton) >= nodes);
  BOOST_TEST(number_of_loops(skeleton) == number_of_loops(graph));
  for (std::size_t n = 0; n < nodes; ++n)
    if (degree(n, graph) == 0 || graph[n].type == SMRG::Reeb_node_type::MINIMUM ||
        graph[n].type == SMRG::Reeb_node_type::MAXIMUM)
    {
      BOOST_TEST((skeleton[n].point == c.mesh.point(graph[n].vertex)));
      BOOST_TEST(skeleton[n].radius == 0);
    }
  std::vector<Skeleton_vertex> last(num_edges(graph)), first(num_edges(graph));
  std::vector<std::size_t> segments(num_edges(graph), 0);
  for (const auto edge : CGAL::make_range(edges(skeleton))) {
    const std::size_t arc = skeleton[edge].arc;
    BOOST_REQUIRE(arc < num_edges(graph));
    if (segments[arc]++ == 0)
      first[arc] = source(edge, skeleton);
    else
      BOOST_TEST(last[arc] == source(edge, skeleton));
    last[arc] = target(edge, skeleton);
  }
  for (const auto arc : CGAL::make_range(edges(graph))) {
    BOOST_REQUIRE(segments[graph[arc].id] > 0);
    BOOST_TEST(first[graph[arc].id] == SMRG::lower_node(arc, graph));
    BOOST_TEST(last[graph[arc].id] == SMRG::upper_node(arc, graph));
  }
  for (std::size_t v = nodes; v < num_vertices(skeleton); ++v)
    BOOST_TEST(degree(v, skeleton) == 2u);
}

// Every vertex is in one list, that of a point of its arc.
void check_vertices(const Case& c, const Graph& graph, const Skeleton& skeleton)
{
  std::vector<std::size_t> arc_of_vertex(c.mesh.num_vertices(), num_edges(graph));
  for (const auto arc : CGAL::make_range(edges(graph)))
    for (const Vertex v : graph[arc].vertices)
      arc_of_vertex[v] = graph[arc].id;
  std::vector<std::size_t> times(c.mesh.num_vertices(), 0);
  for (const auto point : CGAL::make_range(vertices(skeleton)))
    for (const Vertex v : skeleton[point].vertices) {
      ++times[v];
      const auto range = CGAL::make_range(out_edges(point, skeleton));
      BOOST_TEST((arc_of_vertex[v] == num_edges(graph) ||
                  std::any_of(range.begin(), range.end(), [&](const auto& edge) {
                    return skeleton[edge].arc == arc_of_vertex[v];
                  })));
    }
  for (const std::size_t n : times)
    BOOST_TEST(n == 1u);
}

// The distances to all triangles, one after the other. An isolated vertex is on the surface.
void check_radii(const Case& c, const Skeleton& skeleton)
{
  for (const auto point : CGAL::make_range(vertices(skeleton))) {
    if (degree(point, skeleton) == 0)
      continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto f : c.mesh.faces()) {
      const auto h = c.mesh.halfedge(f);
      const Kernel::Triangle_3 triangle(c.mesh.point(source(h, c.mesh)),
                                        c.mesh.point(target(h, c.mesh)),
                                        c.mesh.point(target(next(h, c.mesh), c.mesh)));
      nearest =
          (std::min)(nearest, std::sqrt(CGAL::squared_distance(skeleton[point].point, triangle)));
    }
    BOOST_TEST(std::abs(skeleton[point].radius - nearest) < 1e-12);
  }
}

// Every segment inside against all triangles, one after the other, and by CGAL's own test of its
// middle. A tip is on the surface, so that there the segments meet the triangles of its vertex.
void check_inside(const Case& c, const Skeleton& skeleton)
{
  Exact_mesh mesh;
  std::vector<Exact_mesh::Vertex_index> vertices;
  const auto exact = [](const Point& p) { return Exact_kernel::Point_3(p.x(), p.y(), p.z()); };
  for (const Vertex v : c.mesh.vertices())
    vertices.push_back(mesh.add_vertex(exact(c.mesh.point(v))));
  for (const auto f : c.mesh.faces()) {
    const auto h = c.mesh.halfedge(f);
    mesh.add_face(vertices[source(h, c.mesh)],
                  vertices[target(h, c.mesh)],
                  vertices[target(next(h, c.mesh), c.mesh)]);
  }
  const CGAL::Side_of_triangle_mesh<Exact_mesh, Exact_kernel> side(mesh);
  for (const auto edge : CGAL::make_range(edges(skeleton))) {
    BOOST_TEST(skeleton[edge].is_inside);
    const Exact_kernel::Point_3 p = exact(skeleton[source(edge, skeleton)].point);
    const Exact_kernel::Point_3 q = exact(skeleton[target(edge, skeleton)].point);
    BOOST_TEST((side(CGAL::midpoint(p, q)) == CGAL::ON_BOUNDED_SIDE));
    for (const auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      const std::array<Exact_kernel::Point_3, 3> corners = {
          mesh.point(source(h, mesh)),
          mesh.point(target(h, mesh)),
          mesh.point(target(next(h, mesh), mesh))};
      const bool has_end = std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
        return corner == p || corner == q;
      });
      if (!has_end)
        BOOST_TEST(!CGAL::do_intersect(Exact_kernel::Triangle_3(corners[0], corners[1], corners[2]),
                                       Exact_kernel::Segment_3(p, q)));
    }
  }
}

} // namespace

// ---------------------------------------------------------------------------------------------
// Shapes whose skeletons are known

BOOST_AUTO_TEST_CASE(embedding_of_a_cylinder_is_its_axis)
{
  const Index_mesh mesh = cylinder(16, 12, 3);
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  const Graph graph = graph_of(c);
  BOOST_REQUIRE(num_edges(graph) == 1u);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::EMBEDDING);
  BOOST_REQUIRE(num_vertices(skeleton) > 10u);
  for (std::size_t v = 2; v < num_vertices(skeleton); ++v) {
    BOOST_TEST(std::abs(skeleton[v].point.x()) < 1e-12);
    BOOST_TEST(std::abs(skeleton[v].point.y()) < 1e-12);
    if (v > 2)
      BOOST_TEST(skeleton[v - 1].point.z() < skeleton[v].point.z());
  }
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    BOOST_TEST(!skeleton[edge].is_inside); // it has borders
  check_structure(c, graph, skeleton);
}

BOOST_AUTO_TEST_CASE(skeleton_of_a_tube_is_its_axis)
{
  const Index_mesh mesh = tube(16, 20, 5);
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  const Graph graph = graph_of(c);
  BOOST_REQUIRE(num_edges(graph) == 1u);
  for (const Kind kind : {Kind::EMBEDDING, Kind::SKELETON, Kind::FREE}) {
    const Skeleton skeleton = skeleton_of(c, graph, kind);
    for (const auto v : CGAL::make_range(vertices(skeleton))) {
      BOOST_TEST(std::abs(skeleton[v].point.x()) < 1e-9);
      BOOST_TEST(std::abs(skeleton[v].point.y()) < 1e-9);
    }
    check_structure(c, graph, skeleton);
    check_vertices(c, graph, skeleton);
    check_radii(c, skeleton);
    check_inside(c, skeleton);
  }
}

BOOST_AUTO_TEST_CASE(skeleton_of_a_sphere)
{
  const Index_mesh mesh = sphere(3);
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Graph graph = graph_of(c);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::SKELETON);
  check_structure(c, graph, skeleton);
  check_vertices(c, graph, skeleton);
  check_radii(c, skeleton);
  check_inside(c, skeleton);
  // it runs through the center
  double widest = 0;
  for (const auto v : CGAL::make_range(vertices(skeleton)))
    widest = (std::max)(widest, skeleton[v].radius);
  BOOST_TEST(widest > 0.9);
}

// The circle in the middle, with a tip on either side.
BOOST_AUTO_TEST_CASE(skeleton_of_a_torus)
{
  const Index_mesh mesh = torus(48, 16, 1, 0.3);
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Graph graph = graph_of(c);
  BOOST_REQUIRE(number_of_loops(graph) == 1u);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::SKELETON);
  check_structure(c, graph, skeleton);
  check_vertices(c, graph, skeleton);
  check_radii(c, skeleton);
  check_inside(c, skeleton);
  std::size_t on_loop = 0;
  for (const auto arc : CGAL::make_range(edges(graph))) {
    const bool is_tip =
        degree(source(arc, graph), graph) == 1 || degree(target(arc, graph), graph) == 1;
    if (is_tip)
      continue;
    for (const auto edge : CGAL::make_range(edges(skeleton))) {
      const auto v = target(edge, skeleton);
      if (skeleton[edge].arc != graph[arc].id || v < num_vertices(graph))
        continue;
      ++on_loop;
      BOOST_TEST(skeleton[v].radius > 0.15);
    }
  }
  BOOST_TEST(on_loop > 20u);
}

// The number of points is that asked for.
BOOST_AUTO_TEST_CASE(number_of_samples)
{
  const Index_mesh mesh = torus(24, 12);
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Graph graph = graph_of(c);
  for (const std::size_t n : {1u, 7u, 40u}) {
    Skeleton embedding, free;
    const auto parameters = SMRG::parameters::number_of_samples(n);
    SMRG::embed_Reeb_graph(c.mesh, c.values, graph, embedding, parameters);
    BOOST_TEST(num_vertices(embedding) == num_vertices(graph) + n * num_edges(graph));
    SMRG::compute_curve_skeleton(
        c.mesh, c.values, graph, free, parameters.keep_inside(false).smoothing(0.5));
    BOOST_TEST(num_vertices(free) == num_vertices(graph) + n * num_edges(graph));
  }
}

// What is moved and scaled as a whole gives the same, moved and scaled.
BOOST_AUTO_TEST_CASE(skeletons_move_with_the_shape)
{
  Index_mesh mesh = torus(32, 12, 1, 0.3);
  const std::vector<double> values = heights(mesh, {1, 0.3, 0.1});
  const Case c(mesh, values);
  for (auto& p : mesh.points)
    p = {2 * p[1] + 8, -2 * p[0] - 4, 2 * p[2] + 16}; // exact but for the shift
  const Case moved(mesh, values);
  const Skeleton a = skeleton_of(c, graph_of(c), Kind::EMBEDDING);
  const Skeleton b = skeleton_of(moved, graph_of(moved), Kind::EMBEDDING);
  BOOST_REQUIRE(num_vertices(a) == num_vertices(b));
  for (const auto v : CGAL::make_range(vertices(a))) {
    const Point& p = a[v].point;
    const Point expected(2 * p.y() + 8, -2 * p.x() - 4, 2 * p.z() + 16);
    BOOST_TEST(CGAL::squared_distance(expected, b[v].point) < 1e-24);
    BOOST_TEST(std::abs(2 * a[v].radius - b[v].radius) < 1e-12);
  }
}

// Another mesh, kernel and numbering: with ties the order of the vertices follows the numbers.
BOOST_AUTO_TEST_CASE(exact_polyhedron_with_numbers_of_the_user)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Polyhedron_vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  const Index_mesh input = torus(16, 12);
  Polyhedron mesh;
  std::vector<Polyhedron_vertex> descriptors;
  make_mesh(input, mesh, descriptors);
  std::map<Polyhedron_vertex, double> heights;
  std::map<Polyhedron_vertex, std::size_t> numbers;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    heights[descriptors[i]] = std::round(4 * input.points[i][0]);
    numbers[descriptors[i]] = (7 * i + 5) % descriptors.size();
  }
  const auto values = boost::make_assoc_property_map(heights);
  const auto parameters =
      SMRG::parameters::vertex_index_map(boost::make_assoc_property_map(numbers));
  SMRG::Reeb_graph<Polyhedron> graph;
  SMRG::compute_Reeb_graph(mesh, values, graph, parameters.collect_arc_vertices(true));
  SMRG::Curve_skeleton<Polyhedron> skeleton;
  SMRG::compute_curve_skeleton(mesh, values, graph, skeleton, parameters);
  BOOST_TEST(number_of_loops(graph) == 1u);
  BOOST_TEST(number_of_loops(skeleton) == 1u);
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    BOOST_TEST(skeleton[edge].is_inside);
}

// ---------------------------------------------------------------------------------------------
// Branches that have been cancelled

// A spike on a tube is a branch; without it the embedding is the axis again, but for the levels
// around its foot.
BOOST_AUTO_TEST_CASE(cancelled_branches_do_not_pull)
{
  Index_mesh mesh = tube(24, 40, 10);
  const std::size_t middle = 20; // on the ring at z = 5, at x = 1
  mesh.points[middle] = {6, 0, 8};
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  BOOST_REQUIRE(num_edges(graph_of(c)) == 3u);
  const Graph graph = graph_of(c, 0.5);
  BOOST_REQUIRE(num_edges(graph) == 1u);
  const Skeleton embedding = skeleton_of(c, graph, Kind::EMBEDDING);
  check_structure(c, graph, embedding);
  check_vertices(c, graph, embedding);
  for (const auto v : CGAL::make_range(vertices(embedding))) {
    const Point& p = embedding[v].point;
    if (p.z() < 4.5 || p.z() > 5.5)
      BOOST_TEST(std::hypot(p.x(), p.y()) < 1e-9);
    BOOST_TEST(p.x() < 1.5);
  }
  check_inside(c, skeleton_of(c, graph, Kind::SKELETON));
}

// ---------------------------------------------------------------------------------------------
// Anything: borders, components, isolated vertices, plateaus, infinite values, surfaces that
// intersect themselves

BOOST_AUTO_TEST_CASE(skeletons_of_random_meshes)
{
  // where little is inside, skeletons take long
  constexpr unsigned seeds_apart = 5, skeletons_apart = 20;
  for (unsigned seed = 0; seed < number_of_random_cases(); seed += seeds_apart) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      Case c(mesh, values_for_seed(seed, mesh.points.size(), rng));
      set_random_points(c, rng);
      const Graph graph = graph_of(c, seed % 2 == 0 ? 0.3 : 0);
      const Graph unfolded = graph_of(c, 0.3, true);
      check_structure(c, unfolded, skeleton_of(c, unfolded, Kind::EMBEDDING));
      const bool has_skeleton = seed % skeletons_apart == 0;
      const Skeleton skeleton =
          skeleton_of(c, graph, has_skeleton ? Kind::SKELETON : Kind::EMBEDDING);
      check_structure(c, graph, skeleton);
      check_vertices(c, graph, skeleton);
      check_radii(c, skeleton);
    }
  }
}

BOOST_AUTO_TEST_CASE(degenerate_faces)
{
  // a tube whose rings have been moved onto each other in pairs
  Index_mesh mesh = tube(12, 10, 4);
  for (std::size_t i = 0; i < 12; ++i)
    mesh.points[11 * i + 5] = mesh.points[11 * i + 4];
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  const Graph graph = graph_of(c);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::SKELETON);
  check_structure(c, graph, skeleton);
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    BOOST_TEST(skeleton[edge].is_inside);

  // no face has an area
  Index_mesh flat = tube(12, 10, 4);
  for (auto& p : flat.points)
    p = {0, 0, p[2]};
  const Case d(flat, heights(flat, {0, 0, 1}));
  const Graph flat_graph = graph_of(d);
  check_structure(d, flat_graph, skeleton_of(d, flat_graph, Kind::SKELETON));
}

// A component that is a point has contours of no length, and changes nothing for the others.
BOOST_AUTO_TEST_CASE(components_without_extent)
{
  const Index_mesh mesh = torus(24, 12, 1, 0.3);
  Index_mesh both = mesh;
  append(both, sphere(2), 0);
  for (std::size_t v = mesh.points.size(); v < both.points.size(); ++v)
    both.points[v] = {0, 0, 0.1};
  std::vector<double> values = heights(mesh, {1, 0.3, 0.1});
  const Case c(mesh, values);
  for (std::size_t v = mesh.points.size(); v < both.points.size(); ++v)
    values.push_back(10 + static_cast<double>(v));
  const Case d(both, values);
  const Graph graph = graph_of(c), graph_of_both = graph_of(d);
  const Skeleton alone = skeleton_of(c, graph, Kind::FREE);
  const Skeleton skeleton = skeleton_of(d, graph_of_both, Kind::FREE);
  const auto points = [](const Skeleton& s) {
    std::vector<Point> result;
    for (const auto v : CGAL::make_range(vertices(s)))
      if (CGAL::squared_distance(s[v].point, Point(0, 0, 0.1)) > 1e-6)
        result.push_back(s[v].point);
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<Point> expected = points(alone), found = points(skeleton);
  BOOST_REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    BOOST_TEST(CGAL::squared_distance(found[i], expected[i]) < 1e-16);
}

BOOST_AUTO_TEST_CASE(empty_mesh)
{
  const Case c(Index_mesh(), {});
  Skeleton skeleton(3);
  SMRG::compute_curve_skeleton(c.mesh, c.values, graph_of(c), skeleton);
  BOOST_TEST(num_vertices(skeleton) == 0u);
}

// A closed component keeps its skeleton inside whatever is beside it.
BOOST_AUTO_TEST_CASE(closed_components_beside_open_ones)
{
  Index_mesh mesh = torus(32, 12, 1, 0.3);
  append(mesh, cylinder(12, 6), 4);
  mesh.points.push_back({9, 9, 9});
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Graph graph = graph_of(c);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::SKELETON);
  check_structure(c, graph, skeleton);
  check_vertices(c, graph, skeleton);
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    BOOST_TEST(skeleton[edge].is_inside == (skeleton[target(edge, skeleton)].point.x() < 2));
}

// ---------------------------------------------------------------------------------------------
// Errors

BOOST_AUTO_TEST_CASE(wrong_graphs)
{
  const Index_mesh mesh = torus(24, 12);
  Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  Skeleton skeleton(3);
  const auto fails = [&](const Graph& graph) {
    BOOST_CHECK_THROW(SMRG::compute_curve_skeleton(c.mesh, c.values, graph, skeleton),
                      SMRG::Input_error);
    BOOST_CHECK_THROW(SMRG::embed_Reeb_graph(c.mesh, c.values, graph, skeleton), SMRG::Input_error);
    BOOST_TEST(num_vertices(skeleton) == 3u);
  };
  Graph without_vertices;
  SMRG::compute_Reeb_graph(c.mesh, c.values, without_vertices);
  fails(without_vertices);
  Graph misnumbered = graph_of(c);
  misnumbered[*vertices(misnumbered).first].id = 77;
  fails(misnumbered);
  const Case other(mesh, heights(mesh, {0.1, 1, 0.1}));
  fails(graph_of(other));
  const Graph graph = graph_of(c);
  c.mesh.point(Vertex(5)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  fails(graph);
}

// ---------------------------------------------------------------------------------------------
// Files

BOOST_AUTO_TEST_CASE(polylines)
{
  const Index_mesh mesh = torus(24, 12);
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Graph graph = graph_of(c);
  const Skeleton skeleton = skeleton_of(c, graph, Kind::SKELETON);
  std::stringstream file;
  BOOST_TEST(SMRG::IO::write_polylines(file, skeleton));
  std::size_t arc = 0, points = 0;
  for (std::string line; std::getline(file, line); ++arc) {
    std::istringstream in(line);
    std::size_t n = 0;
    in >> n;
    std::vector<Point> polyline(n);
    for (Point& p : polyline)
      BOOST_REQUIRE(in >> p);
    std::size_t i = 0;
    for (const auto edge : CGAL::make_range(edges(skeleton)))
      if (skeleton[edge].arc == arc) {
        BOOST_TEST((skeleton[source(edge, skeleton)].point == polyline[i]));
        BOOST_TEST((skeleton[target(edge, skeleton)].point == polyline[++i]));
      }
    BOOST_TEST(i + 1 == n);
    points += n - 2;
  }
  BOOST_TEST(arc == num_edges(graph));
  BOOST_TEST(points + num_vertices(graph) == num_vertices(skeleton));
}

// Two trees and an isolated vertex, written and read again.
BOOST_AUTO_TEST_CASE(SWC)
{
  Index_mesh mesh = tube(12, 10, 4);
  append(mesh, sphere(2), 5);
  mesh.points.push_back({9, 9, 9});
  const Case c(mesh, heights(mesh, {0.1, 0.2, 1}));
  const Skeleton skeleton = skeleton_of(c, graph_of(c), Kind::SKELETON);
  BOOST_REQUIRE(SMRG::IO::is_forest(skeleton));
  std::stringstream file;
  BOOST_TEST(SMRG::IO::write_SWC(file, skeleton));

  std::vector<std::array<double, 4>> points;
  std::vector<std::array<Point, 2>> segments;
  std::size_t roots = 0;
  long long number, type, parent;
  for (double x, y, z, r; file >> number >> type >> x >> y >> z >> r >> parent;) {
    points.push_back({x, y, z, r});
    BOOST_TEST(number == static_cast<long long>(points.size()));
    BOOST_TEST(type == 0);
    BOOST_REQUIRE(parent < number);
    if (parent == -1) {
      ++roots;
      continue;
    }
    const auto& p = points[static_cast<std::size_t>(parent - 1)];
    segments.push_back({Point(p[0], p[1], p[2]), Point(x, y, z)});
  }
  BOOST_TEST(file.eof());
  BOOST_TEST(roots == 3u);
  std::vector<std::array<double, 4>> expected;
  for (const auto v : CGAL::make_range(vertices(skeleton))) {
    const Point& p = skeleton[v].point;
    expected.push_back({p.x(), p.y(), p.z(), skeleton[v].radius});
  }
  std::sort(points.begin(), points.end());
  std::sort(expected.begin(), expected.end());
  BOOST_TEST((points == expected));
  std::vector<std::array<Point, 2>> expected_segments;
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    expected_segments.push_back(
        {skeleton[source(edge, skeleton)].point, skeleton[target(edge, skeleton)].point});
  for (auto* list : {&segments, &expected_segments}) {
    for (auto& segment : *list)
      std::sort(segment.begin(), segment.end());
    std::sort(list->begin(), list->end());
  }
  BOOST_TEST((segments == expected_segments));
}

BOOST_AUTO_TEST_CASE(SWC_with_a_loop)
{
  const Index_mesh mesh = torus(24, 12);
  const Case c(mesh, heights(mesh, {1, 0.3, 0.1}));
  const Skeleton skeleton = skeleton_of(c, graph_of(c), Kind::EMBEDDING);
  BOOST_TEST(!SMRG::IO::is_forest(skeleton));
  std::ostringstream file;
  BOOST_CHECK_EXCEPTION(
      SMRG::IO::write_SWC(file, skeleton), SMRG::Input_error, [](const SMRG::Input_error& error) {
        return std::string(error.what()).find("loop") != std::string::npos;
      });
  BOOST_TEST(file.str().empty());
}
