#include "binary.h"
#include "readers.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct OFF_header
{
  bool is_binary = false, has_texture = false, has_color = false, has_normal = false,
       has_denominator = false;
  std::size_t vertices = 0, faces = 0;
};

// The letters before OFF. Returns false if they have no meaning.
bool parse_prefix(std::string_view prefix, OFF_header& header)
{
  if (begins_with(prefix, "ST")) {
    header.has_texture = true;
    prefix.remove_prefix(2);
  }
  for (const char c : prefix) {
    bool& flag = c == 'C'   ? header.has_color
                 : c == 'N' ? header.has_normal
                            : header.has_denominator;
    if ((c != 'C' && c != 'N' && c != '4') || flag)
      return false;
    flag = true;
  }
  return true;
}

std::size_t parse_count(const Lines& lines, std::string_view word, const std::string& what)
{
  std::uint64_t count = 0;
  if (!parse_integer(word, count))
    lines.fail(quoted(word) + " stands where the number of " + what + " is expected");
  return static_cast<std::size_t>(count);
}

// Both numbers need not be in one line, and may follow the word OFF even without a space, as in the
// files of ModelNet. The number of edges is of no use, and often left out.
void read_counts(Lines& lines, std::string_view line, OFF_header& header)
{
  std::array<std::string_view, 2> words;
  for (std::size_t i = 0; i < 2; ++i) {
    while ((words[i] = next_word(line)).empty())
      if (!lines.next_with_words(line, '#'))
        lines.fail("the file ends before its numbers of vertices and faces");
  }
  header.vertices = parse_count(lines, words[0], "vertices");
  header.faces = parse_count(lines, words[1], "faces");
}

OFF_header read_header(Lines& lines)
{
  OFF_header header;
  std::string_view line;
  if (!lines.next_with_words(line, '#'))
    throw Content_error("holds nothing but comments");
  std::string_view rest = line;
  const std::string_view word = next_word(rest);
  std::size_t OFF = word.find("OFF");
  if (OFF == word.npos && equal_ignoring_case(word, "off"))
    OFF = 0;
  std::uint64_t count = 0;
  if (OFF == word.npos) {
    if (!parse_integer(word, count)) // the word OFF may be missing
      lines.fail("the file begins with " + quoted(word) + ", not with OFF");
  } else {
    if (!word.substr(0, OFF).empty() && word[OFF - 1] == 'n')
      lines.fail(quoted(word) + ": surfaces of other dimensions than 3 cannot be read");
    if (!parse_prefix(word.substr(0, OFF), header))
      lines.fail("the file begins with " + quoted(word) + ", not with OFF");
    std::string_view after_word = rest;
    header.is_binary = next_word(after_word) == "BINARY";
    if (header.is_binary)
      return header;
    line.remove_prefix(static_cast<std::size_t>(word.data() - line.data()) + OFF + 3);
  }
  read_counts(lines, line, header);
  return header;
}

void add_vertex(const std::array<double, 3>& point,
                double denominator,
                const Element& vertex,
                Polygon_soup& soup)
{
  std::array<double, 3> scaled = point;
  for (double& coordinate : scaled) {
    coordinate /= denominator;
    if (!std::isfinite(coordinate))
      throw Content_error(vertex.name() + " is not a finite point");
  }
  soup.points.push_back(scaled);
}

void read_text_vertices(Lines& lines, const OFF_header& header, Polygon_soup& soup)
{
  constexpr std::size_t shortest_line = 6; // "0 0 0\n"
  soup.points.reserve((std::min)(header.vertices, lines.rest().size() / shortest_line + 1));
  for (std::size_t i = 0; i < header.vertices; ++i) {
    std::string_view line;
    const Element vertex = {"vertex", i};
    if (!lines.next_with_words(line, '#'))
      lines.fail("the file ends before " + vertex.name() + " of " +
                 std::to_string(header.vertices));
    const std::array<double, 3> point = read_coordinates(lines, line, vertex);
    double denominator = 1;
    if (header.has_denominator && !parse_double(next_word(line), denominator))
      lines.fail(vertex.name() + " has no fourth coordinate");
    add_vertex(point, denominator, vertex, soup);
  }
}

