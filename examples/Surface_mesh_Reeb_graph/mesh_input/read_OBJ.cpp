#include "readers.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace {

// Elements whose words are names, for which a backslash may be the end of a folder, and comments.
bool has_names(std::string_view keyword)
{
  constexpr std::array<std::string_view, 8> keywords = {
      "g", "o", "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj"};
  return keyword[0] == '#' ||
         std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// What says nothing of the faces, and what is no face: attributes, groups, materials, display; points
// and lines.
bool is_known(std::string_view keyword)
{
  constexpr std::array<std::string_view, 14> keywords = {"vt",
                                                         "vn",
                                                         "vp",
                                                         "s",
                                                         "mg",
                                                         "p",
                                                         "l",
                                                         "bevel",
                                                         "c_interp",
                                                         "d_interp",
                                                         "lod",
                                                         "end",
                                                         "call",
                                                         "csh"};
  return has_names(keyword) ||
         std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// A capital letter, or no space after the letter: something would be lost.
bool looks_like_vertex_or_face(std::string_view keyword)
{
  const char letter = to_lower(keyword[0]), next = keyword.size() > 1 ? to_lower(keyword[1]) : ' ';
  return (letter == 'v' || letter == 'f') && (next < 'a' || next > 'z');
}

class OBJ_reader
{
public:
  OBJ_reader(std::string_view bytes, Polygon_soup& soup) : m_lines(bytes), m_soup(soup) {}

  void read()
  {
    std::string_view line;
    while (m_lines.next(line)) {
      std::string_view rest = line;
      const std::string_view keyword = next_word(rest);
      if (keyword.empty())
        continue;
      if (!has_names(keyword) && is_continued(line)) {
        // the pieces are no longer one piece of the file
        const std::string whole = join(line);
        read_element(whole);
      } else {
        read_element(line);
      }
    }
    check_corners();
    if (m_unknown > 0)
      m_soup.notices.push_back(counted(m_unknown, "line") + " with unknown words, such as " +
                               m_unknown_example + ", " + (m_unknown == 1 ? "was" : "were") +
                               " passed over");
  }

private:
  static bool is_continued(std::string_view line)
  {
    while (!line.empty() && is_blank(line.back()))
      line.remove_suffix(1);
    return !line.empty() && line.back() == '\\' && line.find('#') == line.npos;
  }

  // The line and those that continue it.
  std::string join(std::string_view line)
  {
    std::string whole;
    for (;;) {
      const bool goes_on = is_continued(line);
      whole.append(line.substr(0, goes_on ? line.rfind('\\') : line.size())) += ' ';
      if (!goes_on || !m_lines.next(line))
        return whole;
    }
  }

  void read_element(std::string_view line)
  {
    line = line.substr(0, line.find('#'));
    const std::string_view keyword = next_word(line);
    if (keyword.empty())
      return;
    if (keyword == "v") {
      m_soup.points.push_back(
          read_coordinates(m_lines, line, Element{"vertex", m_soup.points.size()}));
    } else if (keyword == "f" || keyword == "fo") {
      read_face(line);
    } else if (!is_known(keyword)) {
      if (looks_like_vertex_or_face(keyword))
        m_lines.fail("the element " + quoted(keyword) + " is unknown; there are v and f");
      if (m_unknown++ == 0)
        m_unknown_example = quoted(keyword) + " in line " + std::to_string(m_lines.number());
    }
  }

  void read_face(std::string_view line)
  {
    const Element face = {"face", m_soup.number_of_polygons()};
    std::size_t size = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++size)
      m_soup.corners.push_back(parse_corner(word, face));
    if (size < 3)
      m_lines.fail(face.name() + " has " + counted(size, "corner") + "; a face has 3 at least");
    m_soup.end_polygon();
  }

  // "7", "7/1", "7/1/2" or "7//2". Numbers of vertices count from 1 on, or backwards from the last
  // vertex so far, which is -1. Vertices may follow the face that has them.
  std::size_t parse_corner(std::string_view word, const Element& face)
  {
    const std::string_view number_word = word.substr(0, word.find('/'));
    const std::string_view attributes = word.substr(number_word.size());
    std::int64_t number = 0;
    if (!parse_integer(number_word, number) ||
        attributes.find_first_not_of("0123456789-/") != attributes.npos)
      m_lines.fail(face.name() + ": " + quoted(word) + " is not the number of a vertex");
    if (number == 0)
      m_lines.fail(face.name() + ": there is no vertex 0; vertices are numbered from 1");
    const std::size_t so_far = m_soup.points.size();
    if (number > 0) {
      const auto vertex = static_cast<std::size_t>(number) - 1;
      if (m_soup.corners.empty() || vertex > m_largest) {
        m_largest = vertex;
        m_line_of_largest = m_lines.number();
      }
      return vertex;
    }
    const std::size_t back = std::size_t(0) - static_cast<std::size_t>(number);
    if (back > so_far)
      m_lines.fail(face.name() + ": the vertex " + std::to_string(number) + " counts back from " +
                   counted(so_far, "vertex", "vertices") + " so far");
    return so_far - back;
  }

  void check_corners() const
  {
    if (m_line_of_largest > 0 && m_largest >= m_soup.points.size())
      throw Content_error("line " + std::to_string(m_line_of_largest) + ": there is no vertex " +
                          std::to_string(m_largest + 1) + "; there are " +
                          std::to_string(m_soup.points.size()) + ", numbered from 1");
  }

  Lines m_lines;
  Polygon_soup& m_soup;
  std::size_t m_largest = 0, m_line_of_largest = 0;
  std::size_t m_unknown = 0;
  std::string m_unknown_example;
};

} // namespace

void read_OBJ(std::string_view bytes, Polygon_soup& soup)
{
  OBJ_reader(bytes, soup).read();
  if (soup.points.empty())
    throw Content_error("holds no vertices");
}
