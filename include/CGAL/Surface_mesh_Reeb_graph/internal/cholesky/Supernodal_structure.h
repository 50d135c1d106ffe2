// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_SUPERNODAL_STRUCTURE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_SUPERNODAL_STRUCTURE_H

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What a Cholesky factor L of a sparse matrix looks like, without its numbers: supernodes are
// ranges of columns that share their rows below the range. A supernode with its rows is a front of
// the multifrontal method; fronts are numbered so that children come before their parent and next
// to each other.
//
// The steps are the usual ones: elimination tree and postorder (Liu 1990), counts of the columns
// (Gilbert, Ng and Peyton 1994), supernodes, and merging of small ones into their parents where
// this stores few zeros (Ashcraft and Grimes 1989).
template <class StorageIndex>
class Supernodal_structure
{
public:
  using Index = Eigen::Index;

  Supernodal_structure() = default;

  // `pattern` is a symmetric matrix in both triangles, of which the positions count only;
  // `position[i]` is the column of the factor that its column `i` becomes. Other positions that
  // give the same fill may replace these: positions() has the final ones.
  template <class Pattern>
  Supernodal_structure(const Pattern& pattern, std::vector<StorageIndex> position)
    : m_position(std::move(position))
  {
    CGAL_precondition(pattern.rows() == pattern.cols());
    CGAL_precondition(pattern.cols() == static_cast<Index>(m_position.size()));
    Tree tree = elimination_tree(pattern);
    renumber(tree, postorder(tree));
    const std::vector<StorageIndex> counts = column_counts(pattern, tree);
    form_supernodes(tree, counts);
    find_rows(pattern);
  }

  const std::vector<StorageIndex>& positions() const { return m_position; }

  Index number_of_supernodes() const { return static_cast<Index>(m_first_column.size()) - 1; }
  StorageIndex first_column(const Index s) const { return at(m_first_column, s); }
  Index width(const Index s) const { return at(m_first_column, s + 1) - at(m_first_column, s); }

  // Number of rows below the columns of supernode `s`, and these rows, increasing.
  Index number_of_rows_below(const Index s) const
  {
    return at(m_rows_begin, s + 1) - at(m_rows_begin, s);
  }
  const StorageIndex* rows_below(const Index s) const
  {
    return m_rows.data() + at(m_rows_begin, s);
  }

  StorageIndex number_of_children(const Index s) const { return at(m_number_of_children, s); }

  // Offset of the columns of supernode `s` in an array of all of them, and the size of that array.
  Index offset(const Index s) const { return at(m_offset, s); }
  Index size() const { return m_offset.empty() ? 0 : m_offset.back(); }

  // Number of entries of the lower triangle of L, explicit zeros of merged supernodes included.
  Index number_of_entries() const
  {
    Index result = 0;
    for (Index s = 0; s < number_of_supernodes(); ++s)
      result += entries(width(s), number_of_rows_below(s));
    return result;
  }

  // The largest number of rows below a supernode.
  Index largest_number_of_rows_below() const { return m_largest_below; }

  // The largest size of the stack of triangles, one per front that waits for its parent.
  Index stack_size() const { return m_stack_size; }

  std::size_t memory() const
  {
    return sizeof(StorageIndex) * (m_position.capacity() + m_first_column.capacity() +
                                   m_rows.capacity() + m_number_of_children.capacity()) +
           sizeof(Index) * (m_rows_begin.capacity() + m_offset.capacity());
  }

private:
  using Tree = std::vector<StorageIndex>; // parent of every node, `none` for a root
  static constexpr StorageIndex none = -1;

  template <class T>
  static const T& at(const std::vector<T>& v, const Index i)
  {
    CGAL_assertion(0 <= i && i < static_cast<Index>(v.size()));
    return v[static_cast<std::size_t>(i)];
  }
  template <class T>
  static T& at(std::vector<T>& v, const Index i)
  {
    CGAL_assertion(0 <= i && i < static_cast<Index>(v.size()));
    return v[static_cast<std::size_t>(i)];
  }

