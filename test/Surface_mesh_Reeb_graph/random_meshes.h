// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes and functions for the tests: a few shapes with known geometry, small random surfaces of
// any topology that a FaceGraph can hold, and the topological numbers to check results against.

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_RANDOM_MESHES_H
#define SURFACE_MESH_REEB_GRAPH_TEST_RANDOM_MESHES_H

#include "Index_mesh.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace Reeb_graph_test {

using Index_edge = std::pair<std::size_t, std::size_t>;

inline Index_edge undirected(const std::size_t a, const std::size_t b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

// ---------------------------------------------------------------------------------------------
// Topology

// Every edge once, smaller vertex first.
inline std::set<Index_edge> edges_of(const Index_mesh& mesh)
{
  std::set<Index_edge> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.insert(undirected(t[i], t[(i + 1) % 3]));
    }
  }
  return edges;
}

// A maximal run of triangles around a vertex, each sharing an edge with the next, given by the
// vertices opposite to the centre in counter-clockwise order. Not closed: the fan ends at two
// border edges.
struct Fan
{
  std::vector<std::size_t> vertices;
  bool closed;
};

// The fans of every vertex: one closed fan inside the surface, one open fan on its border, several
// open ones where the vertex is pinched, none if it is isolated.
// \pre no directed edge occurs in two triangles
inline std::vector<std::vector<Fan>> fans_of_vertices(const Index_mesh& mesh)
{
  std::vector<std::map<std::size_t, std::size_t>> next_in_link(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      next_in_link[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
  }

  std::vector<std::vector<Fan>> fans(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    std::map<std::size_t, std::size_t>& next = next_in_link[v];
    std::set<std::size_t> starts;
    for (const auto& step : next) {
      starts.insert(step.first);
    }
    for (const auto& step : next) {
      starts.erase(step.second);
    }

    // The steps are used up, open fans first: what is left then are the closed ones.
    while (!next.empty()) {
      Fan fan{{}, starts.empty()};
      std::size_t at = fan.closed ? next.begin()->first : *starts.begin();
      starts.erase(at);
      fan.vertices.push_back(at);
      for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
        at = step->second;
        next.erase(step);
        fan.vertices.push_back(at);
      }
      if (fan.closed) {
        fan.vertices.pop_back();
      }
      fans[v].push_back(fan);
    }
  }
  return fans;
}

// Is the mesh a consistently oriented simplicial 2-manifold? `allow_pinched_vertices` accepts
// vertices where several border fans meet: not manifold, yet normal input, since halfedge data
// structures can hold them.
inline bool is_valid(const Index_mesh& mesh, const bool allow_pinched_vertices = false)
{
  std::set<Index_edge> directed_edges;
  std::set<std::set<std::size_t>> faces;
  for (const auto& t : mesh.triangles) {
    const std::set<std::size_t> corners(t.begin(), t.end());
    if (corners.size() != 3 || *corners.rbegin() >= mesh.points.size() ||
        !faces.insert(corners).second) {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      // Hence at most two triangles per edge, and those with opposite orientations.
      if (!directed_edges.insert({t[i], t[(i + 1) % 3]}).second) {
        return false;
      }
    }
  }

  for (const std::vector<Fan>& fans : fans_of_vertices(mesh)) {
    const bool any_closed =
        std::any_of(fans.begin(), fans.end(), [](const Fan& fan) { return fan.closed; });
    if (fans.size() > 1 && (any_closed || !allow_pinched_vertices)) {
      return false;
    }
  }
  return true;
}

inline bool is_closed(const Index_mesh& mesh)
{
  // Every triangle has three sides, every edge of a closed surface two triangles.
  return 3 * mesh.triangles.size() == 2 * edges_of(mesh).size();
}

// V - E + F; an isolated vertex counts 1.
inline long Euler_characteristic(const Index_mesh& mesh)
{
  return static_cast<long>(mesh.points.size()) - static_cast<long>(edges_of(mesh).size()) +
         static_cast<long>(mesh.triangles.size());
}

// Connected by edges, so a pinched vertex holds its fans together; an isolated vertex is a
// component.
inline std::size_t number_of_components(const Index_mesh& mesh)
{
  boost::disjoint_sets_with_storage<> sets(mesh.points.size());
  std::size_t count = mesh.points.size();
  for (const Index_edge& e : edges_of(mesh)) {
    if (sets.find_set(e.first) != sets.find_set(e.second)) {
      sets.union_set(e.first, e.second);
      --count;
    }
  }
  return count;
}

