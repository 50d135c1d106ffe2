// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LINK_CUT_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LINK_CUT_FOREST_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// A forest over the numbers 0, 1, ... that can be changed everywhere and asked for the least key on
// a path, in amortized logarithmic time (Sleator, Tarjan, "Self-adjusting binary search trees",
// 1985): the trees are cut into paths, and every path is kept in a splay tree.
class Link_cut_forest
{
public:
  static constexpr std::uint32_t no_item = (std::numeric_limits<std::uint32_t>::max)();

  // Adds the next number, a tree of its own.
  void add(std::uint32_t key)
  {
    const std::uint32_t item = static_cast<std::uint32_t>(m_items.size());
    m_items.push_back({no_item, {no_item, no_item}, item, key, false});
  }

  std::size_t size() const { return m_items.size(); }

  // Gives a number that is a tree of its own another key.
  void set_key(std::uint32_t item, std::uint32_t key) { m_items[item].key = key; }

  // Joins two trees by an edge between `x` and `y`.
  void link(std::uint32_t x, std::uint32_t y)
  {
    make_root(x);
    m_items[x].parent = y;
  }

  // Removes the edge between `x` and `y`.
  void cut(std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    // the path has two items, of which y is the root of the splay tree
    m_items[m_items[y].child[0]].parent = no_item;
    m_items[y].child[0] = no_item;
    update(y);
  }

  // An item of least key on the path between two items of one tree.
  std::uint32_t least_on_path(std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    return m_items[y].least;
  }

  // All items on the path between two items of one tree, in order.
  std::vector<std::uint32_t> path(std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    std::vector<std::uint32_t> result;
    m_stack.clear();
    for (std::uint32_t item = y; item != no_item || !m_stack.empty();) {
      for (; item != no_item; item = m_items[item].child[0]) {
        push_down_reversal(item);
        m_stack.push_back(item);
      }
      item = m_stack.back();
      m_stack.pop_back();
      result.push_back(item);
      item = m_items[item].child[1];
    }
    return result;
  }

private:
  struct Item
  {
    std::uint32_t parent; // in the splay tree, or, from its root, the item that the path hangs on
    std::array<std::uint32_t, 2> child;
    std::uint32_t least; // an item of least key in the subtree
    std::uint32_t key;
    bool is_reversed; // the subtree, but for the order of the children here
  };

  bool is_splay_root(std::uint32_t x) const
  {
    const std::uint32_t parent = m_items[x].parent;
    return parent == no_item || (m_items[parent].child[0] != x && m_items[parent].child[1] != x);
  }

  void push_down_reversal(std::uint32_t x)
  {
    Item& item = m_items[x];
    if (!item.is_reversed)
      return;
    std::swap(item.child[0], item.child[1]);
    for (const std::uint32_t child : item.child)
      if (child != no_item)
        m_items[child].is_reversed = !m_items[child].is_reversed;
    item.is_reversed = false;
  }

  void update(std::uint32_t x)
  {
    Item& item = m_items[x];
    item.least = x;
    for (const std::uint32_t child : item.child)
      if (child != no_item && m_items[m_items[child].least].key < m_items[item.least].key)
        item.least = m_items[child].least;
  }

  void rotate(std::uint32_t x)
  {
    const std::uint32_t parent = m_items[x].parent, grandparent = m_items[parent].parent;
    const std::size_t side = m_items[parent].child[1] == x ? 1 : 0;
    if (!is_splay_root(parent))
      m_items[grandparent].child[m_items[grandparent].child[1] == parent ? 1 : 0] = x;
    const std::uint32_t inner = m_items[x].child[1 - side];
    m_items[parent].child[side] = inner;
    if (inner != no_item)
      m_items[inner].parent = parent;
    m_items[x].child[1 - side] = parent;
    m_items[parent].parent = x;
    m_items[x].parent = grandparent;
    update(parent);
    update(x);
  }

  void splay(std::uint32_t x)
  {
    m_stack.assign(1, x);
    while (!is_splay_root(m_stack.back()))
      m_stack.push_back(m_items[m_stack.back()].parent);
    for (; !m_stack.empty(); m_stack.pop_back())
      push_down_reversal(m_stack.back());
    while (!is_splay_root(x)) {
      const std::uint32_t parent = m_items[x].parent;
      if (!is_splay_root(parent)) {
        const std::uint32_t grandparent = m_items[parent].parent;
        const bool is_zigzag =
            (m_items[parent].child[0] == x) != (m_items[grandparent].child[0] == parent);
        rotate(is_zigzag ? x : parent);
      }
      rotate(x);
    }
  }

  // Makes the path from the root of the tree to `x` one splay tree, with root `x`.
  void expose(std::uint32_t x)
  {
    std::uint32_t below = no_item;
    for (std::uint32_t item = x; item != no_item; item = m_items[item].parent) {
      splay(item);
      m_items[item].child[1] = below;
      update(item);
      below = item;
    }
    splay(x);
  }

  void make_root(std::uint32_t x)
  {
    expose(x);
    m_items[x].is_reversed = !m_items[x].is_reversed;
    push_down_reversal(x);
  }

  void make_path(std::uint32_t x, std::uint32_t y)
  {
    make_root(x);
    expose(y);
  }

  std::vector<Item> m_items;
  std::vector<std::uint32_t> m_stack;
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_LINK_CUT_FOREST_H