  static Index triangle(const Index n) { return n * (n + 1) / 2; }
  static Index entries(const Index width, const Index below)
  {
    return triangle(width) + width * below;
  }

  StorageIndex size_of_matrix() const { return static_cast<StorageIndex>(m_position.size()); }

  std::vector<StorageIndex> columns() const
  {
    std::vector<StorageIndex> result(m_position.size());
    for (StorageIndex i = 0; i < size_of_matrix(); ++i)
      at(result, at(m_position, i)) = i;
    return result;
  }

  template <class Pattern>
  Tree elimination_tree(const Pattern& pattern) const
  {
    const std::vector<StorageIndex> column = columns();
    Tree parent(m_position.size(), none);
    Tree ancestor(m_position.size(), none); // shortcuts, which each search renews on its path
    for (StorageIndex j = 0; j < size_of_matrix(); ++j)
      for (typename Pattern::InnerIterator it(pattern, at(column, j)); it; ++it)
        for (StorageIndex i = at(m_position, it.index()); i != none && i < j;) {
          const StorageIndex next = std::exchange(at(ancestor, i), j);
          if (next == none)
            at(parent, i) = j;
          i = next;
        }
    return parent;
  }

  // Children of every node as linked lists, in the given order.
  struct Children
  {
    std::vector<StorageIndex> first, next;

    // from the last node to the first, so that lists increase
    explicit Children(const Tree& tree) : first(tree.size(), none), next(tree.size(), none)
    {
      for (Index i = static_cast<Index>(tree.size()) - 1; i >= 0; --i)
        if (at(tree, i) != none)
          add(static_cast<StorageIndex>(i), at(tree, i));
    }
    void add(const StorageIndex child, const StorageIndex parent)
    {
      at(next, child) = at(first, parent);
      at(first, parent) = child;
    }
  };

  static std::vector<StorageIndex> postorder(const Tree& tree)
  {
    return postorder(tree, Children(tree));
  }

  // The number of every node. The lists of children are used up.
  static std::vector<StorageIndex> postorder(const Tree& tree, Children children)
  {
    std::vector<StorageIndex> number(tree.size(), none);
    StorageIndex next_number = 0;
    for (Index root = 0; root < static_cast<Index>(tree.size()); ++root) {
      if (at(tree, root) != none)
        continue;
      for (StorageIndex i = static_cast<StorageIndex>(root); i != none;) {
        const StorageIndex child = at(children.first, i);
        if (child != none) {
          at(children.first, i) = at(children.next, child);
          i = child;
        } else {
          at(number, i) = next_number++;
          i = at(tree, i);
        }
      }
    }
    return number;
  }

  void renumber(Tree& tree, const std::vector<StorageIndex>& number)
  {
    Tree renumbered(tree.size(), none);
    for (Index i = 0; i < static_cast<Index>(tree.size()); ++i)
      if (at(tree, i) != none)
        at(renumbered, at(number, i)) = at(number, at(tree, i));
    tree = std::move(renumbered);
    for (StorageIndex& p : m_position)
      p = at(number, p);
  }

