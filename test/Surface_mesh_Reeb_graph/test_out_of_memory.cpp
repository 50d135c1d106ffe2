// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every request for memory fails once: std::bad_alloc is thrown, what was to be written is as it
// was before, and nothing is lost (the address sanitizer looks for that).

#define BOOST_TEST_MODULE out_of_memory
#include <boost/test/unit_test.hpp>

#include "Index_mesh.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/parameters.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <optional>
#include <random>
#include <vector>

namespace {

long requests_until_failure = -1; // none fails if it is negative

bool fails()
{
  return requests_until_failure >= 0 && requests_until_failure-- == 0;
}

} // namespace

// The linker leads calls of this program, Eigen's among them, to these.
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_realloc(void* memory, std::size_t size);

void* __wrap_malloc(std::size_t size)
{
  return fails() ? nullptr : __real_malloc(size);
}

void* __wrap_realloc(void* memory, std::size_t size)
{
  return fails() ? nullptr : __real_realloc(memory, size);
}
}

// Not inlined, because compilers pair what they see inside, malloc() with delete, and warn.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  void* const memory = std::malloc((std::max)(size, std::size_t(1)));
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

// Who asks like this can do without: that never fails here.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return __real_malloc((std::max)(size, std::size_t(1)));
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

namespace {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_test;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using vertex_descriptor = Mesh::Vertex_index;
using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;
using Float_eigenbasis =
    SMRG::Laplace_Beltrami_eigenbasis<Mesh, SMRG::Block_Lanczos_eigensolver<>, float>;
using Graph = SMRG::Reeb_graph<Mesh>;

// Calls `task()` with one more request granted each time until it succeeds. Returns how often it
// failed.
template <class Task, class IsUnchanged>
std::size_t number_of_failures(const Task& task, const IsUnchanged& is_unchanged)
{
  for (std::size_t failures = 0;; ++failures) {
    bool has_failed = false;
    requests_until_failure = static_cast<long>(failures);
    try {
      task();
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    requests_until_failure = -1;
    if (!has_failed)
      return failures;
    BOOST_TEST_REQUIRE(is_unchanged());
  }
}

// Two components, so that the first one may be done when the other one fails.
struct Two_components
{
  Two_components()
  {
    Index_mesh input = sphere(2);
    for (auto& p : input.points)
      p = {1.5 * p[0], 1.2 * p[1], 0.9 * p[2]};
    append(input, grid(4, 3), 10);
    make_mesh(input, mesh, vertices);
    values.assign(vertices.size(), unwritten);
  }

  auto map() { return CGAL::make_property_map(values); }

  bool is_unwritten() const
  {
    return std::all_of(
        values.begin(), values.end(), [](const double value) { return value == unwritten; });
  }

  static constexpr double unwritten = -7;
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  std::vector<double> values;
};

} // namespace

BOOST_FIXTURE_TEST_SUITE(out_of_memory, Two_components)

BOOST_AUTO_TEST_CASE(eigenbases_are_complete_or_not_there)
{
  const auto parameters = SMRG::parameters::number_of_eigenpairs(10);
  std::optional<Eigenbasis> basis;
  BOOST_TEST(number_of_failures([&]() { basis.emplace(mesh, parameters); },
                                [&]() { return !basis.has_value(); }) > 100);
  std::optional<Float_eigenbasis> float_basis;
  BOOST_TEST(number_of_failures([&]() { float_basis.emplace(mesh, parameters); },
                                [&]() { return !float_basis.has_value(); }) > 100);
}

BOOST_AUTO_TEST_CASE(maps_are_written_as_a_whole_or_not_at_all)
{
  const Eigenbasis basis(mesh, SMRG::parameters::number_of_eigenpairs(10));
  const auto is_unchanged = [&]() { return is_unwritten(); };
  BOOST_TEST(
      number_of_failures([&]() { SMRG::diffusion_distances(basis, vertices[5], 1.5, map()); },
                         is_unchanged) > 2);
  values.assign(vertices.size(), unwritten);
  BOOST_TEST(number_of_failures([&]() { SMRG::commute_time_distances(basis, vertices[5], map()); },
                                is_unchanged) > 2);
  values.assign(vertices.size(), unwritten);
  const std::vector<vertex_descriptor> sources = {vertices[5], vertices[20], vertices[165]};
  BOOST_TEST(number_of_failures([&]() { SMRG::commute_time_function(basis, sources, map()); },
                                is_unchanged) > 5);
  BOOST_TEST(!is_unwritten());

  std::vector<vertex_descriptor> points(vertices.size());
  auto end = points.begin();
  const auto task = [&]() { end = SMRG::feature_points(basis, points.begin()); };
  BOOST_TEST(number_of_failures(task, [&]() {
               return points == std::vector<vertex_descriptor>(vertices.size());
             }) > 5);
  BOOST_TEST((end != points.begin()));
}

BOOST_AUTO_TEST_CASE(graphs_are_not_half_written)
{
  mesh.clear();
  make_mesh(closed_surface(3, 5, 5), mesh, vertices);
  values.assign(vertices.size(), 0);
  std::mt19937 rng(1);
  for (const vertex_descriptor v : vertices)
    values[v] = random_unit(rng);
  constexpr std::size_t unwritten_arc = 1000000;
  std::vector<std::size_t> arcs(vertices.size(), unwritten_arc);
  const auto parameters = SMRG::parameters::vertex_arc_map(CGAL::make_property_map(arcs));
  Graph graph;
  add_vertex(graph);
  const auto is_unchanged = [&]() {
    return num_vertices(graph) <= 1 && num_edges(graph) == 0 &&
           std::count(arcs.begin(), arcs.end(), unwritten_arc) == std::ptrdiff_t(arcs.size());
  };
  BOOST_TEST(number_of_failures([&]() { SMRG::compute_Reeb_graph(mesh, map(), graph, parameters); },
                                is_unchanged) > 20);
  BOOST_TEST(num_vertices(graph) > 10);

  const Graph full_graph = graph;
  const std::vector<std::size_t> full_arcs = arcs;
  const auto is_whole = [&]() {
    if (num_vertices(graph) == 0) // which the manual allows
      graph = full_graph;
    return num_vertices(graph) == num_vertices(full_graph) &&
           num_edges(graph) == num_edges(full_graph) && arcs == full_arcs;
  };
  BOOST_TEST(number_of_failures(
                 [&]() {
                   SMRG::simplify_Reeb_graph(
                       mesh,
                       map(),
                       graph,
                       parameters.persistence_threshold(0.3).loop_persistence_threshold(2));
                 },
                 is_whole) > 20);
  BOOST_TEST(num_vertices(graph) < num_vertices(full_graph));
  BOOST_TEST(num_edges(graph) + 1 == num_vertices(graph)); // no loop is left
  BOOST_TEST((arcs != full_arcs));
}

BOOST_AUTO_TEST_SUITE_END()
