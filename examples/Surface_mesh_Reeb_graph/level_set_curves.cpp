// The curves along which a surface can be cut at the saddles of its height, written as polylines.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return EXIT_FAILURE;
  }

  auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  SMRG::height_function(mesh, Kernel::Vector_3(1, 0, 0), height);
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(mesh, height, graph);

  // made once; every curve then takes the time to walk along it
  const SMRG::Level_set_components components(mesh, height);
  std::vector<SMRG::Level_set_component<Mesh>> curves;
  for (const auto node : CGAL::make_range(vertices(graph))) {
    if (graph[node].type == SMRG::Reeb_node_type::MERGE_SADDLE)
      components.below(graph[node].vertex, std::back_inserter(curves));
    else if (graph[node].type == SMRG::Reeb_node_type::SPLIT_SADDLE)
      components.above(graph[node].vertex, std::back_inserter(curves));
  }

  std::ofstream out("level_set_curves.polylines.txt");
  out.precision(17);
  for (const auto& curve : curves) {
    const std::vector<Mesh::Point> points = components.polyline(curve);
    out << points.size();
    for (const Mesh::Point& p : points)
      out << ' ' << p;
    out << '\n';
    std::cout << (curve.is_closed ? "closed" : "open") << " curve of " << points.size()
              << " points\n";
  }
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
