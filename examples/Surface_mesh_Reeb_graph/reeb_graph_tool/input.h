#ifndef REEB_GRAPH_TOOL_INPUT_H
#define REEB_GRAPH_TOOL_INPUT_H

#include "types.h"

#include "../mesh_input/read_mesh.h"
#include "../mesh_input/read_polygon_soup.h"
#include "../mesh_input/text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

// Says what has been done to the mesh of a file, and what of the file has been passed over.
inline void print_findings(std::ostream& out, const std::string& file, const Mesh_input& input)
{
  for (const std::string& notice : input.notices)
    out << file << ": " << notice << '\n';
  for (const Repair& repair : input.repairs)
    out << file << ": " << repair.text << '\n';
}

inline std::vector<double> read_text_values(const std::string& file, const std::string& content)
{
  std::vector<double> values;
  std::string_view rest = content;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    values.emplace_back();
    if (!parse_double(word, values.back()))
      throw File_error(file,
                       "value " + std::to_string(values.size() - 1) + " (" + quoted(word) +
                           ") is not a number");
  }
  return values;
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

// One value for each point of the mesh file. Vertices that have been duplicated share that of their
// point; a vertex that others have been welded to has its own.
inline void
assign_values(const std::vector<double>& numbers, const Mesh_input& input, Value_map values)
{
  for (std::size_t i = 0; i < input.point_of_vertex.size(); ++i)
    values[vertex_descriptor(static_cast<vertex_descriptor::size_type>(i))] =
        numbers[input.point_of_vertex[i]];
}

// Values for the points of the mesh file or, as the tool writes them, for the vertices of the
// repaired mesh.
inline void read_values(const std::string& file, const Mesh_input& input, Value_map values)
{
  const std::string content = read_bytes(file);
  const bool is_binary = std::filesystem::path(file).extension() == ".f64";
  const std::vector<double> numbers =
      is_binary ? read_binary_values(file, content) : read_text_values(file, content);
  const std::size_t vertices = input.point_of_vertex.size();
  if (numbers.size() == input.number_of_points) {
    assign_values(numbers, input, values);
  } else if (numbers.size() == vertices) {
    for (std::size_t i = 0; i < vertices; ++i)
      values[vertex_descriptor(static_cast<vertex_descriptor::size_type>(i))] = numbers[i];
  } else {
    throw File_error(file,
                     "holds " + counted(numbers.size(), "value") + ", but the mesh has " +
                         counted(input.number_of_points, "vertex", "vertices"));
  }
}

// The property of the points that the options ask for.
inline void use_property(const Options& options, const Mesh_input& input, Value_map values)
{
  if (input.has_property) {
    assign_values(input.property, input, values);
    return;
  }
  std::string names;
  for (const std::string& name : input.property_names)
    names += (names.empty() ? "" : ", ") + name;
  throw Usage_error("--values-from-property: the vertices of " + options.mesh_file +
                    " have no property '" + options.values_property + "'; they have " +
                    (names.empty() ? "none" : names));
}

#endif // REEB_GRAPH_TOOL_INPUT_H
