// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE compute_Reeb_graph

#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/isomorphism.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

using namespace Reeb_graph_test;

namespace {

using Face_map = Mesh::Property_map<Mesh::Face_index, std::size_t>;

// Everything that compute_Reeb_graph() gives, in a form that compares: nodes, ends of arcs, arcs of
// vertices and of faces.
using Everything = std::tuple<std::vector<std::size_t>,
                              std::vector<std::pair<std::size_t, std::size_t>>,
                              std::vector<std::size_t>,
                              std::vector<std::size_t>>;

template <class ConcurrencyTag>
Everything everything(Case& c, const SMRG::Reeb_graph_algorithm algorithm, const bool unfolds)
{
  Graph graph;
  Face_map face_arcs = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc").first;
  SMRG::compute_Reeb_graph<ConcurrencyTag>(c.mesh,
                                           c.values,
                                           graph,
                                           SMRG::parameters::vertex_arc_map(c.arcs)
                                               .face_arc_map(face_arcs)
                                               .unfold_multiple_saddles(unfolds)
                                               .algorithm(algorithm));
  Everything result;
  for (const auto node : CGAL::make_range(vertices(graph)))
    std::get<0>(result).push_back(graph[node].vertex);
  for (const auto arc : CGAL::make_range(edges(graph)))
    std::get<1>(result).emplace_back(source(arc, graph), target(arc, graph));
  for (const Vertex v : c.mesh.vertices())
    std::get<2>(result).push_back(c.arcs[v]);
  for (const auto f : c.mesh.faces())
    std::get<3>(result).push_back(face_arcs[f]);
  return result;
}

using Tag = CGAL::Parallel_if_available_tag;

// All algorithms give the same, down to the numbers of the arcs.
void check_algorithms(Case& c, const bool unfolds)
{
  const Everything sweep =
      everything<CGAL::Sequential_tag>(c, SMRG::Reeb_graph_algorithm::SWEEP, unfolds);
  const Everything cutting =
      everything<CGAL::Sequential_tag>(c, SMRG::Reeb_graph_algorithm::CUTTING, unfolds);
  BOOST_TEST((std::get<0>(sweep) == std::get<0>(cutting)));
  BOOST_TEST((std::get<1>(sweep) == std::get<1>(cutting)));
  BOOST_TEST((std::get<2>(sweep) == std::get<2>(cutting)));
  BOOST_TEST((std::get<3>(sweep) == std::get<3>(cutting)));
  BOOST_TEST((everything<Tag>(c, SMRG::Reeb_graph_algorithm::CUTTING, unfolds) == cutting));
}

Graph reeb_graph(Case& c)
{
  check_algorithms(c, true);
  check_algorithms(c, false);
  Graph graph;
  SMRG::compute_Reeb_graph(
      c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs).collect_arc_vertices(true));
  check_consistency(c, graph);
  return graph;
}

// The rank of every vertex in the library's order, which also orders equal values.
std::vector<std::size_t> rank_of(const Case& c)
{
  const auto indices = get(boost::vertex_index, c.mesh);
  const SMRG::Vertex_order<Mesh, Value_map, std::decay_t<decltype(indices)>> order(
      c.mesh, c.values, indices);
  std::vector<Vertex> sorted(c.mesh.vertices().begin(), c.mesh.vertices().end());
  std::sort(sorted.begin(), sorted.end(), order);
  std::vector<std::size_t> rank(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    rank[sorted[i]] = i;
  return rank;
}

std::size_t number_of_loops(const Graph& graph, const Index_mesh& mesh)
{
  return num_edges(graph) + number_of_components(mesh) - num_vertices(graph);
}

bool has_simple_saddles(const Graph& graph)
{
  for (const auto node : CGAL::make_range(vertices(graph)))
    if (graph[node].type == SMRG::Reeb_node_type::DEGENERATE)
      return false;
  return true;
}

template <class Function>
void for_random_cases(const Function& function)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const bool pinched = seed % 4 == 3;
      function(random_small_mesh(rng, pinched), rng);
    }
  }
}

