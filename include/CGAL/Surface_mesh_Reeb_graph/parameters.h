// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_PARAMETERS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

namespace tags {

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#define CGAL_reuse_named_parameter(X, Y, Z) using CGAL::internal_np::X;
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter

} // namespace tags

// A pack of named parameters that knows the names of this package beside CGAL's. The names of CGAL
// that this package reads hide the inherited ones: they, too, give such a pack again, so that names
// follow each other in any order.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base>
{
  using CGAL_named_parameters = CGAL::Named_function_parameters<T, Tag, Base>;

  explicit Named_parameters(const T& value) : CGAL_named_parameters(value) {}
  Named_parameters(const T& value, const Base& base) : CGAL_named_parameters(value, base) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename K>                                                                            \
  Named_parameters<K, tags::X, CGAL_named_parameters> Z(const K& value) const                      \
  {                                                                                                \
    return Named_parameters<K, tags::X, CGAL_named_parameters>(value, *this);                      \
  }
#define CGAL_reuse_named_parameter CGAL_add_named_parameter
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter
};

// Reads a parameter of this package from any pack; Param_not_found if it is not there.
template <typename NamedParameters, typename Tag>
auto get_own_parameter(const NamedParameters& np, Tag tag)
{
  return CGAL::parameters::get_parameter(np, tag);
}

template <typename NamedParameters, typename Tag, typename Default>
auto choose_own_parameter(const NamedParameters& np, Tag tag, const Default& value)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, tag), value);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphParameters

The named parameters of this package, and those of \cgal that its functions read. They are used like
\cgal's, and follow each other in any order:

\code{.cpp}
namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1)
                                                            .vertex_point_map(points)
                                                            .number_of_eigenpairs(100));
\endcode

A chain that has only names of \cgal may start with `CGAL::parameters::` as everywhere; one that is
for functions of \cgal must.

| name | documented at |
|------|---------------|
| `algorithm`, `collect_arc_vertices`, `face_arc_map`, `unfold_multiple_saddles`, `vertex_arc_map` | `compute_Reeb_graph()` |
| `loop_persistence_threshold`, `number_of_leaves`, `persistence_threshold`, `threshold_is_absolute` | `simplify_Reeb_graph()` |
| `accept_converged_part`, `callback`, `extend_to_gap`, `number_of_eigenpairs`, `random_seed`, `residual_tolerance`, `use_intrinsic_Delaunay` | `Laplace_Beltrami_eigenbasis` |
| `small_time`, `large_time`, `minima_as_feature_points` | `feature_points()` |
| `feature_points`, `use_nearest_feature_point` | `commute_time_function()` |
| `energy_width` | `wave_kernel_signature()` |
| `base_point_radius` | `integral_geodesic_distance_function()` |
| `feature_radius` | `crossed_feature_points()` |
| `curvature_threshold`, `smoothing_length` | `curvature_feature_points()` |
| `cone_angle`, `number_of_rays` | `shape_diameter_function()` |
| `output_iterator`, `sparse_linear_solver`, `vertex_value_map` | `commute_time_Reeb_graph()` |
| `number_of_samples` | `arc_polyline()`, `compute_curve_skeleton()`, `embed_Reeb_graph()` |
| `keep_inside`, `smoothing` | `compute_curve_skeleton()` |
| `vertex_index_map`, `vertex_point_map` | wherever they are read |
*/
namespace parameters {

/// \cond SKIP_IN_MANUAL

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename K>                                                                            \
  internal::Named_parameters<K, internal::tags::X> Z(const K& value)                               \
  {                                                                                                \
    return internal::Named_parameters<K, internal::tags::X>(value);                                \
  }
#define CGAL_reuse_named_parameter CGAL_add_named_parameter
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_reuse_named_parameter
#undef CGAL_add_named_parameter

/// \endcond

} // namespace parameters
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_PARAMETERS_H
