// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a run as tables in Markdown, which the manual includes.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_TABLE_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_TABLE_H

#include "functions.h"

#include <CGAL/version_macros.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace Reeb_graph_benchmark {

constexpr double not_measured = std::numeric_limits<double>::infinity();

// PARALLEL is the automatic choice with all processors, where there is TBB. What follows is the
// automatic choice with more output than the graph.
enum Algorithm {
  AUTOMATIC,
  CUTTING,
  SWEEP,
  PARALLEL,
  VERTEX_MAP,
  ARC_VERTICES,
  FACE_MAP,
  PARALLEL_VERTEX_MAP,
  NUMBER_OF_ALGORITHMS
};

inline const std::array<const char*, NUMBER_OF_ALGORITHMS> algorithm_names = {
    "automatic",
    "cutting",
    "sweep",
    "parallel",
    "vertex_arc_map",
    "arc_vertices",
    "face_arc_map",
    "parallel_vertex_arc_map"};

struct Result
{
  double seconds = not_measured; // the least of all repetitions, as everywhere here
  double working_bytes = 0;      // at the peak, beyond the output
  double output_bytes = 0;
};

// Everything about one function on one mesh.
struct Row
{
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t nodes = 0;
  double floor_seconds = not_measured;
  std::array<Result, NUMBER_OF_ALGORITHMS> results; // by algorithm
  double vtk_seconds = not_measured;

  double ratio_to_floor(const Algorithm algorithm) const
  {
    return results[algorithm].seconds / floor_seconds;
  }
};

// Position in `mesh_families`, number of triangles asked for, function.
using Row_key = std::tuple<std::size_t, std::size_t, Function>;
using Results = std::map<Row_key, Row>;

inline std::string in_figures(const double number, const int decimals)
{
  if (number == not_measured)
    return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << number;
  return out.str();
}

inline void write_times(std::ostream& out, const Results& results)
{
  out << "| mesh | triangles | function | critical vertices | floor [ms] "
         "| automatic [ms] | x floor | cutting [ms] | x floor | sweep [ms] | x floor "
         "| automatic, parallel [ms] "
         "| working bytes per vertex | output bytes per vertex | VTK / automatic |\n"
         "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const auto& [key, row] : results) {
    out << "| " << mesh_families[std::get<0>(key)].name << " | " << row.triangles << " | "
        << function_names[std::get<2>(key)] << " | " << row.nodes << " | "
        << in_figures(1e3 * row.floor_seconds, 2);
    for (const Algorithm algorithm : {AUTOMATIC, CUTTING, SWEEP}) {
      const double seconds = row.results[algorithm].seconds;
      out << " | " << in_figures(1e3 * seconds, 2) << " | "
          << (seconds == not_measured ? "-" : in_figures(row.ratio_to_floor(algorithm), 1));
    }
    out << " | " << in_figures(1e3 * row.results[PARALLEL].seconds, 2);
    const Result& automatic = row.results[AUTOMATIC];
    const bool has_automatic = automatic.seconds != not_measured;
    const double n = double(row.vertices);
    out << " | " << (has_automatic ? in_figures(automatic.working_bytes / n, 1) : "-") << " | "
        << (has_automatic ? in_figures(automatic.output_bytes / n, 1) : "-") << " | "
        << (has_automatic ? in_figures(row.vtk_seconds / automatic.seconds, 0) : "-") << " |\n";
  }
}

// What the relation of graph and mesh costs beside the graph.
inline void write_augmented(std::ostream& out, const Results& results)
{
  out << "| mesh | triangles | function | floor [ms] | graph, x floor | vertex map [ms] | x floor "
         "| vertices of arcs [ms] | x floor | face map [ms] | x floor | vertex map, parallel [ms] "
         "| working bytes per vertex, vertex map |\n"
         "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const auto& [key, row] : results) {
    if (row.results[VERTEX_MAP].seconds == not_measured)
      continue;
    const auto ratio = [&row = row](Algorithm algorithm) {
      return in_figures(row.results[algorithm].seconds == not_measured
                            ? not_measured
                            : row.ratio_to_floor(algorithm),
                        1);
    };
    out << "| " << mesh_families[std::get<0>(key)].name << " | " << row.triangles << " | "
        << function_names[std::get<2>(key)] << " | " << in_figures(1e3 * row.floor_seconds, 2)
        << " | " << ratio(AUTOMATIC);
    for (const Algorithm algorithm : {VERTEX_MAP, ARC_VERTICES, FACE_MAP})
      out << " | " << in_figures(1e3 * row.results[algorithm].seconds, 2) << " | "
          << ratio(algorithm);
    out << " | " << in_figures(1e3 * row.results[PARALLEL_VERTEX_MAP].seconds, 2) << " | "
        << in_figures(row.results[VERTEX_MAP].working_bytes / double(row.vertices), 1) << " |\n";
  }
}