// The sum of the genera of all components, borders capped and pinched vertices pulled apart.
inline std::size_t genus(const Index_mesh& mesh)
{
  const std::set<Index_edge> edges = edges_of(mesh);
  std::map<Index_edge, std::size_t> edge_number;
  for (const Index_edge& e : edges) {
    edge_number.emplace(e, edge_number.size());
  }

  // Surface components are connected by edges through triangles, border loops by border edges
  // through fans.
  boost::disjoint_sets_with_storage<> surfaces(edges.size());
  boost::disjoint_sets_with_storage<> loops(edges.size());
  for (const auto& t : mesh.triangles) {
    const std::size_t side = edge_number.at(undirected(t[0], t[1]));
    surfaces.union_set(side, edge_number.at(undirected(t[1], t[2])));
    surfaces.union_set(side, edge_number.at(undirected(t[2], t[0])));
  }

  std::size_t number_of_fans = 0;
  std::set<std::size_t> border_edges;
  const std::vector<std::vector<Fan>> fans = fans_of_vertices(mesh);
  for (std::size_t v = 0; v < fans.size(); ++v) {
    for (const Fan& fan : fans[v]) {
      ++number_of_fans;
      if (!fan.closed) {
        const std::size_t first = edge_number.at(undirected(v, fan.vertices.front()));
        const std::size_t last = edge_number.at(undirected(v, fan.vertices.back()));
        loops.union_set(first, last);
        border_edges.insert({first, last});
      }
    }
  }

  std::set<std::size_t> surface_roots;
  std::set<std::size_t> loop_roots;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    surface_roots.insert(surfaces.find_set(e));
  }
  for (const std::size_t e : border_edges) {
    loop_roots.insert(loops.find_set(e));
  }

  // V - E + F = sum over the surfaces of (2 - 2 genus - border loops)
  return (2 * surface_roots.size() + edges.size() - number_of_fans - mesh.triangles.size() -
          loop_roots.size()) /
         2;
}

// ---------------------------------------------------------------------------------------------
// Shapes with known geometry, oriented outwards (upwards for the flat one)

// The icosahedron, every triangle split into four `subdivisions` times, on the unit sphere.
inline Index_mesh sphere(const std::size_t subdivisions)
{
  const double phi = (1 + std::sqrt(5.)) / 2;
  Index_mesh mesh;
  mesh.points = {{-1, phi, 0},
                 {1, phi, 0},
                 {-1, -phi, 0},
                 {1, -phi, 0},
                 {0, -1, phi},
                 {0, 1, phi},
                 {0, -1, -phi},
                 {0, 1, -phi},
                 {phi, 0, -1},
                 {phi, 0, 1},
                 {-phi, 0, -1},
                 {-phi, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

  for (std::size_t s = 0; s < subdivisions; ++s) {
    std::map<Index_edge, std::size_t> middles;
    const auto middle = [&](const std::size_t a, const std::size_t b) {
      const auto inserted = middles.emplace(undirected(a, b), mesh.points.size());
      if (inserted.second) {
        const std::array<double, 3> p = mesh.points[a];
        const std::array<double, 3> q = mesh.points[b];
        mesh.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return inserted.first->second;
    };

    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& t : mesh.triangles) {
      const std::size_t a = middle(t[0], t[1]);
      const std::size_t b = middle(t[1], t[2]);
      const std::size_t c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    mesh.triangles = finer;
    for (auto& p : mesh.points) {
      const double length = std::hypot(p[0], p[1], p[2]);
      p = {p[0] / length, p[1] / length, p[2] / length};
    }
  }
  return mesh;
}

// Triangulates an array of quads: `columns` x `rows` of them, vertex (i, j) of the array being
// `number(i, j)`.
template <class Numbering>
std::vector<std::array<std::size_t, 3>>
split_quads(const std::size_t columns, const std::size_t rows, const Numbering& number)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      const std::size_t diagonal_from = number(i, j);
      const std::size_t diagonal_to = number(i + 1, j + 1);
      triangles.push_back({diagonal_from, number(i + 1, j), diagonal_to});
      triangles.push_back({diagonal_from, diagonal_to, number(i, j + 1)});
    }
  }
  return triangles;
}

