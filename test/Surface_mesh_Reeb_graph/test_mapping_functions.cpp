// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions of coordinates, of curvature and of eigenfunctions, and harmonic functions, on shapes where
// they are known in closed form.

#define BOOST_TEST_MODULE test_mapping_functions

#include "Index_mesh.h"
#include "function_checks.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/curvature_feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/harmonic_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

std::vector<double> harmonic_values(const Function_mesh& m,
                                    const std::vector<std::size_t>& minima,
                                    const std::vector<std::size_t>& maxima,
                                    const bool use_intrinsic_Delaunay = true)
{
  return m.values([&](auto map) {
    SMRG::harmonic_function(m.mesh,
                            m.descriptors(minima),
                            m.descriptors(maxima),
                            map,
                            SMRG::parameters::use_intrinsic_Delaunay(use_intrinsic_Delaunay));
  });
}

// The vertices of every set of connected vertices of equal value that has no lower neighbor.
std::vector<std::set<std::size_t>>
minima_of(const Index_mesh& mesh, const std::vector<double>& values)
{
  std::vector<std::set<std::size_t>> neighbors(mesh.points.size());
  for (const auto& e : edges_of(mesh)) {
    neighbors[e.first].insert(e.second);
    neighbors[e.second].insert(e.first);
  }
  std::vector<std::set<std::size_t>> result;
  std::vector<bool> is_seen(values.size(), false);
  for (std::size_t first = 0; first < values.size(); ++first) {
    if (is_seen[first])
      continue;
    std::set<std::size_t> plateau = {first};
    std::vector<std::size_t> waiting = {first};
    is_seen[first] = true;
    bool is_minimum = true;
    while (!waiting.empty()) {
      const std::size_t v = waiting.back();
      waiting.pop_back();
      for (const std::size_t w : neighbors[v]) {
        is_minimum = is_minimum && !(values[w] < values[v]);
        if (values[w] == values[v] && !is_seen[w]) {
          is_seen[w] = true;
          plateau.insert(w);
          waiting.push_back(w);
        }
      }
    }
    if (is_minimum)
      result.push_back(plateau);
  }
  return result;
}

// All minima and maxima are at the given vertices.
void check_extrema(const Index_mesh& mesh,
                   std::vector<double> values,
                   const std::vector<std::size_t>& minima,
                   const std::vector<std::size_t>& maxima)
{
  for (const std::vector<std::size_t>& chosen : {minima, maxima}) {
    for (const std::set<std::size_t>& plateau : minima_of(mesh, values))
      BOOST_TEST(std::any_of(
          chosen.begin(), chosen.end(), [&](std::size_t v) { return plateau.count(v) > 0; }));
    for (double& value : values)
      value = -value;
  }
}

// A vertex where a function is largest.
std::size_t highest(const std::vector<double>& values)
{
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

double smallest_value(const std::vector<double>& values)
{
  return *std::min_element(values.begin(), values.end());
}

double largest_value(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// The mean over the surface.
double mean(const Eigenbasis& basis, const Function_mesh& m, const std::vector<double>& values)
{
  double sum = 0, area = 0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    sum += basis.vertex_area(m.vertices[v]) * values[v];
    area += basis.vertex_area(m.vertices[v]);
  }
  return sum / area;
}

} // namespace

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(coordinates)

BOOST_AUTO_TEST_CASE(height_is_a_scalar_product)
{
  const Function_mesh m(torus(12, 8));
  for (const double length : {1e-200, 1., 1e200}) {
    const auto values = m.values([&](auto map) {
      SMRG::height_function(m.mesh, Kernel::Vector_3(2 * length, -length, 2 * length), map);
    });
    for (std::size_t v = 0; v < values.size(); ++v) {
      const auto& p = m.input.points[v];
      BOOST_TEST(std::abs(values[v] - (2 * p[0] - p[1] + 2 * p[2]) / 3) < 1e-14);
    }
  }
  BOOST_CHECK_THROW(
      m.values([&](auto map) { SMRG::height_function(m.mesh, Kernel::Vector_3(0, 0, 0), map); }),
      CGAL::Precondition_exception);
}

BOOST_AUTO_TEST_CASE(all_points_of_a_sphere_are_equally_far_from_its_barycenter)
{
  const Function_mesh m(rigidly_moved(scaled(sphere(3), 5)));
  for (const double value :
       m.values([&](auto map) { SMRG::barycenter_distance_function(m.mesh, map); }))
    BOOST_TEST(std::abs(value - 5) < 1e-12);
}

