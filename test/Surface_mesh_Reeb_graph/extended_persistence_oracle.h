// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extended persistence by the book: the boundary matrix of the cone over a complex is reduced
// column by column. Slow and simple on purpose, and sharing nothing with the code under test.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_EXTENDED_PERSISTENCE_ORACLE_H
#define SURFACE_MESH_REEB_GRAPH_TEST_EXTENDED_PERSISTENCE_ORACLE_H

#include "Index_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace Reeb_graph_test {

// A cell complex with a function that is given by the ranks of its vertices, all different.
struct Ranked_complex
{
  struct Cell
  {
    int dimension;
    std::size_t least, greatest;       // ranks of the vertices
    std::vector<std::size_t> boundary; // numbers of cells
  };
  std::vector<Cell> cells; // the vertices first, cell i being the vertex of rank i

  explicit Ranked_complex(const std::size_t number_of_vertices)
  {
    for (std::size_t i = 0; i < number_of_vertices; ++i)
      cells.push_back({0, i, i, {}});
  }

  // Adds a cell, the number of which is returned.
  std::size_t add(const int dimension, const std::vector<std::size_t>& boundary)
  {
    Cell cell = {dimension, cells.size(), 0, boundary};
    for (const std::size_t side : boundary) {
      cell.least = (std::min)(cell.least, cells[side].least);
      cell.greatest = (std::max)(cell.greatest, cells[side].greatest);
    }
    cells.push_back(cell);
    return cells.size() - 1;
  }
};

// A graph; its arcs are given by the ranks of their ends.
inline Ranked_complex
ranked_complex_of_graph(const std::size_t number_of_nodes,
                        const std::vector<std::pair<std::size_t, std::size_t>>& arcs)
{
  Ranked_complex result(number_of_nodes);
  for (const auto& arc : arcs)
    result.add(1, {arc.first, arc.second});
  return result;
}

inline Ranked_complex
ranked_complex_of_mesh(const Index_mesh& mesh, const std::vector<std::size_t>& rank)
{
  Ranked_complex result(rank.size());
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges;
  for (const auto& t : mesh.triangles) {
    std::vector<std::size_t> boundary;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<std::size_t, std::size_t> edge =
          std::minmax(rank[t[i]], rank[t[(i + 1) % 3]]);
      const auto found = edges.find(edge);
      if (found == edges.end()) {
        boundary.push_back(result.add(1, {edge.first, edge.second}));
        edges[edge] = boundary.back();
      } else {
        boundary.push_back(found->second);
      }
    }
    result.add(2, boundary);
  }
  return result;
}

enum Extended_kind { ORDINARY, RELATIVE, EXTENDED };

// A pair of ranks; of dimension 0, 1, ...
struct Extended_pair
{
  Extended_kind kind;
  int dimension;
  std::size_t birth, death;

  friend bool operator==(const Extended_pair& p, const Extended_pair& q)
  {
    return std::tie(p.kind, p.dimension, p.birth, p.death) ==
           std::tie(q.kind, q.dimension, q.birth, q.death);
  }
  friend bool operator<(const Extended_pair& p, const Extended_pair& q)
  {
    return std::tie(p.kind, p.dimension, p.birth, p.death) <
           std::tie(q.kind, q.dimension, q.birth, q.death);
  }
  friend std::ostream& operator<<(std::ostream& out, const Extended_pair& p)
  {
    const std::array<const char*, 3> names = {"ordinary", "relative", "extended"};
    return out << names[p.kind] << ' ' << p.dimension << " (" << p.birth << ", " << p.death << ')';
  }
};

// All pairs, sorted, but ordinary and relative ones of equal ranks, which are no pairs of the
// function.
inline std::vector<Extended_pair> extended_persistence(const Ranked_complex& complex)
{
  // The filtration: the tip of the cone, then the cells from the lowest to the highest, then the
  // cones over the cells from the highest to the lowest.
  const std::size_t n = complex.cells.size();
  std::vector<std::size_t> up(n), down(n);
  for (std::size_t i = 0; i < n; ++i)
    up[i] = down[i] = i;
  std::sort(up.begin(), up.end(), [&](const std::size_t i, const std::size_t j) {
    const auto &a = complex.cells[i], &b = complex.cells[j];
    return std::tie(a.greatest, a.dimension, i) < std::tie(b.greatest, b.dimension, j);
  });
  std::sort(down.begin(), down.end(), [&](const std::size_t i, const std::size_t j) {
    const auto &a = complex.cells[i], &b = complex.cells[j];
    return std::tie(b.least, a.dimension, i) < std::tie(a.least, b.dimension, j);
  });
  std::vector<std::size_t> position(n), cone_position(n);
  for (std::size_t k = 0; k < n; ++k) {
    position[up[k]] = 1 + k;
    cone_position[down[k]] = 1 + n + k;
  }

  std::vector<std::vector<std::size_t>> columns(1 + 2 * n); // sorted
  for (std::size_t i = 0; i < n; ++i) {
    auto& column = columns[position[i]];
    auto& cone_column = columns[cone_position[i]];
    for (const std::size_t side : complex.cells[i].boundary) {
      column.push_back(position[side]);
      cone_column.push_back(cone_position[side]);
    }
    cone_column.push_back(position[i]);
    if (complex.cells[i].dimension == 0)
      cone_column.push_back(0);
    std::sort(column.begin(), column.end());
    std::sort(cone_column.begin(), cone_column.end());
  }

  std::vector<Extended_pair> pairs;
  std::vector<std::size_t> column_of_lowest(columns.size(), columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    std::vector<std::size_t>& column = columns[j];
    while (!column.empty() && column_of_lowest[column.back()] < columns.size()) {
      std::vector<std::size_t> sum;
      const std::vector<std::size_t>& other = columns[column_of_lowest[column.back()]];
      std::set_symmetric_difference(
          column.begin(), column.end(), other.begin(), other.end(), std::back_inserter(sum));
      column.swap(sum);
    }
    if (column.empty())
      continue;
    const std::size_t i = column.back();
    column_of_lowest[i] = j;
    if (j <= n) {
      const auto &birth = complex.cells[up[i - 1]], &death = complex.cells[up[j - 1]];
      if (birth.greatest != death.greatest)
        pairs.push_back({ORDINARY, birth.dimension, birth.greatest, death.greatest});
    } else if (i <= n) {
      const auto &birth = complex.cells[up[i - 1]], &death = complex.cells[down[j - 1 - n]];
      pairs.push_back({EXTENDED, birth.dimension, birth.greatest, death.least});
    } else {
      const auto &birth = complex.cells[down[i - 1 - n]], &death = complex.cells[down[j - 1 - n]];
      if (birth.least != death.least)
        pairs.push_back({RELATIVE, birth.dimension + 1, birth.least, death.least});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_EXTENDED_PERSISTENCE_ORACLE_H
