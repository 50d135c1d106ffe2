#ifndef REEB_GRAPH_TOOL_REPORT_H
#define REEB_GRAPH_TOOL_REPORT_H

#include "types.h"

#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>

struct Node_counts
{
  std::size_t minima = 0, maxima = 0, splits = 0, merges = 0;
  std::size_t degenerate = 0; // and isolated ones
};

inline Node_counts count_nodes(const Graph& graph)
{
  Node_counts counts;
  for (auto node : boost::make_iterator_range(vertices(graph))) {
    switch (graph[node].type) {
    case SMRG::MINIMUM:
      ++counts.minima;
      break;
    case SMRG::MAXIMUM:
      ++counts.maxima;
      break;
    case SMRG::SPLIT_SADDLE:
      ++counts.splits;
      break;
    case SMRG::MERGE_SADDLE:
      ++counts.merges;
      break;
    default:
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
  report["degenerate"] = counts.degenerate;
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

inline void print_text(std::ostream& out, const Options& options, const Result& result)
{
  const Node_counts counts = count_nodes(result.graph);
  out << options.mesh_file << ": " << result.mesh.number_of_vertices() << " vertices, "
      << result.mesh.number_of_faces() << " faces, " << result.number_of_components
      << (result.number_of_components == 1 ? " component\n" : " components\n");
  out << "Reeb graph: " << num_vertices(result.graph) << " nodes, " << num_edges(result.graph)
      << " arcs, " << number_of_loops(result)
      << (number_of_loops(result) == 1 ? " loop\n" : " loops\n");
  out << "Nodes: minima " << counts.minima << ", maxima " << counts.maxima << ", splits "
      << counts.splits << ", merges " << counts.merges << ", degenerate " << counts.degenerate
      << '\n';
  if (!result.feature_points.empty())
    out << "Feature points: " << result.feature_points.size() << '\n';
  out << "Seconds: read " << result.seconds.read << ", eigenbasis " << result.seconds.eigenbasis
      << ", function " << result.seconds.function << ", Reeb graph " << result.seconds.reeb_graph
      << ", simplify " << result.seconds.simplify << ", write " << result.seconds.write << '\n';
}

#endif // REEB_GRAPH_TOOL_REPORT_H
