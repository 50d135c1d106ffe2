// The persistence pairs of a Reeb graph: which of its branches and loops are features and which are
// noise. The diagram is written to a file that GUDHI reads.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Graph = SMRG::Reeb_graph<Mesh>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return EXIT_FAILURE;
  }
  auto heights = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    heights[v] = mesh.point(v).y();

  Graph graph;
  SMRG::compute_Reeb_graph(mesh, heights, graph);

  std::vector<SMRG::Persistence_pair<Graph>> pairs;
  SMRG::persistence_pairs(graph, std::back_inserter(pairs));
  for (const auto& pair : pairs)
    std::cout << graph[pair.birth].type << ' ' << pair.birth << " and " << graph[pair.death].type
              << ' ' << pair.death << ": " << pair.persistence() << '\n';

  // a diagram may also be written to a stream
  const std::string diagram = argc > 2 ? argv[2] : "persistence_diagram.pers";
  if (!SMRG::IO::write_persistence_diagram(diagram, graph)) {
    std::cerr << diagram << ": cannot be written\n";
    return EXIT_FAILURE;
  }

  // the four extrema that matter most, and no loops but large ones
  SMRG::simplify_Reeb_graph(
      mesh, heights, graph, SMRG::parameters::number_of_leaves(4).loop_persistence_threshold(0.05));
  std::cout << num_vertices(graph) << " nodes and " << num_edges(graph) << " arcs are left\n";
  return EXIT_SUCCESS;
}
