// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From any polygon soup to a halfedge structure: what is repaired, and what is refused.

#define BOOST_TEST_MODULE polygon_soup_repairs

#include "random_meshes.h"

#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/build_mesh.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/errors.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/prepare_polygon_soup.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/split_polygons.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/weld_points.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Soup_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Faces = std::vector<std::vector<std::size_t>>;

Polygon_soup soup_of(std::size_t number_of_points, const Faces& faces)
{
  Polygon_soup soup;
  for (std::size_t i = 0; i < number_of_points; ++i) { // on a curve in space
    const double t = static_cast<double>(i) + 1;
    soup.points.push_back({t, t * t, t * t * t});
  }
  for (const auto& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_polygon();
  }
  return soup;
}

Polygon_soup soup_of(const Index_mesh& mesh)
{
  Polygon_soup soup;
  for (const auto& p : mesh.points)
    soup.points.push_back({p[0], p[1], p[2]});
  for (const auto& t : mesh.triangles) {
    soup.corners.insert(soup.corners.end(), t.begin(), t.end());
    soup.end_polygon();
  }
  return soup;
}

struct Outcome
{
  Soup_mesh mesh;
  Mesh_input input;

  std::size_t number_of_components() const
  {
    auto& m = const_cast<Soup_mesh&>(mesh);
    return PMP::connected_components(
        m, m.add_property_map<Soup_mesh::Face_index, std::size_t>("f:component").first);
  }

  std::size_t repaired(const std::string& kind) const
  {
    std::size_t number = 0;
    for (const Repair& repair : input.repairs)
      number += repair.kind == kind ? repair.number : 0;
    return number;
  }
};

// The halfedge structure is valid, and CGAL finds the same edges as it does with its own functions.
Outcome repaired(Polygon_soup soup, const Mesh_input_options& options = {})
{
  Outcome result;
  prepare_polygon_soup(soup, options, result.input);
  build_mesh(soup, result.mesh);
  BOOST_TEST(result.mesh.is_valid());
  BOOST_TEST(CGAL::is_triangle_mesh(result.mesh));
  BOOST_REQUIRE(result.input.point_of_vertex.size() == result.mesh.number_of_vertices());
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto e : result.mesh.edges()) {
    const std::size_t v = result.mesh.vertex(e, 0), w = result.mesh.vertex(e, 1);
    BOOST_TEST(edges.insert(std::minmax(v, w)).second);
  }
  std::size_t number_of_corners = 0;
  for (const auto v : result.mesh.vertices()) {
    if (result.mesh.is_isolated(v))
      continue;
    for (const auto h : CGAL::halfedges_around_target(v, result.mesh)) {
      BOOST_TEST(result.mesh.target(h) == v);
      ++number_of_corners;
    }
    BOOST_TEST(result.mesh.is_border(v) == result.mesh.is_border(result.mesh.halfedge(v)));
  }
  BOOST_TEST(number_of_corners == result.mesh.number_of_halfedges());
  return result;
}

void check_error(const Polygon_soup& soup,
                 const std::vector<std::string>& words,
                 const Mesh_input_options& options = {})
{
  std::string message = "no error";
  try {
    Polygon_soup copy = soup;
    Mesh_input input;
    prepare_polygon_soup(copy, options, input);
  } catch (const Content_error& error) {
    message = error.what();
  }
  for (const std::string& word : words)
    BOOST_TEST(message.find(word) != message.npos, message << " does not say " << word);
}

int Euler_characteristic(const Soup_mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
         static_cast<int>(mesh.number_of_faces());
}

const Faces tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

Mesh_input_options splitting()
{
  Mesh_input_options options;
  options.repair.split_nonmanifold_edges = true;
  return options;
}

} // namespace

// A mesh that needs no repair is taken as it is, and in the order of the file.
BOOST_AUTO_TEST_CASE(good_meshes_stay)
{
  for (int genus = 0; genus < 3; ++genus) {
    Index_mesh mesh = closed_surface(genus, 6, 5);
    mesh.points.push_back({9, 9, 9}); // an isolated vertex
    const Polygon_soup soup = soup_of(mesh);
    const Outcome outcome = repaired(soup);
    BOOST_TEST(outcome.input.repairs.empty());
    BOOST_TEST(outcome.input.notices.empty());
    BOOST_TEST(Euler_characteristic(outcome.mesh) == 2 - 2 * genus + 1);
    std::size_t corner = 0;
    for (const auto f : outcome.mesh.faces()) {
      std::vector<std::size_t> found;
      for (const auto v : CGAL::vertices_around_face(outcome.mesh.halfedge(f), outcome.mesh))
        found.push_back(v);
      std::vector<std::size_t> expected(soup.corners.begin() + static_cast<std::ptrdiff_t>(corner),
                                        soup.corners.begin() +
                                            static_cast<std::ptrdiff_t>(corner + 3));
      corner += 3;
      std::rotate(found.begin(), std::find(found.begin(), found.end(), expected[0]), found.end());
      BOOST_TEST(found == expected, boost::test_tools::per_element());
    }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      BOOST_TEST(outcome.input.point_of_vertex[v] == v);
  }
}

