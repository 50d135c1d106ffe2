// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that are none, and inconsistencies that no mesh is to blame for.

#define BOOST_TEST_MODULE invalid_meshes

#include "check_Reeb_graph.h"

#include <CGAL/Surface_mesh_Reeb_graph/Level_set_components.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <CGAL/exceptions.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Halfedge = Mesh::Halfedge_index;
using Order = SMRG::Vertex_order<Mesh, Value_map, CGAL::SM_index_pmap<Mesh::Point, Vertex>>;

auto says(const std::string& text)
{
  return [text](const std::exception& error) {
    return std::string(error.what()).find(text) != std::string::npos;
  };
}

Case random_torus(const unsigned seed)
{
  std::mt19937 rng(seed);
  const Index_mesh mesh = torus(12, 8);
  return Case(mesh, random_values(mesh.points.size(), rng));
}

// Two spheres that share the vertex 3.
void glue(Case& c, const std::size_t size_of_first)
{
  const Vertex kept(3), gone(static_cast<Mesh::size_type>(size_of_first));
  std::vector<Halfedge> star;
  for (const Halfedge h : CGAL::halfedges_around_target(gone, c.mesh))
    star.push_back(h);
  for (const Halfedge h : star)
    c.mesh.set_target(h, kept);
  c.mesh.set_halfedge(gone, Mesh::null_halfedge());
  c.mesh.remove_vertex(gone);
}

Case glued_spheres()
{
  Index_mesh mesh = sphere(1);
  const std::size_t size = mesh.points.size();
  append(mesh, sphere(1), 10);
  std::mt19937 rng(1);
  Case result(mesh, random_values(mesh.points.size(), rng));
  glue(result, size);
  return result;
}