void read_text_faces(Lines& lines, const OFF_header& header, Polygon_soup& soup)
{
  for (std::size_t i = 0; i < header.faces; ++i) {
    std::string_view line;
    const Element face = {"face", i};
    if (!lines.next_with_words(line, '#'))
      lines.fail("the file ends before " + face.name() + " of " + std::to_string(header.faces));
    const std::string_view size_word = next_word(line);
    std::uint64_t size = 0;
    if (!parse_integer(size_word, size))
      lines.fail(face.name() + ": " + quoted(size_word) + " is not a number of corners");
    if (size < 3)
      lines.fail(face.name() + " has " + counted(size, "corner") + "; a face has 3 at least");
    for (std::uint64_t k = 0; k < size; ++k) {
      const std::string_view word = next_word(line);
      if (word.empty())
        lines.fail(face.name() + " has " + counted(k, "corner") + " instead of " +
                   std::to_string(size));
      std::size_t vertex = 0;
      if (!parse_integer(word, vertex) || vertex >= soup.points.size())
        lines.fail(no_such_vertex(face, quoted(word), soup.points.size()));
      soup.corners.push_back(vertex);
    }
    soup.end_polygon();
  }
}

std::size_t read_binary_count(Bytes_in_file& bytes, const char* what)
{
  const std::int64_t count = bytes.integer(Scalar_type::INT32, {what, 0});
  if (count < 0)
    bytes.fail(std::string("the number of ") + what + " is negative");
  return static_cast<std::size_t>(count);
}

void read_binary_vertices(Bytes_in_file& bytes, const OFF_header& header, Polygon_soup& soup)
{
  const std::size_t attributes =
      (header.has_normal ? 3u : 0u) + (header.has_color ? 4u : 0u) + (header.has_texture ? 2u : 0u);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    const Element vertex = {"vertex", i};
    std::array<double, 3> point;
    for (double& coordinate : point)
      coordinate = bytes.number(Scalar_type::FLOAT32, vertex);
    const double denominator =
        header.has_denominator ? bytes.number(Scalar_type::FLOAT32, vertex) : 1;
    bytes.skip_each(attributes, 4, vertex);
    add_vertex(point, denominator, vertex, soup);
  }
}

void read_binary_faces(Bytes_in_file& bytes, const OFF_header& header, Polygon_soup& soup)
{
  for (std::size_t i = 0; i < header.faces; ++i) {
    const Element face = {"face", i};
    const std::int64_t size = bytes.integer(Scalar_type::INT32, face);
    if (size < 3)
      bytes.fail(face.name() + " has " + std::to_string(size) + " corners; a face has 3 at least");
    for (std::int64_t k = 0; k < size; ++k) {
      const std::int64_t vertex = bytes.integer(Scalar_type::INT32, face);
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= soup.points.size())
        bytes.fail(no_such_vertex(face, std::to_string(vertex), soup.points.size()));
      soup.corners.push_back(static_cast<std::size_t>(vertex));
    }
    soup.end_polygon();
    const std::int64_t colors = bytes.integer(Scalar_type::INT32, face);
    if (colors < 0)
      bytes.fail(face.name() + " has a negative number of colors");
    bytes.skip_each(static_cast<std::size_t>(colors), 4, face);
  }
}

} // namespace

void read_OFF(std::string_view bytes, Polygon_soup& soup)
{
  Lines lines(bytes);
  OFF_header header = read_header(lines);
  if (header.is_binary) {
    Bytes_in_file rest(bytes, bytes.size() - lines.rest().size(), true);
    header.vertices = read_binary_count(rest, "vertices");
    header.faces = read_binary_count(rest, "faces");
    read_binary_count(rest, "edges");
    read_binary_vertices(rest, header, soup);
    read_binary_faces(rest, header, soup);
    if (rest.left() > 0)
      soup.notices.push_back(counted(rest.left(), "byte") +
                             " after the last face were passed over");
    return;
  }
  read_text_vertices(lines, header, soup);
  read_text_faces(lines, header, soup);
  std::string_view line;
  if (lines.next_with_words(line, '#'))
    soup.notices.push_back("line " + std::to_string(lines.number()) +
                           " and what follows were passed over: the file announces " +
                           counted(header.faces, "face") + " only");
}
