// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_COMPONENTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_COMPONENTS_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// The connected components of a mesh, isolated vertices included, in the order of their first
// vertices.
template <class TriangleMesh>
class Mesh_components
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  struct Component
  {
    std::vector<vertex_descriptor> vertices; // in the order of the mesh
    std::vector<face_descriptor> faces;
  };

  explicit Mesh_components(const TriangleMesh& tmesh)
    : m_component_of_vertex(get(Number_property(), tmesh))
    , m_position_of_vertex(get(Number_property(), tmesh))
  {
    // Edges, not circulation: vertices whose faces form several fans join these too.
    std::uint32_t n = 0;
    for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
      put(m_position_of_vertex, v, n++);
    Disjoint_sets sets(n);
    for (auto e : CGAL::make_range(edges(tmesh)))
      sets.join(sets.root(position_of(source(e, tmesh))), sets.root(position_of(target(e, tmesh))));

    constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
    std::vector<std::uint32_t> component_of_set(n, none);
    for (vertex_descriptor v : CGAL::make_range(vertices(tmesh))) {
      std::uint32_t& number = component_of_set[sets.root(position_of(v))];
      if (number == none) {
        number = static_cast<std::uint32_t>(m_components.size());
        m_components.emplace_back();
      }
      Component& component = m_components[number];
      put(m_component_of_vertex, v, number);
      put(m_position_of_vertex, v, static_cast<std::uint32_t>(component.vertices.size()));
      component.vertices.push_back(v);
    }
    for (face_descriptor f : CGAL::make_range(faces(tmesh)))
      m_components[component_of(target(halfedge(f, tmesh), tmesh))].faces.push_back(f);
  }

  std::size_t size() const { return m_components.size(); }
  const Component& operator[](std::size_t i) const { return m_components[i]; }

  std::uint32_t component_of(vertex_descriptor v) const { return get(m_component_of_vertex, v); }

  // The position of a vertex among the vertices of its component.
  std::uint32_t position_of(vertex_descriptor v) const { return get(m_position_of_vertex, v); }

private:
  using Number_property = CGAL::dynamic_vertex_property_t<std::uint32_t>;
  using Number_map = typename boost::property_map<TriangleMesh, Number_property>::const_type;

  Number_map m_component_of_vertex;
  Number_map m_position_of_vertex;
  std::vector<Component> m_components;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_MESH_MESH_COMPONENTS_H
