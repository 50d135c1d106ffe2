// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time of the simplification of Reeb graphs, beside the floor: a copy of the graph, which reads and
// writes all of it.
//
// Graphs that a simplification which passes arcs or nodes again and again takes quadratic time for,
// from 10 thousand to a million nodes, and Reeb graphs of noise on meshes of up to 4 million
// triangles. Benchmarks are named graph/what/nodes and noise_on_mesh/triangles/what, for
// --benchmark_filter. The floor and what is compared with it alternate, and the least time of each
// counts. The counters:
//   arcs          of the graph
//   arcs_left     of the simplified graph
//   x_floor       time / time of the floor
//   ns_per_m_log  time / (m log2 m) for m nodes and arcs
// The lines that end with BigO and RMS are the fit of c m log2 m, with m nodes, to all sizes of a
// graph.
//
// With --loop_table=FILE the program writes nothing but a table in Markdown: loops closed by
// Loop_closing and node by node, on a scaffold of genus 243 and on a plate with 10 000 holes.

#include "functions.h"
#include "loop_table.h"
#include "meshes.h"
#include "seconds_for.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <benchmark/benchmark.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace Reeb_graph_benchmark;

namespace {

using Graph = SMRG::Reeb_graph<Mesh>;
using Arcs = std::vector<std::pair<std::size_t, std::size_t>>;

// ---- graphs -------------------------------------------------------------------------------------

// The values of the nodes are their numbers, those from `first_high_node` on are far above all
// others.
Graph make_graph(const std::size_t number_of_nodes,
                 const Arcs& arcs,
                 const std::size_t first_high_node)
{
  Graph graph(number_of_nodes);
  std::vector<std::size_t> down(number_of_nodes, 0), up(number_of_nodes, 0);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    graph[add_edge(arcs[i].first, arcs[i].second, graph).first].id = i;
    ++up[arcs[i].first];
    ++down[arcs[i].second];
  }
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    graph[i].id = i;
    graph[i].vertex = Mesh::Vertex_index(static_cast<Mesh::size_type>(i));
    graph[i].value = double(i < first_high_node ? i : i + 10 * number_of_nodes);
    graph[i].type = SMRG::type_of_Reeb_node(down[i], up[i]);
  }
  return graph;
}

// A branch to each of n nodes that follow each other.
void hang_on(Arcs& arcs,
             const std::size_t first_node,
             const std::size_t n,
             const std::size_t first_extremum)
{
  for (std::size_t i = 0; i < n; ++i)
    arcs.emplace_back((std::minmax)(first_node + i, first_extremum + i));
}

// Maxima that stay hang on the highest minimum; zipped one after the other, all minima would hand
// them on to the next.
Graph branches_handed_on(const std::size_t number_of_nodes)
{
  const std::size_t n = number_of_nodes / 4;
  Arcs arcs = {{2 * n - 1, 2 * n}};
  for (std::size_t i = 0; i < n; ++i)
    arcs.emplace_back(n - 1 + i, n + i);
  hang_on(arcs, n, n, 3 * n - 1);
  for (std::size_t i = 1; i < n; ++i) {
    arcs.emplace_back(n - 1 - i, 2 * n - 1 + i);
    arcs.emplace_back(2 * n - 1 + i, i + 1 < n ? 2 * n + i : 4 * n - 1);
  }
  return make_graph(4 * n, arcs, 3 * n - 1);
}

// A path of n nodes, on which maxima that stay hang, and n arcs beside it.
Graph long_cycles(const std::size_t number_of_nodes)
{
  const std::size_t n = (number_of_nodes - 2) / 2;
  Arcs arcs;
  for (std::size_t i = 0; i <= n; ++i)
    arcs.emplace_back(i, i + 1);
  hang_on(arcs, 1, n, n + 2);
  arcs.insert(arcs.end(), n, {0, n + 1});
  return make_graph(2 * n + 2, arcs, n + 2);
}

// Two such paths, whose nodes alternate.
Graph alternating_cycles(const std::size_t number_of_nodes)
{
  const std::size_t n = (number_of_nodes - 2) / 2;
  Arcs arcs = {{0, 1}, {0, 2}};
  for (std::size_t i = 1; i <= n; ++i)
    arcs.emplace_back(i, (std::min)(i + 2, n + 1));
  hang_on(arcs, 1, n, n + 2);
  arcs.insert(arcs.end(), n, {0, n + 1});
  return make_graph(2 * n + 2, arcs, n + 2);
}

