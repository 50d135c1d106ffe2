// The command-line tool: from a mesh file to its Reeb graph.

#include "reeb_graph_tool/compute_function.h"
#include "reeb_graph_tool/input.h"
#include "reeb_graph_tool/make_page.h"
#include "reeb_graph_tool/options.h"
#include "reeb_graph_tool/output.h"
#include "reeb_graph_tool/progress.h"
#include "reeb_graph_tool/report.h"
#include "reeb_graph_tool/types.h"
#include "reeb_graph_tool/write_page.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_curve_skeleton.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <boost/graph/connected_components.hpp>
#include <boost/program_options/errors.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Which property of the points is wanted: with VTK files, --values may name one.
Mesh_input_options input_options(const Options& options)
{
  Mesh_input_options result = options.input;
  result.property = options.values_property.empty() ? options.values_file : options.values_property;
  return result;
}

void write_pages(const Options& options,
                 const Result& result,
                 const Finest_graph& finest,
                 Progress& progress)
{
  progress.say("writing the page");
  const Page page = make_page(options, result, finest, progress);
  const auto write = [&](std::ostream& out) { write_page(out, page); };
  if (!options.html.empty())
    write_file(options.html, write, std::ios::out | std::ios::binary);
  if (!options.output.empty())
    write_file(options.output + ".html", write, std::ios::out | std::ios::binary);
}

void run(const Options& options, Result& result)
{
  Progress progress;
  timed(result.seconds.read, progress, "reading the mesh", [&]() {
    read_mesh(options.mesh_file, input_options(options), result.mesh, result.input);
  });
  progress.say("");
  print_findings(std::cerr, "reeb_graph: " + options.mesh_file, result.input);
  result.values = result.mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  result.arcs = result.mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;

  if (!options.has_values())
    compute_function(options, result, progress);
  else
    timed(result.seconds.function, progress, "reading the function", [&]() {
      if (options.values_file.empty() || result.input.has_property)
        use_property(options, result.input, result.values);
      else
        read_values(options.values_file, result.input, result.values);
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
  const bool wants_page = has_page() && !(options.output.empty() && options.html.empty());
  std::optional<Finest_graph> finest;
  if (wants_page && !is_simplified_before_levels(options))
    finest = finest_graph(result);
  timed(result.seconds.simplify, progress, "simplifying the Reeb graph", [&]() {
    SMRG::simplify_Reeb_graph(result.mesh,
                              result.values,
                              result.graph,
                              graph_parameters.persistence_threshold(options.simplify)
                                  .persistence_gap(options.gap)
                                  .threshold_is_absolute(options.threshold_is_absolute)
                                  .loop_persistence_threshold(options.close_loops)
                                  .number_of_leaves(options.leaves));
  });
  if ((!options.output.empty() || wants_page) && num_edges(result.graph) <= most_arcs_of_skeleton)
    timed(result.seconds.skeleton, progress, "computing the skeleton", [&]() {
      SMRG::compute_curve_skeleton(
          result.mesh, result.values, result.graph, result.skeleton.emplace());
    });
  timed(result.seconds.write, progress, "writing the results", [&]() {
    if (!options.output.empty())
      write_results(result, options.output);
    if (!options.diagram.empty())
      write_file(options.diagram, [&](std::ostream& out) { out << result.diagram; });
    if (wants_page)
      write_pages(options, result, finest ? *finest : finest_graph(result), progress);
  });
}

// Runs the tool, and throws what goes wrong.
int main_or_throw(int argc, char* argv[], Options& options)
{
  try {
    if (!parse_options(argc, argv, options))
      return DONE;
  } catch (const boost::program_options::error& error) {
    throw Usage_error(error.what());
  }
  if (!options.html.empty() && !has_page())
    throw Usage_error(std::string("--html: ") + how_to_get_page);
  Result result;
  run(options, result);
  if (options.json)
    print_json(std::cout, result);
  else
    print_text(std::cout, options, result);
  if (!options.json && !options.output.empty() && !has_page())
    std::cout << "Note: " << options.output << ".html is not written; " << how_to_get_page << '\n';
  std::cout.flush();
  if (!std::cout)
    throw File_error("standard output", "could not be written");
  for (const Component_failure& failure : result.failures)
    std::cerr << "reeb_graph: " << options.mesh_file << ": " << failure.text()
              << "; the function is not right there\n";
  return result.failures.empty() ? DONE : NOT_COMPUTED;
}

int main(int argc, char* argv[])
{
  Options options;
  const auto fail = [](int status, const std::string& message) {
    std::cerr << "reeb_graph: " << message << '\n';
    return status;
  };
  // what the function comes from is to blame
  const auto source = [&]() {
    return options.values_file.empty() ? options.mesh_file : options.values_file;
  };
  try {
    return main_or_throw(argc, argv, options);
  } catch (const Usage_error& error) {
    return fail(BAD_USAGE, error.what());
  } catch (const SMRG::Input_error& error) {
    return fail(BAD_INPUT, source() + ": " + error.what());
  } catch (const SMRG::Error& error) {
    return fail(NOT_COMPUTED, options.mesh_file + ": " + error.what());
  } catch (const std::bad_alloc&) {
    return fail(NOT_COMPUTED, options.mesh_file + ": there is not enough memory");
  } catch (const std::exception& error) {
    return fail(BAD_INPUT, error.what());
  }
}
