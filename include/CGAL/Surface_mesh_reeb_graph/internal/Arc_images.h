// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_IMAGES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_IMAGES_H

#include <CGAL/Surface_mesh_reeb_graph/internal/Arc_list.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/Folded_graph.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// Where the vertices of the arcs of a graph go when it is folded, as Folded_graph::arc_after()
// says. An arc may have been cut and joined again very often. But what is left of it is a path
// upwards: two vertices of an arc between the ends of one arc that is left go the same way, so that
// only the first one must follow what has happened.
class Arc_images
{
public:
  // The graph must not change any more.
  explicit Arc_images(Folded_graph& folded) : m_folded(folded), m_images(folded.arcs().size()) {}

  template <class IsBelow>
  std::uint32_t arc_after(std::uint32_t arc, const IsBelow& is_below)
  {
    if (m_folded.is_arc(arc))
      return arc;
    const std::vector<Arc_ends>& arcs = m_folded.arcs();
    std::vector<std::uint32_t>& images = m_images[arc];
    const auto next = std::partition_point(images.begin(), images.end(), [&](std::uint32_t image) {
      return !is_below(arcs[image].lower);
    });
    if (next != images.begin() && is_below(arcs[*(next - 1)].upper))
      return *(next - 1);
    const std::uint32_t image = m_folded.arc_after(arc, is_below);
    if (!is_below(arcs[image].lower) && is_below(arcs[image].upper))
      images.insert(next, image);
    return image;
  }

private:
  Folded_graph& m_folded;
  std::vector<std::vector<std::uint32_t>> m_images; // by arc, from the lowest to the highest
};

} // namespace internal
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_ARC_IMAGES_H
