// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_H

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The type of a node, from the numbers (*down*, *up*) of arcs that end and begin there. In a graph
that has been neither simplified nor unfolded, these are the numbers of components of the level set
just below and just above the vertex that touch it, less those cancelled inside a plateau.
*/
enum class Reeb_node_type {
  MINIMUM,      ///< (0, 1): a component appears
  MAXIMUM,      ///< (1, 0): a component vanishes
  SPLIT_SADDLE, ///< (1, 2): a component splits in two (a bifurcation)
  MERGE_SADDLE, ///< (2, 1): two components merge (a junction)
  ISOLATED,     ///< (0, 0): a vertex without edges
  DEGENERATE    ///< anything else, as (1, 3), (2, 2), or (0, 2) at a border vertex of several fans
};

/// \ingroup PkgSurfaceMeshReebGraphClasses
/// gives the type of a node that has `down` arcs below and `up` arcs above.
inline Reeb_node_type type_of_Reeb_node(std::size_t down, std::size_t up)
{
  if (down == 0 && up == 1)
    return Reeb_node_type::MINIMUM;
  if (down == 1 && up == 0)
    return Reeb_node_type::MAXIMUM;
  if (down == 1 && up == 2)
    return Reeb_node_type::SPLIT_SADDLE;
  if (down == 2 && up == 1)
    return Reeb_node_type::MERGE_SADDLE;
  if (down == 0 && up == 0)
    return Reeb_node_type::ISOLATED;
  return Reeb_node_type::DEGENERATE;
}

/// \ingroup PkgSurfaceMeshReebGraphClasses
/// writes the type in words: `minimum`, `maximum`, `split`, `merge`, `isolated` or `degenerate`.
inline std::ostream& operator<<(std::ostream& out, Reeb_node_type type)
{
  switch (type) {
  case Reeb_node_type::MINIMUM:
    return out << "minimum";
  case Reeb_node_type::MAXIMUM:
    return out << "maximum";
  case Reeb_node_type::SPLIT_SADDLE:
    return out << "split";
  case Reeb_node_type::MERGE_SADDLE:
    return out << "merge";
  case Reeb_node_type::ISOLATED:
    return out << "isolated";
  case Reeb_node_type::DEGENERATE:
    break;
  }
  return out << "degenerate";
}

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The vertex bundle of `Reeb_graph`: a critical vertex of the mesh.

\tparam TriangleMesh the type of the mesh
\tparam FT the type of the function's values
*/
template <class TriangleMesh, class FT>
struct Reeb_node
{
  /// the number of the node, from 0, in the increasing order of the critical vertices
  /// (also where values are equal, see `Vertex_order`)
  std::size_t id = 0;
  /// the critical vertex
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex = {};
  /// the function's value there
  FT value = FT(0);
  /// the type of the node
  Reeb_node_type type = Reeb_node_type::ISOLATED;
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The edge bundle of `Reeb_graph`: a family of components of level sets between two nodes.

\tparam TriangleMesh the type of the mesh
*/
template <class TriangleMesh>
struct Reeb_arc
{
  /// the number of the arc, from 0, in the order of the lower nodes
  std::size_t id = 0;
  /// the vertices of the mesh that belong to the arc, in increasing order; filled on request only,
  /// with the named parameter `collect_arc_vertices`. Every vertex that has an edge belongs to
  /// exactly one arc, the vertex of a node to the first arc that begins there, or else to the first
  /// that ends there. The values lie between those of the two nodes; not so those of the vertices
  /// of branches that `simplify_Reeb_graph()` has cancelled.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices = {};
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The default type of Reeb graphs. It is a Boost graph, no more and no less: \c vecS for the edges
lets two nodes be joined by several arcs, as the two saddles of a torus are.

Nodes and arcs are added in the order of their numbers. The source of an edge is its lower node only
where `edges(graph)` gave it; `lower_node()` and `upper_node()` tell the ends apart everywhere.

\sa `lower_node()`, `upper_node()`

\tparam TriangleMesh the type of the mesh
\tparam FT the type of the function's values
*/
template <class TriangleMesh, class FT = double>
using Reeb_graph = boost::adjacency_list<boost::vecS,
                                         boost::vecS,
                                         boost::undirectedS,
                                         Reeb_node<TriangleMesh, FT>,
                                         Reeb_arc<TriangleMesh>>;

/// \ingroup PkgSurfaceMeshReebGraphFunctions
/// returns the lower end of an arc.
///
/// The graph may be of any type whose nodes have a member `id`, as those of `Reeb_node`, and the
/// arc of any origin: what `out_edges()` gives has the node asked as its source, which may be the
/// upper one.
///
/// \tparam Graph a model of `EdgeListGraph` filled by `compute_Reeb_graph()`
///
/// \sa `upper_node()`
template <class Graph>
typename boost::graph_traits<Graph>::vertex_descriptor
lower_node(typename boost::graph_traits<Graph>::edge_descriptor arc, const Graph& graph)
{
  const auto nodes = get(boost::vertex_bundle, graph);
  const auto a = source(arc, graph), b = target(arc, graph);
  return nodes[b].id < nodes[a].id ? b : a;
}

/// \ingroup PkgSurfaceMeshReebGraphFunctions
/// returns the upper end of an arc.
///
/// \tparam Graph a model of `EdgeListGraph` filled by `compute_Reeb_graph()`
///
/// \sa `lower_node()`
template <class Graph>
typename boost::graph_traits<Graph>::vertex_descriptor
upper_node(typename boost::graph_traits<Graph>::edge_descriptor arc, const Graph& graph)
{
  const auto nodes = get(boost::vertex_bundle, graph);
  const auto a = source(arc, graph), b = target(arc, graph);
  return nodes[b].id < nodes[a].id ? a : b;
}

/// \cond SKIP_IN_MANUAL

// CGAL has a function template of this name for the halfedge data structures, which
// argument-dependent lookup also finds for a Boost graph whose bundles know a mesh of CGAL, and
// which would be preferred to Boost's there. This overload leads such calls, in
// boost::isomorphism() for example, back to Boost.
template <class OutEdgeList,
          class VertexList,
          class Directed,
          class VertexProperty,
          class EdgeProperty,
          class GraphProperty,
          class EdgeList>
auto adjacent_vertices(typename boost::adjacency_list<OutEdgeList,
                                                      VertexList,
                                                      Directed,
                                                      VertexProperty,
                                                      EdgeProperty,
                                                      GraphProperty,
                                                      EdgeList>::vertex_descriptor v,
                       const boost::adjacency_list<OutEdgeList,
                                                   VertexList,
                                                   Directed,
                                                   VertexProperty,
                                                   EdgeProperty,
                                                   GraphProperty,
                                                   EdgeList>& graph)
{
  return boost::adjacent_vertices(v, graph);
}

/// \endcond

/// \ingroup PkgSurfaceMeshReebGraphClasses
/// the arc number of a vertex that belongs to no arc because it has no edges
/// (converted to the value type of the user's map).
constexpr std::size_t null_arc = (std::numeric_limits<std::size_t>::max)();

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_H
