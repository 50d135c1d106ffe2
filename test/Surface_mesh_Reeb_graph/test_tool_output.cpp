// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command-line tool writes, under a global locale that groups digits.

#define BOOST_TEST_MODULE test_tool_output

#include "Grouping_locale.h"
#include "Index_mesh.h"
#include "random_meshes.h"
#include "tool_runs.h"

// after random_meshes.h: Boost's disjoint sets do not compile after its readers of graphs
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/output.h"
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/progress.h"
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/report.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// The contents of all files that the tool writes, by the ends of their names.
std::map<std::string, std::string> written_files(Result& result)
{
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("reeb_graph_output_" + std::to_string(std::random_device()()));
  std::filesystem::create_directory(folder);
  write_results(result, (folder / "x").string());
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios_base::binary);
    contents[entry.path().filename().string().substr(1)] =
        std::string(std::istreambuf_iterator<char>(in), {});
  }
  std::filesystem::remove_all(folder);
  return contents;
}

} // namespace

BOOST_AUTO_TEST_CASE(global_locale_that_groups_digits)
{
  Result result;
  std::vector<vertex_descriptor> vertices;
  make_mesh(torus(100, 50), result.mesh, vertices);
  result.values = result.mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  result.arcs = result.mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;
  std::mt19937 rng(20);
  for (vertex_descriptor v : vertices)
    result.values[v] = 1e4 * random_unit(rng);
  SMRG::compute_Reeb_graph(
      result.mesh,
      result.values,
      result.graph,
      SMRG::parameters::vertex_arc_map(result.arcs).collect_arc_vertices(true));
  result.number_of_components = 1;
  result.feature_points = {vertices[1279]};
  result.eigenvalues = {{1279.5}};
  result.seconds.read = 1279.5;
  BOOST_REQUIRE_GT(num_vertices(result.graph), 1000u);

  const auto report = [&]() {
    std::ostringstream json, text;
    print_json(json, result);
    print_text(text, Options(), result);
    return std::make_pair(json.str(), text.str());
  };
  const std::map<std::string, std::string> expected_files = written_files(result);
  const auto expected_report = report();
  BOOST_TEST(expected_files.size() == 6u);
  BOOST_TEST(expected_report.first.find("1279.5") != std::string::npos);
  BOOST_TEST(expected_report.second.find("1279.5") != std::string::npos);

  const Grouping_locale grouping;
  const std::map<std::string, std::string> files = written_files(result);
  BOOST_TEST(files.size() == expected_files.size());
  for (const auto& file : expected_files)
    BOOST_TEST((files.at(file.first) == file.second), file.first << " depends on the locale");
  BOOST_TEST(report().first == expected_report.first);
  BOOST_TEST(report().second == expected_report.second);
}

BOOST_AUTO_TEST_CASE(report_has_a_version)
{
  std::ostringstream out;
  print_json(out, Result());
  BOOST_TEST(nlohmann::json::parse(out.str()).at("version") == 1);
}

BOOST_AUTO_TEST_CASE(time_that_is_left)
{
  BOOST_TEST(time_left(10, 0.5) == ", 10 s left");
  BOOST_TEST(time_left(10, 0.25) == ", 30 s left");
  BOOST_TEST(time_left(60, 0.25) == ", 3 min left");
  BOOST_TEST(time_left(3600, 0.25) == ", 3 h left");
  BOOST_TEST(time_left(10, 1) == ", 0 s left");
  BOOST_TEST(time_left(10, 0) == "");     // nothing is known
  BOOST_TEST(time_left(0.1, 0.01) == ""); // nor yet
  BOOST_TEST(time_left(10, 1e-300) == "");
}

// Curves through barycenters take the place of a skeleton, and the report says so.
BOOST_AUTO_TEST_CASE(noise_has_no_skeleton)
{
  const Folder folder;
  const Index_mesh sphere_mesh = sphere(5);
  std::mt19937 rng(1);
  std::ostringstream values;
  for (std::size_t i = 0; i < sphere_mesh.points.size(); ++i)
    values << random_unit(rng) << '\n';
  const std::string prefix = folder.file("noise");
  const std::string arguments = "'" + folder.write("sphere.off", sphere_mesh) + "' --values '" +
                                folder.write("values.txt", values.str()) + "' --output '" + prefix +
                                "'";
  const Run noise = run(folder, arguments);
  BOOST_TEST(noise.status == 0);
  BOOST_TEST(noise.out.find("there is no skeleton") != std::string::npos);
  BOOST_TEST(count(content(prefix + ".polylines.txt"), "\n") > 1000u);
  BOOST_TEST(!std::filesystem::exists(prefix + ".swc"));
  const Run simple = run(folder, arguments + " --simplify 0.9");
  BOOST_TEST(simple.out.find("there is no skeleton") == std::string::npos);
  BOOST_TEST(std::filesystem::exists(prefix + ".swc"));
}
