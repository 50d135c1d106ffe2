#include "split_polygons.h"

#include "Edge_uses.h"
#include "errors.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross_product(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double scalar_product(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The edges of the polygons, and the diagonals so far.
class Taken_edges
{
public:
  explicit Taken_edges(const Polygon_soup& soup) : m_edges(soup) {}

  bool has(std::size_t v, std::size_t w) const
  {
    return m_edges.has(v, w) || m_diagonals.count(std::minmax(v, w)) > 0;
  }

  void add_diagonal(std::size_t v, std::size_t w) { m_diagonals.insert(std::minmax(v, w)); }

private:
  Edge_uses m_edges;
  using Edge = std::pair<std::size_t, std::size_t>;
  std::unordered_set<Edge, boost::hash<Edge>> m_diagonals;
};

// Splits one polygon after the other. Corners are numbered from 0 on in each of them.
class Polygon_splitter
{
public:
  using Triangle = std::array<std::size_t, 3>; // corners

  Polygon_splitter(const Polygon_soup& soup, Taken_edges& taken) : m_soup(soup), m_taken(taken) {}

  // Whether there is a split; its triangles then.
  bool split(std::size_t polygon)
  {
    m_begin = m_soup.first[polygon];
    m_size = m_soup.size(polygon);
    if (m_size == 3) {
      m_triangles.assign(1, {0, 1, 2});
      return true;
    }
    m_normal = normal();
    if (!(m_size == 4 ? split_quadrangle() : clip_ears()) && !split_by_fan() && !split_by_search())
      return false;
    for (const Triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
        if (!is_side(t[i], t[(i + 1) % 3]))
          m_taken.add_diagonal(vertex(t[i]), vertex(t[(i + 1) % 3]));
    return true;
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  std::size_t vertex(std::size_t corner) const { return m_soup.corners[m_begin + corner]; }
  const Vector& point(std::size_t corner) const { return m_soup.points[vertex(corner)]; }

  bool is_side(std::size_t a, std::size_t b) const
  {
    return (a + 1) % m_size == b || (b + 1) % m_size == a;
  }

  bool is_allowed(std::size_t a, std::size_t b) const
  {
    return is_side(a, b) || !m_taken.has(vertex(a), vertex(b));
  }

  // Newell's normal of the polygon: for polygons in a plane, twice the area times the unit normal.
  Vector normal() const
  {
    Vector result = {0, 0, 0};
    for (std::size_t i = 1; i + 1 < m_size; ++i) {
      const Vector n =
          cross_product(difference(point(i), point(0)), difference(point(i + 1), point(0)));
      for (std::size_t axis = 0; axis < 3; ++axis)
        result[axis] += n[axis];
    }
    return result;
  }

  // Twice the area of the triangle, seen along the normal and times its length.
  double area(std::size_t a, std::size_t b, std::size_t c) const
  {
    return scalar_product(
        cross_product(difference(point(b), point(a)), difference(point(c), point(a))), m_normal);
  }

  double squared_length(std::size_t a, std::size_t b) const
  {
    const Vector d = difference(point(a), point(b));
    return scalar_product(d, d);
  }

  // By the shorter one of the diagonals that lie inside.
  bool split_quadrangle()
  {
    const bool is_allowed_02 = is_allowed(0, 2), is_allowed_13 = is_allowed(1, 3);
    const bool is_inside_02 = area(0, 1, 2) > 0 && area(0, 2, 3) > 0,
               is_inside_13 = area(0, 1, 3) > 0 && area(1, 2, 3) > 0;
    const bool prefers_02 =
        is_inside_02 == is_inside_13 ? squared_length(0, 2) <= squared_length(1, 3) : is_inside_02;
    if (is_allowed_02 && (prefers_02 || !is_allowed_13))
      m_triangles = {{0, 1, 2}, {0, 2, 3}};
    else if (is_allowed_13)
      m_triangles = {{0, 1, 3}, {1, 2, 3}};
    else
      return false;
    return true;
  }

  // Cuts off one triangle after the other, and goes on behind it. Triangles that are turned around
  // or have other corners in them are taken only if there are no others, or if looking for them has
  // taken too long. Fails if all triangles that could be cut off need a diagonal that is taken.
  bool clip_ears()
  {
    m_next.resize(m_size);
    m_previous.resize(m_size);
    for (std::size_t i = 0; i < m_size; ++i) {
      m_next[i] = (i + 1) % m_size;
      m_previous[m_next[i]] = i;
    }
    // only these can be in another triangle, and they become fewer
    m_reflex.clear();
    for (std::size_t i = 0; i < m_size; ++i)
      if (!(area(m_previous[i], i, m_next[i]) > 0))
        m_reflex.push_back(i);
    m_is_clipped.assign(m_size, 0);
    m_budget = 1000 + 100 * m_size;
    m_triangles.clear();
    std::size_t b = 0, failures = 0;
    bool is_choosy = true;
    for (std::size_t left = m_size; left > 3;) {
      const std::size_t a = m_previous[b], c = m_next[b];
      if (is_allowed(a, c) && (!is_choosy || is_ear(a, b, c))) {
        m_triangles.push_back({a, b, c});
        m_next[a] = c;
        m_previous[c] = a;
        m_is_clipped[b] = 1;
        --left;
        failures = 0;
        is_choosy = m_budget > 0;
        b = m_next[c]; // not the next one, which would make a fan
      } else {
        b = c;
        if (++failures > left) {
          if (!is_choosy)
            return false;
          is_choosy = false;
          failures = 0;
        }
      }
    }
    m_triangles.push_back({m_previous[b], b, m_next[b]});
    return true;
  }

  bool is_ear(std::size_t a, std::size_t b, std::size_t c)
  {
    m_budget -= (std::min)(m_budget, std::size_t(1));
    if (!(area(a, b, c) > 0))
      return false;
    m_budget -= (std::min)(m_budget, m_reflex.size());
    for (const std::size_t r : m_reflex) {
      if (m_is_clipped[r] || r == a || r == b || r == c)
        continue;
      const Vector& p = point(r);
      if (p == point(a) || p == point(b) || p == point(c))
        continue;
      if (area(a, b, r) >= 0 && area(b, c, r) >= 0 && area(c, a, r) >= 0)
        return false;
    }
    return true;
  }

  // From the first corner all of whose diagonals are free.
  bool split_by_fan()
  {
    for (std::size_t apex = 0; apex < m_size; ++apex) {
      bool is_free = true;
      for (std::size_t i = 2; i + 1 < m_size && is_free; ++i)
        is_free = is_allowed(apex, (apex + i) % m_size);
      if (!is_free)
        continue;
      m_triangles.clear();
      for (std::size_t i = 1; i + 1 < m_size; ++i)
        m_triangles.push_back({apex, (apex + i) % m_size, (apex + i + 1) % m_size});
      return true;
    }
    return false;
  }

  // Finds a split if there is one: the corners from i to j can be split if some corner between makes
  // a triangle with both, and the two rests can be split. Polygons that are too large for its time,
  // which is cubic, would need hundreds of diagonals that are taken to come here.
  bool split_by_search()
  {
    constexpr std::size_t largest = 300;
    if (m_size > largest)
      return false;
    const std::size_t n = m_size;
    std::vector<std::size_t> apex(n * n, 0); // 0: cannot be split
    const auto can_be_split = [&](std::size_t i, std::size_t j) {
      return j == i + 1 || apex[i * n + j] > 0;
    };
    for (std::size_t length = 2; length < n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t j = i + length;
        if (!is_allowed(i, j))
          continue;
        for (std::size_t k = i + 1; k < j && apex[i * n + j] == 0; ++k)
          if (can_be_split(i, k) && can_be_split(k, j))
            apex[i * n + j] = k;
      }
    if (!can_be_split(0, n - 1))
      return false;
    m_triangles.clear();
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j == i + 1)
        continue;
      const std::size_t k = apex[i * n + j];
      m_triangles.push_back({i, k, j});
      open.push_back({i, k});
      open.push_back({k, j});
    }
    return true;
  }