std::vector<std::pair<std::size_t, std::size_t>> neighbors_of(const Index_mesh& mesh)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& e : edges_of(mesh)) {
    result.push_back(e);
    result.emplace_back(e.second, e.first);
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_brute_force_for_distinct_values)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    Case c(mesh, random_values(mesh.points.size(), rng));
    const Graph graph = reeb_graph(c);
    const Brute_force_Reeb_graph oracle = brute_force_Reeb_graph(mesh, rank_of(c));
    BOOST_TEST((comparable_arcs(graph) == comparable_arcs(oracle)));
    BOOST_REQUIRE(num_vertices(graph) == oracle.nodes.size());
    for (std::size_t i = 0; i < oracle.nodes.size(); ++i) {
      BOOST_TEST(std::size_t(graph[i].vertex) == oracle.nodes[i].vertex);
      BOOST_TEST(graph[i].type ==
                 SMRG::type_of_Reeb_node(oracle.nodes[i].down, oracle.nodes[i].up));
    }
  });
}

// A function with few values has large plateaus. With the ranks of the vertices in the place of the
// values nothing is tied, and the graph must be that of the oracle. From the tied values
// themselves, the pairs inside plateaus are cancelled: what is left are the extrema that the oracle
// pairs with a different value.
BOOST_AUTO_TEST_CASE(agrees_with_brute_force_for_tied_values)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    const std::size_t n = mesh.points.size();
    Case c(mesh, random_integer_values(n, 1 + random_index(6, rng), rng));
    const std::vector<std::size_t> rank = rank_of(c);

    Case ranked(mesh, std::vector<double>(rank.begin(), rank.end()));
    const Graph ranked_graph = reeb_graph(ranked);
    BOOST_TEST(
        (comparable_arcs(ranked_graph) == comparable_arcs(brute_force_Reeb_graph(mesh, rank))));

    const Graph graph = reeb_graph(c);
    BOOST_TEST(number_of_loops(graph, mesh) == number_of_loops(ranked_graph, mesh));
    for (const bool minima : {true, false}) {
      const Extremum_pairs pairs =
          brute_force_extremum_pairs(mesh, minima ? rank : reversed_rank(rank));
      std::vector<std::size_t> expected = pairs.unpaired_extrema;
      for (const Extremum_pair& pair : pairs.pairs)
        if (c.values[Vertex(pair.extremum)] != c.values[Vertex(pair.saddle)])
          expected.push_back(pair.extremum);
      std::sort(expected.begin(), expected.end());
      BOOST_TEST(extrema(graph, minima) == expected, boost::test_tools::per_element());
    }
  });
}

BOOST_AUTO_TEST_CASE(constant_function_has_one_minimum_and_one_maximum_per_component)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937&) {
    Case c(mesh, constant_values(mesh.points.size()));
    const Graph graph = reeb_graph(c);
    BOOST_TEST(extrema(graph, true).size() == number_of_components(mesh));
    BOOST_TEST(extrema(graph, false).size() == number_of_components(mesh));
  });

  Case c(sphere(3), constant_values(sphere(3).points.size()));
  const Graph graph = reeb_graph(c);
  BOOST_TEST(num_vertices(graph) == 2u);
  BOOST_TEST(num_edges(graph) == 1u);
}

// The order by value, then by the distance along the plateau, then by index, by its definition.
BOOST_AUTO_TEST_CASE(vertex_order_counts_plateaus_from_their_lower_borders)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    const std::size_t n = mesh.points.size();
    const std::vector<double> values = random_integer_values(n, 1 + random_index(4, rng), rng);
    const Case c(mesh, values);
    const auto neighbors = neighbors_of(mesh);

    // distances by relaxation until nothing changes
    const std::size_t infinity = n + 1;
    std::vector<std::size_t> distance(n, infinity);
    const auto relax = [&]() {
      for (bool changes = true; changes;) {
        changes = false;
        for (const auto& e : neighbors) {
          if (values[e.first] == values[e.second] && distance[e.first] + 1 < distance[e.second]) {
            distance[e.second] = distance[e.first] + 1;
            changes = true;
          }
        }
      }
    };
    std::vector<bool> is_tied(n, false);
    for (const auto& e : neighbors) {
      if (values[e.second] < values[e.first])
        distance[e.first] = 0;
      is_tied[e.first] = is_tied[e.first] || values[e.first] == values[e.second];
    }
    for (std::size_t v = 0; v < n; ++v)
      if (!is_tied[v])
        distance[v] = 0;
    relax();
    for (std::size_t v = 0; v < n; ++v) {
      if (distance[v] == infinity) {
        distance[v] = 0;
        relax();
      }
    }

    const std::vector<std::size_t> rank = rank_of(c);
    const auto key = [&](std::size_t v) { return std::make_tuple(values[v], distance[v], v); };
    for (std::size_t u = 0; u < n; ++u)
      for (std::size_t v = 0; v < n; ++v)
        BOOST_REQUIRE((rank[u] < rank[v]) == (key(u) < key(v)));
  });
}

