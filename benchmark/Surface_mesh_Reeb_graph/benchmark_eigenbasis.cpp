// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time and memory of Laplace_Beltrami_eigenbasis with 50 eigenpairs, and where the time goes,
// beside other eigensolvers and direct solvers that find the same eigenpairs with the same
// tolerance.
//
// Benchmarks are named irregular/vertices/solver, for --benchmark_filter. With
// --benchmark_repetitions and --benchmark_enable_random_interleaving the solvers alternate; the
// fastest run of each counts. The counters, in seconds of processor time:
//   assembly        of the matrices, from the mesh
//   factorization   of the shifted stiffness matrix
//   solving         for all right-hand sides, whose number is rhs
//   x_floor         total / time of the factorization and of 50 right-hand sides
//   residual        the largest one of all eigenpairs, relative
//   bytes           per vertex, at the peak

#include "Measured_solver_traits.h"
#include "eigenbasis_table.h"
#include "meshes.h"
#include "resident_memory.h"
#ifdef REEB_GRAPH_BENCHMARK_WITH_CHOLMOD
#include "peers_cholmod.h"
#endif

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Spectra_eigensolver.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/SparseCholesky>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef REEB_GRAPH_BENCHMARK_WITH_ARPACK
#include "peers_arpack.h" // the last one
#endif
#ifdef _OPENMP
#include <omp.h>
#endif

#ifdef REEB_GRAPH_BENCHMARK_WITH_OPENBLAS
extern "C" void openblas_set_num_threads(int number);
#endif

using namespace Reeb_graph_benchmark;
namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

namespace {

constexpr const char* usage =
    "Options of this program, beside those that --help lists, and files of triangle meshes to be "
    "measured, too:\n"
    "  --largest=N   meshes of up to about N vertices (160000; 1000000 shows all)\n"
    "  --table=FILE  writes the results as tables in Markdown\n";

struct Options
{
  double largest = 160000;
  std::string table;
  std::vector<std::string> files;
};

constexpr std::array<std::size_t, 5> sizes = {10000, 40000, 160000, 640000, 1000000};
constexpr std::size_t number_of_eigenpairs = 50;

Results results;

// ---- input --------------------------------------------------------------------------------------

Mesh read(const std::string& file)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot read a triangle mesh from " + file);
  return mesh;
}

// Benchmarks of the same mesh follow each other: one is kept.
const Mesh& mesh_for(const Mesh_key& key)
{
  static Mesh_key last_key;
  static Mesh mesh;
  if (key != last_key) {
    mesh = Mesh(); // before there is another one
    // the sphere that it is made from has 4 m^2 + 2 vertices
    mesh = key.file.empty()
               ? irregular_surface(std::size_t(std::lround(std::sqrt(double(key.size) / 4))))
               : read(key.file);
    last_key = key;
  }
  return mesh;
}

// ---- what is measured ---------------------------------------------------------------------------

using Default_traits = Measured_solver_traits<SMRG::internal::Default_solver_traits>;
using Ldlt_traits = Measured_solver_traits<
    CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>>;
#ifdef REEB_GRAPH_BENCHMARK_WITH_CHOLMOD
using Cholmod_traits = Measured_solver_traits<Cholmod_solver_traits>;
#endif

double assembly_seconds(const Mesh& mesh)
{
  const SMRG::internal::Mesh_components<Mesh> components(mesh);
  return processor_seconds_for([&]() {
    benchmark::DoNotOptimize(SMRG::internal::assemble_Laplace_Beltrami_matrices(
        mesh, get(CGAL::vertex_point, mesh), components, 0));
  });
}

// All solvers must find what the first one found.
template <class Basis>
bool agrees(const Mesh_key& key, const Basis& basis)
{
  static std::map<Mesh_key, std::vector<double>> eigenvalues;
  std::vector<double> found;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    for (std::size_t k = 1; k <= basis.number_of_eigenpairs(c); ++k)
      found.push_back(basis.eigenvalue(c, k));
  const std::vector<double>& expected = eigenvalues.emplace(key, found).first->second;
  return std::equal(
      found.begin(), found.end(), expected.begin(), expected.end(), [](double a, double b) {
        return std::abs(a - b) <= 1e-9 * b;
      });
}

