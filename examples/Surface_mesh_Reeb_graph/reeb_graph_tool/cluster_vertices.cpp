#include "cluster_vertices.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

using Cell = std::array<std::int64_t, 3>;

// The cells of a grid that have vertices, and the cell of every vertex.
struct Grid
{
  std::size_t number_of_cells = 0;
  std::vector<std::uint32_t> cell_of_vertex;

  Grid(const std::vector<Page::Point>& points, double width) : cell_of_vertex(points.size())
  {
    std::unordered_map<Cell, std::uint32_t, boost::hash<Cell>> numbers;
    for (std::size_t v = 0; v < points.size(); ++v) {
      Cell cell;
      for (int i = 0; i < 3; ++i)
        cell[i] = static_cast<std::int64_t>(std::floor(points[v][i] / width));
      cell_of_vertex[v] =
          numbers.emplace(cell, static_cast<std::uint32_t>(numbers.size())).first->second;
    }
    number_of_cells = numbers.size();
  }
};

double squared_distance(const Page::Point& p, const Page::Point& q)
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += (p[i] - q[i]) * (p[i] - q[i]);
  return sum;
}

// The vertex of every cell that is closest to the center of them.
std::vector<std::uint32_t>
central_vertices(const std::vector<Page::Point>& points, const Grid& grid)
{
  std::vector<Page::Point> centers(grid.number_of_cells, {0, 0, 0});
  std::vector<double> sizes(grid.number_of_cells, 0);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::uint32_t cell = grid.cell_of_vertex[v];
    ++sizes[cell];
    for (int i = 0; i < 3; ++i)
      centers[cell][i] += (points[v][i] - centers[cell][i]) / sizes[cell];
  }
  std::vector<std::uint32_t> result(grid.number_of_cells, 0);
  std::vector<double> distances(grid.number_of_cells, std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::uint32_t cell = grid.cell_of_vertex[v];
    const double distance = squared_distance(points[v], centers[cell]);
    if (distance < distances[cell]) {
      distances[cell] = distance;
      result[cell] = static_cast<std::uint32_t>(v);
    }
  }
  return result;
}

// The triangle beginning with its smallest vertex, so that it has one form only.
std::array<std::uint32_t, 3> rotated(std::array<std::uint32_t, 3> t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

template <class T>
void keep(std::vector<T>& items, const std::vector<std::uint32_t>& kept)
{
  std::vector<T> result;
  result.reserve(kept.size());
  for (const std::uint32_t i : kept)
    result.push_back(items[i]);
  items = std::move(result);
}

} // namespace

void cluster_vertices(Page& page, std::size_t largest_number_of_vertices)
{
  if (page.points.size() <= largest_number_of_vertices)
    return;
  Page::Point lowest = page.points.front(), highest = lowest;
  for (const Page::Point& p : page.points) {
    for (int i = 0; i < 3; ++i) {
      lowest[i] = (std::min)(lowest[i], p[i]);
      highest[i] = (std::max)(highest[i], p[i]);
    }
  }
  // A grid of twice the width has about a quarter of the cells.
  constexpr double finest = 1. / 4096, growth = 1.1;
  double width = finest * std::sqrt(squared_distance(lowest, highest));
  if (width == 0)
    width = 1;
  Grid grid(page.points, width);
  while (grid.number_of_cells > largest_number_of_vertices) {
    const double excess =
        static_cast<double>(grid.number_of_cells) / static_cast<double>(largest_number_of_vertices);
    width *= (std::max)(growth, 0.9 * std::sqrt(excess));
    grid = Grid(page.points, width);
  }
  const std::vector<std::uint32_t> kept = central_vertices(page.points, grid);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::array<std::uint32_t, 3>& t : page.triangles) {
    const std::uint32_t a = grid.cell_of_vertex[t[0]], b = grid.cell_of_vertex[t[1]],
                        c = grid.cell_of_vertex[t[2]];
    if (a != b && b != c && c != a)
      triangles.push_back(rotated({a, b, c}));
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  page.triangles = std::move(triangles);
  keep(page.points, kept);
  keep(page.vertices, kept);
  keep(page.values, kept);
  keep(page.groups, kept);
  page.is_decimated = true;
}
