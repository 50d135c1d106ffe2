#include "binary.h"
#include "readers.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

struct PLY_property
{
  std::string name;
  Scalar_type type = Scalar_type::INT8; // of the elements, if it is a list
  bool is_list = false;
  Scalar_type size_type = Scalar_type::INT8;
};

struct PLY_element
{
  std::string name;
  std::size_t number = 0;
  std::vector<PLY_property> properties;

  // The first property of that name; their number if there is none.
  std::size_t position_of(std::string_view property) const
  {
    return static_cast<std::size_t>(
        std::find_if(properties.begin(),
                     properties.end(),
                     [&](const PLY_property& p) { return p.name == property; }) -
        properties.begin());
  }

  bool has(std::string_view property) const { return position_of(property) < properties.size(); }
};

struct PLY_header
{
  bool is_binary = false, is_big_endian = false;
  std::vector<PLY_element> elements;
  std::size_t size = 0; // in bytes
};

bool parse_type(std::string_view word, Scalar_type& type)
{
  constexpr std::array<std::pair<std::string_view, Scalar_type>, 20> types = {{
      {"char", Scalar_type::INT8},      {"int8", Scalar_type::INT8},
      {"uchar", Scalar_type::UINT8},    {"uint8", Scalar_type::UINT8},
      {"short", Scalar_type::INT16},    {"int16", Scalar_type::INT16},
      {"ushort", Scalar_type::UINT16},  {"uint16", Scalar_type::UINT16},
      {"int", Scalar_type::INT32},      {"int32", Scalar_type::INT32},
      {"uint", Scalar_type::UINT32},    {"uint32", Scalar_type::UINT32},
      {"long", Scalar_type::INT64},     {"int64", Scalar_type::INT64},
      {"ulong", Scalar_type::UINT64},   {"uint64", Scalar_type::UINT64},
      {"float", Scalar_type::FLOAT32},  {"float32", Scalar_type::FLOAT32},
      {"double", Scalar_type::FLOAT64}, {"float64", Scalar_type::FLOAT64},
  }};
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == word; });
  if (found != types.end())
    type = found->second;
  return found != types.end();
}

class PLY_header_reader
{
public:
  explicit PLY_header_reader(std::string_view bytes) : m_bytes(bytes), m_lines(bytes) {}

  PLY_header read()
  {
    std::string_view line;
    m_lines.next(line);
    const std::string_view magic = next_word(line);
    if (!equal_ignoring_case(magic, "ply"))
      m_lines.fail("the file begins with " + quoted(magic) + ", not with 'ply'");
    for (;;) {
      if (!m_lines.next(line))
        m_lines.fail("the file ends within its header: there is no 'end_header'");
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header")
        break;
      if (keyword == "format")
        read_format(line);
      else if (keyword == "element")
        read_element(line);
      else if (keyword == "property")
        read_property(line);
      else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
        m_lines.fail("the word " + quoted(keyword) + " is unknown in the header of a PLY file");
    }
    if (!m_has_format)
      m_lines.fail("the header has no line 'format'");
    m_header.size = m_bytes.size() - m_lines.rest().size();
    step_back_to_data();
    return m_header;
  }

private:
  // After lone carriage returns, a line feed is the first byte of the data.
  void step_back_to_data()
  {
    const std::size_t end = m_bytes.find_first_of("\r\n");
    const bool has_lone_returns = m_bytes[end] == '\r' && m_bytes.substr(end, 2) != "\r\n";
    const std::size_t size = m_header.size;
    if (has_lone_returns && m_header.is_binary && m_bytes.substr(size - 2, 2) == "\r\n")
      --m_header.size;
  }

  void read_format(std::string_view line)
  {
    const std::string_view format = next_word(line);
    m_header.is_big_endian = format == "binary_big_endian";
    m_header.is_binary = m_header.is_big_endian || format == "binary_little_endian";
    if (!m_header.is_binary && format != "ascii")
      m_lines.fail("the format " + quoted(format) + " is unknown");
    m_has_format = true;
  }