// Faces turned at random are turned back, or the others are: neighbors agree.
BOOST_AUTO_TEST_CASE(faces_are_turned)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Index_mesh mesh = closed_surface(static_cast<int>(seed % 3), 6, 5);
      append(mesh, torus(8, 5), 20); // a second component
      std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), rng);
      for (auto& t : mesh.triangles)
        if (rng() % 4 == 0)
          std::swap(t[1], t[2]);
      const Outcome outcome = repaired(soup_of(mesh));
      BOOST_TEST(CGAL::is_closed(outcome.mesh));
      BOOST_TEST(outcome.number_of_components() == 2u);
      BOOST_TEST(outcome.mesh.number_of_vertices() == mesh.points.size());
      const std::size_t turned = outcome.repaired("turned_faces");
      BOOST_TEST(0u < turned);
      BOOST_TEST(turned <= mesh.triangles.size() / 2);
    }
  }
}

BOOST_AUTO_TEST_CASE(vertices_with_several_fans_are_duplicated)
{
  // two closed surfaces that share the vertex 3
  Index_mesh mesh = sphere(1);
  const std::size_t size = mesh.points.size();
  append(mesh, sphere(1), 10);
  for (auto& t : mesh.triangles)
    for (std::size_t& v : t)
      v = v == size ? 3 : v > size ? v - 1 : v;
  mesh.points.erase(mesh.points.begin() + static_cast<std::ptrdiff_t>(size));
  const Outcome outcome = repaired(soup_of(mesh));
  BOOST_TEST(outcome.mesh.number_of_vertices() == 2 * size);
  BOOST_TEST(outcome.number_of_components() == 2u);
  BOOST_TEST(outcome.input.point_of_vertex.back() == 3u);
  BOOST_TEST(
      outcome.mesh.point(Soup_mesh::Vertex_index(3)) ==
      outcome.mesh.point(Soup_mesh::Vertex_index(static_cast<Soup_mesh::size_type>(2 * size - 1))));
  BOOST_REQUIRE(outcome.input.repairs.size() == 1u);
  BOOST_TEST(outcome.input.repairs[0].text ==
             "1 vertex with 2 fans of faces was duplicated (vertex 3)");
  Mesh_input_options strict;
  strict.is_strict = true;
  check_error(soup_of(mesh), {"--strict", "duplicated (vertex 3)"}, strict);

  // fans that end at the border stay together: a halfedge structure holds them
  for (std::size_t number_of_fans = 1; number_of_fans < 5; ++number_of_fans) {
    Faces faces;
    for (std::size_t i = 0; i < number_of_fans; ++i) {
      faces.push_back({0, 3 * i + 1, 3 * i + 2});
      faces.push_back({0, 3 * i + 2, 3 * i + 3});
    }
    const Outcome bow = repaired(soup_of(3 * number_of_fans + 1, faces));
    BOOST_TEST(bow.input.repairs.empty());
    BOOST_TEST(bow.mesh.number_of_vertices() == 3 * number_of_fans + 1);
  }
  // a closed fan is separated from them
  Faces faces = tetrahedron;
  faces.push_back({0, 4, 5});
  faces.push_back({0, 6, 7});
  BOOST_TEST(repaired(soup_of(8, faces)).mesh.number_of_vertices() == 9u);
}

