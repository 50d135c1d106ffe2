// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_DISTANCES_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Mesh_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Plain_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_coordinates.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/spectral/Heat_solver.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/exceptions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

Geodesic distances on a triangle mesh, by the heat method (\cgalCite{crane_2013}) as it is implemented
in the \cgal package Heat_method_3, which this class wraps so that it suits functions for Reeb graphs:

- The mesh is prepared and factored once, by the constructor; every set of sources afterwards takes
  sparse solutions only.
- Every connected component is seen alone, scaled to mean edge length 1. Isolated vertices are no
  error, and one component does not change the distances in another.
- Where no source is, the distance is the largest one that occurs elsewhere: finite and constant, so
  that a Reeb graph of the distances has no more than the two ends that a constant function has there.
- Long and thin shapes are no error, either: that heat is no number any more some 700 edges away from the
  sources does not matter.
- Degenerate faces do no harm: their corners are moved by about a millionth of the mean edge length.

The distances are approximate, with errors in proportion to the edge length: about one percent on a
sphere with 2562 vertices. Surfaces with borders are fine; distances there are along the surface, and a
little too large near borders that a geodesic meets at a small angle.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam Mode `CGAL::Heat_method_3::Intrinsic_Delaunay`, or `CGAL::Heat_method_3::Direct`, which is
        faster and worse on meshes with obtuse angles

\sa `geodesic_distance_function()`
\sa `integral_geodesic_distance_function()`
\sa `crossed_feature_points()`
*/
template <class TriangleMesh, class Mode = CGAL::Heat_method_3::Intrinsic_Delaunay>
class Geodesic_distances
{
public:
  /// \name Types
  /// @{

  /// the type of the vertices
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// @}
  /// \name Creation
  /// @{