  void read_element(std::string_view line)
  {
    PLY_element element;
    element.name = next_word(line);
    const std::string_view number = next_word(line);
    std::uint64_t count = 0;
    if (!parse_integer(number, count))
      m_lines.fail("the number " + quoted(number) + " of the element " + quoted(element.name) +
                   " is none");
    element.number = static_cast<std::size_t>(count);
    for (const PLY_element& other : m_header.elements)
      if (other.name == element.name)
        m_lines.fail("there are two elements " + quoted(element.name));
    m_header.elements.push_back(element);
  }

  Scalar_type read_type(std::string_view& line) const
  {
    const std::string_view word = next_word(line);
    Scalar_type type;
    if (!parse_type(word, type))
      m_lines.fail("the type " + quoted(word) + " of a property is unknown");
    return type;
  }

  void read_property(std::string_view line)
  {
    if (m_header.elements.empty())
      m_lines.fail("a property stands before the first element");
    PLY_property property;
    std::string_view rest = line;
    property.is_list = next_word(rest) == "list";
    if (property.is_list) {
      line = rest;
      property.size_type = read_type(line);
      if (!is_integer(property.size_type))
        m_lines.fail("the lengths of a list are no integers");
    }
    property.type = read_type(line);
    property.name = next_word(line);
    if (property.name.empty())
      m_lines.fail("a property has no name");
    PLY_element& element = m_header.elements.back();
    if (element.has(property.name))
      m_lines.fail("the element " + quoted(element.name) + " has two properties " +
                   quoted(property.name));
    element.properties.push_back(property);
  }

  std::string_view m_bytes;
  Lines m_lines;
  PLY_header m_header;
  bool m_has_format = false;
};

// The numbers of a text file. An element may take several lines, and begins with a new one.
class PLY_text
{
public:
  PLY_text(std::string_view file, const PLY_header& header) : m_lines(file)
  {
    const std::size_t end = file.size() - header.size;
    std::string_view line;
    while (m_lines.rest().size() > end && m_lines.next(line))
      continue;
  }

  std::size_t left() const { return m_lines.rest().size() + m_line.size(); }

  // The fewest bytes that an element of so many properties takes.
  std::size_t smallest_size(const PLY_element& element) const
  {
    return 2 * element.properties.size();
  }

  void begin(const Element& element)
  {
    if (!next_word(m_line).empty())
      m_lines.fail("more numbers follow " + m_last.name() +
                   " in its line; here or before, a number is too many or missing");
    m_last = element;
  }

  double number(Scalar_type, const Element& element)
  {
    const std::string_view word = next(element);
    double result = 0;
    if (!parse_double(word, result))
      m_lines.fail(element.name() + ": " + quoted(word) + " is not a number");
    return result;
  }

  std::int64_t integer(Scalar_type, const Element& element)
  {
    const std::string_view word = next(element);
    std::int64_t result = 0;
    if (!parse_integer(word, result))
      m_lines.fail(element.name() + ": " + quoted(word) + " is not an integer");
    return result;
  }

  void skip(Scalar_type, const Element& element) { next(element); }

  void skip(std::size_t number, Scalar_type, const Element& element)
  {
    for (; number > 0; --number)
      next(element);
  }

  [[noreturn]] void fail(const std::string& what) const { m_lines.fail(what); }

  std::string rest()
  {
    std::string_view line = m_line;
    if (next_word(line).empty() && !m_lines.next_with_words(line, '\0'))
      return "";
    return "line " + std::to_string(m_lines.number()) + " and what follows were passed over";
  }

private:
  std::string_view next(const Element& element)
  {
    for (;;) {
      const std::string_view word = next_word(m_line);
      if (!word.empty())
        return word;
      if (!m_lines.next(m_line))
        m_lines.fail("the file ends within " + element.name());
    }
  }

  Lines m_lines;
  std::string_view m_line;
  Element m_last = {"", 0};
};

class PLY_binary
{
public:
  PLY_binary(std::string_view file, const PLY_header& header)
    : m_bytes(file, header.size, header.is_big_endian)
  {}

  std::size_t left() const { return m_bytes.left(); }

  std::size_t smallest_size(const PLY_element& element) const
  {
    std::size_t size = 0;
    for (const PLY_property& property : element.properties)
      size += size_of(property.is_list ? property.size_type : property.type);
    return size;
  }

