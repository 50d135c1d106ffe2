// The command-line tool: from a mesh file to its Reeb graph.

#include "reeb_graph_tool/input.h"
#include "reeb_graph_tool/options.h"
#include "reeb_graph_tool/output.h"
#include "reeb_graph_tool/report.h"
#include "reeb_graph_tool/types.h"

#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

// Shows what is being done, while it is done, to somebody who watches.
class Progress
{
public:
  ~Progress() { say(""); }

  void say(const std::string& text)
  {
#if defined(__unix__) || defined(__APPLE__)
    if (isatty(STDERR_FILENO))
      std::cerr << "\r\033[K" << text << std::flush;
#endif
  }
};

template <class Work>
void timed(double& seconds, Progress& progress, const std::string& text, const Work& work)
{
  progress.say(text);
  CGAL::Real_timer timer;
  timer.start();
  work();
  seconds = timer.time();
}

void compute_function(const Options& options, Result& result, Progress& progress)
{
  if (!options.values_file.empty() || options.function == "height") {
    timed(result.seconds.function, progress, "reading or computing the function", [&]() {
      if (!options.values_file.empty())
        read_values(options.values_file, result.mesh, result.values);
      else
        SMRG::height_function(result.mesh,
                              Kernel::Vector_3(options.axis[0], options.axis[1], options.axis[2]),
                              result.values);
    });
    return;
  }

  const bool is_eigenfunction = options.function == "eigenfunction";
  if (is_eigenfunction && std::size_t(options.index) >= result.mesh.number_of_vertices())
    throw File_error(options.mesh_file,
                     "--index: the mesh has " + std::to_string(result.mesh.number_of_vertices()) +
                         " vertices, so that there is no eigenfunction " +
                         std::to_string(options.index));
  std::unique_ptr<SMRG::Laplace_Beltrami_eigenbasis<Mesh>> basis;
  timed(result.seconds.eigenbasis, progress, "computing the eigenbasis", [&]() {
    basis = std::make_unique<SMRG::Laplace_Beltrami_eigenbasis<Mesh>>(
        result.mesh,
        SMRG::parameters::number_of_eigenpairs(is_eigenfunction ? options.index
                                                                : options.eigenpairs));
  });
  std::size_t largest_index = 0;
  for (std::size_t c = 0; c < basis->number_of_components(); ++c) {
    largest_index = (std::max)(largest_index, basis->number_of_eigenpairs(c));
    result.eigenvalues.emplace_back();
    for (std::size_t k = 1; k <= basis->number_of_eigenpairs(c); ++k)
      result.eigenvalues.back().push_back(basis->eigenvalue(c, k));
  }
  // components are smaller than the mesh
  if (is_eigenfunction && static_cast<std::size_t>(options.index) > largest_index)
    throw File_error(options.mesh_file,
                     "--index: no component of the mesh has an eigenfunction " +
                         std::to_string(options.index) + "; the last one is " +
                         std::to_string(largest_index));
  timed(result.seconds.function, progress, "computing the function", [&]() {
    if (is_eigenfunction) {
      SMRG::eigenfunction(*basis, static_cast<std::size_t>(options.index), result.values);
    } else {
      SMRG::feature_points(
          *basis,
          std::back_inserter(result.feature_points),
          SMRG::parameters::small_time(options.small_time).large_time(options.large_time));
      SMRG::commute_time_function(*basis, result.feature_points, result.values);
    }
  });
}

void run(const Options& options, Result& result)
{
  Progress progress;
  timed(result.seconds.read, progress, "reading the mesh", [&]() {
    result.mesh = read_mesh(options.mesh_file);
  });
  result.values = result.mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  result.arcs = result.mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;

  compute_function(options, result, progress);
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
