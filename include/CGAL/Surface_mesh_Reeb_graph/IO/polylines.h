// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_POLYLINES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_POLYLINES_H

#include <CGAL/Surface_mesh_Reeb_graph/arc_polyline.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/properties.hpp>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the arcs of a Reeb graph as polylines, in \cgal's format: a line for every arc, in the order
of `edges(graph)`, with the number of points and their coordinates. Coordinates are converted to
`double` and written such that these can be read back exactly.

\param out the stream
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `arc_polyline()`

\return `true` if the stream is good afterwards
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_polylines(std::ostream& out,
                     const Graph& graph,
                     const TriangleMesh& tmesh,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Exact_output exact_output(out);
  for (auto arc : CGAL::make_range(edges(graph))) {
    const auto polyline = arc_polyline(arc, graph, tmesh, np);
    out << polyline.size();
    for (const auto& p : polyline)
      out << ' ' << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' '
          << CGAL::to_double(p.z());
    out << '\n';
  }
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the arcs of a Reeb graph as polylines to a file, which is replaced if it exists.

\param filename the name of the file
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `arc_polyline()`

\return `true` if the file could be written
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_polylines(const std::string& filename,
                     const Graph& graph,
                     const TriangleMesh& tmesh,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(
      filename, [&](std::ostream& out) { IO::write_polylines(out, graph, tmesh, np); });
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the arcs of a curve skeleton as polylines, in the same format: a line for every arc, in the
order of their numbers.

\param out the stream
\param skeleton a skeleton that `compute_curve_skeleton()` or `embed_Reeb_graph()` has made

\return `true` if the stream is good afterwards
*/
template <class Skeleton>
bool write_polylines(std::ostream& out, const Skeleton& skeleton)
{
  const internal::Exact_output exact_output(out);
  const auto points = get(boost::vertex_bundle, skeleton);
  const auto arcs = get(boost::edge_bundle, skeleton);
  const auto range = edges(skeleton);
  for (auto first = range.first; first != range.second;) {
    // the segments of an arc follow each other
    auto last = first;
    std::size_t number_of_points = 1;
    for (; last != range.second && arcs[*last].arc == arcs[*first].arc; ++last)
      ++number_of_points;
    out << number_of_points;
    const auto write_point = [&](auto v) {
      const auto& p = points[v].point;
      out << ' ' << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' '
          << CGAL::to_double(p.z());
    };
    write_point(source(*first, skeleton));
    for (; first != last; ++first)
      write_point(target(*first, skeleton));
    out << '\n';
  }
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the arcs of a curve skeleton as polylines to a file, which is replaced if it exists.

\return `true` if the file could be written
*/
template <class Skeleton>
bool write_polylines(const std::string& filename, const Skeleton& skeleton)
{
  return internal::write_file(filename,
                              [&](std::ostream& out) { IO::write_polylines(out, skeleton); });
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_POLYLINES_H
