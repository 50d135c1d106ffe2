#ifndef MESH_INPUT_READERS_H
#define MESH_INPUT_READERS_H

#include "Polygon_soup.h"

#include <string>
#include <string_view>

// One reader for each format: from the bytes of a file to an empty polygon soup. Every number of a
// point in a polygon is in range afterwards, every coordinate is finite, and every polygon has three
// corners or more; otherwise a Content_error says what is wrong where. The time is linear in the
// number of bytes, and so is the memory, whatever numbers of elements a file announces.

// The OFF family of Geomview: attributes of the vertices (C, N, ST, 4) and colors of the faces are
// passed over; binary files, too. A fourth coordinate is the denominator of the others.
void read_OFF(std::string_view bytes, Polygon_soup& soup);

// Wavefront OBJ: the elements v and f; all others are passed over.
void read_OBJ(std::string_view bytes, Polygon_soup& soup);

// PLY, as text or binary: x, y and z of the vertices and the lists of vertices of the faces, or
// triangle strips. `property` names the scalar property of the vertices that is wanted; it may be empty.
void read_PLY(std::string_view bytes, const std::string& property, Polygon_soup& soup);

// STL, as text or binary. Corners at exactly the same place are one point; the points are numbered as
// they are met first.
void read_STL(std::string_view bytes, Polygon_soup& soup);

// The polygons and triangle strips of VTK's legacy files of polydata, as text or binary; `property` names
// the array of one component at the points that is wanted.
void read_legacy_VTK(std::string_view bytes, const std::string& property, Polygon_soup& soup);

// The same of VTK's XML files, by VTK's reader. Defined only where the program is built with VTK.
void read_VTP(std::string_view bytes, const std::string& property, Polygon_soup& soup);

#endif // MESH_INPUT_READERS_H
