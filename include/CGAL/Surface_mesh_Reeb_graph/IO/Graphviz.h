// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHVIZ_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHVIZ_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/dynamic_properties.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph in the DOT language of Graphviz, with the writer of Boost.Graph and the
properties that `write_GraphML()` writes; the `id` names a node, its `label` is type and `id`.

\param out the stream
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `write_GraphML()`

\return `true` if the stream is good afterwards
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_Graphviz(std::ostream& out,
                    const Graph& graph,
                    const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  boost::dynamic_properties properties = internal::graph_properties(graph, tmesh, np);
  // Graphviz shows the type where it would show the number
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  internal::add_property<Node>(properties, "label", [&graph](Node n) {
    const auto& node = get(boost::vertex_bundle, graph)[n];
    return internal::exact_text(node.type, ' ', node.id);
  });
  const internal::Exact_output exact_output(out);
  boost::write_graphviz_dp(out, graph, properties, "id");
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph in the DOT language to a file, which is replaced if it exists.

\param filename the name of the file
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `write_GraphML()`

\return `true` if the file could be written
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_Graphviz(const std::string& filename,
                    const Graph& graph,
                    const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(
      filename, [&](std::ostream& out) { IO::write_Graphviz(out, graph, tmesh, np); });
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPHVIZ_H
