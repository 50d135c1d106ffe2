#ifndef MESH_INPUT_EDGE_USES_H
#define MESH_INPUT_EDGE_USES_H

#include "Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// The edges of a polygon soup. A side of a polygon runs from a corner to the next one; the sides
// between the same two vertices are the uses of one edge. The time is linear but for sorting the
// edges of each single vertex.
class Edge_uses
{
public:
  struct Use
  {
    std::size_t low, high; // the vertices
    std::size_t corner;    // where the side begins
  };

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  explicit Edge_uses(const Polygon_soup& soup)
    : m_soup(soup), m_first(soup.points.size() + 1, 0), m_uses(soup.corners.size())
  {
    for_each_side([&](const Use& use) { ++m_first[use.low + 1]; });
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      m_first[v + 1] += m_first[v];
    std::vector<std::size_t> end(m_first.begin(), m_first.end() - 1);
    for_each_side([&](const Use& use) { m_uses[end[use.low]++] = use; });
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      std::sort(begin_of(v), begin_of(v + 1), [](const Use& a, const Use& b) {
        return a.high != b.high ? a.high < b.high : a.corner < b.corner;
      });
  }

  // Calls `visit(begin, end)` for the uses of every edge, in increasing order of the corners.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for (auto begin = m_uses.begin(); begin != m_uses.end();) {
      auto end = begin;
      while (end != m_uses.end() && end->low == begin->low && end->high == begin->high)
        ++end;
      visit(begin, end);
      begin = end;
    }
  }

  bool has(std::size_t v, std::size_t w) const
  {
    const std::size_t low = (std::min)(v, w), high = (std::max)(v, w);
    const auto end = begin_of(low + 1);
    const auto found =
        std::lower_bound(begin_of(low), end, high, [](const Use& use, std::size_t vertex) {
          return use.high < vertex;
        });
    return found != end && found->high == high;
  }

  // Whether the side runs from the lower to the higher vertex.
  bool runs_upwards(const Use& use) const { return m_soup.corners[use.corner] == use.low; }

private:
  std::vector<Use>::iterator begin_of(std::size_t v)
  {
    return m_uses.begin() + static_cast<std::ptrdiff_t>(m_first[v]);
  }

  std::vector<Use>::const_iterator begin_of(std::size_t v) const
  {
    return m_uses.begin() + static_cast<std::ptrdiff_t>(m_first[v]);
  }

  template <class Visit>
  void for_each_side(const Visit& visit) const
  {
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i) {
      for (std::size_t k = m_soup.first[i]; k < m_soup.first[i + 1]; ++k) {
        const std::size_t next = k + 1 < m_soup.first[i + 1] ? k + 1 : m_soup.first[i];
        const auto [low, high] = std::minmax(m_soup.corners[k], m_soup.corners[next]);
        visit(Use{low, high, k});
      }
    }
  }

  const Polygon_soup& m_soup;
  std::vector<std::size_t> m_first; // of the uses with this lower vertex
  std::vector<Use> m_uses;
};

#endif // MESH_INPUT_EDGE_USES_H
