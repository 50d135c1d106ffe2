// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SPLAY_SEQUENCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SPLAY_SEQUENCES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Sequences of the numbers 0, 1, ..., each number in one of them, that can be cut, put together and
// turned around in amortized logarithmic time: each is a splay tree (Sleator, Tarjan,
// "Self-adjusting binary search trees", 1985), and the item at its root stands for the sequence.
// At first each item is a sequence of its own.
//
// `Summary` says what is known of a set of items: its default value, for the empty set, is neutral
// in the sum of two, which is associative and commutative (or may depend on the order where several
// results will do).
template <class Summary>
class Splay_sequences
{
public:
  static constexpr std::uint32_t no_item = (std::numeric_limits<std::uint32_t>::max)();

  // Of a sequence, or an empty one.
  using Root = std::uint32_t;

  explicit Splay_sequences(std::size_t size) : m_items(size) {}

  // Says what is known of an item that is a sequence of its own.
  void set_summary(std::uint32_t item, const Summary& summary)
  {
    m_items[item].own = m_items[item].all = summary;
  }

  // What is known of a sequence that is not empty.
  const Summary& sum(Root sequence) const { return m_items[sequence].all; }

  void reverse(Root sequence)
  {
    if (sequence != no_item)
      m_items[sequence].is_reversed = !m_items[sequence].is_reversed;
  }

  // Puts an item, a sequence of its own, between two sequences.
  Root join(Root first, std::uint32_t item, Root last)
  {
    m_items[item].child = {first, last};
    for (const Root part : {first, last})
      if (part != no_item)
        m_items[part].parent = item;
    update(item);
    return item;
  }

  // Takes the first, or the last item out of a sequence that is not empty.
  std::uint32_t cut_off_first(Root& sequence) { return cut_off_end(sequence, 0); }
  std::uint32_t cut_off_last(Root& sequence) { return cut_off_end(sequence, 1); }

  // Takes an item out of its sequence. Returns what comes before it, and what comes behind.
  std::array<Root, 2> cut_out(std::uint32_t item)
  {
    splay(item);
    const Root first = cut(item, 0), last = cut(item, 1);
    return {first, last};
  }

  struct Neighbors
  {
    std::uint32_t item, next; // `no_item` if there is none
  };

  // The last item of a sequence that is not empty for which `holds(item, sum)` is true, and the
  // next one; `sum` is that over the sequence up to the item, which is included. It must be true
  // for no item behind one for which it is not. The root becomes another one.
  template <class Holds>
  Neighbors last_item(Root& sequence, const Holds& holds)
  {
    Neighbors result = {no_item, no_item};
    Summary sum_before;
    for (std::uint32_t item = sequence; item != no_item;) {
      push_down_reversal(item);
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
    for (const std::uint32_t item : {result.item, result.next}) { // one of them is where it ended
      if (item != no_item) {
        splay(item);
        sequence = item;
      }
    }
    return result;
  }

  // Cuts off the items of a sequence for which `holds(item, sum)` is true, see `last_item()`.
  template <class Holds>
  Root cut_off_while(Root& sequence, const Holds& holds)
  {
    if (sequence == no_item)
      return no_item;
    const Neighbors end = last_item(sequence, holds);
    const Root beginning = end.next == no_item ? sequence : cut(end.next, 0);
    sequence = end.next;
    return beginning;
  }

  // How many rotations and searches there have been: the time of all operations, but for a constant
  // factor.
  std::uint64_t number_of_steps() const { return m_number_of_steps; }

protected:
  struct Item
  {
    // in the splay tree; at its root free for other uses, by those who have this class as a base
    std::uint32_t parent = no_item;
    std::array<std::uint32_t, 2> child = {no_item, no_item};
    bool is_reversed = false; // the subtree is to be read backwards, which has not been done yet
    Summary own, all;         // of the item, and of the subtree
  };

  void push_down_reversal(std::uint32_t x)
  {
    Item& item = m_items[x];
    if (!item.is_reversed)
      return;
    std::swap(item.child[0], item.child[1]);
    for (const std::uint32_t child : item.child)
      reverse(child);
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

  // Makes `x` the root of its sequence.
  void splay(std::uint32_t x)
  {
    ++m_number_of_steps;
    for (std::uint32_t item = x;; item = m_items[item].parent) {
      m_stack.push_back(item);
      if (is_root(item))
        break;
    }
    for (; !m_stack.empty(); m_stack.pop_back())
      push_down_reversal(m_stack.back());
    while (!is_root(x)) {
      const std::uint32_t parent = m_items[x].parent;
      if (!is_root(parent)) {
        const std::uint32_t grandparent = m_items[parent].parent;
        const bool is_zigzag =
            (m_items[parent].child[0] == x) != (m_items[grandparent].child[0] == parent);
        rotate(is_zigzag ? x : parent);
      }
      rotate(x);
    }
  }

  // Cuts a sequence before its root (side 0), or behind it (side 1). Returns the other part.
  Root cut(std::uint32_t root, std::size_t side)
  {
    const std::uint32_t other = m_items[root].child[side];
    if (other != no_item) {
      m_items[other].parent = no_item;
      m_items[root].child[side] = no_item;
      update(root);
    }
    return other;
  }

  std::vector<Item> m_items;

private:
  bool is_root(std::uint32_t x) const
  {
    const std::uint32_t parent = m_items[x].parent;
    return parent == no_item || (m_items[parent].child[0] != x && m_items[parent].child[1] != x);
  }

  void rotate(std::uint32_t x)
  {
    ++m_number_of_steps;
    const std::uint32_t parent = m_items[x].parent, grandparent = m_items[parent].parent;
    const std::size_t side = m_items[parent].child[1] == x ? 1 : 0;
    if (!is_root(parent))
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

  std::uint32_t cut_off_end(Root& sequence, std::size_t side)
  {
    std::uint32_t end = sequence;
    for (push_down_reversal(end); m_items[end].child[side] != no_item; push_down_reversal(end))
      end = m_items[end].child[side];
    splay(end);
    sequence = cut(end, 1 - side);
    return end;
  }

  std::uint64_t m_number_of_steps = 0;
  std::vector<std::uint32_t> m_stack;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_SPLAY_SEQUENCES_H
