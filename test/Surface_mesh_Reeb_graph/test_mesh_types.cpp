// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same results with every type of mesh and kernel, and by several threads.

#define BOOST_TEST_MODULE test_mesh_types

// GCC 12 suspects the optional members of Boost.Graph's edge iterators.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "Index_mesh.h"
#include "plain_results.h"
#include "random_meshes.h"
#include "spectral_results.h"

#include <CGAL/Surface_mesh_Reeb_graph/IO/GraphML.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/VTP.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <thread>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Float_kernel = CGAL::Simple_cartesian<float>;
using EPICK = CGAL::Exact_predicates_inexact_constructions_kernel;
using EPECK = CGAL::Exact_predicates_exact_constructions_kernel;

using Plain_polyhedron = CGAL::Polyhedron_3<EPICK>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Double_kernel, CGAL::Polyhedron_items_with_id_3>;

} // namespace

// ---------------------------------------------------------------------------------------------
// Meshes and kernels

BOOST_AUTO_TEST_SUITE(meshes)

BOOST_AUTO_TEST_CASE(references_are_meaningful)
{
  const Scalar_result& scalar = scalar_reference();
  BOOST_CHECK_GT(scalar.graph.nodes.size(), 20u);
  BOOST_CHECK_GE(scalar.simplified_graph.nodes.size(), 4u);
  BOOST_CHECK_LT(scalar.simplified_graph.nodes.size(), scalar.graph.nodes.size());
  BOOST_CHECK_EQUAL(scalar.graph.arcs.size(), scalar.graph.nodes.size()); // one loop
  BOOST_CHECK_EQUAL(scalar.simplified_graph.arcs.size(), scalar.simplified_graph.nodes.size());

  const Spectral_result& spectral = spectral_reference();
  BOOST_CHECK_GE(spectral.eigenvalues.size(), 50u);
  BOOST_CHECK_GE(spectral.feature_points.size(), 3u);
  BOOST_CHECK_GE(spectral.graph.nodes.size(), 6u);
  BOOST_CHECK_EQUAL(spectral.graph.arcs.size() + 1, spectral.graph.nodes.size());
}

template <class K>
using Surface_mesh_of = CGAL::Surface_mesh<typename K::Point_3>;

// Points matter to spectral results only; the reference is a Surface_mesh.
using Scalar_mesh_types = boost::mpl::list<Plain_polyhedron, Polyhedron_with_ids>;
using Spectral_mesh_types = boost::mpl::list<Surface_mesh_of<Float_kernel>,
                                             Surface_mesh_of<EPECK>,
                                             Plain_polyhedron,
                                             Polyhedron_with_ids>;

