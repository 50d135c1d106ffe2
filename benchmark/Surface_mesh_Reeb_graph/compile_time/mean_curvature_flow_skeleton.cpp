// CGAL's mean curvature flow skeleton of a mesh as polylines: what the compile time of the README's
// program is compared with.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <fstream>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;

struct Print_polylines
{
  const Skeleton& skeleton;

  void start_new_polyline() {}
  void add_node(boost::graph_traits<Skeleton>::vertex_descriptor v)
  {
    std::cout << skeleton[v].point << ' ';
  }
  void end_polyline() { std::cout << '\n'; }
};

int main(int, char* argv[])
{
  Mesh mesh;
  std::ifstream(argv[1]) >> mesh;
  Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  Print_polylines print{skeleton};
  CGAL::split_graph_into_polylines(skeleton, print);
}
