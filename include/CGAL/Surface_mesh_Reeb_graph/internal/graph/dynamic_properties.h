// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_DYNAMIC_PROPERTIES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_DYNAMIC_PROPERTIES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Infinite numbers are written as XML has them.
template <class T>
std::string property_text(const T& value)
{
  if constexpr (std::is_floating_point<T>::value) {
    if (std::isinf(value))
      return value < 0 ? "-INF" : "INF";
  }
  return exact_text(value);
}

// A property of the nodes or arcs. Those that boost::dynamic_properties makes by itself write six
// digits of a number, and group them if the global locale says so.
template <class Key, class Function>
class Exact_property : public boost::dynamic_property_map
{
  using Value = std::decay_t<std::invoke_result_t<const Function&, Key>>;

public:
  explicit Exact_property(const Function& function) : m_function(function) {}

  boost::any get(const boost::any& key) override { return m_function(boost::any_cast<Key>(key)); }
  std::string get_string(const boost::any& key) override
  {
    return property_text(m_function(boost::any_cast<Key>(key)));
  }
  void put(const boost::any&, const boost::any&) override
  {
    throw boost::dynamic_const_put_error();
  }
  const std::type_info& key() const override { return typeid(Key); }
  const std::type_info& value() const override { return typeid(Value); }

private:
  Function m_function;
};

template <class Key, class Function>
void add_property(boost::dynamic_properties& properties,
                  const std::string& name,
                  const Function& function)
{
  properties.insert(name, boost::make_shared<Exact_property<Key, Function>>(function));
}

// The properties of nodes and arcs that both formats write.
template <class Graph, class TriangleMesh, class NamedParameters>
boost::dynamic_properties
graph_properties(const Graph& graph, const TriangleMesh& tmesh, const NamedParameters& np)
{
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);

  const auto node_of = [&graph](Node n) -> decltype(auto) {
    return get(boost::vertex_bundle, graph)[n];
  };
  const auto coordinate = [node_of, vertex_point_map](Node n, int i) {
    return CGAL::to_double(get(vertex_point_map, node_of(n).vertex)[i]);
  };
  boost::dynamic_properties properties;
  add_property<Node>(
      properties, "id", [=](Node n) { return static_cast<unsigned long>(node_of(n).id); });
  add_property<Node>(properties, "mesh_vertex", [=](Node n) {
    return static_cast<unsigned long>(get(vertex_index_map, node_of(n).vertex));
  });
  add_property<Node>(
      properties, "value", [=](Node n) { return CGAL::to_double(node_of(n).value); });
  add_property<Node>(properties, "type", [=](Node n) { return exact_text(node_of(n).type); });
  add_property<Node>(properties, "x", [=](Node n) { return coordinate(n, 0); });
  add_property<Node>(properties, "y", [=](Node n) { return coordinate(n, 1); });
  add_property<Node>(properties, "z", [=](Node n) { return coordinate(n, 2); });
  add_property<Arc>(properties, "id", [&graph](Arc a) {
    return static_cast<unsigned long>(get(boost::edge_bundle, graph)[a].id);
  });
  add_property<Arc>(properties, "number_of_vertices", [&graph](Arc a) {
    return static_cast<unsigned long>(get(boost::edge_bundle, graph)[a].vertices.size());
  });
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

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_DYNAMIC_PROPERTIES_H