// Whether the circulation around every vertex comes to its end.
bool circulations_end(const Mesh& mesh)
{
  for (const Vertex v : mesh.vertices()) {
    const Halfedge first = mesh.halfedge(v);
    Halfedge h = first;
    std::size_t steps = 0;
    do {
      h = mesh.opposite(mesh.next(h));
      if (++steps > mesh.num_halfedges())
        return false;
    } while (h != first);
  }
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(an_internal_error_does_not_blame_a_valid_mesh)
{
  const auto fail = []() { SMRG::internal::throw_internal_error("nothing fits"); };
  const auto indices = [](const Case& c) { return get(boost::vertex_index, c.mesh); };
  const Case valid = random_torus(1);
  BOOST_CHECK_EXCEPTION(
      SMRG::internal::check_mesh_on_internal_error(valid.mesh, indices(valid), fail),
      SMRG::Internal_error,
      says("internal error: nothing fits; please report"));
  const Case invalid = glued_spheres();
  BOOST_CHECK_EXCEPTION(
      SMRG::internal::check_mesh_on_internal_error(invalid.mesh, indices(invalid), fail),
      SMRG::Input_error,
      says("several fans (vertex 3)"));
}

// A classification that is not that of the function: the edges of its extrema do not fit.
BOOST_AUTO_TEST_CASE(the_classification_of_another_function_is_an_internal_error)
{
  Case c = random_torus(2);
  const Case other = random_torus(3);
  const auto indices = get(boost::vertex_index, c.mesh);
  SMRG::internal::Vertex_classification states(c.mesh.number_of_vertices());
  std::vector<SMRG::internal::Monotone_neighbors<Mesh>> neighbors;
  states.classify<CGAL::Sequential_tag>(
      c.mesh, indices, [&](Vertex v) { return other.values[v]; }, &neighbors);
  const Order order(c.mesh, c.values, indices);
  const auto compute = [&]() {
    SMRG::internal::compute_arc_list<CGAL::Sequential_tag>(
        c.mesh, order, indices, states, neighbors, {});
  };
  BOOST_CHECK_EXCEPTION(SMRG::internal::check_mesh_on_internal_error(c.mesh, indices, compute),
                        SMRG::Internal_error,
                        says("internal error"));
}

// A join and a split tree of different graphs: two minima that never meet, and maxima that do.
BOOST_AUTO_TEST_CASE(trees_that_do_not_fit_are_an_internal_error)
{
  SMRG::internal::Merge_forest join_tree, split_tree;
  join_tree.clear(3);
  split_tree.clear(3);
  join_tree.attach(0, 1);
  split_tree.attach(2, 1);
  SMRG::internal::Contour_forest forest(join_tree, split_tree);
  BOOST_CHECK_THROW(forest.run({0, 1, 2}, [](std::uint32_t) { return false; }),
                    SMRG::Internal_error);
}

BOOST_AUTO_TEST_CASE(the_vertex_with_several_fans_is_named)
{
  Case c = glued_spheres();
  Graph graph;
  BOOST_CHECK_EXCEPTION(
      SMRG::compute_Reeb_graph(
          c.mesh, c.values, graph, CGAL::parameters::algorithm(SMRG::Reeb_graph_algorithm::SWEEP)),
      SMRG::Input_error,
      says("several fans (vertex 3)"));
  BOOST_CHECK_EXCEPTION((SMRG::Level_set_components<Mesh, Value_map>(c.mesh, c.values)),
                        SMRG::Input_error,
                        says("several fans (vertex 3)"));
  BOOST_TEST(num_vertices(graph) == 0u);
}

// A halfedge has the wrong successor, so that circulations do not come back to where they began:
// an error, in which the mesh is blamed, and not a walk without end.
BOOST_AUTO_TEST_CASE(circulations_without_end_are_an_error)
{
  unsigned number_of_errors = 0, number_of_endless_circulations = 0;
  for (unsigned seed = 0; seed < number_of_random_cases() / 4; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh index_mesh = closed_surface(seed % 3, 5, 4);
      const std::size_t n = index_mesh.points.size();
      Case c(index_mesh, seed % 2 == 0 ? random_values(n, rng) : random_integer_values(n, 3, rng));
      // the successor of another halfedge that points to the same vertex
      const Vertex v(static_cast<Mesh::size_type>(random_index(n, rng)));
      std::vector<Halfedge> star;
      for (const Halfedge h : CGAL::halfedges_around_target(v, c.mesh))
        star.push_back(h);
      const std::size_t i = random_index(star.size(), rng), j = random_index(star.size(), rng);
      if (i == j)
        continue;
      c.mesh.set_next_only(star[i], c.mesh.next(star[j]));
      number_of_endless_circulations += circulations_end(c.mesh) ? 0 : 1;
      for (const auto algorithm :
           {SMRG::Reeb_graph_algorithm::CUTTING, SMRG::Reeb_graph_algorithm::SWEEP})
      {
        Graph graph;
        try {
          SMRG::compute_Reeb_graph(c.mesh, c.values, graph, CGAL::parameters::algorithm(algorithm));
        } catch (const SMRG::Input_error&) {
          ++number_of_errors;
        } catch (const CGAL::Assertion_exception&) { // may see it first
          ++number_of_errors;
        }
      }
    }
  }
  BOOST_TEST(number_of_endless_circulations > 0u);
  BOOST_TEST(number_of_errors > 0u);
}

// A plateau is searched before anything else is done.
BOOST_AUTO_TEST_CASE(plateaus_are_searched_to_an_end)
{
  const Index_mesh index_mesh = sphere(1);
  Case c(index_mesh, std::vector<double>(index_mesh.points.size(), 1.));
  // 0, 1, 2, 1, 2, ...
  std::vector<Halfedge> star;
  for (const Halfedge h : CGAL::halfedges_around_target(Vertex(0), c.mesh))
    star.push_back(h);
  c.mesh.set_next_only(star[2], c.mesh.next(star[0]));
  BOOST_REQUIRE(!circulations_end(c.mesh));
  Graph graph;
  BOOST_CHECK_THROW(SMRG::compute_Reeb_graph(c.mesh, c.values, graph), SMRG::Input_error);
}

