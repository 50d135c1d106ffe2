// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_LINK_CUT_FOREST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_LINK_CUT_FOREST_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Splay_sequences.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// A forest over the numbers 0, 1, ... that can be changed everywhere and asked for the paths
// between them, in amortized logarithmic time (Sleator, Tarjan, "Self-adjusting binary search
// trees", 1985): the trees are cut into paths, every path is a sequence, and the parent of its root
// is the item that the path hangs on.
template <class Summary>
class Link_cut_forest : private Splay_sequences<Sum_of_items<Summary>>
{
  using Base = Splay_sequences<Sum_of_items<Summary>>;
  using Base::m_items;
  using Base::splay;
  using Base::update;

public:
  using Base::no_item;
  using typename Base::Neighbors;
  using typename Base::Root;

  explicit Link_cut_forest(std::size_t size) : Base(size) {}

  // Says what is known of an item that is a tree of its own.
  using Base::set_summary;

  using Base::number_of_steps;

  // Joins two trees by edges from `x` to `item`, a tree of its own, and from there to `y`.
  void insert(std::uint32_t item, std::uint32_t x, std::uint32_t y)
  {
    CGAL_assertion(Base::is_alone(item) && m_items[item].parent == no_item);
    make_root(y);
    m_items[y].parent = item;
    expose(x); // or else the logarithmic time is not proven
    m_items[item].parent = x;
  }

  // The last item on the path from `x` to `y`, two items of one tree, for which `holds(item, sum)`
  // is true, and the next one, see Splay_sequences. It must be true for `x`.
  template <class Holds>
  Neighbors last_on_path(std::uint32_t x, std::uint32_t y, const Holds& holds)
  {
    make_path(x, y);
    return Base::last_item(y, holds);
  }

  // The path between two items of one tree, as a sequence that can be changed. What hangs on its
  // items goes on to hang on them. The forest is one again when the items are in one sequence, or
  // in sequences that hang on others; some items may be left out on which nothing hangs.
  Root path(std::uint32_t x, std::uint32_t y)
  {
    make_path(x, y);
    return y;
  }
  using Base::cut_off_first;
  using Base::cut_off_last;
  using Base::cut_off_while;
  using Base::cut_out;
  using Base::join;
  using Base::reverse;
  using Base::sum;

  // Hangs a sequence on an item that is one of its own (or else the logarithmic time is not
  // proven): its first item becomes a neighbor.
  void hang(Root sequence, std::uint32_t item)
  {
    CGAL_assertion(Base::is_root(sequence) && Base::is_alone(item));
    m_items[sequence].parent = item;
  }

private:
  // Makes the path from the root of the tree to `x` one sequence, with root `x`.
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
    Base::reverse(x);
    Base::push_down(x);
  }

  void make_path(std::uint32_t x, std::uint32_t y)
  {
    make_root(x);
    expose(y);
    CGAL_assertion(m_items[y].parent == no_item);
  }
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_LINK_CUT_FOREST_H
