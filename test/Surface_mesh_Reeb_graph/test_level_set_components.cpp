// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE level_set_components

#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/property_map.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Halfedge = Mesh::Halfedge_index;
using Component = SMRG::Level_set_component<Mesh>;
using Components = SMRG::Level_set_components<Mesh, Value_map>;

const double infinity = std::numeric_limits<double>::infinity();

std::vector<Component> below(const Components& components, const Vertex v)
{
  std::vector<Component> result;
  components.below(v, std::back_inserter(result));
  return result;
}

std::vector<Component> above(const Components& components, const Vertex v)
{
  std::vector<Component> result;
  components.above(v, std::back_inserter(result));
  return result;
}

std::vector<std::size_t> ranks_of(const Case& c)
{
  std::vector<std::size_t> rank(c.mesh.num_vertices());
  SMRG::vertex_ranks(c.mesh, c.values, CGAL::make_property_map(rank));
  return rank;
}

void set_random_points(Case& c, std::mt19937& rng)
{
  for (const Vertex v : c.mesh.vertices())
    c.mesh.point(v) = Point(random_unit(rng), random_unit(rng), random_unit(rng));
}

// Values without ties, with many ties, and, if wanted, with infinite ones.
std::vector<double> values_for_seed(const unsigned seed, const std::size_t n, std::mt19937& rng)
{
  if (seed % 3 == 0)
    return random_values(n, rng);
  std::vector<double> values = random_integer_values(n, 1 + random_index(9, rng), rng);
  if (seed % 3 == 1)
    for (double& value : values)
      value = value == 0 ? -infinity : value == 5 ? infinity : value;
  return values;
}

template <class Function>
void for_random_cases(const Function& function)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
      Case c(mesh, values_for_seed(seed, mesh.points.size(), rng));
      set_random_points(c, rng);
      function(c);
    }
  }
}

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

// ---------------------------------------------------------------------------------------------
// Polylines

// Where a point lies on an edge: 0 at the source, 1 at the target; the point must lie on its line.
double position_on_edge(const Mesh& mesh, const Halfedge h, const Point& p)
{
  const Point a = mesh.point(source(h, mesh)), b = mesh.point(target(h, mesh));
  const double t = ((p - a) * (b - a)) / ((b - a) * (b - a));
  BOOST_REQUIRE(CGAL::squared_distance(p, a + t * (b - a)) < 1e-24);
  return t;
}

std::vector<double> positions(const Case& c, const Components& components, const Component& curve)
{
  const std::vector<Point> points = components.polyline(curve);
  BOOST_REQUIRE(points.size() == curve.halfedges.size() + (curve.is_closed ? 1 : 0));
  if (curve.is_closed)
    BOOST_TEST((points.front() == points.back()));
  std::vector<double> result;
  for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
    const double t = position_on_edge(c.mesh, curve.halfedges[i], points[i]);
    BOOST_REQUIRE((0 < t && t < 1));
    result.push_back(t);
  }
  return result;
}

// The curve with values strictly between the ends of its edges, or tied ones.
void check_values_on_curve(const Case& c, const Component& curve, const std::vector<double>& t)
{
  double lower = -infinity, upper = infinity;
  for (const Halfedge h : curve.halfedges) {
    lower = (std::max)(lower, c.values[source(h, c.mesh)]);
    upper = (std::min)(upper, c.values[target(h, c.mesh)]);
  }
  BOOST_REQUIRE(lower <= upper);
  if (lower == upper || std::isinf(lower) || std::isinf(upper))
    return;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double a = c.values[source(curve.halfedges[i], c.mesh)];
    const double b = c.values[target(curve.halfedges[i], c.mesh)];
    if (!std::isinf(a) && !std::isinf(b))
      BOOST_TEST(std::abs((1 - t[i]) * a + t[i] * b - (lower + upper) / 2) < 1e-12);
  }
}

bool is_circle_at_height(const std::vector<Point>& points, const double z, const double tolerance)
{
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return std::abs(p.z() - z) < 1e-14 &&
           std::abs(p.x() * p.x() + p.y() * p.y() + z * z - 1) < tolerance;
  });
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

