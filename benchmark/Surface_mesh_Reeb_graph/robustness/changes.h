// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The changes that are made of every mesh: a new one is a line in the table at the end.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_CHANGES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_CHANGES_H

#include "topology_changes.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace Robustness {

inline Vector random_direction(std::mt19937& rng)
{
  std::normal_distribution<> normal;
  const double x = normal(rng), y = normal(rng), z = normal(rng);
  return Vector(x, y, z) / std::hypot(x, y, z);
}

// Every vertex moves in a direction of its own, by at most a fraction of the diagonal.
inline Mesh random_noise(Mesh mesh, const double fraction, std::mt19937& rng)
{
  const double amplitude = fraction * diagonal(mesh);
  std::uniform_real_distribution<> length(0, amplitude);
  for (Point& p : mesh.points())
    p = p + length(rng) * random_direction(rng);
  return mesh;
}

// Four waves, of a third to the half of the diagonal, that move by a fraction of it together.
inline Mesh smooth_noise(Mesh mesh, const double fraction, std::mt19937& rng)
{
  constexpr int number_of_waves = 4;
  const double length = diagonal(mesh);
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for (int i = 0; i < number_of_waves; ++i) {
    const double wave_length = std::uniform_real_distribution<>(length / 3, length / 2)(rng),
                 phase = std::uniform_real_distribution<>(0, 2 * CGAL_PI)(rng);
    const Vector along = random_direction(rng), shift = random_direction(rng);
    for (const Vertex v : mesh.vertices())
      mesh.point(v) =
          mesh.point(v) +
          fraction * length / number_of_waves *
              std::sin(2 * CGAL_PI * (points[v] - CGAL::ORIGIN) * along / wave_length + phase) *
              shift;
  }
  return mesh;
}

inline Mesh decimated(Mesh mesh, const double share)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  SMS::edge_collapse(mesh, SMS::Count_ratio_stop_predicate<Mesh>(share));
  mesh.collect_garbage();
  return mesh;
}

inline Mesh subdivided(Mesh mesh)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  mesh.collect_garbage();
  return mesh;
}

inline Mesh remeshed(Mesh mesh)
{
  double length = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    length += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh),
                                                     1.2 * length / double(mesh.number_of_edges()),
                                                     mesh,
                                                     CGAL::parameters::number_of_iterations(2));
  mesh.collect_garbage();
  return mesh;
}

inline Mesh scaled(Mesh mesh)
{
  CGAL::Polygon_mesh_processing::transform(CGAL::Aff_transformation_3<Kernel>(CGAL::SCALING, 1000),
                                           mesh);
  return mesh;
}

// Turned by an angle about each axis, and shifted by three diagonals.
inline Mesh moved(Mesh mesh)
{
  const double c = std::cos(0.7), s = std::sin(0.7), far = 3 * diagonal(mesh);
  const CGAL::Aff_transformation_3<Kernel> x(1, 0, 0, far, 0, c, -s, 0, 0, s, c, 0),
      y(c, 0, s, 0, 0, 1, 0, far, -s, 0, c, 0), z(c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, far);
  CGAL::Polygon_mesh_processing::transform(z * y * x, mesh);
  return mesh;
}

// A quarter of the longest axis of the box is cut off.
inline Mesh cut(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  int axis = 0;
  for (const int i : {1, 2})
    if (box.max(i) - box.min(i) > box.max(axis) - box.min(axis))
      axis = i;
  const double height = 0.75 * box.max(axis) + 0.25 * box.min(axis);
  return clipped(mesh,
                 Point(height, height, height),
                 Vector(axis == 0 ? -1 : 0, axis == 1 ? -1 : 0, axis == 2 ? -1 : 0));
}

// Holes and cuts make loops: where two borders lie at one height, a level set that was a closed curve
// is two.
constexpr int any_number = -1;

struct Change
{
  std::string name;
  int number_of_new_loops;
  bool keeps_values; // up to rounding, for functions that do not depend on the pose
  std::function<Mesh(const Mesh&, std::mt19937&)> make;
};

inline const std::vector<Change>& changes()
{
  using RNG = std::mt19937;
  static const std::vector<Change> result = {
      {"scale", 0, true, [](const Mesh& m, RNG&) { return scaled(m); }},
      {"rigid motion", 0, true, [](const Mesh& m, RNG&) { return moved(m); }},
      {"random noise 0.1 %",
       0,
       false,
       [](const Mesh& m, RNG& r) { return random_noise(m, 0.001, r); }},
      {"random noise 0.5 %",
       0,
       false,
       [](const Mesh& m, RNG& r) { return random_noise(m, 0.005, r); }},
      {"random noise 2 %",
       0,
       false,
       [](const Mesh& m, RNG& r) { return random_noise(m, 0.02, r); }},
      {"smooth noise 0.5 %",
       0,
       false,
       [](const Mesh& m, RNG& r) { return smooth_noise(m, 0.005, r); }},
      {"smooth noise 2 %",
       0,
       false,
       [](const Mesh& m, RNG& r) { return smooth_noise(m, 0.02, r); }},
      {"decimated to 50 %", 0, false, [](const Mesh& m, RNG&) { return decimated(m, 0.5); }},
      {"decimated to 20 %", 0, false, [](const Mesh& m, RNG&) { return decimated(m, 0.2); }},
      {"Loop subdivision", 0, false, [](const Mesh& m, RNG&) { return subdivided(m); }},
      {"remeshed", 0, false, [](const Mesh& m, RNG&) { return remeshed(m); }},
      {"30 % of faces split",
       0,
       false,
       [](const Mesh& m, RNG& r) { return with_split_faces(m, 0.3, r); }},
      {"plane cut", any_number, false, [](const Mesh& m, RNG&) { return cut(m); }},
      {"8 holes",
       any_number,
       false,
       [](const Mesh& m, RNG& r) { return with_holes(m, 8, 0.01 * diagonal(m), r); }},
      {"small handle",
       1,
       false,
       [](const Mesh& m, RNG& r) { return with_tube(m, neighbors(m, r)); }},
      {"contact merged", 1, false, [](const Mesh& m, RNG&) { return with_tube(m, contact(m)); }},
  };
  return result;
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_CHANGES_H
