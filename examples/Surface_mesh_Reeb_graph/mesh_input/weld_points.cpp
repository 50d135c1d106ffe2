#include "weld_points.h"

#include <boost/functional/hash.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace {

using Point = std::array<double, 3>;
using Disjoint_sets = boost::disjoint_sets_with_storage<>;
using Cell = std::array<double, 3>; // whole numbers, which may be too large for integers

double distance_of(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// The numbers of the points without those that are equal to others; the sets know where those are.
std::vector<std::size_t> unite_equal_points(const std::vector<Point>& points, Disjoint_sets& sets)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return points[i] != points[j] ? points[i] < points[j] : i < j;
  });
  std::vector<std::size_t> different;
  for (const std::size_t i : order) {
    if (!different.empty() && points[different.back()] == points[i])
      sets.union_set(different.back(), i);
    else
      different.push_back(i);
  }
  return different;
}

} // namespace

std::vector<std::size_t> coinciding_points(const std::vector<Point>& points, double distance)
{
  Disjoint_sets sets(points.size());
  const std::vector<std::size_t> different = unite_equal_points(points, sets);
  if (distance > 0) {
    // Two points that are so close are in the same cell or in adjacent ones.
    std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> cells(different.size());
    const auto cell_of = [&](const Point& p) {
      return Cell{std::floor(p[0] / distance) + 0.,
                  std::floor(p[1] / distance) + 0.,
                  std::floor(p[2] / distance) + 0.};
    };
    for (const std::size_t i : different) {
      const Cell cell = cell_of(points[i]);
      for (int step = 0; step < 27; ++step) {
        const auto neighbor = cells.find(
            {cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1});
        if (neighbor == cells.end())
          continue;
        for (const std::size_t j : neighbor->second)
          if (distance_of(points[i], points[j]) <= distance)
            sets.union_set(i, j);
      }
      cells[cell].push_back(i);
    }
  }
  // the first point of every set represents it
  sets.normalize_sets(boost::counting_iterator<std::size_t>(0),
                      boost::counting_iterator<std::size_t>(points.size()));
  std::vector<std::size_t> representative(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    representative[i] = sets.find_set(i);
  return representative;
}

std::vector<std::size_t> weld_points(Polygon_soup& soup, double distance)
{
  const std::vector<std::size_t> representative = coinciding_points(soup.points, distance);
  std::vector<std::size_t> kept, number(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (representative[i] != i)
      continue;
    number[i] = kept.size();
    soup.points[kept.size()] = soup.points[i];
    kept.push_back(i);
  }
  soup.points.resize(kept.size());
  for (std::size_t& corner : soup.corners)
    corner = number[representative[corner]];
  return kept;
}

double diagonal_of_box(const std::vector<Point>& points)
{
  Point extent = {0, 0, 0};
  for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
          return p[axis] < q[axis];
        });
    extent[axis] = (*high)[axis] - (*low)[axis];
  }
  return std::hypot(extent[0], extent[1], extent[2]);
}
