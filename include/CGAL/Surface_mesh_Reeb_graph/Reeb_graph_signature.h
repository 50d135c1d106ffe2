// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_SIGNATURE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_SIGNATURE_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/Measured_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/interlevel_features.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/logarithmic_difference.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/mesh_helpers.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

A point of the persistence diagram of a Reeb graph: the values of a `Persistence_pair`.
*/
struct Persistence_diagram_point
{
  /// the kind of the pair
  Persistence_pair_kind kind = Persistence_pair_kind::MINIMUM;
  /// the lower one of the two values
  double lower = 0;
  /// the higher one of the two values
  double upper = 0;

  /// returns the difference of the values.
  double persistence() const { return upper - lower; }
};

/*!
\ingroup PkgSurfaceMeshReebGraphClasses

What `Reeb_graph_distance()` compares: numbers that describe a Reeb graph with the area of the
surface on it, always the same numbers of them, and the persistence diagram. They depend only on the
graph, the function's values and the areas: not on the numbering of vertices, nodes and arcs.

Let \f$f\f$ be the function. The *levels* \f$a_0, \dots, a_8\f$ are its least value, the means of its
quantiles around the fractions 1/8, ..., 7/8 of the area, and its largest value. For each of them the
interlevel sets \f$\{|f - a_j| \le t\}\f$ grow with \f$t\f$ from the level until they are everything:
the sublevel sets for the first level, the superlevel sets for the last one. Their components are
those of the interlevel sets of the Reeb graph, and see its loops: the two sides of a loop are one
component of the sublevel set, but two of an interlevel set. The smallest \f$t\f$ for
which \f$x\f$ and \f$y\f$ are in one component, minimized over all numbers instead of these nine
levels, is half of the distance \f$d_f(x, y)\f$ of two points of the graph in
\cgalCite{bauer_2014}.

\sa `compute_Reeb_graph_signature()`
\sa `Reeb_graph_distance()`
*/
struct Reeb_graph_signature
{
  /// 32 quantiles of the function, by area (each the mean of the quantile function over an interval
  /// of length 1/32)
  std::vector<double> function_quantiles;

  /// for every level 13 distributions by area, each as 16 quantiles: of the smallest \f$t\f$ for
  /// which two points lie in one component of the interlevel set, and of the smallest \f$t\f$ for
  /// which a point lies in a component that has at least 2, 5, 10, 20, 30, 40, 50, 60, 70, 80, 90
  /// and 95 percent of the area
  std::vector<double> component_quantiles;

  /// for every level, and for components that have at least 0, 0.2, 0.5, 1, 2, 5, 10 and 20 percent
  /// of the area, the persistence of these components: that of the one that lasts until the end,
  /// then the 24 largest ones of the others in decreasing order, or zeros
  std::vector<double> branch_persistences;

  /// the persistence pairs of the graph by kind, then by decreasing persistence
  std::vector<Persistence_diagram_point> diagram;
};

