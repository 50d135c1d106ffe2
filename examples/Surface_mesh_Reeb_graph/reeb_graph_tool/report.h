#ifndef REEB_GRAPH_TOOL_REPORT_H
#define REEB_GRAPH_TOOL_REPORT_H

#include "types.h"

#include "../mesh_input/text.h"
#include "../mesh_input/weld_points.h"

#include <CGAL/Polygon_mesh_processing/border.h>

#include <boost/io/ios_state.hpp>
#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <locale>
#include <ostream>
#include <string>
#include <vector>

struct Node_counts
{
  std::size_t minima = 0, maxima = 0, splits = 0, merges = 0;
  std::size_t isolated = 0, degenerate = 0;
};

inline Node_counts count_nodes(const Graph& graph)
{
  Node_counts counts;
  for (auto node : boost::make_iterator_range(vertices(graph))) {
    switch (graph[node].type) {
    case SMRG::Reeb_node_type::MINIMUM:
      ++counts.minima;
      break;
    case SMRG::Reeb_node_type::MAXIMUM:
      ++counts.maxima;
      break;
    case SMRG::Reeb_node_type::SPLIT_SADDLE:
      ++counts.splits;
      break;
    case SMRG::Reeb_node_type::MERGE_SADDLE:
      ++counts.merges;
      break;
    case SMRG::Reeb_node_type::ISOLATED:
      ++counts.isolated;
      break;
    case SMRG::Reeb_node_type::DEGENERATE:
      ++counts.degenerate;
    }
  }
  return counts;
}

// The cycle rank; the graph has as many components as the mesh.
inline std::size_t number_of_loops(const Result& result)
{
  return num_edges(result.graph) + result.number_of_components - num_vertices(result.graph);
}

// Grows when a program that reads the report has to know of a change.
constexpr int version_of_report = 1;

inline void print_json(std::ostream& out, const Result& result)
{
  const Node_counts counts = count_nodes(result.graph);
  nlohmann::ordered_json report;
  report["version"] = version_of_report;
  report["vertices"] = result.mesh.number_of_vertices();
  report["faces"] = result.mesh.number_of_faces();
  report["components"] = result.number_of_components;
  report["nodes"] = num_vertices(result.graph);
  report["arcs"] = num_edges(result.graph);
  report["loops"] = number_of_loops(result);
  report["minima"] = counts.minima;
  report["maxima"] = counts.maxima;
  report["splits"] = counts.splits;
  report["merges"] = counts.merges;
  report["degenerate"] = counts.degenerate + counts.isolated; // all others
  report["feature_points"] = nlohmann::ordered_json::array();
  for (vertex_descriptor v : result.feature_points)
    report["feature_points"].push_back(static_cast<std::size_t>(v));
  report["eigenvalues"] = result.eigenvalues;
  report["failures"] = nlohmann::ordered_json::array();
  for (const Component_failure& failure : result.failures)
    report["failures"].push_back({{"component", failure.component},
                                  {"vertices", failure.number_of_vertices},
                                  {"text", failure.reason}});
  report["repairs"] = nlohmann::ordered_json::array();
  for (const Repair& repair : result.input.repairs)
    report["repairs"].push_back(
        {{"kind", repair.kind}, {"number", repair.number}, {"text", repair.text}});
  report["seconds"] = {{"read", result.seconds.read},
                       {"eigenbasis", result.seconds.eigenbasis},
                       {"function", result.seconds.function},
                       {"reeb_graph", result.seconds.reeb_graph},
                       {"simplify", result.seconds.simplify},
                       {"skeleton", result.seconds.skeleton},
                       {"write", result.seconds.write}};
  out << report.dump(2) << '\n';
}

// Where the vertices are, but for those that repairs have duplicated: they are in the same place on
// purpose, and the last ones.
inline std::vector<std::array<double, 3>> points_of(const Result& result)
{
  std::vector<std::array<double, 3>> points;
  const std::vector<std::size_t>& origin = result.input.point_of_vertex;
  for (vertex_descriptor v : result.mesh.vertices()) {
    if (!points.empty() && !origin.empty() && origin[v] <= origin[points.size() - 1])
      break;
    const Kernel::Point_3& p = result.mesh.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  return points;
}

inline std::size_t
number_of_places(const std::vector<std::array<double, 3>>& points, double distance)
{
  const std::vector<std::size_t> first = coinciding_points(points, distance);
  std::size_t number = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    number += first[i] == i;
  return number;
}

// Says that vertices at the same place, or so close that most of the border comes from it, are not
// the same.
inline void print_hint_on_places(std::ostream& out, const Result& result)
{
  const std::vector<std::array<double, 3>> points = points_of(result);
  const std::size_t places = number_of_places(points, 0);
  if (places < points.size()) {
    out << "Note: the vertices lie at " << places
        << " different points only; faces are neighbors only if they share vertices "
           "(--weld 0 makes those at the same point one)\n";
    return;
  }
  constexpr double closest = 1e-6;
  const double distance = closest * diagonal_of_box(points);
  std::vector<std::array<double, 3>> at_border;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vertex_descriptor v(static_cast<vertex_descriptor::size_type>(i));
    if (!result.mesh.is_isolated(v) && result.mesh.is_border(v))
      at_border.push_back(points[i]);
  }
  const std::size_t places_at_border = number_of_places(at_border, distance);
  if (at_border.size() - places_at_border >= at_border.size() / 3 + 1)
    out << "Note: the " << at_border.size() << " vertices at the border lie at " << places_at_border
        << " places only if those closer than " << distance << " are the same (--weld " << distance
        << " makes them one)\n";
}

inline void print_text(std::ostream& out, const Options& options, const Result& result)
{
  const boost::io::ios_locale_saver locale(out, std::locale::classic());
  const Node_counts counts = count_nodes(result.graph);
  const std::size_t vertices = result.mesh.number_of_vertices();
  out << options.mesh_file << ": " << vertices << (vertices == 1 ? " vertex" : " vertices") << ", "
      << counted(result.mesh.number_of_faces(), "face") << ", "
      << counted(result.number_of_components, "component") << ", "
      << counted(CGAL::Polygon_mesh_processing::number_of_borders(result.mesh), "border") << '\n';
  print_hint_on_places(out, result);
  out << "Reeb graph: " << counted(num_vertices(result.graph), "node") << ", "
      << counted(num_edges(result.graph), "arc") << ", " << counted(number_of_loops(result), "loop")
      << '\n';
  out << "Nodes: minima " << counts.minima << ", maxima " << counts.maxima << ", splits "
      << counts.splits << ", merges " << counts.merges << ", isolated " << counts.isolated
      << ", degenerate " << counts.degenerate << '\n';
  if (!options.output.empty() && !result.skeleton)
    out << "Note: with more than " << most_arcs_of_skeleton
        << " arcs there is no skeleton; their polylines go through barycenters of vertices "
           "(--simplify cancels arcs)\n";
  if (!result.feature_points.empty())
    out << "Feature points: " << result.feature_points.size() << '\n';
  out << "Seconds: read " << result.seconds.read << ", eigenbasis " << result.seconds.eigenbasis
      << ", function " << result.seconds.function << ", Reeb graph " << result.seconds.reeb_graph
      << ", simplify " << result.seconds.simplify << ", skeleton " << result.seconds.skeleton
      << ", write " << result.seconds.write << '\n';
}

#endif // REEB_GRAPH_TOOL_REPORT_H