// `m` quads around the z-axis, `n` around the tube.
// \pre `m >= 3 && n >= 3`
inline Index_mesh torus(const std::size_t m,
                        const std::size_t n,
                        const double major_radius = 1,
                        const double minor_radius = 0.4)
{
  const double two_pi = 2 * std::acos(-1.);
  Index_mesh mesh;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double u = two_pi * static_cast<double>(i) / static_cast<double>(m);
      const double v = two_pi * static_cast<double>(j) / static_cast<double>(n);
      const double radius = major_radius + minor_radius * std::cos(v);
      mesh.points.push_back(
          {radius * std::cos(u), radius * std::sin(u), minor_radius * std::sin(v)});
    }
  }
  mesh.triangles = split_quads(
      m, n, [=](const std::size_t i, const std::size_t j) { return (i % m) * n + j % n; });
  return mesh;
}

// `m` x `n` unit squares in the plane z = 0; vertex (i, j) has number i (n + 1) + j.
inline Index_mesh grid(const std::size_t m, const std::size_t n)
{
  Index_mesh mesh;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      mesh.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
    }
  }
  mesh.triangles =
      split_quads(m, n, [=](const std::size_t i, const std::size_t j) { return i * (n + 1) + j; });
  return mesh;
}

// `m` quads around the z-axis, `n` along it, radius 1, z from 0 to `height`.
// \pre `m >= 3`
inline Index_mesh cylinder(const std::size_t m, const std::size_t n, const double height = 1)
{
  const double two_pi = 2 * std::acos(-1.);
  Index_mesh mesh;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      const double u = two_pi * static_cast<double>(i) / static_cast<double>(m);
      mesh.points.push_back(
          {std::cos(u), std::sin(u), height * static_cast<double>(j) / static_cast<double>(n)});
    }
  }
  mesh.triangles = split_quads(
      m, n, [=](const std::size_t i, const std::size_t j) { return (i % m) * (n + 1) + j; });
  return mesh;
}

// ---------------------------------------------------------------------------------------------
// Surfaces made by cutting and gluing: of their points only the number matters

// Adds `other`, moved by `shift` along the x-axis, as components of their own.
inline void append(Index_mesh& mesh, const Index_mesh& other, const double shift)
{
  const std::size_t offset = mesh.points.size();
  for (const auto& p : other.points) {
    mesh.points.push_back({p[0] + shift, p[1], p[2]});
  }
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
}

// Drops the points that no triangle uses.
inline void remove_isolated_vertices(Index_mesh& mesh)
{
  std::map<std::size_t, std::size_t> number;
  std::vector<std::array<double, 3>> points;
  for (auto& t : mesh.triangles) {
    for (std::size_t& v : t) {
      const auto inserted = number.emplace(v, points.size());
      if (inserted.second) {
        points.push_back(mesh.points[v]);
      }
      v = inserted.first->second;
    }
  }
  mesh.points = points;
}

// Identifies vertices: `t` becomes `representative.at(t)` where there is one.
inline void
identify_vertices(Index_mesh& mesh, const std::map<std::size_t, std::size_t>& representative)
{
  for (auto& t : mesh.triangles) {
    for (std::size_t& v : t) {
      const auto found = representative.find(v);
      v = found == representative.end() ? v : found->second;
    }
  }
  remove_isolated_vertices(mesh);
}

// A closed surface: `sphere(1)` for genus 0, else the connected sum of `genus` tori of `m` x `n`
// quads.
inline Index_mesh
closed_surface(const std::size_t genus, const std::size_t m = 3, const std::size_t n = 3)
{
  if (genus == 0) {
    return sphere(1);
  }

  Index_mesh mesh = torus(m, n);
  for (std::size_t g = 1; g < genus; ++g) {
    // Any two triangles will do; these lie far from each other within every torus.
    const auto middle_of_last_torus = mesh.triangles.end() - static_cast<std::ptrdiff_t>(m * n);
    const std::array<std::size_t, 3> hole = *middle_of_last_torus;
    mesh.triangles.erase(middle_of_last_torus);
    const std::size_t first_new_triangle = mesh.triangles.size();
    append(mesh, torus(m, n), 3. * static_cast<double>(g));
    const std::array<std::size_t, 3> new_hole = mesh.triangles[first_new_triangle];
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first_new_triangle));
    // Opposite directions, so that the orientations fit.
    identify_vertices(mesh,
                      {{new_hole[0], hole[0]}, {new_hole[1], hole[2]}, {new_hole[2], hole[1]}});
  }
  return mesh;
}