// By area, not by the number of vertices, of which most are on one side.
BOOST_AUTO_TEST_CASE(barycenter_of_an_uneven_rectangle)
{
  const Index_mesh input = transformed(grid(20, 3), [](auto p) {
    return std::array<double, 3>{p[0] * p[0] / 20, p[1], p[2]};
  });
  const Function_mesh m(input);
  const auto values = m.values([&](auto map) { SMRG::barycenter_distance_function(m.mesh, map); });
  for (std::size_t v = 0; v < values.size(); ++v)
    BOOST_TEST(std::abs(values[v] - std::hypot(input.points[v][0] - 10, input.points[v][1] - 1.5)) <
               1e-12);
}

BOOST_AUTO_TEST_CASE(every_component_has_its_barycenter)
{
  Index_mesh input = sphere(2);
  append(input, scaled(sphere(2), 2), 1e6);
  input.points.push_back({5, 5, 5});
  const Function_mesh m(input);
  const auto values = m.values([&](auto map) { SMRG::barycenter_distance_function(m.mesh, map); });
  BOOST_TEST(values.back() == 0);
  for (std::size_t v = 0; v < 162; ++v) {
    BOOST_TEST(std::abs(values[v] - 1) < 1e-12);
    BOOST_TEST(std::abs(values[162 + v] - 2) < 1e-9);
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(harmonic)

// Between the two borders of a cylinder it is linear, and exactly so.
BOOST_AUTO_TEST_CASE(on_a_cylinder_it_is_linear)
{
  const Function_mesh m(cylinder(20, 10, 3));
  std::vector<std::size_t> minima, maxima;
  for (std::size_t i = 0; i < 20; ++i) {
    minima.push_back(11 * i);
    maxima.push_back(11 * i + 10);
  }
  for (const bool intrinsic : {false, true}) {
    const auto values = harmonic_values(m, minima, maxima, intrinsic);
    for (std::size_t v = 0; v < values.size(); ++v)
      BOOST_TEST(std::abs(values[v] - m.input.points[v][2] / 3) < 1e-12);
    check_extrema(m.input, values, minima, maxima);
  }
}

// Between two concentric circles it is a logarithm.
BOOST_AUTO_TEST_CASE(on_a_flat_ring_it_is_a_logarithm)
{
  constexpr std::size_t around = 120, outwards = 40;
  const Function_mesh m(transformed(cylinder(around, outwards, 1), [](auto p) {
    const double radius = 1 + 2 * p[2];
    return std::array<double, 3>{radius * p[0], radius * p[1], 0};
  }));
  std::vector<std::size_t> minima, maxima;
  for (std::size_t i = 0; i < around; ++i) {
    minima.push_back((outwards + 1) * i);
    maxima.push_back((outwards + 1) * i + outwards);
  }
  const auto values = harmonic_values(m, minima, maxima);
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double radius = std::hypot(m.input.points[v][0], m.input.points[v][1]);
    BOOST_TEST(std::abs(values[v] - std::log(radius) / std::log(3.)) < 1e-3);
  }
}

// From pole to pole of a sphere, cut off at 30 degrees: log(tan(theta / 2)).
BOOST_AUTO_TEST_CASE(on_a_sphere_between_two_circles)
{
  constexpr std::size_t around = 120, along = 80;
  const auto theta = [](double z) { return pi / 6 + z * 2 * pi / 3; };
  const Function_mesh m(transformed(cylinder(around, along, 1), [&](auto p) {
    const double t = theta(p[2]);
    return std::array<double, 3>{p[0] * std::sin(t), p[1] * std::sin(t), -std::cos(t)};
  }));
  std::vector<std::size_t> minima, maxima;
  for (std::size_t i = 0; i < around; ++i) {
    minima.push_back((along + 1) * i);
    maxima.push_back((along + 1) * i + along);
  }
  const auto values = harmonic_values(m, minima, maxima);
  const double half = std::log(std::tan(theta(1) / 2));
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double t = std::acos(-m.input.points[v][2]);
    BOOST_TEST(std::abs(values[v] - (std::log(std::tan(t / 2)) / half + 1) / 2) < 1e-3);
  }
}

