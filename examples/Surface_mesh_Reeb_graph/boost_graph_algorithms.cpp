// A Reeb graph is a Boost graph: its loops, the way between two tips, and whether the graphs of two
// shapes are the same.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/isomorphism.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Graph = SMRG::Reeb_graph<Mesh>;
using Node = boost::graph_traits<Graph>::vertex_descriptor;
using Arc = boost::graph_traits<Graph>::edge_descriptor;

bool read(const std::string& filename, Mesh& mesh, Graph& graph)
{
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return false;
  }
  SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1));
  return true;
}

int main(int argc, char* argv[])
{
  // two poses of a shape; one is compared with itself
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  Mesh mesh, other_mesh;
  Graph graph, other_graph;
  if (!read(filename, mesh, graph) || !read(argc > 2 ? argv[2] : filename, other_mesh, other_graph))
    return EXIT_FAILURE;

  std::vector<int> component(num_vertices(graph));
  const int components = boost::connected_components(graph, component.data());
  std::cout << "loops: " << num_edges(graph) + components - num_vertices(graph) << '\n';

  // the shortest path between the highest and the second highest tip, arcs being as long as the
  // difference of their values
  std::vector<Node> tips;
  for (const Node node : CGAL::make_range(vertices(graph)))
    if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM)
      tips.push_back(node);
  if (tips.size() >= 2) {
    const auto length = boost::make_function_property_map<Arc>([&graph](Arc arc) {
      return graph[upper_node(arc, graph)].value - graph[lower_node(arc, graph)].value;
    });
    std::vector<double> distance(num_vertices(graph));
    boost::dijkstra_shortest_paths(
        graph, tips.back(), boost::weight_map(length).distance_map(distance.data()));
    std::cout << "from tip to tip: " << distance[tips[tips.size() - 2]] << '\n';
  }

  std::cout << "the graphs are " << (boost::isomorphism(graph, other_graph) ? "" : "not ")
            << "isomorphic\n";
  return EXIT_SUCCESS;
}
