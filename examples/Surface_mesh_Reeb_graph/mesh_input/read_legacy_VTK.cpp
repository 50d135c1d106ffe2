#include "binary.h"
#include "readers.h"
#include "text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

bool parse_type(std::string_view word, Scalar_type& type)
{
  constexpr std::array<std::pair<std::string_view, Scalar_type>, 14> types = {{
      {"unsigned_char", Scalar_type::UINT8},
      {"char", Scalar_type::INT8},
      {"unsigned_short", Scalar_type::UINT16},
      {"short", Scalar_type::INT16},
      {"unsigned_int", Scalar_type::UINT32},
      {"int", Scalar_type::INT32},
      {"unsigned_long", Scalar_type::UINT64},
      {"long", Scalar_type::INT64},
      {"vtkidtype", Scalar_type::INT32}, // written with 32 bits
      {"vtktypeint64", Scalar_type::INT64},
      {"vtktypeuint64", Scalar_type::UINT64},
      {"float", Scalar_type::FLOAT32},
      {"double", Scalar_type::FLOAT64},
      {"signed_char", Scalar_type::INT8},
  }};
  for (const auto& [name, value] : types) {
    if (equal_ignoring_case(name, word)) {
      type = value;
      return true;
    }
  }
  return false;
}

// Names have spaces and other characters as %20 and the like.
std::string decoded(std::string_view name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    const std::string_view digits = name.substr(i + 1, 2);
    const bool is_code =
        name[i] == '%' && digits.size() == 2 &&
        std::from_chars(digits.data(), digits.data() + 2, code, 16).ptr == digits.data() + 2;
    result += is_code ? static_cast<char>(code) : name[i];
    i += is_code ? 2 : 0;
  }
  return result;
}

class Legacy_VTK_reader
{
public:
  Legacy_VTK_reader(std::string_view bytes, const std::string& property, Polygon_soup& soup)
    : m_bytes(bytes), m_lines(bytes), m_property(property), m_soup(soup)
  {}

  void read()
  {
    read_header();
    for (std::string_view word = next_keyword(); !word.empty(); word = next_keyword())
      read_section(word);
    if (!m_has_points)
      m_lines.fail("the file ends without POINTS");
    check_corners(m_soup);
  }

private:
  static bool is(std::string_view word, std::string_view keyword)
  {
    return equal_ignoring_case(word, keyword);
  }

  void read_header()
  {
    std::string_view line;
    if (!m_lines.next(line) || !begins_with(line, "# vtk DataFile"))
      m_lines.fail("the file does not begin with '# vtk DataFile'");
    m_lines.next(line); // a title
    const std::string_view encoding = next_keyword();
    m_is_binary = is(encoding, "BINARY");
    if (!m_is_binary && !is(encoding, "ASCII"))
      m_lines.fail(quoted(encoding) + " stands where ASCII or BINARY is expected");
    const std::string_view dataset = next_keyword();
    const std::string_view type = next_word(m_line);
    if (!is(dataset, "DATASET") || !is(type, "POLYDATA"))
      m_lines.fail(quoted(std::string(dataset) + ' ' + std::string(type)) +
                   " stands where DATASET POLYDATA is expected");
  }

  void read_section(std::string_view keyword)
  {
    if (is(keyword, "POINTS")) {
      read_points();
    } else if (is(keyword, "POLYGONS")) {
      read_cells("polygon", [&](const std::vector<std::size_t>& cell) { add_polygon(cell); });
    } else if (is(keyword, "TRIANGLE_STRIPS")) {
      read_cells("strip", [&](const std::vector<std::size_t>& cell) { add_strip(cell); });
    } else if (is(keyword, "VERTICES") || is(keyword, "LINES")) {
      m_least_size = 1;
      read_cells("cell", [](const std::vector<std::size_t>&) {});
      m_least_size = 3;
    } else if (is(keyword, "POINT_DATA") || is(keyword, "CELL_DATA")) {
      m_number_of_tuples = read_number("tuples");
      m_is_at_points = is(keyword, "POINT_DATA");
      if (m_is_at_points && m_number_of_tuples != m_soup.points.size())
        m_lines.fail("POINT_DATA has " + std::to_string(m_number_of_tuples) + " tuples for " +
                     counted(m_soup.points.size(), "point"));
    } else if (is(keyword, "METADATA")) {
      skip_metadata();
    } else {
      read_attribute(keyword);
    }
  }

