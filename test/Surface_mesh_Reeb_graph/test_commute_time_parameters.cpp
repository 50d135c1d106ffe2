// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outputs of commute_time_Reeb_graph(), its named parameters, and its errors.

#define BOOST_TEST_MODULE commute_time_parameters
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "limbed_shapes.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(outputs_and_parameters)

// A shape with maps for the outputs, filled with sentinels.
struct Fixture
{
  Fixture()
    : shape(limbed_mesh(4, poses[1], triangulations[1], straight))
    , values(shape.mesh.add_property_map<vertex_descriptor, double>("v:value", -5).first)
    , arcs(shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:arc", 12345).first)
    , step_values(shape.mesh.add_property_map<vertex_descriptor, double>("v:step_value", -5).first)
    , step_arcs(
          shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:step_arc", 12345).first)
  {}

  // The same step by step.
  template <class NamedParameters>
  Graph step_by_step(const double threshold, const NamedParameters& np)
  {
    Graph graph;
    const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh, np);
    step_points.clear();
    SMRG::feature_points(basis, std::back_inserter(step_points), np);
    SMRG::commute_time_function(basis, step_points, step_values);
    SMRG::compute_Reeb_graph(
        shape.mesh,
        step_values,
        graph,
        SMRG::parameters::vertex_arc_map(step_arcs).collect_arc_vertices(true));
    SMRG::simplify_Reeb_graph(
        shape.mesh,
        step_values,
        graph,
        SMRG::parameters::vertex_arc_map(step_arcs).persistence_threshold(threshold));
    return graph;
  }

  void check_equal_to_steps(const Graph& graph, const Graph& step_graph) const
  {
    BOOST_TEST(are_equal(graph, step_graph));
    BOOST_TEST(points == step_points, boost::test_tools::per_element());
    BOOST_TEST(std::equal(values.begin(), values.end(), step_values.begin()));
    BOOST_TEST(std::equal(arcs.begin(), arcs.end(), step_arcs.begin()));
    BOOST_TEST((vertices_of_arcs(graph) == vertices_of_arcs(step_graph)));
  }

  std::vector<Vector> straight;
  Shape shape;
  Value_map values;
  Arc_map arcs;
  Value_map step_values;
  Arc_map step_arcs;
  std::vector<vertex_descriptor> points, step_points;
};

BOOST_FIXTURE_TEST_CASE(one_call_gives_what_the_steps_give, Fixture)
{
  for (const double threshold : {0., 0.02, 0.1}) {
    Graph graph;
    points.clear();
    SMRG::commute_time_Reeb_graph(shape.mesh,
                                  graph,
                                  SMRG::parameters::persistence_threshold(threshold)
                                      .vertex_value_map(values)
                                      .vertex_arc_map(arcs)
                                      .collect_arc_vertices(true)
                                      .output_iterator(std::back_inserter(points)));
    check_equal_to_steps(graph, step_by_step(threshold, CGAL::parameters::default_values()));
  }
}

BOOST_FIXTURE_TEST_CASE(parameters_reach_the_steps, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                graph,
                                SMRG::parameters::persistence_threshold(0.05)
                                    .number_of_eigenpairs(20)
                                    .small_time(1.)
                                    .large_time(10.)
                                    .vertex_value_map(values)
                                    .vertex_arc_map(arcs)
                                    .collect_arc_vertices(true)
                                    .output_iterator(std::back_inserter(points)));
  check_equal_to_steps(
      graph,
      step_by_step(0.05,
                   SMRG::parameters::number_of_eigenpairs(20).small_time(1.).large_time(10.)));

  // and make a difference
  const std::vector<double> with_few(values.begin(), values.end());
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::vertex_value_map(values).number_of_eigenpairs(50));
  BOOST_TEST(!std::equal(values.begin(), values.end(), with_few.begin()));
}

BOOST_FIXTURE_TEST_CASE(values_are_those_of_the_nodes_and_the_farthest_distances, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      graph,
      SMRG::parameters::vertex_value_map(values).output_iterator(std::back_inserter(points)));
  for (const auto node : CGAL::make_range(vertices(graph)))
    BOOST_TEST(graph[node].value == values[graph[node].vertex]);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh);
  BOOST_REQUIRE(!points.empty());
  double difference = 0;
  for (const vertex_descriptor v : shape.vertices) {
    double farthest = 0;
    for (const vertex_descriptor p : points)
      farthest = (std::max)(farthest, basis.commute_time_distance(v, p));
    difference = (std::max)(difference, std::abs(values[v] - farthest) / farthest);
  }
  BOOST_TEST(difference <= 1e-13); // sums of 50 squares
}

