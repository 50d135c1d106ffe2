// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is written to files and streams, whatever the format and the locale that their user has set.

#define BOOST_TEST_MODULE test_file_formats

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Grouping_locale.h"
#include "Index_mesh.h"
#include "plain_results.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/Graphviz.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/VTP.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/arc_polyline.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

// ---------------------------------------------------------------------------------------------
// Files

BOOST_AUTO_TEST_SUITE(files)

struct Graph_fixture
{
  Numbered_mesh<Mesh> input;
  std::vector<double> values;
  std::vector<int> arcs;
  SMRG::Reeb_graph<Mesh> graph;

  Graph_fixture()
  {
    Index_mesh mesh = rough_torus();
    mesh.points.push_back({9, 9, 1. / 3}); // isolated
    make_mesh(mesh, input.mesh, input.vertices);
    input.number_vertices();
    std::mt19937 rng(18);
    for (const auto& p : mesh.points) {
      values.push_back(1e-5 * (p[0] + random_unit(rng) / 3));
    }
    arcs.resize(values.size());
    SMRG::compute_Reeb_graph(
        input.mesh,
        CGAL::make_property_map(values),
        graph,
        SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)).collect_arc_vertices(true));
  }
};

boost::property_tree::ptree parse_xml(const std::string& text)
{
  std::istringstream in(text);
  boost::property_tree::ptree tree;
  read_xml(in, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree;
}

template <class T>
std::vector<T> numbers(const std::string& text)
{
  std::istringstream in(text);
  std::vector<T> result((std::istream_iterator<T>(in)), std::istream_iterator<T>());
  BOOST_CHECK(in.eof());
  return result;
}

BOOST_FIXTURE_TEST_CASE(polylines, Graph_fixture)
{
  for (const int number_of_samples : {0, 1, 10, 1000}) {
    std::ostringstream out;
    out.precision(3);
    BOOST_CHECK(SMRG::IO::write_polylines(
        out, graph, input.mesh, CGAL::parameters::number_of_samples(number_of_samples)));
    BOOST_CHECK_EQUAL(out.precision(), 3);

    std::istringstream in(out.str());
    std::string line;
    for (auto e : CGAL::make_range(edges(graph))) {
      BOOST_REQUIRE(std::getline(in, line));
      const std::vector<double> row = numbers<double>(line);
      const std::vector<Mesh::Point> polyline = SMRG::arc_polyline(
          e, graph, input.mesh, CGAL::parameters::number_of_samples(number_of_samples));
      BOOST_CHECK_LE(polyline.size(), static_cast<std::size_t>(number_of_samples) + 2);
      BOOST_REQUIRE_EQUAL(row[0], static_cast<double>(polyline.size()));
      BOOST_REQUIRE_EQUAL(row.size(), 3 * polyline.size() + 1);
      for (std::size_t i = 0; i < polyline.size(); ++i) {
        BOOST_CHECK(polyline[i] == Mesh::Point(row[3 * i + 1], row[3 * i + 2], row[3 * i + 3]));
      }
      BOOST_CHECK(polyline.front() == input.mesh.point(graph[lower_node(e, graph)].vertex));
      BOOST_CHECK(polyline.back() == input.mesh.point(graph[upper_node(e, graph)].vertex));
    }
    BOOST_CHECK(!std::getline(in, line));
  }
}

// Files hold what streams get.
BOOST_FIXTURE_TEST_CASE(files, Graph_fixture)
{
  const auto scalar_map = CGAL::make_property_map(values);
  const auto arc_map = CGAL::make_property_map(arcs);
  const auto check = [&](const auto& write) {
    std::string file = (std::filesystem::temp_directory_path() /
                        ("reeb_graph_" + std::to_string(std::random_device()())))
                           .string();
    std::ofstream(file) << "what was there before";
    std::ostringstream out;
    BOOST_CHECK(write(out));
    BOOST_CHECK(write(file));
    std::ifstream in(file, std::ios_base::binary);
    BOOST_CHECK(out.str() == std::string(std::istreambuf_iterator<char>(in), {}));
    in.close();
    std::filesystem::remove(file);
    file += "/of/no/folder";
    BOOST_CHECK(!write(file));
  };
  check([&](auto& out) { return SMRG::IO::write_polylines(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_GraphML(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_Graphviz(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_persistence_diagram(out, graph); });
  check([&](auto& out) { return SMRG::IO::write_VTP(out, input.mesh, scalar_map, arc_map); });

  const SMRG::Reeb_graph<Mesh> empty;
  check([&](auto& out) { return SMRG::IO::write_polylines(out, empty, input.mesh); });
}

// As XML has them.
BOOST_FIXTURE_TEST_CASE(graphml_with_infinite_values, Graph_fixture)
{
  const double infinity = std::numeric_limits<double>::infinity();
  *std::min_element(values.begin(), values.end()) = -infinity;
  *std::max_element(values.begin(), values.end()) = infinity;
  SMRG::compute_Reeb_graph(input.mesh, CGAL::make_property_map(values), graph);
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(out.str().find(">INF<") != std::string::npos);
  BOOST_CHECK(out.str().find(">-INF<") != std::string::npos);
  BOOST_CHECK(out.str().find(">inf<") == std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(polylines_with_a_negative_number_of_samples, Graph_fixture)
{
  std::ostringstream out;
  out.precision(3);
  BOOST_CHECK_THROW(
      SMRG::IO::write_polylines(out, graph, input.mesh, CGAL::parameters::number_of_samples(-1)),
      CGAL::Precondition_exception);
  BOOST_CHECK(out.str().empty());
  BOOST_CHECK_EQUAL(out.precision(), 3);
}

BOOST_FIXTURE_TEST_CASE(graphml, Graph_fixture)
{
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  const boost::property_tree::ptree tree = parse_xml(out.str());

  std::map<std::string, std::string> node_property, arc_property; // names by key
  std::vector<std::map<std::string, std::string>> nodes, arcs_read;
  auto read_data = [](const boost::property_tree::ptree& element,
                      const std::map<std::string, std::string>& property) {
    std::map<std::string, std::string> data;
    for (const auto& child : element) {
      if (child.first == "data") {
        data[property.at(child.second.get<std::string>("<xmlattr>.key"))] = child.second.data();
      }
    }
    return data;
  };
  for (const auto& child : tree.get_child("graphml")) {
    if (child.first == "key") {
      const bool is_node = child.second.get<std::string>("<xmlattr>.for") == "node";
      (is_node ? node_property : arc_property)[child.second.get<std::string>("<xmlattr>.id")] =
          child.second.get<std::string>(
              "<xmlattr>.attr.name",
              child.second.get_child("<xmlattr>").count("attr.name")
                  ? child.second.get_child("<xmlattr>").find("attr.name")->second.data()
                  : "");
    }
  }
  for (const auto& child : tree.get_child("graphml.graph")) {
    if (child.first == "node") {
      nodes.push_back(read_data(child.second, node_property));
    } else if (child.first == "edge") {
      arcs_read.push_back(read_data(child.second, arc_property));
    }
  }
  BOOST_REQUIRE_EQUAL(nodes.size(), num_vertices(graph));
  BOOST_REQUIRE_EQUAL(arcs_read.size(), num_edges(graph));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& node = graph[i];
    const Mesh::Point p = input.mesh.point(node.vertex);
    std::ostringstream type;
    type << node.type;
    BOOST_CHECK_EQUAL(nodes[i].at("id"), std::to_string(i));
    BOOST_CHECK_EQUAL(nodes[i].at("mesh_vertex"), std::to_string(input.number.at(node.vertex)));
    BOOST_CHECK_EQUAL(nodes[i].at("type"), type.str());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("value")), node.value);
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("x")), p.x());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("y")), p.y());
    BOOST_CHECK_EQUAL(std::stod(nodes[i].at("z")), p.z());
  }
  std::size_t i = 0;
  for (auto e : CGAL::make_range(edges(graph))) {
    BOOST_CHECK_EQUAL(arcs_read[i].at("id"), std::to_string(i));
    BOOST_CHECK_EQUAL(arcs_read[i].at("number_of_vertices"),
                      std::to_string(graph[e].vertices.size()));
    ++i;
  }
}

