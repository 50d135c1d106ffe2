// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_REEB_GRAPH_REQUEST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_REEB_GRAPH_REQUEST_H

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// What a user wants of a Reeb graph, and how it may be computed.
struct Reeb_graph_request
{
  bool unfolds = false;        // multiple saddles into simple ones
  bool has_vertex_arcs = true; // fills Arc_list::arc_of_vertex
  bool has_wedge_arcs = false; // fills Arc_list::upper_wedges
  // The algorithms that may be used, one at least. If both may, the sweep steps in where cutting
  // takes too long.
  bool may_cut = true;
  bool may_sweep = true;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_REEB_GRAPH_REQUEST_H
