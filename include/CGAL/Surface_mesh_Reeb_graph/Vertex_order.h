// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_VERTEX_ORDER_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_VERTEX_ORDER_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>
#include <CGAL/utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Says that all values are known to be numbers, and those of neighbors to be different.
struct No_plateaus
{
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The strict total order of the vertices that turns any scalar function into one with distinct values
(\cgalCite{el_khoury_2012}, Section 4.3 and Eq. 13), and so into a Morse function, but for multiple
saddles, which stay. Vertices are compared

1. by their value, exactly: never with a tolerance;
2. inside a plateau (vertices of equal value that are connected by edges) by the number of edges,
   along the plateau, from its lower border: the vertices of the plateau that have a lower neighbor.
   A plateau without a lower border counts from one of its vertices, which is the only local minimum
   that a plateau can have;
3. by their index.

The object can be copied cheaply. It is a model of `StrictWeakOrdering` for vertices and can be
given to `std::sort()`. On a function without plateaus it takes no memory.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type, or
        any other type with a strict order `<`, as value type
\tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptor as key type and a
        distinct integer from 0 to `num_vertices(tmesh) - 1` for every vertex
*/
template <class TriangleMesh, class VertexScalarMap, class VertexIndexMap>
class Vertex_order
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  /// the vertex descriptor of the mesh
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  /// the type of the function's values
  using FT = std::remove_cv_t<typename boost::property_traits<VertexScalarMap>::value_type>;

  /*!
  prepares the order.

  Takes one pass over vertices and edges; if there are plateaus, another one and four bytes per
  vertex.

  \param tmesh the mesh; it must outlive the order
  \param scalar_map the function
  \param vertex_index_map the indices of the vertices

  \throws Error if a value is not a number; infinite values are ordered as such
  */
  Vertex_order(const TriangleMesh& tmesh,
               VertexScalarMap scalar_map,
               VertexIndexMap vertex_index_map)
    : m_scalar_map(scalar_map), m_vertex_index_map(vertex_index_map)
  {
    check_values(tmesh);
    if (exists_plateau(tmesh))
      internal::check_mesh_on_internal_error(
          tmesh, vertex_index_map, [&]() { measure_plateaus(tmesh); });
  }

  /// \cond SKIP_IN_MANUAL

  Vertex_order(VertexScalarMap scalar_map, VertexIndexMap vertex_index_map, internal::No_plateaus)
    : m_scalar_map(scalar_map), m_vertex_index_map(vertex_index_map)
  {}

  // What the order compares, with the comparison.
  struct Key
  {
    FT value;
    std::uint32_t plateau_distance;
    std::size_t index;

    friend bool operator<(const Key& a, const Key& b)
    {
      if (a.value < b.value)
        return true;
      if (b.value < a.value)
        return false;
      if (a.plateau_distance != b.plateau_distance)
        return a.plateau_distance < b.plateau_distance;
      return a.index < b.index;
    }
  };

  Key key(vertex_descriptor v) const
  {
    return {value(v), plateau_distance(v), static_cast<std::size_t>(get(m_vertex_index_map, v))};
  }

  void check_value(vertex_descriptor v) const
  {
    if (!CGAL::is_valid(value(v)))
      throw Input_error("the value of vertex " + std::to_string(get(m_vertex_index_map, v)) +
                        " is not a number");
  }

  /// \endcond

  /// returns the value of `v`.
  FT value(vertex_descriptor v) const { return get(m_scalar_map, v); }

  /// returns `true` if two neighbors have the same value.
  bool has_plateaus() const { return m_plateau_distance != nullptr; }

  /// returns the number of edges from `v`, along its plateau, to the plateau's lower border
  /// (0 for a vertex that lies in no plateau).
  std::uint32_t plateau_distance(vertex_descriptor v) const
  {
    return m_plateau_distance == nullptr ? 0 : (*m_plateau_distance)[get(m_vertex_index_map, v)];
  }

  /// returns `true` if `u` comes before `v`.
  bool operator()(vertex_descriptor u, vertex_descriptor v) const
  {
    // the only branch is almost always taken, while which value is less cannot be predicted
    const FT u_value = value(u), v_value = value(v);
    const bool is_less = u_value < v_value;
    if (is_less != (v_value < u_value))
      return is_less;
    const std::uint32_t u_distance = plateau_distance(u), v_distance = plateau_distance(v);
    if (u_distance != v_distance)
      return u_distance < v_distance;
    return get(m_vertex_index_map, u) < get(m_vertex_index_map, v);
  }

private:
  void check_values(const TriangleMesh& tmesh) const
  {
    for (vertex_descriptor v : CGAL::make_range(vertices(tmesh)))
      check_value(v);
  }

  bool are_tied(vertex_descriptor u, vertex_descriptor v) const
  {
    const FT u_value = value(u), v_value = value(v);
    return !(u_value < v_value) && !(v_value < u_value);
  }

  bool exists_plateau(const TriangleMesh& tmesh) const
  {
    for (auto e : CGAL::make_range(edges(tmesh)))
      if (are_tied(source(e, tmesh), target(e, tmesh)))
        return true;
    return false;
  }