// A path that goes up and down, and n arcs beside it.
Graph cycles_with_peaks(const std::size_t number_of_nodes)
{
  const std::size_t n = (number_of_nodes - 3) / 4;
  Arcs arcs = {{n, 2 * n + 1}, {3 * n + 1, 3 * n + 2}};
  for (std::size_t i = 0; i < n; ++i) {
    arcs.emplace_back(n + 1 + i, 2 * n + 1 + i);
    arcs.emplace_back(n + 1 + i, 2 * n + 2 + i);
  }
  hang_on(arcs, n + 1, n, 0);
  hang_on(arcs, 2 * n + 1, n, 3 * n + 3);
  arcs.insert(arcs.end(), n, {n, 3 * n + 1});
  return make_graph(4 * n + 3, arcs, 3 * n + 2);
}

// Two arcs up from every node, of very different lengths.
Graph random_cycles(const std::size_t n)
{
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> logarithm(0, std::log(double(n)));
  Arcs arcs;
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      arcs.emplace_back(i, (std::min)(n - 1, i + 1 + std::size_t(std::exp(logarithm(generator)))));
  return make_graph(n, arcs, n);
}

// The number whose binary digits are those of another one below `bound`, a power of two, in reverse
// order.
std::size_t reversed_bits(std::size_t number, std::size_t bound)
{
  std::size_t result = 0;
  for (; bound > 1; bound /= 2) {
    result = 2 * result + number % 2;
    number /= 2;
  }
  return result;
}

// Paths of 8 nodes each from one node down, with alternating nodes. They meet in pairs, the pairs
// meet in pairs, and so on: when two bundles are zipped together their nodes alternate, so that the
// sides change as often as can be.
Graph nested_cycles(const std::size_t number_of_nodes)
{
  std::size_t number_of_paths = 1;
  while (number_of_paths * 20 <= number_of_nodes)
    number_of_paths *= 2;
  const std::size_t length = 8, n = length * number_of_paths;
  const std::size_t first = number_of_paths; // of the nodes on the paths; below are the splits
  const std::size_t top = first + n;
  Arcs arcs;
  for (std::size_t i = 0; i < n; ++i)
    arcs.emplace_back(first + i, (std::min)(first + i + number_of_paths, top));
  hang_on(arcs, first, n, top + 1);
  // above the split i lie two splits, or two paths
  for (std::size_t i = 1; i < number_of_paths; ++i)
    for (std::size_t k = 2 * i; k < 2 * i + 2; ++k)
      arcs.emplace_back(
          i, k < number_of_paths ? k : first + reversed_bits(k - number_of_paths, number_of_paths));
  arcs.emplace_back(0, 1);
  return make_graph(top + 1 + n, arcs, top + 1);
}

// ---- measurements -------------------------------------------------------------------------------

// Measures the simplification of a graph with these named parameters. `arcs` are those of the
// vertices of the mesh, which are brought up to date on demand.
template <bool has_map, class ScalarMap, class NamedParameters>
void measure(benchmark::State& state,
             const Mesh& mesh,
             const ScalarMap scalar_map,
             const Graph& graph,
             const std::vector<std::size_t>& arcs,
             const NamedParameters& parameters)
{
  double least = std::numeric_limits<double>::infinity(), least_floor = least;
  std::size_t number_of_arcs_left = 0;
  for (auto _ : state) {
    std::vector<std::size_t> arcs_of_copy = arcs;
    Graph copy;
    least_floor = (std::min)(least_floor, seconds_for([&]() { copy = graph; }));
    const double seconds = seconds_for([&]() {
      if constexpr (has_map)
        SMRG::simplify_Reeb_graph(mesh,
                                  scalar_map,
                                  copy,
                                  parameters.vertex_arc_map(CGAL::make_property_map(arcs_of_copy)));
      else
        SMRG::simplify_Reeb_graph(mesh, scalar_map, copy, parameters);
    });
    least = (std::min)(least, seconds);
    state.SetIterationTime(seconds);
    number_of_arcs_left = num_edges(copy);
  }
  const double m = double(num_vertices(graph) + num_edges(graph));
  state.SetComplexityN(static_cast<benchmark::IterationCount>(num_vertices(graph)));
  state.counters["arcs"] = double(num_edges(graph));
  state.counters["arcs_left"] = double(number_of_arcs_left);
  state.counters["x_floor"] = least / least_floor;
  state.counters["ns_per_m_log"] = least * 1e9 / (m * std::log2(m));
}

