#ifndef REEB_GRAPH_TOOL_TYPES_H
#define REEB_GRAPH_TOOL_TYPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<vertex_descriptor, double>;
using Arc_map = Mesh::Property_map<vertex_descriptor, int>;
using Graph = SMRG::Reeb_graph<Mesh>;

// Something is wrong with a file.
struct File_error : std::runtime_error
{
  File_error(const std::string& file, const std::string& what)
    : std::runtime_error(file + ": " + what)
  {}
};

struct Options
{
  std::string mesh_file;
  std::string values_file; // empty: the function is computed
  std::string function = "commute_time";
  std::array<double, 3> axis = {0, 0, 1};
  int index = 1;
  double time = 1;
  std::vector<std::size_t> sources, minima, maxima; // numbers of vertices
  std::string features_file;                        // empty: feature points are computed
  bool unfold = false;
  double simplify = 0;
  int gap =
      0; // if it is positive, the branches below this gap of the diagram, instead of a fraction
  double close_loops = 0;
  int leaves = (std::numeric_limits<int>::max)();
  int eigenpairs = 50;
  double small_time = 1.5;
  double large_time = 20;
  std::string output;  // empty: no files are written
  std::string diagram; // empty: it is not written
  bool json = false;
};

// What the tool finds out.
struct Result
{
  Mesh mesh;
  std::size_t number_of_components = 0;
  Value_map values;
  Arc_map arcs;
  Graph graph;
  std::string diagram; // of the graph before it is simplified
  std::vector<vertex_descriptor> feature_points;
  std::vector<std::vector<double>> eigenvalues; // by component
  struct
  {
    double read = 0, eigenbasis = 0, function = 0, reeb_graph = 0, simplify = 0, write = 0;
  } seconds;
};

#endif // REEB_GRAPH_TOOL_TYPES_H
