// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time of the spectral distances over a whole mesh, for eigenfunctions kept in `double` and in
// `float`, beside the floor: one pass over the matrix of the eigenfunctions, which adds up its
// numbers.
//
// The floor and what is compared with it alternate, and the least time of each counts. Benchmarks
// are named what/number type, for --benchmark_filter. The counters:
//   x_floor      time / time of the floor with the same number type
//   GB_per_s     bytes of the matrix / time
//   GFlop_per_s  additions and multiplications that the definition takes with a product of
//                matrices / time
//   difference   the largest one to the distances from eigenfunctions in `double`, in parts of the
//                largest distance

#include "meshes.h"
#include "seconds_for.h"

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>

#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

using namespace Reeb_graph_benchmark;
namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

namespace {

template <class Number>
using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh, SMRG::Block_Lanczos_eigensolver<>, Number>;
using Vertices = std::vector<Mesh::Vertex_index>;
using Values = std::vector<double>;

Vertices spread_vertices(const Mesh& mesh, const std::size_t number)
{
  Vertices result;
  for (std::size_t i = 0; i < number; ++i)
    result.emplace_back(static_cast<Mesh::size_type>(mesh.number_of_vertices() * i / number));
  return result;
}

double largest_difference(const Values& values, const Values& expected)
{
  double largest = 0, result = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    largest = (std::max)(largest, std::abs(expected[i]));
    result = (std::max)(result, std::abs(values[i] - expected[i]));
  }
  return result / largest;
}

// Measures `task(basis, values)`, whose result is compared with that for `exact_basis` if it fills
// the values. `flops` are operations per number of the matrix.
template <class Number, class Task>
void measure(benchmark::State& state,
             const Basis<Number>& basis,
             const Basis<double>& exact_basis,
             const double flops,
             const Task& task)
{
  const auto& eigenfunctions = basis.basis(0).eigenfunctions;
  Values values(static_cast<std::size_t>(eigenfunctions.rows()), 0);
  double least = std::numeric_limits<double>::infinity(), least_floor = least;
  for (auto _ : state) {
    least_floor = (std::min)(
        least_floor, seconds_for([&]() { benchmark::DoNotOptimize(eigenfunctions.sum()); }));
    const double seconds = seconds_for([&]() { task(basis, values); });
    least = (std::min)(least, seconds);
    state.SetIterationTime(seconds);
  }
  const double size = double(eigenfunctions.size());
  state.counters["x_floor"] = least / least_floor;
  state.counters["GB_per_s"] = size * sizeof(Number) / least * 1e-9;
  if (flops > 0)
    state.counters["GFlop_per_s"] = size * flops / least * 1e-9;
  if (!std::is_same<Number, double>::value) {
    Values expected(values.size(), 0);
    task(exact_basis, expected);
    if (*std::max_element(expected.begin(), expected.end()) > 0)
      state.counters["difference"] = largest_difference(values, expected);
  }
}

template <class Number>
void register_benchmarks(const Mesh& mesh,
                         const Basis<Number>& basis,
                         const Basis<double>& exact_basis,
                         const std::string& number_type)
{
  const auto add = [&](const std::string& what, const double flops, const auto& task) {
    benchmark::RegisterBenchmark((what + '/' + number_type).c_str(),
                                 [&basis, &exact_basis, flops, task](benchmark::State& state) {
                                   measure(state, basis, exact_basis, flops, task);
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };

  add("floor", 1, [](const auto& b, Values&) {
    benchmark::DoNotOptimize(b.basis(0).eigenfunctions.sum());
  });
  const Mesh::Vertex_index source(0);
  add("diffusion_distances", 3, [source](const auto& b, Values& values) {
    SMRG::diffusion_distances(b, source, 1.5, CGAL::make_property_map(values));
  });
  add("commute_time_distances", 3, [source](const auto& b, Values& values) {
    SMRG::commute_time_distances(b, source, CGAL::make_property_map(values));
  });
  add("commute_time_distances_pair_by_pair", 3, [&mesh, source](const auto& b, Values& values) {
    for (const Mesh::Vertex_index v : mesh.vertices())
      values[v] = b.commute_time_distance(source, v);
  });
  for (const std::size_t number : {4, 16, 64}) {
    const Vertices sources = spread_vertices(mesh, number);
    add("commute_time_function_of_" + std::to_string(number),
        3 + 2 * double(number - 1),
        [sources](const auto& b, Values& values) {
          SMRG::commute_time_function(b, sources, CGAL::make_property_map(values));
        });
  }
  add("feature_points", 0, [](const auto& b, Values&) {
    Vertices points;
    SMRG::feature_points(b, std::back_inserter(points));
    benchmark::DoNotOptimize(points.data());
  });
}

} // namespace

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  const double number_of_vertices = argc > 1 ? std::atof(argv[1]) : 640000;
  if (argc > 2 || !(number_of_vertices >= 100)) {
    std::cerr << "usage: " << argv[0] << " [options that --help lists] [number of vertices]\n";
    return EXIT_FAILURE;
  }
  try {
    const Mesh mesh =
        irregular_surface(std::size_t(std::lround(std::sqrt(number_of_vertices / 4))));
    const Basis<double> basis(mesh);
    const Basis<float> float_basis(mesh);
    register_benchmarks(mesh, basis, basis, "double");
    register_benchmarks(mesh, float_basis, basis, "float");
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
