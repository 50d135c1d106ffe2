#include "prepare_polygon_soup.h"

#include "errors.h"
#include "read_polygon_soup.h"
#include "split_polygons.h"
#include "text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

void check_strictly(const Mesh_input& input)
{
  std::vector<std::string> findings = input.notices;
  for (const Repair& repair : input.repairs)
    if (!repair.is_wanted)
      findings.push_back(repair.text);
  if (findings.empty())
    return;
  std::string text = findings[0];
  for (std::size_t i = 1; i < findings.size(); ++i)
    text += "; " + findings[i];
  throw Content_error("is refused by --strict, without which this would be done: " + text);
}

// Meshes number their elements with 32 bits.
void check_size(const Polygon_soup& soup)
{
  constexpr std::size_t largest = (std::numeric_limits<std::uint32_t>::max)() - 1;
  if (soup.points.size() > largest || soup.corners.size() > largest / 2)
    throw Content_error("has too many elements: there can be 2 ^ 32 halfedges");
}

} // namespace

void prepare_polygon_soup(Polygon_soup& soup, const Mesh_input_options& options, Mesh_input& input)
{
  check_size(soup);
  input.number_of_points = soup.points.size();
  input.has_property = std::exchange(soup.has_property, false);
  input.property.swap(soup.property);
  input.property_names.swap(soup.property_names);
  input.notices.swap(soup.notices);
  input.point_of_vertex = repair_polygon_soup(soup, options.repair, input.repairs);
  split_polygons(soup);
  check_size(soup);
  if (soup.points.empty())
    input.notices.push_back("there are no vertices: the mesh is empty");
  else if (soup.number_of_polygons() == 0)
    input.notices.push_back(
        "there are no faces: " + counted(soup.points.size(), "vertex is", "vertices are") +
        " all that the mesh has");
  if (options.is_strict)
    check_strictly(input);
}

Polygon_soup read_repaired_triangles(const std::string& file,
                                     const Mesh_input_options& options,
                                     Mesh_input& input)
{
  Polygon_soup soup = read_polygon_soup(file, options.property);
  try {
    prepare_polygon_soup(soup, options, input);
  } catch (const Content_error& error) {
    throw File_error(file, error.what());
  }
  return soup;
}

Polygon_soup parse_repaired_triangles(const std::string& bytes,
                                      const std::string& extension,
                                      const Mesh_input_options& options,
                                      Mesh_input& input)
{
  Polygon_soup soup = parse_polygon_soup(bytes, extension, options.property);
  prepare_polygon_soup(soup, options, input);
  return soup;
}