// The leaves of the Reeb graph are those that were asked for, and its loops those of the surface.
BOOST_AUTO_TEST_CASE(the_Reeb_graph_has_only_the_chosen_leaves)
{
  const Function_mesh m(torus(60, 30));
  Mesh mesh = m.mesh;
  const auto map = mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  SMRG::harmonic_function(mesh, m.descriptors({3}), m.descriptors({900, 1500}), map);
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(mesh, map, graph, SMRG::parameters::unfold_multiple_saddles(true));
  std::multiset<vertex_descriptor> leaves;
  for (auto node : CGAL::make_range(vertices(graph)))
    if (degree(node, graph) == 1)
      leaves.insert(graph[node].vertex);
  BOOST_TEST(leaves.size() == 3u);
  for (const vertex_descriptor v : m.descriptors({3, 900, 1500}))
    BOOST_TEST(leaves.count(v) == 1u);
  BOOST_TEST(num_edges(graph) + 1 - num_vertices(graph) == 1u);
}

// Slivers and needles make cotangents negative. Long arms without a chosen vertex make the function
// constant to the last digit.
BOOST_AUTO_TEST_CASE(there_are_no_other_extrema)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 rng(seed);
    Index_mesh input = seed % 3 == 0 ? random_small_mesh(rng) : seed % 3 == 1 ? sphere(3) : star(3);
    const double roughness = seed % 2 == 0 ? 0.2 : 0;
    for (auto& p : input.points)
      for (double& x : p)
        x += roughness * random_unit(rng);
    for (auto& p : input.points) // needles
      p[2] *= seed % 5 == 0 ? 0.01 : 1;
    const Function_mesh m(input);
    const std::size_t n = input.points.size();
    const std::vector<std::size_t> order = random_permutation(n, rng);
    const std::size_t low = (std::min)(n / 2, 1 + random_index(3, rng));
    const std::size_t high = (std::min)(n - low, 1 + random_index(3, rng));
    const auto middle = order.begin() + static_cast<long>(low);
    const std::vector<std::size_t> minima(order.begin(), middle);
    const std::vector<std::size_t> maxima(middle, middle + static_cast<long>(high));
    for (const bool intrinsic : {false, true}) {
      const auto values = harmonic_values(m, minima, maxima, intrinsic);
      BOOST_TEST_CONTEXT("seed " << seed << ", intrinsic " << intrinsic)
      {
        for (const double value : values)
          BOOST_TEST((0 <= value && value <= 1));
        if (number_of_components(input) == 1)
          check_extrema(input, values, minima, maxima);
        for (const std::size_t v : maxima)
          BOOST_TEST(values[v] == 1);
      }
    }
  }
}

// What is flattened is small: away from the chosen vertices the values are means of their neighbors'.
BOOST_AUTO_TEST_CASE(on_a_good_mesh_it_solves_the_equation)
{
  const Function_mesh m(sphere(3));
  const auto values = harmonic_values(m, {0}, {100, 200}, false);
  const SMRG::internal::Mesh_components<Mesh> components(m.mesh);
  const auto matrices =
      SMRG::internal::assemble_Laplace_Beltrami_matrices(m.mesh, m.mesh.points(), components, 0);
  const Eigen::VectorXd x =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<long>(values.size()));
  Eigen::VectorXd residual = matrices.stiffness * x;
  for (const int chosen : {0, 100, 200})
    residual[chosen] = 0;
  BOOST_TEST(residual.cwiseAbs().maxCoeff() < 1e-13);
}

BOOST_AUTO_TEST_CASE(components_without_both_kinds_are_constant)
{
  Index_mesh input = sphere(1); // 42 vertices
  append(input, sphere(1), 5);
  append(input, sphere(1), 10);
  append(input, sphere(1), 15);
  input.points.push_back({9, 9, 9});
  input.points.push_back({9, 9, 8});
  const Function_mesh m(input);
  const auto values = harmonic_values(m, {0, 42}, {1, 84, 169});
  for (std::size_t v = 0; v < 42; ++v) {
    BOOST_TEST((v == 0 ? values[v] == 0 : v == 1 ? values[v] == 1 : values[v] > 0));
    BOOST_TEST(values[42 + v] == 0);  // a minimum only
    BOOST_TEST(values[84 + v] == 1);  // a maximum only
    BOOST_TEST(values[126 + v] == 0); // neither
  }
  BOOST_TEST(values[168] == 0);
  BOOST_TEST(values[169] == 1); // isolated, and chosen
}

