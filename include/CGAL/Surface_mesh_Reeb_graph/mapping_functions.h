// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H

/// \file mapping_functions.h
/// Includes the headers for all scalar functions on a mesh that this package computes. Every one of
/// these headers also suffices alone; those on geodesic distances and on the shape diameter include other
/// packages of \cgal and take long to compile.

#include <CGAL/Surface_mesh_Reeb_graph/Geodesic_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/curvature_feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/geodesic_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/harmonic_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/shape_diameter_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_MAPPING_FUNCTIONS_H
