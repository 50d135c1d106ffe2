// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that is computed from the points of a mesh, as plain data.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_SPECTRAL_RESULTS_H
#define SURFACE_MESH_REEB_GRAPH_TEST_SPECTRAL_RESULTS_H

#include "plain_results.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_functions.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace Reeb_graph_test {

struct Spectral_result
{
  std::vector<double> eigenvalues, eigenfunction, height, commute_time;
  std::vector<std::size_t> feature_points;
  Plain_graph graph;
  std::vector<long long> arc_of_vertex;
};

// Everything that is computed from the points; `np` holds CGAL's named parameters.
template <class TriangleMesh, class Axis, class NamedParameters>
Spectral_result spectral_result(const Numbered_mesh<TriangleMesh>& input,
                                const Axis& axis,
                                const NamedParameters& np)
{
  using Values = Vertex_values<TriangleMesh, double>;
  auto in_order = [&](const Values& values) {
    std::vector<double> result;
    for (auto v : input.vertices) {
      result.push_back(values.at(v));
    }
    return result;
  };
  Spectral_result result;

  const SMRG::Laplace_Beltrami_eigenbasis<TriangleMesh> basis(input.mesh, np);
  BOOST_REQUIRE_EQUAL(basis.number_of_components(), 1u);
  for (std::size_t k = 1; k <= basis.number_of_eigenpairs(0); ++k) {
    result.eigenvalues.push_back(basis.eigenvalue(0, k));
  }
  std::vector<Vertex_of<TriangleMesh>> points;
  SMRG::feature_points(basis, std::back_inserter(points), np);
  for (auto v : points) {
    result.feature_points.push_back(input.number.at(v));
  }
  Values values;
  SMRG::eigenfunction(basis, 2, boost::make_assoc_property_map(values));
  result.eigenfunction = in_order(values);
  SMRG::height_function(input.mesh, axis, boost::make_assoc_property_map(values), np);
  result.height = in_order(values);

  SMRG::Reeb_graph<TriangleMesh> graph;
  Vertex_values<TriangleMesh, int> arcs;
  Values commute_time;
  std::vector<Vertex_of<TriangleMesh>> points_of_one_call;
  SMRG::commute_time_Reeb_graph(
      input.mesh,
      graph,
      SMRG::parameters::vertex_value_map(boost::make_assoc_property_map(commute_time))
          .persistence_threshold(0.05)
          .vertex_arc_map(boost::make_assoc_property_map(arcs))
          .collect_arc_vertices(true)
          .output_iterator(std::back_inserter(points_of_one_call)));
  if (std::is_same<NamedParameters, CGAL::parameters::Default_named_parameters>::value) {
    BOOST_CHECK(points == points_of_one_call);
    SMRG::commute_time_function(basis, points, boost::make_assoc_property_map(values));
    BOOST_CHECK(values == commute_time);
  }
  result.commute_time = in_order(commute_time);
  result.graph = plain(input, graph);
  result.arc_of_vertex = numbers_of_vertices(input, arcs);
  return result;
}

template <class TriangleMesh, class Axis>
Spectral_result spectral_result(const Numbered_mesh<TriangleMesh>& input, const Axis& axis)
{
  return spectral_result(input, axis, CGAL::parameters::default_values());
}

inline void check_close(const Spectral_result& a, const Spectral_result& b)
{
  check_close(a.eigenvalues, b.eigenvalues);
  check_close(a.eigenfunction, b.eigenfunction);
  check_close(a.height, b.height);
  check_close(a.commute_time, b.commute_time);
  check_equal(a.feature_points, b.feature_points);
  check_close(a.graph, b.graph);
  check_equal(a.arc_of_vertex, b.arc_of_vertex);
}

inline const Spectral_result& spectral_reference()
{
  static const Numbered_mesh<Mesh> input(shape_with_limbs());
  static const Spectral_result result = spectral_result(input, Double_kernel::Vector_3(1, -2, 4));
  return result;
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_SPECTRAL_RESULTS_H