  void read_attribute(std::string_view keyword)
  {
    const std::string name = decoded(next_word(m_line));
    if (is(keyword, "FIELD")) {
      const std::size_t number = read_number("arrays");
      for (std::size_t i = 0; i < number; ++i)
        read_field_array();
    } else if (is(keyword, "SCALARS")) {
      const Scalar_type type = read_type();
      std::size_t components = 1;
      const std::string_view word = next_word(m_line);
      if (!word.empty() && !parse_integer(word, components))
        m_lines.fail(quoted(word) + " stands where the number of components is expected");
      skip_name_of_lookup_table();
      read_array(name, type, components, m_number_of_tuples);
    } else if (is(keyword, "LOOKUP_TABLE")) {
      skip_bytes_or_numbers(4, read_number("colors"));
    } else if (is(keyword, "COLOR_SCALARS")) {
      skip_bytes_or_numbers(read_number("components"), m_number_of_tuples);
    } else if (is(keyword, "TEXTURE_COORDINATES")) {
      const std::size_t components = read_number("components");
      read_array(name, read_type(), components, m_number_of_tuples);
    } else {
      constexpr std::array<std::pair<std::string_view, std::size_t>, 7> keywords = {
          {{"VECTORS", 3},
           {"NORMALS", 3},
           {"TENSORS", 9},
           {"TENSORS6", 6},
           {"GLOBAL_IDS", 1},
           {"PEDIGREE_IDS", 1},
           {"EDGE_FLAGS", 1}}};
      for (const auto& [known, components] : keywords) {
        if (is(keyword, known)) {
          read_array(name, read_type(), components, m_number_of_tuples);
          return;
        }
      }
      m_lines.fail("the keyword " + quoted(keyword) + " is unknown");
    }
  }

  // ---- words and numbers ----

  // Empty at the end of the file.
  std::string_view next_keyword()
  {
    for (;;) {
      const std::string_view word = next_word(m_line);
      if (!word.empty() || !m_lines.next(m_line))
        return word;
    }
  }

  std::size_t read_number(const char* what)
  {
    const std::string_view word = next_word(m_line);
    std::uint64_t number = 0;
    if (!parse_integer(word, number))
      m_lines.fail(quoted(word) + " stands where a number of " + what + " is expected");
    return static_cast<std::size_t>(number);
  }

  Scalar_type read_type()
  {
    const std::string_view word = next_word(m_line);
    Scalar_type type;
    if (!parse_type(word, type))
      m_lines.fail("the type " + quoted(word) + " cannot be read");
    return type;
  }

  void skip_metadata()
  {
    while (m_lines.next(m_line) && !m_line.empty())
      continue;
    m_line = {};
  }

  void skip_name_of_lookup_table()
  {
    const std::string_view keyword = next_keyword();
    if (!is(keyword, "LOOKUP_TABLE"))
      m_lines.fail(quoted(keyword) + " stands where LOOKUP_TABLE is expected");
    next_word(m_line);
  }

  // Calls `read` with the number of each of `number` values, and what reads a value as a double or
  // as an integer. The values begin in the next line.
  template <class Read>
  void read_values(Scalar_type type, std::size_t number, const char* what, const Read& read)
  {
    const std::size_t left = m_lines.rest().size() + m_line.size();
    const std::size_t least = m_is_binary ? size_of(type) : 2;
    if (number > (left + 1) / least)
      m_lines.fail("the file is too short for " + std::to_string(number) + " numbers of " + what);
    if (!m_is_binary) {
      for (std::size_t i = 0; i < number; ++i)
        read(i, [&](auto& value) { parse_next(value, what); });
      return;
    }
    Bytes_in_file bytes(m_bytes, m_bytes.size() - m_lines.rest().size(), true);
    const Element element = {what, 0};
    for (std::size_t i = 0; i < number; ++i)
      read(i, [&](auto& value) {
        if constexpr (std::is_integral_v<std::remove_reference_t<decltype(value)>>)
          value = bytes.integer(type, element);
        else
          value = bytes.number(type, element);
      });
    m_lines.skip(m_lines.rest().size() - bytes.left());
    m_line = {};
  }

  template <class Number>
  void parse_next(Number& number, const char* what)
  {
    const std::string_view word = next_keyword();
    bool is_number;
    if constexpr (std::is_integral_v<Number>)
      is_number = parse_integer(word, number);
    else
      is_number = parse_double(word, number);
    if (!is_number)
      m_lines.fail(word.empty()
                       ? std::string("the file ends within the numbers of ") + what
                       : quoted(word) + " stands where a number of " + what + " is expected");
  }

  // ---- sections ----

  void read_points()
  {
    if (m_has_points)
      m_lines.fail("there are POINTS twice");
    m_has_points = true;
    const std::size_t number = read_number("points");
    const Scalar_type type = read_type();
    if (number > m_bytes.size())
      m_lines.fail("the file is too short for " + std::to_string(number) + " points");
    std::array<double, 3> point = {0, 0, 0};
    read_values(type, 3 * number, "points", [&](std::size_t i, const auto& next) {
      double& coordinate = point[i % 3];
      next(coordinate);
      if (!std::isfinite(coordinate))
        m_lines.fail("point " + std::to_string(i / 3) + " has a coordinate that is not finite");
      if (i % 3 == 2)
        m_soup.points.push_back(point);
    });
  }

  std::vector<std::int64_t> read_integers(Scalar_type type, std::size_t number, const char* what)
  {
    std::vector<std::int64_t> result;
    read_values(type, number, what, [&](std::size_t, const auto& next) {
      result.push_back(0);
      next(result.back());
    });
    return result;
  }

