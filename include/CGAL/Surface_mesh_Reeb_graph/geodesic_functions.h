// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_FUNCTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_FUNCTIONS_H

#include <CGAL/Surface_mesh_Reeb_graph/Geodesic_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

inline std::size_t position_of_largest(const std::vector<double>& values)
{
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

// Two vertices of a component that are far apart, found by going to the farthest vertex several times;
// the distances from both.
struct Far_pair
{
  std::size_t first = 0, second = 0;
  std::vector<double> from_first, from_second;
};

template <class Geodesics>
Far_pair far_pair(Geodesics& geodesics, std::size_t c)
{
  Far_pair pair;
  pair.first = position_of_largest(geodesics.component_distances(c, {0}));
  pair.from_first = geodesics.component_distances(c, {pair.first});
  constexpr int number_of_steps = 3; // hardly ever is there a third better one
  for (int i = 0;; ++i) {
    pair.second = position_of_largest(pair.from_first);
    pair.from_second = geodesics.component_distances(c, {pair.second});
    const std::size_t farthest = position_of_largest(pair.from_second);
    if (i == number_of_steps || !(pair.from_second[farthest] > pair.from_first[pair.second]))
      return pair;
    pair.first = pair.second;
    pair.from_first = std::move(pair.from_second);
  }
}

// The positions of vertices whose values are larger than those of all neighbors, or smaller. Equal
// values are told apart by their positions.
template <class Geodesics>
std::vector<std::size_t>
local_extrema(const Geodesics& geodesics, std::size_t c, const std::vector<double>& values)
{
  std::vector<std::size_t> result;
  const auto& component_vertices = geodesics.component_vertices(c);
  for (std::size_t i = 0; i < component_vertices.size(); ++i) {
    std::size_t smaller = 0, larger = 0;
    for_each_neighbor(component_vertices[i], geodesics.triangle_mesh(), [&](auto neighbor) {
      const std::size_t j = geodesics.position(neighbor);
      ++(std::make_pair(values[j], j) < std::make_pair(values[i], i) ? smaller : larger);
    });
    if (smaller == 0 || larger == 0)
      result.push_back(i);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the geodesic distance of every vertex to the nearest source, as
`Geodesic_distances::write_distances()` does, for one set of sources.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexRange a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param sources the sources
\param values receives the distances, in the unit of the coordinates: 0 at sources; in components
       without sources the largest distance of all others, 0 if there are none
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{use_intrinsic_Delaunay}
    \cgalParamDescription{whether the heat method works on the intrinsic Delaunay triangulation of the surface}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes two sparse factorizations per component, O(n^1.5) time for *n* vertices. Who has several sets of
sources factors once with `Geodesic_distances`.

\throws Error as `Geodesic_distances`; all outputs are then left as they were
*/
template <class TriangleMesh,
          class VertexRange,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void geodesic_distance_function(const TriangleMesh& tmesh,
                                const VertexRange& sources,
                                VertexScalarMap values,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  // the other mode is compiled only for those who may choose it
  if constexpr (!CGAL::parameters::is_default_parameter<
                    NamedParameters,
                    internal::tags::use_intrinsic_Delaunay_t>::value)
    if (!internal::get_own_parameter(np, internal::tags::use_intrinsic_Delaunay)) {
      Geodesic_distances<TriangleMesh, CGAL::Heat_method_3::Direct>(tmesh, np).write_distances(
          sources, values);
      return;
    }
  Geodesic_distances<TriangleMesh>(tmesh, np).write_distances(sources, values);
}

/*!
\ingroup PkgSurfaceMeshReebGraphMappingFunctions

computes the integral geodesic distance (\cgalCite{hilaga_2001}): the integral of the geodesic
distance over the connected component, `f(v) = sum_i d(v, b_i) area(b_i)`, where the base points `b_i`
are spread over the surface and `area(b_i)` is that of the vertices that are nearest to `b_i`. It is
smallest in the center of the shape and largest on the tips of its limbs. It does not depend on the
pose, nor on any source.

The source paper then subtracts the minimum and divides by the maximum, which changes no Reeb graph.

\tparam TriangleMesh, Mode as in `Geodesic_distances`
\tparam VertexScalarMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value
        type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param geodesics the distances of the mesh; sets of sources are computed with it
\param values receives the function, in the third power of the unit of the coordinates; 0 for isolated
       vertices
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{base_point_radius}
    \cgalParamDescription{base points are added, each the vertex farthest from those before, until no vertex is farther from all of them than this, in units of the square root of the area of the component}
    \cgalParamType{`double`, not negative; with 0 all vertices are base points}
    \cgalParamDefault{`sqrt(0.005)`, about 0.07, as in the source paper: some hundred base points}
  \cgalParamNEnd
\cgalNamedParamsEnd

Borders need no care, and every component is seen alone. The first base point is the vertex farthest
from the first vertex of the component; only by that does the result depend on the numbering.

Takes O(b n log n) time and O(b n) memory for *n* vertices and *b* base points.

\pre `base_point_radius` is not negative

\throws Numerical_error as `Geodesic_distances::write_distances()`; all outputs are then left as they
        were
*/
template <class TriangleMesh,
          class Mode,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void integral_geodesic_distance_function(
    Geodesic_distances<TriangleMesh, Mode>& geodesics,
    VertexScalarMap values,
    const NamedParameters& np = CGAL::parameters::default_values())
{
  const double radius =
      internal::choose_own_parameter(np, internal::tags::base_point_radius, std::sqrt(0.005));
  CGAL_precondition(radius >= 0);
  std::vector<std::vector<double>> results; // all of them before anything is written
  for (std::size_t c = 0; c < geodesics.number_of_components(); ++c) {
    const std::size_t n = geodesics.component_vertices(c).size();
    results.emplace_back(n, 0.);
    const std::vector<double> areas = geodesics.vertex_areas(c);
    const double area = std::accumulate(areas.begin(), areas.end(), 0.);
    if (!(area > 0))
      continue;
    std::vector<double> nearest(n, (std::numeric_limits<double>::infinity)());
    std::vector<std::size_t> nearest_base_point(n, 0);
    std::vector<std::vector<double>> from_base_points;
    std::size_t next = internal::position_of_largest(geodesics.component_distances(c, {0}));
    do {
      from_base_points.push_back(geodesics.component_distances(c, {next}));
      const std::vector<double>& distances = from_base_points.back();
      for (std::size_t i = 0; i < n; ++i)
        if (distances[i] < nearest[i]) {
          nearest[i] = distances[i];
          nearest_base_point[i] = from_base_points.size() - 1;
        }
      // a base point is at distance 0 from itself, so that all are different ones
      CGAL_assertion(nearest[next] == 0);
      next = internal::position_of_largest(nearest);
    } while (nearest[next] > radius * std::sqrt(area));

    std::vector<double> base_point_areas(from_base_points.size(), 0.);
    for (std::size_t i = 0; i < n; ++i)
      base_point_areas[nearest_base_point[i]] += areas[i];
    for (std::size_t b = 0; b < from_base_points.size(); ++b)
      for (std::size_t i = 0; i < n; ++i)
        results.back()[i] += base_point_areas[b] * from_base_points[b][i];
  }
  for (std::size_t c = 0; c < results.size(); ++c)
    for (std::size_t i = 0; i < results[c].size(); ++i)
      put(values, geodesics.component_vertices(c)[i], results[c][i]);
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

finds feature points by crossing the extrema of two geodesic distances (\cgalCite{tierny_2006}): the
tips of the limbs of a mesh. The mapping function of that paper follows from the distance to the nearest
one, `Geodesic_distances::write_distances()` from all of them, which is smallest at the tips.

In every connected component,
1. `V1` and `V2` are two vertices far apart, found by going to the farthest vertex several times;
2. candidates are the local extrema of the distance from `V1` that have a local extremum of the distance
   from `V2` within the radius;
3. of candidates within the radius of each other the one with the largest sum of both distances is kept.

\tparam TriangleMesh, Mode as in `Geodesic_distances`
\tparam OutputIterator a model of `OutputIterator` that holds
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param geodesics the distances of the mesh; sets of sources are computed with it
\param out receives the feature points, component by component
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{feature_radius}
    \cgalParamDescription{the radius, as a fraction of the distance of `V1` and `V2`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0.05`, as in the source paper}
  \cgalParamNEnd
\cgalNamedParamsEnd

Components without extent, as isolated vertices, have no feature points; all others have at least the
two far ones. On borders the same rules hold, where corners are extrema.

Takes O(n log n) time for every feature point, for *n* vertices.

\return the output iterator

\pre `feature_radius` is not negative

\throws Numerical_error as `Geodesic_distances::write_distances()`; nothing is written then
*/
template <class TriangleMesh,
          class Mode,
          class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator
crossed_feature_points(Geodesic_distances<TriangleMesh, Mode>& geodesics,
                       OutputIterator out,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  const double relative_radius =
      internal::choose_own_parameter(np, internal::tags::feature_radius, 0.05);
  CGAL_precondition(relative_radius >= 0);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> points;
  for (std::size_t c = 0; c < geodesics.number_of_components(); ++c) {
    const internal::Far_pair pair = internal::far_pair(geodesics, c);
    const double radius = relative_radius * pair.from_first[pair.second];
    if (!(pair.from_first[pair.second] > 0))
      continue;
    const std::vector<double> to_second_extrema =
        geodesics.component_distances(c, internal::local_extrema(geodesics, c, pair.from_second));
    std::vector<std::pair<double, std::size_t>> candidates; // by the sum of distances
    for (const std::size_t i : internal::local_extrema(geodesics, c, pair.from_first))
      if (to_second_extrema[i] <= radius && i != pair.first && i != pair.second)
        candidates.emplace_back(pair.from_first[i] + pair.from_second[i], i);
    std::sort(candidates.begin(), candidates.end(), std::greater<>());

    std::vector<double> to_points(geodesics.component_vertices(c).size());
    const auto add = [&](std::size_t i, const std::vector<double>& distances) {
      points.push_back(geodesics.component_vertices(c)[i]);
      for (std::size_t j = 0; j < to_points.size(); ++j)
        to_points[j] = (std::min)(to_points[j], distances[j]);
    };
    to_points = pair.from_first;
    points.push_back(geodesics.component_vertices(c)[pair.first]);
    add(pair.second, pair.from_second);
    for (const auto& candidate : candidates)
      if (to_points[candidate.second] > radius)
        add(candidate.second, geodesics.component_distances(c, {candidate.second}));
  }
  return std::copy(points.begin(), points.end(), out);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_GEODESIC_FUNCTIONS_H
