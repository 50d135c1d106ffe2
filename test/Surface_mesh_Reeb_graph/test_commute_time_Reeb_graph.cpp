// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a mesh to the Reeb graph of its commute-time function, on shapes with limbs made here, in
// several poses and triangulations, and on meshes that come with CGAL.

#define BOOST_TEST_MODULE commute_time_Reeb_graph
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "limbed_shapes.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/coordinate_functions.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(shapes_of_the_tests)

BOOST_AUTO_TEST_CASE(shapes_are_closed_surfaces_of_the_genus_meant)
{
  for (const Triangulation& triangulation : triangulations) {
    Index_mesh mesh = smooth_surface(cubes_of(6), triangulation);
    BOOST_TEST(is_valid(mesh));
    BOOST_TEST(is_closed(mesh));
    BOOST_TEST(number_of_components(mesh) == 1);
    BOOST_TEST(genus(mesh) == 0);
    std::set<Cube> cubes = cubes_of(6);
    add_handle(cubes);
    mesh = smooth_surface(cubes, triangulation);
    BOOST_TEST(is_valid(mesh));
    BOOST_TEST(is_closed(mesh));
    BOOST_TEST(genus(mesh) == 1);
  }
}

BOOST_AUTO_TEST_CASE(bending_a_limb_moves_its_tip_and_keeps_its_length)
{
  const Limb& limb = all_limbs[0];
  const Vector tip = {limb.length + 1.5, 0, 0};
  for (const double bend : {1.5, -1.5}) {
    double length = 0;
    Vector previous = {1.5, 0, 0};
    for (int i = 1; i <= 1000; ++i) {
      const Vector p = posed({1.5 + i * limb.length / 1000., 0, 0}, {bend});
      length += std::hypot(p[0] - previous[0], p[1] - previous[1], p[2] - previous[2]);
      previous = p;
    }
    BOOST_CHECK_CLOSE_FRACTION(length, limb.length, 1e-5); // of a polyline of 1000 pieces
    BOOST_TEST(std::abs(previous[0] - tip[0]) > 2);
    BOOST_TEST(previous[1] * bend > 5);
  }
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(limbs)

BOOST_AUTO_TEST_CASE(every_limb_is_an_arc_in_every_pose_and_triangulation)
{
  for (const std::size_t limbs : {2, 3, 4, 5, 6}) {
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      for (std::size_t t = 0; t < triangulations.size(); ++t) {
        // all poses with some triangulation, and all triangulations with some pose
        if (limbs < 6 && (t + pose + limbs) % 3 != 0)
          continue;
        std::vector<Vector> straight;
        const Index_mesh input = limbed_mesh(limbs, poses[pose], triangulations[t], straight);
        const Shape shape(input, straight);
        BOOST_TEST_CONTEXT(limbs << " limbs, pose " << pose << ", triangulation " << t)
        {
          Graph graph;
          std::vector<vertex_descriptor> points;
          SMRG::commute_time_Reeb_graph(
              shape.mesh,
              graph,
              SMRG::parameters::persistence_threshold(0.1).output_iterator(
                  std::back_inserter(points)));
          BOOST_TEST(summary(graph) == tree_of_limbs(limbs));
          check_places_of_nodes(shape, graph, limbs);

          std::set<int> tips;
          for (const vertex_descriptor v : points)
            tips.insert(limb_with_tip_at(shape.straight_point(v), limbs));
          tips.erase(-1);
          BOOST_TEST(tips.size() == limbs);

          Graph finer;
          SMRG::commute_time_Reeb_graph(
              shape.mesh, finer, SMRG::parameters::persistence_threshold(0.05));
          BOOST_TEST(summary(finer) == tree_of_limbs(limbs));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(values_at_tips_do_not_depend_on_pose_and_triangulation)
{
  std::vector<double> first;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Vector> straight;
    const Index_mesh input = limbed_mesh(6, poses[i], triangulations[i], straight);
    const Shape shape(input, straight);
    Graph graph;
    SMRG::commute_time_Reeb_graph(shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1));
    std::vector<double> values(6, 0);
    for (const auto node : CGAL::make_range(vertices(graph))) {
      const int limb = limb_with_tip_at(shape.straight_point(graph[node].vertex), 6);
      if (graph[node].type == SMRG::Reeb_node_type::MAXIMUM && limb >= 0)
        values[static_cast<std::size_t>(limb)] = graph[node].value;
    }
    if (first.empty())
      first = values;
    // bending is not quite isometric on limbs one cube thick, and a refinement of 2 leaves some
    // discretization error: a few percent
    for (std::size_t limb = 0; limb < 6; ++limb)
      BOOST_CHECK_CLOSE_FRACTION(values[limb], first[limb], 0.05);
  }
}

BOOST_AUTO_TEST_CASE(handle_between_two_limbs_is_one_loop)
{
  for (const Triangulation& triangulation : triangulations) {
    for (const std::size_t limbs : {3, 6}) {
      std::set<Cube> cubes = cubes_of(limbs);
      add_handle(cubes);
      const Shape shape(smooth_surface(cubes, triangulation));
      for (const double threshold : {0.1, 0.05}) {
        Graph graph;
        SMRG::commute_time_Reeb_graph(
            shape.mesh, graph, SMRG::parameters::persistence_threshold(threshold));
        BOOST_TEST(summary(graph).loops == 1);
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).minima == 1);
        // every limb ends in a maximum beyond the handle; its corner may be one more
        BOOST_TEST(summary(graph).maxima >= limbs);
        BOOST_TEST(summary(graph).maxima <= limbs + 1);
        BOOST_TEST(summary(graph).splits + 1 == summary(graph).maxima + summary(graph).loops);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(torus_has_one_loop_for_any_function)
{
  const Index_mesh input = torus(40, 16, 3, 1);
  const Shape shape(input);
  Graph graph;
  SMRG::commute_time_Reeb_graph(
      shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1).number_of_eigenpairs(20));
  BOOST_TEST(summary(graph).loops == 1);
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(components_of_the_mesh)

BOOST_AUTO_TEST_CASE(every_component_has_the_graph_that_it_has_alone)
{
  std::vector<Vector> straight;
  const Index_mesh four = limbed_mesh(4, poses[1], triangulations[1], straight);
  const Index_mesh three = limbed_mesh(3, poses[2], triangulations[0], straight);
  Index_mesh input = four;
  append(input, three, 40);
  const Index_mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}}, {{0, 1, 2}}};
  append(input, triangle, 80);
  append(input, Index_mesh{{{0, 0, 0}}, {}}, 90);
  Shape shape(input);

  Value_map values = shape.mesh.add_property_map<vertex_descriptor, double>("v:value", -1).first;
  Arc_map arcs = shape.mesh.add_property_map<vertex_descriptor, std::size_t>("v:arc", 7777).first;
  Graph graph;
  std::vector<vertex_descriptor> points;
  SMRG::commute_time_Reeb_graph(shape.mesh,
                                graph,
                                SMRG::parameters::persistence_threshold(0.1)
                                    .vertex_value_map(values)
                                    .vertex_arc_map(arcs)
                                    .output_iterator(std::back_inserter(points)));

  Shape four_alone(four), three_alone(three);
  std::size_t offset = 0;
  for (Shape* alone : {&four_alone, &three_alone}) {
    Value_map values_alone =
        alone->mesh.add_property_map<vertex_descriptor, double>("v:value", -1).first;
    Graph graph_alone;
    SMRG::commute_time_Reeb_graph(
        alone->mesh,
        graph_alone,
        SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values_alone));
    BOOST_TEST(summary(graph_alone) == tree_of_limbs(alone == &four_alone ? 4 : 3));
    double difference = 0;
    std::set<std::size_t> nodes_alone, nodes;
    for (std::size_t v = 0; v < alone->vertices.size(); ++v)
      difference = (std::max)(
          difference,
          std::abs(values[shape.vertices[offset + v]] - values_alone[alone->vertices[v]]));
    // the translation rounds coordinates to 1e-14
    BOOST_TEST(difference <= 1e-9);
    for (const auto node : CGAL::make_range(vertices(graph_alone)))
      nodes_alone.insert(offset + graph_alone[node].vertex);
    for (const auto node : CGAL::make_range(vertices(graph))) {
      const std::size_t v = graph[node].vertex;
      if (v >= offset && v < offset + alone->vertices.size())
        nodes.insert(v);
    }
    BOOST_TEST(nodes == nodes_alone, boost::test_tools::per_element());
    offset += alone->vertices.size();
  }

  // the triangle is an arc of two nodes, the isolated vertex a node with value 0 and no arc
  BOOST_TEST(summary(graph) == (Summary{4, 3, 8, 5, 0, 0}));
  const vertex_descriptor isolated = shape.vertices.back();
  BOOST_TEST(values[isolated] == 0);
  BOOST_TEST(arcs[isolated] == SMRG::null_arc);
  std::size_t isolated_nodes = 0;
  for (const auto node : CGAL::make_range(vertices(graph)))
    if (graph[node].type == SMRG::Reeb_node_type::ISOLATED) {
      ++isolated_nodes;
      BOOST_TEST(graph[node].vertex == isolated);
    }
  BOOST_TEST(isolated_nodes == 1);
  BOOST_TEST(std::count(points.begin(), points.end(), isolated) == 0);
}

BOOST_AUTO_TEST_CASE(meshes_without_faces_have_graphs_without_arcs)
{
  Graph graph(5);
  const Shape empty((Index_mesh()));
  SMRG::commute_time_Reeb_graph(empty.mesh, graph);
  BOOST_TEST(num_vertices(graph) == 0);
  BOOST_TEST(num_edges(graph) == 0);
  const Shape points(Index_mesh{{{0, 0, 0}, {1, 0, 0}}, {}});
  SMRG::commute_time_Reeb_graph(points.mesh, graph);
  BOOST_TEST(num_vertices(graph) == 2);
  BOOST_TEST(num_edges(graph) == 0);
}

BOOST_AUTO_TEST_CASE(surface_with_border_has_a_graph)
{
  // a limbed shape without the tip of its last limb
  Index_mesh input = smooth_surface(cubes_of(6), triangulations[0]);
  const auto is_beyond = [&](const std::array<std::size_t, 3>& t) {
    return input.points[t[0]][2] < -11;
  };
  input.triangles.erase(std::remove_if(input.triangles.begin(), input.triangles.end(), is_beyond),
                        input.triangles.end());
  remove_isolated_vertices(input);
  BOOST_REQUIRE(is_valid(input));
  BOOST_REQUIRE(!is_closed(input));
  const Shape shape(input);
  Graph graph;
  SMRG::commute_time_Reeb_graph(shape.mesh, graph, SMRG::parameters::persistence_threshold(0.1));
  BOOST_TEST(summary(graph) == tree_of_limbs(6));
}

BOOST_AUTO_TEST_SUITE_END()

// -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_SUITE(meshes_of_cgal)

BOOST_AUTO_TEST_CASE(camel_has_head_tail_and_legs)
{
  Mesh mesh;
  if (!read("camel.off", mesh))
    return;
  Graph graph;
  SMRG::commute_time_Reeb_graph(mesh, graph, SMRG::parameters::persistence_threshold(0.1));
  BOOST_TEST(summary(graph) == tree_of_limbs(6));
}

BOOST_AUTO_TEST_CASE(loops_are_the_genus_of_closed_surfaces)
{
  for (const auto& [name, genus] : {std::pair<std::string, std::size_t>("elephant.off", 3),
                                    std::pair<std::string, std::size_t>("eight.off", 2),
                                    std::pair<std::string, std::size_t>("knot1.off", 1)})
  {
    Mesh mesh;
    if (!read(name, mesh))
      continue;
    BOOST_TEST_CONTEXT(name)
    {
      // closed and connected, hence V - E + F = 2 - 2 genus
      BOOST_REQUIRE(CGAL::is_closed(mesh));
      BOOST_REQUIRE(num_vertices(mesh) + num_faces(mesh) + 2 * genus == num_edges(mesh) + 2);
      for (const double threshold : {0., 0.1}) {
        Graph graph;
        SMRG::commute_time_Reeb_graph(
            mesh, graph, SMRG::parameters::persistence_threshold(threshold));
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).loops == genus);
      }
      Value_map height = mesh.add_property_map<vertex_descriptor, double>("v:height", 0).first;
      for (const Kernel::Vector_3& axis :
           {Kernel::Vector_3(0.31, -0.52, 0.79), Kernel::Vector_3(0.83, 0.44, -0.19)})
      {
        SMRG::height_function(mesh, axis, height);
        Graph graph;
        SMRG::compute_Reeb_graph(mesh, height, graph);
        BOOST_TEST(summary(graph).components == 1);
        BOOST_TEST(summary(graph).loops == genus);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