BOOST_AUTO_TEST_CASE(reversed_function_turns_the_graph_upside_down)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    std::vector<double> values = random_values(mesh.points.size(), rng);
    Case c(mesh, values);
    std::vector<Comparable_arc> expected;
    for (const Comparable_arc& arc : comparable_arcs(reeb_graph(c)))
      expected.emplace_back(std::get<1>(arc), std::get<0>(arc), std::get<2>(arc));
    std::sort(expected.begin(), expected.end());
    for (double& value : values)
      value = -value;
    c.set(values);
    BOOST_TEST((comparable_arcs(reeb_graph(c)) == expected));
  });
}

// Renumbering and a monotone map of the values change nothing, not even the numbers of the arcs.
BOOST_AUTO_TEST_CASE(does_not_depend_on_numbering_and_scale)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    const std::size_t n = mesh.points.size();
    const std::vector<double> values = random_values(n, rng);
    Case c(mesh, values);
    const Graph graph = reeb_graph(c);

    const std::vector<std::size_t> new_number = random_permutation(n, rng);
    Index_mesh renumbered = mesh;
    std::vector<double> new_values(n);
    for (std::size_t v = 0; v < n; ++v) {
      renumbered.points[new_number[v]] = mesh.points[v];
      new_values[new_number[v]] = std::exp(3 * values[v]);
    }
    for (auto& triangle : renumbered.triangles)
      for (std::size_t& v : triangle)
        v = new_number[v];
    shuffle(renumbered.triangles, rng);
    Case other(renumbered, new_values);
    const Graph other_graph = reeb_graph(other);

    BOOST_REQUIRE(num_vertices(graph) == num_vertices(other_graph));
    BOOST_REQUIRE(num_edges(graph) == num_edges(other_graph));
    for (std::size_t i = 0; i < num_vertices(graph); ++i)
      BOOST_TEST(new_number[graph[i].vertex] == std::size_t(other_graph[i].vertex));
    for (const Vertex v : c.mesh.vertices())
      BOOST_TEST(c.arcs[v] == other.arcs[Vertex(static_cast<unsigned>(new_number[v]))]);
  });
}

// On larger closed surfaces whose saddles are all simple.
BOOST_AUTO_TEST_CASE(loops_equal_genus_and_nodes_the_Euler_characteristic)
{
  std::mt19937 rng(1);
  unsigned simple_cases = 0;
  for (std::size_t g = 0; g <= 5; ++g) {
    for (unsigned i = 0; i < 20; ++i) {
      const Index_mesh mesh = g == 0 ? sphere(3) : closed_surface(g, 6 + i % 5, 5 + i % 7);
      BOOST_REQUIRE(genus(mesh) == g);
      Case c(mesh, random_values(mesh.points.size(), rng));
      const Graph graph = reeb_graph(c);
      if (has_simple_saddles(graph)) {
        ++simple_cases;
        BOOST_TEST(number_of_loops(graph, mesh) == g);
      } else {
        BOOST_TEST(number_of_loops(graph, mesh) <= g);
      }
    }
  }
  BOOST_TEST(simple_cases > 0u);

  for (const double tilt : {0.1, 0.5, 0.9}) {
    const Index_mesh mesh = torus(40, 20);
    std::vector<double> height;
    for (const auto& p : mesh.points)
      height.push_back(p[0] + tilt * 0.3 * p[1] + 0.01 * tilt * p[2]);
    Case c(mesh, height);
    const Graph graph = reeb_graph(c);
    BOOST_TEST(num_vertices(graph) == 4u);
    BOOST_TEST(number_of_loops(graph, mesh) == 1u);
    BOOST_TEST(graph[0].type == SMRG::Reeb_node_type::MINIMUM);
    BOOST_TEST(graph[1].type == SMRG::Reeb_node_type::SPLIT_SADDLE);
    BOOST_TEST(graph[2].type == SMRG::Reeb_node_type::MERGE_SADDLE);
    BOOST_TEST(graph[3].type == SMRG::Reeb_node_type::MAXIMUM);
  }
}