template <Solver solver, class Eigensolver>
void measure(benchmark::State& state, const Mesh_key& key)
{
  using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh, Eigensolver>;

  const Mesh& mesh = mesh_for(key);
  Row& row = results[key];
  row.vertices = mesh.number_of_vertices();
  Result& least = row.results[solver];
  for (auto _ : state) {
    row.assembly_seconds = (std::min)(row.assembly_seconds, assembly_seconds(mesh));

    Result result;
    direct_solver_times = Direct_solver_times();
    warm_up_memory(3000 * row.vertices); // as much as anybody uses
    const Resident_memory_meter memory;
    std::optional<Basis> basis;
    result.seconds = processor_seconds_for([&]() {
      basis.emplace(mesh, SMRG::parameters::number_of_eigenpairs(number_of_eigenpairs));
    });
    result.bytes = double(memory.peak());
    result.factorization_seconds = direct_solver_times.factorization_seconds;
    result.solution_seconds = direct_solver_times.solution_seconds;
    result.right_hand_sides = direct_solver_times.right_hand_sides;
    result.residual = basis->residual();
    state.SetIterationTime(result.seconds);
    if (result.seconds < least.seconds)
      least = result;
    if (!agrees(key, *basis))
      state.SkipWithError("the solvers find different eigenvalues");
  }
  state.counters["assembly"] = row.assembly_seconds;
  state.counters["factorization"] = least.factorization_seconds;
  state.counters["solving"] = least.solution_seconds;
  state.counters["rhs"] = double(least.right_hand_sides);
  state.counters["x_floor"] = least.seconds / least.floor_seconds(number_of_eigenpairs);
  state.counters["residual"] = least.residual;
  state.counters["bytes"] = least.bytes / double(row.vertices);
}

// ---- the program --------------------------------------------------------------------------------

template <Solver solver, class Eigensolver>
void add(const Mesh_key& key)
{
  const std::string name = key.name() + '/' + std::to_string(key.size) + '/' + solver_names[solver];
  benchmark::RegisterBenchmark(
      name.c_str(), [key](benchmark::State& state) { measure<solver, Eigensolver>(state, key); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void add_all_solvers(const Mesh_key& key)
{
  add<OURS, SMRG::Block_Lanczos_eigensolver<Default_traits>>(key);
  add<SPECTRA_LDLT, SMRG::Spectra_eigensolver<Ldlt_traits>>(key);
#ifdef REEB_GRAPH_BENCHMARK_WITH_CHOLMOD
  add<OURS_CHOLMOD, SMRG::Block_Lanczos_eigensolver<Cholmod_traits>>(key);
  add<SPECTRA_CHOLMOD, SMRG::Spectra_eigensolver<Cholmod_traits>>(key);
#ifdef REEB_GRAPH_BENCHMARK_WITH_ARPACK
  add<ARPACK_CHOLMOD, Arpack_eigensolver<Cholmod_traits>>(key);
#endif
#endif
}

void register_benchmarks(const Options& options)
{
  for (const std::string& file : options.files)
    add_all_solvers({read(file).number_of_vertices(), file});
  for (const std::size_t size : sizes)
    if (double(size) <= options.largest)
      add_all_solvers({size, std::string()});
}

// Reads the options that are left when Google Benchmark has taken its own.
bool read_options(int argc, char* argv[], Options& options)
{
  const std::string largest = "--largest=", table = "--table=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.compare(0, largest.size(), largest) == 0) {
      options.largest = std::atof(argument.c_str() + largest.size());
    } else if (argument.compare(0, table.size(), table) == 0) {
      options.table = argument.substr(table.size());
    } else if (argument.compare(0, 1, "-") != 0) {
      options.files.push_back(argument);
    } else {
      std::cerr << "unknown option " << argument << '\n' << usage;
      return false;
    }
  }
  return true;
}

// The threads of CHOLMOD and of its BLAS wait for each other busily, which takes many times longer
// where other programs run; and one thread is compared with one thread.
void use_one_thread()
{
#ifdef _OPENMP
  omp_set_num_threads(1);
#endif
#ifdef REEB_GRAPH_BENCHMARK_WITH_OPENBLAS
  openblas_set_num_threads(1);
#endif
}

} // namespace

int main(int argc, char* argv[])
{
  use_one_thread();
  Options options;
  benchmark::Initialize(&argc, argv);
  if (!read_options(argc, argv, options))
    return EXIT_FAILURE;
  try {
    register_benchmarks(options);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  if (!options.table.empty()) {
    std::ofstream out(options.table);
    write_tables(out, results, number_of_eigenpairs);
    if (!out.flush()) {
      std::cerr << "cannot write " << options.table << '\n';
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