  void begin(const Element&) {}
  double number(Scalar_type type, const Element& element) { return m_bytes.number(type, element); }
  std::int64_t integer(Scalar_type type, const Element& element)
  {
    return m_bytes.integer(type, element);
  }
  void skip(Scalar_type type, const Element& element) { m_bytes.skip(size_of(type), element); }
  void skip(std::size_t number, Scalar_type type, const Element& element)
  {
    m_bytes.skip_each(number, size_of(type), element);
  }
  [[noreturn]] void fail(const std::string& what) const { m_bytes.fail(what); }

  std::string rest() const
  {
    return left() == 0 ? "" : counted(left(), "byte") + " after the last element were passed over";
  }

private:
  Bytes_in_file m_bytes;
};

// The data behind the header, from text or bytes.
template <class Numbers>
class PLY_reader
{
public:
  PLY_reader(Numbers& numbers,
             const PLY_header& header,
             const std::string& property,
             Polygon_soup& soup)
    : m_numbers(numbers), m_header(header), m_property(property), m_soup(soup)
  {}

  void read()
  {
    bool has_vertices = false;
    for (const PLY_element& element : m_header.elements) {
      if (element.name == "vertex") {
        has_vertices = true;
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        skip(element);
      }
    }
    if (!has_vertices)
      throw Content_error("the header has no element 'vertex'");
    check_corners(m_soup);
    const std::string rest = m_numbers.rest();
    if (!rest.empty())
      m_soup.notices.push_back(rest);
  }

private:
  static constexpr std::size_t nowhere = (std::numeric_limits<std::size_t>::max)();

