// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command-line tool puts into its HTML page: at every stop the graph and the regions that
// simplify_Reeb_graph() makes. (check_page.mjs looks at the page itself, in a browser.)

#define BOOST_TEST_MODULE test_html_page

#include "Grouping_locale.h"
#include "Index_mesh.h"
#include "brute_force_Reeb_graph.h"
#include "random_meshes.h"

// after random_meshes.h: Boost's disjoint sets do not compile after its readers of graphs
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/Graph_recorder.h"
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/cluster_vertices.h"
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/make_page.h"
#include "../../examples/Surface_mesh_Reeb_graph/reeb_graph_tool/write_page.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/embed_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

void compute_graph(Result& result, bool unfold)
{
  SMRG::compute_Reeb_graph(result.mesh,
                           result.values,
                           result.graph,
                           SMRG::parameters::vertex_arc_map(result.arcs)
                               .collect_arc_vertices(true)
                               .unfold_multiple_saddles(unfold));
}

void simplify(Result& result, const Options& options, double threshold)
{
  SMRG::simplify_Reeb_graph(result.mesh,
                            result.values,
                            result.graph,
                            SMRG::parameters::vertex_arc_map(result.arcs)
                                .persistence_threshold(options.gap == 0 ? threshold : 0)
                                .persistence_gap(options.gap)
                                .threshold_is_absolute(options.threshold_is_absolute));
}

void set_up(Result& result, const Index_mesh& mesh, const std::vector<double>& function)
{
  std::vector<vertex_descriptor> vertices;
  make_mesh(mesh, result.mesh, vertices);
  result.values = result.mesh.add_property_map<vertex_descriptor, double>("v:value").first;
  result.arcs = result.mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;
  for (const vertex_descriptor v : vertices)
    result.values[v] = function[v];
}

