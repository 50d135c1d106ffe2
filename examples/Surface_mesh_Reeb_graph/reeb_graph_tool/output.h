#ifndef REEB_GRAPH_TOOL_OUTPUT_H
#define REEB_GRAPH_TOOL_OUTPUT_H

#include "types.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/Graphviz.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/SWC.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/VTP.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ios>
#include <limits>
#include <locale>
#include <string>

// From red through yellow, green and cyan to blue as t goes from 0 to 1, as in the figures of the
// paper.
inline CGAL::IO::Color rainbow(double t)
{
  const double hue = 4 * (std::min)((std::max)(t, 0.), 1.); // in sixths of the circle
  const auto channel = [hue](double center) {
    const double level = 2 - std::abs(hue - center);
    return static_cast<unsigned char>(std::lround(255 * (std::min)((std::max)(level, 0.), 1.)));
  };
  return CGAL::IO::Color(channel(0), channel(2), channel(4));
}

inline void color_by_value(Mesh& mesh, const Value_map& values)
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (vertex_descriptor v : mesh.vertices()) {
    if (std::isfinite(values[v])) {
      lowest = (std::min)(lowest, values[v]);
      highest = (std::max)(highest, values[v]);
    }
  }
  auto colors = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  for (vertex_descriptor v : mesh.vertices()) {
    // halves, since the difference of two finite numbers may overflow
    const double t =
        lowest < highest ? (values[v] / 2 - lowest / 2) / (highest / 2 - lowest / 2) : 0;
    colors[v] = rainbow(t);
  }
}

// The files are the same in every locale.
template <class Write>
void write_file(const std::string& file,
                const Write& write,
                std::ios::openmode mode = std::ios::out)
{
  std::ofstream out(file, mode);
  out.imbue(std::locale::classic());
  if (!out)
    throw File_error(file, "cannot be opened for writing");
  write(out);
  out.close();
  if (!out)
    throw File_error(file, "could not be written");
}

inline void write_results(Result& result, const std::string& prefix)
{
  write_file(prefix + ".values.txt", [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    for (vertex_descriptor v : result.mesh.vertices())
      out << result.values[v] << '\n';
  });
  write_file(prefix + ".graphml",
             [&](std::ostream& out) { SMRG::IO::write_GraphML(out, result.graph, result.mesh); });
  write_file(prefix + ".dot",
             [&](std::ostream& out) { SMRG::IO::write_Graphviz(out, result.graph, result.mesh); });
  write_file(prefix + ".polylines.txt", [&](std::ostream& out) {
    if (result.skeleton)
      SMRG::IO::write_polylines(out, *result.skeleton);
    else
      SMRG::IO::write_polylines(out, result.graph, result.mesh);
  });
  // a skeleton with loops has no such file: one of an earlier run would not be its own
  if (result.skeleton && SMRG::IO::is_forest(*result.skeleton))
    write_file(prefix + ".swc",
               [&](std::ostream& out) { SMRG::IO::write_SWC(out, *result.skeleton); });
  else
    std::filesystem::remove(prefix + ".swc");
  write_file(prefix + ".vtp", [&](std::ostream& out) {
    SMRG::IO::write_VTP(out, result.mesh, result.values, result.arcs);
  });
  color_by_value(result.mesh, result.values);
  write_file(
      prefix + ".ply",
      [&](std::ostream& out) {
        CGAL::IO::set_binary_mode(out);
        CGAL::IO::write_PLY(out, result.mesh);
      },
      std::ios::out | std::ios::binary);
}

#endif // REEB_GRAPH_TOOL_OUTPUT_H
