// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed surfaces of known genus and of any size. But for the shuffled one, vertices and triangles
// that are neighbors on the surface are near each other in memory, too.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_MESHES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_MESHES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace Reeb_graph_benchmark {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

using Index = std::uint32_t;

struct Triangle_soup
{
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> triangles;
};

// The octahedron with `m` segments on every edge, blown up to the unit sphere: 8 `m`^2 triangles,
// ring by ring from pole to pole.
inline Triangle_soup sphere(const std::size_t m)
{
  Triangle_soup soup;
  const auto size_of_quarter = [m](const std::size_t ring) {
    return (std::min)(ring, 2 * m - ring);
  };

  std::vector<Index> first_of_ring;
  for (std::size_t ring = 0; ring <= 2 * m; ++ring) {
    first_of_ring.push_back(static_cast<Index>(soup.points.size()));
    const double z = double(m) - double(ring);
    const std::size_t k = size_of_quarter(ring);
    for (std::size_t i = 0; i < (std::max)(4 * k, std::size_t(1)); ++i) {
      // around the square |x| + |y| = k
      const std::size_t quarter = k == 0 ? 0 : i / k;
      const double a = k == 0 ? 0 : double(k - i % k), b = k == 0 ? 0 : double(i % k);
      const double x = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
      const double y = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
      const double length = std::hypot(x, y, z);
      soup.points.emplace_back(x / length, y / length, z / length);
    }
  }

  const auto vertex = [&](const std::size_t ring, const std::size_t quarter, const std::size_t i) {
    const std::size_t k = size_of_quarter(ring);
    return k == 0 ? first_of_ring[ring]
                  : first_of_ring[ring] + static_cast<Index>((quarter * k + i) % (4 * k));
  };
  for (std::size_t ring = 0; ring < 2 * m; ++ring) {
    const bool is_upper_half = ring < m;
    const std::size_t small = is_upper_half ? ring : ring + 1; // the ring with less vertices
    const std::size_t large = is_upper_half ? ring + 1 : ring;
    const auto add = [&](const Index a, const Index b, const Index c) {
      if (is_upper_half)
        soup.triangles.push_back({a, b, c});
      else
        soup.triangles.push_back({a, c, b});
    };
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      for (std::size_t i = 0; i < size_of_quarter(large); ++i) {
        add(vertex(small, quarter, i), vertex(large, quarter, i), vertex(large, quarter, i + 1));
        if (i < size_of_quarter(small))
          add(vertex(small, quarter, i),
              vertex(large, quarter, i + 1),
              vertex(small, quarter, i + 1));
      }
    }
  }
  return soup;
}

