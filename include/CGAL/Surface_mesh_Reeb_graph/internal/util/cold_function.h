// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COLD_FUNCTION_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COLD_FUNCTION_H

// Marks a function that is called rarely. The compiler spends little time on it, and does not let
// it grow into the functions that call it.
#if defined(__GNUC__)
#define CGAL_REEB_GRAPH_COLD __attribute__((cold, noinline))
#else
#define CGAL_REEB_GRAPH_COLD
#endif

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_COLD_FUNCTION_H
