#ifndef REEB_GRAPH_TOOL_INPUT_H
#define REEB_GRAPH_TOOL_INPUT_H

#include "types.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// CGAL's readers tell what they dislike on the error stream; the tool says it in one line of its
// own.
class Silence
{
public:
  Silence() : m_buffer(std::cerr.rdbuf(m_nowhere.rdbuf())) {}
  ~Silence() { std::cerr.rdbuf(m_buffer); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  std::ostringstream m_nowhere;
  std::streambuf* m_buffer;
};

struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

// CGAL's reader of OBJ files stops at elements that it does not know, such as lines.
inline bool read_obj(const std::string& file, Polygon_soup& soup)
{
  std::ifstream in(file);
  std::stringstream points_and_faces;
  for (std::string line; std::getline(in, line);)
    if (line.size() > 1 && (line[0] == 'v' || line[0] == 'f') &&
        std::isspace(static_cast<unsigned char>(line[1])))
      points_and_faces << line << '\n';
  return CGAL::IO::read_OBJ(points_and_faces, soup.points, soup.polygons);
}

// What keeps a polygon soup from being a 2-manifold, however its faces are oriented; empty if
// nothing is found.
inline std::string defect_of(const Polygon_soup& soup)
{
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of_edge;
  for (const std::vector<std::size_t>& polygon : soup.polygons) {
    if (std::set<std::size_t>(polygon.begin(), polygon.end()).size() < polygon.size())
      return "a face has the same vertex twice";
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++faces_of_edge[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
  }
  for (const auto& edge : faces_of_edge) {
    if (edge.second > 2) {
      std::ostringstream text;
      text << "the edge between vertices " << edge.first.first << " and " << edge.first.second
           << " has " << edge.second << " faces";
      return text.str();
    }
  }
  return "";
}

// Makes a mesh of a polygon soup whose faces need not be oriented consistently. Returns why that is
// not possible, or nothing.
inline std::string make_mesh(Polygon_soup& soup, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const std::string defect = defect_of(soup);
  if (!defect.empty())
    return defect;
  // it doubles vertices where it cannot do otherwise, and says so
  if (!PMP::orient_polygon_soup(soup.points, soup.polygons))
    return "it has only one side, or several fans of faces meet in a vertex";
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return "";
}

inline Mesh read_mesh(const std::string& file)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error || !std::ifstream(file))
    throw File_error(file, "cannot be opened");
  const std::string type =
      boost::algorithm::to_lower_copy(std::filesystem::path(file).extension().string());
  if (type != ".off" && type != ".obj" && type != ".ply" && type != ".stl")
    throw File_error(file, "is of an unknown type; OFF, OBJ, PLY and STL files can be read");
  if (size == 0)
    throw File_error(file, "is empty");

  Mesh mesh;
  bool is_read = false;
  std::string defect;
  try {
    const Silence silence;
    is_read = CGAL::IO::read_polygon_mesh(file, mesh);
    if (!is_read) {
      mesh.clear();
      Polygon_soup soup;
      is_read = type == ".obj" ? read_obj(file, soup)
                               : CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons);
      if (is_read)
        defect = make_mesh(soup, mesh);
    }
  } catch (const std::exception&) {
    is_read = false; // as any other failure to read
  }
  if (!is_read)
    throw File_error(file,
                     "cannot be read: it is damaged or incomplete, or a coordinate is not a "
                     "finite number");
  if (!defect.empty())
    throw File_error(file, "is not an orientable 2-manifold: " + defect);
  // files of these types do not say how many vertices they have
  if ((type == ".obj" || type == ".stl") && mesh.number_of_vertices() == 0)
    throw File_error(file, "holds no vertices");

  if (!CGAL::is_triangle_mesh(mesh) && !CGAL::Polygon_mesh_processing::triangulate_faces(mesh))
    throw File_error(file, "has a face that cannot be split into triangles");
  return mesh;
}

inline std::vector<double> read_text_values(const std::string& file, const std::string& content)
{
  std::vector<double> values;
  const char* position = content.c_str();
  const char* const end = position + content.size();
  for (;;) {
    while (position != end && std::isspace(static_cast<unsigned char>(*position)))
      ++position;
    if (position == end)
      return values;
    char* rest = nullptr;
    values.push_back(std::strtod(position, &rest));
    if (rest == position || (rest != end && !std::isspace(static_cast<unsigned char>(*rest)))) {
      const char* const word_end = std::find_if(
          position, end, [](unsigned char c) { return std::isspace(c) || !std::isprint(c); });
      throw File_error(file,
                       "value " + std::to_string(values.size() - 1) + " ('" +
                           std::string(position, (std::min)(word_end, position + 20)) +
                           "') is not a number");
    }
    position = rest;
  }
}

inline std::vector<double> read_binary_values(const std::string& file, const std::string& content)
{
  if (content.size() % 8 != 0)
    throw File_error(file, "does not hold a whole number of doubles: it is incomplete");
  std::vector<double> values(content.size() / 8);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t bits = 0;
    for (std::size_t byte = 8; byte-- > 0;)
      bits = bits << 8 | static_cast<unsigned char>(content[8 * i + byte]);
    std::memcpy(&values[i], &bits, 8);
  }
  return values;
}

inline void read_values(const std::string& file, const Mesh& mesh, Value_map values)
{
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  if (!in || std::filesystem::is_directory(file, error))
    throw File_error(file, "cannot be opened");
  const std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const bool is_binary = std::filesystem::path(file).extension() == ".f64";
  const std::vector<double> numbers =
      is_binary ? read_binary_values(file, content) : read_text_values(file, content);
  if (numbers.size() != mesh.number_of_vertices()) {
    std::ostringstream text;
    text << "holds " << numbers.size() << " values, but the mesh has " << mesh.number_of_vertices()
         << " vertices";
    throw File_error(file, text.str());
  }
  std::size_t i = 0;
  for (vertex_descriptor v : mesh.vertices())
    values[v] = numbers[i++];
}

#endif // REEB_GRAPH_TOOL_INPUT_H
