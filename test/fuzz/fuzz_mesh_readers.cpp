// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a mesh file: a reader says that it is none, or gives a sound polygon soup, whatever
// the repairs make of that.

#include "mesh_file_from_bytes.h"

#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/Edge_uses.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/errors.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/read_polygon_soup.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace {

void check_soup(const Polygon_soup& soup)
{
  for (const auto& point : soup.points)
    for (const double coordinate : point)
      require(std::isfinite(coordinate), "coordinates are finite");
  for (const std::size_t corner : soup.corners)
    require(corner < soup.points.size(), "corners are points");
  require(soup.first.front() == 0 && soup.first.back() == soup.corners.size(),
          "the polygons have all corners");
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    require(soup.first[i] + 3 <= soup.first[i + 1], "polygons have three corners or more");
  require(!soup.has_property || soup.property.size() == soup.points.size(),
          "a property has a value for each point");
}

void check_manifold(const Polygon_soup& soup)
{
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    require(soup.size(i) == 3, "polygons have been split");
  const Edge_uses edges(soup);
  edges.for_each_edge([&](auto begin, auto end) {
    require(end - begin == 1 || (end - begin == 2 &&
                                 edges.runs_upwards(*begin) != edges.runs_upwards(*(begin + 1))),
            "an edge has two faces at most, which agree");
    require(begin->low < begin->high, "an edge has two different vertices");
  });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  const Mesh_file_from_bytes file(data, size);
  try {
    Polygon_soup soup = parse_polygon_soup(file.content, file.extension, file.options.property);
    check_soup(soup);
    Mesh_input input;
    prepare_polygon_soup(soup, file.options, input);
    check_soup(soup);
    check_manifold(soup);
    require(input.point_of_vertex.size() == soup.points.size(), "vertices come from points");
    for (const std::size_t point : input.point_of_vertex)
      require(point < input.number_of_points, "vertices come from points of the file");
  } catch (const Content_error&) {
  }
  return 0;
}