  // Number of entries of every column of L, the diagonal included. Row i of L is a subtree of the
  // elimination tree with root i; its leaves are found among the entries of the matrix. Counting
  // paths from leaves to the root, less what consecutive paths share, is a sum over subtrees.
  template <class Pattern>
  std::vector<StorageIndex> column_counts(const Pattern& pattern, const Tree& tree) const
  {
    const std::size_t n = m_position.size();
    const std::vector<StorageIndex> column = columns();
    std::vector<StorageIndex> first_descendant(n, none);
    std::vector<StorageIndex> count(n, 0);
    for (StorageIndex j = 0; j < size_of_matrix(); ++j) {
      if (at(first_descendant, j) == none) {
        at(first_descendant, j) = j;
        at(count, j) = 1;
      }
      const StorageIndex parent = at(tree, j);
      if (parent != none) {
        if (at(first_descendant, parent) == none)
          at(first_descendant, parent) = at(first_descendant, j);
        --at(count, parent);
      }
    }

    std::vector<StorageIndex> last_leaf(n, none); // of the subtree of every row
    std::vector<StorageIndex> ancestor(n);        // disjoint sets of what is below a node
    for (StorageIndex j = 0; j < size_of_matrix(); ++j)
      at(ancestor, j) = j;
    for (StorageIndex j = 0; j < size_of_matrix(); ++j) {
      for (typename Pattern::InnerIterator it(pattern, at(column, j)); it; ++it) {
        const StorageIndex i = at(m_position, it.index());
        if (i <= j)
          continue;
        const StorageIndex previous = at(last_leaf, i);
        if (previous != none && previous >= at(first_descendant, j))
          continue; // there is a leaf below j
        at(last_leaf, i) = j;
        ++at(count, j);
        if (previous != none)
          --at(count, find(ancestor, previous));
      }
      if (at(tree, j) != none)
        at(ancestor, j) = at(tree, j);
    }
    for (StorageIndex j = 0; j < size_of_matrix(); ++j)
      if (at(tree, j) != none)
        at(count, at(tree, j)) += at(count, j);
    return count;
  }

  static StorageIndex find(std::vector<StorageIndex>& ancestor, StorageIndex i)
  {
    StorageIndex root = i;
    while (root != at(ancestor, root))
      root = at(ancestor, root);
    while (i != root)
      i = std::exchange(at(ancestor, i), root);
    return root;
  }

  // Whether so many zeros are a fair price for one front less. Work on a small front is hardly work
  // with numbers, so that zeros cost nothing there.
  static bool is_worth_merging(const Index zeros, const Index width, const Index below)
  {
    const double share = static_cast<double>(zeros) / static_cast<double>(entries(width, below));
    return width <= 4 || (width <= 16 && share < 0.4) || (width <= 48 && share < 0.15) ||
           share < 0.05;
  }

  // Supernodes in the making, which have neither their final columns nor their rows.
  struct Supernodes
  {
    std::vector<StorageIndex> of_column; // the supernode of every column
    std::vector<Index> width, below;     // numbers of columns, and of rows below them
    Tree parent;

    Index number() const { return static_cast<Index>(width.size()); }
  };

  void form_supernodes(const Tree& tree, const std::vector<StorageIndex>& counts)
  {
    Supernodes supernodes = fundamental_supernodes(tree, counts);
    supernodes = without_merged(supernodes, merge_small(supernodes));
    const std::vector<StorageIndex> order =
        postorder(supernodes.parent, children_for_small_stack(supernodes.parent, supernodes.below));
    lay_out(supernodes, order);
    renumber_columns(supernodes, order);
  }

  // The largest ranges of columns that have the same rows below: no zero is stored.
  Supernodes fundamental_supernodes(const Tree& tree, const std::vector<StorageIndex>& counts) const
  {
    Supernodes result;
    result.of_column.resize(m_position.size());
    for (StorageIndex j = 0; j < size_of_matrix(); ++j) {
      if (j > 0 && at(tree, j - 1) == j && at(counts, j - 1) == at(counts, j) + 1)
        ++result.width.back();
      else {
        result.width.push_back(1);
        result.below.push_back(0);
      }
      result.below.back() = at(counts, j) - 1;
      at(result.of_column, j) = static_cast<StorageIndex>(result.number() - 1);
    }
    result.parent.assign(result.width.size(), none);
    for (StorageIndex j = 0; j < size_of_matrix(); ++j)
      if (at(tree, j) != none && at(result.of_column, at(tree, j)) != at(result.of_column, j))
        at(result.parent, at(result.of_column, j)) = at(result.of_column, at(tree, j));
    return result;
  }

