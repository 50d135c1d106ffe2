// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_SIGNATURE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_SIGNATURE_H

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_signature.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/Indexed_surface.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

What shapes are retrieved by: the signature of a Reeb graph, with what its arcs carry on the surface,
and the spectrum. It is some 53 kilobytes of text, whatever the size of the mesh. Lengths are those
after scaling to area 1, so that nothing but the function's own values depends on the size.

\sa `compute_shape_signature()`
\sa `shape_distance()`
\sa `IO::write_shape_signature()`
*/
struct Shape_signature
{
  /// the signature of the Reeb graph, which has not been simplified
  Reeb_graph_signature graph;
  /// the girths of the shape along the arcs of the graph: for 32 levels that halve bands of equal
  /// area the lengths of the 6 longest components of the level set in decreasing order, or zeros
  std::vector<double> section_lengths;
  /// the first 20 eigenvalues after 0 of the Laplace-Beltrami operator, times the area (ShapeDNA,
  /// \cgalCite{reuter_2006}), those of all components of the mesh together; zeros where there are no more
  std::vector<double> eigenvalues;
  /// for the 10 pairs of the four bands between the quartiles of the function 16 quantiles of the
  /// distance of two points in space
  std::vector<double> band_distances;
  /// the volume
  double volume = 0;
};

namespace internal {

constexpr std::size_t number_of_signature_eigenvalues = 20;

template <class Eigenbasis>
std::vector<double> normalized_eigenvalues(const Eigenbasis& basis)
{
  double area = 0;
  std::vector<double> result;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c) {
    area += basis.area(c);
    // every component of the surface but the first one adds an eigenvalue zero
    if (c > 0 && basis.area(c) > 0)
      result.push_back(0.);
    for (std::size_t k = 1; k <= basis.number_of_eigenpairs(c); ++k)
      result.push_back(basis.eigenvalue(c, k));
  }
  std::sort(result.begin(), result.end());
  result.resize(number_of_signature_eigenvalues, 0.);
  for (double& value : result)
    value *= area;
  return result;
}

template <class TriangleMesh, class VertexScalarMap, class VertexPointMap, class VertexIndexMap>
Indexed_surface indexed_surface(const TriangleMesh& tmesh,
                                VertexScalarMap scalar_map,
                                VertexPointMap vertex_point_map,
                                VertexIndexMap vertex_index_map)
{
  const std::size_t n = index_bound(tmesh, vertex_index_map);
  std::vector<Eigen::Vector3d> points(n, Eigen::Vector3d::Zero());
  std::vector<double> values(n, 0.);
  for (const auto v : CGAL::make_range(vertices(tmesh))) {
    const auto i = static_cast<std::size_t>(get(vertex_index_map, v));
    const auto& p = get(vertex_point_map, v);
    points[i] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    values[i] = CGAL::to_double(get(scalar_map, v));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto f : CGAL::make_range(faces(tmesh))) {
    const auto h = halfedge(f, tmesh);
    const auto number = [&](auto v) {
      return static_cast<std::uint32_t>(get(vertex_index_map, v));
    };
    triangles.push_back({{number(source(h, tmesh)),
                          number(target(h, tmesh)),
                          number(target(next(h, tmesh), tmesh))}});
  }
  return Indexed_surface(std::move(points),
                         std::move(triangles),
                         std::move(values),
                         barycentric_areas(tmesh, vertex_point_map, vertex_index_map));
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the signature of a shape by the Reeb graph of a function on it.

\tparam TriangleMesh, Eigensolver, EigenfunctionNumber as in `Laplace_Beltrami_eigenbasis`
\tparam VertexScalarMap as in `compute_Reeb_graph_signature()`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param basis the eigenbasis of the mesh, with 20 eigenpairs at least
\param scalar_map the function, for example `commute_time_function()`
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Borders and several components are normal input. The volume of a surface with a border is that of
the cones of its faces over the center.

Takes O(n log n) time for *n* vertices and faces, without the eigenbasis.

\throws Error as `compute_Reeb_graph()` and `compute_Reeb_graph_signature()`

\sa `shape_distance()`
*/
template <class TriangleMesh,
          class Eigensolver,
          class EigenfunctionNumber,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Shape_signature compute_shape_signature(
    const Laplace_Beltrami_eigenbasis<TriangleMesh, Eigensolver, EigenfunctionNumber>& basis,
    VertexScalarMap scalar_map,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  const TriangleMesh& tmesh = basis.triangle_mesh();
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  Reeb_graph<TriangleMesh> graph;
  const auto arcs = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);
  compute_Reeb_graph(tmesh,
                     scalar_map,
                     graph,
                     parameters::vertex_arc_map(arcs).vertex_index_map(vertex_index_map));

  Shape_signature signature;
  signature.graph = compute_Reeb_graph_signature(tmesh, scalar_map, graph, arcs, np);
  const internal::Indexed_surface surface = internal::indexed_surface(
      tmesh, scalar_map, internal::vertex_point_map(tmesh, np), vertex_index_map);
  signature.section_lengths = surface.section_lengths();
  signature.eigenvalues = internal::normalized_eigenvalues(basis);
  signature.band_distances = surface.band_distances();
  signature.volume = surface.volume();
  return signature;
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns the distance of two shapes: the sum of the distance of the Reeb graphs and of the mean
differences of section lengths, logarithms of eigenvalues (plus 1), distances between bands, and the
logarithm of the volume (plus 0.01), each divided by a constant that makes the parts comparable.

It is a pseudo-metric, as all its parts are.

\param a, b signatures from `compute_shape_signature()`

Takes O(1) time.

\pre both have lists of the right lengths, as `compute_shape_signature()` makes them
*/
inline double shape_distance(const Shape_signature& a, const Shape_signature& b)
{
  return Reeb_graph_distance(a.graph, b.graph) / .002 +
         internal::mean_difference(a.section_lengths, b.section_lengths) / .37 +
         internal::mean_logarithmic_difference(a.eigenvalues, b.eigenvalues, 1) / .9 +
         internal::mean_difference(a.band_distances, b.band_distances) / .19 +
         internal::mean_logarithmic_difference({a.volume}, {b.volume}, .01) / .018;
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns the distance of the spectra of two shapes (ShapeDNA, \cgalCite{reuter_2006}): the Euclidean
distance of the roots of the first 12 eigenvalues after 0, after scaling to area 1.

\param a, b signatures from `compute_shape_signature()`

It is a pseudo-metric.
*/
inline double spectral_shape_distance(const Shape_signature& a, const Shape_signature& b)
{
  constexpr std::size_t number = 12;
  CGAL_precondition(a.eigenvalues.size() >= number && b.eigenvalues.size() >= number);
  double sum = 0;
  for (std::size_t k = 0; k < number; ++k) {
    const double difference = std::sqrt(a.eigenvalues[k]) - std::sqrt(b.eigenvalues[k]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SHAPE_SIGNATURE_H
