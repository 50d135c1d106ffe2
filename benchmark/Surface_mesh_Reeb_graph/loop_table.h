// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it buys to close loops with Loop_closing rather than node by node, as a table in Markdown.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_LOOP_TABLE_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_LOOP_TABLE_H

#include "Node_by_node_loop_closing.h"
#include "functions.h"
#include "meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/node_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/persistence/Two_core.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/simplification/Loop_closing.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iomanip>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Reeb_graph_benchmark {

// The arcs that are left, sorted.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>>
arcs_left(const std::vector<SMRG::internal::Arc_ends>& arcs)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const SMRG::internal::Arc_ends& ends : arcs)
    if (ends.lower != ends.upper)
      result.emplace_back(ends.lower, ends.upper);
  std::sort(result.begin(), result.end());
  return result;
}

// Milliseconds count here: other programs must not.
template <class Task>
double processor_seconds_for(const Task& task)
{
  const std::clock_t start = std::clock();
  task();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Writes the rows of a function on a mesh: loops below some fractions of the range are closed in
// both ways, in turns. Throws if the results differ.
inline void write_loop_rows(std::ostream& out,
                            const std::string& name,
                            const Mesh& mesh,
                            const Function function)
{
  using Graph = SMRG::Reeb_graph<Mesh>;
  const std::vector<double> function_values = values_of(function, mesh);
  Graph graph;
  SMRG::compute_Reeb_graph(mesh, CGAL::make_property_map(function_values), graph);
  std::vector<SMRG::internal::Node_bundle<Graph>> nodes;
  std::vector<SMRG::internal::Arc_bundle<Graph>> arcs;
  std::vector<SMRG::internal::Arc_ends> ends;
  SMRG::internal::read_graph(graph, nodes, arcs, ends);
  const std::vector<double> values = SMRG::internal::values_of_nodes(nodes);
  const SMRG::internal::Two_core core(nodes.size(), ends, [](std::uint32_t) { return true; });

  for (const double fraction : {0.01, 0.1, 0.5}) {
    const double threshold = fraction * (values.back() - values.front());
    const auto is_small = [&](const SMRG::internal::Loop_pair& loop) {
      return values[core.node_before(loop.merge)] - values[core.node_before(loop.split)] <
             threshold;
    };
    double least = std::numeric_limits<double>::infinity(), least_node_by_node = least;
    std::size_t number_of_arcs_left = 0, number_of_steps = 0;
    for (int i = 0; i < 3; ++i) {
      SMRG::internal::Loop_closing closing(core.number_of_nodes(), core.arcs());
      least = (std::min)(least, processor_seconds_for([&]() { closing.run(is_small); }));
      Node_by_node_loop_closing node_by_node(core.number_of_nodes(), core.arcs());
      least_node_by_node = (std::min)(least_node_by_node,
                                      processor_seconds_for([&]() { node_by_node.run(is_small); }));
      number_of_steps = node_by_node.number_of_steps();
      number_of_arcs_left = arcs_left(closing.arcs()).size();
      if (arcs_left(closing.arcs()) != arcs_left(node_by_node.arcs()))
        throw std::logic_error("two ways to close loops give different graphs");
    }
    out << "| " << name << " | " << mesh.number_of_faces() << " | " << function_names[function]
        << " | " << fraction << " | " << core.number_of_nodes() << " | "
        << core.arcs().size() - number_of_arcs_left << " | " << number_of_steps << std::fixed
        << std::setprecision(1) << " | " << least * 1e3 << " | " << least_node_by_node * 1e3
        << " | " << std::setprecision(2) << least_node_by_node / least << " |\n"
        << std::defaultfloat << std::flush;
  }
}

inline void write_loop_table(std::ostream& out)
{
  out << "| surface | triangles | function | loops below (of the range) | nodes on cycles "
         "| loops closed | nodes passed one by one | Loop_closing [ms] | node by node [ms] "
         "| node by node / Loop_closing |\n"
         "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|\n";
  constexpr std::size_t number_of_holes = 100;
  const Mesh scaffold_mesh = make_mesh(scaffold(10), scaffold_genus);
  const Mesh plate_mesh =
      make_mesh(perforated_plate(number_of_holes, 2), number_of_holes * number_of_holes);
  for (const Function function : {SMOOTH, FINE_NOISE, PURE_NOISE})
    write_loop_rows(
        out, "scaffold, genus " + std::to_string(scaffold_genus), scaffold_mesh, function);
  for (const Function function : {SMOOTH, FINE_NOISE, PURE_NOISE})
    write_loop_rows(out, "perforated plate, genus 10000", plate_mesh, function);
}

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_LOOP_TABLE_H
