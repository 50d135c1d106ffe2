#include "write_page.h"

#include "Page_text.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <nlohmann/json.hpp>

#ifdef REEB_GRAPH_TOOL_WITH_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

// Grows when a program that reads the data has to know of a change.
constexpr int version_of_data = 1;

// Coordinates and values are rounded to this many steps.
constexpr double steps = 65535;

struct Interval
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;

  void add(double x)
  {
    if (!std::isfinite(x))
      return;
    lowest = (std::min)(lowest, x);
    highest = (std::max)(highest, x);
  }

  // halves, since the difference of two finite numbers may overflow
  std::uint32_t step(double x) const
  {
    const double half_length = highest / 2 - lowest / 2;
    const double t = half_length > 0 ? (x / 2 - lowest / 2) / half_length : 0;
    return static_cast<std::uint32_t>(std::lround(steps * (std::min)((std::max)(t, 0.), 1.)));
  }

  nlohmann::ordered_json json() const
  {
    if (lowest > highest)
      return {0, 0};
    return {lowest, highest};
  }
};

// Arrays one after the other, with a list of their names, places and lengths.
class Data
{
public:
  // Differences of numbers that are `stride` positions apart, small ones in few bytes: seven bits in
  // each, and one that says whether another byte follows.
  void
  add_integers(const char* name, const std::vector<std::uint32_t>& numbers, std::size_t stride = 1)
  {
    begin_array(name, numbers.size());
    m_arrays.back()["stride"] = stride;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::uint32_t last = i < stride ? 0 : numbers[i - stride];
      const std::uint32_t difference = numbers[i] - last; // modulo 2^32
      // the sign to the lowest bit
      std::uint32_t rest = difference << 1 ^ (difference >> 31 ? 0xffffffff : 0);
      for (; rest >= 0x80; rest >>= 7)
        m_bytes.push_back(static_cast<char>(rest | 0x80));
      m_bytes.push_back(static_cast<char>(rest));
    }
  }

  // Little-endian doubles.
  void add_numbers(const char* name, const std::vector<double>& numbers)
  {
    begin_array(name, numbers.size());
    for (const double number : numbers) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &number, 8);
      for (int byte = 0; byte < 8; ++byte)
        m_bytes.push_back(static_cast<char>(bits >> 8 * byte));
    }
  }

  const nlohmann::ordered_json& arrays() const { return m_arrays; }
  const std::string& bytes() const { return m_bytes; }

private:
  void begin_array(const char* name, std::size_t length)
  {
    m_arrays.push_back({{"name", name}, {"begin", m_bytes.size()}, {"length", length}});
  }

  nlohmann::ordered_json m_arrays = nlohmann::ordered_json::array();
  std::string m_bytes;
};

// `member(item)` of all items.
template <class Items, class Member>
auto column(const Items& items, const Member& member)
{
  std::vector<std::decay_t<decltype(member(items.front()))>> result;
  result.reserve(items.size());
  for (const auto& item : items)
    result.push_back(member(item));
  return result;
}

class Page_writer
{
public:
  explicit Page_writer(const Page& page) : m_page(page)
  {
    for (const Page::Point& p : page.points)
      add_to_box(p);
    for (const Page::Node& node : page.nodes)
      add_to_box(node.place);
    for (const Page::Arc& arc : page.arcs)
      for (const Page::Point& p : arc.points)
        add_to_box(p);
    for (const double value : page.values)
      m_range.add(value);
    for (const Page::Node& node : page.nodes)
      m_range.add(node.value);
  }

  // The header's length in four bytes, the header, the arrays.
  std::string bytes()
  {
    add_picture();
    add_graph();
    const nlohmann::ordered_json box = {m_box[0].json(), m_box[1].json(), m_box[2].json()};
    const nlohmann::ordered_json header = {{"version", version_of_data},
                                           {"generator", "reeb_graph " REEB_GRAPH_TOOL_VERSION},
                                           {"name", m_page.name},
                                           {"function", m_page.function},
                                           {"vertices", m_page.number_of_vertices},
                                           {"faces", m_page.number_of_faces},
                                           {"is_decimated", m_page.is_decimated},
                                           {"is_threshold_absolute", m_page.is_threshold_absolute},
                                           {"is_graph_simplified", m_page.is_graph_simplified},
                                           {"number_of_levels", m_page.number_of_levels},
                                           {"first_stop", m_page.first_stop},
                                           {"box", box},
                                           {"range", m_range.json()},
                                           {"steps", steps},
                                           {"arrays", m_data.arrays()}};
    // names of files may be in any encoding
    const std::string text =
        header.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
    std::string result;
    for (int byte = 0; byte < 4; ++byte)
      result.push_back(static_cast<char>(text.size() >> 8 * byte));
    return result + text + m_data.bytes();
  }

private:
  void add_to_box(const Page::Point& p)
  {
    for (std::size_t i = 0; i < 3; ++i)
      m_box[i].add(p[i]);
  }