// The arcs of vertices, which cutting spreads from neighbor to neighbor where the function is not mere
// noise, and which the sweep sees: on larger surfaces, with handles and borders, functions from smooth
// to noisy, with plateaus.
BOOST_AUTO_TEST_CASE(arcs_of_vertices_do_not_depend_on_the_algorithm)
{
  const unsigned number = number_of_random_cases() / 10;
  for (unsigned seed = 0; seed < number; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const std::size_t g = random_index(5, rng);
      Index_mesh mesh = g == 0 ? sphere(4) : closed_surface(g, 16 + seed % 9, 12 + seed % 7);
      for (std::size_t holes = seed % 3 == 0 ? random_index(6, rng) : 0; holes > 0; --holes) {
        const std::size_t v = mesh.triangles[random_index(mesh.triangles.size(), rng)][0];
        mesh.triangles.erase(std::remove_if(mesh.triangles.begin(),
                                            mesh.triangles.end(),
                                            [v](const std::array<std::size_t, 3>& t) {
                                              return std::count(t.begin(), t.end(), v) > 0;
                                            }),
                             mesh.triangles.end());
      }
      remove_isolated_vertices(mesh);
      if (!is_valid(mesh))
        continue; // a vertex between two holes
      const double noise = std::pow(10., -1 - 3 * random_unit(rng));
      const double a = random_unit(rng), b = random_unit(rng), step = seed % 4 == 0 ? 0.02 : 0;
      std::vector<double> values;
      for (const auto& p : mesh.points) {
        const double value =
            p[0] + a * p[1] + b * std::sin(3 * p[2]) + noise * (random_unit(rng) - 0.5);
        values.push_back(step > 0 ? std::round(value / step) : value);
      }
      Case c(mesh, values);
      check_algorithms(c, false);
      check_algorithms(c, true);
    }
  }
}

// With multiple saddles unfolded, for every function: distinct values, plateaus, constant.
BOOST_AUTO_TEST_CASE(loops_equal_genus_when_saddles_are_unfolded)
{
  std::mt19937 rng(2);
  unsigned folded_cases = 0;
  for (std::size_t g = 0; g <= 5; ++g) {
    for (unsigned i = 0; i < 30; ++i) {
      Index_mesh mesh = g == 0 ? sphere(2) : closed_surface(g, 4 + i % 5, 4 + i % 7);
      flip_random_edges(mesh, 3 * mesh.points.size(), rng);
      BOOST_REQUIRE(genus(mesh) == g);
      const std::size_t n = mesh.points.size();
      Case c(mesh,
             i % 3 == 0   ? random_values(n, rng)
             : i % 3 == 1 ? random_integer_values(n, 1 + i / 3, rng)
                          : constant_values(n));
      check_algorithms(c, true);
      Graph graph;
      SMRG::compute_Reeb_graph(
          c.mesh, c.values, graph, SMRG::parameters::unfold_multiple_saddles(true));
      BOOST_TEST(number_of_loops(graph, mesh) == g);
      if (i % 3 == 0)
        BOOST_TEST(has_simple_saddles(graph));
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph);
      folded_cases += number_of_loops(graph, mesh) < g;
    }
  }
  BOOST_TEST(folded_cases > 0u); // or there is nothing to unfold
}

