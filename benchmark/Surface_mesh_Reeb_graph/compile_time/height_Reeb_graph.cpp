// The Reeb graph of the height function and nothing else.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <fstream>
#include <iostream>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int, char* argv[])
{
  Mesh mesh;
  std::ifstream(argv[1]) >> mesh;
  auto heights = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for (const auto v : mesh.vertices())
    heights[v] = mesh.point(v).z();
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(mesh, heights, graph);
  for (const auto node : CGAL::make_range(vertices(graph)))
    std::cout << graph[node].type << ' ' << graph[node].value << '\n';
}
