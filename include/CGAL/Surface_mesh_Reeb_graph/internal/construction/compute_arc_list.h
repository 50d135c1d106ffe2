// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_COMPUTE_ARC_LIST_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_COMPUTE_ARC_LIST_H

#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Cutting_algorithm.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/construction/Sweep_algorithm.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Reeb_graph_request.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Vertex_classification.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/upper_wedge.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/throw_internal_error.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// So many steps of walks per vertex take less time than the sweep.
constexpr std::size_t WALK_STEPS_PER_VERTEX = 4;
constexpr std::size_t UNLIMITED_WALK_STEPS = (std::numeric_limits<std::size_t>::max)();

// Classifies the vertices for an order, which is made as cheap as they allow.
template <class ConcurrencyTag, class TriangleMesh, class VertexScalarMap, class VertexIndexMap>
Vertex_order<TriangleMesh, VertexScalarMap, VertexIndexMap>
classify_vertices(const TriangleMesh& tmesh,
                  VertexScalarMap scalar_map,
                  VertexIndexMap vertex_index_map,
                  Vertex_classification& states,
                  std::vector<Monotone_neighbors<TriangleMesh>>* neighbors)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Order = Vertex_order<TriangleMesh, VertexScalarMap, VertexIndexMap>;

  const bool has_no_plateaus = states.classify<ConcurrencyTag>(
      tmesh, vertex_index_map, [&](vertex_descriptor v) { return get(scalar_map, v); }, neighbors);
  if (has_no_plateaus && !states.has_faceless_edges())
    return Order(scalar_map, vertex_index_map, No_plateaus());
  Order order(tmesh, scalar_map, vertex_index_map);
  if (!states.classify<ConcurrencyTag>(
          tmesh, vertex_index_map, [&](vertex_descriptor v) { return order.key(v); }, neighbors))
  {
    check_mesh(tmesh, vertex_index_map);
    throw Input_error("the mesh has a face with the same vertex twice");
  }
  return order;
}

// Computes the Reeb graph as lists, by cutting if the walks do not take too long, or else by a
// sweep.
template <class ConcurrencyTag, class TriangleMesh, class VertexOrder, class VertexIndexMap>
Arc_list<TriangleMesh>
compute_arc_list(const TriangleMesh& tmesh,
                 const VertexOrder& order,
                 VertexIndexMap vertex_index_map,
                 const Vertex_classification& states,
                 const std::vector<Monotone_neighbors<TriangleMesh>>& neighbors,
                 const Reeb_graph_request& request)
{
  CGAL_precondition(request.may_cut || request.may_sweep);
  const std::size_t index_bound = states.index_bound();
  if (request.may_cut) {
    const std::size_t budget =
        request.may_sweep ? WALK_STEPS_PER_VERTEX * index_bound : UNLIMITED_WALK_STEPS;
    Arc_list<TriangleMesh> result;
    Cutting_algorithm<ConcurrencyTag, TriangleMesh, VertexOrder, VertexIndexMap> cutting(
        tmesh, order, vertex_index_map, index_bound, states, neighbors, request);
    if (cutting.run(budget, result))
      return result;
    if (!request.may_sweep)
      throw_internal_error("an unlimited number of steps does not suffice");
  }
  const auto halfedge_index_map = CGAL::get_initialized_halfedge_index_map(tmesh);
  return Sweep_algorithm<TriangleMesh,
                         VertexOrder,
                         VertexIndexMap,
                         std::decay_t<decltype(halfedge_index_map)>>(
             tmesh, order, vertex_index_map, index_bound, halfedge_index_map, request)
      .run(sorted_vertices<ConcurrencyTag>(tmesh, order));
}

// The vertices of every arc, in increasing order.
template <class ConcurrencyTag, class TriangleMesh, class VertexIndexMap, class VertexOrder>
auto vertices_of_arcs(const Arc_list<TriangleMesh>& list,
                      const TriangleMesh& tmesh,
                      VertexIndexMap vertex_index_map,
                      const VertexOrder& order)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  std::vector<std::size_t> size(list.arcs.size(), 0);
  for (const std::uint32_t arc : list.arc_of_vertex)
    if (arc != no_arc)
      ++size[arc];
  std::vector<std::vector<vertex_descriptor>> result(list.arcs.size());
  for (std::size_t a = 0; a < result.size(); ++a)
    result[a].reserve(size[a]);
  for (const vertex_descriptor v : sorted_vertices<ConcurrencyTag>(tmesh, order)) {
    const std::uint32_t arc = list.arc_of_vertex[get(vertex_index_map, v)];
    if (arc != no_arc)
      result[arc].push_back(v);
  }
  return result;
}

// Writes the arcs of the faces: that of the middle vertex; if several arcs begin there, the one
// above it in the wedge that the face's highest vertex belongs to.
template <class TriangleMesh, class VertexIndexMap, class VertexOrder, class FaceArcMap>
void write_face_arcs(const Arc_list<TriangleMesh>& list,
                     const TriangleMesh& tmesh,
                     VertexIndexMap vertex_index_map,
                     const VertexOrder& order,
                     FaceArcMap face_arc_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Number = typename boost::property_traits<FaceArcMap>::value_type;

  for (const auto f : CGAL::make_range(faces(tmesh))) {
    const auto v = middle_vertex(f, tmesh, order);
    put(face_arc_map, f, static_cast<Number>(list.arc_of_vertex[get(vertex_index_map, v)]));
  }
  for (const auto& wedge : list.upper_wedges) {
    const auto v = target(wedge.halfedge, tmesh);
    const auto write = [&](halfedge_descriptor h) {
      if (!is_border(h, tmesh) && middle_vertex(face(h, tmesh), tmesh, order) == v)
        put(face_arc_map, face(h, tmesh), static_cast<Number>(wedge.arc));
    };
    for_each_edge_of_upper_wedge(wedge.halfedge, tmesh, order, [&](halfedge_descriptor h) {
      write(h);
      write(opposite(h, tmesh));
    });
  }
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CONSTRUCTION_COMPUTE_ARC_LIST_H
