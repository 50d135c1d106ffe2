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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace tags

// A pack of named parameters that knows the names of this package beside CGAL's. A name of this
// package gives such a pack again, a name of CGAL (inherited) gives CGAL's own pack.
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
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
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

The named parameters of this package. They are used like those of \cgal. In one chain the names of
this package come first, in any order, and those of \cgal follow:

\code{.cpp}
namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1)
                                                            .number_of_eigenpairs(100)
                                                            .vertex_point_map(points));
\endcode

A chain that has only names of \cgal starts with `CGAL::parameters::` as everywhere.

| name | documented at |
|------|---------------|
| `collect_arc_vertices`, `face_arc_map`, `unfold_multiple_saddles`, `vertex_arc_map` | `compute_Reeb_graph()` |
| `loop_persistence_threshold`, `number_of_leaves`, `persistence_threshold`, `threshold_is_absolute` | `simplify_Reeb_graph()` |
| `accept_converged_part`, `extend_to_gap`, `number_of_eigenpairs`, `residual_tolerance`, `use_intrinsic_Delaunay` | `Laplace_Beltrami_eigenbasis` |
| `small_time`, `large_time`, `minima_as_feature_points` | `feature_points()` |
| `vertex_value_map` | `commute_time_Reeb_graph()` |
*/
namespace parameters {

/// \cond SKIP_IN_MANUAL

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename K>                                                                            \
  internal::Named_parameters<K, internal::tags::X> Z(const K& value)                               \
  {                                                                                                \
    return internal::Named_parameters<K, internal::tags::X>(value);                                \
  }
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/parameters_interface.h>
#undef CGAL_add_named_parameter

/// \endcond

} // namespace parameters
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_PARAMETERS_H
