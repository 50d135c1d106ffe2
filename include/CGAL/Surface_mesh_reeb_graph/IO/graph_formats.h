// Copyright (c) 2026 The Surface_mesh_reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPH_FORMATS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPH_FORMATS_H

#include <CGAL/Surface_mesh_reeb_graph/internal/exact_output.h>
#include <CGAL/Surface_mesh_reeb_graph/internal/write_file.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/graph/properties.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace CGAL {
namespace Surface_mesh_reeb_graph {
namespace internal {

// A number with all its digits: boost::dynamic_properties alone writes six. Infinite ones are
// written as XML has them.
template <class Key, class Function>
class Exact_number_property : public boost::dynamic_property_map
{
public:
  explicit Exact_number_property(const Function& function) : m_function(function) {}

  boost::any get(const boost::any& key) override { return m_function(boost::any_cast<Key>(key)); }
  std::string get_string(const boost::any& key) override
  {
    const double number = m_function(boost::any_cast<Key>(key));
    if (std::isinf(number))
      return number < 0 ? "-INF" : "INF";
    std::ostringstream text;
    const Exact_output exact_output(text);
    text << number;
    return text.str();
  }
  void put(const boost::any&, const boost::any&) override
  {
    throw boost::dynamic_const_put_error();
  }
  const std::type_info& key() const override { return typeid(Key); }
  const std::type_info& value() const override { return typeid(double); }

private:
  Function m_function;
};

// The properties of nodes and arcs that both formats write.
template <class Graph, class TriangleMesh, class NamedParameters>
boost::dynamic_properties
graph_properties(const Graph& graph, const TriangleMesh& tmesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto vertex_point_map =
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                       CGAL::get_const_property_map(CGAL::vertex_point, tmesh));

  boost::dynamic_properties properties;
  const auto add_node_property = [&](const std::string& name, auto function) {
    properties.property(name, boost::make_function_property_map<Node>([&graph, function](Node n) {
                          return function(get(boost::vertex_bundle, graph)[n]);
                        }));
  };
  const auto add_number_property = [&](const std::string& name, auto function) {
    const auto number = [&graph, function](Node n) -> double {
      return function(get(boost::vertex_bundle, graph)[n]);
    };
    properties.insert(
        name,
        boost::make_shared<Exact_number_property<Node, std::decay_t<decltype(number)>>>(number));
  };
  const auto add_arc_property = [&](const std::string& name, auto function) {
    properties.property(name, boost::make_function_property_map<Arc>([&graph, function](Arc a) {
                          return function(get(boost::edge_bundle, graph)[a]);
                        }));
  };
  add_node_property("id", [](const auto& node) { return static_cast<unsigned long>(node.id); });
  add_node_property("mesh_vertex", [vertex_index_map](const auto& node) {
    return static_cast<unsigned long>(get(vertex_index_map, node.vertex));
  });
  add_number_property("value", [](const auto& node) { return CGAL::to_double(node.value); });
  add_node_property("type", [](const auto& node) {
    std::ostringstream word;
    word << node.type;
    return word.str();
  });
  add_number_property("x", [vertex_point_map](const auto& node) {
    return CGAL::to_double(get(vertex_point_map, node.vertex).x());
  });
  add_number_property("y", [vertex_point_map](const auto& node) {
    return CGAL::to_double(get(vertex_point_map, node.vertex).y());
  });
  add_number_property("z", [vertex_point_map](const auto& node) {
    return CGAL::to_double(get(vertex_point_map, node.vertex).z());
  });
  add_arc_property("id", [](const auto& arc) { return static_cast<unsigned long>(arc.id); });
  add_arc_property("number_of_vertices",
                   [](const auto& arc) { return static_cast<unsigned long>(arc.vertices.size()); });
  return properties;
}

template <class Graph>
auto node_id_map(const Graph& graph)
{
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  return boost::make_function_property_map<Node>([&graph](Node n) {
    return static_cast<unsigned long>(get(boost::vertex_bundle, graph)[n].id);
  });
}

} // namespace internal

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
bool write_graphml(std::ostream& out,
                   const Graph& graph,
                   const TriangleMesh& tmesh,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
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
\param np named parameters, as for `write_graphml()`

\return `true` if the file could be written
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_graphml(const std::string& filename,
                   const Graph& graph,
                   const TriangleMesh& tmesh,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(filename,
                              [&](std::ostream& out) { IO::write_graphml(out, graph, tmesh, np); });
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph in the DOT language of Graphviz, with the writer of Boost.Graph and the
properties that `write_graphml()` writes; the `id` names a node, its `label` is type and `id`.

\param out the stream
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `write_graphml()`

\return `true` if the stream is good afterwards
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_graphviz(std::ostream& out,
                    const Graph& graph,
                    const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  boost::dynamic_properties properties = internal::graph_properties(graph, tmesh, np);
  // Graphviz shows the type where it would show the number
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  properties.property("label", boost::make_function_property_map<Node>([&graph](Node n) {
                        std::ostringstream text;
                        const auto& node = get(boost::vertex_bundle, graph)[n];
                        text << node.type << ' ' << node.id;
                        return text.str();
                      }));
  boost::write_graphviz_dp(out, graph, properties, "id");
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a Reeb graph in the DOT language to a file, which is replaced if it exists.

\param filename the name of the file
\param graph the Reeb graph
\param tmesh the mesh
\param np named parameters, as for `write_graphml()`

\return `true` if the file could be written
*/
template <class Graph,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_graphviz(const std::string& filename,
                    const Graph& graph,
                    const TriangleMesh& tmesh,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(
      filename, [&](std::ostream& out) { IO::write_graphviz(out, graph, tmesh, np); });
}

} // namespace IO
} // namespace Surface_mesh_reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_GRAPH_FORMATS_H