  // Breadth-first search along the plateaus, from all lower borders at once, then from one vertex
  // of every plateau that has none.
  void measure_plateaus(const TriangleMesh& tmesh)
  {
    constexpr std::uint32_t unreached = (std::numeric_limits<std::uint32_t>::max)();
    m_plateau_distance = std::make_shared<std::vector<std::uint32_t>>(
        internal::index_bound(tmesh, m_vertex_index_map), unreached);

    std::vector<vertex_descriptor> queue;
    auto reach = [&](vertex_descriptor v, std::uint32_t distance) {
      (*m_plateau_distance)[get(m_vertex_index_map, v)] = distance;
      queue.push_back(v);
    };
    auto search = [&]() {
      for (std::size_t i = 0; i < queue.size(); ++i) {
        const vertex_descriptor u = queue[i];
        const std::uint32_t next_distance = plateau_distance(u) + 1;
        internal::for_each_neighbor(u, tmesh, [&](vertex_descriptor v) {
          if (plateau_distance(v) == unreached && are_tied(u, v))
            reach(v, next_distance);
        });
      }
      queue.clear();
    };

    for (vertex_descriptor u : CGAL::make_range(vertices(tmesh))) {
      bool has_lower = false, has_tied = false;
      internal::for_each_neighbor(u, tmesh, [&](vertex_descriptor v) {
        has_lower = has_lower || value(v) < value(u);
        has_tied = has_tied || are_tied(u, v);
      });
      if (has_lower || !has_tied)
        reach(u, 0);
    }
    search();
    for (vertex_descriptor u : CGAL::make_range(vertices(tmesh))) {
      if (plateau_distance(u) == unreached) {
        reach(u, 0);
        search();
      }
    }
  }

  VertexScalarMap m_scalar_map;
  VertexIndexMap m_vertex_index_map;
  // by vertex index, null without plateaus; shared, so that copies of the order are cheap
  std::shared_ptr<std::vector<std::uint32_t>> m_plateau_distance;
};

namespace internal {

// Whether a number type can tell the numbers 0, ..., n - 1 apart, and 0 / n, ..., (n - 1) / n too.
template <class Number>
bool has_distinct_numbers(std::size_t n)
{
  // binary digits; 0 for types that do not say how many they have
  constexpr int digits = std::numeric_limits<Number>::digits;
  if constexpr (0 < digits && digits < std::numeric_limits<std::size_t>::digits)
    return n == 0 || ((n - 1) >> digits) == 0;
  else
    return true;
}

template <class Number>
void check_distinct_numbers(std::size_t number_of_vertices)
{
  if (!has_distinct_numbers<Number>(number_of_vertices))
    throw Input_error("the value type of the map is too small to number " +
                      std::to_string(number_of_vertices) + " vertices");
}

// All vertices of the mesh in their order. When this returns, the data can do nothing wrong any
// more.
template <class Number, class TriangleMesh, class VertexScalarMap, class NamedParameters>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
vertices_to_number(const TriangleMesh& tmesh, VertexScalarMap scalar_map, const NamedParameters& np)
{
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  using VIM = std::decay_t<decltype(vertex_index_map)>;

  const Vertex_order<TriangleMesh, VertexScalarMap, VIM> order(tmesh, scalar_map, vertex_index_map);
  auto vertices = sorted_vertices<CGAL::Sequential_tag>(tmesh, order);
  check_distinct_numbers<Number>(vertices.size());
  return vertices;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

numbers the vertices of a mesh in the order of `Vertex_order`: the lowest vertex has the rank 0, the
highest one *n* - 1, where *n* is the number of vertices. (Removed vertices of a
`CGAL::Surface_mesh` do not count.)

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type, or
        any other type with a strict order `<`, as value type
\tparam VertexRankMap a model of `WritablePropertyMap` with the vertex descriptor as key type and a
        number type as value type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param rank_map receives the ranks; it may be the map of the function itself
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

Takes O(n log n) time.

\throws Error if a value is not a number, or if the value type of the rank map cannot
        hold the ranks; the rank map is then left as it was

\sa `vertex_order_values()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexRankMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void vertex_ranks(const TriangleMesh& tmesh,
                  VertexScalarMap scalar_map,
                  VertexRankMap rank_map,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using Number = std::remove_cv_t<typename boost::property_traits<VertexRankMap>::value_type>;

  const auto vertices = internal::vertices_to_number<Number>(tmesh, scalar_map, np);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    put(rank_map, vertices[i], static_cast<Number>(i));
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

turns a scalar function into one with distinct values (\cgalCite{el_khoury_2012}, Eq. 13): the
vertex of rank *i* in the order of `Vertex_order` gets the value *i* / *n*, where *n* is the number
of vertices.

As in the paper, *i* counts from 0: the values are 0, 1 / *n*, ..., (*n* - 1) / *n*. All of them are
different, and `Vertex_order` gives the same order for them as for the function, whatever the
indices of the vertices: both have the same level set components. (`compute_Reeb_graph()` needs no
such function; it compares vertices in this order itself, and cancels the pairs of extrema and
saddles inside plateaus then, which the values given here hide from it.)

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type, or
        any other type with a strict order `<`, as value type
\tparam VertexValueMap a model of `WritablePropertyMap` with the vertex descriptor as key type and a
        number type that has fractions, as `double`, as value type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param value_map receives the values; it may be the map of the function itself
\param np an optional sequence of named parameters, as for `vertex_ranks()`

Takes O(n log n) time.

\throws Error if a value is not a number, or if the value type of the value map cannot
        tell the new values apart (as `float` for more than 16 777 216 vertices); the value map is
        then left as it was

\sa `vertex_ranks()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexValueMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void vertex_order_values(const TriangleMesh& tmesh,
                         VertexScalarMap scalar_map,
                         VertexValueMap value_map,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using Number = std::remove_cv_t<typename boost::property_traits<VertexValueMap>::value_type>;
  static_assert(!std::numeric_limits<Number>::is_integer,
                "the values of the vertex order are fractions: integers cannot hold them");

  const auto vertices = internal::vertices_to_number<Number>(tmesh, scalar_map, np);
  const Number n = static_cast<Number>(static_cast<double>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    put(value_map, vertices[i], Number(static_cast<Number>(static_cast<double>(i)) / n));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_VERTEX_ORDER_H