  // Widens supernodes by children that are worth merging, the last ones first: those often are the
  // largest. Returns the supernode that every one becomes a part of, `none` for those that remain.
  static std::vector<StorageIndex> merge_small(Supernodes& supernodes)
  {
    const Index number = supernodes.number();
    std::vector<Index>&width = supernodes.width, &below = supernodes.below;
    std::vector<StorageIndex> merged_into(width.size(), none);
    std::vector<Index> zeros(width.size(), 0);
    Children children{Tree(width.size(), none)};
    for (Index s = 0; s < number; ++s)
      if (at(supernodes.parent, s) != none)
        children.add(static_cast<StorageIndex>(s), at(supernodes.parent, s));
    for (Index s = 0; s < number; ++s)
      for (StorageIndex c = at(children.first, s); c != none; c = at(children.next, c)) {
        const Index sum = at(zeros, s) + at(zeros, c) +
                          at(width, c) * (at(width, s) + at(below, s) - at(below, c));
        if (is_worth_merging(sum, at(width, c) + at(width, s), at(below, s))) {
          at(merged_into, c) = static_cast<StorageIndex>(s);
          at(width, s) += at(width, c);
          at(zeros, s) = sum;
        }
      }
    // parents come after their children: from the last one on, what they are a part of is final
    for (Index s = number - 1; s >= 0; --s)
      if (at(merged_into, s) != none && at(merged_into, at(merged_into, s)) != none)
        at(merged_into, s) = at(merged_into, at(merged_into, s));
    return merged_into;
  }

  // The supernodes that were not merged into others, numbered anew.
  static Supernodes
  without_merged(const Supernodes& supernodes, const std::vector<StorageIndex>& merged_into)
  {
    const Index number = supernodes.number();
    Supernodes result;
    std::vector<StorageIndex> remaining(merged_into.size(), none); // the new number of every one
    for (Index s = 0; s < number; ++s)
      if (at(merged_into, s) == none) {
        at(remaining, s) = static_cast<StorageIndex>(result.number());
        result.width.push_back(at(supernodes.width, s));
        result.below.push_back(at(supernodes.below, s));
      }
    for (Index s = 0; s < number; ++s)
      if (at(merged_into, s) != none)
        at(remaining, s) = at(remaining, at(merged_into, s));
    result.parent.assign(result.width.size(), none);
    for (Index s = 0; s < number; ++s)
      if (at(merged_into, s) == none && at(supernodes.parent, s) != none)
        at(result.parent, at(remaining, s)) = at(remaining, at(supernodes.parent, s));
    result.of_column.reserve(supernodes.of_column.size());
    for (const StorageIndex s : supernodes.of_column)
      result.of_column.push_back(at(remaining, s));
    return result;
  }

  // Where the columns, the rows and the numbers of every supernode begin, in their final order.
  void lay_out(const Supernodes& supernodes, const std::vector<StorageIndex>& order)
  {
    const Index number = supernodes.number();
    m_number_of_children.assign(static_cast<std::size_t>(number), 0);
    m_first_column.assign(static_cast<std::size_t>(number) + 1, 0);
    m_rows_begin.assign(static_cast<std::size_t>(number) + 1, 0);
    m_offset.assign(static_cast<std::size_t>(number) + 1, 0);
    for (Index r = 0; r < number; ++r) {
      const StorageIndex s = at(order, r);
      const Index width = at(supernodes.width, r), below = at(supernodes.below, r);
      at(m_first_column, s + 1) = static_cast<StorageIndex>(width);
      at(m_rows_begin, s + 1) = below;
      at(m_offset, s + 1) = width * (width + below);
      if (at(supernodes.parent, r) != none)
        ++at(m_number_of_children, at(order, at(supernodes.parent, r)));
      m_largest_below = (std::max)(m_largest_below, below);
    }
    for (Index s = 0; s < number; ++s) {
      at(m_first_column, s + 1) += at(m_first_column, s);
      at(m_rows_begin, s + 1) += at(m_rows_begin, s);
      at(m_offset, s + 1) += at(m_offset, s);
    }
    CGAL_postcondition(m_first_column.back() == size_of_matrix());
  }

