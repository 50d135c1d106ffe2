// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time and memory of compute_Reeb_graph() for a scalar function that is given, beside the floor
// (one pass over the faces that reads the three values of each and counts its middle vertex) and
// beside VTK.
//
// The floor and what is compared with it alternate on the same mesh, and the least time of each
// counts, so that a machine that has other things to do spoils the ratios little.
//
// Benchmarks are named mesh/triangles/function/algorithm, for --benchmark_filter. The counters:
//   vertices, triangles, nodes, loops
//   x_floor   time / time of the floor
//   working   bytes per vertex at the peak, without the output
//   output    bytes per vertex of the graph
//   vtk_ratio time of VTK / time of the automatic choice

#include "functions.h"
#include "allocated_memory.h"
#include "meshes.h"
#include "seconds_for.h"
#include "table.h"
#ifdef REEB_GRAPH_BENCHMARK_WITH_VTK
#include "peers_vtk.h"
#endif

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace Reeb_graph_benchmark;

namespace {

constexpr const char* usage =
    "Options of this program, beside those that --help lists:\n"
    "  --largest=N          meshes of up to about N triangles (700000; 8000000 shows the\n"
    "                       scaling up to 4 million vertices)\n"
    "  --mapping_largest=N  the commute-time mapping function up to N triangles (50000)\n"
    "  --vtk_largest=N      VTK, where it was found, up to N triangles (165000)\n"
    "  --vtk_functions=all  VTK with noise too, not only smooth functions\n"
    "  --table=FILE         writes the results as tables in Markdown\n";

struct Options
{
  double largest = 700000;
  double mapping_largest = 50000;
  double vtk_largest = 165000;
  bool vtk_with_noise = false;
  std::string table;
};

// In triangles. The number of vertices is half of it: from 10 thousand to 4 million.
constexpr std::array<std::size_t, 8> sizes = {
    20000, 40000, 162000, 640000, 1300000, 2600000, 4000000, 8000000};

Results results;

// ---- input --------------------------------------------------------------------------------------

struct Input
{
  Row_key key;
  Mesh mesh;
  std::vector<double> values;
};

// Benchmarks of the same input follow each other: one is kept, and its mesh if only the function
// changes.
const Input& input_for(const Row_key& key)
{
  static Input input{{mesh_families.size(), 0, SMOOTH}, {}, {}};
  const auto [family, size, function] = key;
  const auto [last_family, last_size, last_function] = input.key;
  const bool has_mesh = family == last_family && size == last_size;
  if (has_mesh && function == last_function)
    return input;

  if (!has_mesh) {
    const Mesh_family& f = mesh_families[family];
    input.mesh = Mesh(); // before there is another one
    input.mesh = make_mesh(f.make(f.size_for(double(size))), f.genus);
  }
  input.values = values_of(function, input.mesh);
  input.key = key;
  return input;
}

// ---- what is measured ---------------------------------------------------------------------------

void take_minimum(double& minimum, const double seconds)
{
  minimum = (std::min)(minimum, seconds);
}

void floor_pass(const Mesh& mesh,
                const std::vector<double>& values,
                std::vector<std::uint8_t>& count)
{
  std::fill(count.begin(), count.end(), std::uint8_t(0));
  for (const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    std::array<std::size_t, 3> v = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    if (values[v[0]] > values[v[1]])
      std::swap(v[0], v[1]);
    if (values[v[1]] > values[v[2]])
      std::swap(v[1], v[2]);
    if (values[v[0]] > values[v[1]])
      std::swap(v[0], v[1]);
    ++count[v[1]];
  }
  benchmark::DoNotOptimize(count.data());
}

// Three times, since the slowest graphs are computed once only, and the least time counts.
double time_floor(const Input& input)
{
  std::vector<std::uint8_t> count(input.mesh.number_of_vertices());
  double least = not_measured;
  for (int i = 0; i < 3; ++i)
    take_minimum(least, seconds_for([&]() { floor_pass(input.mesh, input.values, count); }));
  return least;
}

// Where the arcs go; made before the measurement.
struct Arc_maps
{
  explicit Arc_maps(const Mesh& mesh)
    : of_vertices(mesh.number_of_vertices()), of_faces(mesh.number_of_faces())
  {}

