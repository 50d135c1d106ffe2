// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_TRIANGLE_TREE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_TRIANGLE_TREE_H

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// CGAL's tree over triangles, by the names that it has in this version of CGAL. The kernel decides
// exactly on which side of the surface, given by coordinates in double precision, a point lies.
struct Triangle_tree_types
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_NR >= 1060000000
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
};

using Triangle_tree = CGAL::AABB_tree<Triangle_tree_types::Traits>;

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_TRIANGLE_TREE_H