// The arcs of a graph with the vertices that are no nodes, in a form that compares.
std::vector<Comparable_arc> arcs_of_result(const Result& result)
{
  std::set<std::size_t> nodes;
  for (const auto node : CGAL::make_range(vertices(result.graph)))
    nodes.insert(result.graph[node].vertex);
  std::vector<std::vector<std::size_t>> regular(num_edges(result.graph));
  for (const vertex_descriptor v : result.mesh.vertices())
    if (result.arcs[v] >= 0 && nodes.count(v) == 0)
      regular[static_cast<std::size_t>(result.arcs[v])].push_back(v);
  std::vector<Comparable_arc> arcs;
  for (const auto arc : CGAL::make_range(edges(result.graph)))
    arcs.push_back(comparable_arc(result.graph[SMRG::lower_node(arc, result.graph)].vertex,
                                  result.graph[SMRG::upper_node(arc, result.graph)].vertex,
                                  regular[result.graph[arc].id]));
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

bool is_there(const Page::Arc& arc, std::uint32_t stop)
{
  return arc.begin <= stop && stop < arc.end;
}

// The arc that a group of vertices belongs to, as the page finds it.
std::uint32_t arc_at(const Page& page, std::uint32_t group, std::uint32_t stop)
{
  std::uint32_t arc = page.arc_of_group[group];
  while (!is_there(page.arcs[arc], stop)) {
    const std::uint32_t last = arc;
    arc = page.arcs[last].heir;
    if (arc == Page::none)
      for (const Page::Parting& parting : page.partings)
        if (parting.arc == last && parting.group == group)
          arc = parting.heir;
    BOOST_REQUIRE(arc != Page::none);
    BOOST_REQUIRE(page.arcs[last].end < page.arcs[arc].end);
  }
  return arc;
}

std::vector<std::uint32_t> nodes_at(const Page& page, std::uint32_t stop)
{
  std::vector<std::uint32_t> result;
  for (const Page::Node& node : page.nodes)
    if (stop < node.end)
      result.push_back(node.vertex);
  return result;
}

std::vector<Comparable_arc> arcs_at(const Page& page, std::uint32_t stop)
{
  const std::vector<std::uint32_t> nodes = nodes_at(page, stop);
  const std::set<std::uint32_t> is_node(nodes.begin(), nodes.end());
  std::map<std::uint32_t, std::vector<std::size_t>> regular;
  for (std::size_t i = 0; i < page.vertices.size(); ++i)
    if (page.groups[i] != Page::none && is_node.count(page.vertices[i]) == 0)
      regular[arc_at(page, page.groups[i], stop)].push_back(page.vertices[i]);
  std::vector<Comparable_arc> arcs;
  for (std::uint32_t a = 0; a < page.arcs.size(); ++a)
    if (is_there(page.arcs[a], stop))
      arcs.push_back(comparable_arc(page.nodes[page.arcs[a].lower].vertex,
                                    page.nodes[page.arcs[a].upper].vertex,
                                    regular[a]));
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

void check_stop(const Page& page, std::uint32_t stop, const Result& result)
{
  std::vector<std::uint32_t> nodes;
  for (const auto node : CGAL::make_range(vertices(result.graph)))
    nodes.push_back(static_cast<std::uint32_t>(result.graph[node].vertex));
  BOOST_TEST(nodes_at(page, stop) == nodes);
  BOOST_TEST((arcs_at(page, stop) == arcs_of_result(result)));
}

// The page begins with the graph of the result, and its arcs are the curves of the skeleton.
void check_curves(const Page& page, const Result& result)
{
  check_stop(page, page.first_stop, result);
  using Segment = std::array<Page::Point, 2>;
  std::vector<Segment> expected, segments;
  const Skeleton& skeleton = *result.skeleton;
  const auto place = [&](auto v) {
    const auto& p = skeleton[v].point;
    return Page::Point{p.x(), p.y(), p.z()};
  };
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    expected.push_back({place(source(edge, skeleton)), place(target(edge, skeleton))});
  for (const Page::Arc& arc : page.arcs) {
    if (!is_there(arc, page.first_stop))
      continue;
    std::vector<Page::Point> points = arc.points;
    points.insert(points.begin(), page.nodes[arc.lower].place);
    points.push_back(page.nodes[arc.upper].place);
    for (std::size_t i = 1; i < points.size(); ++i)
      segments.push_back({points[i - 1], points[i]});
  }
  for (std::vector<Segment>* list : {&expected, &segments}) {
    for (Segment& segment : *list)
      std::sort(segment.begin(), segment.end());
    std::sort(list->begin(), list->end());
  }
  BOOST_TEST((segments == expected));
}

// With curves that are made faster than the skeleton.
Page page_of(const Options& options, Result& result, const Finest_graph& finest)
{
  SMRG::embed_Reeb_graph(result.mesh, result.values, result.graph, result.skeleton.emplace());
  Progress progress;
  return make_page(options, result, finest, progress);
}

Page check_all_stops(const Index_mesh& mesh,
                     const std::vector<double>& function,
                     const Options& options)
{
  Result finest_result;
  set_up(finest_result, mesh, function);
  compute_graph(finest_result, options.unfold);
  const Finest_graph finest = finest_graph(finest_result);
  const SMRG::Reeb_graph_hierarchy<Graph> hierarchy(
      finest.graph, SMRG::parameters::threshold_is_absolute(options.threshold_is_absolute));

  Result result;
  set_up(result, mesh, function);
  compute_graph(result, options.unfold);
  simplify(result, options, options.simplify);
  const Page page = page_of(options, result, finest);

  BOOST_REQUIRE(page.stops.size() == hierarchy.number_of_levels());
  BOOST_TEST(page.number_of_levels == hierarchy.number_of_levels());
  check_curves(page, result);
  for (std::uint32_t stop = 0; stop < page.stops.size(); ++stop) {
    BOOST_TEST(page.stops[stop].level == stop);
    Result simplified;
    set_up(simplified, mesh, function);
    compute_graph(simplified, options.unfold);
    Options same = options;
    same.gap = 0;
    simplify(simplified, same, hierarchy.threshold(stop));
    check_stop(page, stop, simplified);
  }
  for (const Page::Pair& pair : page.pairs) {
    BOOST_TEST(pair.birth < page.nodes.size());
    BOOST_TEST(pair.death < page.nodes.size());
    BOOST_TEST(pair.persistence >= 0);
  }
  return page;
}

Page picture_of(const Index_mesh& mesh)
{
  Page page;
  page.points = mesh.points;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    page.vertices.push_back(v);
    page.values.push_back(mesh.points[v][0]);
    page.groups.push_back(v % 7);
  }
  for (const auto& t : mesh.triangles)
    page.triangles.push_back({static_cast<std::uint32_t>(t[0]),
                              static_cast<std::uint32_t>(t[1]),
                              static_cast<std::uint32_t>(t[2])});
  return page;
}

} // namespace

