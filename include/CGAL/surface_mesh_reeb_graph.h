// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_H

/// \file surface_mesh_reeb_graph.h
/// Includes all headers of the package.

#include <CGAL/Surface_mesh_reeb_graph/Block_lanczos_eigensolver.h>
#include <CGAL/Surface_mesh_reeb_graph/Eigenpairs.h>
#include <CGAL/Surface_mesh_reeb_graph/Eigensolver_options.h>
#include <CGAL/Surface_mesh_reeb_graph/IO/VTP.h>
#include <CGAL/Surface_mesh_reeb_graph/IO/graph_formats.h>
#include <CGAL/Surface_mesh_reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_reeb_graph/Laplace_beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_algorithm.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_error.h>
#include <CGAL/Surface_mesh_reeb_graph/Reeb_graph_interrupted.h>
#include <CGAL/Surface_mesh_reeb_graph/Supernodal_cholesky.h>
#include <CGAL/Surface_mesh_reeb_graph/commute_time_reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/compute_reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/embed_reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_reeb_graph/level_set_components.h>
#include <CGAL/Surface_mesh_reeb_graph/mapping_functions.h>
#include <CGAL/Surface_mesh_reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_reeb_graph/persistence.h>
#include <CGAL/Surface_mesh_reeb_graph/simplify_reeb_graph.h>
#include <CGAL/Surface_mesh_reeb_graph/spectral_distances.h>
#include <CGAL/Surface_mesh_reeb_graph/vertex_order.h>

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_H