std::vector<double> heights(const Index_mesh& mesh, const std::array<double, 3>& direction)
{
  std::vector<double> result;
  for (const auto& p : mesh.points)
    result.push_back(p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2]);
  return result;
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

// ---------------------------------------------------------------------------------------------
// Polylines

// All curves of all vertices have one value, if there are no ties, and cross an edge in the order
// of their levels; two points on an edge are the same only if the curves have the same edges.
BOOST_AUTO_TEST_CASE(polylines_have_one_value_and_do_not_meet)
{
  struct Crossing
  {
    std::size_t level;
    double position;
    std::size_t curve;
  };

  for_random_cases([](const Case& c) {
    const std::vector<std::size_t> rank = ranks_of(c);
    const Components components(c.mesh, c.values);
    std::vector<std::vector<Halfedge>> curves; // sorted
    std::vector<std::vector<Crossing>> crossings(c.mesh.num_halfedges());
    for (const Vertex v : c.mesh.vertices()) {
      for (const bool is_below : {true, false}) {
        for (const Component& curve : is_below ? below(components, v) : above(components, v)) {
          const std::vector<double> t = positions(c, components, curve);
          check_values_on_curve(c, curve, t);
          for (std::size_t i = 0; i < t.size(); ++i)
            crossings[curve.halfedges[i]].push_back(
                {rank[v] + (is_below ? 0 : 1), t[i], curves.size()});
          curves.push_back(curve.halfedges);
          std::sort(curves.back().begin(), curves.back().end());
        }
      }
    }
    for (std::vector<Crossing>& on_edge : crossings) {
      std::sort(on_edge.begin(), on_edge.end(), [](const Crossing& a, const Crossing& b) {
        return a.level < b.level;
      });
      for (std::size_t i = 1; i < on_edge.size(); ++i) {
        const Crossing &a = on_edge[i - 1], &b = on_edge[i];
        if (curves[a.curve] == curves[b.curve])
          BOOST_TEST(std::abs(a.position - b.position) < 1e-14);
        else
          BOOST_TEST(a.position < b.position - 1e-8);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(level_sets_of_the_height_on_a_sphere_are_circles)
{
  const Index_mesh mesh = sphere(4);
  const Case c(mesh, heights(mesh, {0, 0, 1}));
  const Components components(c.mesh, c.values);
  unsigned number_of_circles = 0;
  for (const Vertex v : c.mesh.vertices()) {
    for (const Component& curve : above(components, v)) {
      double lower = -1, upper = 1;
      for (const Halfedge h : curve.halfedges) {
        lower = (std::max)(lower, c.values[c.mesh.source(h)]);
        upper = (std::min)(upper, c.values[c.mesh.target(h)]);
      }
      if (lower < upper && std::abs(lower) < 0.9) {
        ++number_of_circles;
        BOOST_TEST(curve.is_closed);
        BOOST_TEST(is_circle_at_height(components.polyline(curve), (lower + upper) / 2, 0.02));
      }
    }
  }
  BOOST_TEST(number_of_circles > 300u);
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
// Types of meshes, maps and values

template <class TriangleMesh>
using Vertex_of = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

// A component by the numbers of the vertices of its edges.
using Plain_component = std::pair<std::vector<std::array<std::size_t, 2>>, bool>;

template <class TriangleMesh, class Number>
std::vector<Plain_component> plain(const TriangleMesh& mesh,
                                   const std::vector<SMRG::Level_set_component<TriangleMesh>>& list,
                                   const Number& number)
{
  std::vector<Plain_component> result;
  for (const auto& component : list) {
    result.emplace_back();
    result.back().second = component.is_closed;
    for (const auto h : component.halfedges)
      result.back().first.push_back({number(source(h, mesh)), number(target(h, mesh))});
  }
  return result;
}

// The components of all vertices, in the order of `vertices`, and their polylines.
template <class Objects, class TriangleMesh, class Vertices, class Number>
std::vector<std::vector<Plain_component>> all_components(const Objects& objects,
                                                         const TriangleMesh& mesh,
                                                         const Vertices& vertices,
                                                         const Number& number)
{
  std::vector<std::vector<Plain_component>> result;
  for (const auto v : vertices) {
    std::vector<SMRG::Level_set_component<TriangleMesh>> found;
    objects.below(v, std::back_inserter(found));
    result.push_back(plain(mesh, found, number));
    found.clear();
    objects.above(v, std::back_inserter(found));
    result.push_back(plain(mesh, found, number));
  }
  return result;
}

std::vector<std::vector<Plain_component>> all_components(const Case& c)
{
  return all_components(Components(c.mesh, c.values),
                        c.mesh,
                        c.mesh.vertices(),
                        [](const Vertex v) -> std::size_t { return v; });
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Polyhedron = CGAL::Polyhedron_3<Exact>;
  using Key = Vertex_of<Polyhedron>;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 rng(seed);
    const Index_mesh mesh = random_small_mesh(rng);
    const std::size_t n = mesh.points.size();
    const std::vector<double> values =
        seed % 2 == 0 ? random_values(n, rng) : random_integer_values(n, 4, rng);
    const Case c(mesh, values);

    Polyhedron polyhedron;
    std::vector<Key> vertices;
    make_mesh(mesh, polyhedron, vertices);
    std::map<Key, double> map;
    std::map<Key, std::size_t> index;
    std::map<Key, Exact::Point_3> point;
    for (std::size_t i = 0; i < n; ++i) {
      map[vertices[i]] = values[i];
      index[vertices[i]] = i;
      point[vertices[i]] = Exact::Point_3(random_unit(rng), random_unit(rng), random_unit(rng));
    }
    const auto value_map = boost::make_assoc_property_map(map);
    const auto point_map = boost::make_assoc_property_map(point);
    const SMRG::Level_set_components components(
        polyhedron,
        value_map,
        CGAL::parameters::vertex_index_map(boost::make_assoc_property_map(index)));
    BOOST_TEST((all_components(components, polyhedron, vertices, [&](Key v) {
                  return index.at(v);
                }) == all_components(c)));

    const SMRG::Level_set_components with_own_indices(polyhedron, value_map);
    std::vector<SMRG::Level_set_component<Polyhedron>> curves;
    with_own_indices.above(vertices[0], std::back_inserter(curves));
    with_own_indices.below(vertices[0], std::back_inserter(curves));
    for (const auto& curve : curves) {
      const auto points =
          with_own_indices.polyline(curve, CGAL::parameters::vertex_point_map(point_map));
      for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
        const auto h = curve.halfedges[i];
        BOOST_TEST((CGAL::collinear_are_strictly_ordered_along_line(
            point[source(h, polyhedron)], points[i], point[target(h, polyhedron)])));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(face_filtered_graph)
{
  // two pieces with borders, and a few pinched vertices
  const Index_mesh whole = torus(16, 8);
  std::mt19937 rng(4);
  const std::vector<double> values = random_values(whole.points.size(), rng);
  const Case c(whole, values);
  Mesh mesh = c.mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  Index_mesh part;
  part.points = whole.points; // the others become isolated vertices
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    if (i % 16 < 11 && i / 32 != 3 && i % 37 != 0) {
      patch[Mesh::Face_index(static_cast<unsigned>(i))] = 1;
      part.triangles.push_back(whole.triangles[i]);
    }
  }
  BOOST_REQUIRE(is_valid(part, true));
  const Case expected(part, values);

  using Filtered = CGAL::Face_filtered_graph<Mesh>;
  const Filtered filtered(mesh, std::size_t(1), patch);
  const SMRG::Level_set_components components(filtered, c.values);
  const Components expected_components(expected.mesh, expected.values);
  std::size_t number_of_curves = 0;
  for (const Vertex v : CGAL::make_range(vertices(filtered))) {
    for (const bool is_below : {true, false}) {
      std::vector<SMRG::Level_set_component<Filtered>> found;
      if (is_below)
        components.below(v, std::back_inserter(found));
      else
        components.above(v, std::back_inserter(found));
      const auto number = [](const Vertex u) -> std::size_t { return u; };
      BOOST_TEST((plain(filtered, found, number) ==
                  plain(expected.mesh,
                        is_below ? below(expected_components, v) : above(expected_components, v),
                        number)));
      number_of_curves += found.size();
      for (const auto& curve : found)
        BOOST_TEST(components.polyline(curve).size() >= curve.halfedges.size());
    }
  }
  BOOST_TEST(number_of_curves > 100u);
}

BOOST_AUTO_TEST_CASE(removed_elements)
{
  std::mt19937 rng(6);
  Case c(sphere(2), random_values(sphere(2).points.size(), rng));
  CGAL::Euler::remove_center_vertex(c.mesh.halfedge(Vertex(0)), c.mesh);
  CGAL::Euler::remove_face(c.mesh.halfedge(*c.mesh.faces().begin()), c.mesh);
  // the hole of the removed vertex is no triangle
  for (const auto f : c.mesh.faces()) {
    if (c.mesh.degree(f) != 3) {
      CGAL::Euler::remove_face(c.mesh.halfedge(f), c.mesh);
      break;
    }
  }
  BOOST_REQUIRE(c.mesh.has_garbage());
  BOOST_REQUIRE(CGAL::is_triangle_mesh(c.mesh));
  const Components components(c.mesh, c.values);
  std::size_t open = 0, closed = 0;
  for (const Vertex v : c.mesh.vertices())
    for (const Component& curve : above(components, v))
      ++(curve.is_closed ? closed : open);
  BOOST_TEST(open > 0u);
  BOOST_TEST(closed > 0u);
}

// Values at the ends of what their type can represent.
template <class Number>
void check_extreme_values(const std::vector<Number>& choice)
{
  using Values = std::map<Vertex, Number>;
  for (unsigned seed = 0; seed < 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh mesh = random_small_mesh(rng);
      const std::size_t n = mesh.points.size();
      Case c(mesh, std::vector<double>(n, 0));
      set_random_points(c, rng);
      Values values;
      for (const Vertex v : c.mesh.vertices())
        values[v] = choice[random_index(choice.size(), rng)];
      const SMRG::Level_set_components components(c.mesh, boost::make_assoc_property_map(values));
      for (const Vertex v : c.mesh.vertices()) {
        std::vector<Component> curves;
        components.above(v, std::back_inserter(curves));
        for (const Component& curve : curves) {
          const std::vector<Point> points = components.polyline(curve);
          for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
            const double t = position_on_edge(c.mesh, curve.halfedges[i], points[i]);
            BOOST_TEST((-1e-12 < t && t < 1 + 1e-12)); // false for a point that is no point
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(extreme_values)
{
  using Double = std::numeric_limits<double>;
  check_extreme_values<double>(
      {Double::lowest(), Double::max(), 0, Double::denorm_min(), -Double::denorm_min(), 1});
  check_extreme_values<double>({-infinity, infinity});
  check_extreme_values<double>({-infinity, infinity, Double::max(), 1, std::nextafter(1., 2.)});
  using Float = std::numeric_limits<float>;
  check_extreme_values<float>({Float::lowest(), Float::max(), 0.f, Float::infinity()});
  using Long = std::numeric_limits<std::int64_t>;
  check_extreme_values<std::int64_t>({Long::lowest(), Long::max(), 0, 1, -1});
  check_extreme_values<unsigned>({0u, 1u, std::numeric_limits<unsigned>::max()});
  check_extreme_values<bool>({false, true});
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  check_extreme_values<Exact>({Exact(1) / 3, Exact(1) / 7, Exact(0), Exact(-5)});
}

// Differences that `double` cannot represent.
BOOST_AUTO_TEST_CASE(large_whole_values)
{
  const Index_mesh mesh = torus(8, 6);
  std::mt19937 rng(14);
  const std::vector<std::size_t> ranks = random_permutation(mesh.points.size(), rng);
  const Case c(mesh, std::vector<double>(ranks.begin(), ranks.end()));
  std::map<Vertex, std::int64_t> large;
  for (const Vertex v : c.mesh.vertices())
    large[v] = (std::int64_t(1) << 60) + static_cast<std::int64_t>(ranks[v]);
  const Components expected(c.mesh, c.values);
  const SMRG::Level_set_components components(c.mesh, boost::make_assoc_property_map(large));
  for (const Vertex v : c.mesh.vertices())
    for (const Component& curve : above(expected, v))
      BOOST_TEST((components.polyline(curve) == expected.polyline(curve)));
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
