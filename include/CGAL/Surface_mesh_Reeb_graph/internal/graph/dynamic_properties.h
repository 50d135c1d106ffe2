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
#include <sstream>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
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
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);

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

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_GRAPH_DYNAMIC_PROPERTIES_H
