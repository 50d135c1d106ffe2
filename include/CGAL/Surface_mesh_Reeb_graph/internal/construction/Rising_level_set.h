// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_RISING_LEVEL_SET_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_RISING_LEVEL_SET_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Splay_sequences.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The components of a level set that rises, each as the sequence of the edges that it crosses,
// closed or from border to border. Elements of edges that are not crossed any more are deleted
// lazily, if at all: they change neither the order of the others nor which sequence these are in.
class Rising_level_set
{
  using Sequences = Splay_sequences<Sequence_number>;

public:
  static constexpr std::uint32_t no_element = Sequences::no_item;

  // A run of edges around a vertex in cyclic order: a lower one by its first and last element in
  // the sequence; an upper one by the number of its edges, to which new elements are given.
  struct Run
  {
    bool is_upper;
    bool is_linked; // to the next run, by a face
    std::uint32_t first, last;
    std::size_t size;
    std::uint32_t
        lowest; // an upper one: its components are put in the order of the smallest of these
    std::size_t elements_begin; // an upper one: where its elements are, in the order of its edges
  };

  // A component of the level set above the vertex.
  struct Component
  {
    std::uint32_t root, lowest;
    bool is_closed;
  };

  // Gives `size` upper edges the elements of the lower ones, from the first of the former to the
  // last of the latter; more are added as needed: what a regular vertex does.
  void replace(std::vector<std::uint32_t>& run, std::size_t size)
  {
    CGAL_precondition(!run.empty() && size > 0);
    while (run.size() < size)
      run.push_back(m_sequences.insert_after(run.back()));
    run.resize(size);
    std::reverse(run.begin(), run.end());
  }

  // Prefetches an element; it may be none.
  void prefetch_element(std::uint32_t element) const { m_sequences.prefetch_item(element); }

  // The arc that a component belongs to, by one of its elements.
  std::uint32_t arc(std::uint32_t element)
  {
    m_sequences.splay(element);
    const std::uint32_t number = m_sequences.number(element);
    if (number >= m_states.size())
      throw_internal_error("a part of the level set has no arc");
    return m_states[number].arc;
  }

  // Lets the level rise past a vertex: cuts the lower runs out of their components and puts
  // together what is left with the upper runs. `arcs_below` receives the arcs of the components
  // below.
  void pass(std::vector<Run>& runs, std::vector<std::uint32_t>& arcs_below)
  {
    const std::size_t number = runs.size();
    arcs_below.clear();
    components.clear();
    elements.clear();
    m_pieces.clear();
    m_left_of_gap.assign(number, no_piece);
    m_right_of_gap.assign(number, no_piece);
    for (std::size_t i = 0; i < number; ++i)
      if (!runs[i].is_upper)
        cut_out(runs, i, arcs_below);
    for (std::size_t i = 0; i < number; ++i)
      if (runs[i].is_upper)
        put_in(runs, i);
    for (const Piece& piece : m_pieces)
      if (piece.is_upper && !piece.is_used)
        components.push_back({piece.root, piece.lowest, false});
    if (components.size() > 1)
      sort_components(number);
  }

  // To be called for every component that `pass()` has made.
  void set_arc(const Component& component, std::uint32_t arc)
  {
    CGAL_assertion(m_states.size() < first_piece_number - m_pieces.size());
    m_sequences.number(component.root) = static_cast<std::uint32_t>(m_states.size());
    m_states.push_back({arc, component.is_closed});
  }

  // Of the last vertex passed:
  std::vector<Component> components;   // above it
  std::vector<std::uint32_t> elements; // of the upper runs

private:
  struct State
  {
    std::uint32_t arc;
    bool is_closed;
  };

  // A part of a component that lies outside of the runs. Its ends are at gaps between runs, or at
  // the border. Gap i lies between run i and the next one.
  struct Piece
  {
    std::uint32_t root;
    std::size_t left_gap, right_gap;
    bool is_upper = false;
    bool is_used = false;
    std::uint32_t lowest = no_element;
  };

  static constexpr std::size_t no_gap = (std::numeric_limits<std::size_t>::max)();
  static constexpr std::size_t no_piece = no_gap;
  // numbers of sequences that are pieces by now, counted down from here
  static constexpr std::uint32_t first_piece_number = Sequences::no_item - 1;

  static std::size_t gap_before(const std::vector<Run>& runs, std::size_t i)
  {
    const std::size_t previous = i == 0 ? runs.size() - 1 : i - 1;
    return runs[previous].is_linked ? previous : no_gap;
  }

  static std::size_t gap_after(const std::vector<Run>& runs, std::size_t i)
  {
    return runs[i].is_linked ? i : no_gap;
  }

