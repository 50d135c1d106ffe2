#ifndef MESH_INPUT_READ_POLYGON_SOUP_H
#define MESH_INPUT_READ_POLYGON_SOUP_H

#include "Polygon_soup.h"

#include <string>
#include <string_view>

// The names of the formats that can be read, for messages: "OFF, OBJ, PLY and STL".
std::string readable_formats();

// Whether the end of a name is one of a format that can be read. `has_properties` tells whether points
// have properties in that format.
bool has_readable_format(const std::string& file);
bool format_has_properties(const std::string& file);

// Reads a mesh from the bytes of a file whose name ends in `extension`, such as ".off"; throws
// Content_error. See readers.h for what is checked, and what `property` is.
Polygon_soup
parse_polygon_soup(std::string_view bytes, std::string extension, const std::string& property = "");

// Reads a mesh file; throws File_error.
Polygon_soup read_polygon_soup(const std::string& file, const std::string& property = "");

// The bytes of a file; throws File_error.
std::string read_bytes(const std::string& file);

#endif // MESH_INPUT_READ_POLYGON_SOUP_H
