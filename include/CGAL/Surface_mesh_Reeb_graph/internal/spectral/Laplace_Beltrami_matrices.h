// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_LAPLACE_BELTRAMI_MATRICES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_LAPLACE_BELTRAMI_MATRICES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_Delaunay.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangle.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Intrinsic_triangulation.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/huge_pages.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The Laplace-Beltrami operator of one connected component with n vertices, discretized with linear
// elements on the lengths of the edges.
//
// The triangles are those of the mesh with mollified lengths (see `Intrinsic_triangulation`) or,
// optionally, those of the intrinsic Delaunay triangulation of the same surface (see
// `Intrinsic_Delaunay`), for which no coefficient outside of the diagonal is positive but those of
// edges on a border opposite to an obtuse angle.
//
// Nothing is imposed on borders: this is the Neumann condition.
struct Laplace_Beltrami_matrices
{
  double unit = 0; // the mean edge length
  Eigen::SparseMatrix<double>
      stiffness;        // n x n, symmetric, positive semi-definite: half the sum of
                        // the cotangents opposite to an edge, with negative sign
  Eigen::VectorXd mass; // n mixed Voronoi areas, in squared units
  double area = 0;      // their sum, in squared units
};

// Makes a stiffness matrix from the weights of the sides of triangles: an entry is at most the sum
// of two. Every column has room for all that its triangles add to it, so that nothing has to be
// sorted but short columns.
class Stiffness_assembly
{
public:
  Stiffness_assembly(Eigen::Index n,
                     const std::vector<Intrinsic_triangulation::Triangle>& triangles)
    : m_diagonal(Eigen::VectorXd::Zero(n)), m_end(static_cast<std::size_t>(n) + 1, 0)
  {
    for (const Intrinsic_triangulation::Triangle& triangle : triangles)
      for (const std::uint32_t corner : triangle.corners)
        m_end[corner + 1] += 2;
    for (std::size_t i = 1; i < m_end.size(); ++i)
      m_end[i] += m_end[i - 1];
    m_begin = m_end;
    m_entries.resize(m_end.back());
    m_end.pop_back(); // the end of every column so far, in the order of the columns
  }

  void add_edge(std::uint32_t u, std::uint32_t v, double weight)
  {
    CGAL_precondition(u < m_end.size() && v < m_end.size());
    if (u == v)
      return; // functions do not differ between the ends of such an edge
    CGAL_assertion(m_end[u] < m_begin[u + 1] && m_end[v] < m_begin[v + 1]); // as counted
    m_entries[m_end[u]++] = {v, -weight};
    m_entries[m_end[v]++] = {u, -weight};
    m_diagonal[u] += weight;
    m_diagonal[v] += weight;
  }

  void write(Eigen::SparseMatrix<double>& matrix)
  {
    const Eigen::Index n = m_diagonal.size();
    std::size_t size = static_cast<std::size_t>(n);
    for (std::size_t j = 0; j < m_end.size(); ++j) {
      m_end[j] =
          sum_up(m_entries.data() + m_begin[j], m_entries.data() + m_end[j]) - m_entries.data();
      size += m_end[j] - m_begin[j];
    }
    matrix.resize(n, n);
    matrix.reserve(static_cast<Eigen::Index>(size));
    prefer_huge_pages(matrix.valuePtr(), size);
    prefer_huge_pages(matrix.innerIndexPtr(), size);
    for (Eigen::Index j = 0; j < n; ++j) {
      matrix.startVec(j);
      bool has_diagonal = false;
      const auto insert_diagonal = [&]() {
        matrix.insertBack(j, j) = m_diagonal[j];
        has_diagonal = true;
      };
      for (std::size_t k = m_begin[static_cast<std::size_t>(j)];
           k < m_end[static_cast<std::size_t>(j)];
           ++k)
      {
        if (!has_diagonal && static_cast<Eigen::Index>(m_entries[k].row) > j)
          insert_diagonal();
        matrix.insertBack(m_entries[k].row, j) = m_entries[k].value;
      }
      if (!has_diagonal)
        insert_diagonal();
    }
    matrix.finalize();
  }

private:
  struct Entry
  {
    std::uint32_t row;
    double value;
  };

  // Sorts entries by their rows, and puts those of one row together; returns the new end.
  static Entry* sum_up(Entry* begin, Entry* end)
  {
    std::sort(begin, end, [](const Entry& a, const Entry& b) {
      // values, too, so that the order of summation does not depend on that of the triangles
      return std::tie(a.row, a.value) < std::tie(b.row, b.value);
    });
    Entry* last = begin;
    for (Entry* entry = begin; entry != end; ++entry) {
      if (last != begin && (last - 1)->row == entry->row)
        (last - 1)->value += entry->value;
      else
        *last++ = *entry;
    }
    return last;
  }

  Eigen::VectorXd m_diagonal;
  std::vector<std::size_t> m_begin, m_end; // of the entries of every column outside of the diagonal
  std::vector<Entry, Huge_page_allocator<Entry>> m_entries;
};

// A component without extent (all edges of length 0, or no faces) gives matrices with `area == 0`.
template <class TriangleMesh, class VertexPointMap>
Laplace_Beltrami_matrices
assemble_Laplace_Beltrami_matrices(const TriangleMesh& tmesh,
                                   VertexPointMap vertex_point_map,
                                   const Mesh_components<TriangleMesh>& components,
                                   std::size_t component_number,
                                   bool use_intrinsic_Delaunay = false)
{
  CGAL_precondition(component_number < components.size());
  Intrinsic_triangulation triangulation =
      intrinsic_triangulation(tmesh, vertex_point_map, components, component_number);
  if (use_intrinsic_Delaunay && !triangulation.triangles.empty()) {
    std::vector<Triangle_side> glued = glued_sides(tmesh, components, component_number);
    Intrinsic_Delaunay(triangulation, glued).flip_all();
  }

  Laplace_Beltrami_matrices result;
  const Eigen::Index n = static_cast<Eigen::Index>(components[component_number].vertices.size());
  result.unit = triangulation.unit;
  result.mass = Eigen::VectorXd::Zero(n);
  Stiffness_assembly assembly(n, triangulation.triangles);
  for (const Intrinsic_triangulation::Triangle& triangle : triangulation.triangles) {
    const Intrinsic_triangle t(triangle.lengths);
    result.area += t.area();
    for (int i = 0; i < 3; ++i) {
      result.mass[triangle.corners[i]] += t.mixed_voronoi_area(i);
      assembly.add_edge(
          triangle.corners[(i + 1) % 3], triangle.corners[(i + 2) % 3], t.cotangent(i) / 2);
    }
  }
  assembly.write(result.stiffness);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SPECTRAL_LAPLACE_BELTRAMI_MATRICES_H
