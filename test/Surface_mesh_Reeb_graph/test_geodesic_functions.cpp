// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances, the functions made of them, and the shape diameter, on shapes where they are known
// in closed form.

#define BOOST_TEST_MODULE test_geodesic_functions

#include "Index_mesh.h"
#include "function_checks.h"
#include "random_meshes.h"

// after random_meshes.h: Boost's disjoint sets do not compile after its compressed graphs
#include <CGAL/Surface_mesh_Reeb_graph/Geodesic_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/curvature_feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/geodesic_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/shape_diameter_function.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Geodesics = SMRG::Geodesic_distances<Mesh>;

std::vector<double> distances(const Index_mesh& input, const std::vector<std::size_t>& sources)
{
  const Function_mesh m(input);
  return m.values(
      [&](auto map) { SMRG::geodesic_distance_function(m.mesh, m.descriptors(sources), map); });
}

// Of two unit vectors.
double angle_between(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::acos(std::clamp(p[0] * q[0] + p[1] * q[1] + p[2] * q[2], -1., 1.));
}

// The largest error of the distances from vertex 0 on a unit sphere.
double error_on_sphere(const std::size_t subdivisions)
{
  const Index_mesh mesh = sphere(subdivisions);
  const std::vector<double> found = distances(mesh, {0});
  double error = 0;
  for (std::size_t v = 0; v < found.size(); ++v)
    error = (std::max)(error, std::abs(found[v] - angle_between(mesh.points[v], mesh.points[0])));
  return error;
}

// A unit disc with rings of 6, 12, 18, ... vertices around vertex 0.
Index_mesh disc(const std::size_t rings)
{
  Index_mesh mesh;
  mesh.points.push_back({0, 0, 0});
  const auto number = [](std::size_t ring, std::size_t i) {
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
  };
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t i = 0; i < 6 * ring; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(6 * ring);
      const double radius = static_cast<double>(ring) / static_cast<double>(rings);
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t sector = 0; sector < 6; ++sector)
      for (std::size_t i = 0; i < ring; ++i) {
        const std::size_t outer = sector * ring + i, inner = sector * (ring - 1) + i;
        mesh.triangles.push_back(
            {number(ring - 1, inner), number(ring, outer), number(ring, outer + 1)});
        if (i + 1 < ring)
          mesh.triangles.push_back(
              {number(ring - 1, inner), number(ring, outer + 1), number(ring - 1, inner + 1)});
      }
  return mesh;
}

// Spheres of radius 1 and 2 without contact.
Index_mesh two_spheres()
{
  Index_mesh mesh = sphere(2);
  append(mesh, scaled(sphere(2), 2), 10);
  return mesh;
}

