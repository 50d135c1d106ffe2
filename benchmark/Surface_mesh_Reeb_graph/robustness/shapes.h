// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes of the robustness benchmark: a folder of families, each a folder of meshes.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SHAPES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SHAPES_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace Robustness {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Values = std::vector<double>; // by vertex

struct Shape
{
  std::string family, name;
  Mesh mesh;
};

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// The subfolders of a folder, or those of some names. Files that hold no triangle mesh are reported
// and left out.
inline std::vector<Shape>
read_shapes(const std::filesystem::path& folder, const std::set<std::string>& families)
{
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const fs::directory_entry& family : fs::directory_iterator(folder))
    if (family.is_directory() &&
        (families.empty() || families.count(family.path().filename().string()) != 0))
      for (const fs::directory_entry& file : fs::directory_iterator(family))
        if (std::set<std::string>{".off", ".obj", ".ply"}.count(file.path().extension().string()) !=
            0)
          files.push_back(file.path());
  std::sort(files.begin(), files.end());
  std::vector<Shape> shapes;
  for (const fs::path& file : files) {
    Shape shape{file.parent_path().filename().string(), file.stem().string(), Mesh()};
    if (CGAL::IO::read_polygon_mesh(file.string(), shape.mesh) && !is_empty(shape.mesh) &&
        CGAL::is_triangle_mesh(shape.mesh))
      shapes.push_back(std::move(shape));
    else
      std::cerr << file << " is left out: no triangle mesh\n";
  }
  return shapes;
}

// Whether vertices of the same number correspond: the faces are the same.
inline bool have_same_faces(const Mesh& a, const Mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices() ||
      a.number_of_faces() != b.number_of_faces())
    return false;
  return std::equal(
      a.faces().begin(), a.faces().end(), b.faces().begin(), [&](const Face f, const Face g) {
        const auto corners = [](const Mesh& mesh, const Face face) {
          std::set<std::size_t> result;
          for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
            result.insert(v);
          return result;
        };
        return corners(a, f) == corners(b, g);
      });
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_SHAPES_H
