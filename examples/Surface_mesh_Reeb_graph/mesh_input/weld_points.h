#ifndef MESH_INPUT_WELD_POINTS_H
#define MESH_INPUT_WELD_POINTS_H

#include "Polygon_soup.h"

#include <array>
#include <cstddef>
#include <vector>

// For each point the first of those that are connected with it by steps of at most `distance`, which
// is not negative. The time is linear as long as few points crowd within a distance.
std::vector<std::size_t>
coinciding_points(const std::vector<std::array<double, 3>>& points, double distance);

// Makes the points that are connected by steps of at most `distance` one, the first of them, and
// leaves out the others. Returns the old numbers of the points that stay.
std::vector<std::size_t> weld_points(Polygon_soup& soup, double distance);

// The length of the diagonal of the smallest box with edges along the axes that has all points in it.
double diagonal_of_box(const std::vector<std::array<double, 3>>& points);

#endif // MESH_INPUT_WELD_POINTS_H
