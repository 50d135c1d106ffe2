// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE simplify_Reeb_graph

#include "simplification_checks.h"
#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using namespace Reeb_graph_test;

// Branches and loops together through the user's function, for growing thresholds: what persistence
// says is small goes, and the numbers of nodes, arcs, components and loops fit at every step.
BOOST_AUTO_TEST_CASE(branches_and_loops_of_random_graphs_are_simplified)
{
  const Mesh no_mesh;
  const Value_map no_values;
  for (unsigned seed = 0; seed < 2 * number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Graph graph = random_graph(rng, seed % 2 == 1);
      const double range = values_of(graph).back() + 1;
      for (const double fraction : {0., 0.1, 0.3, 0.6, 2.}) {
        const double loop_threshold = fraction * range;
        const double threshold = random_unit(rng) * loop_threshold;
        const std::vector<Extended_pair> before = oracle_pairs(graph);
        const std::vector<double> values_before = values_of(graph);
        SMRG::simplify_Reeb_graph(no_mesh,
                                  no_values,
                                  graph,
                                  SMRG::parameters::threshold_is_absolute(true)
                                      .persistence_threshold(threshold)
                                      .loop_persistence_threshold(loop_threshold));
        const std::vector<Extended_pair> after = oracle_pairs(graph);
        const std::vector<double> values = values_of(graph);
        std::size_t components = 0;
        for (const Extended_pair& pair : after) {
          if (is_loop(pair))
            BOOST_TEST(persistence_of(pair, values) >= loop_threshold);
          else if (pair.kind == EXTENDED)
            ++components;
          else
            BOOST_TEST(persistence_of(pair, values) >= threshold);
        }
        BOOST_TEST(num_edges(graph) + components == num_vertices(graph) + number_of_loops(after));
        std::vector<std::size_t> down(num_vertices(graph), 0), up(num_vertices(graph), 0);
        for (const auto arc : CGAL::make_range(edges(graph))) {
          BOOST_TEST(source(arc, graph) < target(arc, graph));
          ++up[source(arc, graph)];
          ++down[target(arc, graph)];
        }
        for (const auto node : CGAL::make_range(vertices(graph))) {
          BOOST_TEST(graph[node].type == SMRG::type_of_Reeb_node(down[node], up[node]));
          BOOST_TEST(!(down[node] == 1 && up[node] == 1));
        }
        if (fraction == 0) { // the loops stay, even those in plateaus
          std::vector<double> persistence_before, persistence;
          for (const Extended_pair& pair : before)
            if (is_loop(pair))
              persistence_before.push_back(persistence_of(pair, values_before));
          for (const Extended_pair& pair : after)
            if (is_loop(pair))
              persistence.push_back(persistence_of(pair, values));
          std::sort(persistence_before.begin(), persistence_before.end());
          std::sort(persistence.begin(), persistence.end());
          BOOST_TEST(persistence == persistence_before, boost::test_tools::per_element());
        }
      }
      for (const Extended_pair& pair : oracle_pairs(graph))
        BOOST_TEST(!is_loop(pair));
    }
  }
}

