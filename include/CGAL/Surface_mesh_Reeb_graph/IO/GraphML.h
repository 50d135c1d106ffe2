// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHML_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHML_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/dynamic_properties.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graphml.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph as GraphML, with the writer of Boost.Graph. Nodes have the properties `id`,
`mesh_vertex` (the index of the critical vertex), `value`, `type` (in words), `x`, `y` and `z`; arcs
have `id` and `number_of_vertices` (0 unless the vertices of the arcs have been collected).

\param out the stream
\param graph the Reeb graph
\param tmesh the mesh
\param np an optional sequence of named parameters: `vertex_index_map` and `vertex_point_map`, by
       default those of the mesh

\return `true` if the stream is good afterwards
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_GraphML(std::ostream& out,
                   const Graph& graph,
                   const TriangleMesh& tmesh,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Exact_output exact_output(out);
  boost::write_graphml(
      out, graph, internal::node_id_map(graph), internal::graph_properties(graph, tmesh, np), true);
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph as GraphML to a file, which is replaced if it exists.

\param filename the name of the file
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `write_GraphML()`

\return `true` if the file could be written
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_GraphML(const std::string& filename,
                   const Graph& graph,
                   const TriangleMesh& tmesh,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(filename,
                              [&](std::ostream& out) { IO::write_GraphML(out, graph, tmesh, np); });
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHML_H
