// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far Reeb graphs stay the same in other poses, and when a mesh is changed.
//
//   benchmark_robustness [--csv FILE] [--every N] FOLDER [FAMILY]...
//
// Every subfolder of FOLDER, or every FAMILY among them, holds the meshes of a family. The tables go
// to the standard output. Every N-th shape is changed, too; 0 for none.

#include "robustness/tables.h"

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace Robustness;

struct Options
{
  std::string csv, folder;
  std::size_t every = 1;
  std::set<std::string> families;
};

Options parse(const int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--csv" && i + 1 < argc)
      options.csv = argv[++i];
    else if (word == "--every" && i + 1 < argc)
      options.every = std::stoul(argv[++i]);
    else if (word.rfind("--", 0) == 0)
      throw std::runtime_error("there is no option " + word);
    else if (options.folder.empty())
      options.folder = word;
    else
      options.families.insert(word);
  }
  if (options.folder.empty())
    throw std::runtime_error(
        "usage: benchmark_robustness [--csv FILE] [--every N] FOLDER [FAMILY]...");
  return options;
}

Analyses analyze_all(const Mesh& mesh)
{
  const Basis basis(mesh);
  Analyses result;
  for (const Scalar_function& function : scalar_functions)
    result.push_back(analyze(mesh, function.compute(mesh, basis)));
  return result;
}

// Maxima of two models and of both together, at the finest threshold.
void write_combinations(std::ostream& out, const std::vector<Analyzed_shape>& shapes)
{
  std::vector<Mean> separate(scalar_functions.size()), together = separate, loops = separate;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    if (shapes[i].shape.family == shapes[i - 1].shape.family)
      continue;
    const Analyses analyses = analyze_all(combined(shapes[i - 1].shape.mesh, shapes[i].shape.mesh));
    for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
      const Level &a = shapes[i - 1].analyses[f].levels[0], &b = shapes[i].analyses[f].levels[0],
                  &both = analyses[f].levels[0];
      separate[f].add(double(a.maxima.size() + b.maxima.size()));
      together[f].add(double(both.maxima.size()));
      loops[f].add(a.loops + b.loops == both.loops);
    }
  }
  out << "\n**Two models combined.** The last shape of each family and the first one of the next, "
         "joined by a tube, threshold "
      << threshold_names[0] << ".\n";
  write_header(out, header("mean"));
  const auto write =
      [&](const std::string& name, const std::vector<Mean>& means, const bool is_share) {
        std::vector<std::string> row = {name};
        for (const Mean& mean : means)
          row.push_back(is_share || mean.is_empty() ? percent(mean) : fixed(mean.value(), 1));
        write_row(out, row);
      };
  write("maxima of the two models", separate, false);
  write("maxima of both together", together, false);
  write("as many loops as both", loops, true);
}

void run(const Options& options)
{
  std::vector<Analyzed_shape> shapes;
  std::ofstream csv;
  if (!options.csv.empty())
    csv.open(options.csv);
  write_csv_header(csv);
  const auto report = [](const Shape& shape, const std::string& change, const std::exception& e) {
    std::cerr << shape.family << '/' << shape.name << ' ' << change << ": " << e.what() << '\n';
  };
  for (Shape& shape : read_shapes(options.folder, options.families)) {
    try {
      Analyses analyses = analyze_all(shape.mesh);
      write_csv_rows(csv, shape, "", analyses);
      shapes.push_back({std::move(shape), std::move(analyses)});
    } catch (const SMRG::Error& e) {
      report(shape, "", e);
    }
  }
  if (shapes.empty())
    throw std::runtime_error(options.folder + " has no families of meshes");
  std::cout << "CGAL " CGAL_STR(CGAL_VERSION) ".\n";
  write_family_tables(std::cout, shapes);

  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; options.every != 0 && i < shapes.size(); i += options.every) {
    std::cerr << "changing " << shapes[i].shape.name << '\n';
    for (std::size_t c = 0; c < changes().size(); ++c) {
      const Change& change = changes()[c];
      try {
        std::mt19937 rng(static_cast<unsigned>(i));
        const Mesh mesh = change.make(shapes[i].shape.mesh, rng);
        const Analyses analyses = analyze_all(mesh);
        write_csv_rows(csv, shapes[i].shape, change.name, analyses);
        comparisons.push_back(compare(shapes[i], mesh, analyses, change));
        comparisons.back().shape = i;
        comparisons.back().change = c;
      } catch (const std::exception& e) { // also of the programs that make the change
        report(shapes[i].shape, change.name, e);
      }
    }
  }
  if (!comparisons.empty()) {
    write_change_tables(std::cout, comparisons);
    write_combinations(std::cout, shapes);
  }
  if (!csv.good() && !options.csv.empty())
    throw std::runtime_error(options.csv + " could not be written");
}

} // namespace

int main(int argc, char* argv[])
{
  try {
    run(parse(argc, argv));
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
