#ifndef MESH_INPUT_BUILD_MESH_H
#define MESH_INPUT_BUILD_MESH_H

#include "Edge_uses.h"
#include "Polygon_soup.h"

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

// Adds the points and the triangles of an oriented 2-manifold to an empty `CGAL::Surface_mesh`, the
// vertices in the order of the points. At the border, several fans of faces may meet in a vertex.
// `CGAL::Euler::add_face()` would look for its place among all faces around a vertex, which takes
// quadratic time around vertices of high degree; here, the edges are known beforehand.
template <class Mesh>
void build_mesh(const Polygon_soup& soup, Mesh& mesh)
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;
  using Size = typename Mesh::size_type;

  const Edge_uses edges(soup);
  std::size_t number_of_edges = 0;
  edges.for_each_edge([&](auto, auto) { ++number_of_edges; });
  mesh.reserve(static_cast<Size>(soup.points.size()),
               static_cast<Size>(number_of_edges),
               static_cast<Size>(soup.number_of_polygons()));
  for (const auto& p : soup.points)
    mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2]));

  std::vector<Halfedge> halfedge_of_corner(soup.corners.size());
  edges.for_each_edge([&](auto begin, auto end) {
    const Vertex low(static_cast<Size>(begin->low)), high(static_cast<Size>(begin->high));
    const Halfedge upward = mesh.add_edge(low, high);
    CGAL_assertion(end - begin == 1 || (end - begin == 2 && edges.runs_upwards(*begin) !=
                                                                edges.runs_upwards(*(begin + 1))));
    for (auto use = begin; use != end; ++use)
      halfedge_of_corner[use->corner] = edges.runs_upwards(*use) ? upward : mesh.opposite(upward);
  });

  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
    const Face face = mesh.add_face();
    const std::size_t first = soup.first[i], end = soup.first[i + 1];
    for (std::size_t k = first; k < end; ++k) {
      const Halfedge h = halfedge_of_corner[k];
      mesh.set_face(h, face);
      mesh.set_next(h, halfedge_of_corner[k + 1 < end ? k + 1 : first]);
      mesh.set_halfedge(mesh.target(h), h);
    }
    mesh.set_halfedge(face, halfedge_of_corner[first]);
  }

  // A border halfedge is followed by the one that leaves its vertex beside the next fan of faces; most
  // vertices at the border have one fan.
  const auto leaving_beside_same_fan = [&](Halfedge h) {
    do
      h = mesh.prev(mesh.opposite(h));
    while (!mesh.is_border(mesh.opposite(h)));
    return mesh.opposite(h);
  };
  std::vector<Halfedge> first_leaving(soup.points.size()), last_arriving(soup.points.size());
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_border(h))
      continue;
    const Vertex v = mesh.target(h);
    const Halfedge leaving = leaving_beside_same_fan(h);
    if (first_leaving[v] == Mesh::null_halfedge())
      first_leaving[v] = leaving;
    else
      mesh.set_next(last_arriving[v], leaving);
    last_arriving[v] = h;
    mesh.set_halfedge(v, h); // a vertex at the border is known by a border halfedge
  }
  for (const Vertex v : mesh.vertices())
    if (last_arriving[v] != Mesh::null_halfedge())
      mesh.set_next(last_arriving[v], first_leaving[v]);
}

#endif // MESH_INPUT_BUILD_MESH_H