BOOST_AUTO_TEST_CASE(degenerate_faces_and_surfaces_without_area)
{
  Index_mesh input = sphere(2);
  const auto t = input.triangles[100];
  input.points[t[0]] = input.points[t[1]];
  check_extrema(input, harmonic_values(Function_mesh(input), {0}, {50}), {0}, {50});
  for (auto& p : input.points)
    p = {1, 2, 3};
  check_extrema(input, harmonic_values(Function_mesh(input), {0}, {50}), {0}, {50});
}

BOOST_AUTO_TEST_CASE(wrong_arguments_and_data)
{
  const Function_mesh m(sphere(1));
  BOOST_CHECK_THROW(harmonic_values(m, {1, 2}, {3, 2}), CGAL::Precondition_exception);
  Index_mesh input = sphere(1);
  input.points[7][0] = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(harmonic_values(Function_mesh(input), {1}, {2}), SMRG::Input_error);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(curvature)

BOOST_AUTO_TEST_CASE(of_a_sphere_is_1)
{
  const Function_mesh m(scaled(sphere(3), 7));
  for (const double value :
       m.values([&](auto map) { SMRG::Gaussian_curvature_function(m.mesh, map); }))
    BOOST_TEST(std::abs(value - 1) < 0.01);
  std::vector<vertex_descriptor> points;
  SMRG::curvature_feature_points(m.mesh, std::back_inserter(points));
  BOOST_TEST(points.empty());
}

BOOST_AUTO_TEST_CASE(of_flat_and_of_rolled_surfaces_is_0)
{
  for (const Index_mesh& input : {grid(8, 5), cylinder(20, 6)}) {
    const Function_mesh m(input);
    for (const double value :
         m.values([&](auto map) { SMRG::Gaussian_curvature_function(m.mesh, map); }))
      BOOST_TEST(std::abs(value) < 1e-12);
  }
}

// On a torus it is cos(v) / (r (R + r cos(v))), which changes little over the smoothing length.
BOOST_AUTO_TEST_CASE(of_a_torus)
{
  const Function_mesh m(torus(160, 80));
  const double area = 4 * pi * pi * 0.4;
  const auto values = m.values([&](auto map) {
    SMRG::Gaussian_curvature_function(m.mesh, map, SMRG::parameters::smoothing_length(0.001));
  });
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double angle = 2 * pi * static_cast<double>(v % 80) / 80;
    const double exact = std::cos(angle) / (0.4 * (1 + 0.4 * std::cos(angle)));
    BOOST_TEST(std::abs(values[v] - exact * area / (4 * pi)) < 0.02);
  }
}