BOOST_AUTO_TEST_CASE(repeated_faces_and_corners_are_dropped)
{
  Faces faces = tetrahedron;
  faces.insert(faces.end(), {{2, 0, 1}, {1, 1, 2}, {0, 1, 0}, {3, 3, 3}});
  Outcome outcome = repaired(soup_of(4, faces));
  BOOST_TEST(outcome.mesh.number_of_faces() == 4u);
  BOOST_TEST(CGAL::is_closed(outcome.mesh));
  BOOST_TEST(outcome.repaired("dropped_repeated_faces") == 1u);
  BOOST_TEST(outcome.repaired("dropped_degenerate_faces") == 3u);
  // each face twice, on both sides
  faces = tetrahedron;
  for (const auto& face : tetrahedron)
    faces.emplace_back(face.rbegin(), face.rend());
  outcome = repaired(soup_of(4, faces));
  BOOST_TEST(outcome.mesh.number_of_faces() == 4u);
  BOOST_TEST(outcome.repaired("dropped_repeated_faces") == 4u);
  // a closed surface of two faces is none that is repeated
  outcome = repaired(soup_of(3, {{0, 1, 2}, {0, 2, 1}}));
  BOOST_TEST(outcome.mesh.number_of_faces() == 2u);
  BOOST_TEST(CGAL::is_closed(outcome.mesh));
  // a corner twice in a row, and a polygon that comes back to a vertex
  outcome = repaired(soup_of(7, {{0, 1, 1, 2, 0}, {2, 3, 4, 2, 5, 6}}));
  BOOST_TEST(outcome.mesh.number_of_faces() == 3u);
  BOOST_TEST(outcome.repaired("simplified_faces") == 2u);
}

BOOST_AUTO_TEST_CASE(what_is_no_surface_is_refused)
{
  const Polygon_soup Moebius_strip =
      soup_of(6, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 1}, {5, 0, 1}});
  check_error(Moebius_strip, {"one side only"});
  check_error(Moebius_strip, {"one side only"}, splitting());
  const Polygon_soup book = soup_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  check_error(book, {"between the vertices 0 and 1", "faces 0, 1 and 2", "--split"});
  const Outcome outcome = repaired(book, splitting());
  BOOST_TEST(outcome.mesh.number_of_vertices() == 9u);
  BOOST_TEST(outcome.number_of_components() == 3u);
  BOOST_TEST(outcome.repaired("split_edges") == 1u);
  BOOST_TEST(outcome.repaired("duplicated_vertices") == 2u);
  Mesh_input_options strict = splitting();
  strict.is_strict = true; // what was asked for may be done
  BOOST_TEST(repaired(book, strict).number_of_components() == 3u);
}

// Two tetrahedra that share the edge 0 1: each is closed again afterwards.
BOOST_AUTO_TEST_CASE(bodies_that_share_an_edge_are_separated)
{
  Faces faces = tetrahedron;
  faces.insert(faces.end(), {{0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}});
  const Outcome outcome = repaired(soup_of(6, faces), splitting());
  BOOST_TEST(outcome.number_of_components() == 2u);
  BOOST_TEST(CGAL::is_closed(outcome.mesh));
  BOOST_TEST(outcome.mesh.number_of_vertices() == 8u);
}

BOOST_AUTO_TEST_CASE(points_are_welded)
{
  // every triangle has vertices of its own, moved by less than a quarter of the distance
  const double distance = 1e-3;
  const Index_mesh mesh = torus(16, 8);
  std::mt19937 rng(1);
  Polygon_soup soup;
  for (const auto& t : mesh.triangles) {
    for (const std::size_t v : t) {
      soup.corners.push_back(soup.points.size());
      std::array<double, 3> p = {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]};
      for (double& x : p)
        x += distance / 8 * (2 * random_unit(rng) - 1);
      soup.points.push_back(p);
    }
    soup.end_polygon();
  }
  BOOST_TEST(repaired(soup).number_of_components() == mesh.triangles.size());
  Mesh_input_options options;
  options.repair.weld_distance = distance;
  const Outcome outcome = repaired(soup, options);
  BOOST_TEST(outcome.mesh.number_of_vertices() == mesh.points.size());
  BOOST_TEST(CGAL::is_closed(outcome.mesh));
  BOOST_TEST(Euler_characteristic(outcome.mesh) == 0);
  BOOST_TEST(outcome.repaired("welded_vertices") == soup.points.size() - mesh.points.size());
  for (std::size_t v = 0; v < outcome.input.point_of_vertex.size(); ++v)
    BOOST_TEST(
        (soup.points[outcome.input.point_of_vertex[v]][0] ==
         outcome.mesh.point(Soup_mesh::Vertex_index(static_cast<Soup_mesh::size_type>(v))).x()));

  // against all pairs
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 300; ++i)
    points.push_back({random_unit(rng), random_unit(rng), std::floor(2 * random_unit(rng))});
  for (const double d : {0., 0.01, 0.05, 0.2, 3.}) {
    const std::vector<std::size_t> first = coinciding_points(points, d);
    std::vector<std::size_t> expected(points.size());
    std::iota(expected.begin(), expected.end(), std::size_t(0));
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j)
          if (std::hypot(points[i][0] - points[j][0],
                         points[i][1] - points[j][1],
                         points[i][2] - points[j][2]) <= d &&
              expected[j] < expected[i])
          {
            expected[i] = expected[j];
            is_changed = true;
          }
    }
    BOOST_TEST(first == expected, boost::test_tools::per_element());
  }
}

