// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the command-line tool REEB_GRAPH_TOOL as a user would.

#define BOOST_TEST_MODULE reeb_graph_tool

#include "Index_mesh.h"
#include "random_meshes.h"
#include "tool_runs.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Mesh = Tool_mesh;
namespace fs = std::filesystem;

} // namespace

BOOST_AUTO_TEST_CASE(json_report_has_exactly_the_documented_keys)
{
  const Folder folder;
  const std::string mesh = folder.write("torus.off", torus(24, 12));
  const nlohmann::json j = report(folder, "'" + mesh + "'");

  std::vector<std::string> keys, seconds;
  for (const auto& item : j.items())
    keys.push_back(item.key());
  std::vector<std::string> expected = {"version",
                                       "vertices",
                                       "faces",
                                       "components",
                                       "nodes",
                                       "arcs",
                                       "loops",
                                       "minima",
                                       "maxima",
                                       "splits",
                                       "merges",
                                       "degenerate",
                                       "feature_points",
                                       "seconds",
                                       "eigenvalues",
                                       "failures",
                                       "repairs"};
  std::sort(expected.begin(), expected.end());
  BOOST_TEST(keys == expected, boost::test_tools::per_element());
  for (const auto& item : j["seconds"].items())
    seconds.push_back(item.key());
  expected = {"eigenbasis", "function", "read", "reeb_graph", "simplify", "skeleton", "write"};
  BOOST_TEST(seconds == expected, boost::test_tools::per_element());

  BOOST_TEST(j["vertices"] == 288);
  BOOST_TEST(j["faces"] == 576);
  BOOST_TEST(j["components"] == 1);
  BOOST_TEST(j["loops"] == 1);
  BOOST_TEST(j["nodes"].get<int>() == j["minima"].get<int>() + j["maxima"].get<int>() +
                                          j["splits"].get<int>() + j["merges"].get<int>() +
                                          j["degenerate"].get<int>());
  BOOST_TEST(j["eigenvalues"].size() == 1u);
  BOOST_TEST(j["eigenvalues"][0].size() >= 50u);
  BOOST_TEST(j["eigenvalues"][0][0].get<double>() > 0);
  BOOST_TEST(j["feature_points"].size() >= 1u);
  for (const auto& v : j["feature_points"])
    BOOST_TEST(v.get<std::size_t>() < 288u);
  BOOST_TEST(j["seconds"]["eigenbasis"].is_number());
}

// Without npm the tool has no page, and says how to get it.
BOOST_AUTO_TEST_CASE(page)
{
  const Folder folder;
  const std::string mesh = "'" + folder.write("mesh.off", sphere(1)) + "' --function height ";
  const std::string html = " --html '" + folder.file("x.html") + "'";
  const Run output = run(folder, mesh + "--output '" + folder.file("y") + "'");
  BOOST_TEST(output.status == 0);
  const bool has_page = std::filesystem::exists(folder.file("y.html"));
  BOOST_TEST(has_page == (output.out.find("y.html is not written") == std::string::npos));
  if (!has_page) {
    check_usage_error(folder, mesh + html, {"--html", "npm"});
    return;
  }
  report(folder, mesh + html);
  BOOST_TEST(content(folder.file("x.html")).rfind("<!DOCTYPE html>", 0) == 0u);
  check_error(folder, mesh + "--html '" + folder.file("no/such/z.html") + "'", {"z.html"});
}

