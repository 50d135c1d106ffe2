// The arcs of the vertices as a segmentation of the shape, written as a colored PLY file.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <fstream>
#include <iostream>
#include <string>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return EXIT_FAILURE;
  }

  auto arcs = mesh.add_property_map<Mesh::Vertex_index, int>("v:arc").first;
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(
      mesh,
      graph,
      SMRG::parameters::persistence_threshold(0.1).vertex_arc_map(arcs).collect_arc_vertices(true));

  for (const auto arc : CGAL::make_range(edges(graph)))
    std::cout << "arc " << graph[arc].id << ": " << graph[arc].vertices.size() << " vertices\n";

  const std::array<CGAL::IO::Color, 6> palette = {CGAL::IO::Color(228, 26, 28),
                                                  CGAL::IO::Color(55, 126, 184),
                                                  CGAL::IO::Color(77, 175, 74),
                                                  CGAL::IO::Color(152, 78, 163),
                                                  CGAL::IO::Color(255, 127, 0),
                                                  CGAL::IO::Color(255, 217, 47)};
  auto colors = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (arcs[v] >= 0) // isolated vertices have no arc
      colors[v] = palette[static_cast<std::size_t>(arcs[v]) % palette.size()];
  std::ofstream out("arc_segmentation.ply");
  return CGAL::IO::write_PLY(out, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
