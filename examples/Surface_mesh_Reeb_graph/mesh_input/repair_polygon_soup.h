#ifndef MESH_INPUT_REPAIR_POLYGON_SOUP_H
#define MESH_INPUT_REPAIR_POLYGON_SOUP_H

#include "Polygon_soup.h"

#include <cstddef>
#include <string>
#include <vector>

// What has been changed of a polygon soup.
struct Repair
{
  std::string kind;       // for programs
  std::size_t number = 0; // of the elements that were changed
  std::string text;       // for people
  bool is_wanted = false; // the user has asked for it
};

struct Repair_options
{
  double weld_distance = -1; // points so close are made one; none if it is negative
  bool split_nonmanifold_edges = false;
};

// Makes an oriented 2-manifold of a polygon soup: each edge has one face or two that run along it in
// opposite directions, and the faces around each vertex are one fan, or several that end at the border.
// In this order
// - points are welded, if that is wanted;
// - corners that a face repeats are left out: a face that comes back to a vertex is cut there, and
//   dropped if fewer than three corners remain;
// - faces with the same vertices as an earlier one in the same order are dropped, and those in the
//   opposite order where an edge has more than two faces;
// - edges with more than two faces are split into an edge for each, if that is wanted, and are an
//   error otherwise;
// - faces are turned until neighbors agree, as few as possible of each component; a surface with one
//   side only is an error;
// - each fan of faces around a vertex but the first one gets a vertex of its own, behind all others;
//   but fans that end at the border may stay together at a vertex, since a halfedge structure can link
//   them, unless an edge of the vertex has been split.
// Returns, for each point afterwards, its number before. The time is linear, but for sorting the edges
// of each single vertex. Throws Content_error.
std::vector<std::size_t> repair_polygon_soup(Polygon_soup& soup,
                                             const Repair_options& options,
                                             std::vector<Repair>& repairs);

#endif // MESH_INPUT_REPAIR_POLYGON_SOUP_H
