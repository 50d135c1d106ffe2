// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_H

/// \file surface_mesh_Reeb_graph.h
/// Includes the headers for Reeb graphs of functions that are at hand: to compute and simplify them,
/// their persistence, level sets, and files. Every one of these headers also suffices alone for what
/// it documents. The spectral half of the package, which takes much longer to compile, is in
/// Surface_mesh_Reeb_graph/spectral.h; curve skeletons, which take \cgal's AABB tree, are in
/// Surface_mesh_Reeb_graph/compute_curve_skeleton.h.

#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/Graphviz.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/VTP.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/persistence_diagram.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/polylines.h>
#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/arc_polyline.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_gap.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_H