// The nodes that a vertex is unfolded into are joined by arcs of no length: without these, the arcs
// between vertices are the same as before, but that a vertex at which a handle was hidden may be a
// node now, in the middle of an arc. Every node is a simple saddle.
BOOST_AUTO_TEST_CASE(unfolding_leaves_the_arcs_between_vertices)
{
  unsigned unfolded_cases = 0;
  for_random_cases([&](const Index_mesh& mesh, std::mt19937& rng) {
    Case c(mesh, random_values(mesh.points.size(), rng));
    Graph folded, unfolded;
    SMRG::compute_Reeb_graph(c.mesh, c.values, folded);
    SMRG::compute_Reeb_graph(
        c.mesh, c.values, unfolded, SMRG::parameters::unfold_multiple_saddles(true));
    using Vertex_pair = std::pair<std::size_t, std::size_t>;
    const auto arcs_between_vertices = [](const Graph& graph) {
      std::vector<Vertex_pair> result;
      for (const auto arc : CGAL::make_range(edges(graph)))
        result.emplace_back(graph[source(arc, graph)].vertex, graph[target(arc, graph)].vertex);
      std::sort(result.begin(), result.end());
      return result;
    };
    std::vector<bool> is_folded_node(mesh.points.size(), false);
    for (const auto node : CGAL::make_range(vertices(folded)))
      is_folded_node[folded[node].vertex] = true;
    std::vector<std::size_t> next(mesh.points.size(), mesh.points.size());
    std::vector<Vertex_pair> joined;
    for (const Vertex_pair& arc : arcs_between_vertices(unfolded)) {
      if (arc.first == arc.second)
        continue;
      if (is_folded_node[arc.first]) {
        joined.push_back(arc);
      } else {
        BOOST_TEST(next[arc.first] == mesh.points.size());
        next[arc.first] = arc.second;
      }
    }
    for (Vertex_pair& arc : joined)
      while (!is_folded_node[arc.second])
        arc.second = next.at(arc.second);
    std::sort(joined.begin(), joined.end());
    BOOST_TEST((joined == arcs_between_vertices(folded)));
    unfolded_cases += num_vertices(folded) < num_vertices(unfolded);
    if (is_closed(mesh))
      BOOST_TEST(has_simple_saddles(unfolded));
  });
  BOOST_TEST(unfolded_cases > 0u);
}

// A face belongs to an arc that its interior meets: among the arcs on a monotone way through its
// three vertices, from an arc that reaches to its lowest vertex to one that reaches from its
// highest.
BOOST_AUTO_TEST_CASE(faces_belong_to_arcs_that_they_meet)
{
  for_random_cases([](const Index_mesh& mesh, std::mt19937& rng) {
    Case c(mesh, random_values(mesh.points.size(), rng));
    Face_map face_arcs = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc").first;
    Graph graph;
    SMRG::compute_Reeb_graph(
        c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs).face_arc_map(face_arcs));
    std::vector<std::pair<double, double>> range_of_arc;
    std::vector<std::size_t> node_of_vertex(c.mesh.number_of_vertices(), num_vertices(graph));
    for (const auto arc : CGAL::make_range(edges(graph)))
      range_of_arc.emplace_back(graph[source(arc, graph)].value, graph[target(arc, graph)].value);
    for (const auto node : CGAL::make_range(vertices(graph)))
      node_of_vertex[graph[node].vertex] = node;
    for (const auto f : c.mesh.faces()) {
      std::vector<Vertex> corners;
      for (const Vertex v : c.mesh.vertices_around_face(c.mesh.halfedge(f)))
        corners.push_back(v);
      std::sort(corners.begin(), corners.end(), [&](Vertex u, Vertex v) {
        return c.values[u] < c.values[v];
      });
      const std::size_t arc = face_arcs[f];
      BOOST_REQUIRE(arc < num_edges(graph));
      const double middle = c.values[corners[1]];
      BOOST_TEST(range_of_arc[arc].first <= middle);
      BOOST_TEST(middle < range_of_arc[arc].second);
      // a regular vertex in the middle, or at the top and not above another node, settles it
      if (node_of_vertex[corners[1]] == num_vertices(graph))
        BOOST_TEST(arc == c.arcs[corners[1]]);
      else
        BOOST_TEST(range_of_arc[arc].first == middle);
      const std::size_t top = c.arcs[corners[2]];
      if (node_of_vertex[corners[2]] == num_vertices(graph) && range_of_arc[top].first <= middle)
        BOOST_TEST(arc == top);
    }
  });
}

