#ifndef REEB_GRAPH_TOOL_REPORT_H
#define REEB_GRAPH_TOOL_REPORT_H

#include "types.h"

#include <CGAL/Polygon_mesh_processing/border.h>

#include <boost/io/ios_state.hpp>
#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
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

inline void print_json(std::ostream& out, const Result& result)
{
  const Node_counts counts = count_nodes(result.graph);
  nlohmann::ordered_json report;
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
  report["seconds"] = {{"read", result.seconds.read},
                       {"eigenbasis", result.seconds.eigenbasis},
                       {"function", result.seconds.function},
                       {"reeb_graph", result.seconds.reeb_graph},
                       {"simplify", result.seconds.simplify},
                       {"write", result.seconds.write}};
  out << report.dump(2) << '\n';
}

// "1 arc", "2 arcs"
inline std::string counted(std::size_t number, const std::string& what)
{
  return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

inline std::size_t number_of_points(const Mesh& mesh)
{
  std::vector<Kernel::Point_3> points(mesh.points().begin(), mesh.points().end());
  std::sort(points.begin(), points.end());
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

inline void print_text(std::ostream& out, const Options& options, const Result& result)
{
  const boost::io::ios_locale_saver locale(out, std::locale::classic());
  const Node_counts counts = count_nodes(result.graph);
  const std::size_t vertices = result.mesh.number_of_vertices();
  const std::size_t points = number_of_points(result.mesh);
  out << options.mesh_file << ": " << vertices << (vertices == 1 ? " vertex" : " vertices") << ", "
      << counted(result.mesh.number_of_faces(), "face") << ", "
      << counted(result.number_of_components, "component") << ", "
      << counted(CGAL::Polygon_mesh_processing::number_of_borders(result.mesh), "border") << '\n';
  if (points < vertices)
    out << "Note: the vertices lie at " << points
        << " different points only; faces are neighbors only if they share vertices\n";
  out << "Reeb graph: " << counted(num_vertices(result.graph), "node") << ", "
      << counted(num_edges(result.graph), "arc") << ", " << counted(number_of_loops(result), "loop")
      << '\n';
  out << "Nodes: minima " << counts.minima << ", maxima " << counts.maxima << ", splits "
      << counts.splits << ", merges " << counts.merges << ", isolated " << counts.isolated
      << ", degenerate " << counts.degenerate << '\n';
  if (!result.feature_points.empty())
    out << "Feature points: " << result.feature_points.size() << '\n';
  out << "Seconds: read " << result.seconds.read << ", eigenbasis " << result.seconds.eigenbasis
      << ", function " << result.seconds.function << ", Reeb graph " << result.seconds.reeb_graph
      << ", simplify " << result.seconds.simplify << ", write " << result.seconds.write << '\n';
}

#endif // REEB_GRAPH_TOOL_REPORT_H
