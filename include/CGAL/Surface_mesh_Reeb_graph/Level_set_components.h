// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_LEVEL_SET_COMPONENTS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_LEVEL_SET_COMPONENTS_H

#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/Level_set_walk.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/check_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/sorted_vertices.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/difference.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

A connected component of a level set of a scalar function on a triangle mesh, as the edges that it
crosses: a curve that is closed, or that begins and ends on the border of the mesh.
`Level_set_components` finds them.

\tparam TriangleMesh a model of `HalfedgeGraph`
*/
template <class TriangleMesh>
struct Level_set_component
{
  /// the halfedge descriptor of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// the crossed edges, in the order in which the curve meets them, as the halfedges that point
  /// upwards: their sources lie below the level, their targets above. Consecutive ones, if the
  /// curve is closed also the last and the first one, belong to one triangle, the face of the
  /// former halfedge. Seen from outside the higher side lies to the right of the curve.
  std::vector<halfedge_descriptor> halfedges;

  /// whether the curve is closed. If not, its first and its last edge are border edges.
  bool is_closed = false;
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

The components of the level sets of a scalar function just below and just above the vertices of a
triangle mesh.

At a node of a Reeb graph components of the level set appear, vanish, split or merge. Those just
below and just above the vertex of the node that touch it are the curves along which the surface can
be cut there: if no two neighbors have the same value and multiple saddles are not unfolded, there is
below a node of the graph that `compute_Reeb_graph()` makes a component for every arc that ends at
it, above it one for every arc that begins at it.

The vertices are compared by `Vertex_order`, as everywhere in this package. So a component is well
defined even inside a plateau; no vertex lies on a level set. But `compute_Reeb_graph()` cancels
pairs of an extremum and a saddle that have equal values: so there may be more components than arcs
at a vertex of a plateau, or fewer. There are as many for the graph of the function that
`vertex_order_values()` makes of the values, whose components are the same. Multiple saddles,
borders, several components, isolated vertices, and border vertices at which several fans of faces
meet are normal input.

The object is made once for all vertices. All its members are `const`, several threads may call them
at once.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type; for components without polylines any other type with a strict order `<` will do
\tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptor as key type and a
        distinct integer from 0 to `num_vertices(tmesh) - 1` for every vertex

The template arguments can be left to the compiler:

\code{.cpp}
const SMRG::Level_set_components components(mesh, values);
for (const auto node : CGAL::make_range(vertices(graph))) {
  std::vector<SMRG::Level_set_component<Mesh>> curves;
  components.below(graph[node].vertex, std::back_inserter(curves));
  for (const auto& curve : curves)
    use(components.polyline(curve));
}
\endcode

\sa `compute_Reeb_graph()`
\sa `level_set_components_below()`
\sa `level_set_components_above()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexIndexMap =
              typename CGAL::GetInitializedVertexIndexMap<TriangleMesh>::const_type>
class Level_set_components
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  /// \name Types
  /// @{

  /// the vertex descriptor of the mesh
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  /// the halfedge descriptor of the mesh
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  /// the type of the function's values
  using FT = std::remove_cv_t<typename boost::property_traits<VertexScalarMap>::value_type>;
  /// the type of a component
  using Component = Level_set_component<TriangleMesh>;

  /// @}
  /// \name Construction
  /// @{

  /*!
  sorts the vertices.

  \tparam NamedParameters a sequence of
          \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

  \param tmesh the mesh; it must outlive the object and not be changed meanwhile
  \param scalar_map the function; its values must stay the same meanwhile
  \param np an optional sequence of named parameters among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_index_map}
      \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
      \cgalParamType{`VertexIndexMap`}
      \cgalParamDefault{an automatically indexed internal map}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Takes O(n log n) time for *n* vertices and faces, and about 16 bytes per vertex.

  \throws Error if a face is not a triangle, if a value is not a number, or if the faces
          around a vertex form several closed fans
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Level_set_components(const TriangleMesh& tmesh,
                       VertexScalarMap scalar_map,
                       const NamedParameters& np = CGAL::parameters::default_values())
    : m_tmesh(tmesh)
    , m_scalar_map(scalar_map)
    , m_vertex_index_map(CGAL::get_initialized_vertex_index_map(tmesh, np))
  {
    internal::check_triangles(tmesh);
    internal::check_mesh(tmesh, m_vertex_index_map);
    const Vertex_order<TriangleMesh, VertexScalarMap, VertexIndexMap> order(
        tmesh, scalar_map, m_vertex_index_map);
    m_vertices = internal::sorted_vertices<CGAL::Sequential_tag>(tmesh, order);
    m_rank.resize(internal::index_bound(tmesh, m_vertex_index_map));
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_rank[get(m_vertex_index_map, m_vertices[i])] = i;
  }

  /// @}
  /// \name Components
  /// @{

  /*!
  writes the components of the level set just below `v` that touch `v`. Closed ones begin at an edge
  of `v`, open ones on the border.

  The components come in the order of the highest neighbors of `v` that lie below them, the one of
  the highest first. A minimum has none, and an isolated vertex neither.

  Takes time in proportion to the number of crossed edges (and to *d* log *d* for a vertex with *d*
  edges).

  \tparam OutputIterator a model of `OutputIterator` that accepts `Component`

  \return the iterator past the components
  */
  template <class OutputIterator>
  OutputIterator below(vertex_descriptor v, OutputIterator out) const
  {
    return touching_components(v, rank(v), out);
  }

  /*!
  writes the components of the level set just above `v` that touch `v`, as `below()` does.

  The components come in the order of the lowest neighbors of `v` that lie above them, the one of
  the lowest first. This is the order in which `compute_Reeb_graph()` numbers the arcs that begin at
  `v`: the *k*-th component is the beginning of the *k*-th arc. (The graph has fewer arcs where
  pairs of an extremum and a saddle have been cancelled: by `simplify_Reeb_graph()`, or because they
  have equal values. If multiple saddles are unfolded, the components are those of all nodes of `v`
  together.)
  */
  template <class OutputIterator>
  OutputIterator above(vertex_descriptor v, OutputIterator out) const
  {
    return touching_components(v, rank(v) + 1, out);
  }

  /// @}
  /// \name Geometry
  /// @{

  /*!
  returns a component as a polyline in space, with a point on every crossed edge.

  All points lie where the function, extended linearly over the edges, has the same value: the mean
  of the values of the highest vertex below and of the lowest vertex above the curve. If these two
  are equal, as in plateaus, the positions of the vertices in the order count:
  - On an edge between vertices of different values the point lies where the function has this
    value, moved by less than half of the way to the next lower or higher value of a vertex, in the
    order of the levels.
  - On an edge between vertices of equal value, and on an edge that ends in an infinite value, the
    point lies as if the ranks of the vertices were the values.

  Hence every point lies inside its edge, not at a vertex, and polylines of different components, of
  whatever vertices, have no point in common: one can cut along all of them. (Numbers of limited
  precision can be too coarse for that, if values or points are almost equal.)

  \tparam NamedParameters a sequence of
          \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

  \param component a component that this object has found
  \param np an optional sequence of named parameters among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
      \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
      \cgalParamExtra{with a kernel of exact constructions the points lie exactly on the edges}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Takes time in proportion to the number of crossed edges (and to log *n* in plateaus).

  \return the points, as a `std::vector` of the value type of the vertex point map; the first point
          of a closed component is repeated at the end
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  auto polyline(const Component& component,
                const NamedParameters& np = CGAL::parameters::default_values()) const
  {

    const auto vertex_point_map = internal::vertex_point_map(m_tmesh, np);
    using Point_3 = std::remove_cv_t<
        typename boost::property_traits<std::decay_t<decltype(vertex_point_map)>>::value_type>;
    using Coordinate = typename CGAL::Kernel_traits<Point_3>::Kernel::FT;

    std::vector<Point_3> points;
    if (component.halfedges.empty())
      return points;
    points.reserve(component.halfedges.size() + 1);
    const Level level = level_of(component);
    for (halfedge_descriptor h : component.halfedges)
      points.push_back(CGAL::barycenter(get(vertex_point_map, source(h, m_tmesh)),
                                        static_cast<Coordinate>(1 - position(level, h)),
                                        get(vertex_point_map, target(h, m_tmesh))));
    if (component.is_closed)
      points.push_back(Point_3(points.front()));
    return points;
  }

  /// @}

private:
  // An edge of a vertex that the level set crosses.
  struct Star_edge
  {
    std::size_t distance;         // how many places the other vertex is away in the order
    halfedge_descriptor halfedge; // points upwards
    bool is_done;
  };

  // Where a component crosses its edges.
  struct Level
  {
    double rank;
    FT value; // the largest one below
    // What has to be added to the value on edges that begin, or that end, at a different value.
    double shift_up, shift_down;
  };

  std::size_t rank(vertex_descriptor v) const { return m_rank[get(m_vertex_index_map, v)]; }

  FT value(std::size_t rank) const { return get(m_scalar_map, m_vertices[rank]); }

  // The components that touch `v` of the level set that has `level` vertices below it.
  template <class OutputIterator>
  OutputIterator
  touching_components(vertex_descriptor v, std::size_t level, OutputIterator out) const
  {
    std::vector<Star_edge> star = crossed_edges(v, level);
    for (const Star_edge& edge : star)
      if (!edge.is_done)
        *out++ = component(edge.halfedge, v, level, star);
    return out;
  }

  // The nearest vertices in the order come first: they decide on the order of the components.
  std::vector<Star_edge> crossed_edges(vertex_descriptor v, std::size_t level) const
  {
    std::vector<Star_edge> star;
    if (internal::has_no_edge(v, m_tmesh))
      return star;
    const std::size_t v_rank = rank(v);
    const bool v_is_above = level <= v_rank;
    for (halfedge_descriptor h : CGAL::halfedges_around_target(v, m_tmesh)) {
      const std::size_t u_rank = rank(source(h, m_tmesh));
      if ((level <= u_rank) == v_is_above)
        continue;
      if (v_is_above)
        star.push_back({v_rank - u_rank, h, false});
      else
        star.push_back({u_rank - v_rank, opposite(h, m_tmesh), false});
    }
    std::stable_sort(star.begin(), star.end(), [](const Star_edge& a, const Star_edge& b) {
      return a.distance < b.distance;
    });
    return star;
  }

  // The component that crosses the edge of `start`. All its edges in the star of `v` are done then.
  Component component(halfedge_descriptor start,
                      vertex_descriptor v,
                      std::size_t level,
                      std::vector<Star_edge>& star) const
  {
    using Walk = internal::Level_set_walk<TriangleMesh>;
    const auto is_above = [this, level](vertex_descriptor u) { return level <= rank(u); };

    Component result;
    const auto add = [&](halfedge_descriptor h) {
      result.halfedges.push_back(h);
      set_done(h, v, star);
    };

    add(start);
    for (Walk walk(start, true); !walk.is_at_border(m_tmesh);) {
      walk.step(m_tmesh, is_above);
      if (walk.halfedge() == start) {
        result.is_closed = true;
        return result;
      }
      add(walk.halfedge());
    }

    // it has come to the border: what is left lies in the other direction
    std::reverse(result.halfedges.begin(), result.halfedges.end());
    for (Walk walk(opposite(start, m_tmesh), false); !walk.is_at_border(m_tmesh);) {
      walk.step(m_tmesh, is_above);
      add(opposite(walk.halfedge(), m_tmesh));
    }
    std::reverse(result.halfedges.begin(), result.halfedges.end());
    return result;
  }

  void set_done(halfedge_descriptor h, vertex_descriptor v, std::vector<Star_edge>& star) const
  {
    const vertex_descriptor lower = source(h, m_tmesh), upper = target(h, m_tmesh);
    if (lower != v && upper != v)
      return;
    const std::size_t distance = rank(upper) - rank(lower);
    auto edge =
        std::lower_bound(star.begin(), star.end(), distance, [](const Star_edge& e, std::size_t d) {
          return e.distance < d;
        });
    while (edge->halfedge != h) // two vertices may be joined by several edges
      ++edge;
    edge->is_done = true;
  }

  Level level_of(const Component& component) const
  {
    // the highest vertex below the component, the lowest one above it
    std::size_t lower = 0, upper = m_vertices.size() - 1;
    for (halfedge_descriptor h : component.halfedges) {
      lower = (std::max)(lower, rank(source(h, m_tmesh)));
      upper = (std::min)(upper, rank(target(h, m_tmesh)));
    }
    CGAL_precondition(lower < upper);

    Level level;
    level.rank = (static_cast<double>(lower) + static_cast<double>(upper)) / 2;
    level.value = value(lower);
    level.shift_up = level.shift_down = 0;
    if (level.value < value(upper))
      level.shift_up = internal::half_of_difference(level.value, value(upper)) / 2;
    else
      spread_tied_levels(level);
    return level;
  }

  // The levels between vertices of equal value get different places, in their order, in the inner
  // halves of the gaps to the next values. The outer halves belong to the levels next to these
  // gaps.
  void spread_tied_levels(Level& level) const
  {
    const auto tied = std::equal_range(
        m_vertices.begin(), m_vertices.end(), level.value, Compare_values{m_scalar_map});
    const auto first = static_cast<std::size_t>(tied.first - m_vertices.begin());
    const auto end = static_cast<std::size_t>(tied.second - m_vertices.begin());
    const double place =
        (level.rank - static_cast<double>(first)) / static_cast<double>(end - first - 1);
    if (0 < first)
      level.shift_down =
          -internal::half_of_difference(value(first - 1), level.value) * (1 - place) / 2;
    if (end < m_vertices.size())
      level.shift_up = internal::half_of_difference(level.value, value(end)) * place / 2;
  }

  // Where the component crosses an edge: strictly between 0, the source, and 1, the target.
  double position(const Level& level, halfedge_descriptor h) const
  {
    const std::size_t lower = rank(source(h, m_tmesh)), upper = rank(target(h, m_tmesh));
    const FT lower_value = value(lower), upper_value = value(upper);
    if (lower_value < upper_value && !is_infinite(lower_value) && !is_infinite(upper_value)) {
      const double shift = (lower_value < level.value ? level.shift_down : 0) +
                           (level.value < upper_value ? level.shift_up : 0);
      const double t = (internal::half_of_difference(lower_value, level.value) + shift) /
                       internal::half_of_difference(lower_value, upper_value);
      if (t == t) // values next to zero may have the difference zero
        return (std::min)((std::max)(t, (std::numeric_limits<double>::min)()),
                          1 - std::numeric_limits<double>::epsilon());
    }
    return (level.rank - static_cast<double>(lower)) /
           (static_cast<double>(upper) - static_cast<double>(lower));
  }

  struct Compare_values
  {
    VertexScalarMap scalar_map;

    bool operator()(vertex_descriptor v, const FT& x) const { return get(scalar_map, v) < x; }
    bool operator()(const FT& x, vertex_descriptor v) const { return x < get(scalar_map, v); }
  };

  static bool is_infinite(const FT& x)
  {
    using Limits = std::numeric_limits<FT>;
    if constexpr (Limits::has_infinity)
      return x == Limits::infinity() || x == -Limits::infinity();
    else
      return false;
  }

  const TriangleMesh& m_tmesh;
  VertexScalarMap m_scalar_map;
  VertexIndexMap m_vertex_index_map;
  std::vector<vertex_descriptor> m_vertices; // in increasing order
  std::vector<std::size_t> m_rank;           // by vertex index
};

/// \cond SKIP_IN_MANUAL

template <class TriangleMesh, class VertexScalarMap, class NamedParameters>
Level_set_components(const TriangleMesh&, VertexScalarMap, const NamedParameters&)
    -> Level_set_components<
        TriangleMesh,
        VertexScalarMap,
        typename CGAL::GetInitializedVertexIndexMap<TriangleMesh, NamedParameters>::const_type>;

/// \endcond

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

writes the components of the level set of a scalar function just below a vertex that touch the
vertex; see `Level_set_components::below()`.

This is for one vertex: every call sorts all vertices. For several vertices make an object of the
class `Level_set_components`.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type
\tparam OutputIterator a model of `OutputIterator` that accepts `Level_set_component<TriangleMesh>`
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param v the vertex, as the member `vertex` of a node of a Reeb graph
\param tmesh the mesh
\param scalar_map the function
\param out the components
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the iterator past the components

\throws Error if a face is not a triangle, if a value is not a number, or if the faces
        around a vertex form several closed fans; nothing has been written then
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator
level_set_components_below(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                           const TriangleMesh& tmesh,
                           VertexScalarMap scalar_map,
                           OutputIterator out,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  return Level_set_components(tmesh, scalar_map, np).below(v, out);
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

writes the components of the level set of a scalar function just above a vertex that touch the
vertex; see `Level_set_components::above()`, and `level_set_components_below()` for the parameters.
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator
level_set_components_above(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                           const TriangleMesh& tmesh,
                           VertexScalarMap scalar_map,
                           OutputIterator out,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  return Level_set_components(tmesh, scalar_map, np).above(v, out);
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns a component of a level set as a polyline in space; see `Level_set_components::polyline()`.

This is for one component: every call sorts all vertices. For several components make an object of
the class `Level_set_components`.

\param component a component found by `level_set_components_below()` or
        `level_set_components_above()`
\param tmesh the mesh
\param scalar_map the function, as given to that function
\param np an optional sequence of named parameters: `vertex_index_map` as given to that function,
       and `vertex_point_map` as for `Level_set_components::polyline()`

\return the points, as a `std::vector` of the value type of the vertex point map

\throws Error as `level_set_components_below()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
auto level_set_polyline(const Level_set_component<TriangleMesh>& component,
                        const TriangleMesh& tmesh,
                        VertexScalarMap scalar_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  return Level_set_components(tmesh, scalar_map, np).polyline(component, np);
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_LEVEL_SET_COMPONENTS_H