namespace internal {

inline bool comes_before(const Persistence_diagram_point& p, const Persistence_diagram_point& q)
{
  return std::make_tuple(p.kind, -p.persistence(), p.lower) <
         std::make_tuple(q.kind, -q.persistence(), q.lower);
}

// The largest persistences of each kind, in decreasing order; zeros where there are no more.
inline std::vector<double>
largest_persistences(const std::vector<Persistence_diagram_point>& diagram)
{
  constexpr std::size_t number_of_kinds = 4, number_of_pairs = 32;
  std::vector<double> result(number_of_kinds * number_of_pairs, 0.);
  std::array<std::size_t, number_of_kinds> size = {};
  for (const Persistence_diagram_point& point : diagram) {
    const auto kind = static_cast<std::size_t>(point.kind);
    if (size[kind] < number_of_pairs)
      result[kind * number_of_pairs + size[kind]++] = point.persistence();
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

computes the signature of a Reeb graph, by which graphs are compared.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as
        value type
\tparam Graph as in `persistence_pairs()`; the nodes also have the member `vertex` of `Reeb_node`
\tparam VertexArcMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer type as
        value type
\tparam NamedParameters a sequence of
        \ref CGAL::Surface_mesh_Reeb_graph::parameters "named parameters"

\param tmesh the mesh
\param scalar_map the function
\param graph its Reeb graph, as `compute_Reeb_graph()` or `simplify_Reeb_graph()` has made it. For a
       distance that is stable leave the graph as it is: small branches matter little, but what a
       threshold cancels jumps.
\param vertex_arc_map the number of the arc of every vertex, as these functions write it with the
       named parameter `vertex_arc_map`. Vertices of cancelled branches count at the nearer end of
       their arc.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices; they give the areas, a third of every face for each of its vertices, and nothing else}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a three-dimensional point of a \cgal kernel as value type}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a map from every vertex to a distinct integer from 0 to `num_vertices(tmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

All numbers have the unit of the function. Borders need no care; components of the mesh are taken to
meet in the end, when the interlevel set is everything; isolated vertices have no area and count as
nodes.

Takes O(n log n) time for *n* vertices, nodes and arcs, with a factor of 9 for the levels.

\throws Input_error if a value or the area is not finite, if the area is zero, if the mesh has a face
        that is not a triangle, if the graph is not as `persistence_pairs()` asks for, or if function,
        graph and map do not belong together

\sa `Reeb_graph_distance()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class Graph,
          class VertexArcMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Reeb_graph_signature
compute_Reeb_graph_signature(const TriangleMesh& tmesh,
                             VertexScalarMap scalar_map,
                             const Graph& graph,
                             VertexArcMap vertex_arc_map,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_triangles(tmesh);
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(tmesh, np);
  const std::vector<double> areas =
      internal::barycentric_areas(tmesh, internal::vertex_point_map(tmesh, np), vertex_index_map);
  internal::Interlevel_features features = internal::interlevel_features(
      internal::Measured_graph_builder<TriangleMesh, VertexScalarMap, Graph, VertexArcMap>::build(
          tmesh, scalar_map, graph, vertex_arc_map, areas, vertex_index_map));

  Reeb_graph_signature signature;
  signature.function_quantiles = std::move(features.function_quantiles);
  signature.component_quantiles = std::move(features.component_quantiles);
  signature.branch_persistences = std::move(features.branch_persistences);
  std::vector<Persistence_pair<Graph>> pairs;
  persistence_pairs(graph, std::back_inserter(pairs));
  for (const Persistence_pair<Graph>& pair : pairs) {
    const std::pair<double, double> ends =
        std::minmax({CGAL::to_double(pair.birth_value), CGAL::to_double(pair.death_value)});
    signature.diagram.push_back({pair.kind, ends.first, ends.second});
  }
  std::sort(signature.diagram.begin(), signature.diagram.end(), internal::comes_before);
  return signature;
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns the distance of two Reeb graphs: how much their structure and values differ, loops included.

It is the weighted sum of the mean differences of four lists of numbers,

\f[ d = \tfrac{1}{10000} \, |q - q'| + \tfrac{1}{80} \, |\phi_{1/20}(c) - \phi_{1/20}(c')|
      + \tfrac{3}{16} \, |\phi_{3/100}(b) - \phi_{3/100}(b')|
      + \tfrac{1}{10} \, |\phi_{1/10}(p) - \phi_{1/10}(p')|, \f]

where \f$q\f$, \f$c\f$ and \f$b\f$ are the `function_quantiles`, `component_quantiles` and
`branch_persistences`, \f$p\f$ are the 32 largest persistences of each kind of pairs of the diagram,
\f$|\cdot|\f$ is the mean of the absolute values, and \f$\phi_s(x) = s \log(1 + x/s)\f$ takes
differences far below *s* as they are, and larger ones as ratios.

It is a pseudo-metric: zero for the graph itself and for any graph that differs from it only in the
numbering, symmetric, and with the triangle inequality, as it is a norm of a difference. Graphs of
distance zero need not be isomorphic.

It is stable: for two functions *f* and *g* on the same mesh whose Reeb graphs have not been
simplified, it is at most the largest difference \f$\max |f - g|\f$. The proof is in the manual.

The scales *s* are made for `commute_time_function()`, which has no unit and a range of about 1.
Another function should be scaled alike, all of a collection in the same way: a height by the root of
the area, for example.

\param a, b signatures from `compute_Reeb_graph_signature()`

Takes O(1) time.

\pre both have lists of the right lengths, as `compute_Reeb_graph_signature()` makes them
*/
inline double Reeb_graph_distance(const Reeb_graph_signature& a, const Reeb_graph_signature& b)
{
  return internal::mean_difference(a.function_quantiles, b.function_quantiles) / 10000 +
         internal::mean_logarithmic_difference(
             a.component_quantiles, b.component_quantiles, 1. / 20) /
             80 +
         internal::mean_logarithmic_difference(a.branch_persistences, b.branch_persistences, .03) *
             3 / 16 +
         internal::mean_logarithmic_difference(internal::largest_persistences(a.diagram),
                                               internal::largest_persistences(b.diagram),
                                               .1) /
             10;
}

/*!
\ingroup PkgSurfaceMeshReebGraphFunctions

returns the mean absolute difference of the 32 largest persistences of each kind, in decreasing order,
of the diagrams of two Reeb graphs. It does not see how the branches hang together.

\param a, b signatures from `compute_Reeb_graph_signature()`

It is a pseudo-metric, and at most twice the bottleneck distance of the diagrams.

\sa `bottleneck_distance()`
*/
inline double persistence_distance(const Reeb_graph_signature& a, const Reeb_graph_signature& b)
{
  return internal::mean_difference(internal::largest_persistences(a.diagram),
                                   internal::largest_persistences(b.diagram));
}

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_REEB_GRAPH_SIGNATURE_H
