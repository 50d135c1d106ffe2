#ifndef MESH_INPUT_PREPARE_POLYGON_SOUP_H
#define MESH_INPUT_PREPARE_POLYGON_SOUP_H

#include "Polygon_soup.h"
#include "repair_polygon_soup.h"

#include <cstddef>
#include <string>
#include <vector>

struct Mesh_input_options
{
  std::string property; // of the points, that is wanted; may be empty
  Repair_options repair;
  bool is_strict = false; // what would be repaired or passed over is an error
};

// What is known of a mesh besides itself.
struct Mesh_input
{
  std::size_t number_of_points = 0;         // in the file
  std::vector<std::size_t> point_of_vertex; // numbers in the file
  bool has_property = false;
  std::vector<double> property; // of the points in the file
  std::vector<std::string> property_names;
  std::vector<Repair> repairs;
  std::vector<std::string> notices;
};

// Makes triangles of a polygon soup, which are an oriented 2-manifold; throws Content_error.
void prepare_polygon_soup(Polygon_soup& soup, const Mesh_input_options& options, Mesh_input& input);

// Reads a file and does the same; throws File_error.
Polygon_soup read_repaired_triangles(const std::string& file,
                                     const Mesh_input_options& options,
                                     Mesh_input& input);

// The same with the bytes of a file whose name ends in `extension`; throws Content_error.
Polygon_soup parse_repaired_triangles(const std::string& bytes,
                                      const std::string& extension,
                                      const Mesh_input_options& options,
                                      Mesh_input& input);

#endif // MESH_INPUT_PREPARE_POLYGON_SOUP_H