// On meshes: the maps to the arcs follow, and the branches and loops that are left have the heights
// that they had.
BOOST_AUTO_TEST_CASE(maps_follow_when_loops_are_closed)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      const std::size_t n = mesh.points.size();
      Case c(mesh, seed % 3 == 2 ? random_integer_values(n, 12, rng) : random_values(n, rng));
      Graph graph;
      const auto parameters = SMRG::parameters::vertex_arc_map(c.arcs).collect_arc_vertices(true);
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph, parameters);

      // a face goes with its middle vertex, if that is no node; the others have no arc here
      auto face_arcs =
          c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc", SMRG::null_arc).first;
      std::vector<bool> is_node(n, false);
      for (const auto node : CGAL::make_range(vertices(graph)))
        is_node[graph[node].vertex] = true;
      const SMRG::
          Vertex_order<Mesh, Value_map, boost::property_map<Mesh, boost::vertex_index_t>::type>
              order(c.mesh, c.values, get(boost::vertex_index, c.mesh));
      const auto middle_vertex = [&](const Mesh::Face_index f) {
        std::vector<Vertex> corners;
        for (const Vertex v : CGAL::vertices_around_face(c.mesh.halfedge(f), c.mesh))
          corners.push_back(v);
        std::sort(corners.begin(), corners.end(), order);
        return corners[1];
      };
      for (const auto f : c.mesh.faces())
        if (!is_node[middle_vertex(f)])
          face_arcs[f] = c.arcs[middle_vertex(f)];

      for (const double fraction : {0.1, 0.4, 2.}) {
        SMRG::simplify_Reeb_graph(c.mesh,
                                  c.values,
                                  graph,
                                  parameters.face_arc_map(face_arcs)
                                      .persistence_threshold(fraction / 2)
                                      .loop_persistence_threshold(fraction));
        check_consistency(c, graph);
        for (const auto f : c.mesh.faces()) {
          const Vertex v = middle_vertex(f);
          BOOST_TEST(face_arcs[f] == (is_node[v] ? SMRG::null_arc : c.arcs[v]));
        }
      }
      for (const Extended_pair& pair : oracle_pairs(graph))
        BOOST_TEST(!is_loop(pair));
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_arguments_are_violated_preconditions)
{
  std::mt19937 rng(3);
  const Index_mesh mesh = sphere(2);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
  const std::size_t nodes = num_vertices(graph);
  const auto check = [&](const auto& parameters) {
    BOOST_CHECK_THROW(SMRG::simplify_Reeb_graph(c.mesh, c.values, graph, parameters),
                      CGAL::Precondition_exception);
    BOOST_TEST(num_vertices(graph) == nodes);
  };
  for (const double threshold : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    check(SMRG::parameters::persistence_threshold(threshold));
    check(SMRG::parameters::loop_persistence_threshold(threshold));
  }
  check(SMRG::parameters::number_of_leaves(-1));
}

BOOST_AUTO_TEST_CASE(wrong_maps_are_errors_and_change_nothing)
{
  std::mt19937 rng(3);
  const Index_mesh mesh = sphere(2);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));
  const std::size_t nodes = num_vertices(graph);
  // a map of faces that belongs to another graph; the map of the vertices is left as it was, too
  auto face_arcs = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc", 1000000).first;
  const std::vector<std::size_t> arcs_before(c.arcs.begin(), c.arcs.end());
  BOOST_CHECK_THROW(
      SMRG::simplify_Reeb_graph(
          c.mesh,
          c.values,
          graph,
          SMRG::parameters::vertex_arc_map(c.arcs).face_arc_map(face_arcs).persistence_threshold(
              infinity)),
      SMRG::Input_error);
  BOOST_TEST(std::vector<std::size_t>(c.arcs.begin(), c.arcs.end()) == arcs_before,
             boost::test_tools::per_element());
  BOOST_TEST(num_vertices(graph) == nodes);
  // another function
  auto other_values = c.mesh.add_property_map<Vertex, double>("v:other").first;
  for (const Vertex v : c.mesh.vertices())
    other_values[v] = 1 - c.values[v];
  BOOST_CHECK_THROW(SMRG::simplify_Reeb_graph(
                        c.mesh, other_values, graph, SMRG::parameters::vertex_arc_map(c.arcs)),
                    SMRG::Input_error);
  BOOST_TEST(std::vector<std::size_t>(c.arcs.begin(), c.arcs.end()) == arcs_before,
             boost::test_tools::per_element());
  // everything goes but one arc
  SMRG::simplify_Reeb_graph(c.mesh,
                            c.values,
                            graph,
                            SMRG::parameters::vertex_arc_map(c.arcs).persistence_threshold(
                                std::numeric_limits<double>::infinity()));
  BOOST_TEST(num_edges(graph) == 1u);
  for (const Vertex v : c.mesh.vertices())
    BOOST_TEST(c.arcs[v] == 0u);
}
