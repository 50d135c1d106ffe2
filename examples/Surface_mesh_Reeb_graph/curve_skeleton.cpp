// A curve skeleton inside of a shape, and what code for CGAL's mean curvature flow skeleton does with
// it: its polylines, and a segmentation of the shape by the distances of the surface from it.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/SWC.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_curve_skeleton.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeleton = SMRG::Curve_skeleton<Mesh>;

// A visitor as the examples of CGAL's skeletons have it.
struct Longest_polyline
{
  std::size_t number_of_polylines = 0, longest = 0, current = 0;

  void start_new_polyline() { current = 0; }
  void add_node(boost::graph_traits<Skeleton>::vertex_descriptor) { ++current; }
  void end_polyline()
  {
    ++number_of_polylines;
    longest = (std::max)(longest, current);
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return EXIT_FAILURE;
  }

  auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::commute_time_Reeb_graph(
      mesh,
      graph,
      SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values).collect_arc_vertices(
          true));
  Skeleton skeleton;
  SMRG::compute_curve_skeleton(mesh, values, graph, skeleton);

  std::size_t outside = 0;
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    outside += skeleton[edge].is_inside ? 0 : 1;
  std::cout << num_vertices(skeleton) << " points, " << outside << " segments not inside\n";
  SMRG::IO::write_polylines("curve_skeleton.polylines.txt", skeleton);
  if (SMRG::IO::is_forest(skeleton))
    SMRG::IO::write_SWC("curve_skeleton.swc", skeleton);

  Longest_polyline visitor;
  CGAL::split_graph_into_polylines(skeleton, visitor);
  std::cout << visitor.number_of_polylines << " polylines, the longest of " << visitor.longest
            << " points\n";

  // the distance from the skeleton in place of the shape's diameter
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  for (const auto point : CGAL::make_range(vertices(skeleton)))
    for (const Mesh::Vertex_index v : skeleton[point].vertices)
      distance[v] = std::sqrt(CGAL::squared_distance(skeleton[point].point, mesh.point(v)));
  auto diameter = mesh.add_property_map<Mesh::Face_index, double>("f:diameter").first;
  for (const Mesh::Face_index f : mesh.faces()) {
    for (const Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      diameter[f] += distance[v] / 3;
  }
  CGAL::sdf_values_postprocessing(mesh, diameter);
  auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  std::cout << CGAL::segmentation_from_sdf_values(mesh, diameter, segment) << " segments\n";

  const std::array<CGAL::IO::Color, 6> palette = {CGAL::IO::Color(228, 26, 28),
                                                  CGAL::IO::Color(55, 126, 184),
                                                  CGAL::IO::Color(77, 175, 74),
                                                  CGAL::IO::Color(152, 78, 163),
                                                  CGAL::IO::Color(255, 127, 0),
                                                  CGAL::IO::Color(255, 217, 47)};
  auto colors = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (const Mesh::Face_index f : mesh.faces())
    colors[f] = palette[segment[f] % palette.size()];
  std::ofstream out("curve_skeleton.ply");
  return CGAL::IO::write_PLY(out, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
