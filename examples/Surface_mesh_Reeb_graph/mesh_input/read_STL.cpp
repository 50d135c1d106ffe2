#include "binary.h"
#include "readers.h"
#include "text.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace {

// The corners of facets are points without numbers.
class Facets
{
  using Point = std::array<double, 3>;

public:
  explicit Facets(Polygon_soup& soup) : m_soup(soup) {}

  void add_corner(Point point)
  {
    for (double& coordinate : point)
      coordinate += 0.; // of the two zeros, which are equal, the positive one
    const auto [position, is_new] = m_numbers.try_emplace(point, m_soup.points.size());
    if (is_new)
      m_soup.points.push_back(point);
    m_soup.corners.push_back(position->second);
  }

private:
  Polygon_soup& m_soup;
  std::unordered_map<Point, std::size_t, boost::hash<Point>> m_numbers;
};

class STL_text_reader
{
public:
  STL_text_reader(std::string_view bytes, Polygon_soup& soup)
    : m_lines(bytes), m_soup(soup), m_facets(soup)
  {}

  // Some files have several solids, and the end of one may be missing. A solid that is left open at
  // the end of the file may be a sign of loss.
  void read()
  {
    bool is_open = false;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (is(word, "solid")) {
        m_line = {}; // the name, which may have any words in it
        is_open = true;
      } else if (is(word, "facet") && is_open) {
        read_facet();
      } else if (is_end("solid", word) && is_open) {
        m_line = {};
        is_open = false;
      } else {
        fail_at(word, is_open ? "'facet' or 'endsolid'" : "'solid'");
      }
    }
    if (is_open)
      m_soup.notices.push_back("the file ends without 'endsolid': it may be incomplete");
  }

private:
  static bool is(std::string_view word, std::string_view keyword)
  {
    return equal_ignoring_case(word, keyword);
  }

  // "endloop" or "end loop"; takes the second word.
  bool is_end(const std::string& what, std::string_view word)
  {
    if (is(word, "end" + what))
      return true;
    std::string_view line = m_line;
    if (!is(word, "end") || !is(next_word(line), what))
      return false;
    m_line = line;
    return true;
  }

  // Empty at the end of the file.
  std::string_view next()
  {
    for (;;) {
      const std::string_view word = next_word(m_line);
      if (!word.empty() || !m_lines.next(m_line))
        return word;
    }
  }

  [[noreturn]] void fail_at(std::string_view word, const std::string& expected) const
  {
    const std::string place = "facet " + std::to_string(m_soup.number_of_polygons()) + ": ";
    if (word.empty())
      m_lines.fail(place + "the file ends where " + expected + " is expected");
    m_lines.fail(place + quoted(word) + " stands where " + expected + " is expected");
  }

  void expect(std::string_view word, const std::string& keyword) const
  {
    if (!is(word, keyword))
      fail_at(word, "'" + keyword + "'");
  }

  void expect_end(const std::string& what)
  {
    const std::string_view word = next();
    if (!is_end(what, word))
      fail_at(word, "'end" + what + "'");
  }

  void read_facet()
  {
    // The normal, which may be anything: it follows from the corners.
    std::string_view word = next();
    for (int i = 0; i < 4 && !is(word, "outer"); ++i)
      word = next();
    expect(word, "outer");
    expect(next(), "loop");
    std::size_t size = 0;
    for (word = next(); is(word, "vertex"); word = next(), ++size)
      m_facets.add_corner(
          read_coordinates(m_lines, m_line, Element{"facet", m_soup.number_of_polygons()}));
    if (!is_end("loop", word))
      fail_at(word, size < 3 ? "'vertex'" : "'endloop'");
    if (size < 3)
      m_lines.fail("facet " + std::to_string(m_soup.number_of_polygons()) + " has " +
                   counted(size, "corner") + "; a facet has 3");
    expect_end("facet");
    m_soup.end_polygon();
  }

  Lines m_lines;
  std::string_view m_line;
  Polygon_soup& m_soup;
  Facets m_facets;
};

constexpr std::size_t header_size = 84; // 80 of any bytes, and the number of facets
constexpr std::size_t facet_size = 50;

std::size_t number_of_binary_facets(std::string_view bytes)
{
  Bytes_in_file header(bytes, 80, false);
  return static_cast<std::size_t>(header.integer(Scalar_type::UINT32, {"facet", 0}));
}

void read_binary(std::string_view bytes, Polygon_soup& soup)
{
  const std::size_t number = number_of_binary_facets(bytes);
  const std::size_t space = (bytes.size() - header_size) / facet_size;
  const std::string says = "the file announces " + counted(number, "facet") + ", but ";
  if (number > space)
    throw Content_error("byte 80: " + says + "has space for " + std::to_string(space) + " only");
  const std::size_t rest = bytes.size() - header_size - number * facet_size;
  if (rest >= facet_size && rest % facet_size == 0)
    throw Content_error("byte 80: " + says + "has space for " + std::to_string(space));
  if (rest > 0)
    soup.notices.push_back(counted(rest, "byte") + " after the last facet were passed over");

  Bytes_in_file facets(bytes, header_size, false);
  Facets corners(soup);
  for (std::size_t i = 0; i < number; ++i) {
    const Element facet = {"facet", i};
    facets.skip(3 * 4, facet); // the normal
    for (int corner = 0; corner < 3; ++corner) {
      std::array<double, 3> point;
      for (double& coordinate : point) {
        coordinate = facets.number(Scalar_type::FLOAT32, facet);
        if (!std::isfinite(coordinate))
          facets.fail(facet.name() + " has a coordinate that is not finite");
      }
      corners.add_corner(point);
    }
    soup.end_polygon();
    facets.skip(2, facet); // some programs write colors here
  }
}

} // namespace

void read_STL(std::string_view bytes, Polygon_soup& soup)
{
  // Binary files may begin with the word solid, too. Text has no zeros, and its bytes 80 to 83 as a
  // number of facets make more than any file has.
  std::string_view text = bytes;
  const std::string_view word = next_word(text);
  const bool has_header = bytes.size() >= header_size;
  const bool has_zero = bytes.substr(0, header_size).find('\0') != bytes.npos;
  if (has_header &&
      (has_zero || bytes.size() == header_size + facet_size * number_of_binary_facets(bytes)))
    read_binary(bytes, soup);
  else if (equal_ignoring_case(word, "solid"))
    STL_text_reader(bytes, soup).read();
  else
    throw Content_error("line 1: the file begins with " + quoted(word) +
                        ", not with 'solid', and has no header of a binary STL file");
  if (soup.points.empty())
    throw Content_error("holds no facets");
}
