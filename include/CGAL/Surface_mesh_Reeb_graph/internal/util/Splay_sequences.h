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

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/prefetch.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A summary policy of Splay_sequences: nothing is known of the items, but a sequence has a number,
// which its root holds.
struct Sequence_number
{
  static constexpr bool is_reversible = false;
  static constexpr bool can_hang = false;
  static constexpr bool counts_steps = false;

  struct Data
  {
    std::uint32_t number = (std::numeric_limits<std::uint32_t>::max)();
  };

  static void update(Data&, const Data*, const Data*) {}
  static void copy_from_root(const Data& root, Data& other) { other.number = root.number; }
};

// A summary policy of Splay_sequences: the sum of what is known of the items. The default value of
// `Sum`, for the empty sequence, is neutral in the sum of two, which is associative and commutative
// (or may depend on the order where several results will do): sequences can be turned around.
template <class Sum>
struct Sum_of_items
{
  static constexpr bool is_reversible = true;
  static constexpr bool can_hang = true;
  static constexpr bool counts_steps = true;

  struct Data
  {
    Sum own, all; // of the item, and of the subtree
    // The subtree is to be read backwards, which has not been done yet. At the end, where the links
    // of an item fill the gap up to its alignment.
    bool is_reversed = false;
  };

  static void update(Data& data, const Data* left, const Data* right)
  {
    data.all = data.own;
    if (left != nullptr)
      data.all = data.all + left->all;
    if (right != nullptr)
      data.all = data.all + right->all;
  }
  static void copy_from_root(const Data&, Data&) {}
};

// Sequences of the numbers 0, 1, ..., each number in one of them, that can be cut and put together
// in amortized logarithmic time: each is a splay tree (Sleator, Tarjan, "Self-adjusting binary
// search trees", 1985), and the item at its root stands for the sequence. At first each item is a
// sequence of its own.
//
// `Summary` is the policy that says what is known of a sequence: the `Data` of an item, how those of
// a subtree follow from its root and what lies below it, and what a new root takes over from the
// old one. With `is_reversible`, sequences can be turned around; with `can_hang`, the root of one
// can have a parent in another one, which does not know of it, as in link-cut trees.
template <class Summary>
class Splay_sequences
{
public:
  static constexpr std::uint32_t no_item = (std::numeric_limits<std::uint32_t>::max)();

  // Of a sequence, or an empty one.
  using Root = std::uint32_t;

  explicit Splay_sequences(std::size_t size = 0) : m_items(size) {}

  std::uint32_t number_of_items() const { return static_cast<std::uint32_t>(m_items.size()); }

  // Adds the next item, a sequence of its own.
  std::uint32_t add()
  {
    m_items.emplace_back();
    return number_of_items() - 1;
  }

  // Adds a sequence of the next `size` items, as a balanced tree.
  Root add_balanced(std::uint32_t size)
  {
    const std::uint32_t first = number_of_items();
    m_items.resize(m_items.size() + size);
    return link_balanced(first, first + size, no_item);
  }

  // Adds an item, which comes after `item` in its sequence and becomes the root. Returns it.
  std::uint32_t insert_after(std::uint32_t item)
  {
    const std::uint32_t new_item = add();
    splay(item);
    const Root rest = m_items[item].child[1];
    m_items[item].child[1] = no_item;
    update(item);
    Summary::copy_from_root(m_items[item], m_items[new_item]);
    return join(item, new_item, rest);
  }

  // Says that an item will be needed soon; it may be none.
  void prefetch_item(std::uint32_t item) const
  {
    if (item != no_item)
      prefetch(&m_items[item]);
  }

  // Makes an item the root of its sequence.
  void splay(std::uint32_t item)
  {
    if constexpr (Summary::counts_steps)
      ++m_number_of_steps;
    push_down_from_root(item);
    while (!is_root(item)) {
      const std::uint32_t parent = m_items[item].parent;
      if (!is_root(parent)) {
        const std::uint32_t grandparent = m_items[parent].parent;
        const bool is_zigzag =
            (m_items[parent].child[0] == item) != (m_items[grandparent].child[0] == parent);
        rotate(is_zigzag ? item : parent);
      }
      rotate(item);
    }
  }

  // The number of a sequence that is not empty.
  std::uint32_t& number(Root sequence)
  {
    CGAL_assertion(is_root(sequence));
    return m_items[sequence].number;
  }

  // Says what is known of an item that is a sequence of its own.
  template <class Sum>
  void set_summary(std::uint32_t item, const Sum& sum)
  {
    CGAL_assertion(is_alone(item));
    m_items[item].own = m_items[item].all = sum;
  }

  // What is known of a sequence that is not empty.
  const auto& sum(Root sequence) const
  {
    CGAL_assertion(is_root(sequence));
    return m_items[sequence].all;
  }

  void reverse(Root sequence)
  {
    static_assert(Summary::is_reversible, "the order of these sequences has a meaning");
    if (sequence != no_item)
      m_items[sequence].is_reversed = !m_items[sequence].is_reversed;
  }

  // Appends a sequence to another one, whose number, if there is one, it gets.
  Root join(Root first, Root last)
  {
    if (first == no_item)
      return last;
    if (last == no_item)
      return first;
    CGAL_assertion(is_root(first) && is_root(last) && first != last);
    const std::uint32_t end = end_of(first, 1);
    splay(end);
    m_items[end].child[1] = last;
    m_items[last].parent = end;
    update(end);
    return end;
  }

