// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SEQUENCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SEQUENCES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/prefetch.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Sequences of elements that can be cut and put together, each as a splay tree (Sleator, Tarjan,
// "Self-adjusting binary search trees", 1985): any sequence of m operations takes O(m log m) time.
// An element stands for its sequence as long as it is the root of its tree, and has a number that
// belongs to the sequence and goes from root to root.
class Sequences
{
public:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // Makes a sequence of one element.
  std::uint32_t add()
  {
    m_elements.push_back(Element());
    return static_cast<std::uint32_t>(m_elements.size() - 1);
  }

  // Makes a sequence of `size` elements, which are the next ones, as a balanced tree. Returns its
  // root.
  std::uint32_t add_balanced(std::uint32_t size)
  {
    const std::uint32_t first = number_of_elements();
    m_elements.resize(m_elements.size() + size);
    return link_balanced(first, first + size, none);
  }

  std::uint32_t number_of_elements() const { return static_cast<std::uint32_t>(m_elements.size()); }

  void prefetch_element(std::uint32_t x) const
  {
    if (x != none)
      prefetch(&m_elements[x]);
  }

  // Makes `x` the root of its sequence.
  void expose(std::uint32_t x)
  {
    while (m_elements[x].parent != none) {
      const std::uint32_t p = m_elements[x].parent, g = m_elements[p].parent;
      if (g != none)
        rotate((m_elements[g].child[1] == p) == (m_elements[p].child[1] == x) ? p : x);
      rotate(x);
    }
  }

  // \pre `x` is a root
  std::uint32_t& number(std::uint32_t x) { return m_elements[x].number; }

  // Cuts a sequence before (after) the root `x`; returns the root of the other part, or `none`.
  // Both parts have the number of the whole.
  std::uint32_t cut_before(std::uint32_t x) { return cut(x, 0); }
  std::uint32_t cut_after(std::uint32_t x) { return cut(x, 1); }

  // Appends the sequence of the root `y` to that of the root `x`, whose number it gets; either may
  // be `none`. Returns the root.
  std::uint32_t join(std::uint32_t x, std::uint32_t y)
  {
    if (x == none)
      return y;
    if (y == none)
      return x;
    while (m_elements[x].child[1] != none)
      x = m_elements[x].child[1];
    expose(x);
    m_elements[x].child[1] = y;
    m_elements[y].parent = x;
    return x;
  }

  // Adds an element after `x`, and returns it.
  std::uint32_t insert_after(std::uint32_t x)
  {
    const std::uint32_t y = add();
    expose(x);
    const std::uint32_t rest = m_elements[x].child[1];
    m_elements[y].child = {x, rest};
    m_elements[y].number = m_elements[x].number;
    m_elements[x].child[1] = none;
    m_elements[x].parent = y;
    if (rest != none)
      m_elements[rest].parent = y;
    return y;
  }

private:
  struct Element
  {
    std::uint32_t parent = none;
    std::array<std::uint32_t, 2> child = {none, none};
    std::uint32_t number = none;
  };

  // Makes a tree of the elements from `begin` to `end` below `parent`. Returns its root.
  std::uint32_t link_balanced(std::uint32_t begin, std::uint32_t end, std::uint32_t parent)
  {
    if (begin == end)
      return none;
    const std::uint32_t x = begin + (end - begin) / 2;
    m_elements[x].parent = parent;
    m_elements[x].child = {link_balanced(begin, x, x), link_balanced(x + 1, end, x)};
    return x;
  }

  // Puts `x` in the place of its parent.
  void rotate(std::uint32_t x)
  {
    const std::uint32_t p = m_elements[x].parent, g = m_elements[p].parent;
    const std::size_t side = m_elements[p].child[1] == x ? 1 : 0;
    const std::uint32_t inner = m_elements[x].child[1 - side];
    m_elements[p].child[side] = inner;
    if (inner != none)
      m_elements[inner].parent = p;
    m_elements[x].child[1 - side] = p;
    m_elements[p].parent = x;
    m_elements[x].parent = g;
    if (g != none)
      m_elements[g].child[m_elements[g].child[1] == p ? 1 : 0] = x;
    else
      m_elements[x].number = m_elements[p].number;
  }

  std::uint32_t cut(std::uint32_t x, std::size_t side)
  {
    const std::uint32_t y = m_elements[x].child[side];
    if (y != none) {
      m_elements[x].child[side] = none;
      m_elements[y].parent = none;
      m_elements[y].number = m_elements[x].number;
    }
    return y;
  }

  std::vector<Element> m_elements;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SEQUENCES_H
