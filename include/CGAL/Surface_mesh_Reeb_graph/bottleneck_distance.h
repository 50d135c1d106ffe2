// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_BOTTLENECK_DISTANCE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_BOTTLENECK_DISTANCE_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_signature.h>

#include <hera/bottleneck/bottleneck.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns the bottleneck distance of the persistence diagrams of two Reeb graphs: the largest one of
those of the four kinds of pairs. It needs <a href="https://github.com/anigmetov/hera">Hera</a>
(Debian: `libhera-dev`); no other header of the package does.

For two functions on the same surface it is at most the largest difference of the functions
(\cgalCite{cohen_steiner_2009}); it is a lower bound of the distances of Reeb graphs that see the
structure, as the functional distortion distance is bounded below by a third of it
(\cgalCite{bauer_2014}).

As usual, points may be matched to the diagonal, those of components too.

\param a, b signatures from `compute_Reeb_graph_signature()`

Takes O(m<sup>1.5</sup> log m) time for diagrams of *m* points.
*/
inline double bottleneck_distance(const Reeb_graph_signature& a, const Reeb_graph_signature& b)
{
  using Points = std::vector<std::pair<double, double>>;
  const auto points = [](const Reeb_graph_signature& signature, Persistence_pair_kind kind) {
    Points result;
    for (const Persistence_diagram_point& point : signature.diagram)
      if (point.kind == kind && (point.upper > point.lower))
        result.emplace_back(point.lower, point.upper);
    return result;
  };
  double distance = 0;
  for (const Persistence_pair_kind kind : {Persistence_pair_kind::MINIMUM,
                                           Persistence_pair_kind::MAXIMUM,
                                           Persistence_pair_kind::COMPONENT,
                                           Persistence_pair_kind::LOOP})
  {
    Points p = points(a, kind), q = points(b, kind); // Hera takes no constants
    distance = (std::max)(distance, hera::bottleneckDistExact(p, q));
  }
  return distance;
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_BOTTLENECK_DISTANCE_H