// Nanoseconds per vertex from the smallest mesh to the largest: what is linear stays the same.
inline void write_scaling(std::ostream& out, const Results& results)
{
  std::set<std::size_t> sizes;
  std::set<std::tuple<std::size_t, Function, Algorithm>> lines;
  for (const auto& [key, row] : results) {
    for (const Algorithm algorithm : {AUTOMATIC, CUTTING, SWEEP}) {
      if (row.results[algorithm].seconds == not_measured)
        continue;
      sizes.insert(std::get<1>(key));
      lines.emplace(std::get<0>(key), std::get<2>(key), algorithm);
    }
  }

  out << "| mesh | function | algorithm |";
  for (const std::size_t size : sizes)
    out << ' ' << size / 2000 << " k |";
  out << "\n|---|---|---|";
  for (std::size_t i = 0; i < sizes.size(); ++i)
    out << "--:|";
  out << '\n';
  for (const auto& [family, function, algorithm] : lines) {
    out << "| " << mesh_families[family].name << " | " << function_names[function] << " | "
        << algorithm_names[algorithm] << " |";
    for (const std::size_t size : sizes) {
      const auto found = results.find({family, size, function});
      out << ' '
          << (found == results.end() ? "-"
                                     : in_figures(1e9 * found->second.results[algorithm].seconds /
                                                      double(found->second.vertices),
                                                  0))
          << " |";
    }
    out << '\n';
  }
}

// The worst of the rows that a target is about, beside the target.
inline void write_targets(std::ostream& out, const Results& results)
{
  const auto worst = [&results](std::size_t family, const auto& is_meant, const auto& measure) {
    double result = -not_measured;
    for (const auto& [key, row] : results)
      if (std::get<0>(key) == family && row.results[AUTOMATIC].seconds != not_measured &&
          is_meant(std::get<2>(key), row))
        result = (std::max)(result, measure(row));
    return result;
  };
  const auto is_large = [](const Row& row) { return row.vertices >= 1000000; };
  std::set<std::size_t> families; // that have been measured at this size
  for (const auto& [key, row] : results)
    if (is_large(row))
      families.insert(std::get<0>(key));
  const auto line = [&](const char* what, const char* target, const auto& measured) {
    out << "| " << what << " | " << target << " |";
    for (const std::size_t family : families) {
      const double number = measured(family);
      out << ' ' << (std::abs(number) == not_measured ? "-" : in_figures(number, 1)) << " |";
    }
    out << '\n';
  };
  const auto ratio_to_floor = [&](const Function wanted) {
    return [&, wanted](std::size_t family) {
      return worst(
          family,
          [&](Function function, const Row& row) { return function == wanted && is_large(row); },
          [](const Row& row) { return row.ratio_to_floor(AUTOMATIC); });
    };
  };

  out << "| automatic choice, the worst | target |";
  for (const std::size_t family : families)
    out << ' ' << mesh_families[family].name << " |";
  out << "\n|---|--:|";
  for (std::size_t i = 0; i < families.size(); ++i)
    out << "--:|";
  out << '\n';
  line("smooth, from 1 million vertices on, x floor", "at most 3", ratio_to_floor(SMOOTH));
  line("fine noise, from 1 million vertices on, x floor", "at most 10", ratio_to_floor(FINE_NOISE));
  line("pure noise, from 1 million vertices on, x floor", "at most 80", ratio_to_floor(PURE_NOISE));
  line(
      "working bytes per vertex, from 1 million vertices on", "below 100", [&](std::size_t family) {
        return worst(
            family,
            [&](Function, const Row& row) { return is_large(row); },
            [](const Row& row) {
              return row.results[AUTOMATIC].working_bytes / double(row.vertices);
            });
      });
  // the least ratio is the worst one
  line("vtkReebGraph / automatic, smooth, 162 thousand triangles",
       "at least 1000",
       [&](std::size_t family) {
         return -worst(
             family,
             [](Function function, const Row& row) {
               return function == SMOOTH && row.vtk_seconds != not_measured &&
                      row.triangles > 150000 && row.triangles < 175000;
             },
             [](const Row& row) { return -row.vtk_seconds / row.results[AUTOMATIC].seconds; });
       });
}

inline void write_tables(std::ostream& out, const Results& results)
{
  out << "One thread but where it says parallel, `Surface_mesh`, CGAL " << CGAL_VERSION_STR
      << ", compiler " << __VERSION__
      << ". The floor is one pass over the faces that reads the three values of each and counts "
         "its "
         "middle vertex.\n\n";
  write_times(out, results);
  out << "\nWith the arc of every vertex, the vertices of every arc in increasing order, and the "
         "arc of "
         "every face:\n\n";
  write_augmented(out, results);
  out << "\nNanoseconds per vertex, by the number of vertices:\n\n";
  write_scaling(out, results);
  out << '\n';
  write_targets(out, results);
  out << "\nSeconds that Recon (Doraiswamy and Natarajan, 2013) and the Topology ToolKit (Gueunet "
         "et al., "
         "2019) took, measured before, on another machine of this kind:\n\n"
         "| mesh, triangles, function | Recon | TTK (FTR) |\n"
         "|---|--:|--:|\n"
         "| sphere, 2.6 million, smooth | 2.6 | 8.5 |\n"
         "| sphere, 2.6 million, fine noise (26 thousand critical vertices) | 2.8 | 12.1 |\n"
         "| sphere, 2.6 million, pure noise | about 7 | - |\n"
         "| gyroid of genus 245, 1.3 million, fine noise (63 thousand critical vertices) | 1.9 | "
         "17.9 |\n"
         "| gyroid of genus 245, 1.3 million, pure noise | 13 | - |\n";
}

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_TABLE_H
