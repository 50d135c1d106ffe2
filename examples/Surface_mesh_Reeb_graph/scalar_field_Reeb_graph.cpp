// The Reeb graph of a scalar function of one's own: here the distance from an axis.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>
#include <string>

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

  // any property map from vertices to numbers is a scalar field
  auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    values[v] = std::hypot(mesh.point(v).y(), mesh.point(v).z());

  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(mesh, values, graph);

  for (const auto node : CGAL::make_range(vertices(graph)))
    std::cout << graph[node].type << " of value " << graph[node].value << " at "
              << mesh.point(graph[node].vertex) << '\n';
  for (const auto arc : CGAL::make_range(edges(graph)))
    std::cout << lower_node(arc, graph) << " - " << upper_node(arc, graph) << '\n';
  return EXIT_SUCCESS;
}