BOOST_FIXTURE_TEST_CASE(graphviz, Graph_fixture)
{
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_Graphviz(out, graph, input.mesh));
  const std::string text = out.str();
  BOOST_CHECK_EQUAL(text.compare(0, 7, "graph G"), 0);
  std::istringstream in(text);
  std::string line;
  std::size_t number_of_nodes = 0, number_of_arcs = 0;
  while (std::getline(in, line)) {
    if (line.find("--") != std::string::npos) {
      ++number_of_arcs;
    } else if (line.find('[') != std::string::npos) {
      const std::string name = " value=";
      const std::size_t begin = line.find(name);
      BOOST_REQUIRE(begin != std::string::npos);
      std::string value = line.substr(begin + name.size());
      value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
      const std::size_t id = static_cast<std::size_t>(std::stoul(line));
      BOOST_REQUIRE_LT(id, num_vertices(graph));
      BOOST_CHECK_EQUAL(std::stod(value), graph[id].value);
      ++number_of_nodes;
    }
  }
  BOOST_CHECK_EQUAL(number_of_nodes, num_vertices(graph));
  BOOST_CHECK_EQUAL(number_of_arcs, num_edges(graph));
}

BOOST_FIXTURE_TEST_CASE(vtp, Graph_fixture)
{
  std::ostringstream out;
  out.precision(3);
  BOOST_CHECK(SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs)));
  BOOST_CHECK_EQUAL(out.precision(), 3);
  const boost::property_tree::ptree tree = parse_xml(out.str());
  const auto& piece = tree.get_child("VTKFile.PolyData.Piece");
  BOOST_CHECK_EQUAL(piece.get<std::size_t>("<xmlattr>.NumberOfPoints"), input.vertices.size());
  BOOST_CHECK_EQUAL(piece.get<std::size_t>("<xmlattr>.NumberOfPolys"), num_faces(input.mesh));

  std::map<std::string, std::string> arrays;
  for (const char* section : {"PointData", "Points", "Polys"}) {
    for (const auto& child : piece.get_child(section)) {
      if (child.first == "DataArray") {
        arrays[child.second.get<std::string>("<xmlattr>.Name", section)] = child.second.data();
      }
    }
  }
  check_equal(numbers<double>(arrays.at("value")), values);
  check_equal(numbers<int>(arrays.at("arc")), arcs);
  BOOST_CHECK_EQUAL(arcs.back(), -1);
  const std::vector<double> coordinates = numbers<double>(arrays.at("Points"));
  BOOST_REQUIRE_EQUAL(coordinates.size(), 3 * input.vertices.size());
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    BOOST_CHECK(input.mesh.point(input.vertices[i]) ==
                Mesh::Point(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]));
  }
  const std::vector<std::size_t> corners = numbers<std::size_t>(arrays.at("connectivity"));
  BOOST_REQUIRE_EQUAL(corners.size(), 3 * rough_torus().triangles.size());
  for (std::size_t i = 0; i < rough_torus().triangles.size(); ++i) {
    // the same triangle, whatever its first corner
    std::array<std::size_t, 3> read = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
    std::rotate(read.begin(), std::min_element(read.begin(), read.end()), read.end());
    std::array<std::size_t, 3> expected = rough_torus().triangles[i];
    std::rotate(
        expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
    BOOST_CHECK(read == expected);
  }
  const std::vector<std::size_t> offsets = numbers<std::size_t>(arrays.at("offsets"));
  BOOST_REQUIRE_EQUAL(offsets.size(), num_faces(input.mesh));
  BOOST_CHECK_EQUAL(offsets.back(), corners.size());
}

