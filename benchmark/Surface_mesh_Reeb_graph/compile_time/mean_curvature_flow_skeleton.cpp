// CGAL's mean curvature flow skeleton of a mesh: what the compile time of the README's program is
// compared with.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <fstream>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<Mesh>;

int main(int, char* argv[])
{
  Mesh mesh;
  std::ifstream(argv[1]) >> mesh;
  Skeletonization::Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  for (const auto v : CGAL::make_range(vertices(skeleton)))
    std::cout << skeleton[v].point << '\n';
}
