// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of benchmark_eigenbasis as tables in Markdown, which the manual includes.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_EIGENBASIS_TABLE_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_EIGENBASIS_TABLE_H

#include <CGAL/version_macros.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <tuple>

namespace Reeb_graph_benchmark {

constexpr double not_measured = std::numeric_limits<double>::infinity();

enum Solver { OURS, OURS_CHOLMOD, SPECTRA_LDLT, SPECTRA_CHOLMOD, ARPACK_CHOLMOD };

inline const std::array<const char*, 5> solver_names = {
    "ours", "ours_cholmod", "spectra_ldlt", "spectra_cholmod", "arpack_cholmod"};
inline const std::array<const char*, 5> solver_titles = {"ours, default",
                                                         "ours + CHOLMOD",
                                                         "Spectra + SimplicialLDLT",
                                                         "Spectra + CHOLMOD",
                                                         "ARPACK + CHOLMOD"};

// The fastest run of all repetitions.
struct Result
{
  double seconds = not_measured; // for everything
  double factorization_seconds = 0;
  double solution_seconds = 0;
  std::size_t right_hand_sides = 0;
  double residual = 0;
  double bytes = 0; // at the peak, with the output

  bool is_measured() const { return seconds != not_measured; }

  // What no solver with shift and invert can do without: one factorization and a solution for every
  // pair.
  double floor_seconds(const std::size_t number_of_eigenpairs) const
  {
    return factorization_seconds +
           solution_seconds * double(number_of_eigenpairs) / double(right_hand_sides);
  }
};

// A surface that is made for the purpose, with about so many vertices, or a file.
struct Mesh_key
{
  std::size_t size = 0; // the number of vertices
  std::string file;

  std::string name() const
  {
    if (file.empty())
      return "irregular";
    const std::size_t begin = file.find_last_of('/') + 1; // 0 if there is none
    return file.substr(begin, file.find_last_of('.') - begin);
  }

  friend bool operator<(const Mesh_key& a, const Mesh_key& b)
  {
    return std::tie(a.size, a.file) < std::tie(b.size, b.file);
  }
  friend bool operator!=(const Mesh_key& a, const Mesh_key& b) { return a < b || b < a; }
};

// Everything about one mesh.
struct Row
{
  std::size_t vertices = 0;
  double assembly_seconds = not_measured;
  std::array<Result, solver_names.size()> results; // by solver

  double ratio_to_ours(const Solver solver) const
  {
    return results[solver].seconds / results[OURS].seconds;
  }
  bool has_ratio(const Solver solver) const
  {
    return results[solver].is_measured() && results[OURS].is_measured();
  }
};

using Results = std::map<Mesh_key, Row>;

inline std::string in_figures(const double number, const int decimals)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << number;
  return out.str();
}

inline void write_times(std::ostream& out, const Results& results, std::size_t number_of_eigenpairs)
{
  out << "| mesh | vertices | solver | assembly [s] | factorization [s] | right-hand sides | "
         "solving [s] "
         "| rest [s] | total [s] | x ours | x floor | residual | kB per vertex |\n"
         "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const auto& [key, row] : results) {
    for (std::size_t solver = 0; solver < row.results.size(); ++solver) {
      const Result& result = row.results[solver];
      if (!result.is_measured())
        continue;
      const double rest = result.seconds - row.assembly_seconds - result.factorization_seconds -
                          result.solution_seconds;
      std::ostringstream residual;
      residual << std::scientific << std::setprecision(0) << result.residual;
      out << "| " << key.name() << " | " << row.vertices << " | " << solver_titles[solver] << " | "
          << in_figures(row.assembly_seconds, 2) << " | "
          << in_figures(result.factorization_seconds, 2) << " | " << result.right_hand_sides
          << " | " << in_figures(result.solution_seconds, 2) << " | " << in_figures(rest, 2)
          << " | " << in_figures(result.seconds, 2) << " | "
          << (row.has_ratio(Solver(solver)) ? in_figures(row.ratio_to_ours(Solver(solver)), 2)
                                            : "-")
          << " | " << in_figures(result.seconds / result.floor_seconds(number_of_eigenpairs), 2)
          << " | " << residual.str() << " | "
          << in_figures(result.bytes / 1e3 / double(row.vertices), 2) << " |\n";
    }
  }
}

// The worst of the rows that a target is about, beside the target.
inline void write_targets(std::ostream& out, const Results& results)
{
  const auto line = [&out](const char* what, const char* target, const double measured) {
    out << "| " << what << " | " << target << " | "
        << (measured == not_measured ? "-" : in_figures(measured, 2)) << " |\n";
  };
  const auto least_ratio = [&results](const Solver solver, const std::size_t smallest_size) {
    double least = not_measured;
    for (const auto& [key, row] : results)
      if (key.size >= smallest_size && row.has_ratio(solver))
        least = (std::min)(least, row.ratio_to_ours(solver));
    return least;
  };
  double bytes = 0;
  for (const auto& [key, row] : results)
    bytes = (std::max)(bytes, row.results[OURS].bytes / double(row.vertices));

  out << "| default, the worst | target | measured |\n|---|--:|--:|\n";
  line("ARPACK + CHOLMOD / ours, from 160 thousand vertices on",
       "at least 3",
       least_ratio(ARPACK_CHOLMOD, 160000));
  line("Spectra + SimplicialLDLT / ours, from 160 thousand vertices on",
       "at least 6",
       least_ratio(SPECTRA_LDLT, 160000));
  line("any other program / ours",
       "at least 1",
       (std::min)({least_ratio(SPECTRA_LDLT, 0),
                   least_ratio(SPECTRA_CHOLMOD, 0),
                   least_ratio(ARPACK_CHOLMOD, 0)}));
  line("kB per vertex", "below 2.5", bytes == 0 ? not_measured : bytes / 1e3);
}

inline void
write_tables(std::ostream& out, const Results& results, const std::size_t number_of_eigenpairs)
{
  out << "Seconds of processor time, one thread, " << number_of_eigenpairs << " eigenpairs, CGAL "
      << CGAL_VERSION_STR << ", compiler " << __VERSION__ << ". The floor is one factorization and "
      << number_of_eigenpairs
      << " right-hand sides, at what they take in the same row; the rest is orthogonalization and "
         "the "
         "certificates.\n\n";
  write_times(out, results, number_of_eigenpairs);
  out << '\n';
  write_targets(out, results);
}

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_EIGENBASIS_TABLE_H
