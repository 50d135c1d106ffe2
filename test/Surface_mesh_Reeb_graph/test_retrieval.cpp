// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program RETRIEVAL as a user would, under MPIEXEC too if that is defined.

#define BOOST_TEST_MODULE retrieval

#include "../../examples/Surface_mesh_Reeb_graph/retrieval_tool/evaluation.h"
#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>

using namespace Reeb_graph_test;

namespace {

namespace fs = std::filesystem;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

std::string content(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Spheres and tori, stretched in different ways, in a folder that goes with the test.
struct Collection
{
  fs::path path;

  Collection()
  {
    std::random_device device;
    path = fs::temp_directory_path() / ("retrieval_" + std::to_string(device()));
    fs::create_directories(path / "meshes");
    std::ofstream classes(path / "classes.txt");
    for (int i = 0; i < 3; ++i) {
      Index_mesh ball = sphere(2), ring = torus(18, 10);
      for (Index_mesh* mesh : {&ball, &ring})
        for (auto& p : mesh->points)
          p = {p[0] * (1.5 + .05 * i), p[1] * 1.2, p[2]};
      write("ball" + std::to_string(i) + ".off", ball);
      write("ring" + std::to_string(i) + ".off", ring);
      classes << "ball" << i << ".off ball\nring" << i << ".off ring\n";
    }
  }
  ~Collection() { fs::remove_all(path); }

  void write(const std::string& name, const Index_mesh& mesh) const
  {
    Mesh m;
    std::vector<Mesh::Vertex_index> vertices;
    make_mesh(mesh, m, vertices);
    BOOST_REQUIRE(CGAL::IO::write_polygon_mesh(
        (path / "meshes" / name).string(), m, CGAL::parameters::stream_precision(17)));
  }

  // Its exit status; `output` and `errors` receive what it writes.
  int run(const std::string& arguments, const std::string& launcher = "")
  {
    const std::string command = "cd '" + path.string() + "' && " + launcher + " '" RETRIEVAL "' " +
                                arguments + " > output 2> errors";
    const int status = std::system(command.c_str());
    output = content(path / "output");
    errors = content(path / "errors");
    BOOST_REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
  }

  std::string output, errors;
};

std::size_t number_of_files(const fs::path& folder)
{
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

} // namespace

BOOST_AUTO_TEST_CASE(scores)
{
  // the classes of 0, 1, 2 and of 3, 4 are equal, 5 is alone
  const std::vector<std::string> classes = {"a", "a", "a", "b", "b", "c"};
  const Scores best = scores_of_query({1, 2, 3, 4, 5}, classes, 0);
  for (const double score :
       {best.nearest_neighbor, best.first_tier, best.second_tier, best.discounted_gain})
    BOOST_TEST(score == 1);
  // first and fourth of five
  const Scores middle = scores_of_query({1, 3, 4, 2, 5}, classes, 0);
  BOOST_TEST(middle.nearest_neighbor == 1);
  BOOST_TEST(middle.first_tier == .5);
  BOOST_TEST(middle.second_tier == 1);
  BOOST_TEST(middle.discounted_gain == (1 + 1 / std::log2(4.)) / 2,
             boost::test_tools::tolerance(1e-15));
  BOOST_TEST(scores_of_query({0, 1, 2, 3, 4}, classes, 5).number_of_queries == 0);
  BOOST_TEST(ranking({3, 0, 1, 3, 2}, 1) == std::vector<std::size_t>({2, 4, 0, 3}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(index_and_query)
{
  Collection c;
  BOOST_TEST(c.run("index meshes --threads 2 --distances distances.txt --classes classes.txt") ==
             0);
  BOOST_TEST(c.errors == "");
  BOOST_TEST(number_of_files(c.path / "meshes/signatures") == 12); // of two functions
  BOOST_TEST(c.output.find("6 shapes indexed") != std::string::npos);
  BOOST_TEST(c.output.find("| all          | 1.000 | 1.000 | 1.000 | 1.000 |") !=
             std::string::npos);

  std::istringstream in(content(c.path / "distances.txt"));
  std::string line;
  std::getline(in, line);
  BOOST_TEST(line == "ball0.off ball1.off ball2.off ring0.off ring1.off ring2.off");
  std::vector<double> d((std::istream_iterator<double>(in)), {});
  BOOST_REQUIRE(d.size() == 36);
  for (std::size_t i = 0; i < 6; ++i) {
    BOOST_TEST(d[7 * i] == 0);
    for (std::size_t j = 0; j < i; ++j) {
      BOOST_TEST(d[6 * i + j] > 0);
      BOOST_TEST(d[6 * i + j] == d[6 * j + i]);
    }
  }

  // a query reads signatures only, and the collection grows shape by shape
  const std::string first = content(c.path / "meshes/signatures/ball0.off.commute_time.signature");
  fs::copy(c.path / "meshes/ring1.off", c.path / "query.off");
  BOOST_TEST(c.run("query query.off --signatures meshes/signatures --nearest 3") == 0);
  BOOST_TEST(c.output.substr(0, 12) == "0 ring1.off\n");
  BOOST_TEST(c.output.find("ball") == std::string::npos);
  c.write("new.off", torus(12, 9));
  BOOST_TEST(c.run("index meshes") == 0);
  BOOST_TEST(c.output.find("1 shape indexed") == 0);
  BOOST_TEST(number_of_files(c.path / "meshes/signatures") == 14);
  BOOST_TEST(content(c.path / "meshes/signatures/ball0.off.commute_time.signature") == first);
}

BOOST_AUTO_TEST_CASE(other_functions_and_distances)
{
  Collection c;
  for (const std::string function : {"height", "geodesic", "auto_diffusion"})
    BOOST_TEST(c.run("index meshes --signatures s --function " + function) == 0);
  BOOST_TEST(number_of_files(c.path / "s") == 18);

  // several functions: the distances are added
  const auto distances = [&c](const std::string& functions) {
    BOOST_TEST(c.run("index meshes --signatures s --distances d.txt --function " + functions) == 0);
    BOOST_TEST(c.output == ""); // all signatures are there
    std::istringstream in(content(c.path / "d.txt"));
    std::string line;
    std::getline(in, line);
    return std::vector<double>((std::istream_iterator<double>(in)), {});
  };
  const std::vector<double> height = distances("height"), geodesic = distances("geodesic"),
                            both = distances("height,geodesic");
  BOOST_REQUIRE(both.size() == 36);
  for (std::size_t i = 0; i < both.size(); ++i)
    BOOST_TEST(both[i] == height[i] + geodesic[i]);

  for (const std::string distance : {"graph", "spectrum", "persistence"})
    BOOST_TEST(c.run("query meshes/ball2.off --signatures s --function geodesic --nearest 1 "
                     "--distance " +
                     distance) == 0);
  BOOST_TEST(c.run("index meshes --signatures s --function height --classes classes.txt --table") ==
             0);
  BOOST_TEST(c.output.find("| spectrum ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(errors)
{
  Collection c;
  const auto check = [&c](const std::string& arguments, const std::string& message) {
    BOOST_TEST_CONTEXT(arguments)
    {
      BOOST_TEST(c.run(arguments) == EXIT_FAILURE);
      BOOST_TEST(c.errors.find("retrieval: ") == 0);
      BOOST_TEST(c.errors.find(message) != std::string::npos);
    }
  };
  BOOST_TEST(c.run("--help") == 0);
  check("", "the command is");
  check("find meshes", "the command is");
  check("index", "which folder");
  check("index nowhere", "nowhere: cannot be read as a folder");
  check("index meshes/..", "holds no file in one of the formats OFF");
  check("query meshes/ball0.off", "--signatures");
  check("query meshes/ball0.off --signatures meshes", "holds no signature");
  check("index meshes --function no", "there is no function 'no'");
  check("index meshes --function height,", "there is no function ''");
  check("index meshes --distance no", "there is no distance 'no'");
  check("index meshes --threads 0", "--threads");
  check("index meshes --table", "--table needs --classes");
  std::ofstream(c.path / "few.txt") << "ball0.off ball\n";
  check("index meshes --classes few.txt", "has no class for ball1.off");

  // one mesh that is none does not keep the others from being indexed
  std::ofstream(c.path / "meshes/bad.off") << "OFF\n3 1 0\n";
  check("index meshes", "meshes/bad.off");
  BOOST_TEST(number_of_files(c.path / "meshes/signatures") == 12);
  std::ofstream(c.path / "meshes/signatures/ball0.off.commute_time.signature") << "nothing\n";
  check("query meshes/ball1.off --signatures meshes/signatures", "the first line");
}

#ifdef MPIEXEC
BOOST_AUTO_TEST_CASE(two_processes_find_what_one_finds)
{
  Collection c;
  const std::string arguments = "index meshes --classes classes.txt --distances ";
  BOOST_TEST(c.run(arguments + "one.txt --signatures one") == 0);
  const std::string table = c.output.substr(c.output.find('|'));
  BOOST_TEST(c.run(arguments + "two.txt --signatures two", MPIEXEC) == 0);
  BOOST_TEST(c.output.find("3 shapes indexed") != std::string::npos);
  BOOST_TEST(c.output.substr(c.output.find('|')) == table);
  BOOST_TEST(content(c.path / "one.txt") == content(c.path / "two.txt"));
  BOOST_TEST(number_of_files(c.path / "two") == 12);
  for (const fs::directory_entry& entry : fs::directory_iterator(c.path / "one"))
    BOOST_TEST(content(entry) == content(c.path / "two" / entry.path().filename()));
  // an error ends both
  BOOST_TEST(c.run("index nowhere", MPIEXEC) != 0);
}
#endif
