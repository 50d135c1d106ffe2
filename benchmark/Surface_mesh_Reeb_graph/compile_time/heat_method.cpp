// CGAL's geodesic distances on a mesh: what the compile time of compute_Reeb_graph() is compared
// with.

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <fstream>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int, char* argv[])
{
  Mesh mesh;
  std::ifstream(argv[1]) >> mesh;
  auto distances = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distances, *mesh.vertices().begin());
  for (const auto v : mesh.vertices())
    std::cout << distances[v] << '\n';
}