BOOST_AUTO_TEST_CASE_TEMPLATE(same_graph_of_a_scalar_function, TriangleMesh, Scalar_mesh_types)
{
  const Numbered_mesh<TriangleMesh> input(rough_torus());
  check_equal(scalar_result(input, rough_values(rough_torus())), scalar_reference());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(same_spectral_results, TriangleMesh, Spectral_mesh_types)
{
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using Vector = typename CGAL::Kernel_traits<Point>::Kernel::Vector_3;

  const Numbered_mesh<TriangleMesh> input(shape_with_limbs());
  check_close(spectral_result(input, Vector(1, -2, 4)), spectral_reference());
}

BOOST_AUTO_TEST_CASE(same_graphs_on_random_meshes)
{
  std::mt19937 rng(11);
  for (int i = 0; i < 60; ++i) {
    BOOST_TEST_CONTEXT("mesh " << i)
    {
      const Index_mesh mesh = random_small_mesh(rng);
      const std::vector<double> values = i % 3 == 0
                                             ? random_values(mesh.points.size(), rng)
                                             : random_integer_values(mesh.points.size(), 6, rng);
      const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(mesh), values);
      check_equal(scalar_result(Numbered_mesh<Plain_polyhedron>(mesh), values), expected);
      check_equal(scalar_result(Numbered_mesh<Polyhedron_with_ids>(mesh), values), expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(polyhedron_with_initialized_ids)
{
  {
    Numbered_mesh<Polyhedron_with_ids> input(rough_torus());
    CGAL::set_halfedgeds_items_id(input.mesh);
    check_equal(scalar_result(input, rough_values(rough_torus())), scalar_reference());
  }
  {
    Numbered_mesh<Polyhedron_with_ids> input(shape_with_limbs());
    CGAL::set_halfedgeds_items_id(input.mesh);
    check_close(spectral_result(input, Double_kernel::Vector_3(1, -2, 4)), spectral_reference());
  }
}

// Valid indices are used as they are; without ties they do not matter.
BOOST_AUTO_TEST_CASE(polyhedron_with_ids_in_another_order)
{
  std::mt19937 rng(12);
  const std::vector<double> values = random_values(rough_torus().points.size(), rng);
  const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(rough_torus()), values);

  Numbered_mesh<Polyhedron_with_ids> input(rough_torus());
  CGAL::set_halfedgeds_items_id(input.mesh);
  const std::vector<std::size_t> ids = random_permutation(input.vertices.size(), rng);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    input.vertices[i]->id() = ids[i];
  }
  check_equal(scalar_result(input, values), expected);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    BOOST_CHECK_EQUAL(input.vertices[i]->id(), ids[i]);
  }
}

// A part of a mesh, with a border where it was cut off, against a mesh that has this part only.
BOOST_AUTO_TEST_CASE(face_filtered_graph)
{
  const Index_mesh& whole = rough_torus();
  std::vector<double> values = rough_values(whole);

  Numbered_mesh<Mesh> whole_input(whole);
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch =
      whole_input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  Index_mesh part;
  part.points = whole.points;
  auto f = faces(whole_input.mesh).begin();
  for (std::size_t i = 0; i < whole.triangles.size(); ++i, ++f) {
    // two pieces with borders, and a few pinched vertices
    const bool is_selected = i % 16 < 11 && i / 32 != 3 && i % 37 != 0;
    patch[*f] = is_selected ? 1 : 0;
    if (is_selected) {
      part.triangles.push_back(whole.triangles[i]);
    }
  }
  std::vector<std::size_t> number(whole.points.size(), std::size_t(-1));
  {
    std::set<std::size_t> used;
    for (const auto& t : part.triangles) {
      used.insert(t.begin(), t.end());
    }
    std::vector<std::array<double, 3>> points;
    std::vector<double> used_values;
    for (const std::size_t v : used) {
      number[v] = points.size();
      points.push_back(part.points[v]);
      used_values.push_back(values[v]);
    }
    part.points = points;
    values = used_values;
    for (auto& t : part.triangles) {
      t = {number[t[0]], number[t[1]], number[t[2]]};
    }
  }

  using Filtered = CGAL::Face_filtered_graph<Mesh>;
  const Filtered filtered(whole_input.mesh, std::size_t(1), patch);
  Vertex_values<Mesh, double> map;
  std::map<Vertex, std::size_t> number_of_vertex;
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    if (number[i] != std::size_t(-1)) {
      map[whole_input.vertices[i]] = values[number[i]];
      number_of_vertex[whole_input.vertices[i]] = number[i];
    }
  }
  BOOST_REQUIRE_EQUAL(
      static_cast<std::size_t>(std::distance(vertices(filtered).begin(), vertices(filtered).end())),
      part.points.size());

  Numbered_mesh<Mesh> names_of_vertices;
  names_of_vertices.number = number_of_vertex;
  SMRG::Reeb_graph<Filtered> graph;
  SMRG::compute_Reeb_graph(filtered,
                           boost::make_assoc_property_map(map),
                           graph,
                           SMRG::parameters::collect_arc_vertices(true));
  const Scalar_result expected = scalar_result(Numbered_mesh<Mesh>(part), values);
  check_equal(plain(names_of_vertices, graph), expected.graph);
  SMRG::simplify_Reeb_graph(filtered,
                            boost::make_assoc_property_map(map),
                            graph,
                            SMRG::parameters::persistence_threshold(scalar_threshold));
  check_equal(plain(names_of_vertices, graph), expected.simplified_graph);
}

