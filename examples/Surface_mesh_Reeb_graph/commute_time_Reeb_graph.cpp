#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>

#include <fstream>
#include <iostream>
#include <string>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  Mesh mesh;
  if (!(std::ifstream(filename) >> mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": no triangle mesh in the format OFF\n";
    return EXIT_FAILURE;
  }

  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1));

  for (auto node : CGAL::make_range(vertices(graph))) // it is a Boost graph, no more, no less
    std::cout << graph[node].type << ' ' << graph[node].value << " at "
              << mesh.point(graph[node].vertex) << '\n';
  for (auto arc : CGAL::make_range(edges(graph)))
    std::cout << lower_node(arc, graph) << " -- " << upper_node(arc, graph) << '\n';
}