// A budget of no steps is too little for a torus, but not for a sphere, where there is nothing to
// walk.
BOOST_AUTO_TEST_CASE(cutting_gives_up_when_its_budget_is_spent)
{
  using SMRG::internal::Arc_list;
  for (const bool is_torus : {false, true}) {
    std::mt19937 rng(3);
    const Index_mesh mesh = is_torus ? torus(12, 8) : sphere(2);
    Case c(mesh, random_values(mesh.points.size(), rng));
    const auto indices = get(boost::vertex_index, c.mesh);
    using VIM = std::decay_t<decltype(indices)>;
    using Order = SMRG::Vertex_order<Mesh, Value_map, VIM>;
    const Order order(c.mesh, c.values, indices);
    SMRG::internal::Vertex_classification states(c.mesh.number_of_vertices());
    std::vector<SMRG::internal::Monotone_neighbors<Mesh>> neighbors;
    states.classify<CGAL::Sequential_tag>(
        c.mesh, indices, [&](Vertex v) { return c.values[v]; }, &neighbors);
    const auto is_done = [&](std::size_t budget) {
      Arc_list<Mesh> result;
      return SMRG::internal::Cutting_algorithm<CGAL::Sequential_tag, Mesh, Order, VIM>(
                 c.mesh, order, indices, c.mesh.number_of_vertices(), states, neighbors, {})
          .run(budget, result);
    };
    BOOST_TEST(is_done(0) == !is_torus);
    BOOST_TEST(is_done(1000000));
  }
}

// Two closed surfaces that share a vertex, which leads to the faces of one of them only: an error
// if that changes anything, wherever the vertex lies.
BOOST_AUTO_TEST_CASE(several_fans_never_give_a_wrong_graph)
{
  unsigned errors = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Index_mesh mesh = closed_surface(1 + seed % 2, 4, 4);
      const std::size_t n = mesh.points.size();
      append(mesh, sphere(seed % 3), 10);
      Case c(mesh, random_values(mesh.points.size(), rng));
      std::vector<Mesh::Halfedge_index> star;
      for (const auto h :
           c.mesh.halfedges_around_target(c.mesh.halfedge(Vertex(static_cast<Mesh::size_type>(n)))))
        star.push_back(h);
      for (const auto h : star)
        c.mesh.set_target(h, Vertex(0));
      c.mesh.set_halfedge(Vertex(static_cast<Mesh::size_type>(n)), Mesh::null_halfedge());
      for (auto& triangle : mesh.triangles)
        for (std::size_t& v : triangle)
          v = v == n ? 0 : v;
      const Brute_force_Reeb_graph oracle = brute_force_Reeb_graph(mesh, rank_of(c));
      for (const auto algorithm :
           {SMRG::Reeb_graph_algorithm::CUTTING, SMRG::Reeb_graph_algorithm::SWEEP})
      {
        Graph graph;
        try {
          SMRG::compute_Reeb_graph(c.mesh, c.values, graph, CGAL::parameters::algorithm(algorithm));
        } catch (const SMRG::Input_error&) {
          ++errors;
          continue;
        }
        BOOST_TEST(num_edges(graph) == oracle.arcs.size());
        BOOST_REQUIRE(num_vertices(graph) == oracle.nodes.size());
        for (std::size_t i = 0; i < oracle.nodes.size(); ++i)
          BOOST_TEST(std::size_t(graph[i].vertex) == oracle.nodes[i].vertex);
      }
    }
  }
  BOOST_TEST(errors > 0u);
}

BOOST_AUTO_TEST_CASE(borders_are_open_level_sets)
{
  // along its axis a cylinder is one arc; across, the level sets are two segments in the middle
  const Index_mesh mesh = cylinder(24, 7);
  std::vector<double> along, across;
  for (const auto& p : mesh.points) {
    along.push_back(p[2] + 1e-3 * p[0]);
    across.push_back(p[0] + 1e-3 * p[1] + 1e-6 * p[2]);
  }
  Case c(mesh, along);
  BOOST_TEST(extrema(reeb_graph(c), true).size() == 1u);
  BOOST_TEST(number_of_loops(reeb_graph(c), mesh) == 0u);
  c.set(across);
  BOOST_TEST(number_of_loops(reeb_graph(c), mesh) == 1u);
}

BOOST_AUTO_TEST_CASE(infinite_values_are_ordered_as_such)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for_random_cases([infinity](const Index_mesh& mesh, std::mt19937& rng) {
    const std::size_t n = mesh.points.size();
    std::vector<double> values = random_integer_values(n, 7, rng);
    Case finite(mesh, values);
    for (double& value : values)
      value = value == 0 ? -infinity : value == 6 ? infinity : value;
    Case infinite(mesh, values);
    BOOST_TEST((comparable_arcs(reeb_graph(finite)) == comparable_arcs(reeb_graph(infinite))));
  });
}

