// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_H

/// \file Surface_mesh_Reeb_graph/spectral.h
/// Includes the headers for functions that come from the surface itself: the eigenbasis and its
/// solvers, distances, feature points, mapping functions, and the whole method in one call. Every one
/// of these headers also suffices alone for what it documents. Spectra_eigensolver.h is not among
/// them, since it needs another library.

#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/harmonic_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_SPECTRAL_H