  static std::size_t list_of_vertices(const PLY_element& element)
  {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
      const std::size_t position = element.position_of(name);
      if (position == element.properties.size() || !element.properties[position].is_list)
        continue;
      if (!is_integer(element.properties[position].type))
        throw Content_error("the header: the numbers in the list " + quoted(name) +
                            " are no integers");
      return position;
    }
    return nowhere;
  }

  void skip_property(const PLY_property& property, const Element& element)
  {
    if (property.is_list)
      m_numbers.skip(read_size(property, element), property.type, element);
    else
      m_numbers.skip(property.type, element);
  }

  // A file may announce any number of elements; what is missing in it is noticed before there are
  // too many of them.
  void check_number(const PLY_element& element) const
  {
    const std::size_t size = m_numbers.smallest_size(element);
    // the last line of a text may end without a line feed
    if (size > 0 && element.number > (m_numbers.left() + 1) / size)
      m_numbers.fail("the file is too short for " + std::to_string(element.number) + " elements '" +
                     element.name + "'");
  }

  void skip(const PLY_element& element)
  {
    if (list_of_vertices(element) != nowhere)
      throw Content_error("the header: the element " + quoted(element.name) +
                          " has lists of vertices, and is unknown; there are face and tristrips");
    if (element.properties.empty())
      return;
    check_number(element);
    for (std::size_t i = 0; i < element.number; ++i) {
      const Element name = {element.name.c_str(), i};
      m_numbers.begin(name);
      for (const PLY_property& property : element.properties)
        skip_property(property, name);
    }
  }

  std::size_t read_size(const PLY_property& property, const Element& element)
  {
    const std::int64_t size = m_numbers.integer(property.size_type, element);
    if (size < 0)
      m_numbers.fail(element.name() + " has a list of length " + std::to_string(size));
    if (static_cast<std::uint64_t>(size) > m_numbers.left())
      m_numbers.fail(element.name() + " has a list of length " + std::to_string(size) +
                     ", more than the file has space for");
    return static_cast<std::size_t>(size);
  }

  void read_vertices(const PLY_element& element)
  {
    // what becomes of each property: 0, 1, 2 are coordinates
    constexpr std::size_t wanted = 3, unwanted = 4;
    std::vector<std::size_t> use(element.properties.size(), unwanted);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PLY_property& property = element.properties[p];
      if (property.is_list)
        continue;
      m_soup.property_names.push_back(property.name);
      if (property.name == m_property)
        use[p] = wanted;
    }
    for (const std::size_t axis : {0u, 1u, 2u}) {
      const std::string name(1, "xyz"[axis]);
      const std::size_t p = element.position_of(name);
      if (p == element.properties.size() || element.properties[p].is_list)
        throw Content_error("the header: the element 'vertex' has no property '" + name + "'");
      if (use[p] == wanted)
        m_wanted = axis;
      use[p] = axis;
    }
    m_soup.has_property = m_wanted < 3 || std::find(use.begin(), use.end(), wanted) != use.end();

    check_number(element);
    m_soup.points.reserve(element.number);
    for (std::size_t i = 0; i < element.number; ++i) {
      const Element vertex = {"vertex", i};
      std::array<double, 4> found = {0, 0, 0, 0};
      m_numbers.begin(vertex);
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (use[p] == unwanted)
          skip_property(element.properties[p], vertex);
        else
          found[use[p]] = m_numbers.number(element.properties[p].type, vertex);
        if (use[p] < wanted && !std::isfinite(found[use[p]]))
          m_numbers.fail(vertex.name() + ": the coordinate " + element.properties[p].name +
                         " is not finite");
      }
      m_soup.points.push_back({found[0], found[1], found[2]});
      if (m_soup.has_property)
        m_soup.property.push_back(found[m_wanted]);
    }
  }

  // Calls `read_list` where the list of vertices of each element is, and passes over the rest.
  template <class Read_list>
  void read_lists(const PLY_element& element, const char* kind, const Read_list& read_list)
  {
    const std::size_t position = list_of_vertices(element);
    if (position == nowhere && element.number > 0)
      throw Content_error("the header: the element " + quoted(element.name) +
                          " has no list 'vertex_indices' of integers");
    check_number(element);
    for (std::size_t i = 0; i < element.number; ++i) {
      const Element name = {kind, i};
      m_numbers.begin(name);
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == position)
          read_list(read_size(element.properties[p], name), element.properties[p].type, name);
        else
          skip_property(element.properties[p], name);
      }
    }
  }

  // The vertices may come later.
  std::size_t read_vertex(Scalar_type type, const Element& element)
  {
    const std::int64_t vertex = m_numbers.integer(type, element);
    if (vertex < 0)
      m_numbers.fail(no_such_vertex(element, std::to_string(vertex), m_soup.points.size()));
    return static_cast<std::size_t>(vertex);
  }

  void read_faces(const PLY_element& element)
  {
    read_lists(element, "face", [&](std::size_t size, Scalar_type type, const Element& face) {
      if (size < 3)
        m_numbers.fail(face.name() + " has " + counted(size, "corner") + "; a face has 3 at least");
      for (std::size_t k = 0; k < size; ++k)
        m_soup.corners.push_back(read_vertex(type, face));
      m_soup.end_polygon();
    });
  }

  // Each vertex of a strip after the second one makes a triangle with the two before it, which are
  // turned every second time. -1 ends a strip. Triangles that have a vertex twice lead the strip to
  // another place, and are none.
  void read_strips(const PLY_element& element)
  {
    read_lists(element, "tristrips", [&](std::size_t size, Scalar_type type, const Element& strip) {
      std::array<std::size_t, 2> last = {0, 0};
      std::size_t length = 0;
      for (std::size_t k = 0; k < size; ++k) {
        const std::int64_t number = m_numbers.integer(type, strip);
        if (number < -1)
          m_numbers.fail(no_such_vertex(strip, std::to_string(number), m_soup.points.size()));
        if (number == -1) {
          length = 0;
          continue;
        }
        const auto vertex = static_cast<std::size_t>(number);
        if (length >= 2 && vertex != last[0] && vertex != last[1] && last[0] != last[1]) {
          const bool is_turned = length % 2 == 1;
          for (const std::size_t corner :
               {last[is_turned ? 1 : 0], last[is_turned ? 0 : 1], vertex})
            m_soup.corners.push_back(corner);
          m_soup.end_polygon();
        }
        last = {last[1], vertex};
        ++length;
      }
    });
  }

  Numbers& m_numbers;
  const PLY_header& m_header;
  const std::string& m_property;
  Polygon_soup& m_soup;
  std::size_t m_wanted = 3; // where the wanted property is among what is read of a vertex
};

} // namespace

void read_PLY(std::string_view bytes, const std::string& property, Polygon_soup& soup)
{
  const PLY_header header = PLY_header_reader(bytes).read();
  if (header.is_binary) {
    PLY_binary numbers(bytes, header);
    PLY_reader<PLY_binary>(numbers, header, property, soup).read();
  } else {
    PLY_text numbers(bytes, header);
    PLY_reader<PLY_text>(numbers, header, property, soup).read();
  }
}
