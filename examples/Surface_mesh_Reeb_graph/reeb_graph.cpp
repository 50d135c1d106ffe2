// The command-line tool: from a mesh file to its Reeb graph.

#include "reeb_graph_tool/compute_function.h"
#include "reeb_graph_tool/input.h"
#include "reeb_graph_tool/options.h"
#include "reeb_graph_tool/output.h"
#include "reeb_graph_tool/progress.h"
#include "reeb_graph_tool/report.h"
#include "reeb_graph_tool/types.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <boost/graph/connected_components.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

void run(const Options& options, Result& result)
{
  Progress progress;
  timed(result.seconds.read, progress, "reading the mesh", [&]() {
    result.mesh = read_mesh(options.mesh_file);
  });
  result.values = result.mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  result.arcs = result.mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;

  if (options.values_file.empty())
    compute_function(options, result, progress);
  else
    timed(result.seconds.function, progress, "reading the function", [&]() {
      read_values(options.values_file, result.mesh, result.values);
    });
  const auto graph_parameters = SMRG::parameters::vertex_arc_map(result.arcs)
                                    .collect_arc_vertices(true)
                                    .unfold_multiple_saddles(options.unfold);
  timed(result.seconds.reeb_graph, progress, "computing the Reeb graph", [&]() {
    SMRG::compute_Reeb_graph(result.mesh, result.values, result.graph, graph_parameters);
  });
  std::vector<std::size_t> components(num_vertices(result.graph));
  result.number_of_components =
      static_cast<std::size_t>(boost::connected_components(result.graph, components.data()));
  if (!options.diagram.empty()) {
    std::ostringstream diagram;
    SMRG::IO::write_persistence_diagram(diagram, result.graph);
    result.diagram = diagram.str();
  }
  timed(result.seconds.simplify, progress, "simplifying the Reeb graph", [&]() {
    SMRG::simplify_Reeb_graph(result.mesh,
                              result.values,
                              result.graph,
                              graph_parameters.persistence_threshold(options.simplify)
                                  .persistence_gap(options.gap)
                                  .loop_persistence_threshold(options.close_loops)
                                  .number_of_leaves(options.leaves));
  });
  timed(result.seconds.write, progress, "writing the results", [&]() {
    if (!options.output.empty())
      write_results(result, options.output);
    if (!options.diagram.empty())
      write_file(options.diagram, [&](std::ostream& out) { out << result.diagram; });
  });
}

int main(int argc, char* argv[])
{
  Options options;
  try {
    if (!parse_options(argc, argv, options))
      return EXIT_SUCCESS;
    Result result;
    try {
      run(options, result);
    } catch (const SMRG::Error& error) {
      throw File_error(options.values_file.empty() ? options.mesh_file : options.values_file,
                       error.what());
    }
    if (options.json)
      print_json(std::cout, result);
    else
      print_text(std::cout, options, result);
  } catch (const std::bad_alloc&) {
    std::cerr << "reeb_graph: " << options.mesh_file << ": there is not enough memory\n";
    return EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << "reeb_graph: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cout.flush();
  return std::cout ? EXIT_SUCCESS : EXIT_FAILURE;
}
