// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE shape_signature

#include "Grouping_locale.h"
#include "random_Reeb_graph_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/shape_signature_file.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Shape_signature.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

const double pi = std::acos(-1.);

SMRG::Shape_signature signature_of(const Index_mesh& mesh, const std::vector<double>& values)
{
  const Case c(mesh, values);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(c.mesh,
                                                      SMRG::parameters::number_of_eigenpairs(24));
  return SMRG::compute_shape_signature(basis, c.values);
}

// In a direction in which no two vertices have the same height.
std::vector<double> heights(const Index_mesh& mesh)
{
  const std::array<double, 3> axis = {.6, std::sqrt(.5 - .36 / 2 - .01), std::sqrt(.33)};
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  std::vector<double> result;
  for (const auto& p : mesh.points)
    result.push_back((axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2]) / length);
  return result;
}

std::string text_of(const SMRG::Shape_signature& signature)
{
  std::ostringstream out;
  BOOST_TEST(SMRG::IO::write_shape_signature(out, signature));
  return out.str();
}

SMRG::Shape_signature read(const std::string& text)
{
  std::istringstream in(text);
  return SMRG::IO::read_shape_signature(in);
}

SMRG::Shape_signature small_signature()
{
  std::mt19937 rng(1);
  const Index_mesh mesh = torus(9, 6);
  return signature_of(mesh, random_values(mesh.points.size(), rng));
}

} // namespace

BOOST_AUTO_TEST_CASE(sphere_in_closed_form)
{
  const Index_mesh mesh = sphere(4);
  const SMRG::Shape_signature s = signature_of(mesh, heights(mesh));
  const double unit = std::sqrt(4 * pi);

  // l (l + 1), 2 l + 1 times, times the area; relative errors of the mesh are of order h^2
  const double h = 2 * pi / 5 / 16; // about the longest edge
  std::size_t k = 0;
  for (int l = 1; k < s.eigenvalues.size(); ++l)
    for (int m = 0; m < 2 * l + 1 && k < s.eigenvalues.size(); ++m, ++k)
      BOOST_TEST(s.eigenvalues[k] == 4 * pi * l * (l + 1),
                 boost::test_tools::tolerance(l * (l + 1) * h * h));

  BOOST_TEST(s.volume == 4. / 3 * pi / std::pow(unit, 3), boost::test_tools::tolerance(h * h));

  // Archimedes: the areas of bands are as their heights. A level is wrong by the area of a vertex,
  // and the polygon is inscribed.
  const double height_error = 2 * 2. / static_cast<double>(mesh.points.size());
  for (std::size_t i = 0; i < 32; ++i) {
    const double z = -1 + 2 * (static_cast<double>(i) + .5) / 32, radius = std::sqrt(1 - z * z);
    if (radius < .3)
      continue;
    const double length = 2 * pi * radius / unit;
    BOOST_TEST(std::abs(s.section_lengths[6 * i] - length) <
               2 * pi / unit * std::abs(z) / radius * height_error + h * h * length);
    for (std::size_t j = 1; j < 6; ++j)
      BOOST_TEST(s.section_lengths[6 * i + j] == 0);
  }

  // chords of a sphere: the squares of their lengths are uniformly distributed, the mean is 4/3
  double mean = 0;
  for (std::size_t pair = 0, a = 0; a < 4; ++a)
    for (std::size_t b = a; b < 4; ++b, ++pair)
      for (std::size_t i = 0; i < 16; ++i)
        mean += (a == b ? 1 : 2) / 16. / 16 * s.band_distances[16 * pair + i];
  BOOST_TEST(mean == 4. / 3 / unit, boost::test_tools::tolerance(.02));
}

BOOST_AUTO_TEST_CASE(torus_has_two_sections)
{
  Index_mesh mesh = torus(60, 30);
  std::vector<double> x;
  for (const auto& p : mesh.points)
    x.push_back(p[0] + 1e-5 * p[1] + 1e-6 * p[2]);
  const SMRG::Shape_signature s = signature_of(mesh, x);
  // in the middle the tube of radius 0.4 is cut twice
  const double unit = std::sqrt(4 * pi * pi * .4);
  for (const std::size_t i : {15, 16}) {
    for (std::size_t j = 0; j < 2; ++j)
      BOOST_TEST(s.section_lengths[6 * i + j] == 2 * pi * .4 / unit,
                 boost::test_tools::tolerance(.02));
    BOOST_TEST(s.section_lengths[6 * i + 2] == 0);
  }
  BOOST_TEST(s.volume == 2 * pi * pi * .16 / std::pow(unit, 3), boost::test_tools::tolerance(.02));
}

