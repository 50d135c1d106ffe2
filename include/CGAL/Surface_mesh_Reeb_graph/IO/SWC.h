// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_SWC_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_SWC_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

tells whether a curve skeleton has no loop, so that `write_SWC()` can write it.

Takes O(m) time for *m* vertices and edges.
*/
template <class Skeleton>
bool is_forest(const Skeleton& skeleton)
{
  std::vector<std::size_t> component(num_vertices(skeleton));
  const auto number_of_trees =
      static_cast<std::size_t>(boost::connected_components(skeleton, component.data()));
  return num_edges(skeleton) + number_of_trees == num_vertices(skeleton);
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a curve skeleton as trees with radii in the SWC format, which programs for neurons and other
branching shapes read (navis, skeletor, neuTube).

Every line is a point: its number from 1, its type (always 0, undefined), its coordinates, its
radius, and the number of the point before it, -1 for a root. The root of a tree is its first
vertex: of a skeleton of this package, the lowest node. Numbers are converted to `double` and
written such that these can be read back exactly.

\tparam Skeleton a model of `VertexListGraph`, `EdgeListGraph` and `IncidenceGraph` with vertices
        numbered from 0 whose bundles have the members `point` and `radius`, as `Curve_skeleton`

\param out the stream
\param skeleton the skeleton

\return `true` if the stream is good afterwards

\throws Input_error if the skeleton has a loop, which the format cannot hold; nothing has been
        written then
*/
template <class Skeleton>
bool write_SWC(std::ostream& out, const Skeleton& skeleton)
{
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  if (!is_forest(skeleton))
    throw Input_error("the skeleton has a loop: an SWC file can hold trees only");

  const internal::Exact_output exact_output(out);
  const auto bundles = get(boost::vertex_bundle, skeleton);
  std::vector<bool> is_reached(num_vertices(skeleton), false);
  std::size_t number = 0;
  for (const Vertex root : CGAL::make_range(vertices(skeleton))) {
    if (is_reached[root])
      continue;
    std::vector<std::pair<Vertex, long long>> stack = {{root, -1}}; // and the number before
    is_reached[root] = true;
    while (!stack.empty()) {
      const auto [v, parent] = stack.back();
      stack.pop_back();
      const auto& bundle = bundles[v];
      out << ++number << " 0 " << CGAL::to_double(bundle.point.x()) << ' '
          << CGAL::to_double(bundle.point.y()) << ' ' << CGAL::to_double(bundle.point.z()) << ' '
          << bundle.radius << ' ' << parent << '\n';
      for (const auto edge : CGAL::make_range(out_edges(v, skeleton))) {
        const Vertex w = target(edge, skeleton);
        if (!is_reached[w]) {
          is_reached[w] = true;
          stack.push_back({w, static_cast<long long>(number)});
        }
      }
    }
  }
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a curve skeleton in the SWC format to a file, which is replaced if it exists.

\return `true` if the file could be written

\throws Input_error if the skeleton has a loop; the file is left as it was then
*/
template <class Skeleton>
bool write_SWC(const std::string& filename, const Skeleton& skeleton)
{
  return internal::write_file(filename, [&](std::ostream& out) { IO::write_SWC(out, skeleton); });
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_SWC_H
