// The height function of an icosahedron: one minimum, one maximum, one arc.

#include <CGAL/surface_mesh_Reeb_graph.h>

#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_LAPLACE_BELTRAMI_EIGENBASIS_H
#error "the header for Reeb graphs of given functions includes the spectral half"
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1.);

  auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for (auto v : mesh.vertices())
    height[v] = mesh.point(v).x() + 0.1 * mesh.point(v).y() + 0.01 * mesh.point(v).z();

  CGAL::Surface_mesh_Reeb_graph::Reeb_graph<Mesh> graph;
  CGAL::Surface_mesh_Reeb_graph::compute_Reeb_graph(mesh, height, graph);
  return num_vertices(graph) == 2 && num_edges(graph) == 1 ? 0 : 1;
}