// The vertices of the nodes, and one somewhere on every arc.
struct Vertices_of_graph
{
  Mesh mesh;
  std::vector<double> values;
  std::vector<std::size_t> arcs;

  explicit Vertices_of_graph(const Graph& graph)
  {
    for (const auto node : CGAL::make_range(vertices(graph))) {
      mesh.add_vertex();
      values.push_back(graph[node].value);
      arcs.push_back(SMRG::null_arc);
    }
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> height(0, 1);
    for (const auto arc : CGAL::make_range(edges(graph))) {
      const double lower = graph[source(arc, graph)].value, upper = graph[target(arc, graph)].value;
      mesh.add_vertex();
      values.push_back(lower + height(generator) * (upper - lower));
      arcs.push_back(graph[arc].id);
      for (const auto node : {source(arc, graph), target(arc, graph)})
        if (arcs[node] == SMRG::null_arc)
          arcs[node] = graph[arc].id;
    }
  }
};

template <bool has_map>
void measure_graph(benchmark::State& state,
                   Graph (*make)(std::size_t),
                   const double threshold_per_node,
                   const double loop_threshold)
{
  const Graph graph = make(std::size_t(state.range(0)));
  const Vertices_of_graph all_vertices(graph);
  measure<has_map>(state,
                   all_vertices.mesh,
                   CGAL::make_property_map(all_vertices.values),
                   graph,
                   all_vertices.arcs,
                   SMRG::parameters::threshold_is_absolute(true)
                       .persistence_threshold(threshold_per_node * double(state.range(0)))
                       .loop_persistence_threshold(loop_threshold));
}

void add_graph(const std::string& name,
               Graph (*make)(std::size_t),
               const double threshold_per_node,
               const double loop_threshold)
{
  const auto add = [&](const char* what, const auto& measure_it) {
    benchmark::RegisterBenchmark(
        (name + what).c_str(), measure_it, make, threshold_per_node, loop_threshold)
        ->RangeMultiplier(10)
        ->Range(10000, 1000000)
        ->Complexity(benchmark::oNLogN)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  add("/graph", measure_graph<false>);
  add("/graph_and_vertices", measure_graph<true>);
}

// The Reeb graph of noise on a mesh; all branches and loops below half of the range go.
template <bool has_map>
void measure_mesh(benchmark::State& state, const Mesh_family& family, const std::size_t m)
{
  const Mesh mesh = make_mesh(family.make(m), family.genus);
  const std::vector<double> values = values_of(PURE_NOISE, mesh);
  const auto scalar_map = CGAL::make_property_map(values);
  std::vector<std::size_t> arcs(mesh.number_of_vertices());
  Graph graph;
  SMRG::compute_Reeb_graph(
      mesh, scalar_map, graph, SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)));
  measure<has_map>(state,
                   mesh,
                   scalar_map,
                   graph,
                   arcs,
                   SMRG::parameters::persistence_threshold(0.5).loop_persistence_threshold(0.5));
}

void add_meshes()
{
  for (const Mesh_family& family : mesh_families) {
    for (const std::size_t number_of_triangles : {40000, 400000, 4000000}) {
      const std::size_t m = family.size_for(double(number_of_triangles));
      const std::string name = "noise_on_" + std::string(family.name) + '/' +
                               std::to_string(family.number_of_triangles(m)) + '/';
      const auto add = [&](const char* what, const auto& measure_it) {
        benchmark::RegisterBenchmark((name + what).c_str(), measure_it, family, m)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
      };
      add("graph", measure_mesh<false>);
      add("graph_and_vertices", measure_mesh<true>);
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  const std::string loop_table = "--loop_table=";
  if (argc == 2 && std::string(argv[1]).compare(0, loop_table.size(), loop_table) == 0) {
    std::ofstream out(argv[1] + loop_table.size());
    write_loop_table(out);
    if (!out) {
      std::cerr << "cannot write " << argv[1] + loop_table.size() << '\n';
      return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  }
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return EXIT_FAILURE;
  const double infinity = std::numeric_limits<double>::infinity();
  add_graph("branches_handed_on", branches_handed_on, 2, 0);
  add_graph("long_cycles", long_cycles, 0, infinity);
  add_graph("alternating_cycles", alternating_cycles, 0, infinity);
  add_graph("cycles_with_peaks", cycles_with_peaks, 0, infinity);
  add_graph("nested_cycles", nested_cycles, 0, infinity);
  add_graph("random_cycles", random_cycles, 0, infinity);
  add_meshes();
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
