#ifndef MESH_INPUT_POLYGON_SOUP_H
#define MESH_INPUT_POLYGON_SOUP_H

#include "errors.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Points, and polygons that name them by their numbers. The points are in the order of the file,
// and stay so: values that users have belong to them.
struct Polygon_soup
{
  std::vector<std::array<double, 3>> points;

  // The corners of all polygons one after the other; those of polygon i are [first[i], first[i + 1]).
  std::vector<std::size_t> corners;
  std::vector<std::size_t> first = {0};

  // One value per point of the property that was asked for, if there is one of that name.
  bool has_property = false;
  std::vector<double> property;
  std::vector<std::string> property_names; // that could have been asked for

  // What is in the file, or should be, and has been passed over: one sentence each.
  std::vector<std::string> notices;

  std::size_t number_of_polygons() const { return first.size() - 1; }
  std::size_t size(std::size_t polygon) const { return first[polygon + 1] - first[polygon]; }
  void end_polygon() { first.push_back(corners.size()); }
};

// Throws a Content_error if a polygon names a point that is not there.
inline void check_corners(const Polygon_soup& soup)
{
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    for (std::size_t k = soup.first[i]; k < soup.first[i + 1]; ++k)
      if (soup.corners[k] >= soup.points.size())
        throw Content_error(
            no_such_vertex({"face", i}, std::to_string(soup.corners[k]), soup.points.size()));
}

#endif // MESH_INPUT_POLYGON_SOUP_H
