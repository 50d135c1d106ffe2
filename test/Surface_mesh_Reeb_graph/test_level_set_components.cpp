// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE level_set_components

#include "level_set_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

// ---------------------------------------------------------------------------------------------
// What the documentation promises of one component

void check_component(const Case& c,
                     const std::vector<std::size_t>& rank,
                     const std::size_t level,
                     const Component& component)
{
  const Mesh& mesh = c.mesh;
  const std::vector<Halfedge>& halfedges = component.halfedges;
  BOOST_REQUIRE(!halfedges.empty());
  for (const Halfedge h : halfedges)
    BOOST_REQUIRE((rank[source(h, mesh)] < level && level <= rank[target(h, mesh)]));
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    const bool is_last = i + 1 == halfedges.size();
    const auto f = mesh.face(halfedges[i]);
    if (is_last && !component.is_closed) {
      BOOST_TEST((f == Mesh::null_face()));
    } else {
      const Halfedge next = halfedges[is_last ? 0 : i + 1];
      BOOST_REQUIRE((f != Mesh::null_face()));
      BOOST_TEST((f == mesh.face(mesh.opposite(next))));
    }
  }
  if (!component.is_closed)
    BOOST_TEST((mesh.face(mesh.opposite(halfedges.front())) == Mesh::null_face()));
}

// The edges as the oracle numbers them.
Level_component numbers_of_edges(const Case& c,
                                 const std::map<Index_edge, std::size_t>& number_of_edge,
                                 const Component& component)
{
  Level_component result;
  for (const Halfedge h : component.halfedges)
    result.push_back(number_of_edge.at(undirected(source(h, c.mesh), target(h, c.mesh))));
  std::sort(result.begin(), result.end());
  return result;
}

// The oracle's components that touch `v`, sorted by the neighbors of `v` that they separate from
// it.
std::vector<Level_component> expected_components(const Edge_table& table,
                                                 const std::vector<Level_component>& all,
                                                 const std::vector<std::size_t>& rank,
                                                 const std::size_t v)
{
  std::map<std::size_t, Level_component> result; // by the distance in the order
  for (const Level_component& component : all) {
    std::size_t distance = rank.size();
    for (const std::size_t e : component) {
      const auto& ends = table.edges[e];
      if (ends[0] == v || ends[1] == v) {
        const std::size_t a = rank[ends[0]], b = rank[ends[1]];
        distance = (std::min)(distance, a < b ? b - a : a - b);
      }
    }
    if (distance < rank.size())
      result.emplace(distance, component);
  }
  std::vector<Level_component> sorted;
  for (const auto& entry : result)
    sorted.push_back(entry.second);
  return sorted;
}

// Into how many parts the surface falls if it is cut along curves: edges that no curve crosses hold
// vertices together.
std::size_t number_of_parts(const Mesh& mesh, const std::vector<Component>& curves)
{
  std::set<Mesh::Edge_index> cut;
  for (const Component& curve : curves)
    for (const Halfedge h : curve.halfedges)
      cut.insert(mesh.edge(h));
  boost::disjoint_sets_with_storage<> sets(mesh.num_vertices());
  std::size_t parts = mesh.number_of_vertices();
  for (const auto e : mesh.edges()) {
    const std::size_t u = sets.find_set(std::size_t(mesh.vertex(e, 0)));
    const std::size_t v = sets.find_set(std::size_t(mesh.vertex(e, 1)));
    if (cut.count(e) == 0 && u != v) {
      sets.link(u, v);
      --parts;
    }
  }
  return parts;
}

} // namespace

// ---------------------------------------------------------------------------------------------
// Components

BOOST_AUTO_TEST_CASE(agree_with_brute_force)
{
  for_random_cases([](const Case& c) {
    const Edge_table table(c.index_mesh);
    std::map<Index_edge, std::size_t> number_of_edge;
    for (std::size_t e = 0; e < table.edges.size(); ++e)
      number_of_edge[undirected(table.edges[e][0], table.edges[e][1])] = e;

    const std::vector<std::size_t> rank = ranks_of(c);
    const std::vector<std::size_t> order = order_of_rank(rank);
    const Components components(c.mesh, c.values);
    std::vector<Level_component> level_below; // none below the lowest vertex
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::vector<Level_component> level_above = level_set_components(table, rank, k);
      const Vertex v(static_cast<unsigned>(order[k]));
      for (const bool is_below : {true, false}) {
        const std::vector<Component> found = is_below ? below(components, v) : above(components, v);
        const std::vector<Level_component> expected =
            expected_components(table, is_below ? level_below : level_above, rank, v);
        BOOST_REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          check_component(c, rank, is_below ? k : k + 1, found[i]);
          BOOST_TEST((numbers_of_edges(c, number_of_edge, found[i]) == expected[i]));
        }
      }
      level_below = level_above;
    }
  });
}

