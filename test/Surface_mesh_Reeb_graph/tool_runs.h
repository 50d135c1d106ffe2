// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of the command-line tool REEB_GRAPH_TOOL, with files and what it says.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_TOOL_RUNS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_TOOL_RUNS_H

#include "Index_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace Reeb_graph_test {

using Tool_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A folder of files that goes with the test.
struct Folder
{
  std::filesystem::path path;

  Folder()
  {
    std::random_device device;
    path = std::filesystem::temp_directory_path() / ("reeb_graph_tool_" + std::to_string(device()));
    std::filesystem::create_directory(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }

  std::string file(const std::string& name) const { return (path / name).string(); }

  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

  std::string write(const std::string& name, const Index_mesh& mesh) const
  {
    Tool_mesh m;
    std::vector<Tool_mesh::Vertex_index> vertices;
    make_mesh(mesh, m, vertices);
    BOOST_REQUIRE(
        CGAL::IO::write_polygon_mesh(file(name), m, CGAL::parameters::stream_precision(17)));
    return file(name);
  }
};

inline std::string content(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  BOOST_REQUIRE(in);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

inline std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t number = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1))
    ++number;
  return number;
}

struct Run
{
  int status;
  std::string out, error;
};

inline Run run(const Folder& folder, const std::string& arguments)
{
  const std::string command = std::string("'") + REEB_GRAPH_TOOL + "' " + arguments + " > '" +
                              folder.file("stdout") + "' 2> '" + folder.file("stderr") + "'";
  const int status = std::system(command.c_str());
  return {status, content(folder.file("stdout")), content(folder.file("stderr"))};
}

// `findings` receives what the tool says about the mesh file; without it, there is nothing to say.
inline nlohmann::json
report(const Folder& folder, const std::string& arguments, std::string* findings = nullptr)
{
  const Run r = run(folder, arguments + " --report json");
  if (findings != nullptr)
    *findings = r.error;
  else
    BOOST_TEST(r.error == "");
  BOOST_REQUIRE(r.status == 0);
  return nlohmann::json::parse(r.out);
}

// The exit statuses that the tool documents.
enum Exit_status { BAD_INPUT = 1, BAD_USAGE = 2, NOT_COMPUTED = 3 };

// One line on the error stream that has all the given words in it, and nothing else.
inline void check_error(const Folder& folder,
                        const std::string& arguments,
                        const std::vector<std::string>& words,
                        Exit_status status = BAD_INPUT)
{
  BOOST_TEST_CONTEXT("reeb_graph " << arguments)
  {
    const Run r = run(folder, arguments);
    BOOST_TEST(WIFEXITED(r.status)); // no signal
    BOOST_TEST(WEXITSTATUS(r.status) == status);
    BOOST_TEST(r.out == "");
    BOOST_TEST(count(r.error, "\n") == 1u);
    for (const std::string& word : words)
      BOOST_TEST(r.error.find(word) != std::string::npos, r.error << " does not say " << word);
  }
}

// The same for the options, of which the mesh file is not accused.
inline void check_usage_error(const Folder& folder,
                              const std::string& arguments,
                              const std::vector<std::string>& words)
{
  check_error(folder, arguments, words, BAD_USAGE);
  BOOST_TEST(content(folder.file("stderr")).find("reeb_graph: /") == std::string::npos);
}

inline std::vector<double> numbers(const std::string& file)
{
  std::ifstream in(file);
  return std::vector<double>(std::istream_iterator<double>(in), std::istream_iterator<double>());
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_TOOL_RUNS_H