  /*!
  prepares the mesh.

  \tparam NamedParameters a sequence of
          \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

  \param tmesh the mesh; it must outlive this object
  \param np an optional sequence of named parameters among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
      \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Takes two sparse factorizations per component, O(n^1.5) time, and O(n log n) memory for *n* vertices.

  \throws Input_error if a face is not a triangle, a coordinate not a finite number, or the mesh not a
          2-manifold
  \throws Numerical_error if a factorization fails
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Geodesic_distances(const TriangleMesh& tmesh,
                              const NamedParameters& np = CGAL::parameters::default_values())
    : m_tmesh(&tmesh), m_components(tmesh)
  {
    const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
    internal::check_triangles(tmesh);
    internal::check_halfedges(tmesh, CGAL::get_initialized_vertex_index_map(tmesh));
    internal::check_coordinates(tmesh, vertex_point_map);
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      m_parts.push_back(std::make_unique<Part>());
      Part& part = *m_parts.back();
      part.plain = internal::plain_mesh(tmesh, vertex_point_map, m_components, c);
      if (part.plain.unit > 0)
        call([&]() { part.heat = std::make_unique<Heat>(part.plain.mesh); });
    }
  }

  /// \cond SKIP_IN_MANUAL

  // It refers to the mesh: a temporary one would be gone.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Geodesic_distances(const TriangleMesh&&,
                              const NamedParameters& = CGAL::parameters::default_values()) = delete;

  /// \endcond

  /// @}
  /// \name Distances
  /// @{

  /*!
  writes the distances of all vertices from the nearest source.

  \tparam VertexRange a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
  \tparam VertexDistanceMap a model of `WritablePropertyMap` with
          `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
          type

  \param sources the sources; there may be none
  \param distances receives the distances, in the unit of the coordinates: 0 at sources; in components
         without sources the largest distance of all others, 0 if there are none

  Takes O(n log n) time for *n* vertices, plus O(n m) for *m* sources.

  \throws Numerical_error if the heat method does not find the distances
  */
  template <class VertexRange, class VertexDistanceMap>
  void write_distances(const VertexRange& sources, VertexDistanceMap distances)
  {
    std::vector<std::vector<std::size_t>> positions(m_components.size());
    for (vertex_descriptor v : sources)
      positions[m_components.component_of(v)].push_back(m_components.position_of(v));
    std::vector<std::vector<double>> results; // all of them before anything is written
    double largest = 0;
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      results.emplace_back();
      if (positions[c].empty())
        continue;
      results.back() = component_distances(c, positions[c]);
      largest =
          (std::max)(largest, *std::max_element(results.back().begin(), results.back().end()));
    }
    for (std::size_t c = 0; c < m_components.size(); ++c)
      for (std::size_t i = 0; i < m_components[c].vertices.size(); ++i)
        put(distances, m_components[c].vertices[i], results[c].empty() ? largest : results[c][i]);
  }

  /// @}
  /// \name Access
  /// @{

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return *m_tmesh; }

  /// returns the number of connected components of the mesh, isolated vertices included.
  std::size_t number_of_components() const { return m_components.size(); }

  /// returns the component of `v`; components are numbered in the order of their first vertices.
  std::size_t component(vertex_descriptor v) const { return m_components.component_of(v); }

  /// returns the vertices of component `c`, in the order of the mesh.
  /// \pre `c < number_of_components()`
  const std::vector<vertex_descriptor>& component_vertices(std::size_t c) const
  {
    CGAL_precondition(c < number_of_components());
    return m_components[c].vertices;
  }

  /// @}

  /// \cond SKIP_IN_MANUAL

  std::size_t position(vertex_descriptor v) const { return m_components.position_of(v); }

  // A third of the area of the faces of every vertex, by positions.
  std::vector<double> vertex_areas(std::size_t c) const
  {
    const internal::Plain_mesh& plain = m_parts[c]->plain;
    std::vector<double> areas = plain.vertex_areas;
    for (double& area : areas)
      area *= plain.unit * plain.unit;
    return areas;
  }

  // The distances of the vertices of a component from sources in it, by positions.
  std::vector<double> component_distances(std::size_t c, const std::vector<std::size_t>& sources)
  {
    CGAL_precondition(!sources.empty());
    Part& part = *m_parts[c];
    std::vector<double> result(m_components[c].vertices.size(), 0.);
    if (!part.heat)
      return result; // without extent
    using Plain_vertex =
        typename boost::graph_traits<internal::Plain_mesh::Mesh>::vertex_descriptor;
    const auto map = get(CGAL::dynamic_vertex_property_t<double>(), part.plain.mesh);
    call([&]() {
      part.heat->clear_sources();
      for (const std::size_t i : sources)
        part.heat->add_source(part.plain.vertices[i]);
      part.heat->estimate_geodesic_distances(map);
    });
    std::size_t i = 0;
    for (const Plain_vertex v : part.plain.vertices) {
      // CGAL leaves the largest number where it finds no distance
      const double distance = get(map, v);
      if (!(distance < (std::numeric_limits<double>::max)()))
        throw Numerical_error("the heat method found no geodesic distance");
      result[i] = distance * part.plain.unit;
      ++i;
    }
    for (const std::size_t source : sources)
      CGAL_assertion(result[source] == 0);
    return result;
  }

  /// \endcond

private:
  using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<
      internal::Plain_mesh::Mesh,
      Mode,
      CGAL::Default,
      CGAL::Eigen_solver_traits<internal::Heat_solver>>;

  // What the heat method refers to must not move.
  struct Part
  {
    internal::Plain_mesh plain;
    std::unique_ptr<Heat> heat; // none for components without extent
  };

  // CGAL fails with an assertion where a factorization does.
  template <class Function>
  static void call(const Function& function)
  {
    try {
      function();
    } catch (const CGAL::Failure_exception& failure) {
      throw Numerical_error("the heat method failed: " + failure.message());
    }
  }

  const TriangleMesh* m_tmesh;
  internal::Mesh_components<TriangleMesh> m_components;
  std::vector<std::unique_ptr<Part>> m_parts; // by component
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_DISTANCES_H