BOOST_FIXTURE_TEST_CASE(arcs_of_vertices_agree_with_vertices_of_arcs, Fixture)
{
  for (const double threshold : {0., 0.1}) {
    Graph graph;
    SMRG::commute_time_Reeb_graph(shape.mesh,
                                  graph,
                                  SMRG::parameters::persistence_threshold(threshold)
                                      .vertex_value_map(values)
                                      .vertex_arc_map(arcs)
                                      .collect_arc_vertices(true));
    std::size_t number = 0;
    bool agrees = true, increases = true, lies_between = true;
    for (const auto e : CGAL::make_range(edges(graph))) {
      const auto& vertices = graph[e].vertices;
      number += vertices.size();
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        agrees = agrees && arcs[vertices[i]] == graph[e].id;
        increases = increases && (i == 0 || values[vertices[i - 1]] <= values[vertices[i]]);
        // Nothing has been cancelled at threshold 0: then an arc's vertices have values between
        // those of its nodes.
        if (threshold == 0) {
          const double s = graph[source(e, graph)].value, t = graph[target(e, graph)].value;
          lies_between = lies_between && (std::min)(s, t) <= values[vertices[i]] &&
                         values[vertices[i]] <= (std::max)(s, t);
        }
      }
    }
    BOOST_TEST(number == shape.vertices.size());
    BOOST_TEST(agrees);
    BOOST_TEST(increases);
    BOOST_TEST(lies_between);

    // the tips of different limbs lie on different arcs
    if (threshold > 0) {
      std::set<std::size_t> arcs_of_tips;
      for (const auto node : CGAL::make_range(vertices(graph)))
        if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM)
          arcs_of_tips.insert(arcs[graph[node].vertex]);
      BOOST_TEST(arcs_of_tips.size() == 4);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(absolute_threshold_is_a_difference_of_values, Fixture)
{
  Graph relative, absolute;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, relative, SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values));
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                absolute,
                                SMRG::parameters::persistence_threshold(0.1 * (*highest - *lowest))
                                    .threshold_is_absolute(true));
  BOOST_TEST(are_equal(relative, absolute));
  Graph nothing_left;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, nothing_left, SMRG::parameters::persistence_threshold(1.1));
  BOOST_TEST(summary(nothing_left) == tree_of_limbs(1));
}

// V1 and V2 are the ends of the longest limbs; the other feature points are told from all other
// vertices by their neighbors.
BOOST_FIXTURE_TEST_CASE(feature_points_are_local_extrema_of_distances_from_the_ends, Fixture)
{
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(shape.mesh);
  const auto ends = SMRG::internal::farthest_pair(
      basis.basis(0).eigenfunctions,
      SMRG::internal::relative_diffusion_factors(basis.basis(0).eigenvalues, 20));
  std::map<bool, std::set<vertex_descriptor>> points_found;
  for (const bool minima : {false, true}) {
    const double sign = minima ? -1 : 1;
    points.clear();
    Graph graph;
    SMRG::commute_time_Reeb_graph(
        shape.mesh,
        graph,
        SMRG::parameters::minima_as_feature_points(minima).output_iterator(
            std::back_inserter(points)));
    points_found[minima].insert(points.begin(), points.end());
    BOOST_TEST(points_found[minima].size() == points.size());

    std::set<vertex_descriptor> extrema;
    for (const std::size_t end : {ends.first, ends.second}) {
      const vertex_descriptor from = basis.component_vertices(0)[end];
      for (const vertex_descriptor v : shape.vertices) {
        const double distance = basis.diffusion_distance(from, v, 1.5);
        bool is_extremum = true;
        for (const vertex_descriptor u :
             CGAL::vertices_around_target(halfedge(v, shape.mesh), shape.mesh))
          is_extremum =
              is_extremum && sign * basis.diffusion_distance(from, u, 1.5) < sign * distance;
        if (is_extremum)
          extrema.insert(v);
      }
    }
    // of neighbors only one has been kept
    for (const vertex_descriptor v : points)
      BOOST_TEST(extrema.count(v) == 1);
    for (const vertex_descriptor v : extrema) {
      std::size_t kept = points_found[minima].count(v);
      for (const vertex_descriptor u :
           CGAL::vertices_around_target(halfedge(v, shape.mesh), shape.mesh))
        kept += points_found[minima].count(u);
      BOOST_TEST(kept >= 1);
    }
  }

  // maxima at all tips; the ends have distance 0 to themselves, and are minima with all that the
  // trunk has
  std::set<int> tips;
  for (const vertex_descriptor v : points_found[false])
    tips.insert(limb_with_tip_at(straight[v], 4));
  tips.erase(-1);
  BOOST_TEST(tips.size() == 4);
  std::size_t minima_at_tips = 0;
  for (const vertex_descriptor v : points_found[true])
    minima_at_tips += limb_with_tip_at(straight[v], 4) >= 0 ? 1 : 0;
  BOOST_TEST(minima_at_tips == 2);
  BOOST_TEST(points_found[true].count(basis.component_vertices(0)[ends.first]) == 1);
  BOOST_TEST(points_found[true].count(basis.component_vertices(0)[ends.second]) == 1);
}

