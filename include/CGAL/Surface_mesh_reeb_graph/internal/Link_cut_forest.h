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

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// A forest over the numbers 0, 1, ... that can be changed everywhere and asked for the paths
// between them, in amortized logarithmic time (Sleator, Tarjan, "Self-adjusting binary search
// trees", 1985): the trees are cut into paths, and every path is kept in a splay tree.
//
// `Summary` says what is known of a set of numbers: its default value, for the empty set, is
// neutral in the sum of two, which is associative and commutative (or may depend on the order where
// several results will do).
template <class Summary>
class Link_cut_forest
{
public:
  static constexpr std::uint32_t no_item = (std::numeric_limits<std::uint32_t>::max)();

  explicit Link_cut_forest(std::size_t size) : m_items(size) {}

  // Says what is known of a number that is a tree of its own.
  void set_summary(std::uint32_t item, const Summary& summary)
  {
    m_items[item].own = m_items[item].all = summary;
  }

  // Joins two trees by edges from `x` to `item`, a tree of its own, and from there to `y`.
  void insert(std::uint32_t item, std::uint32_t x, std::uint32_t y)
  {
    make_root(y);
    m_items[y].parent = item;
    expose(x); // or else the logarithmic time is not proven
    m_items[item].parent = x;
  }

  // Removes the edges from `item` to `x` and `y`, its only neighbors.
  void remove(std::uint32_t item, std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    splay(item);
    CGAL_assertion(m_items[item].child[0] == x && m_items[item].child[1] == y);
    for (std::uint32_t& child : m_items[item].child) {
      m_items[child].parent = no_item;
      child = no_item;
    }
    update(item);
  }

  // The sum over the path between two items of one tree.
  const Summary& sum_on_path(std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    return m_items[y].all;
  }

  // The item next to `x` on the path to `y`, another item of its tree.
  std::uint32_t second_on_path(std::uint32_t x, std::uint32_t y)
  {
    CGAL_assertion(x != y);
    make_path(x, y);
    splay(x);
    std::uint32_t item = m_items[x].child[1];
    for (;;) {
      push_down_reversal(item);
      if (m_items[item].child[0] == no_item)
        break;
      item = m_items[item].child[0];
    }
    splay(item);
    return item;
  }

  struct Neighbors_on_path
  {
    std::uint32_t item, next; // `no_item` if there is no next one
  };

  // The last item on the path from `x` to `y`, two items of one tree, for which `holds(item, sum)`
  // is true, and the next one; `sum` is that over the path from `x` to the item, both included. It
  // must be true for `x`, and for no item behind one for which it is not.
  template <class Holds>
  Neighbors_on_path last_on_path(std::uint32_t x, std::uint32_t y, const Holds& holds)
  {
    make_path(x, y);
    Neighbors_on_path result = {x, no_item};
    std::uint32_t last = y;
    Summary sum_before;
    for (std::uint32_t item = y; item != no_item;) {
      push_down_reversal(item);
      last = item;
      Summary sum = sum_before + m_items[item].own;
      if (m_items[item].child[0] != no_item)
        sum = sum + m_items[m_items[item].child[0]].all;
      if (holds(item, sum)) {
        result.item = item;
        sum_before = sum;
        item = m_items[item].child[1];
      } else {
        result.next = item;
        item = m_items[item].child[0];
      }
    }
    splay(last);
    return result;
  }

private:
  struct Item
  {
    // in the splay tree, or, from its root, the item that the path hangs on
    std::uint32_t parent = no_item;
    std::array<std::uint32_t, 2> child = {no_item, no_item};
    bool is_reversed = false; // the subtree is to be read backwards, which has not been done yet
    Summary own, all;         // of the item, and of the subtree
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
    item.all = item.own;
    for (const std::uint32_t child : item.child)
      if (child != no_item)
        item.all = item.all + m_items[child].all;
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
    for (std::uint32_t item = x;; item = m_items[item].parent) {
      m_stack.push_back(item);
      if (is_splay_root(item))
        break;
    }
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