  std::size_t add_piece(const Piece& piece)
  {
    const std::size_t i = m_pieces.size();
    m_pieces.push_back(piece);
    if (piece.left_gap != no_gap)
      m_right_of_gap[piece.left_gap] = i;
    if (piece.right_gap != no_gap)
      m_left_of_gap[piece.right_gap] = i;
    if (piece.root != no_element)
      m_sequences.number(piece.root) = first_piece_number - static_cast<std::uint32_t>(i);
    return i;
  }

  void cut_out(const std::vector<Run>& runs, std::size_t i, std::vector<std::uint32_t>& arcs_below)
  {
    const std::uint32_t first = runs[i].first, last = runs[i].last;
    const std::size_t before = gap_before(runs, i), after = gap_after(runs, i);
    m_sequences.splay(first);
    const std::uint32_t number = m_sequences.number(first);
    const bool is_piece = number >= m_states.size();
    std::size_t left_gap = no_gap, right_gap = no_gap;
    if (is_piece) {
      if (first_piece_number - number >= m_pieces.size())
        throw_internal_error("a part of the level set has got lost");
      Piece& piece = m_pieces[first_piece_number - number];
      left_gap = piece.left_gap;
      right_gap = piece.right_gap;
      piece.is_used = true;
    } else {
      arcs_below.push_back(m_states[number].arc);
      if (m_states[number].is_closed) {
        const std::uint32_t end = m_sequences.cut_before(first);
        m_sequences.join(first, end);
        m_sequences.splay(last);
        add_piece({m_sequences.cut_after(last), after, before});
        return;
      }
    }
    const std::uint32_t left = m_sequences.cut_before(first);
    m_sequences.splay(last);
    const std::uint32_t right = m_sequences.cut_after(last);
    add_piece({left, left_gap, before});
    add_piece({right, after, right_gap});
  }

  // By `lowest`: these are different numbers, less than that of the runs.
  void sort_components(std::size_t number_of_runs)
  {
    m_component_of_lowest.assign(number_of_runs, {no_element, 0, false});
    for (const Component& component : components) {
      CGAL_assertion(m_component_of_lowest[component.lowest].root == no_element);
      m_component_of_lowest[component.lowest] = component;
    }
    components.clear();
    for (const Component& component : m_component_of_lowest)
      if (component.root != no_element)
        components.push_back(component);
  }

  void put_in(std::vector<Run>& runs, std::size_t i)
  {
    Run& run = runs[i];
    std::uint32_t root = m_sequences.add();
    run.elements_begin = elements.size();
    elements.push_back(root);
    for (std::size_t k = 1; k < run.size; ++k)
      elements.push_back(root = m_sequences.insert_after(root));
    // seen from the level set, the edges of upper runs come in reversed order
    std::reverse(elements.begin() + static_cast<std::ptrdiff_t>(run.elements_begin),
                 elements.end());
    const std::size_t before = gap_before(runs, i), after = gap_after(runs, i);
    const std::size_t left = after == no_gap ? no_piece : m_left_of_gap[after];
    const std::size_t right = before == no_gap ? no_piece : m_right_of_gap[before];
    const bool is_alone = runs.size() == 1 && run.is_linked;
    if (is_alone || (left != no_piece && left == right)) {
      Component component = {root, run.lowest, true};
      if (!is_alone) {
        component.root = m_sequences.join(root, m_pieces[left].root);
        component.lowest = (std::min)(component.lowest, m_pieces[left].lowest);
        m_pieces[left].is_used = true;
      }
      components.push_back(component);
      return;
    }
    Piece piece = {root, no_gap, no_gap};
    piece.is_upper = true;
    piece.lowest = run.lowest;
    if (left != no_piece) {
      piece.root = m_sequences.join(m_pieces[left].root, piece.root);
      piece.left_gap = m_pieces[left].left_gap;
      piece.lowest = (std::min)(piece.lowest, m_pieces[left].lowest);
      m_pieces[left].is_used = true;
    }
    if (right != no_piece) {
      piece.root = m_sequences.join(piece.root, m_pieces[right].root);
      piece.right_gap = m_pieces[right].right_gap;
      piece.lowest = (std::min)(piece.lowest, m_pieces[right].lowest);
      m_pieces[right].is_used = true;
    }
    add_piece(piece);
  }

  Sequences m_sequences;
  std::vector<State> m_states; // of components, by the numbers of their sequences
  std::vector<Piece> m_pieces;
  std::vector<std::size_t> m_left_of_gap, m_right_of_gap; // pieces that end there
  std::vector<Component> m_component_of_lowest;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_RISING_LEVEL_SET_H