// Any reference of the structure may be wrong, one or several: nothing circles for ever or reads
// what is not there, and an error blames the mesh.
BOOST_AUTO_TEST_CASE(damaged_halfedge_structures_are_an_error)
{
  unsigned number_of_errors = 0;
  for (unsigned seed = 0; seed < 5 * number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const Index_mesh index_mesh = closed_surface(seed % 3, 5, 4);
      const std::size_t n = index_mesh.points.size();
      Case c(index_mesh, seed % 2 == 0 ? random_values(n, rng) : random_integer_values(n, 7, rng));
      const auto random_number = [&](std::size_t size) {
        return static_cast<Mesh::size_type>(random_index(size, rng));
      };
      for (std::size_t i = 0; i < 1 + seed % 3; ++i) {
        const Halfedge h(random_number(c.mesh.number_of_halfedges())),
            other(random_number(c.mesh.number_of_halfedges()));
        const Vertex v(random_number(n));
        const Mesh::Face_index f(random_number(c.mesh.number_of_faces()));
        switch (random_index(7, rng)) {
        case 0:
          c.mesh.set_next_only(h, other);
          break;
        case 1:
          c.mesh.set_prev_only(h, other);
          break;
        case 2:
          c.mesh.set_next(h, other);
          break;
        case 3:
          c.mesh.set_target(h, v);
          break;
        case 4:
          c.mesh.set_face(h, f);
          break;
        case 5:
          c.mesh.set_halfedge(v, h);
          break;
        default:
          c.mesh.set_halfedge(f, h);
        }
      }
      for (const auto algorithm :
           {SMRG::Reeb_graph_algorithm::CUTTING, SMRG::Reeb_graph_algorithm::SWEEP})
      {
        Graph graph;
        const auto arcs = c.mesh.add_property_map<Vertex, std::size_t>("v:arc").first;
        try {
          SMRG::compute_Reeb_graph(
              c.mesh,
              c.values,
              graph,
              SMRG::parameters::vertex_arc_map(arcs).algorithm(algorithm).unfold_multiple_saddles(
                  seed % 5 == 0));
        } catch (const SMRG::Input_error&) {
          ++number_of_errors;
        } catch (const CGAL::Assertion_exception&) { // may see it first
          ++number_of_errors;
        }
      }
    }
  }
  BOOST_TEST(number_of_errors > 0u);
}

// Debug or Release: an error, not a walk without end.
BOOST_AUTO_TEST_CASE(other_faces_than_triangles_are_an_error)
{
  // with border; closed, a pyramid with one quadrangle; nothing but quadrangles
  for (const std::vector<std::vector<std::size_t>>& faces :
       {std::vector<std::vector<std::size_t>>{{0, 1, 3, 2}, {1, 0, 4}},
        {{0, 1, 3, 2}, {1, 0, 4}, {3, 1, 4}, {2, 3, 4}, {0, 2, 4}},
        {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {3, 7, 6, 2}, {2, 6, 4, 0}}})
  {
    Case c(Index_mesh(), {});
    std::vector<Vertex> corners;
    for (int i = 0; i < 8; ++i) {
      corners.push_back(c.mesh.add_vertex(Mesh::Point(i % 2, i / 2 % 2, i / 4)));
      c.values[corners.back()] = i;
    }
    for (const std::vector<std::size_t>& face : faces) {
      std::vector<Vertex> vertices;
      for (const std::size_t i : face)
        vertices.push_back(corners[i]);
      BOOST_TEST_REQUIRE((c.mesh.add_face(vertices) != Mesh::null_face()));
    }
    Graph graph;
    BOOST_CHECK_EXCEPTION(
        SMRG::compute_Reeb_graph(c.mesh, c.values, graph), SMRG::Error, says("triangle"));
  }
}