  // Either each cell is its size and its points, or, from version 5 on, the cells are two lists of
  // offsets and of points.
  template <class Add_cell>
  void read_cells(const char* kind, const Add_cell& add_cell)
  {
    const std::size_t number = read_number("cells"), size = read_number("entries");
    const std::string_view line = m_line;
    const Lines lines = m_lines;
    const std::string_view word = m_lines.next(m_line) ? next_word(m_line) : std::string_view();
    std::vector<std::int64_t> offsets, vertices;
    if (is(word, "OFFSETS")) {
      offsets = read_integers(read_type(), number, "offsets");
      const std::string_view keyword = next_keyword();
      if (!is(keyword, "CONNECTIVITY"))
        m_lines.fail(quoted(keyword) + " stands where CONNECTIVITY is expected");
      vertices = read_integers(read_type(), size, kind);
    } else {
      m_line = line;
      m_lines = lines;
      const std::vector<std::int64_t> entries = read_integers(Scalar_type::INT32, size, kind);
      offsets.push_back(0);
      for (std::size_t i = 0; i < entries.size();) {
        const std::int64_t cell_size = entries[i++];
        if (cell_size < 0 || static_cast<std::uint64_t>(cell_size) > entries.size() - i)
          m_lines.fail(Element{kind, offsets.size() - 1}.name() + " has " +
                       std::to_string(cell_size) + " corners, more than the list");
        for (std::int64_t k = 0; k < cell_size; ++k)
          vertices.push_back(entries[i++]);
        offsets.push_back(static_cast<std::int64_t>(vertices.size()));
      }
      if (offsets.size() != number + 1)
        m_lines.fail("there are " + counted(offsets.size() - 1, kind) + " instead of " +
                     std::to_string(number));
    }
    add_cells(kind, offsets, vertices, add_cell);
  }

  template <class Add_cell>
  void add_cells(const char* kind,
                 const std::vector<std::int64_t>& offsets,
                 const std::vector<std::int64_t>& vertices,
                 const Add_cell& add_cell)
  {
    std::vector<std::size_t> cell;
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      const Element name = {kind, i};
      if (offsets[i] < 0 || offsets[i + 1] < offsets[i] ||
          static_cast<std::uint64_t>(offsets[i + 1]) > vertices.size())
        m_lines.fail(name.name() + " has offsets that do not fit");
      const auto begin = static_cast<std::size_t>(offsets[i]),
                 end = static_cast<std::size_t>(offsets[i + 1]);
      if (end - begin < m_least_size)
        m_lines.fail(name.name() + " has " + counted(end - begin, "corner") +
                     "; a face has 3 at least");
      cell.clear();
      for (std::size_t k = begin; k < end; ++k) {
        if (vertices[k] < 0)
          m_lines.fail(no_such_vertex(name, std::to_string(vertices[k]), m_soup.points.size()));
        cell.push_back(static_cast<std::size_t>(vertices[k]));
      }
      add_cell(cell);
    }
  }

  void add_polygon(const std::vector<std::size_t>& cell)
  {
    m_soup.corners.insert(m_soup.corners.end(), cell.begin(), cell.end());
    m_soup.end_polygon();
  }

  // Each triangle of a strip is turned against the one before.
  void add_strip(const std::vector<std::size_t>& cell)
  {
    for (std::size_t k = 2; k < cell.size(); ++k) {
      const std::size_t turn = k % 2;
      add_polygon({cell[k - 2 + turn], cell[k - 1 - turn], cell[k]});
    }
  }

  // ---- arrays ----

  void read_field_array()
  {
    const std::string name = decoded(next_keyword());
    const std::size_t components = read_number("components"), tuples = read_number("tuples");
    read_array(name, read_type(), components, tuples);
  }

  void
  read_array(const std::string& name, Scalar_type type, std::size_t components, std::size_t tuples)
  {
    if (components == 0 || tuples == 0)
      return;
    if (tuples > m_bytes.size() || components > m_bytes.size() / tuples)
      m_lines.fail("the file is too short for the array " + quoted(name));
    const bool is_property = m_is_at_points && components == 1 && tuples == m_soup.points.size();
    const bool is_wanted = is_property && name == m_property && !m_soup.has_property;
    if (is_property)
      m_soup.property_names.push_back(name);
    m_soup.has_property |= is_wanted;
    read_values(type, tuples * components, "the array", [&](std::size_t, const auto& next) {
      double value = 0;
      next(value);
      if (is_wanted)
        m_soup.property.push_back(value);
    });
  }

  // Colors are bytes in binary files, and numbers from 0 to 1 otherwise.
  void skip_bytes_or_numbers(std::size_t components, std::size_t tuples)
  {
    const bool is_at_points = std::exchange(m_is_at_points, false);
    read_array("", Scalar_type::UINT8, components, tuples);
    m_is_at_points = is_at_points;
  }

  std::string_view m_bytes;
  Lines m_lines;
  std::string_view m_line;
  const std::string& m_property;
  Polygon_soup& m_soup;
  bool m_is_binary = false, m_has_points = false, m_is_at_points = false;
  std::size_t m_number_of_tuples = 0;
  std::size_t m_least_size = 3; // of a cell
};

} // namespace

void read_legacy_VTK(std::string_view bytes, const std::string& property, Polygon_soup& soup)
{
  Legacy_VTK_reader(bytes, property, soup).read();
}