  // Puts an item, a sequence of its own, between two sequences.
  Root join(Root first, std::uint32_t item, Root last)
  {
    CGAL_assertion(is_alone(item));
    m_items[item].child = {first, last};
    for (const Root part : {first, last})
      if (part != no_item)
        m_items[part].parent = item;
    update(item);
    return item;
  }

  // Cuts a sequence before, or after its root. Returns the other part; both have the number of the
  // whole.
  Root cut_before(Root sequence) { return cut(sequence, 0); }
  Root cut_after(Root sequence) { return cut(sequence, 1); }

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
    CGAL_assertion(is_root(sequence));
    Neighbors result = {no_item, no_item};
    auto sum_before = decltype(m_items[sequence].all)();
    for (std::uint32_t item = sequence; item != no_item;) {
      push_down(item);
      auto sum = sum_before + m_items[item].own;
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
  // factor. Only with `counts_steps`: the sweep would take a few percent longer.
  std::uint64_t number_of_steps() const
  {
    static_assert(Summary::counts_steps, "the steps of these sequences are not counted");
    return m_number_of_steps;
  }

protected:
  struct Item : Summary::Data
  {
    // in the splay tree; at its root, with `can_hang`, in another one
    std::uint32_t parent = no_item;
    std::array<std::uint32_t, 2> child = {no_item, no_item};
  };

  bool is_root(std::uint32_t item) const
  {
    const std::uint32_t parent = m_items[item].parent;
    if constexpr (Summary::can_hang)
      return parent == no_item ||
             (m_items[parent].child[0] != item && m_items[parent].child[1] != item);
    else
      return parent == no_item;
  }

  // Whether an item is a sequence of its own.
  bool is_alone(std::uint32_t item) const
  {
    return is_root(item) && m_items[item].child[0] == no_item && m_items[item].child[1] == no_item;
  }

  // Carries out the reversal of a subtree at its root.
  void push_down(std::uint32_t root)
  {
    if constexpr (Summary::is_reversible) {
      Item& item = m_items[root];
      if (!item.is_reversed)
        return;
      std::swap(item.child[0], item.child[1]);
      for (const std::uint32_t child : item.child)
        reverse(child);
      item.is_reversed = false;
    }
  }

  void update(std::uint32_t root)
  {
    const auto data = [&](std::uint32_t item) -> const typename Summary::Data* {
      return item == no_item ? nullptr : &m_items[item];
    };
    Summary::update(m_items[root], data(m_items[root].child[0]), data(m_items[root].child[1]));
  }

  // Cuts a sequence before its root (side 0), or behind it (side 1). Returns the other part.
  Root cut(Root sequence, std::size_t side)
  {
    CGAL_assertion(is_root(sequence));
    const Root other = m_items[sequence].child[side];
    if (other != no_item) {
      m_items[other].parent = no_item;
      m_items[sequence].child[side] = no_item;
      update(sequence);
      Summary::copy_from_root(m_items[sequence], m_items[other]);
    }
    return other;
  }

  std::vector<Item> m_items;

private:
  // Makes a tree of the items from `begin` to `end` below `parent`. Returns its root.
  std::uint32_t link_balanced(std::uint32_t begin, std::uint32_t end, std::uint32_t parent)
  {
    if (begin == end)
      return no_item;
    const std::uint32_t item = begin + (end - begin) / 2;
    m_items[item].parent = parent;
    m_items[item].child = {link_balanced(begin, item, item), link_balanced(item + 1, end, item)};
    update(item);
    return item;
  }

  // Carries out the reversals on the way from the root to an item, from above.
  void push_down_from_root(std::uint32_t item)
  {
    if constexpr (Summary::is_reversible) {
      m_stack.push_back(item);
      for (; !is_root(item); m_stack.push_back(item))
        item = m_items[item].parent;
      for (; !m_stack.empty(); m_stack.pop_back())
        push_down(m_stack.back());
    }
  }

  // Puts an item in the place of its parent.
  void rotate(std::uint32_t item)
  {
    if constexpr (Summary::counts_steps)
      ++m_number_of_steps;
    const std::uint32_t parent = m_items[item].parent, grandparent = m_items[parent].parent;
    const std::size_t side = m_items[parent].child[1] == item ? 1 : 0;
    if (!is_root(parent))
      m_items[grandparent].child[m_items[grandparent].child[1] == parent ? 1 : 0] = item;
    else
      Summary::copy_from_root(m_items[parent], m_items[item]);
    const std::uint32_t inner = m_items[item].child[1 - side];
    m_items[parent].child[side] = inner;
    if (inner != no_item)
      m_items[inner].parent = parent;
    m_items[item].child[1 - side] = parent;
    m_items[parent].parent = item;
    m_items[item].parent = grandparent;
    update(parent);
    update(item);
  }

  // The first (side 0), or the last item (side 1).
  std::uint32_t end_of(Root sequence, std::size_t side)
  {
    std::uint32_t end = sequence;
    for (push_down(end); m_items[end].child[side] != no_item; push_down(end))
      end = m_items[end].child[side];
    return end;
  }

  std::uint32_t cut_off_end(Root& sequence, std::size_t side)
  {
    const std::uint32_t end = end_of(sequence, side);
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