  std::vector<std::size_t> of_vertices, of_faces;
};

template <Algorithm algorithm>
void compute_graph(const Input& input, SMRG::Reeb_graph<Mesh>& graph, Arc_maps& arcs)
{
  using Choice = SMRG::Reeb_graph_algorithm;
  constexpr Choice choice = algorithm == CUTTING ? Choice::CUTTING
                            : algorithm == SWEEP ? Choice::SWEEP
                                                 : Choice::AUTOMATIC;
  constexpr bool is_parallel = algorithm == PARALLEL || algorithm == PARALLEL_VERTEX_MAP;
  using Tag = std::conditional_t<is_parallel, CGAL::Parallel_tag, CGAL::Sequential_tag>;
  const auto compute = [&](const auto& np) {
    SMRG::compute_Reeb_graph<Tag>(input.mesh, CGAL::make_property_map(input.values), graph, np);
  };
  if constexpr (algorithm == VERTEX_MAP || algorithm == PARALLEL_VERTEX_MAP)
    compute(SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs.of_vertices)));
  else if constexpr (algorithm == FACE_MAP)
    compute(SMRG::parameters::face_arc_map(CGAL::make_property_map(arcs.of_faces)));
  else if constexpr (algorithm == ARC_VERTICES)
    compute(SMRG::parameters::collect_arc_vertices(true));
  else
    compute(CGAL::parameters::algorithm(choice));
}

Row& row_of(const Input& input)
{
  Row& row = results[input.key];
  row.vertices = input.mesh.number_of_vertices();
  row.triangles = input.mesh.number_of_faces();
  return row;
}

void set_size_counters(benchmark::State& state, const Row& row)
{
  state.counters["vertices"] = double(row.vertices);
  state.counters["triangles"] = double(row.triangles);
  state.counters["nodes"] = double(row.nodes);
}

template <Algorithm algorithm>
void measure(benchmark::State& state, const Row_key& key)
{
  const Input& input = input_for(key);
  Row& row = row_of(input);
  Result& result = row.results[algorithm];
  std::size_t loops = 0;
  Arc_maps arcs(input.mesh);
  for (auto _ : state) {
    take_minimum(row.floor_seconds, time_floor(input));

    const Memory_meter memory;
    SMRG::Reeb_graph<Mesh> graph;
    const double seconds = seconds_for([&]() { compute_graph<algorithm>(input, graph, arcs); });
    result.output_bytes = double(memory.live());
    result.working_bytes = double(memory.peak() - memory.live());
    take_minimum(result.seconds, seconds);
    state.SetIterationTime(seconds);

    loops = num_edges(graph) + 1 - num_vertices(graph);
    const bool is_first = row.nodes == 0;
    if (!is_first && row.nodes != num_vertices(graph))
      state.SkipWithError("the algorithms differ");
    if (loops > mesh_families[std::get<0>(key)].genus)
      state.SkipWithError("the graph has more loops than the surface has handles");
    row.nodes = num_vertices(graph);
  }
  set_size_counters(state, row);
  state.counters["loops"] = double(loops);
  state.counters["x_floor"] = row.ratio_to_floor(algorithm);
  state.counters["working"] = result.working_bytes / double(row.vertices);
  state.counters["output"] = result.output_bytes / double(row.vertices);
}

void measure_floor(benchmark::State& state, const Row_key& key)
{
  const Input& input = input_for(key);
  Row& row = row_of(input);
  for (auto _ : state) {
    const double seconds = time_floor(input);
    take_minimum(row.floor_seconds, seconds);
    state.SetIterationTime(seconds);
  }
}