BOOST_AUTO_TEST_CASE(empty_mesh_gives_an_empty_graph)
{
  Case c(Index_mesh(), {});
  BOOST_TEST(num_vertices(reeb_graph(c)) == 0u);

  Index_mesh points;
  points.points.resize(3);
  Case isolated(points, {1, 0, 2});
  const Graph graph = reeb_graph(isolated);
  BOOST_TEST(num_vertices(graph) == 3u);
  BOOST_TEST(num_edges(graph) == 0u);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(graph[i].type == SMRG::Reeb_node_type::ISOLATED);
}

// Two vertices that are neighbors of all others, with a great many wedges each: nothing may take
// the square of that.
BOOST_AUTO_TEST_CASE(vertices_of_large_degree)
{
  for (const bool is_closed : {true, false}) {
    const std::size_t n = 30000; // to make the mesh takes longer than all the rest
    Index_mesh mesh;
    for (std::size_t i = 0; i < n; ++i)
      mesh.points.push_back({double(i), 0, 0});
    mesh.points.push_back({0, 1, 0});
    mesh.points.push_back({0, 0, 1});
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i) {
      mesh.triangles.push_back({i, (i + 1) % n, n});
      mesh.triangles.push_back({(i + 1) % n, i, n + 1});
    }
    std::mt19937 rng(4);
    std::vector<double> values = random_values(n + 2, rng);
    values[n] = 0.5;
    values[n + 1] = 0.51;
    Case c(mesh, values);
    for (const bool unfolds : {false, true})
      check_algorithms(c, unfolds);
  }
}

BOOST_AUTO_TEST_CASE(nan_is_an_error_that_names_the_vertex)
{
  std::mt19937 rng(5);
  Case c(sphere(1), random_values(42, rng));
  Graph graph = reeb_graph(c);
  const std::size_t nodes = num_vertices(graph);
  const std::size_t arc_of_3 = c.arcs[Vertex(3)];
  c.values[Vertex(17)] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EXCEPTION(
      SMRG::compute_Reeb_graph(c.mesh, c.values, graph, SMRG::parameters::vertex_arc_map(c.arcs)),
      SMRG::Error,
      [](const SMRG::Error& error) {
        return std::string(error.what()).find("vertex 17 ") != std::string::npos;
      });
  BOOST_TEST(num_vertices(graph) == nodes);
  BOOST_TEST(c.arcs[Vertex(3)] == arc_of_3);
}

BOOST_AUTO_TEST_CASE(a_map_that_is_too_small_is_an_error_that_names_it)
{
  std::mt19937 rng(6);
  const Index_mesh mesh = sphere(3);
  Case c(mesh, random_values(mesh.points.size(), rng));
  Graph graph;
  auto vertex_arcs = c.mesh.add_property_map<Vertex, signed char>("v:small", 5).first;
  auto face_arcs = c.mesh.add_property_map<Mesh::Face_index, signed char>("f:small", 5).first;
  const auto check = [&](const auto& np, const std::string& name) {
    BOOST_CHECK_EXCEPTION(SMRG::compute_Reeb_graph(c.mesh, c.values, graph, np),
                          SMRG::Error,
                          [&](const SMRG::Error& error) {
                            return std::string(error.what()).find(name) != std::string::npos;
                          });
  };
  check(SMRG::parameters::vertex_arc_map(vertex_arcs), "vertex arc map");
  check(SMRG::parameters::face_arc_map(face_arcs), "face arc map");
  BOOST_TEST(num_vertices(graph) == 0u);
  BOOST_TEST(int(vertex_arcs[Vertex(0)]) == 5);
  BOOST_TEST(int(face_arcs[Mesh::Face_index(0)]) == 5);
}

// Boost's algorithms must find Boost's functions for the graph, not those of CGAL's meshes.
BOOST_AUTO_TEST_CASE(the_graph_is_a_boost_graph)
{
  std::mt19937 rng(7);
  const Index_mesh mesh = closed_surface(2, 4, 4);
  Case c(mesh, random_values(mesh.points.size(), rng));
  const Graph graph = reeb_graph(c);
  BOOST_TEST(boost::isomorphism(graph, graph));
  std::vector<int> component(num_vertices(graph));
  BOOST_TEST(boost::connected_components(graph, component.data()) == 1);
}