BOOST_AUTO_TEST_SUITE(levels)

BOOST_AUTO_TEST_CASE(random_meshes)
{
  const char* const number = std::getenv("REEB_GRAPH_TEST_CASES");
  const int number_of_cases = number == nullptr ? 150 : std::atoi(number);
  for (int seed = 0; seed < number_of_cases; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(static_cast<unsigned>(seed));
      const Index_mesh mesh = random_small_mesh(rng);
      const bool has_ties = seed % 3 == 0;
      std::vector<double> function;
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        function.push_back(has_ties ? static_cast<double>(random_index(5, rng)) : random_unit(rng));
      Options options;
      options.simplify = seed % 4 == 0 ? 0 : random_unit(rng);
      options.threshold_is_absolute = seed % 5 == 0;
      options.unfold = seed % 2 == 0;
      options.gap = seed % 7 == 0 ? 1 : 0;
      check_all_stops(mesh, function, options);
    }
  }
}

// Branches on branches, which are zipped.
BOOST_AUTO_TEST_CASE(noise)
{
  const Index_mesh mesh = torus(30, 16);
  std::mt19937 rng(5);
  std::vector<double> function;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    function.push_back(random_unit(rng));
  Options options;
  options.simplify = 0.1;
  const Page page = check_all_stops(mesh, function, options);
  BOOST_TEST(page.stops.size() > 100u);
  BOOST_TEST(!page.partings.empty()); // regions are divided
}

// Infinite values and empty meshes are drawn, too.
BOOST_AUTO_TEST_CASE(extreme_input)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Index_mesh mesh = sphere(1);
  std::vector<double> function(mesh.points.size(), 0);
  function[0] = infinity;
  function[1] = -infinity;
  function[2] = 1e308;
  function[3] = -1e308;
  check_all_stops(mesh, function, Options());
  check_all_stops(Index_mesh(), {}, Options());
  Index_mesh isolated;
  isolated.points = {{0, 0, 0}, {1, 0, 0}};
  check_all_stops(isolated, {1, 1}, Options());

  Result result;
  set_up(result, mesh, function);
  compute_graph(result, false);
  std::ostringstream out;
  write_page(out, page_of(Options(), result, finest_graph(result)));
  BOOST_TEST(out.str().size() > 1000u);
}

