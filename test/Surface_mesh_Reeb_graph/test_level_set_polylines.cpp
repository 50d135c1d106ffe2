// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE level_set_polylines

#include "level_set_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// Where a point lies on an edge: 0 at the source, 1 at the target; the point must lie on its line.
double position_on_edge(const Mesh& mesh, const Halfedge h, const Point& p)
{
  const Point a = mesh.point(source(h, mesh)), b = mesh.point(target(h, mesh));
  const double t = ((p - a) * (b - a)) / ((b - a) * (b - a));
  BOOST_REQUIRE(CGAL::squared_distance(p, a + t * (b - a)) < 1e-24);
  return t;
}

std::vector<double> positions(const Case& c, const Components& components, const Component& curve)
{
  const std::vector<Point> points = components.polyline(curve);
  BOOST_REQUIRE(points.size() == curve.halfedges.size() + (curve.is_closed ? 1 : 0));
  if (curve.is_closed)
    BOOST_TEST((points.front() == points.back()));
  std::vector<double> result;
  for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
    const double t = position_on_edge(c.mesh, curve.halfedges[i], points[i]);
    BOOST_REQUIRE((0 < t && t < 1));
    result.push_back(t);
  }
  return result;
}

// The curve with values strictly between the ends of its edges, or tied ones.
void check_values_on_curve(const Case& c, const Component& curve, const std::vector<double>& t)
{
  double lower = -infinity, upper = infinity;
  for (const Halfedge h : curve.halfedges) {
    lower = (std::max)(lower, c.values[source(h, c.mesh)]);
    upper = (std::min)(upper, c.values[target(h, c.mesh)]);
  }
  BOOST_REQUIRE(lower <= upper);
  if (lower == upper || std::isinf(lower) || std::isinf(upper))
    return;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double a = c.values[source(curve.halfedges[i], c.mesh)];
    const double b = c.values[target(curve.halfedges[i], c.mesh)];
    if (!std::isinf(a) && !std::isinf(b))
      BOOST_TEST(std::abs((1 - t[i]) * a + t[i] * b - (lower + upper) / 2) < 1e-12);
  }
}

bool is_circle_at_height(const std::vector<Point>& points, const double z, const double tolerance)
{
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return std::abs(p.z() - z) < 1e-14 &&
           std::abs(p.x() * p.x() + p.y() * p.y() + z * z - 1) < tolerance;
  });
}

} // namespace

// ---------------------------------------------------------------------------------------------
// Polylines