// A vertex without an arc has the number -1 in the file, whatever the type of the numbers.
template <class Number>
void check_vtp_of_isolated_vertex()
{
  const Numbered_mesh<Mesh> input(Index_mesh{{{0, 0, 0}}, {}});
  const std::vector<double> values(1, 0.);
  std::vector<Number> arcs(1, Number(77));
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(input.mesh,
                           CGAL::make_property_map(values),
                           graph,
                           SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)));
  std::ostringstream out;
  SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs));
  BOOST_CHECK(contains(out.str(), "Name=\"arc\" format=\"ascii\">\n-1\n<"));
}

BOOST_AUTO_TEST_CASE(vtp_of_isolated_vertex)
{
  check_vtp_of_isolated_vertex<int>();
  check_vtp_of_isolated_vertex<std::size_t>();
  check_vtp_of_isolated_vertex<unsigned>();
}

BOOST_FIXTURE_TEST_CASE(stream_that_fails, Graph_fixture)
{
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  BOOST_CHECK(!SMRG::IO::write_polylines(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_Graphviz(out, graph, input.mesh));
  BOOST_CHECK(!SMRG::IO::write_VTP(
      out, input.mesh, CGAL::make_property_map(values), CGAL::make_property_map(arcs)));
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Locales

BOOST_AUTO_TEST_SUITE(locales)

// Files are the same under a global locale that groups digits, in which 1279 is 1.279.
BOOST_AUTO_TEST_CASE(global_locale_that_groups_digits)
{
  // more than a thousand nodes, arcs, vertices of the mesh and vertices of one arc
  Index_mesh mesh = torus(100, 50);
  append(mesh, sphere(5), 5);
  const Numbered_mesh<Mesh> input(mesh);
  std::mt19937 rng(19);
  std::vector<double> values;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    values.push_back(i < 5000 ? 1e4 * random_unit(rng) : 1e6 * mesh.points[i][2]);
  }
  std::vector<int> arcs(values.size());
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(
      input.mesh,
      values_as_map(input, values),
      graph,
      SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs)).collect_arc_vertices(true));
  BOOST_REQUIRE_GT(num_vertices(graph), 1000u);
  std::size_t longest_arc = 0;
  for (auto e : CGAL::make_range(edges(graph))) {
    longest_arc = (std::max)(longest_arc, graph[e].vertices.size());
  }
  BOOST_REQUIRE_GT(longest_arc, 1000u);

  const auto check = [&](const auto& write) {
    std::ostringstream expected;
    BOOST_REQUIRE(write(expected));
    BOOST_CHECK(contains(expected.str(), "1279"));

    const Grouping_locale grouping;
    std::ostringstream out;
    BOOST_CHECK(write(out));
    BOOST_CHECK(out.str() == expected.str());
    out << 1279;
    BOOST_CHECK(contains(out.str(), "1.279")); // the stream has its own locale again
    const std::string file = (std::filesystem::temp_directory_path() /
                              ("reeb_graph_" + std::to_string(std::random_device()())))
                                 .string();
    BOOST_CHECK(write(file));
    std::ifstream in(file, std::ios_base::binary);
    BOOST_CHECK(expected.str() == std::string(std::istreambuf_iterator<char>(in), {}));
    in.close();
    std::filesystem::remove(file);
  };
  check([&](auto& out) { return SMRG::IO::write_GraphML(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_Graphviz(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_polylines(out, graph, input.mesh); });
  check([&](auto& out) { return SMRG::IO::write_persistence_diagram(out, graph); });
  check([&](auto& out) {
    return SMRG::IO::write_VTP(
        out, input.mesh, values_as_map(input, values), CGAL::make_property_map(arcs));
  });
}

// So are the messages of exceptions.
BOOST_AUTO_TEST_CASE(messages_under_a_locale_that_groups_digits)
{
  const Index_mesh mesh = torus(100, 50);
  const Numbered_mesh<Mesh> input(mesh);
  std::vector<double> values(mesh.points.size(), 0.);
  values[1279] = std::numeric_limits<double>::quiet_NaN();
  SMRG::Reeb_graph<Mesh> graph;
  const Grouping_locale grouping;
  BOOST_CHECK_EXCEPTION(
      SMRG::compute_Reeb_graph(input.mesh, values_as_map(input, values), graph),
      SMRG::Input_error,
      [](const SMRG::Input_error& error) { return contains(error.what(), " 1279 "); });
}

BOOST_AUTO_TEST_SUITE_END()