// Closed loops, and branches that the number of leaves cancels, belong to no level: the page has the
// simplified graph and its levels.
BOOST_AUTO_TEST_CASE(loops_and_leaves)
{
  const Index_mesh mesh = torus(24, 12);
  std::mt19937 rng(6);
  std::vector<double> function;
  for (const auto& p : mesh.points)
    function.push_back(p[0] + 0.8 * random_unit(rng));
  Options options;
  options.simplify = 0.05;
  options.close_loops = 10;
  Result result;
  set_up(result, mesh, function);
  compute_graph(result, false);
  SMRG::simplify_Reeb_graph(result.mesh,
                            result.values,
                            result.graph,
                            SMRG::parameters::vertex_arc_map(result.arcs)
                                .persistence_threshold(options.simplify)
                                .loop_persistence_threshold(options.close_loops));
  const Page page = page_of(options, result, finest_graph(result));
  BOOST_TEST(page.is_graph_simplified);
  BOOST_TEST(page.first_stop == 0u);
  check_curves(page, result);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(recorder)

// A branch of one arc hangs on a path of two. When it is cancelled, its vertices belong to the arc that
// the path becomes, and do not pull the polyline.
BOOST_AUTO_TEST_CASE(cancelled_branches_do_not_lie_along_the_arc)
{
  using Ends = std::vector<Graph_recorder::Ends>;
  const std::vector<std::uint32_t> path = {0, 2}, groups = {0, 1, 2};
  for (const bool is_upward : {false, true}) {
    const Ends ends = is_upward ? Ends{{0, 1}, {1, 2}, {1, 3}} : Ends{{0, 2}, {1, 2}, {2, 3}};
    Page page;
    page.nodes.resize(4, {0, 0, {0, 0, 0}, Page::none});
    Graph_recorder recorder(page);
    const auto first = recorder.add({{0, 1, 2, 3}, ends, groups});
    BOOST_REQUIRE(first.size() == 3u);
    for (std::size_t i = 0; i < 3; ++i)
      BOOST_TEST(first[i].groups == std::vector<std::uint32_t>(1, static_cast<std::uint32_t>(i)));
    auto next = recorder.add({{0, 3}, {{0, 3}}, {0, 0, 0}});
    BOOST_REQUIRE(next.size() == 1u);
    std::sort(next[0].groups.begin(), next[0].groups.end());
    BOOST_TEST(next[0].groups == path);
    for (std::size_t i = 0; i < 3; ++i) {
      BOOST_TEST(page.arcs[i].end == 1u);
      BOOST_TEST(page.arcs[i].heir == next[0].arc);
    }
    BOOST_TEST(page.nodes[0].end == Page::none);
    BOOST_TEST(page.nodes[1].end == 1u);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(picture)

BOOST_AUTO_TEST_CASE(clusters)
{
  const Index_mesh mesh = torus(200, 100);
  const Page original = picture_of(mesh);
  for (const std::size_t limit : {1, 50, 1000, 5000, 19999}) {
    BOOST_TEST_CONTEXT("limit " << limit)
    {
      Page page = original;
      cluster_vertices(page, limit);
      BOOST_TEST(page.is_decimated);
      BOOST_REQUIRE(page.points.size() <= limit);
      BOOST_TEST(page.points.size() >= limit / 4);
      BOOST_REQUIRE(page.vertices.size() == page.points.size());
      BOOST_REQUIRE(page.values.size() == page.points.size());
      BOOST_REQUIRE(page.groups.size() == page.points.size());
      for (std::size_t i = 0; i < page.points.size(); ++i) {
        const std::uint32_t v = page.vertices[i];
        BOOST_TEST((page.points[i] == original.points[v]));
        BOOST_TEST(page.values[i] == original.values[v]);
        BOOST_TEST(page.groups[i] == original.groups[v]);
      }
      BOOST_TEST((std::set<std::uint32_t>(page.vertices.begin(), page.vertices.end()).size() ==
                  page.vertices.size()));
      std::set<std::array<std::uint32_t, 3>> triangles;
      for (const auto& t : page.triangles) {
        BOOST_TEST((t[0] < t[1] && t[0] < t[2] && t[1] != t[2]));
        BOOST_TEST((std::max)(t[1], t[2]) < page.points.size());
        BOOST_TEST(triangles.insert(t).second);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(small_mesh_is_left)
{
  Page page = picture_of(sphere(2));
  const Page original = page;
  cluster_vertices(page, page.points.size());
  BOOST_TEST(!page.is_decimated);
  BOOST_TEST((page.points == original.points));
  BOOST_TEST((page.triangles == original.triangles));
}

BOOST_AUTO_TEST_CASE(points_in_one_place)
{
  Index_mesh mesh;
  mesh.points.assign(10, {1, 2, 3});
  Page page = picture_of(mesh);
  cluster_vertices(page, 5);
  BOOST_TEST(page.points.size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(global_locale_that_groups_digits)
{
  const Index_mesh mesh = torus(60, 40);
  std::vector<double> function;
  for (const auto& p : mesh.points)
    function.push_back(1e4 * p[0]);
  Result result;
  set_up(result, mesh, function);
  compute_graph(result, false);
  const auto text = [&]() {
    std::ostringstream out;
    write_page(out, page_of(Options(), result, finest_graph(result)));
    return out.str();
  };
  const std::string expected = text();
  const Grouping_locale grouping;
  BOOST_TEST((text() == expected));
}
