#ifndef RETRIEVAL_TOOL_FUNCTIONS_H
#define RETRIEVAL_TOOL_FUNCTIONS_H

#include "../reeb_graph_tool/types.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

using Basis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

inline double area_of(const Basis& basis)
{
  double area = 0;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    area += basis.area(c);
  return area;
}

// The lengths of the shortest paths of edges.
inline std::vector<double> edge_distances(const Mesh& mesh, vertex_descriptor source)
{
  using Entry = std::pair<double, vertex_descriptor>;
  std::vector<double> distances(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distances[source] = 0;
  queue.emplace(0., source);
  while (!queue.empty()) {
    const Entry next = queue.top();
    queue.pop();
    if (next.first > distances[next.second])
      continue;
    for (const vertex_descriptor w : vertices_around_target(mesh.halfedge(next.second), mesh)) {
      const double distance =
          next.first + std::sqrt(CGAL::squared_distance(mesh.point(next.second), mesh.point(w)));
      if (distance < distances[w]) {
        distances[w] = distance;
        queue.emplace(distance, w);
      }
    }
  }
  return distances;
}

// The mean distance from 32 vertices that are far from each other, along edges; infinite distances
// between components count as 0.
inline void geodesic_function(const Mesh& mesh, double unit, Value_map values)
{
  constexpr int number_of_sources = 32;
  const std::size_t n = mesh.number_of_vertices();
  std::vector<double> nearest(n, std::numeric_limits<double>::infinity()), sum(n, 0.);
  vertex_descriptor source(0);
  for (int i = 0; i <= number_of_sources; ++i) {
    const std::vector<double> distances = edge_distances(mesh, source);
    if (i == 0) { // the first vertex only leads to one at an end of the shape
      nearest = distances;
    } else {
      for (std::size_t v = 0; v < n; ++v) {
        nearest[v] = i == 1 ? distances[v] : (std::min)(nearest[v], distances[v]);
        if (std::isfinite(distances[v]))
          sum[v] += distances[v];
      }
    }
    source = vertex_descriptor(static_cast<Mesh::size_type>(
        std::max_element(nearest.begin(), nearest.end()) - nearest.begin()));
  }
  for (const vertex_descriptor v : mesh.vertices())
    values[v] = sum[v] / number_of_sources / unit;
}

// The auto-diffusion function (Gebal et al. 2009) at a tenth of the time of the first eigenvalue,
// divided by its mean over the component.
inline void auto_diffusion_function(const Mesh& mesh, const Basis& basis, Value_map values)
{
  constexpr double time = 0.1;
  for (const vertex_descriptor v : mesh.vertices()) {
    const std::size_t c = basis.component(v);
    double sum = 0, mean = 0;
    for (std::size_t k = 1; k <= basis.number_of_eigenpairs(c); ++k) {
      const double factor = std::exp(-time * basis.eigenvalue(c, k) / basis.eigenvalue(c, 1));
      sum += factor * basis.eigenfunction(k, v) * basis.eigenfunction(k, v);
      mean += factor / basis.area(c);
    }
    values[v] = mean > 0 ? sum / mean : 0;
  }
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
    geodesic_function(mesh, unit, values);
  } else if (name == "auto_diffusion") {
    auto_diffusion_function(mesh, basis, values);
  } else {
    std::vector<vertex_descriptor> points;
    SMRG::feature_points(basis, std::back_inserter(points));
    SMRG::commute_time_function(basis, points, values);
  }
}

#endif // RETRIEVAL_TOOL_FUNCTIONS_H