// ---------------------------------------------------------------------------------------------
// Randomness. The distributions and `std::shuffle` of the standard library differ between its
// implementations; these do not, so that a seed means the same case everywhere.

// From 0 to n - 1.
inline std::size_t random_index(const std::size_t n, std::mt19937& rng)
{
  return static_cast<std::size_t>(rng()) % n;
}

// From 0 to 1, 1 excluded.
inline double random_unit(std::mt19937& rng)
{
  return static_cast<double>(rng()) / 4294967296.;
}

template <class T>
void shuffle(std::vector<T>& items, std::mt19937& rng)
{
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[random_index(i, rng)]);
  }
}

inline std::vector<std::size_t> random_permutation(const std::size_t n, std::mt19937& rng)
{
  std::vector<std::size_t> permutation(n);
  std::iota(permutation.begin(), permutation.end(), std::size_t(0));
  shuffle(permutation, rng);
  return permutation;
}

// ---------------------------------------------------------------------------------------------
// Random changes of a mesh, each keeping it valid

// Tries `attempts` times to replace an edge by the other diagonal of its two triangles.
inline void flip_random_edges(Index_mesh& mesh, const std::size_t attempts, std::mt19937& rng)
{
  std::map<Index_edge, std::size_t> triangle_of; // of a directed edge
  const auto enter = [&](const std::size_t triangle) {
    const auto& t = mesh.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      triangle_of[{t[i], t[(i + 1) % 3]}] = triangle;
    }
  };
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    enter(triangle);
  }

  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t left = random_index(mesh.triangles.size(), rng);
    const std::size_t i = random_index(3, rng);
    const std::size_t a = mesh.triangles[left][i];
    const std::size_t b = mesh.triangles[left][(i + 1) % 3];
    const std::size_t c = mesh.triangles[left][(i + 2) % 3];
    const auto opposite = triangle_of.find({b, a});
    if (opposite == triangle_of.end()) {
      continue;
    }
    const std::size_t right = opposite->second;
    const auto& t = mesh.triangles[right];
    const std::size_t d = t[0] + t[1] + t[2] - a - b;
    // A second edge between c and d would leave the simplicial complexes.
    if (triangle_of.count({c, d}) != 0 || triangle_of.count({d, c}) != 0) {
      continue;
    }
    triangle_of.erase({a, b});
    triangle_of.erase({b, a});
    mesh.triangles[left] = {a, d, c};
    mesh.triangles[right] = {d, b, c};
    enter(left);
    enter(right);
  }
}

// Removes a random triangle or the star of a random vertex if what is left is valid; `false` if
// it is not. The hole may join another one or cut the mesh in two.
inline bool punch_random_hole(Index_mesh& mesh, std::mt19937& rng)
{
  Index_mesh punched = mesh;
  const std::size_t triangle = random_index(mesh.triangles.size(), rng);
  if (random_index(2, rng) == 0) {
    punched.triangles.erase(punched.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  } else {
    const std::size_t v = mesh.triangles[triangle][0];
    const auto has_v = [v](const std::array<std::size_t, 3>& t) {
      return std::find(t.begin(), t.end(), v) != t.end();
    };
    punched.triangles.erase(
        std::remove_if(punched.triangles.begin(), punched.triangles.end(), has_v),
        punched.triangles.end());
  }

  remove_isolated_vertices(punched);
  if (punched.triangles.empty() || !is_valid(punched)) {
    return false;
  }
  mesh = punched;
  return true;
}

// Makes one vertex of two random border vertices, of one component or of two, if they have no
// neighbour in common; `false` if that is not to be had.
inline bool pinch_random_border_vertices(Index_mesh& mesh, std::mt19937& rng)
{
  std::vector<std::size_t> border;
  const std::vector<std::vector<Fan>> fans = fans_of_vertices(mesh);
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (!fans[v].empty() && !fans[v].front().closed) {
      border.push_back(v);
    }
  }
  if (border.empty()) {
    return false;
  }

  Index_mesh pinched = mesh;
  const std::size_t kept = border[random_index(border.size(), rng)];
  const std::size_t gone = border[random_index(border.size(), rng)];
  identify_vertices(pinched, {{gone, kept}});
  // A common neighbour would make two edges one, so fewer of them.
  if (kept == gone || edges_of(pinched).size() != edges_of(mesh).size() || !is_valid(pinched, true))
  {
    return false;
  }
  mesh = pinched;
  return true;
}

