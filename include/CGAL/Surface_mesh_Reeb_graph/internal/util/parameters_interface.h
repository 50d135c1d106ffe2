// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

// List of the named parameters of this package, in the form of CGAL's own list:
// (type of the tag, value of the tag, name of the parameter).
// There is no include guard: parameters.h includes this file several times.
CGAL_add_named_parameter(number_of_eigenpairs_t, number_of_eigenpairs, number_of_eigenpairs)
CGAL_add_named_parameter(residual_tolerance_t, residual_tolerance, residual_tolerance)
CGAL_add_named_parameter(use_intrinsic_Delaunay_t, use_intrinsic_Delaunay, use_intrinsic_Delaunay)
CGAL_add_named_parameter(extend_to_gap_t, extend_to_gap, extend_to_gap)
CGAL_add_named_parameter(accept_converged_part_t, accept_converged_part, accept_converged_part)
CGAL_add_named_parameter(small_time_t, small_time, small_time)
CGAL_add_named_parameter(large_time_t, large_time, large_time)
CGAL_add_named_parameter(minima_as_feature_points_t,
                         minima_as_feature_points,
                         minima_as_feature_points)
CGAL_add_named_parameter(feature_points_t, feature_points, feature_points)
CGAL_add_named_parameter(use_nearest_feature_point_t,
                         use_nearest_feature_point,
                         use_nearest_feature_point)
CGAL_add_named_parameter(energy_width_t, energy_width, energy_width)
CGAL_add_named_parameter(base_point_radius_t, base_point_radius, base_point_radius)
CGAL_add_named_parameter(feature_radius_t, feature_radius, feature_radius)
CGAL_add_named_parameter(curvature_threshold_t, curvature_threshold, curvature_threshold)
CGAL_add_named_parameter(smoothing_length_t, smoothing_length, smoothing_length)
CGAL_add_named_parameter(cone_angle_t, cone_angle, cone_angle)
CGAL_add_named_parameter(number_of_rays_t, number_of_rays, number_of_rays)
CGAL_add_named_parameter(smoothing_t, smoothing, smoothing)
CGAL_add_named_parameter(keep_inside_t, keep_inside, keep_inside)
CGAL_add_named_parameter(persistence_threshold_t, persistence_threshold, persistence_threshold)
CGAL_add_named_parameter(persistence_gap_t, persistence_gap, persistence_gap)
CGAL_add_named_parameter(threshold_is_absolute_t, threshold_is_absolute, threshold_is_absolute)
CGAL_add_named_parameter(loop_persistence_threshold_t,
                         loop_persistence_threshold,
                         loop_persistence_threshold)
CGAL_add_named_parameter(number_of_leaves_t, number_of_leaves, number_of_leaves)
CGAL_add_named_parameter(vertex_value_map_t, vertex_value_map, vertex_value_map)
CGAL_add_named_parameter(vertex_arc_map_t, vertex_arc_map, vertex_arc_map)
CGAL_add_named_parameter(face_arc_map_t, face_arc_map, face_arc_map)
CGAL_add_named_parameter(collect_arc_vertices_t, collect_arc_vertices, collect_arc_vertices)
CGAL_add_named_parameter(unfold_multiple_saddles_t,
                         unfold_multiple_saddles,
                         unfold_multiple_saddles)

// The parameters of CGAL that functions of this package read, with CGAL's tags.
CGAL_reuse_named_parameter(vertex_point_t, vertex_point, vertex_point_map)
    CGAL_reuse_named_parameter(vertex_index_t, vertex_index, vertex_index_map)
        CGAL_reuse_named_parameter(algorithm_t, algorithm, algorithm)
            CGAL_reuse_named_parameter(callback_t, callback, callback)
                CGAL_reuse_named_parameter(number_of_samples_t,
                                           number_of_samples,
                                           number_of_samples)
                    CGAL_reuse_named_parameter(output_iterator_t, output_iterator, output_iterator)
                        CGAL_reuse_named_parameter(random_seed_t, random_seed, random_seed)
                            CGAL_reuse_named_parameter(sparse_linear_solver_t,
                                                       sparse_linear_solver,
                                                       sparse_linear_solver)