BOOST_AUTO_TEST_CASE(reads_all_formats)
{
  const Folder folder;
  const Index_mesh mesh = torus(20, 10);
  for (const std::string type : {"off", "obj", "ply", "stl"}) {
    const std::string file = folder.write("torus." + type, mesh);
    const nlohmann::json j = report(folder, "'" + file + "' --function height --axis 1,0.3,0.1");
    BOOST_TEST(j["vertices"] == 200);
    BOOST_TEST(j["nodes"] == 4);
    BOOST_TEST(j["arcs"] == 4);
    BOOST_TEST(j["loops"] == 1);
    BOOST_TEST(j["eigenvalues"].size() == 0u);
    BOOST_TEST(j["feature_points"].size() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(writes_all_files)
{
  const Folder folder;
  Index_mesh input = torus(24, 12);
  input.points.push_back({9, 9, 9}); // an isolated vertex
  const std::string mesh = folder.write("torus.off", input);
  const std::string prefix = folder.file("result");
  const nlohmann::json j =
      report(folder, "'" + mesh + "' --function height --axis 1,0.3,0.1 --output '" + prefix + "'");
  const std::size_t nodes = j["nodes"], arcs = j["arcs"];
  BOOST_TEST(nodes == 5u);
  BOOST_TEST(j["components"] == 2);
  BOOST_TEST(j["degenerate"] == 1); // the isolated one

  const std::vector<double> values = numbers(prefix + ".values.txt");
  BOOST_REQUIRE(values.size() == 289u);
  const double length = std::sqrt(1 + 0.09 + 0.01);
  for (std::size_t v = 0; v < 289; ++v) {
    const auto& p = input.points[v];
    BOOST_TEST(values[v] == (p[0] + 0.3 * p[1] + 0.1 * p[2]) / length,
               boost::test_tools::tolerance(1e-12));
  }

  const std::string graphml = content(prefix + ".graphml");
  BOOST_TEST(count(graphml, "<node ") == nodes);
  BOOST_TEST(count(graphml, "<edge ") == arcs);
  for (const std::string name :
       {"id", "mesh_vertex", "value", "type", "x", "y", "z", "number_of_vertices"})
    BOOST_TEST(count(graphml, "attr.name=\"" + name + "\"") >= 1u);
  BOOST_TEST(count(graphml, ">minimum<") == 1u);

  const std::string dot = content(prefix + ".dot");
  BOOST_TEST(count(dot, "--") == arcs);
  BOOST_TEST(count(dot, "mesh_vertex=") == nodes);

  // a line per arc, from node to node
  std::istringstream polylines(content(prefix + ".polylines.txt"));
  std::size_t lines = 0;
  for (std::string line; std::getline(polylines, line); ++lines) {
    std::istringstream in(line);
    std::size_t size;
    in >> size;
    const std::vector<double> coordinates{std::istream_iterator<double>(in),
                                          std::istream_iterator<double>()};
    BOOST_TEST(size >= 2u);
    BOOST_TEST(coordinates.size() == 3 * size);
  }
  BOOST_TEST(lines == arcs);
  BOOST_TEST(!std::filesystem::exists(prefix + ".swc")); // it has a loop

  Mesh ply;
  std::ifstream in(prefix + ".ply", std::ios::binary);
  BOOST_REQUIRE(CGAL::IO::read_PLY(in, ply));
  BOOST_TEST(ply.number_of_vertices() == 289u);
  BOOST_TEST(ply.number_of_faces() == 576u);
  const auto colors = ply.property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  const auto arc_numbers = ply.property_map<Mesh::Vertex_index, int>("v:arc").first;
  std::size_t lowest = 0, highest = 0;
  for (std::size_t v = 0; v < 289; ++v) {
    lowest = values[v] < values[lowest] ? v : lowest;
    highest = values[v] > values[highest] ? v : highest;
    const int arc = arc_numbers[Mesh::Vertex_index(static_cast<unsigned>(v))];
    BOOST_TEST((v == 288 ? arc == -1 : 0 <= arc && arc < static_cast<int>(arcs)));
  }
  BOOST_TEST(
      (colors[Mesh::Vertex_index(static_cast<unsigned>(lowest))] == CGAL::IO::Color(255, 0, 0)));
  BOOST_TEST(
      (colors[Mesh::Vertex_index(static_cast<unsigned>(highest))] == CGAL::IO::Color(0, 0, 255)));

  const std::string vtp = content(prefix + ".vtp");
  BOOST_TEST(count(vtp, "NumberOfPoints=\"289\" NumberOfPolys=\"576\"") == 1u);
  BOOST_TEST(count(vtp, "Name=\"value\"") == 1u);
  BOOST_TEST(count(vtp, "Name=\"arc\"") == 1u);
  BOOST_TEST(count(vtp, "</VTKFile>") == 1u);
}

BOOST_AUTO_TEST_CASE(values_of_the_user_as_text_and_binary)
{
  const Folder folder;
  const Index_mesh mesh = closed_surface(2, 6, 5);
  const std::string file = folder.write("mesh.off", mesh);
  std::mt19937 rng(11);
  const std::vector<double> values = random_values(mesh.points.size(), rng);
  std::ostringstream text;
  text.precision(17);
  std::string binary;
  for (const double value : values) {
    text << value << '\n';
    char bytes[8]; // this machine's doubles are taken to be little-endian
    std::memcpy(bytes, &value, 8);
    binary.append(bytes, 8);
  }
  folder.write("values.txt", text.str());
  folder.write("values.f64", binary);

  nlohmann::json from_text = report(folder,
                                    "'" + file + "' --values '" + folder.file("values.txt") +
                                        "' --output '" + folder.file("a") + "'");
  nlohmann::json from_binary = report(folder,
                                      "'" + file + "' --values '" + folder.file("values.f64") +
                                          "' --output '" + folder.file("b") + "'");
  from_text.erase("seconds");
  from_binary.erase("seconds");
  BOOST_TEST((from_text == from_binary));
  BOOST_TEST(from_text["nodes"].get<int>() > 4);
  BOOST_TEST(content(folder.file("a.values.txt")) == content(folder.file("b.values.txt")));
  BOOST_TEST(numbers(folder.file("a.values.txt")) == values, boost::test_tools::per_element());

  const nlohmann::json simplified =
      report(folder, "'" + file + "' --simplify 2 --values '" + folder.file("values.txt") + "'");
  BOOST_TEST(simplified["minima"] == 1);
  BOOST_TEST(simplified["maxima"] == 1);
  BOOST_TEST(simplified["loops"] == from_text["loops"]);
}

BOOST_AUTO_TEST_CASE(bad_values_are_one_line_of_error)
{
  const Folder folder;
  const std::string mesh = "'" + folder.write("mesh.off", sphere(1)) + "' --values ";
  std::string good;
  for (int i = 0; i < 42; ++i)
    good += std::to_string(i) + ' ';
  const auto check =
      [&](const std::string& name, const std::string& text, const std::vector<std::string>& words) {
        const std::string file = folder.write(name, text);
        std::vector<std::string> all = words;
        all.push_back(file);
        check_error(folder, mesh + "'" + file + "'", all);
      };
  report(folder, mesh + "'" + folder.write("good.txt", good) + "'");
  check("empty.txt", "", {"0 values", "42 vertices"});
  check("short.txt", "1 2 3\n", {"3 values", "42 vertices"});
  check("long.txt", good + "42", {"43 values"});
  check("word.txt", "1 2 three", {"value 2", "three"});
  check("nan.txt", "nan " + good.substr(2), {"vertex 0", "not a number"});
  check("half.f64", std::string(42 * 8 - 3, 'x'), {"incomplete"});
  check("short.f64", std::string(41 * 8, 'x'), {"41 values"});
  check("nan.f64", std::string(42 * 8, '\xff'), {"vertex 0", "not a number"});
  check_error(folder, mesh + "'" + folder.file("none.txt") + "'", {"none.txt", "opened"});
  check_error(folder, mesh + "'" + folder.path.string() + "'", {"opened"});

  // infinite values are values
  const nlohmann::json j =
      report(folder, mesh + "'" + folder.write("inf.txt", "inf -inf " + good.substr(4)) + "'");
  BOOST_TEST(j["loops"] == 0);
}

BOOST_AUTO_TEST_CASE(bad_meshes_are_one_line_of_error)
{
  const Folder folder;
  const auto check =
      [&](const std::string& name, const std::string& text, const std::vector<std::string>& words) {
        std::vector<std::string> all = words;
        all.push_back(folder.write(name, text));
        check_error(folder, "'" + folder.file(name) + "'", all);
      };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  check("empty.off", "", {"empty"});
  check("type.xyz", "OFF\n", {"unknown type"});
  check("garbage.off", "no mesh at all", {"line 1", "'no'"});
  check("truncated.off", "OFF\n4 4 0\n" + points + "3 0 1 2\n", {"ends before face 1 of 4"});
  check("index.off", "OFF\n4 1 0\n" + points + "3 0 1 7\n", {"line 7", "face 0", "'7'"});
  check("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"line 3", "'nan'"});
  check(
      "edge.off",
      "OFF\n5 3 0\n" + points + "0 0 -1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n",
      {"between the vertices 0 and 1", "3 faces (faces 0, 1 and 2)", "--split-nonmanifold-edges"});
  check_error(folder, "'" + folder.file("none.off") + "'", {"none.off", "opened"});
  check_error(folder, "'" + folder.path.string() + "'", {"opened"});
  // a function that needs an area
  check("point.off", "OFF\n3 1 0\n1 2 3\n1 2 3\n1 2 3\n3 0 1 2\n", {"no area"});

  check("moebius.off",
        "OFF\n6 6 0\n" + points + "1 1 0\n1 0 1\n" +
            "3 0 1 2\n3 1 3 2\n3 2 3 4\n3 3 5 4\n3 4 5 1\n3 5 0 1\n",
        {"one side"});
  check("hello.stl", "hello", {"'hello'", "solid"});
  check_usage_error(folder,
                    "'" + folder.write("four.off", sphere(0)) +
                        "' --function eigenfunction --index 100",
                    {"four.off", "no eigenfunction 100"});

  // no errors, but loud: an empty mesh, points only
  std::string findings;
  BOOST_TEST(report(folder,
                    "'" + folder.write("none.off", "OFF\n0 0 0\n") + "'",
                    &findings)["nodes"] == 0);
  BOOST_TEST(findings.find("no vertices") != findings.npos);
  BOOST_TEST(report(folder,
                    "'" + folder.write("points.off", "OFF\n4 0 0\n" + points) + "'",
                    &findings)["components"] == 4);
  BOOST_TEST(findings.find("no faces") != findings.npos);
  const nlohmann::json quad = report(
      folder,
      "'" + folder.write("quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n") + "'");
  BOOST_TEST(quad["faces"] == 2);
}

// Faces that are oriented anyhow, and lines beside the faces. The order of the vertices stays.
BOOST_AUTO_TEST_CASE(meshes_that_need_repair_are_read)
{
  const Folder folder;
  Index_mesh mesh = torus(24, 12);
  std::ostringstream off, obj, values;
  off << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  std::mt19937 rng(1);
  for (const auto& p : mesh.points) {
    off << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    obj << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    values << rng() << '\n';
  }
  obj << "l 1 2 3\n";
  for (const auto& t : mesh.triangles) {
    const std::size_t turn = rng() % 2;
    off << "3 " << t[0] << ' ' << t[1 + turn] << ' ' << t[2 - turn] << '\n';
    obj << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  const std::string options = " --values '" + folder.write("values.txt", values.str()) + "'";
  const nlohmann::json expected =
      report(folder, "'" + folder.write("good.off", mesh) + "'" + options);
  for (const std::string& file :
       {folder.write("turned.off", off.str()), folder.write("line.obj", obj.str())})
  {
    std::string findings;
    const nlohmann::json found = report(folder, "'" + file + "'" + options, &findings);
    BOOST_TEST(count(findings, "turned to agree") == count(file, "turned.off"));
    BOOST_TEST(found["repairs"].size() == count(file, "turned.off"));
    for (const char* key : {"vertices", "faces", "nodes", "arcs", "loops", "minima", "splits"})
      BOOST_TEST(found[key] == expected[key], file << ", " << key);
  }
}

// What is likely to surprise is said.
BOOST_AUTO_TEST_CASE(text_report)
{
  const Folder folder;
  const std::string mesh = folder.write("cracked.off",
                                        "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n0 1 0\n"
                                        "1 1 0\n5 5 5\n3 0 1 2\n3 3 5 4\n");
  const Run r = run(folder, "'" + mesh + "' --function height --axis 1,0.1,0");
  BOOST_TEST(r.status == 0);
  for (const char* text : {"7 vertices, 2 faces, 3 components, 2 borders\n",
                           "at 5 different points",
                           "5 nodes, 2 arcs, 0 loops",
                           "isolated 1, degenerate 0"})
    BOOST_TEST(r.out.find(text) != std::string::npos, r.out << " does not say " << text);
}

BOOST_AUTO_TEST_CASE(bad_options_are_one_line_of_error)
{
  const Folder folder;
  const std::string mesh = "'" + folder.write("mesh.off", sphere(1)) + "' ";
  check_usage_error(folder, "", {"mesh"});
  check_usage_error(folder, mesh + "--no-such-option 3", {"no-such-option"});
  check_usage_error(folder, mesh + "--function shape", {"shape", "commute_time", "height"});
  check_usage_error(folder, mesh + "--function height --axis 1,2", {"--axis", "1,2"});
  check_usage_error(folder, mesh + "--function height --axis 0,0,0", {"--axis", "direction"});
  check_usage_error(
      folder, mesh + "--function height --axis 1.7e308,1.7e308,1.7e308", {"--axis", "direction"});
  check_usage_error(folder, mesh + "--function eigenfunction --index 0", {"--index"});
  check_usage_error(
      folder, mesh + "--function eigenfunction --index 42", {"--index", "eigenfunction 42"});
  // less than the number of vertices, but more than a component has
  Index_mesh two_spheres = sphere(0);
  const std::string index = std::to_string(two_spheres.points.size());
  append(two_spheres, sphere(0), 5);
  check_usage_error(folder,
                    "'" + folder.write("two.off", two_spheres) +
                        "' --function eigenfunction --index " + index,
                    {"--index", "eigenfunction " + index, "component"});
  check_usage_error(folder, mesh + "--index -1", {"--index"});
  check_usage_error(folder, mesh + "--eigenpairs 0", {"--eigenpairs"});
  check_usage_error(folder, mesh + "--eigenpairs -3", {"--eigenpairs"});
  check_usage_error(folder, mesh + "--eigenpairs many", {"eigenpairs", "many"});
  check_usage_error(folder, mesh + "--simplify -0.1", {"--simplify"});
  check_usage_error(folder, mesh + "--simplify nan", {"--simplify"});
  for (const std::string text : {"wide", "0.1x", "gap:", "gap:0", "gap:-1", "gap:two", "gap2"})
    check_usage_error(folder, mesh + "--simplify " + text, {"--simplify", text});
  check_usage_error(folder, mesh + "--close-loops nan", {"--close-loops"});
  check_usage_error(folder, mesh + "--close-loops -1", {"--close-loops"});
  check_usage_error(folder, mesh + "--leaves -1", {"--leaves"});
  check_error(folder, mesh + "--diagram '" + folder.file("no/such/x.pers") + "'", {"x.pers"});
  check_usage_error(folder, mesh + "--small-time nan", {"--small-time"});
  check_usage_error(folder, mesh + "--small-time -1", {"--small-time"});
  check_usage_error(folder, mesh + "--large-time -1", {"--large-time"});
  check_usage_error(folder, mesh + "--large-time inf", {"--large-time"});
  check_usage_error(folder, mesh + "--report xml", {"xml"});
  check_error(
      folder, mesh + "--output '" + folder.file("no/such/folder/x") + "'", {"x.values.txt"});

  // options without effect
  check_usage_error(folder, mesh + "--axis 1,0,0", {"--axis", "commute_time", "height"});
  check_usage_error(
      folder, mesh + "--function height --source 1", {"--source", "height", "geodesic"});
  check_usage_error(
      folder, mesh + "--function geodesic --source 1 --time 2", {"--time", "geodesic"});
  check_usage_error(folder, mesh + "--function barycentre --eigenpairs 5", {"--eigenpairs"});
  check_usage_error(folder, mesh + "--values x.txt --index 2", {"--index", "--values"});
  check_usage_error(folder, mesh + "--values x.txt --function height", {"--function", "--values"});
  check_usage_error(
      folder, mesh + "--features x.txt --small-time 1", {"--small-time", "--features"});
  check_usage_error(
      folder, mesh + "--values x.txt --values-from-property y", {"--values-from-property"});
  check_usage_error(
      folder, mesh + "--values-from-property y", {"--values-from-property", "no effect"});
  check_usage_error(folder, mesh + "--threshold-absolute", {"--threshold-absolute", "--simplify"});
  check_usage_error(
      folder, mesh + "--threshold-absolute --simplify gap", {"--threshold-absolute", "--simplify"});
  check_usage_error(folder,
                    mesh + "--function height --residual-tolerance 1e-6",
                    {"--residual-tolerance", "height"});
  check_usage_error(folder, mesh + "--residual-tolerance 0", {"--residual-tolerance"});
  check_usage_error(folder, mesh + "--weld -1", {"--weld"});
  check_usage_error(folder, mesh + "--weld nan", {"--weld"});
  // lists of vertices
  check_usage_error(folder, mesh + "--function diffusion", {"diffusion", "--source"});
  check_usage_error(folder, mesh + "--function harmonic --minima 1", {"harmonic", "--maxima"});
  check_usage_error(folder, mesh + "--function harmonic --minima 1,2 --maxima 3,2", {"vertex 2"});
  check_usage_error(folder, mesh + "--function geodesic --source 1,,2", {"--source", "''"});
  check_usage_error(folder, mesh + "--function geodesic --source 1,", {"--source", "1,"});
  check_usage_error(folder, mesh + "--function geodesic --source -1", {"--source", "-1"});
  for (const std::string function : {"geodesic", "biharmonic"})
    check_usage_error(folder,
                      mesh + "--function " + function + " --source 0,42",
                      {"mesh.off", "--source", "vertex 42", "42"});
  check_usage_error(folder, mesh + "--function diffusion --source 1 --time -1", {"--time"});
  for (const std::string content : {"", "1 2 x", "42", "-1"}) {
    const std::string features = folder.write("features.txt", content);
    for (const std::string function : {"commute_time", "tierny", "curvature"})
      check_error(folder,
                  mesh + "--function " + function + " --features '" + features + "'",
                  {features, "vert"});
  }
  check_error(folder, mesh + "--features '" + folder.file("none.txt") + "'", {"none.txt"});

  const Run help = run(folder, "--help");
  BOOST_TEST(help.status == 0);
  for (const std::string option : {"--function",
                                   "--axis",
                                   "--index",
                                   "--time",
                                   "--source",
                                   "--minima",
                                   "--maxima",
                                   "--features",
                                   "--values",
                                   "--simplify",
                                   "--close-loops",
                                   "--leaves",
                                   "--unfold",
                                   "--diagram",
                                   "--eigenpairs",
                                   "--small-time",
                                   "--large-time",
                                   "--output",
                                   "--report",
                                   "--threshold-absolute",
                                   "--residual-tolerance",
                                   "--strict",
                                   "--split-nonmanifold-edges",
                                   "--weld",
                                   "--values-from-property"})
    BOOST_TEST(count(help.out, option + " ") == 1u);
}

BOOST_AUTO_TEST_CASE(options_of_the_graph_arrive)
{
  const Folder folder;
  const std::string mesh = "'" + folder.write("mesh.off", torus(30, 14)) + "' ";
  std::mt19937 rng(1);
  std::string noise;
  for (int i = 0; i < 420; ++i)
    noise += std::to_string(random_unit(rng)) + '\n';
  const std::string noisy = mesh + "--values '" + folder.write("noise.txt", noise) + "' ";

  const nlohmann::json graph =
      report(folder, noisy + "--unfold --diagram '" + folder.file("pairs.pers") + "'");
  BOOST_TEST(graph["loops"] == 1);
  // two nodes make a pair
  const std::string pairs = content(folder.file("pairs.pers"));
  BOOST_TEST(count(pairs, "\n") - count(pairs, "#") == graph["nodes"].get<std::size_t>() / 2);

  // "gap" is a threshold in the widest gap of the persistences, "gap:2" one in the second one
  std::vector<double> persistences = {0};
  double lowest = 1, highest = 0;
  std::istringstream lines(pairs);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double dimension, lower, upper;
    if (line.find('#') == 0 || !(words >> dimension >> lower >> upper))
      continue;
    lowest = (std::min)({lowest, lower, upper});
    highest = (std::max)({highest, lower, upper});
    persistences.push_back(std::abs(upper - lower));
  }
  // neither the pair of the component nor that of the loop, which is the last one, are pairs of
  // branches
  BOOST_REQUIRE(persistences.back() < highest - lowest);
  persistences.pop_back();
  persistences.erase(std::find(persistences.begin(), persistences.end(), highest - lowest));
  std::sort(persistences.begin(), persistences.end());
  std::vector<std::pair<double, double>> gaps; // width, middle
  for (std::size_t i = 1; i < persistences.size(); ++i)
    gaps.emplace_back(persistences[i] - persistences[i - 1],
                      (persistences[i] + persistences[i - 1]) / 2 / (highest - lowest));
  std::sort(gaps.rbegin(), gaps.rend());
  for (const std::size_t k : {0, 1, 6}) {
    const std::string gap = k == 0 ? "gap" : "gap:" + std::to_string(k + 1);
    std::ostringstream threshold;
    threshold << gaps[k].second;
    const nlohmann::json expected =
                             report(folder, noisy + "--unfold --simplify " + threshold.str()),
                         result = report(folder, noisy + "--unfold --simplify " + gap);
    for (const std::string number : {"nodes", "arcs", "minima", "maxima"})
      BOOST_TEST(result[number] == expected[number]);
  }

  const nlohmann::json few_leaves = report(folder, noisy + "--unfold --leaves 5");
  BOOST_TEST(few_leaves["minima"].get<int>() + few_leaves["maxima"].get<int>() == 5);
  BOOST_TEST(few_leaves["loops"] == 1);
  BOOST_TEST(report(folder, noisy + "--unfold --close-loops 2")["loops"] == 0);
}

BOOST_AUTO_TEST_CASE(options_of_the_spectral_functions_arrive)
{
  const Folder folder;
  const std::string mesh = "'" + folder.write("mesh.off", torus(30, 14)) + "' ";
  const nlohmann::json j = report(folder, mesh + "--eigenpairs 7");
  BOOST_TEST(j["eigenvalues"][0].size() >= 7u);
  BOOST_TEST(j["eigenvalues"][0].size() <= 9u);
  const nlohmann::json k = report(folder, mesh + "--function eigenfunction --index 1");
  BOOST_TEST(k["feature_points"].size() == 0u);
  BOOST_TEST(k["loops"] == 1);
  BOOST_TEST(k["minima"] == 1);
  BOOST_TEST(k["maxima"] == 1);

  report(folder, mesh + "--output '" + folder.file("a") + "'");
  const std::vector<double> a = numbers(folder.file("a.values.txt"));
  BOOST_TEST(a.size() == 420u);
  for (const double value : a)
    BOOST_TEST(std::isfinite(value));
  const Run text = run(folder, mesh);
  BOOST_TEST(text.status == 0);
  BOOST_TEST(count(text.out, "420 vertices") == 1u);
}

// Of every function, what must be so on a long ellipsoid along the x-axis, whose poles are its tips.
BOOST_AUTO_TEST_CASE(all_functions_are_computed)
{
  const Folder folder;
  Index_mesh input = sphere(2);
  std::size_t left = 0, right = 0;
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    auto& p = input.points[v];
    p = {3 * p[0], p[1], 0.9 * p[2]};
    left = p[0] < input.points[left][0] ? v : left;
    right = p[0] > input.points[right][0] ? v : right;
  }
  const std::string mesh =
      "'" + folder.write("mesh.off", input) + "' --output '" + folder.file("x") + "' --function ";
  const std::string l = std::to_string(left), r = std::to_string(right);
  const std::string features =
      " --features '" + folder.write("features.txt", l + "\n" + r + "\n") + "'";
  const auto values = [&](const std::string& options) {
    report(folder, mesh + options);
    const std::vector<double> result = numbers(folder.file("x.values.txt"));
    BOOST_REQUIRE(result.size() == input.points.size());
    return result;
  };
  const auto lowest_x = [&](const std::vector<double>& v) {
    return input.points[std::min_element(v.begin(), v.end()) - v.begin()][0];
  };
  const auto highest_x = [&](const std::vector<double>& v) {
    return input.points[std::max_element(v.begin(), v.end()) - v.begin()][0];
  };

  // from one pole to the other
  for (const std::string& options : {std::string("height --axis 1,0,0"),
                                     "geodesic --source " + l,
                                     "harmonic --minima " + l + " --maxima " + r,
                                     "diffusion --time 2 --source " + l,
                                     "commute_time_distance --source " + l,
                                     "biharmonic --eigenpairs 20 --source " + l})
  {
    const std::vector<double> v = values(options);
    BOOST_TEST(lowest_x(v) < -2.5, options);
    BOOST_TEST(highest_x(v) > 2.5, options);
  }
  // from the middle to both poles, and the other way
  for (const std::string& options : {std::string("barycentre"),
                                     std::string("integral_geodesic"),
                                     std::string("auto_diffusion --time 0.5"),
                                     std::string("heat_kernel_signature"),
                                     "commute_time" + features})
  {
    const std::vector<double> v = values(options);
    BOOST_TEST(std::abs(lowest_x(v)) < 1, options);
    BOOST_TEST(std::abs(highest_x(v)) > 2.5, options);
  }
  for (const std::string& options : {std::string("tierny"),
                                     std::string("curvature"),
                                     "tierny" + features,
                                     "curvature" + features,
                                     std::string("geodesic --source " + l + "," + r),
                                     std::string("biharmonic --source " + l + "," + r)})
  {
    const std::vector<double> v = values(options);
    BOOST_TEST(std::abs(lowest_x(v)) > 2.5, options);
    BOOST_TEST(std::abs(highest_x(v)) < 1, options);
  }
  for (const double value : values("shape_diameter"))
    BOOST_TEST((0 < value && value < 6));
  for (const double value : values("wave_kernel_signature --index 7"))
    BOOST_TEST(value > 0);
  // the first eigenfunction has either sign
  const std::vector<double> first = values("eigenfunction");
  BOOST_TEST(lowest_x(first) * highest_x(first) < -6);

  const nlohmann::json j = report(folder, mesh + "commute_time" + features);
  BOOST_TEST(j["feature_points"] == nlohmann::json::array({left, right}));
}

// Where no source is, the tool has finite values for all distances.
BOOST_AUTO_TEST_CASE(distances_in_other_components_are_finite)
{
  const Folder folder;
  Index_mesh input = sphere(1);
  append(input, sphere(1), 5);
  const std::string mesh =
      "'" + folder.write("mesh.off", input) + "' --output '" + folder.file("x") + "' --function ";
  for (const std::string function :
       {"geodesic", "diffusion", "commute_time_distance", "biharmonic"}) {
    report(folder, mesh + function + " --source 3");
    const std::vector<double> v = numbers(folder.file("x.values.txt"));
    BOOST_REQUIRE(v.size() == 84u);
    BOOST_TEST(v[3] == 0);
    const double largest = *std::max_element(v.begin(), v.begin() + 42);
    for (std::size_t i = 42; i < 84; ++i)
      BOOST_TEST(v[i] == largest);
  }
}

// A tube that is so thin that its eigenbasis cannot be computed, beside a sphere.
BOOST_AUTO_TEST_CASE(a_component_that_cannot_be_computed_is_marked)
{
  const Folder folder;
  Index_mesh input = sphere(2);
  const std::string alone = folder.write("sphere.off", input);
  append(input, cylinder(100, 2, 1e9), 5);
  const std::string mesh = folder.write("mesh.off", input);
  const Run r = run(folder, "'" + mesh + "' --report json");
  BOOST_TEST(WIFEXITED(r.status));
  BOOST_TEST(WEXITSTATUS(r.status) == NOT_COMPUTED);
  BOOST_TEST(count(r.error, "\n") == 1u);
  BOOST_TEST(r.error.find("component 1 (300 vertices): ") != std::string::npos);
  const nlohmann::json j = nlohmann::json::parse(r.out),
                       expected = report(folder, "'" + alone + "'");
  BOOST_REQUIRE(j["failures"].size() == 1u);
  BOOST_TEST(j["failures"][0]["component"] == 1);
  BOOST_TEST(j["eigenvalues"][0] == expected["eigenvalues"][0]);
  BOOST_TEST(j["feature_points"] == expected["feature_points"]);
  BOOST_TEST(expected["failures"].empty());

  // nothing else is there
  Index_mesh tube = cylinder(100, 2, 1e9);
  check_error(folder,
              "'" + folder.write("tube.off", tube) + "'",
              {"tube.off", "component 0 (300 vertices)"},
              NOT_COMPUTED);
}
