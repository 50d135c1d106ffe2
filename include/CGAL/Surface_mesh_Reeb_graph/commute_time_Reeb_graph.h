// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_REEB_GRAPH_H

#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the Reeb graph of the commute-time mapping function: the method of
\cgalCite{el_khoury_2012} in one call.

It computes the eigenbasis, the feature points, the mapping function, its Reeb graph, and simplifies
it. For a shape with limbs the graph has a minimum in the center and a maximum at the tip of every
limb, in any pose.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam MutableGraph as in `compute_Reeb_graph()`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param graph the Reeb graph; what it contained before is lost
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{persistence_threshold}
    \cgalParamDescription{as in `simplify_Reeb_graph()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`: only pairs of persistence zero are cancelled}
  \cgalParamNEnd
  \cgalParamNBegin{persistence_gap}
    \cgalParamDescription{as in `simplify_Reeb_graph()`}
    \cgalParamType{an integer type, not negative}
    \cgalParamDefault{`0`: `persistence_threshold` counts}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_leaves}
    \cgalParamDescription{as in `simplify_Reeb_graph()`}
    \cgalParamType{an integer type, not negative}
    \cgalParamDefault{no limit}
  \cgalParamNEnd
  \cgalParamNBegin{loop_persistence_threshold}
    \cgalParamDescription{as in `simplify_Reeb_graph()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`0`: loops are never closed}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_is_absolute}
    \cgalParamDescription{as in `simplify_Reeb_graph()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_value_map}
    \cgalParamDescription{receives the mapping function}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type}
    \cgalParamDefault{no map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{as in `compute_Reeb_graph()`; the arcs are those of the simplified graph}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
  \cgalParamNEnd
  \cgalParamNBegin{face_arc_map}
    \cgalParamDescription{as in `compute_Reeb_graph()`; the arcs are those of the simplified graph}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value type}
    \cgalParamDefault{no map}
  \cgalParamNEnd
  \cgalParamNBegin{collect_arc_vertices}
    \cgalParamDescription{as in `compute_Reeb_graph()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{unfold_multiple_saddles}
    \cgalParamDescription{as in `compute_Reeb_graph()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{algorithm}
    \cgalParamDescription{as in `compute_Reeb_graph()`}
    \cgalParamType{`Reeb_graph_algorithm`}
    \cgalParamDefault{`Reeb_graph_algorithm::AUTOMATIC`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_eigenpairs}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{an integer, at least 1}
    \cgalParamDefault{`50`}
  \cgalParamNEnd
  \cgalParamNBegin{residual_tolerance}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e-8`}
  \cgalParamNEnd
  \cgalParamNBegin{use_intrinsic_Delaunay}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{extend_to_gap}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{accept_converged_part}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{an unsigned integer}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{as in `Laplace_Beltrami_eigenbasis`}
    \cgalParamType{a type convertible to `std::function<bool(double)>`}
    \cgalParamDefault{no function}
  \cgalParamNEnd
  \cgalParamNBegin{small_time}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`1.5`}
  \cgalParamNEnd
  \cgalParamNBegin{large_time}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`20`}
  \cgalParamNEnd
  \cgalParamNBegin{minima_as_feature_points}
    \cgalParamDescription{as in `feature_points()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{feature_points}
    \cgalParamDescription{as in `commute_time_function()`}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`; it is copied}
    \cgalParamDefault{those of `feature_points()`}
  \cgalParamNEnd
  \cgalParamNBegin{use_nearest_feature_point}
    \cgalParamDescription{as in `commute_time_function()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{receives the feature points}
    \cgalParamType{a model of `OutputIterator` that holds `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{`CGAL::Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{an object of the type that factors and solves the linear systems; only its type counts}
    \cgalParamType{a class model of `SparseLinearAlgebraWithFactorTraits_d`}
    \cgalParamDefault{the default of `Laplace_Beltrami_eigenbasis`}
  \cgalParamNEnd
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

\throws Error as the functions that it calls; all outputs are then left as they were
\throws Interruption if the callback returns `false`; all outputs are then left as they were

\sa `compute_Reeb_graph()`
*/
template <class TriangleMesh,
          class MutableGraph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void commute_time_Reeb_graph(const TriangleMesh& tmesh,
                             MutableGraph& graph,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;

  internal::simplification_parameters(np); // throws before any output is written

  // the basis is by far the largest object: it is gone before the graph is computed
  const auto values = get(CGAL::dynamic_vertex_property_t<double>(), tmesh);
  const std::vector<vertex_descriptor> points =
      internal::write_commute_time_function(tmesh, values, np);
  compute_Reeb_graph(tmesh, values, graph, np);
  simplify_Reeb_graph(tmesh, values, graph, np);

  if constexpr (!is_default_parameter<NamedParameters, internal::tags::vertex_value_map_t>::value) {
    auto vertex_value_map = internal::get_own_parameter(np, internal::tags::vertex_value_map);
    for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
      put(vertex_value_map, v, get(values, v));
  }
  if constexpr (!is_default_parameter<NamedParameters, CGAL::internal_np::output_iterator_t>::value)
    std::copy(points.begin(), points.end(), get_parameter(np, CGAL::internal_np::output_iterator));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_COMMUTE_TIME_REEB_GRAPH_H
