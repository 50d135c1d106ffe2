#ifndef REEB_GRAPH_TOOL_TYPES_H
#define REEB_GRAPH_TOOL_TYPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Curve_skeleton.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>

#include "../mesh_input/errors.h"
#include "../mesh_input/prepare_polygon_soup.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<vertex_descriptor, double>;
using Arc_map = Mesh::Property_map<vertex_descriptor, int>;
using Graph = SMRG::Reeb_graph<Mesh>;
using Skeleton = SMRG::Curve_skeleton<Mesh>;

// Of noise nobody wants a skeleton that takes minutes: with more arcs, curves go through barycenters.
constexpr std::size_t most_arcs_of_skeleton = 1000;

// The exit statuses of the tool.
enum Exit_status {
  DONE = 0,
  BAD_INPUT = 1,   // a file, or what is in it; files that cannot be written, too
  BAD_USAGE = 2,   // options
  NOT_COMPUTED = 3 // nothing is wrong with the input, but numbers or memory do not suffice
};

struct Options
{
  std::string mesh_file;
  Mesh_input_options input;
  std::string values_file;     // or the name of a property of VTK's; empty: see below
  std::string values_property; // empty, too: the function is computed
  std::string function = "commute_time";
  std::array<double, 3> axis = {0, 0, 1};
  int index = 1;
  double time = 1;
  std::vector<std::size_t> sources, minima, maxima; // numbers of vertices
  std::string features_file;                        // empty: feature points are computed
  bool unfold = false;
  double simplify = 0;
  int gap = 0; // positive: the branches below this gap of the diagram, instead of a fraction
  double close_loops = 0;
  bool threshold_is_absolute = false;
  int leaves = (std::numeric_limits<int>::max)();
  int eigenpairs = 50;
  double residual_tolerance = 1e-8;
  double small_time = 1.5;
  double large_time = 20;
  std::string output;  // empty: no files are written
  std::string diagram; // empty: it is not written
  std::string html;    // empty, too
  bool json = false;

  bool has_values() const { return !values_file.empty() || !values_property.empty(); }
};

// A component whose eigenbasis could not be computed as asked for.
struct Component_failure
{
  std::size_t component, number_of_vertices;
  std::string reason;

  std::string text() const
  {
    return "component " + std::to_string(component) + " (" + std::to_string(number_of_vertices) +
           " vertices): " + reason;
  }
};

// What the tool finds out.
struct Result
{
  Mesh mesh;
  Mesh_input input;
  std::size_t number_of_components = 0;
  Value_map values;
  Arc_map arcs;
  Graph graph;
  std::optional<Skeleton> skeleton; // if files with it are written, and there are few arcs
  std::string diagram;              // of the graph before it is simplified
  std::vector<vertex_descriptor> feature_points;
  std::vector<std::vector<double>> eigenvalues; // by component
  std::vector<Component_failure> failures;
  struct
  {
    double read = 0, eigenbasis = 0, function = 0, reeb_graph = 0, simplify = 0, skeleton = 0,
           write = 0;
  } seconds;
};

#endif // REEB_GRAPH_TOOL_TYPES_H