// A polygon in a plane is covered by its triangles once: the areas sum to its area.
BOOST_AUTO_TEST_CASE(polygons_in_a_plane_are_covered_once)
{
  for (const std::size_t n : {4u, 5u, 8u, 30u, 300u}) {
    for (const double depth : {0., 0.3, 0.8}) { // of the notches of a star
      Polygon_soup soup;
      double area = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n),
                     radius = i % 2 == 0 ? 1 : 1 - depth;
        // in a plane that is not one of the axes
        const double x = radius * std::cos(angle), y = radius * std::sin(angle);
        soup.points.push_back({x, 0.6 * y, 0.8 * y});
        soup.corners.push_back(i);
      }
      soup.end_polygon();
      for (std::size_t i = 0; i < n; ++i) {
        const auto &p = soup.points[i], &q = soup.points[(i + 1) % n];
        area += (p[0] * q[1] - q[0] * p[1]) / 2 / 0.6;
      }
      const Outcome outcome = repaired(soup);
      BOOST_TEST(outcome.mesh.number_of_faces() == n - 2);
      BOOST_TEST(PMP::area(outcome.mesh) == area, boost::test_tools::tolerance(1e-10));
    }
  }
}

// Bent polygons, with corners on a small lattice, alone and glued to others.
BOOST_AUTO_TEST_CASE(any_polygons_can_be_split)
{
  for (unsigned seed = 0; seed < 400; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const std::size_t n = 4 + rng() % 6;
      Faces faces(1, std::vector<std::size_t>(n));
      std::iota(faces[0].begin(), faces[0].end(), std::size_t(0));
      if (seed % 2 == 1) // a pillow: whatever diagonals one side has, the other must have others
        faces.emplace_back(faces[0].rbegin(), faces[0].rend());
      Polygon_soup soup = soup_of(n, faces);
      for (auto& p : soup.points)
        for (double& x : p)
          x = static_cast<double>(rng() % 3) - 1;
      const Outcome outcome = repaired(soup);
      BOOST_TEST(outcome.mesh.number_of_faces() == faces.size() * (n - 2));
      BOOST_TEST(CGAL::is_closed(outcome.mesh) == (seed % 2 == 1));
    }
  }
  // both diagonals of the quadrangle are edges of other faces
  check_error(soup_of(6, {{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 5}}), {"cannot be split", "diagonals"});
  // all diagonals but those from 3 are taken, so that no ear but one can be cut off first
  const Outcome forced = repaired(soup_of(10, {{0, 1, 2, 3, 4}, {0, 2, 6}, {2, 4, 7}, {1, 4, 8}}));
  BOOST_TEST(forced.mesh.number_of_faces() == 6u);
}

// The time is linear in the degree of a vertex, and in the number of corners of a polygon.
BOOST_AUTO_TEST_CASE(fans_and_polygons_of_any_size)
{
  const std::size_t n = 40000;
  std::mt19937 rng(3);
  Faces fan;
  for (std::size_t i = 0; i < n; ++i)
    fan.push_back({0, i + 1, (i + 1) % n + 1});
  std::shuffle(fan.begin(), fan.end(), rng);
  Polygon_soup soup = soup_of(n + 1, fan);
  Mesh_input input;
  prepare_polygon_soup(soup, {}, input);
  Soup_mesh mesh;
  build_mesh(soup, mesh);
  BOOST_TEST(mesh.is_valid());
  BOOST_TEST(mesh.degree(Soup_mesh::Vertex_index(0)) == n);

  Faces polygon(1, std::vector<std::size_t>(n));
  std::iota(polygon[0].begin(), polygon[0].end(), std::size_t(0));
  soup = soup_of(n, polygon);
  split_polygons(soup);
  BOOST_TEST(soup.number_of_polygons() == n - 2);
}
