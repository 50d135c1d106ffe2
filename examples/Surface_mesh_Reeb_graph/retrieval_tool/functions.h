#ifndef RETRIEVAL_TOOL_FUNCTIONS_H
#define RETRIEVAL_TOOL_FUNCTIONS_H

#include "../reeb_graph_tool/types.h"

#include <CGAL/Surface_mesh_Reeb_graph/Geodesic_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/geodesic_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

inline double area_of(const Basis& basis)
{
  double area = 0;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    area += basis.area(c);
  return area;
}

// `name` is one of those that the options allow.
inline void
compute_function(const std::string& name, const Mesh& mesh, const Basis& basis, Value_map values)
{
  const double unit = std::sqrt(area_of(basis)); // as if the area were 1
  if (name == "height") {
    SMRG::height_function(mesh, Kernel::Vector_3(0, 0, 1), values);
    for (const vertex_descriptor v : mesh.vertices())
      values[v] /= unit;
  } else if (name == "geodesic") {
    SMRG::Geodesic_distances<Mesh> geodesics(mesh);
    SMRG::integral_geodesic_distance_function(geodesics, values);
    for (const vertex_descriptor v : mesh.vertices())
      values[v] /= unit * unit * unit;
  } else if (name == "auto_diffusion") {
    // divided by its mean, at a time that lets details go
    SMRG::heat_kernel_signature(basis, 0.1, values);
  } else {
    std::vector<vertex_descriptor> points;
    SMRG::feature_points(basis, std::back_inserter(points));
    SMRG::commute_time_function(basis, points, values);
  }
}

#endif // RETRIEVAL_TOOL_FUNCTIONS_H