  void add_points(const char* name, const std::vector<Page::Point>& points)
  {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(3 * points.size());
    for (const Page::Point& p : points)
      for (std::size_t i = 0; i < 3; ++i)
        numbers.push_back(m_box[i].step(p[i]));
    m_data.add_integers(name, numbers, 3);
  }

  void add_picture()
  {
    add_points("points", m_page.points);
    std::vector<std::uint32_t> corners;
    for (const std::array<std::uint32_t, 3>& triangle : m_page.triangles)
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    m_data.add_integers("triangles", corners);
    m_data.add_integers("values",
                        column(m_page.values, [this](double x) { return m_range.step(x); }));
    m_data.add_integers("vertices", m_page.vertices);
    m_data.add_integers("groups", m_page.groups);
  }

  void add_graph()
  {
    const auto& nodes = m_page.nodes;
    m_data.add_integers("node_vertices", column(nodes, [](auto& node) { return node.vertex; }));
    m_data.add_numbers("node_values", column(nodes, [](auto& node) { return node.value; }));
    m_data.add_integers("node_ends", column(nodes, [](auto& node) { return node.end; }));
    add_points("node_places", column(nodes, [](auto& node) { return node.place; }));
    const auto& arcs = m_page.arcs;
    m_data.add_integers("arc_lowers", column(arcs, [](auto& arc) { return arc.lower; }));
    m_data.add_integers("arc_uppers", column(arcs, [](auto& arc) { return arc.upper; }));
    m_data.add_integers("arc_begins", column(arcs, [](auto& arc) { return arc.begin; }));
    m_data.add_integers("arc_ends", column(arcs, [](auto& arc) { return arc.end; }));
    m_data.add_integers("arc_heirs", column(arcs, [](auto& arc) { return arc.heir; }));
    m_data.add_integers("arc_sizes", column(arcs, [](auto& arc) {
                          return static_cast<std::uint32_t>(arc.points.size());
                        }));
    std::vector<Page::Point> arc_points;
    for (const Page::Arc& arc : arcs)
      arc_points.insert(arc_points.end(), arc.points.begin(), arc.points.end());
    add_points("arc_points", arc_points);
    m_data.add_integers("group_arcs", m_page.arc_of_group);
    const auto& partings = m_page.partings;
    m_data.add_integers("parting_arcs", column(partings, [](auto& p) { return p.arc; }));
    m_data.add_integers("parting_groups", column(partings, [](auto& p) { return p.group; }));
    m_data.add_integers("parting_heirs", column(partings, [](auto& p) { return p.heir; }));
    const auto& stops = m_page.stops;
    m_data.add_numbers("stop_lowers", column(stops, [](auto& stop) { return stop.lower; }));
    m_data.add_numbers("stop_uppers", column(stops, [](auto& stop) { return stop.upper; }));
    m_data.add_integers("stop_levels", column(stops, [](auto& stop) { return stop.level; }));
    const auto& pairs = m_page.pairs;
    m_data.add_integers("pair_kinds", column(pairs, [](auto& pair) { return pair.kind; }));
    m_data.add_integers("pair_births", column(pairs, [](auto& pair) { return pair.birth; }));
    m_data.add_integers("pair_deaths", column(pairs, [](auto& pair) { return pair.death; }));
    m_data.add_numbers("pair_persistences",
                       column(pairs, [](auto& pair) { return pair.persistence; }));
  }

  const Page& m_page;
  std::array<Interval, 3> m_box;
  Interval m_range;
  Data m_data;
};

#ifdef REEB_GRAPH_TOOL_WITH_ZLIB
constexpr const char* encoding = "deflate";

std::string encoded(const std::string& bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()),
                &size,
                reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot compress the data of the page");
  result.resize(size);
  return result;
}
#else
constexpr const char* encoding = "none";

std::string encoded(std::string bytes)
{
  return bytes;
}
#endif

void write_base64(std::ostream& out, std::string bytes)
{
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string text(Base64(bytes.cbegin()), Base64(bytes.cend()));
  std::fill(text.end() - static_cast<std::ptrdiff_t>(padding), text.end(), '=');
  out << text;
}

} // namespace

const char* const how_to_get_page =
    "this build of the tool has no HTML page: it needs npm when the tool is built (Debian: apt "
    "install npm; then run CMake again, and build)";

bool has_page()
{
  return !page_text().before_data.empty();
}

void write_page(std::ostream& out, const Page& page)
{
  for (const std::string_view piece : page_text().before_data)
    out << piece;
  out << encoding << ';';
  write_base64(out, encoded(Page_writer(page).bytes()));
  for (const std::string_view piece : page_text().after_data)
    out << piece;
}