BOOST_AUTO_TEST_CASE(removed_elements)
{
  // vertices and faces removed at the beginning, in the middle and at the end of the arrays
  Index_mesh with_debris = sphere(0);
  append(with_debris, shape_with_limbs(), 0);
  append(with_debris, sphere(0), 20);
  Numbered_mesh<Mesh> input(with_debris);
  const std::size_t first = sphere(0).points.size();
  const std::size_t last = first + shape_with_limbs().points.size();
  CGAL::Euler::remove_face(halfedge(*faces(input.mesh).begin(), input.mesh), input.mesh);
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    if (i < first || i >= last) {
      const Vertex v = input.vertices[i];
      // a face takes the vertices with it that have no other
      while (!input.mesh.is_removed(v) && halfedge(v, input.mesh) != Mesh::null_halfedge()) {
        auto h = halfedge(v, input.mesh);
        h = is_border(h, input.mesh) ? opposite(h, input.mesh) : h;
        CGAL::Euler::remove_face(h, input.mesh);
      }
      if (!input.mesh.is_removed(v)) {
        remove_vertex(v, input.mesh);
      }
    }
  }
  // an isolated vertex in between and a removed one after everything
  remove_vertex(add_vertex(input.mesh), input.mesh);
  BOOST_REQUIRE(input.mesh.has_garbage());
  BOOST_REQUIRE_EQUAL(input.mesh.number_of_vertices(), last - first);
  input.vertices.assign(input.mesh.vertices().begin(), input.mesh.vertices().end());
  input.number_vertices();

  Numbered_mesh<Mesh> collected;
  collected.mesh = input.mesh;
  collected.mesh.collect_garbage();
  collected.vertices.assign(collected.mesh.vertices().begin(), collected.mesh.vertices().end());
  collected.number_vertices();
  // garbage collection may change the order; the positions tell who is who
  std::map<Double_kernel::Point_3, Vertex> vertex_at;
  for (Vertex v : collected.mesh.vertices()) {
    vertex_at[collected.mesh.point(v)] = v;
  }
  BOOST_REQUIRE_EQUAL(vertex_at.size(), last - first);
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    collected.vertices[i] = vertex_at.at(input.mesh.point(input.vertices[i]));
  }
  collected.number_vertices();

  std::mt19937 rng(13);
  const std::vector<double> values = random_values(last - first, rng);
  check_equal(scalar_result(input, values), scalar_result(collected, values));
  const Double_kernel::Vector_3 axis(1, -2, 4);
  check_close(spectral_result(input, axis), spectral_result(collected, axis));

  // the graph can be written as well
  SMRG::Reeb_graph<Mesh> graph;
  auto map = values_of_vertices<double>(input, values);
  auto arcs = values_of_vertices<int>(input, std::vector<int>(values.size(), 0));
  SMRG::compute_Reeb_graph(input.mesh, boost::make_assoc_property_map(map), graph);
  std::ostringstream out;
  BOOST_CHECK(SMRG::IO::write_GraphML(out, graph, input.mesh));
  BOOST_CHECK(SMRG::IO::write_VTP(
      out, input.mesh, boost::make_assoc_property_map(map), boost::make_assoc_property_map(arcs)));
}

BOOST_AUTO_TEST_SUITE_END()

// ---------------------------------------------------------------------------------------------
// Threads

BOOST_AUTO_TEST_SUITE(threads)

// The mesh is the only thing that the threads share.
template <class TriangleMesh>
void check_threads(const Index_mesh& mesh)
{
  const Numbered_mesh<TriangleMesh> input(mesh);
  constexpr std::size_t rounds = 20;
  std::vector<std::vector<double>> values;
  std::vector<Scalar_result> expected, found(2 * rounds);
  for (unsigned i = 0; i < 2 * rounds; ++i) {
    values.push_back(rough_values(mesh, i));
    expected.push_back(scalar_result(input, values.back()));
  }
  auto work = [&](const std::size_t first) {
    for (std::size_t i = first; i < values.size(); i += 2) {
      found[i] = scalar_result(input, values[i]);
    }
  };
  std::thread odd(work, 1);
  work(0);
  odd.join();
  for (std::size_t i = 0; i < values.size(); ++i) {
    check_equal(found[i], expected[i]);
  }
}

BOOST_AUTO_TEST_CASE(one_mesh_two_threads)
{
  check_threads<Mesh>(rough_torus());
  check_threads<Plain_polyhedron>(rough_torus());
}

BOOST_AUTO_TEST_CASE(one_mesh_two_threads_whole_method)
{
  const Numbered_mesh<Mesh> input(shape_with_limbs());
  std::array<SMRG::Reeb_graph<Mesh>, 2> graphs;
  auto work = [&](const std::size_t i) {
    SMRG::commute_time_Reeb_graph(
        input.mesh,
        graphs[i],
        SMRG::parameters::persistence_threshold(0.05).collect_arc_vertices(true));
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  check_close(plain(input, graphs[0]), spectral_reference().graph);
  check_close(plain(input, graphs[1]), spectral_reference().graph);
}

BOOST_AUTO_TEST_SUITE_END()