  // Columns in the order of the supernodes, and within one as they were.
  void renumber_columns(const Supernodes& supernodes, const std::vector<StorageIndex>& order)
  {
    std::vector<StorageIndex> next_column = m_first_column;
    std::vector<StorageIndex> column(m_position.size());
    for (StorageIndex j = 0; j < size_of_matrix(); ++j)
      at(column, j) = at(next_column, at(order, at(supernodes.of_column, j)))++;
    for (StorageIndex& p : m_position)
      p = at(column, p);
  }

  // Lists of children in the order that needs the smallest stack of triangles: by decreasing
  // difference of what the work on a subtree needs and what remains of it (Liu 1986).
  Children children_for_small_stack(const Tree& tree, const std::vector<Index>& below)
  {
    Children children(tree);
    std::vector<Index> peak(tree.size(), 0);
    std::vector<StorageIndex> sorted;
    const auto remains = [&](const StorageIndex s) { return triangle(at(below, s)); };
    for (Index s = 0; s < static_cast<Index>(tree.size()); ++s) {
      sorted.clear();
      for (StorageIndex c = at(children.first, s); c != none; c = at(children.next, c))
        sorted.push_back(c);
      std::sort(sorted.begin(), sorted.end(), [&](const StorageIndex a, const StorageIndex b) {
        const Index of_a = at(peak, a) - remains(a), of_b = at(peak, b) - remains(b);
        return of_a != of_b ? of_a > of_b : a < b;
      });
      Index sum = 0;
      for (const StorageIndex c : sorted) {
        at(peak, s) = (std::max)(at(peak, s), sum + at(peak, c));
        sum += remains(c);
      }
      at(peak, s) = (std::max)({at(peak, s), sum, remains(static_cast<StorageIndex>(s))});
      m_stack_size = (std::max)(m_stack_size, at(peak, s));
      at(children.first, s) = none;
      for (auto it = sorted.rbegin(); it != sorted.rend(); ++it)
        children.add(*it, static_cast<StorageIndex>(s));
    }
    return children;
  }

  // The rows of a supernode are those of the matrix and those of its children.
  template <class Pattern>
  void find_rows(const Pattern& pattern)
  {
    const std::vector<StorageIndex> column = columns();
    m_rows.resize(static_cast<std::size_t>(m_rows_begin.back()));
    std::vector<Index> found_by(m_position.size(), none);
    std::vector<Index> waiting; // for their parents
    for (Index s = 0; s < number_of_supernodes(); ++s) {
      StorageIndex* end = m_rows.data() + at(m_rows_begin, s);
      const StorageIndex end_column = first_column(s + 1);
      const auto add = [&](const StorageIndex row) {
        if (row >= end_column && std::exchange(at(found_by, row), s) != s)
          *end++ = row;
      };
      for (StorageIndex j = first_column(s); j < end_column; ++j)
        for (typename Pattern::InnerIterator it(pattern, at(column, j)); it; ++it)
          add(at(m_position, it.index()));
      for (StorageIndex c = 0; c < number_of_children(s); ++c, waiting.pop_back())
        std::for_each(rows_below(waiting.back()),
                      rows_below(waiting.back()) + number_of_rows_below(waiting.back()),
                      add);
      CGAL_assertion(end == m_rows.data() + at(m_rows_begin, s + 1)); // as counted
      std::sort(m_rows.data() + at(m_rows_begin, s), end);
      if (number_of_rows_below(s) > 0)
        waiting.push_back(s);
    }
  }

  std::vector<StorageIndex> m_position;
  std::vector<StorageIndex> m_first_column; // of every supernode, and the number of columns
  std::vector<Index> m_rows_begin;
  std::vector<StorageIndex> m_rows;
  std::vector<StorageIndex> m_number_of_children;
  std::vector<Index> m_offset;
  Index m_largest_below = 0;
  Index m_stack_size = 0;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_SUPERNODAL_STRUCTURE_H