// `m` x `m` quads around a ring of radius 3 and thickness 1: 2 `m`^2 triangles.
inline Triangle_soup torus(const std::size_t m)
{
  Triangle_soup soup;
  const double angle = 2 * std::acos(-1.) / double(m);
  for (std::size_t i = 0; i < m; ++i) {
    const double u = angle * double(i);
    for (std::size_t j = 0; j < m; ++j) {
      const double v = angle * double(j), r = 3 + std::cos(v);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  }
  const auto vertex = [m](const std::size_t i, const std::size_t j) {
    return static_cast<Index>((i % m) * m + j % m);
  };
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return soup;
}

// How many nodes the scaffold has in every direction, and its genus: that of a thickened graph,
// edges - nodes + 1.
constexpr std::array<std::size_t, 3> scaffold_nodes = {4, 6, 7};
constexpr std::size_t scaffold_genus =
    2 * scaffold_nodes[0] * scaffold_nodes[1] * scaffold_nodes[2] -
    scaffold_nodes[0] * scaffold_nodes[1] - scaffold_nodes[1] * scaffold_nodes[2] -
    scaffold_nodes[2] * scaffold_nodes[0] + 1;

using Coordinates = std::array<std::size_t, 3>;

// The surface of the small cubes inside a box of `size` for which `is_solid(cube)` is true, rounded
// a little; edges and corners must not touch from outside. Cubes have length 1 / `m`. Layer by
// layer.
template <class IsSolid>
Triangle_soup
surface_of_cubes(const Coordinates& size, const std::size_t m, const IsSolid& is_solid)
{
  // the coordinates of a cube are those of its corner at the origin's side
  const auto is_inside_and_solid = [&](const Coordinates& cube) {
    for (std::size_t d = 0; d < 3; ++d)
      if (cube[d] >= size[d]) // unsigned: or less than 0
        return false;
    return bool(is_solid(cube));
  };

  Triangle_soup soup;
  const Index none = ~Index(0);
  std::vector<Index> number((size[0] + 1) * (size[1] + 1) * (size[2] + 1), none);
  const auto vertex = [&](const Coordinates& corner) {
    Index& v = number[(corner[0] * (size[1] + 1) + corner[1]) * (size[2] + 1) + corner[2]];
    if (v == none) {
      v = static_cast<Index>(soup.points.size());
      // Bent, so that no level set of a plane meets a whole face of the cubes.
      const double scale = 1 / double(m);
      std::array<double, 3> p;
      for (std::size_t d = 0; d < 3; ++d)
        p[d] = double(corner[d]) * scale + 0.1 * std::sin(double(corner[(d + 1) % 3]) * scale + d);
      soup.points.emplace_back(p[0], p[1], p[2]);
    }
    return v;
  };

  Coordinates cube;
  for (cube[0] = 0; cube[0] < size[0]; ++cube[0]) {
    for (cube[1] = 0; cube[1] < size[1]; ++cube[1]) {
      for (cube[2] = 0; cube[2] < size[2]; ++cube[2]) {
        if (!is_inside_and_solid(cube))
          continue;
        for (std::size_t d = 0; d < 3; ++d) {
          for (const bool is_upper_side : {false, true}) {
            Coordinates neighbor = cube;
            neighbor[d] += is_upper_side ? 1 : -1;
            if (is_inside_and_solid(neighbor))
              continue;
            std::array<Coordinates, 4> corner;
            corner.fill(cube);
            for (Coordinates& c : corner)
              c[d] += is_upper_side;
            const std::size_t right = (d + 1) % 3, up = (d + 2) % 3;
            ++corner[is_upper_side ? 1 : 3][right];
            ++corner[2][right];
            ++corner[2][up];
            ++corner[is_upper_side ? 3 : 1][up];
            std::array<Index, 4> v;
            std::transform(corner.begin(), corner.end(), v.begin(), vertex);
            soup.triangles.push_back({v[0], v[1], v[2]});
            soup.triangles.push_back({v[0], v[2], v[3]});
          }
        }
      }
    }
  }
  return soup;
}

// Something like a gyroid, but of known genus: a scaffold of struts along the edges of a cubic
// lattice, made of small cubes, `m` of which make the width of a strut and of the gaps between
// them. 3656 `m`^2 triangles.
inline Triangle_soup scaffold(const std::size_t m)
{
  Coordinates size;
  for (std::size_t d = 0; d < 3; ++d)
    size[d] = (2 * scaffold_nodes[d] - 1) * m;
  return surface_of_cubes(size, m, [m](const Coordinates& cube) {
    std::size_t number_of_walls = 0;
    for (const std::size_t coordinate : cube)
      number_of_walls += coordinate % (2 * m) < m;
    return number_of_walls >= 2;
  });
}

// A plate with `number_of_holes`^2 small holes, which are its handles, `m` cubes wide and deep, and
// as far from each other.
inline Triangle_soup perforated_plate(const std::size_t number_of_holes, const std::size_t m)
{
  const std::size_t length = (2 * number_of_holes + 1) * m;
  return surface_of_cubes({length, length, m}, m, [m](const Coordinates& cube) {
    return cube[0] % (2 * m) < m || cube[1] % (2 * m) < m;
  });
}

// The same surface, its vertices and triangles in an order that has nothing to do with the surface.
inline Triangle_soup shuffled(const Triangle_soup& soup)
{
  std::mt19937 generator(1);
  std::vector<Index> number(soup.points.size());
  std::iota(number.begin(), number.end(), Index(0));
  std::shuffle(number.begin(), number.end(), generator);
  Triangle_soup result = soup;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.points[number[v]] = soup.points[v];
  for (auto& triangle : result.triangles)
    for (Index& v : triangle)
      v = number[v];
  std::shuffle(result.triangles.begin(), result.triangles.end(), generator);
  return result;
}

// Throws if the soup is not a closed, connected surface of this genus: the figures would be about
// something else than what the table says.
inline Mesh make_mesh(const Triangle_soup& soup, const std::size_t genus)
{
  Mesh mesh;
  mesh.reserve(soup.points.size(), soup.triangles.size() / 2 * 3, soup.triangles.size());
  for (const Point& p : soup.points)
    mesh.add_vertex(p);
  boost::disjoint_sets_with_storage<> sets(soup.points.size());
  std::size_t number_of_components = soup.points.size();
  for (const auto& t : soup.triangles) {
    using Vertex = Mesh::Vertex_index;
    if (mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Mesh::null_face())
      throw std::logic_error("a mesh of the benchmark is not a manifold");
    for (const Index v : {t[1], t[2]}) {
      if (sets.find_set(t[0]) != sets.find_set(v)) {
        sets.link(sets.find_set(t[0]), sets.find_set(v));
        --number_of_components;
      }
    }
  }
  const long Euler_characteristic =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
  if (!CGAL::is_closed(mesh) || number_of_components != 1 ||
      Euler_characteristic != 2 - 2 * long(genus))
    throw std::logic_error("a mesh of the benchmark is not the closed surface that it should be");
  return mesh;
}

// A closed surface as scans have them: no symmetry, vertices that are not in line, and of two
// diagonals not always the better one. Triangles keep a height of at least a tenth of their longest
// edge.
inline Mesh irregular_surface(const std::size_t m)
{
  constexpr double smallest_height = 0.1; // by the longest edge
  Mesh mesh = make_mesh(sphere(m), 0);
  std::mt19937 generator(1);
  const auto random_number = [&generator]() { return double(generator()) / 4294967296.; };

  const auto is_well_shaped = [](const Point& p, const Point& q, const Point& r) {
    const double longest = (std::max)({CGAL::to_double(squared_distance(p, q)),
                                       CGAL::to_double(squared_distance(q, r)),
                                       CGAL::to_double(squared_distance(r, p))});
    const Kernel::Vector_3 normal = cross_product(q - p, r - p);
    // outwards, seen from the center of the sphere
    return normal * (p - CGAL::ORIGIN) > 0 &&
           normal.squared_length() > smallest_height * smallest_height * longest * longest;
  };
  const auto is_vertex_well_shaped = [&](const Mesh::Vertex_index v) {
    for (const Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh))
      if (!is_well_shaped(
              mesh.point(v), mesh.point(mesh.target(mesh.next(h))), mesh.point(mesh.source(h))))
        return false;
    return true;
  };

  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double length = std::sqrt(squared_distance(p, mesh.point(mesh.source(mesh.halfedge(v)))));
    const Kernel::Vector_3 step(
        random_number() - 0.5, random_number() - 0.5, random_number() - 0.5);
    const Kernel::Vector_3 moved = (p - CGAL::ORIGIN) + 0.6 * length * step;
    mesh.point(v) = CGAL::ORIGIN + moved / std::sqrt(moved.squared_length());
    if (!is_vertex_well_shaped(v))
      mesh.point(v) = p;
  }

  for (const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e), g = mesh.opposite(h);
    const Mesh::Vertex_index a = mesh.source(h), b = mesh.target(h);
    const Mesh::Vertex_index c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(g));
    if (random_number() < 0.3 && mesh.degree(a) > 4 && mesh.degree(b) > 4 &&
        !CGAL::halfedge(c, d, mesh).second &&
        is_well_shaped(mesh.point(a), mesh.point(d), mesh.point(c)) &&
        is_well_shaped(mesh.point(b), mesh.point(c), mesh.point(d)))
      CGAL::Euler::flip_edge(h, mesh);
  }

  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double radius =
        1 + 0.2 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + 0.1 * std::sin(5 * p.z() + p.x());
    mesh.point(v) = Point(radius * p.x(), 1.4 * radius * p.y(), 0.7 * radius * p.z());
  }
  return mesh;
}

// ---- the families of meshes ---------------------------------------------------------------------

struct Mesh_family
{
  const char* name;
  std::size_t genus;
  double triangles_of_unit; // the number of triangles is this times m^2
  std::size_t smallest_m;
  Triangle_soup (*make)(std::size_t m);

  std::size_t size_for(const double number_of_triangles) const
  {
    return static_cast<std::size_t>(
        std::lround(std::sqrt(number_of_triangles / triangles_of_unit)));
  }

  std::size_t number_of_triangles(const std::size_t m) const
  {
    return static_cast<std::size_t>(triangles_of_unit) * m * m;
  }
};

inline Triangle_soup shuffled_sphere(const std::size_t m)
{
  return shuffled(sphere(m));
}

inline const std::array<Mesh_family, 4> mesh_families = {{
    {"sphere", 0, 8, 2, sphere},
    {"torus", 1, 2, 3, torus},
    {"scaffold", scaffold_genus, 3656, 2, scaffold},
    {"shuffled_sphere", 0, 8, 2, shuffled_sphere},
}};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_MESHES_H