double relative_range(const std::vector<double>& values)
{
  const auto range = std::minmax_element(values.begin(), values.end());
  return (*range.second - *range.first) / *range.second;
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(geodesic_distances)

// The heat method is of first order: half of the edge length, half of the error.
BOOST_AUTO_TEST_CASE(on_a_sphere_they_are_angles)
{
  const double coarse = error_on_sphere(3), fine = error_on_sphere(4);
  BOOST_TEST(fine < 0.01 * pi);
  BOOST_TEST(coarse < 0.02 * pi);
  BOOST_TEST(fine < 0.65 * coarse);
}

BOOST_AUTO_TEST_CASE(on_a_flat_disc_they_are_lengths)
{
  const Index_mesh mesh = disc(20);
  const std::vector<double> found = distances(mesh, {0});
  for (std::size_t v = 0; v < found.size(); ++v)
    BOOST_TEST(std::abs(found[v] - std::hypot(mesh.points[v][0], mesh.points[v][1])) < 0.03);
}

BOOST_AUTO_TEST_CASE(on_a_cylinder_they_are_those_of_the_unrolled_one)
{
  const Index_mesh mesh = cylinder(60, 40, 4);
  const std::size_t source = 20; // in the middle
  const std::vector<double> found = distances(mesh, {source});
  for (std::size_t v = 0; v < found.size(); ++v) {
    const auto &p = mesh.points[v], &q = mesh.points[source];
    const double around = std::acos(std::clamp(p[0] * q[0] + p[1] * q[1], -1., 1.));
    BOOST_TEST(std::abs(found[v] - std::hypot(around, p[2] - q[2])) < 0.15);
  }
}

// Heat is no number any more 700 edges away from the source; the distances go on as they began.
BOOST_AUTO_TEST_CASE(they_do_not_end_where_heat_is_no_number)
{
  constexpr std::size_t around = 10, rings = 2500, plain_rings = 500;
  const double spacing = 2 * pi / static_cast<double>(around);
  const Index_mesh mesh = cylinder(around, rings, spacing * static_cast<double>(rings)),
                   plain =
                       cylinder(around, plain_rings, spacing * static_cast<double>(plain_rings));
  const std::vector<double> found = distances(mesh, {0}), expected = distances(plain, {0});
  const double slope = expected[400] / 400; // of the first line of the tube, away from its end
  BOOST_TEST(std::abs(slope / spacing - 1) < 0.1);
  for (std::size_t line = 0; line < around; ++line)
    for (std::size_t ring = 1; ring <= rings; ++ring) {
      const std::size_t v = line * (rings + 1) + ring;
      if (ring > around)
        BOOST_TEST(found[v] > found[v - 1]);
      BOOST_TEST(std::abs(found[v] - slope * static_cast<double>(ring)) <
                 0.06 * static_cast<double>(ring) * slope + pi);
    }
}

BOOST_AUTO_TEST_CASE(integral_distances_of_a_long_tube)
{
  constexpr std::size_t rings = 1500;
  const Function_mesh m(cylinder(6, rings, double(rings)));
  Geodesics geodesics(m.mesh);
  const auto values =
      m.values([&](auto map) { SMRG::integral_geodesic_distance_function(geodesics, map); });
  const auto center =
      static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
  BOOST_TEST(std::abs(double(center % (rings + 1)) - rings / 2.) < 0.02 * rings);
}

// The outer equator of a torus is a geodesic, the shortest one for small angles.
BOOST_AUTO_TEST_CASE(on_a_torus_they_are_lengths_of_the_outer_equator)
{
  const std::vector<double> found = distances(torus(120, 48), {0});
  for (std::size_t i = 1; i <= 15; ++i) {
    const double exact = 1.4 * 2 * pi * static_cast<double>(i) / 120;
    BOOST_TEST(std::abs(found[48 * i] - exact) < 0.06);
  }
}

BOOST_AUTO_TEST_CASE(the_nearest_of_several_sources_counts)
{
  const Index_mesh mesh = sphere(4);
  const std::vector<std::size_t> sources = {0, 3, 77};
  const std::vector<double> found = distances(mesh, sources);
  for (const std::size_t source : sources)
    BOOST_TEST(found[source] == 0);
  for (std::size_t v = 0; v < found.size(); ++v) {
    double exact = pi;
    for (const std::size_t source : sources)
      exact = (std::min)(exact, angle_between(mesh.points[v], mesh.points[source]));
    BOOST_TEST(std::abs(found[v] - exact) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(one_factorization_serves_many_sources)
{
  const Function_mesh m(sphere(2));
  Geodesics geodesics(m.mesh);
  for (const std::size_t source : {0, 5, 100, 0}) {
    const auto sources = m.descriptors({source});
    const auto kept = m.values([&](auto map) { geodesics.write_distances(sources, map); });
    const auto fresh =
        m.values([&](auto map) { SMRG::geodesic_distance_function(m.mesh, sources, map); });
    BOOST_TEST(kept == fresh, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(they_grow_with_the_shape_and_do_not_see_where_it_is)
{
  const Index_mesh mesh = sphere(3);
  const std::vector<double> expected = distances(mesh, {7});
  for (const double factor : {1e-100, 0.01, 1e3, 1e100}) {
    const std::vector<double> found = distances(scaled(mesh, factor), {7});
    for (std::size_t v = 0; v < found.size(); ++v)
      BOOST_TEST(std::abs(found[v] / factor - expected[v]) < 1e-9);
  }
  const std::vector<double> found = distances(rigidly_moved(mesh), {7});
  for (std::size_t v = 0; v < found.size(); ++v)
    BOOST_TEST(std::abs(found[v] - expected[v]) < 1e-6);
}

BOOST_AUTO_TEST_CASE(components_without_sources_have_the_largest_distance)
{
  Index_mesh mesh = sphere(2);
  const std::size_t size = mesh.points.size();
  append(mesh, grid(3, 3), 10);
  mesh.points.push_back({0, 0, 9});
  const std::vector<double> found = distances(mesh, {0});
  const std::vector<double> alone = distances(sphere(2), {0});
  const double largest = *std::max_element(alone.begin(), alone.end());
  for (std::size_t v = 0; v < found.size(); ++v)
    BOOST_TEST(found[v] == (v < size ? alone[v] : largest));
  for (const double distance : distances(mesh, {}))
    BOOST_TEST(distance == 0);
  for (const double distance : distances(mesh, {mesh.points.size() - 1}))
    BOOST_TEST(distance == 0); // an isolated source
}

BOOST_AUTO_TEST_CASE(degenerate_faces_do_no_harm)
{
  Index_mesh mesh = sphere(3);
  const std::vector<double> expected = distances(mesh, {0});
  // vertices fall together with a neighbor, and one slides onto an edge
  const auto t = mesh.triangles[300], s = mesh.triangles[700];
  mesh.points[t[0]] = mesh.points[t[1]];
  for (std::size_t i = 0; i < 3; ++i)
    mesh.points[s[0]][i] = (mesh.points[s[1]][i] + mesh.points[s[2]][i]) / 2;
  const std::vector<double> found = distances(mesh, {0});
  for (std::size_t v = 0; v < found.size(); ++v)
    BOOST_TEST(std::abs(found[v] - expected[v]) < 0.15); // about an edge length
}

BOOST_AUTO_TEST_CASE(the_mesh_itself_may_be_used)
{
  const Function_mesh m(sphere(4));
  const auto values = m.values([&](auto map) {
    SMRG::geodesic_distance_function(
        m.mesh, m.descriptors({0}), map, SMRG::parameters::use_intrinsic_Delaunay(false));
  });
  for (std::size_t v = 0; v < values.size(); ++v)
    BOOST_TEST(std::abs(values[v] - angle_between(m.input.points[v], m.input.points[0])) < 0.05);
}

BOOST_AUTO_TEST_CASE(points_may_come_from_a_map)
{
  const Function_mesh flat(transformed(sphere(2), [](auto p) {
    return std::array<double, 3>{p[0], 0, 0};
  }));
  const Function_mesh round(sphere(2));
  const auto expected = distances(sphere(2), {0});
  const auto found = flat.values([&](auto map) {
    SMRG::geodesic_distance_function(flat.mesh,
                                     flat.descriptors({0}),
                                     map,
                                     SMRG::parameters::vertex_point_map(round.mesh.points()));
  });
  BOOST_TEST(found == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_data_are_errors)
{
  Index_mesh mesh = sphere(1);
  mesh.points[5][1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(distances(mesh, {0}), SMRG::Input_error);
  BOOST_TEST(distances(Index_mesh(), {}).empty());
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(functions_of_geodesic_distances)

// On the unit sphere the integral of the distance is 2 pi^2, everywhere.
BOOST_AUTO_TEST_CASE(integral_on_a_sphere)
{
  const Function_mesh m(sphere(4));
  Geodesics geodesics(m.mesh);
  const auto values =
      m.values([&](auto map) { SMRG::integral_geodesic_distance_function(geodesics, map); });
  for (const double value : values)
    BOOST_TEST(std::abs(value - 2 * pi * pi) < 0.015 * 2 * pi * pi);
}

// From the center of the unit disc it is 2 pi / 3, from a point of the border 32 / 9.
BOOST_AUTO_TEST_CASE(integral_on_a_flat_disc)
{
  const Function_mesh m(disc(24));
  Geodesics geodesics(m.mesh);
  const auto values = m.values([&](auto map) {
    SMRG::integral_geodesic_distance_function(
        geodesics, map, SMRG::parameters::base_point_radius(0.04));
  });
  BOOST_TEST(std::abs(values.front() - 2 * pi / 3) < 0.03 * 2 * pi / 3);
  BOOST_TEST(std::abs(values.back() - 32. / 9) < 0.03 * 32 / 9);
  for (const double value : values)
    BOOST_TEST(value > 0.97 * values.front());
}

// With all vertices as base points it is the sum over the vertices.
BOOST_AUTO_TEST_CASE(integral_with_all_vertices)
{
  Index_mesh input = sphere(1);
  append(input, grid(3, 2), 5);
  input.points.push_back({0, 0, 9});
  const Function_mesh m(input);
  Geodesics geodesics(m.mesh);
  const auto values = m.values([&](auto map) {
    SMRG::integral_geodesic_distance_function(
        geodesics, map, SMRG::parameters::base_point_radius(0));
  });
  std::vector<double> expected(input.points.size(), 0.);
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    const std::vector<double> from_v = distances(input, {v});
    const std::size_t c = geodesics.component(m.vertices[v]);
    const double area = geodesics.vertex_areas(c)[geodesics.position(m.vertices[v])];
    for (std::size_t w = 0; w < expected.size(); ++w)
      if (geodesics.component(m.vertices[w]) == c)
        expected[w] += area * from_v[w];
  }
  BOOST_TEST(values.back() == 0);
  for (std::size_t v = 0; v < values.size(); ++v)
    BOOST_TEST(std::abs(values[v] - expected[v]) < 1e-9);
  BOOST_CHECK_THROW(m.values([&](auto map) {
    SMRG::integral_geodesic_distance_function(
        geodesics, map, SMRG::parameters::base_point_radius(-1));
  }),
                    CGAL::Precondition_exception);
}

// The poles of a long ellipsoid are its feature points; the distance from them is largest between.
BOOST_AUTO_TEST_CASE(crossed_feature_points_of_an_ellipsoid)
{
  const Index_mesh input = transformed(sphere(3), [](auto p) {
    return std::array<double, 3>{3 * p[0], p[1], p[2]};
  });
  const Function_mesh m(input);
  Geodesics geodesics(m.mesh);
  std::vector<vertex_descriptor> points;
  SMRG::crossed_feature_points(geodesics, std::back_inserter(points));
  BOOST_TEST(points.size() == 2u);
  for (const vertex_descriptor v : points)
    BOOST_TEST(std::abs(m.mesh.point(v).x()) > 2.9);
  BOOST_TEST(m.mesh.point(points[0]).x() * m.mesh.point(points[1]).x() < 0);
  const auto values = m.values([&](auto map) { geodesics.write_distances(points, map); });
  const std::size_t highest =
      static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  BOOST_TEST(std::abs(input.points[highest][0]) < 0.4);
}

// Six arms grow out of a sphere: all of them are found, and nothing else.
BOOST_AUTO_TEST_CASE(feature_points_of_a_star_are_the_tips)
{
  const Function_mesh m(star(4));
  Geodesics geodesics(m.mesh);
  std::vector<vertex_descriptor> crossed, curved;
  // the extrema of both distances are on different sides of the blunt tips
  SMRG::crossed_feature_points(
      geodesics, std::back_inserter(crossed), SMRG::parameters::feature_radius(0.1));
  SMRG::curvature_feature_points(
      m.mesh, std::back_inserter(curved), SMRG::parameters::smoothing_length(0.02));
  for (const std::vector<vertex_descriptor>& points : {crossed, curved}) {
    BOOST_TEST(points.size() == 6u);
    for (const vertex_descriptor v : points) {
      const auto p = m.mesh.point(v);
      BOOST_TEST((std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) > 2.8);
    }
  }
}

BOOST_AUTO_TEST_CASE(feature_points_of_every_component)
{
  Index_mesh input = star(3);
  append(input, star(3), 10);
  input.points.push_back({0, 0, 9});
  const Function_mesh m(input);
  Geodesics geodesics(m.mesh);
  std::vector<vertex_descriptor> crossed;
  SMRG::crossed_feature_points(geodesics, std::back_inserter(crossed));
  BOOST_TEST(crossed.size() == 12u);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(shape_diameter)

// All points of a sphere see the same, and chords in a cone of 60 degrees around the normal have
// between half of a diameter and a diameter.
BOOST_AUTO_TEST_CASE(on_spheres)
{
  const Function_mesh m(two_spheres());
  const auto values = m.values([&](auto map) { SMRG::shape_diameter_function(m.mesh, map); });
  const std::size_t half = values.size() / 2;
  const std::vector<double> small(values.begin(), values.begin() + static_cast<long>(half));
  const std::vector<double> large(values.begin() + static_cast<long>(half), values.end());
  BOOST_TEST(relative_range(small) < 0.05);
  for (const double value : small)
    BOOST_TEST((1 < value && value < 2));
  for (std::size_t v = 0; v < half; ++v)
    BOOST_TEST(std::abs(large[v] - 2 * small[v]) < 0.02);
}

// A narrow cone sees the opposite side alone: the diameter.
BOOST_AUTO_TEST_CASE(narrow_cones_see_diameters)
{
  for (const double radius : {1., 3.}) {
    const Function_mesh m(scaled(sphere(4), radius));
    const auto values = m.values([&](auto map) {
      SMRG::shape_diameter_function(
          m.mesh, map, SMRG::parameters::cone_angle(0.05).number_of_rays(9));
    });
    for (const double value : values)
      BOOST_TEST(std::abs(value - 2 * radius) < 0.02 * radius);
  }
  // the tube of a torus
  const Function_mesh m(torus(80, 40));
  const auto values = m.values([&](auto map) {
    SMRG::shape_diameter_function(m.mesh, map, SMRG::parameters::cone_angle(0.05));
  });
  for (const double value : values)
    BOOST_TEST(std::abs(value - 0.8) < 0.02);
}

// Open at its ends, where most rays leave: the others see the opposite side, or a neighbor does.
BOOST_AUTO_TEST_CASE(on_an_open_cylinder)
{
  const Function_mesh m(cylinder(48, 30, 6));
  const auto values = m.values([&](auto map) {
    SMRG::shape_diameter_function(m.mesh, map, SMRG::parameters::cone_angle(0.05));
  });
  for (const double value : values)
    BOOST_TEST(std::abs(value - 2) < 0.02);
}

BOOST_AUTO_TEST_CASE(without_an_opposite_side_it_is_zero)
{
  Index_mesh input = disc(4);
  input.points.push_back({0, 0, 9});
  const Function_mesh flat(input);
  for (const double value :
       flat.values([&](auto map) { SMRG::shape_diameter_function(flat.mesh, map); }))
    BOOST_TEST(value == 0);
  const Function_mesh points(Index_mesh{{{0, 0, 0}, {1, 0, 0}}, {}});
  for (const double value :
       points.values([&](auto map) { SMRG::shape_diameter_function(points.mesh, map); }))
    BOOST_TEST(value == 0);
}

BOOST_AUTO_TEST_CASE(degenerate_faces_have_no_part)
{
  Index_mesh input = sphere(3);
  const auto t = input.triangles[300];
  input.points[t[0]] = input.points[t[1]];
  const Function_mesh m(input);
  for (const double value : m.values([&](auto map) { SMRG::shape_diameter_function(m.mesh, map); }))
    BOOST_TEST((1 < value && value < 2));
  BOOST_CHECK_THROW(m.values([&](auto map) {
    SMRG::shape_diameter_function(m.mesh, map, SMRG::parameters::cone_angle(0));
  }),
                    CGAL::Precondition_exception);
}

BOOST_AUTO_TEST_SUITE_END()