// All curves of all vertices have one value, if there are no ties, and cross an edge in the order
// of their levels; two points on an edge are the same only if the curves have the same edges.
BOOST_AUTO_TEST_CASE(polylines_have_one_value_and_do_not_meet)
{
  struct Crossing
  {
    std::size_t level;
    double position;
    std::size_t curve;
  };

  for_random_cases([](const Case& c) {
    const std::vector<std::size_t> rank = ranks_of(c);
    const Components components(c.mesh, c.values);
    std::vector<std::vector<Halfedge>> curves; // sorted
    std::vector<std::vector<Crossing>> crossings(c.mesh.num_halfedges());
    for (const Vertex v : c.mesh.vertices()) {
      for (const bool is_below : {true, false}) {
        for (const Component& curve : is_below ? below(components, v) : above(components, v)) {
          const std::vector<double> t = positions(c, components, curve);
          check_values_on_curve(c, curve, t);
          for (std::size_t i = 0; i < t.size(); ++i)
            crossings[curve.halfedges[i]].push_back(
                {rank[v] + (is_below ? 0 : 1), t[i], curves.size()});
          curves.push_back(curve.halfedges);
          std::sort(curves.back().begin(), curves.back().end());
        }
      }
    }
    for (std::vector<Crossing>& on_edge : crossings) {
      std::sort(on_edge.begin(), on_edge.end(), [](const Crossing& a, const Crossing& b) {
        return a.level < b.level;
      });
      for (std::size_t i = 1; i < on_edge.size(); ++i) {
        const Crossing &a = on_edge[i - 1], &b = on_edge[i];
        if (curves[a.curve] == curves[b.curve])
          BOOST_TEST(std::abs(a.position - b.position) < 1e-14);
        else
          BOOST_TEST(a.position < b.position - 1e-8);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(level_sets_of_the_height_on_a_sphere_are_circles)
{
  const Index_mesh mesh = sphere(4);
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  const Components components(c.mesh, c.values);
  unsigned number_of_circles = 0;
  for (const Vertex v : c.mesh.vertices()) {
    for (const Component& curve : above(components, v)) {
      double lower = -1, upper = 1;
      for (const Halfedge h : curve.halfedges) {
        lower = (std::max)(lower, c.values[c.mesh.source(h)]);
        upper = (std::min)(upper, c.values[c.mesh.target(h)]);
      }
      if (lower < upper && std::abs(lower) < 0.9) {
        ++number_of_circles;
        BOOST_TEST(curve.is_closed);
        BOOST_TEST(is_circle_at_height(components.polyline(curve), (lower + upper) / 2, 0.02));
      }
    }
  }
  BOOST_TEST(number_of_circles > 300u);
}

// ---------------------------------------------------------------------------------------------
// Types of meshes, maps and values

template <class TriangleMesh>
using Vertex_of = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

// A component by the numbers of the vertices of its edges.
using Plain_component = std::pair<std::vector<std::array<std::size_t, 2>>, bool>;

template <class TriangleMesh, class Number>
std::vector<Plain_component> plain(const TriangleMesh& mesh,
                                   const std::vector<SMRG::Level_set_component<TriangleMesh>>& list,
                                   const Number& number)
{
  std::vector<Plain_component> result;
  for (const auto& component : list) {
    result.emplace_back();
    result.back().second = component.is_closed;
    for (const auto h : component.halfedges)
      result.back().first.push_back({number(source(h, mesh)), number(target(h, mesh))});
  }
  return result;
}

// The components of all vertices, in the order of `vertices`, and their polylines.
template <class Objects, class TriangleMesh, class Vertices, class Number>
std::vector<std::vector<Plain_component>> all_components(const Objects& objects,
                                                         const TriangleMesh& mesh,
                                                         const Vertices& vertices,
                                                         const Number& number)
{
  std::vector<std::vector<Plain_component>> result;
  for (const auto v : vertices) {
    std::vector<SMRG::Level_set_component<TriangleMesh>> found;
    objects.below(v, std::back_inserter(found));
    result.push_back(plain(mesh, found, number));
    found.clear();
    objects.above(v, std::back_inserter(found));
    result.push_back(plain(mesh, found, number));
  }
  return result;
}

std::vector<std::vector<Plain_component>> all_components(const Case& c)
{
  return all_components(Components(c.mesh, c.values),
                        c.mesh,
                        c.mesh.vertices(),
                        [](const Vertex v) -> std::size_t { return v; });
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Polyhedron = CGAL::Polyhedron_3<Exact>;
  using Key = Vertex_of<Polyhedron>;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 rng(seed);
    const Index_mesh mesh = random_small_mesh(rng);
    const std::size_t n = mesh.points.size();
    const std::vector<double> values =
        seed % 2 == 0 ? random_values(n, rng) : random_integer_values(n, 4, rng);
    const Case c(mesh, values);

    Polyhedron polyhedron;
    std::vector<Key> vertices;
    make_mesh(mesh, polyhedron, vertices);
    std::map<Key, double> map;
    std::map<Key, std::size_t> index;
    std::map<Key, Exact::Point_3> point;
    for (std::size_t i = 0; i < n; ++i) {
      map[vertices[i]] = values[i];
      index[vertices[i]] = i;
      point[vertices[i]] = Exact::Point_3(random_unit(rng), random_unit(rng), random_unit(rng));
    }
    const auto value_map = boost::make_assoc_property_map(map);
    const auto point_map = boost::make_assoc_property_map(point);
    const SMRG::Level_set_components components(
        polyhedron,
        value_map,
        CGAL::parameters::vertex_index_map(boost::make_assoc_property_map(index)));
    BOOST_TEST((all_components(components, polyhedron, vertices, [&](Key v) {
                  return index.at(v);
                }) == all_components(c)));

    const SMRG::Level_set_components with_own_indices(polyhedron, value_map);
    std::vector<SMRG::Level_set_component<Polyhedron>> curves;
    with_own_indices.above(vertices[0], std::back_inserter(curves));
    with_own_indices.below(vertices[0], std::back_inserter(curves));
    for (const auto& curve : curves) {
      const auto points =
          with_own_indices.polyline(curve, CGAL::parameters::vertex_point_map(point_map));
      for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
        const auto h = curve.halfedges[i];
        BOOST_TEST((CGAL::collinear_are_strictly_ordered_along_line(
            point[source(h, polyhedron)], points[i], point[target(h, polyhedron)])));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(face_filtered_graph)
{
  // two pieces with borders, and a few pinched vertices
  const Index_mesh whole = torus(16, 8);
  std::mt19937 rng(4);
  const std::vector<double> values = random_values(whole.points.size(), rng);
  const Case c(whole, values);
  Mesh mesh = c.mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  Index_mesh part;
  part.points = whole.points; // the others become isolated vertices
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    if (i % 16 < 11 && i / 32 != 3 && i % 37 != 0) {
      patch[Mesh::Face_index(static_cast<unsigned>(i))] = 1;
      part.triangles.push_back(whole.triangles[i]);
    }
  }
  BOOST_REQUIRE(is_valid(part, true));
  const Case expected(part, values);

  using Filtered = CGAL::Face_filtered_graph<Mesh>;
  const Filtered filtered(mesh, std::size_t(1), patch);
  const SMRG::Level_set_components components(filtered, c.values);
  const Components expected_components(expected.mesh, expected.values);
  std::size_t number_of_curves = 0;
  for (const Vertex v : CGAL::make_range(vertices(filtered))) {
    for (const bool is_below : {true, false}) {
      std::vector<SMRG::Level_set_component<Filtered>> found;
      if (is_below)
        components.below(v, std::back_inserter(found));
      else
        components.above(v, std::back_inserter(found));
      const auto number = [](const Vertex u) -> std::size_t { return u; };
      BOOST_TEST((plain(filtered, found, number) ==
                  plain(expected.mesh,
                        is_below ? below(expected_components, v) : above(expected_components, v),
                        number)));
      number_of_curves += found.size();
      for (const auto& curve : found)
        BOOST_TEST(components.polyline(curve).size() >= curve.halfedges.size());
    }
  }
  BOOST_TEST(number_of_curves > 100u);
}

BOOST_AUTO_TEST_CASE(removed_elements)
{
  std::mt19937 rng(6);
  Case c(sphere(2), random_values(sphere(2).points.size(), rng));
  CGAL::Euler::remove_center_vertex(c.mesh.halfedge(Vertex(0)), c.mesh);
  CGAL::Euler::remove_face(c.mesh.halfedge(*c.mesh.faces().begin()), c.mesh);
  // the hole of the removed vertex is no triangle
  for (const auto f : c.mesh.faces()) {
    if (c.mesh.degree(f) != 3) {
      CGAL::Euler::remove_face(c.mesh.halfedge(f), c.mesh);
      break;
    }
  }
  BOOST_REQUIRE(c.mesh.has_garbage());
  BOOST_REQUIRE(CGAL::is_triangle_mesh(c.mesh));
  const Components components(c.mesh, c.values);
  std::size_t open = 0, closed = 0;
  for (const Vertex v : c.mesh.vertices())
    for (const Component& curve : above(components, v))
      ++(curve.is_closed ? closed : open);
  BOOST_TEST(open > 0u);
  BOOST_TEST(closed > 0u);
}

// Values at the ends of what their type can represent.
template <class Number>
void check_extreme_values(const std::vector<Number>& choice)
{
  using Values = std::map<Vertex, Number>;
  for (unsigned seed = 0; seed < 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng);
      const std::size_t n = mesh.points.size();
      Case c(mesh, std::vector<double>(n, 0));
      set_random_points(c, rng);
      Values values;
      for (const Vertex v : c.mesh.vertices())
        values[v] = choice[random_index(choice.size(), rng)];
      const SMRG::Level_set_components components(c.mesh, boost::make_assoc_property_map(values));
      for (const Vertex v : c.mesh.vertices()) {
        std::vector<Component> curves;
        components.above(v, std::back_inserter(curves));
        for (const Component& curve : curves) {
          const std::vector<Point> points = components.polyline(curve);
          for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
            const double t = position_on_edge(c.mesh, curve.halfedges[i], points[i]);
            BOOST_TEST((-1e-12 < t && t < 1 + 1e-12)); // false for a point that is no point
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(extreme_values)
{
  using Double = std::numeric_limits<double>;
  check_extreme_values<double>(
      {Double::lowest(), Double::max(), 0, Double::denorm_min(), -Double::denorm_min(), 1});
  check_extreme_values<double>({-infinity, infinity});
  check_extreme_values<double>({-infinity, infinity, Double::max(), 1, std::nextafter(1., 2.)});
  using Float = std::numeric_limits<float>;
  check_extreme_values<float>({Float::lowest(), Float::max(), 0.f, Float::infinity()});
  using Long = std::numeric_limits<std::int64_t>;
  check_extreme_values<std::int64_t>({Long::lowest(), Long::max(), 0, 1, -1});
  check_extreme_values<unsigned>({0u, 1u, std::numeric_limits<unsigned>::max()});
  check_extreme_values<bool>({false, true});
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  check_extreme_values<Exact>({Exact(1) / 3, Exact(1) / 7, Exact(0), Exact(-5)});
}

// Differences that `double` cannot represent.
BOOST_AUTO_TEST_CASE(large_whole_values)
{
  const Index_mesh mesh = torus(8, 6);
  std::mt19937 rng(14);
  const std::vector<std::size_t> ranks = random_permutation(mesh.points.size(), rng);
  const Case c(mesh, std::vector<double>(ranks.begin(), ranks.end()));
  std::map<Vertex, std::int64_t> large;
  for (const Vertex v : c.mesh.vertices())
    large[v] = (std::int64_t(1) << 60) + static_cast<std::int64_t>(ranks[v]);
  const Components expected(c.mesh, c.values);
  const SMRG::Level_set_components components(c.mesh, boost::make_assoc_property_map(large));
  for (const Vertex v : c.mesh.vertices())
    for (const Component& curve : above(expected, v))
      BOOST_TEST((components.polyline(curve) == expected.polyline(curve)));
}