#ifdef REEB_GRAPH_BENCHMARK_WITH_VTK
void measure_vtk(benchmark::State& state, const Row_key& key)
{
  const Input& input = input_for(key);
  Row& row = row_of(input);
  Vtk_input vtk_input(input.mesh, input.values);
  Arc_maps arcs(input.mesh);
  for (auto _ : state) {
    SMRG::Reeb_graph<Mesh> graph;
    take_minimum(row.results[AUTOMATIC].seconds,
                 seconds_for([&]() { compute_graph<AUTOMATIC>(input, graph, arcs); }));
    std::size_t nodes = 0;
    const double seconds = seconds_for([&]() { nodes = vtk_input.compute_Reeb_graph(); });
    take_minimum(row.vtk_seconds, seconds);
    state.SetIterationTime(seconds);
    row.nodes = num_vertices(graph);
    if (nodes != row.nodes)
      state.SkipWithError("VTK finds other critical vertices");
  }
  set_size_counters(state, row);
  state.counters["vtk_ratio"] = row.vtk_seconds / row.results[AUTOMATIC].seconds;
}
#endif

// ---- the program --------------------------------------------------------------------------------

void register_benchmarks(const Options& options)
{
  const auto add = [](const std::string& name, const auto& function, const Row_key& key) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [function, key](benchmark::State& state) { function(state, key); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };

  for (std::size_t family = 0; family < mesh_families.size(); ++family) {
    const Mesh_family& f = mesh_families[family];
    for (const std::size_t size : sizes) {
      const std::size_t m = f.size_for(double(size));
      const double triangles = double(f.number_of_triangles(m));
      // the meshes do not come in every size: not those that are far from what the table says
      if (double(size) > options.largest || m < f.smallest_m ||
          std::abs(triangles / double(size) - 1) > 0.3)
        continue;
      for (const Function function : {SMOOTH, FINE_NOISE, ONE_PERCENT_NOISE, PURE_NOISE, MAPPING}) {
        if (function == MAPPING && triangles > options.mapping_largest)
          continue;
        const Row_key key{family, size, function};
        const std::string name = std::string(f.name) + '/' +
                                 std::to_string(std::size_t(triangles)) + '/' +
                                 function_names[function] + '/';
        add(name + "floor", measure_floor, key);
        add(name + algorithm_names[AUTOMATIC], measure<AUTOMATIC>, key);
        add(name + algorithm_names[CUTTING], measure<CUTTING>, key);
        add(name + algorithm_names[SWEEP], measure<SWEEP>, key);
        add(name + algorithm_names[VERTEX_MAP], measure<VERTEX_MAP>, key);
        add(name + algorithm_names[ARC_VERTICES], measure<ARC_VERTICES>, key);
        add(name + algorithm_names[FACE_MAP], measure<FACE_MAP>, key);
#ifdef CGAL_LINKED_WITH_TBB
        add(name + algorithm_names[PARALLEL], measure<PARALLEL>, key);
        add(name + algorithm_names[PARALLEL_VERTEX_MAP], measure<PARALLEL_VERTEX_MAP>, key);
#endif
#ifdef REEB_GRAPH_BENCHMARK_WITH_VTK
        if (triangles <= options.vtk_largest && (function == SMOOTH || options.vtk_with_noise))
          add(name + "vtk", measure_vtk, key);
#endif
      }
    }
  }
}

// Reads the options that are left when Google Benchmark has taken its own.
bool read_options(int argc, char* argv[], Options& options)
{
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto has_value = [&](const char* option, std::string& value) {
      const std::size_t length = std::strlen(option);
      if (argument.compare(0, length, option) != 0)
        return false;
      value = argument.substr(length);
      return !value.empty();
    };
    std::string value;
    if (has_value("--largest=", value))
      options.largest = std::atof(value.c_str());
    else if (has_value("--mapping_largest=", value))
      options.mapping_largest = std::atof(value.c_str());
    else if (has_value("--vtk_largest=", value))
      options.vtk_largest = std::atof(value.c_str());
    else if (argument == "--vtk_functions=all")
      options.vtk_with_noise = true;
    else if (!has_value("--table=", options.table)) {
      std::cerr << "unknown option " << argument << '\n' << usage;
      return false;
    }
  }
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  benchmark::Initialize(&argc, argv);
  if (!read_options(argc, argv, options))
    return EXIT_FAILURE;
  register_benchmarks(options);
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  if (!options.table.empty()) {
    std::ofstream out(options.table);
    write_tables(out, results);
    if (!out.flush()) {
      std::cerr << "cannot write " << options.table << '\n';
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
