#ifndef MESH_INPUT_READ_MESH_H
#define MESH_INPUT_READ_MESH_H

#include "Polygon_soup.h"
#include "build_mesh.h"
#include "errors.h"
#include "prepare_polygon_soup.h"

#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

// Reads a triangle mesh from a file, repaired where that is needed, into an empty mesh. What is not
// obvious from the mesh is in `input`. Throws File_error.
template <class Point>
void read_mesh(const std::string& file,
               const Mesh_input_options& options,
               CGAL::Surface_mesh<Point>& mesh,
               Mesh_input& input)
{
  const Polygon_soup soup = read_repaired_triangles(file, options, input);
  build_mesh(soup, mesh);
}

#endif // MESH_INPUT_READ_MESH_H