// A component below or above a node is the end or the beginning of an arc: the nearest vertex on
// its other side lies on the arc, or is its other node.
BOOST_AUTO_TEST_CASE(belong_to_the_arcs_of_the_graph)
{
  for_random_cases([](Case& c) {
    const std::vector<std::size_t> rank = ranks_of(c);
    const Components components(c.mesh, c.values);
    // ranks in the place of the values, so that no arc inside a plateau is cancelled
    c.set(std::vector<double>(rank.begin(), rank.end()));
    Graph graph;
    SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs));

    std::map<Vertex, std::size_t> node_of_vertex;
    for (const auto node : CGAL::make_range(vertices(graph)))
      node_of_vertex[graph[node].vertex] = node;
    std::vector<std::vector<std::size_t>> arcs_down(num_vertices(graph)),
        arcs_up(num_vertices(graph));
    std::vector<std::array<std::size_t, 2>> ends;
    for (const auto arc : CGAL::make_range(edges(graph))) {
      arcs_up[source(arc, graph)].push_back(graph[arc].id);
      arcs_down[target(arc, graph)].push_back(graph[arc].id);
      ends.push_back({source(arc, graph), target(arc, graph)});
    }

    for (const Vertex v : c.mesh.vertices()) {
      const auto found = node_of_vertex.find(v);
      if (found == node_of_vertex.end()) {
        BOOST_TEST(below(components, v).size() == 1u);
        BOOST_TEST(above(components, v).size() == 1u);
        continue;
      }
      const std::size_t node = found->second;
      const std::vector<Component> curves_up = above(components, v);
      BOOST_REQUIRE(curves_up.size() == arcs_up[node].size());
      for (std::size_t k = 0; k < curves_up.size(); ++k) {
        Vertex nearest = c.mesh.target(curves_up[k].halfedges.front());
        for (const Halfedge h : curves_up[k].halfedges)
          if (rank[c.mesh.target(h)] < rank[nearest])
            nearest = c.mesh.target(h);
        const std::size_t arc = arcs_up[node][k];
        if (node_of_vertex.count(nearest) != 0)
          BOOST_TEST(ends[arc][1] == node_of_vertex[nearest]);
        else
          BOOST_TEST(c.arcs[nearest] == arc);
      }

      const std::vector<Component> curves_down = below(components, v);
      BOOST_REQUIRE(curves_down.size() == arcs_down[node].size());
      std::set<std::size_t> arcs_of_regular_vertices;
      for (const Component& curve : curves_down) {
        Vertex nearest = c.mesh.source(curve.halfedges.front());
        for (const Halfedge h : curve.halfedges)
          if (rank[c.mesh.source(h)] > rank[nearest])
            nearest = c.mesh.source(h);
        if (node_of_vertex.count(nearest) == 0) {
          BOOST_TEST(ends[c.arcs[nearest]][1] == node);
          BOOST_TEST(arcs_of_regular_vertices.insert(c.arcs[nearest]).second);
        }
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(one_off_functions_do_the_same)
{
  std::mt19937 rng(1);
  Case c(closed_surface(2, 5, 4),
         random_integer_values(closed_surface(2, 5, 4).points.size(), 5, rng));
  const Components components(c.mesh, c.values);
  for (const Vertex v : c.mesh.vertices()) {
    std::vector<Component> found_below, found_above;
    SMRG::level_set_components_below(v, c.mesh, c.values, std::back_inserter(found_below));
    SMRG::level_set_components_above(v, c.mesh, c.values, std::back_inserter(found_above));
    for (const bool is_below : {true, false}) {
      const std::vector<Component>& found = is_below ? found_below : found_above;
      const std::vector<Component> expected =
          is_below ? below(components, v) : above(components, v);
      BOOST_REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        BOOST_TEST((found[i].halfedges == expected[i].halfedges));
        BOOST_TEST(found[i].is_closed == expected[i].is_closed);
        BOOST_TEST((SMRG::level_set_polyline(found[i], c.mesh, c.values) ==
                    components.polyline(expected[i])));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertex_has_no_components)
{
  Index_mesh mesh = sphere(0);
  mesh.points.push_back({0, 0, 5});
  const Case c(mesh, heights(mesh, {0.1, 0.2, 1}));
  const Components components(c.mesh, c.values);
  BOOST_TEST(below(components, Vertex(12)).empty());
  BOOST_TEST(above(components, Vertex(12)).empty());
  BOOST_TEST(components.polyline(Component()).empty());
}

// Three upper and three lower wedges at a vertex in the middle: the level sets next to it pass it
// three times. On a disk these are three curves each; on a closed surface the rest decides.
BOOST_AUTO_TEST_CASE(multiple_saddle)
{
  Index_mesh disk;
  disk.points.push_back({0, 0, 0});
  std::vector<double> values = {0};
  for (std::size_t i = 0; i < 12; ++i) {
    const double angle = static_cast<double>(i) * std::acos(-1.) / 6;
    disk.points.push_back({std::cos(angle), std::sin(angle), 0});
    disk.triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
    values.push_back((i % 4 < 2 ? 1 : -1) * (1 + 0.01 * static_cast<double>(i)));
  }
  const Case open(disk, values);
  const Components components(open.mesh, open.values);
  BOOST_TEST(below(components, Vertex(0)).size() == 3u);
  BOOST_TEST(above(components, Vertex(0)).size() == 3u);
  for (const Component& curve : below(components, Vertex(0)))
    BOOST_TEST(!curve.is_closed);

  // under the disk a highest vertex closes the surface and joins the three hills: above the saddle
  // there is one curve, around all of them
  Index_mesh closed = disk;
  closed.points.push_back({0, 0, -1});
  for (std::size_t i = 0; i < 12; ++i)
    closed.triangles.push_back({13, 1 + (i + 1) % 12, 1 + i});
  values.push_back(10);
  const Case with_maximum(closed, values);
  const Components with_maximum_components(with_maximum.mesh, with_maximum.values);
  BOOST_TEST(below(with_maximum_components, Vertex(0)).size() == 3u);
  const std::vector<Component> one = above(with_maximum_components, Vertex(0));
  BOOST_REQUIRE(one.size() == 1u);
  BOOST_TEST(one.front().is_closed);
  // six edges of the middle, six of the rim, six of the highest vertex
  BOOST_TEST(one.front().halfedges.size() == 6u + 6u + 6u);
}

BOOST_AUTO_TEST_CASE(cutting_a_torus_at_its_saddles)
{
  const Index_mesh mesh = torus(40, 20);
  const Case c(mesh, heights(mesh, {1, 0.15, 0.005}));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
  BOOST_REQUIRE(graph[2].type == SMRG::Reeb_node_type::MERGE_SADDLE);
  const Components components(c.mesh, c.values);
  const std::vector<Component> below_merge = below(components, graph[2].vertex);
  const std::vector<Component> above_split = above(components, graph[1].vertex);
  for (const std::vector<Component>& curves : {below_merge, above_split}) {
    BOOST_REQUIRE(curves.size() == 2u);
    for (const Component& curve : curves) {
      BOOST_TEST(curve.is_closed);
      BOOST_TEST(number_of_parts(c.mesh, {curve}) == 1u);
    }
    BOOST_TEST(number_of_parts(c.mesh, curves) == 2u);
  }
  std::vector<Component> all = below_merge;
  all.insert(all.end(), above_split.begin(), above_split.end());
  BOOST_TEST(number_of_parts(c.mesh, all) == 4u);
  BOOST_TEST(below(components, graph[1].vertex).size() == 1u);
  BOOST_TEST(above(components, graph[2].vertex).size() == 1u);
}

BOOST_AUTO_TEST_CASE(cylinder_has_open_curves_across)
{
  const Index_mesh mesh = cylinder(24, 7);
  const Case c(mesh, heights(mesh, {1, 1e-3, 1e-6}));
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
  const Components components(c.mesh, c.values);
  unsigned curves = 0;
  for (const auto node : CGAL::make_range(vertices(graph))) {
    for (const Component& curve : below(components, graph[node].vertex)) {
      ++curves;
      const std::vector<Point> points = components.polyline(curve);
      BOOST_TEST(!curve.is_closed);
      BOOST_TEST(points.size() == curve.halfedges.size());
    }
  }
  BOOST_TEST(curves == num_edges(graph));
}

// ---------------------------------------------------------------------------------------------
// Plateaus

// Components are those of the order; pairs of equal values are cancelled in the graph. So there may
// be more components than arcs at a vertex, or fewer, but not for the values of the order.
BOOST_AUTO_TEST_CASE(as_many_arcs_as_components_for_the_values_of_the_order)
{
  unsigned number_of_differences = 0;
  for_random_cases([&](Case& c) {
    const auto count_differences = [&]() {
      const Components components(c.mesh, c.values);
      Graph graph;
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      std::vector<std::size_t> arcs_down(num_vertices(graph), 0), arcs_up(num_vertices(graph), 0);
      for (const auto arc : CGAL::make_range(edges(graph))) {
        ++arcs_up[source(arc, graph)];
        ++arcs_down[target(arc, graph)];
      }
      unsigned result = 0;
      for (const auto node : CGAL::make_range(vertices(graph)))
        result += arcs_down[node] == below(components, graph[node].vertex).size() &&
                          arcs_up[node] == above(components, graph[node].vertex).size()
                      ? 0
                      : 1;
      return result;
    };
    number_of_differences += count_differences();
    SMRG::vertex_order_values(c.mesh, c.values, c.values);
    BOOST_TEST(count_differences() == 0u);
  });
  BOOST_TEST(number_of_differences > 0u);
}

// The lowest vertex of a square grid in the order is on a plateau with a saddle, whose pair is
// cancelled: two curves for one arc. For the values of the order there is an arc for every curve.
BOOST_AUTO_TEST_CASE(curves_of_a_plateau_and_arcs_of_the_order)
{
  const std::vector<double> values = {0, 1, 1, 1, 2, 0, 0, 0, 1};
  Mesh mesh;
  std::vector<Vertex> v;
  for (std::size_t i = 0; i < 9; ++i)
    v.push_back(mesh.add_vertex(Mesh::Point(double(i / 3), double(i % 3), 0)));
  for (const std::array<std::size_t, 3> f : {std::array<std::size_t, 3>{0, 3, 4},
                                             {0, 4, 1},
                                             {1, 4, 5},
                                             {1, 5, 2},
                                             {3, 6, 7},
                                             {3, 7, 4},
                                             {4, 7, 8},
                                             {4, 8, 5}})
    BOOST_REQUIRE((mesh.add_face(v[f[0]], v[f[1]], v[f[2]]) != Mesh::null_face()));
  auto value_map = mesh.add_property_map<Vertex, double>("v:value").first;
  for (std::size_t i = 0; i < 9; ++i)
    value_map[v[i]] = values[i];

  const auto arcs_and_curves = [&]() {
    const Components components(mesh, value_map);
    Graph graph;
    SMRG::compute_Reeb_graph(mesh, value_map, graph);
    std::pair<std::size_t, std::size_t> result(0, above(components, v[1]).size());
    for (const auto arc : CGAL::make_range(edges(graph)))
      result.first += graph[source(arc, graph)].vertex == v[1] ? 1 : 0;
    return result;
  };
  BOOST_TEST((arcs_and_curves() == std::pair<std::size_t, std::size_t>(1, 2)));
  SMRG::vertex_order_values(mesh, value_map, value_map);
  BOOST_TEST((arcs_and_curves() == std::pair<std::size_t, std::size_t>(2, 2)));
}

// ---------------------------------------------------------------------------------------------
// Data that cannot be computed with

BOOST_AUTO_TEST_CASE(bad_data)
{
  const auto check = [](const Case& c, const char* const message) {
    const auto has_message = [message](const SMRG::Error& error) {
      return std::string(error.what()).find(message) != std::string::npos;
    };
    std::vector<Component> found;
    BOOST_CHECK_EXCEPTION(Components(c.mesh, c.values), SMRG::Error, has_message);
    BOOST_CHECK_EXCEPTION(
        SMRG::level_set_components_below(Vertex(1), c.mesh, c.values, std::back_inserter(found)),
        SMRG::Error,
        has_message);
    BOOST_CHECK_EXCEPTION(
        SMRG::level_set_components_above(Vertex(1), c.mesh, c.values, std::back_inserter(found)),
        SMRG::Error,
        has_message);
    BOOST_TEST(found.empty());
  };

  Case with_nan(sphere(0), std::vector<double>(12, 1.));
  with_nan.values[Vertex(7)] = std::numeric_limits<double>::quiet_NaN();
  check(with_nan, "vertex 7 ");

  Case with_quad(Index_mesh(), {});
  std::vector<Vertex> corners;
  for (int i = 0; i < 4; ++i)
    corners.push_back(with_quad.mesh.add_vertex(Point(i % 2, i / 2, 0)));
  with_quad.mesh.add_face(corners[0], corners[1], corners[3], corners[2]);
  check(with_quad, "triangle");

  // two closed surfaces that share a vertex
  Index_mesh two_spheres = sphere(0);
  append(two_spheres, sphere(0), 3);
  Case glued(two_spheres, std::vector<double>(24, 1.));
  const Vertex kept(0), gone(12);
  std::vector<Halfedge> star;
  for (const Halfedge h : CGAL::halfedges_around_target(gone, glued.mesh))
    star.push_back(h);
  for (const Halfedge h : star)
    set_target(h, kept, glued.mesh);
  set_halfedge(gone, Mesh::null_halfedge(), glued.mesh);
  remove_vertex(gone, glued.mesh);
  check(glued, "several fans");
}