// Gauss and Bonnet, at every smoothing length.
BOOST_AUTO_TEST_CASE(integral_is_the_Euler_characteristic)
{
  for (const Index_mesh& input : {star(2), torus(20, 10)}) {
    const Function_mesh m(input);
    const Eigenbasis basis(m.mesh,
                           SMRG::parameters::use_intrinsic_Delaunay(true).number_of_eigenpairs(2));
    for (const double length : {0., 0.05, 1.}) {
      const auto values = m.values([&](auto map) {
        SMRG::Gaussian_curvature_function(m.mesh, map, SMRG::parameters::smoothing_length(length));
      });
      BOOST_TEST(std::abs(4 * pi * mean(basis, m, values) -
                          2 * pi * static_cast<double>(Euler_characteristic(input))) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(spectral)

// By the addition theorem the squares of the 2 l + 1 spherical harmonics of degree l sum to a constant,
// and so all functions of squares are constant on the sphere.
BOOST_AUTO_TEST_CASE(squares_on_a_sphere_are_those_of_the_addition_theorem)
{
  const Function_mesh m(sphere(4));
  constexpr int degrees = 7;
  const Eigenbasis basis(m.mesh,
                         SMRG::parameters::number_of_eigenpairs((degrees + 1) * (degrees + 1) - 1)
                             .extend_to_gap(false));
  for (const double t : {0.1, 0.5, 2., 10.}) {
    double exact = 1;
    for (int l = 1; l <= degrees; ++l)
      exact += (2 * l + 1) * std::exp(-t * l * (l + 1) / 2.);
    for (const double value :
         m.values([&](auto map) { SMRG::auto_diffusion_function(basis, t, map); }))
      BOOST_TEST(std::abs(value / exact - 1) < 0.01);
    for (const double value :
         m.values([&](auto map) { SMRG::heat_kernel_signature(basis, t, map); }))
      BOOST_TEST(std::abs(value - 1) < 0.01);
  }
  for (const double energy : {0., 1., 3.})
    for (const double value :
         m.values([&](auto map) { SMRG::wave_kernel_signature(basis, energy, map); }))
      BOOST_TEST(std::abs(value - 1) < 0.02);
}

// On the flat rectangle [0, 2] x [0, 1] the eigenfunctions are products of cosines.
BOOST_AUTO_TEST_CASE(auto_diffusion_on_a_rectangle)
{
  const Function_mesh m(transformed(grid(80, 40), [](auto p) {
    return std::array<double, 3>{p[0] / 40, p[1] / 40, 0};
  }));
  const Eigenbasis basis(m.mesh, SMRG::parameters::number_of_eigenpairs(60));
  const double t = 0.4;
  const auto values = m.values([&](auto map) { SMRG::auto_diffusion_function(basis, t, map); });
  const auto theta = [](double x, double time) {
    double sum = 1;
    for (int k = 1; k < 40; ++k)
      sum += 2 * std::exp(-time * k * k) * std::pow(std::cos(k * pi * x), 2);
    return sum;
  };
  for (std::size_t v = 0; v < values.size(); ++v) {
    const auto& p = m.input.points[v];
    // eigenvalues are pi^2 (j^2 / 4 + k^2), the first one pi^2 / 4
    const double exact = theta(p[0] / 2, t) * theta(p[1], 4 * t);
    BOOST_TEST(std::abs(values[v] / exact - 1) < 0.01);
  }
  BOOST_TEST(largest_value(values) == values[highest(values)]);
  const auto& corner = m.input.points[highest(values)];
  BOOST_TEST((corner[0] == 0 || corner[0] == 2));
  BOOST_TEST((corner[1] == 0 || corner[1] == 1));
}

BOOST_AUTO_TEST_CASE(means_of_signatures_are_1)
{
  Index_mesh input = star(2);
  append(input, grid(5, 4), 10);
  input.points.push_back({0, 0, 9});
  const Function_mesh m(input);
  const Eigenbasis basis(m.mesh, SMRG::parameters::number_of_eigenpairs(20));
  for (const double x : {0., 0.3, 2., 40.}) {
    const auto heat = m.values([&](auto map) { SMRG::heat_kernel_signature(basis, x, map); });
    const auto wave = m.values([&](auto map) { SMRG::wave_kernel_signature(basis, x, map); });
    const auto diffusion =
        m.values([&](auto map) { SMRG::auto_diffusion_function(basis, x, map); });
    BOOST_TEST(std::abs(mean(basis, m, heat) - 1) < 1e-9);
    BOOST_TEST(std::abs(mean(basis, m, wave) - 1) < 1e-9);
    BOOST_TEST(heat.back() == 1); // isolated
    BOOST_TEST(wave.back() == 1);
    BOOST_TEST(diffusion.back() == 1);
    const double factor = diffusion.front() / heat.front(); // on the first component
    for (std::size_t v = 0; v < 162; ++v)
      BOOST_TEST(std::abs(diffusion[v] / heat[v] - factor) < 1e-12 * factor);
  }
  // at a width of nearly zero, the energy of a simple eigenvalue gives its eigenfunction alone
  const double energy = std::log(basis.eigenvalue(1, 2) / basis.eigenvalue(1, 1));
  const auto wave = m.values([&](auto map) {
    SMRG::wave_kernel_signature(basis, energy, map, SMRG::parameters::energy_width(1e-6));
  });
  for (const vertex_descriptor v : basis.component_vertices(1)) {
    const double psi = basis.eigenfunction(2, v);
    BOOST_TEST(std::abs(wave[v] - basis.area(1) * psi * psi) < 1e-9);
  }
  BOOST_CHECK_THROW(m.values([&](auto map) { SMRG::auto_diffusion_function(basis, -1, map); }),
                    CGAL::Precondition_exception);
  BOOST_CHECK_THROW(m.values([&](auto map) {
    SMRG::wave_kernel_signature(basis, 1, map, SMRG::parameters::energy_width(0));
  }),
                    CGAL::Precondition_exception);
}

// On the unit sphere, with the Legendre polynomials P_l: the squared distance at angle a is
// 2 sum_l (2 l + 1) (2 / (l (l + 1)))^2 (1 - P_l(cos a)), in units of a component of area 1.
BOOST_AUTO_TEST_CASE(biharmonic_distances_on_a_sphere)
{
  const Function_mesh m(sphere(4));
  constexpr int degrees = 7;
  const Eigenbasis basis(m.mesh,
                         SMRG::parameters::number_of_eigenpairs((degrees + 1) * (degrees + 1) - 1)
                             .extend_to_gap(false));
  const auto values =
      m.values([&](auto map) { SMRG::biharmonic_distances(basis, m.vertices[0], map); });
  for (std::size_t v = 0; v < values.size(); ++v) {
    double x = 0;
    for (std::size_t i = 0; i < 3; ++i)
      x += m.input.points[v][i] * m.input.points[0][i];
    double sum = 0, previous = 1, legendre = x;
    for (int l = 1; l <= degrees; ++l) {
      sum += 2 * (2 * l + 1) * std::pow(2. / (l * (l + 1)), 2) * (1 - legendre);
      const double next = ((2 * l + 1) * x * legendre - l * previous) / (l + 1);
      previous = legendre;
      legendre = next;
    }
    BOOST_TEST(std::abs(values[v] - std::sqrt(sum)) < 0.02 * std::sqrt(sum) + 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(biharmonic_distances_in_components)
{
  Index_mesh input = star(2);
  append(input, sphere(1), 10);
  const Function_mesh m(input);
  const Eigenbasis basis(m.mesh, SMRG::parameters::number_of_eigenpairs(20));
  const auto values =
      m.values([&](auto map) { SMRG::biharmonic_distances(basis, m.vertices[4], map); });
  BOOST_TEST(values[4] == 0);
  for (std::size_t v = 0; v < values.size(); ++v) {
    double sum = 0;
    if (v < 162)
      for (std::size_t k = 1; k <= basis.number_of_eigenpairs(0); ++k) {
        const double difference =
            basis.eigenfunction(k, m.vertices[v]) - basis.eigenfunction(k, m.vertices[4]);
        sum += std::pow(basis.eigenvalue(0, 1) / basis.eigenvalue(0, k) * difference, 2);
      }
    if (v < 162)
      BOOST_TEST(std::abs(values[v] - std::sqrt(basis.area(0) * sum)) < 1e-10);
    else
      BOOST_TEST(values[v] == std::numeric_limits<double>::infinity());
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(commute_time)

BOOST_AUTO_TEST_CASE(choices_of_the_paper)
{
  const Function_mesh m(star(2));
  const Eigenbasis basis(m.mesh);
  std::vector<vertex_descriptor> points;
  SMRG::feature_points(basis, std::back_inserter(points));
  BOOST_TEST(points.size() == 6u);

  // one call does what the steps do
  std::vector<vertex_descriptor> found;
  const auto steps = m.values([&](auto map) { SMRG::commute_time_function(basis, points, map); });
  const auto one_call = m.values([&](auto map) {
    SMRG::commute_time_function(
        m.mesh, map, SMRG::parameters::output_iterator(std::back_inserter(found)));
  });
  BOOST_TEST(one_call == steps, boost::test_tools::per_element());
  BOOST_TEST(found == points, boost::test_tools::per_element());

  // the nearest point, and points of the user
  const std::vector<vertex_descriptor> chosen = m.descriptors({0, 40, 90});
  const auto nearest = m.values([&](auto map) {
    SMRG::commute_time_function(
        m.mesh, map, SMRG::parameters::use_nearest_feature_point(true).feature_points(chosen));
  });
  const auto farthest = m.values([&](auto map) {
    SMRG::commute_time_function(m.mesh, map, SMRG::parameters::feature_points(chosen));
  });
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    std::vector<double> distances;
    for (const vertex_descriptor point : chosen)
      distances.push_back(basis.commute_time_distance(m.vertices[v], point));
    BOOST_TEST(std::abs(nearest[v] - smallest_value(distances)) < 1e-12);
    BOOST_TEST(std::abs(farthest[v] - largest_value(distances)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(without_feature_points_it_is_zero)
{
  const Function_mesh m(sphere(1));
  const Eigenbasis basis(m.mesh);
  for (const bool nearest : {false, true})
    for (const double value : m.values([&](auto map) {
           SMRG::commute_time_function(basis,
                                       std::vector<vertex_descriptor>(),
                                       map,
                                       SMRG::parameters::use_nearest_feature_point(nearest));
         }))
      BOOST_TEST(value == 0);
}

BOOST_AUTO_TEST_SUITE_END()