// Soon after the start the heat that remains at a vertex counts for more than the way to the ends:
// it is least on the body.
BOOST_FIXTURE_TEST_CASE(minima_at_small_times_lie_on_the_trunk, Fixture)
{
  for (const bool minima : {false, true}) {
    Graph graph;
    points.clear();
    SMRG::commute_time_Reeb_graph(
        shape.mesh,
        graph,
        SMRG::parameters::minima_as_feature_points(minima).small_time(0.1).output_iterator(
            std::back_inserter(points)));
    std::size_t on_body = 0;
    for (const vertex_descriptor v : points) {
      const Vector& p = straight[v];
      on_body += (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) < 2 ? 1 : 0;
    }
    BOOST_TEST((on_body > 0) == minima);
  }
}

BOOST_FIXTURE_TEST_CASE(solver_is_the_one_asked_for, Fixture)
{
  using Cholesky_traits =
      CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
  Graph expected, graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      expected,
      SMRG::parameters::persistence_threshold(0.1).vertex_value_map(step_values));
  SMRG::commute_time_Reeb_graph(
      shape.mesh,
      graph,
      SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values).sparse_linear_solver(
          Cholesky_traits()));
  BOOST_TEST(are_equal(graph, expected, 1e-9));
  double difference = 0;
  for (const vertex_descriptor v : shape.vertices)
    difference = (std::max)(difference, std::abs(values[v] / step_values[v] - 1));
  BOOST_TEST(difference <= 1e-9);

  // a solver that refuses to work shows that it is asked
  struct Refusing_traits : Cholesky_traits
  {
    bool factor(const Matrix&, double&) { return false; }
  };
  BOOST_CHECK_THROW(
      SMRG::commute_time_Reeb_graph(
          shape.mesh, graph, CGAL::parameters::sparse_linear_solver(Refusing_traits())),
      SMRG::Error);
}

BOOST_FIXTURE_TEST_CASE(vertex_point_map_replaces_the_points_of_the_mesh, Fixture)
{
  Graph expected, graph;
  SMRG::commute_time_Reeb_graph(shape.mesh, expected);
  auto points_elsewhere =
      shape.mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:elsewhere").first;
  for (const vertex_descriptor v : shape.vertices) {
    points_elsewhere[v] = shape.mesh.point(v);
    shape.mesh.point(v) = CGAL::ORIGIN;
  }
  BOOST_CHECK_THROW(SMRG::commute_time_Reeb_graph(shape.mesh, graph), SMRG::Error);
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, CGAL::parameters::vertex_point_map(points_elsewhere));
  BOOST_TEST(are_equal(graph, expected));
}

BOOST_FIXTURE_TEST_CASE(errors_leave_all_outputs_as_they_were, Fixture)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Graph graph(3);
  add_edge(0, 2, graph);
  graph[1].value = 42;
  const auto fails = [&](const auto& np) {
    points.assign(2, shape.vertices[7]);
    bool failed = false;
    try {
      SMRG::commute_time_Reeb_graph(shape.mesh,
                                    graph,
                                    np.vertex_value_map(values)
                                        .vertex_arc_map(arcs)
                                        .collect_arc_vertices(true)
                                        .output_iterator(std::back_inserter(points)));
    } catch (const SMRG::Error& error) {
      failed = !std::string(error.what()).empty();
    } catch (const CGAL::Precondition_exception&) {
      failed = true;
    }
    return failed;
  };
  const auto is_untouched = [&] {
    return num_vertices(graph) == 3 && num_edges(graph) == 1 && graph[1].value == 42 &&
           points == std::vector<vertex_descriptor>(2, shape.vertices[7]) &&
           std::all_of(values.begin(), values.end(), [](double x) { return x == -5; }) &&
           std::all_of(arcs.begin(), arcs.end(), [](std::size_t x) { return x == 12345; });
  };

  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(-0.1)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(nan)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::small_time(-1.)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::large_time(nan)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::number_of_eigenpairs(0)));
  BOOST_TEST(is_untouched());
  BOOST_TEST(fails(SMRG::parameters::residual_tolerance(0)));
  BOOST_TEST(is_untouched());
  shape.mesh.point(shape.vertices[11]) = Kernel::Point_3(0, nan, 0);
  BOOST_TEST(fails(SMRG::parameters::persistence_threshold(0.1)));
  BOOST_TEST(is_untouched());
}

BOOST_FIXTURE_TEST_CASE(scale_and_rigid_motion_drop_out, Fixture)
{
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values));
  const Index_mesh input = limbed_mesh(4, poses[1], triangulations[1], straight);
  for (const double scale : {1e-100, 1e-3, 1., 1e100}) {
    Shape other(transformed(input, scale));
    Value_map other_values =
        other.mesh.add_property_map<vertex_descriptor, double>("v:value", -5).first;
    Graph other_graph;
    SMRG::commute_time_Reeb_graph(
        other.mesh,
        other_graph,
        SMRG::parameters::persistence_threshold(0.1).vertex_value_map(other_values));
    double difference = 0;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
      difference = (std::max)(
          difference, std::abs(other_values[other.vertices[v]] / values[shape.vertices[v]] - 1));
    BOOST_TEST(difference <= 1e-9);
    BOOST_TEST(are_equal(graph, other_graph, 1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()