// Renumbers the vertices, the triangles, and the corners of each triangle (orientation kept).
inline void relabel_randomly(Index_mesh& mesh, std::mt19937& rng)
{
  const std::vector<std::size_t> number = random_permutation(mesh.points.size(), rng);
  std::vector<std::array<double, 3>> points(mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    points[number[v]] = mesh.points[v];
  }
  mesh.points = points;
  for (auto& t : mesh.triangles) {
    t = {number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random_index(3, rng)), t.end());
  }
  shuffle(mesh.triangles, rng);
}

// A random surface of at most 150 vertices: one to three parts of total genus 0 to 5, edges flipped
// at random, one mesh in two with up to four holes punched, some isolated vertices now and then,
// everything renumbered. With `pinched_vertices` there is a hole wherever one is possible, and
// often border vertices are glued to each other.
inline Index_mesh random_small_mesh(std::mt19937& rng, const bool pinched_vertices = false)
{
  const std::size_t number_of_parts = (std::max)(random_index(5, rng), std::size_t(2)) - 1;
  std::size_t genus_left = random_index(6, rng);
  Index_mesh mesh;
  for (std::size_t part = 0; part < number_of_parts; ++part) {
    const bool last_part = part + 1 == number_of_parts;
    const std::size_t part_genus = last_part ? genus_left : random_index(genus_left + 1, rng);
    genus_left -= part_genus;
    const std::size_t m = 3 + random_index(3, rng);
    const std::size_t n = 3 + random_index(2, rng);
    const std::size_t kind = random_index(6, rng);
    // The finer sphere only if it is alone, to keep to the number of vertices promised.
    const Index_mesh shape = part_genus > 0 ? closed_surface(part_genus, m, n)
                             : kind == 0    ? grid(m, n - 1)
                             : kind == 1    ? cylinder(m, n - 1)
                                            : sphere(kind % 2 == 0 && number_of_parts == 1 ? 1 : 0);
    append(mesh, shape, 20. * static_cast<double>(part));
  }

  flip_random_edges(mesh, random_index(6 * mesh.triangles.size(), rng), rng);

  const bool with_holes = pinched_vertices || random_index(2, rng) == 0;
  const std::size_t number_of_holes = with_holes ? 1 + random_index(4, rng) : 0;
  for (std::size_t hole = 0; hole < number_of_holes; ++hole) {
    punch_random_hole(mesh, rng);
  }
  if (pinched_vertices) {
    for (std::size_t attempt = random_index(8, rng); attempt > 0; --attempt) {
      pinch_random_border_vertices(mesh, rng);
    }
  }
  if (random_index(4, rng) == 0) {
    append(mesh, Index_mesh{{{0, 0, 2}, {0, 1, 2}, {0, 2, 2}}, {}}, 0);
    mesh.points.resize(mesh.points.size() - random_index(3, rng));
  }
  relabel_randomly(mesh, rng);
  return mesh;
}

// ---------------------------------------------------------------------------------------------
// Functions

// Distinct values between 0 and 1.
inline std::vector<double> random_values(const std::size_t n, std::mt19937& rng)
{
  std::vector<double> values;
  for (const std::size_t slot : random_permutation(n, rng)) {
    values.push_back((static_cast<double>(slot) + random_unit(rng)) / static_cast<double>(n));
  }
  return values;
}

// Whole numbers from 0 to k - 1: ties and plateaus.
inline std::vector<double>
random_integer_values(const std::size_t n, const std::size_t k, std::mt19937& rng)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    values.push_back(static_cast<double>(random_index(k, rng)));
  }
  return values;
}

inline std::vector<double> constant_values(const std::size_t n)
{
  return std::vector<double>(n, 1.);
}

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_RANDOM_MESHES_H