  const Polygon_soup& m_soup;
  Taken_edges& m_taken;
  std::size_t m_begin = 0, m_size = 0;
  Vector m_normal = {0, 0, 0};
  std::vector<Triangle> m_triangles;
  // for clip_ears()
  std::vector<std::size_t> m_next, m_previous, m_reflex;
  std::vector<char> m_is_clipped;
  std::size_t m_budget = 0;
};

} // namespace

void split_polygons(Polygon_soup& soup)
{
  if (soup.corners.size() == 3 * soup.number_of_polygons())
    return;
  Taken_edges taken(soup);
  Polygon_splitter splitter(soup, taken);
  std::vector<std::size_t> corners;
  corners.reserve(3 * (soup.corners.size() - 2 * soup.number_of_polygons()));
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
    const std::size_t begin = soup.first[i];
    if (!splitter.split(i))
      throw Content_error("a polygon with the vertices " + std::to_string(soup.corners[begin]) +
                          ", " + std::to_string(soup.corners[begin + 1]) + ", " +
                          std::to_string(soup.corners[begin + 2]) +
                          ", ... cannot be split into triangles: other faces have edges where "
                          "diagonals would be needed");
    for (const auto& triangle : splitter.triangles())
      for (const std::size_t corner : triangle)
        corners.push_back(soup.corners[begin + corner]);
  }
  soup.corners.swap(corners);
  soup.first.resize(1);
  for (std::size_t end = 3; end <= soup.corners.size(); end += 3)
    soup.first.push_back(end);
}