BOOST_AUTO_TEST_CASE(invariance)
{
  Index_mesh mesh = torus(20, 12);
  std::mt19937 rng(2);
  for (auto& p : mesh.points)
    for (double& x : p)
      x += .02 * random_unit(rng);
  const std::vector<double> values = heights(mesh);
  Index_mesh moved = mesh;
  for (auto& p : moved.points) // turned, moved and scaled
    p = {7 * (.6 * p[0] - .8 * p[1]) + 3, 7 * (.8 * p[0] + .6 * p[1]) - 100, 7 * p[2]};
  const SMRG::Shape_signature a = signature_of(mesh, values), b = signature_of(moved, values);
  // eigenvalues are computed with relative residuals of 1e-8
  BOOST_TEST(SMRG::shape_distance(a, b) < 1e-6);
  BOOST_TEST(SMRG::spectral_shape_distance(a, b) < 1e-6);

  const Index_mesh ball = sphere(2);
  const SMRG::Shape_signature c = signature_of(ball, heights(ball));
  BOOST_TEST(SMRG::shape_distance(a, c) > 1);
  BOOST_TEST(SMRG::shape_distance(a, c) == SMRG::shape_distance(c, a));
  BOOST_TEST(SMRG::shape_distance(a, a) == 0);
}

// Eigenvalues of all components together, with one that is zero more.
BOOST_AUTO_TEST_CASE(two_components)
{
  const Index_mesh ball = sphere(2);
  Index_mesh two = ball;
  append(two, ball, 5);
  const SMRG::Shape_signature one = signature_of(ball, heights(ball)),
                              both = signature_of(two, heights(two));
  BOOST_TEST(both.eigenvalues[0] == 0);
  for (std::size_t k = 0; k < 8; ++k) {
    BOOST_TEST(both.eigenvalues[1 + 2 * k] == 2 * one.eigenvalues[k],
               boost::test_tools::tolerance(1e-6));
    BOOST_TEST(both.eigenvalues[2 + 2 * k] == 2 * one.eigenvalues[k],
               boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(written_and_read_back)
{
  const SMRG::Shape_signature s = small_signature();
  const std::string text = text_of(s);
  const SMRG::Shape_signature t = read(text);
  BOOST_TEST(SMRG::shape_distance(s, t) == 0);
  BOOST_TEST(text_of(t) == text); // all of it, bit by bit
  {
    const Grouping_locale locale;
    BOOST_TEST(text_of(read(text)) == text);
  }
  const std::string file = "test_shape_signature.signature";
  BOOST_TEST(SMRG::IO::write_shape_signature(file, s));
  BOOST_TEST(text_of(SMRG::IO::read_shape_signature(file)) == text);
  std::remove(file.c_str());
  BOOST_CHECK_THROW(SMRG::IO::read_shape_signature(file), SMRG::Input_error);
  BOOST_TEST(!SMRG::IO::write_shape_signature("no_such_folder/" + file, s));
}

BOOST_AUTO_TEST_CASE(damaged_files)
{
  const std::string text = text_of(small_signature());
  const auto replaced = [&](const std::string& what, const std::string& by) {
    const std::size_t position = text.find(what);
    BOOST_REQUIRE(position != std::string::npos);
    return text.substr(0, position) + by + text.substr(position + what.size());
  };
  const auto check = [](const std::string& damaged) {
    BOOST_CHECK_THROW(read(damaged), SMRG::Input_error);
  };

  // cut off after every word but the last one
  std::size_t number_of_cuts = 0;
  for (std::size_t i = 0; i < text.size(); i += 1 + i / 40) {
    const std::string cut = text.substr(0, text.find_first_of(" \n", i));
    if (cut.size() + 1 < text.size()) {
      check(cut);
      ++number_of_cuts;
    }
  }
  BOOST_TEST(number_of_cuts > 100);

  check(text + "1\n");
  check(replaced("signature 1", "signature 2"));
  check(replaced("function_quantiles", "quantiles"));
  check(replaced("function_quantiles 32", "function_quantiles 31"));
  check(replaced("function_quantiles 32", "function_quantiles -1"));
  check(replaced("section_lengths 192\n", "section_lengths 192\n-"));
  check(replaced("section_lengths 192\n", "section_lengths 192\nnan "));
  check(replaced("eigenvalues 20\n", "eigenvalues 20\n1e999 "));
  check(replaced("volume 1\n", "volume 1\n-"));
  check(replaced("volume 1\n", "volume 2\n"));
  const std::size_t diagram = text.find("diagram");
  const std::size_t first_point = text.find('\n', diagram) + 1;
  const auto with_first_kind = [&](const std::string& kind) {
    return text.substr(0, first_point) + kind + text.substr(first_point + 1);
  };
  check(with_first_kind("4"));
  check(with_first_kind("-1"));
  check(with_first_kind("3"));           // not sorted
  check(with_first_kind("0 1000 -1 0")); // below the diagonal
}
