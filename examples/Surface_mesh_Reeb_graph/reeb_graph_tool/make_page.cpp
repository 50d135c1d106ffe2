#include "make_page.h"

#include "Graph_recorder.h"
#include "cluster_vertices.h"

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph_hierarchy.h>
#include <CGAL/Surface_mesh_Reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_Reeb_graph/arc_polyline.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_gap.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/connected_components.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

// More vertices are not drawn fluently everywhere.
constexpr std::size_t largest_picture = 100000;

vertex_descriptor vertex(std::size_t i)
{
  return vertex_descriptor(static_cast<vertex_descriptor::size_type>(i));
}

Page::Point place_of(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

std::string name_of_function(const Options& options)
{
  if (!options.values_property.empty())
    return options.values_property;
  return options.values_file.empty()
             ? options.function
             : std::filesystem::path(options.values_file).filename().string();
}

// Where vertices of the mesh lie among the nodes of a graph.
class Node_order
{
public:
  Node_order(const Result& result, const Graph& graph)
    : m_order(result.mesh, result.values, get(boost::vertex_index, result.mesh))
  {
    for (const auto node : boost::make_iterator_range(vertices(graph)))
      m_nodes.push_back(graph[node].vertex);
  }

  bool is_below(vertex_descriptor u, vertex_descriptor v) const { return m_order(u, v); }

  std::uint32_t number_below(vertex_descriptor v) const
  {
    return static_cast<std::uint32_t>(std::lower_bound(m_nodes.begin(), m_nodes.end(), v, m_order) -
                                      m_nodes.begin());
  }

  // `v` itself counts, too, if it is a node.
  std::uint32_t number_not_above(vertex_descriptor v) const
  {
    return static_cast<std::uint32_t>(std::upper_bound(m_nodes.begin(), m_nodes.end(), v, m_order) -
                                      m_nodes.begin());
  }

private:
  using Index_map = decltype(get(boost::vertex_index, std::declval<const Mesh&>()));

  SMRG::Vertex_order<Mesh, Value_map, Index_map> m_order;
  std::vector<vertex_descriptor> m_nodes;
};

// The groups of the picture's vertices.
struct Vertex_groups
{
  std::vector<std::uint32_t> number_of_nodes_below;
  std::vector<std::vector<std::uint32_t>> vertices; // positions in the picture, from below

  Vertex_groups(Page& page, const Finest_graph& finest, const Node_order& order)
  {
    std::vector<std::uint32_t> lower_node;
    for (const auto arc : boost::make_iterator_range(edges(finest.graph)))
      lower_node.push_back(static_cast<std::uint32_t>(lower_node_of(arc, finest.graph)));
    using Key = std::tuple<int, std::uint32_t, std::uint32_t>; // arc, nodes below, vertex
    std::vector<Key> keys;
    for (std::uint32_t i = 0; i < page.vertices.size(); ++i) {
      const vertex_descriptor v = vertex(page.vertices[i]);
      const int arc = finest.arcs[page.vertices[i]];
      if (arc < 0)
        continue;
      // the vertex of a node lies just above it if its arc begins there, else just below
      const bool is_above = finest.graph[lower_node[static_cast<std::size_t>(arc)]].vertex == v;
      keys.emplace_back(arc, is_above ? order.number_not_above(v) : order.number_below(v), i);
    }
    std::sort(keys.begin(), keys.end());
    page.groups.assign(page.vertices.size(), Page::none);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto& [arc, number_below, v] = keys[i];
      if (i == 0 || std::get<0>(keys[i - 1]) != arc || std::get<1>(keys[i - 1]) != number_below) {
        arcs.push_back(arc);
        number_of_nodes_below.push_back(number_below);
        vertices.emplace_back();
      }
      page.groups[v] = static_cast<std::uint32_t>(vertices.size() - 1);
      vertices.back().push_back(v);
    }
  }

  std::vector<int> arcs;

private:
  static std::size_t lower_node_of(Graph::edge_descriptor arc, const Graph& graph)
  {
    return graph[SMRG::lower_node(arc, graph)].id;
  }
};

// Simplifies a graph as simplify_Reeb_graph() does it, with one vertex instead of each group. A mesh
// without faces has all that matters: the nodes, and the groups between them.
class Level_maker
{
public:
  Level_maker(const Graph& graph, const Vertex_groups& groups, bool is_threshold_absolute)
    : m_is_threshold_absolute(is_threshold_absolute)
  {
    m_values = m_mesh.add_property_map<vertex_descriptor, double>("v:value").first;
    m_arcs = m_mesh.add_property_map<vertex_descriptor, int>("v:arc", -1).first;
    std::vector<std::uint32_t> sorted(groups.vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::stable_sort(sorted.begin(), sorted.end(), [&](std::uint32_t g, std::uint32_t h) {
      return groups.number_of_nodes_below[g] < groups.number_of_nodes_below[h];
    });
    m_vertices.resize(sorted.size());
    auto next_group = sorted.begin();
    const auto add_groups = [&](std::size_t number_of_nodes_below, double value) {
      for (; next_group != sorted.end() &&
             groups.number_of_nodes_below[*next_group] == number_of_nodes_below;
           ++next_group)
      {
        m_vertices[*next_group] = add_vertex(value, Page::none);
        m_arc_of_group.push_back({*next_group, groups.arcs[*next_group]});
      }
    };
    m_graph = graph;
    for (std::size_t i = 0; i < num_vertices(graph); ++i) {
      // vertices of equal value are ordered by their numbers
      m_graph[i].vertex = add_vertex(graph[i].value, static_cast<std::uint32_t>(i));
      add_groups(i + 1, graph[i].value);
    }
    CGAL_assertion(next_group == sorted.end());
  }

  Graph_recorder::Snapshot level(double threshold) const
  {
    Graph graph = m_graph;
    Arc_map arcs = m_arcs;
    for (const auto& [group, arc] : m_arc_of_group)
      arcs[m_vertices[group]] = arc;
    SMRG::simplify_Reeb_graph(m_mesh,
                              m_values,
                              graph,
                              SMRG::parameters::persistence_threshold(threshold)
                                  .threshold_is_absolute(m_is_threshold_absolute)
                                  .vertex_arc_map(arcs));
    Graph_recorder::Snapshot result;
    for (const auto node : boost::make_iterator_range(vertices(graph)))
      result.nodes.push_back(m_node[graph[node].vertex]);
    for (const auto arc : boost::make_iterator_range(edges(graph)))
      result.arcs.emplace_back(m_node[graph[SMRG::lower_node(arc, graph)].vertex],
                               m_node[graph[SMRG::upper_node(arc, graph)].vertex]);
    for (const vertex_descriptor v : m_vertices)
      result.arc_of_group.push_back(static_cast<std::uint32_t>(arcs[v]));
    return result;
  }

private:
  vertex_descriptor add_vertex(double value, std::uint32_t node)
  {
    const vertex_descriptor v = m_mesh.add_vertex();
    m_values[v] = value;
    m_node.push_back(node);
    return v;
  }

  bool m_is_threshold_absolute;
  Mesh m_mesh;
  Value_map m_values;
  Arc_map m_arcs;
  Graph m_graph;
  std::vector<std::uint32_t> m_node; // by vertex; none for groups
  std::vector<vertex_descriptor> m_vertices;
  std::vector<std::pair<std::uint32_t, int>> m_arc_of_group;
};

// All levels if there are not too many; else all of the coarse ones, and ever fewer of the finer ones.
std::set<std::size_t> levels_to_show(std::size_t number_of_levels, std::size_t limit)
{
  std::set<std::size_t> levels = {0};
  const std::size_t number_of_coarse_levels = limit / 2;
  const double growth = std::pow(static_cast<double>(number_of_levels), 2. / double(limit));
  double number_left = 0; // of levels that are coarser
  while (number_left < double(number_of_levels)) {
    levels.insert(number_of_levels - 1 - static_cast<std::size_t>(number_left));
    const bool is_coarse =
        number_of_levels <= limit || number_left < double(number_of_coarse_levels);
    number_left = is_coarse ? number_left + 1 : (std::max)(number_left + 1, number_left * growth);
  }
  return levels;
}

// Half the range of the finite values of every node's component, which fractions are meant of. It is
// not positive if there is none. (Halves, since the difference of two finite numbers may overflow.)
std::vector<double> half_ranges_of_nodes(const Graph& graph)
{
  std::vector<int> component(num_vertices(graph));
  const auto number =
      static_cast<std::size_t>(boost::connected_components(graph, component.data()));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> lowest(number, infinity), highest(number, -infinity);
  for (const auto node : boost::make_iterator_range(vertices(graph))) {
    const auto c = static_cast<std::size_t>(component[node]);
    if (std::isfinite(graph[node].value)) {
      lowest[c] = (std::min)(lowest[c], graph[node].value);
      highest[c] = (std::max)(highest[c], graph[node].value);
    }
  }
  std::vector<double> result;
  for (const int c : component)
    result.push_back(highest[static_cast<std::size_t>(c)] / 2 -
                     lowest[static_cast<std::size_t>(c)] / 2);
  return result;
}

class Page_maker
{
public:
  Page_maker(const Options& options,
             const Result& result,
             const Finest_graph& finest,
             Progress& progress)
    : m_options(options)
    , m_result(result)
    , m_finest(finest)
    , m_progress(progress)
    , m_order(result, finest.graph)
  {}

  Page run()
  {
    m_page.name = std::filesystem::path(m_options.mesh_file).filename().string();
    m_page.function = name_of_function(m_options);
    m_page.number_of_vertices = m_result.mesh.number_of_vertices();
    m_page.number_of_faces = m_result.mesh.number_of_faces();
    m_page.is_threshold_absolute = m_options.threshold_is_absolute;
    add_picture();
    add_nodes();
    add_levels();
    add_pairs();
    return std::move(m_page);
  }

private:
  using Hierarchy = SMRG::Reeb_graph_hierarchy<Graph>;

  // The one that result.graph has been made with.
  double threshold() const
  {
    if (is_simplified_before_levels(m_options))
      return 0;
    if (m_options.gap == 0)
      return m_options.simplify;
    return SMRG::persistence_gap(
               m_finest.graph,
               static_cast<std::size_t>(m_options.gap),
               SMRG::parameters::threshold_is_absolute(m_options.threshold_is_absolute))
        .threshold;
  }

  void add_picture()
  {
    for (const vertex_descriptor v : m_result.mesh.vertices()) {
      m_page.points.push_back(place_of(m_result.mesh.point(v)));
      m_page.vertices.push_back(static_cast<std::uint32_t>(v));
      m_page.values.push_back(m_result.values[v]);
    }
    for (const auto f : m_result.mesh.faces()) {
      std::array<std::uint32_t, 3> triangle;
      auto corner = triangle.begin();
      for (const vertex_descriptor v :
           CGAL::vertices_around_face(m_result.mesh.halfedge(f), m_result.mesh))
        *corner++ = static_cast<std::uint32_t>(v);
      m_page.triangles.push_back(triangle);
    }
    m_page.groups.assign(m_page.vertices.size(), Page::none);
    cluster_vertices(m_page, largest_picture);
  }

  void add_nodes()
  {
    const Graph& graph = m_finest.graph;
    for (const auto node : boost::make_iterator_range(vertices(graph)))
      m_page.nodes.push_back({static_cast<std::uint32_t>(graph[node].vertex),
                              graph[node].value,
                              place_of(m_result.mesh.point(graph[node].vertex)),
                              Page::none});
  }

  void add_levels()
  {
    const Vertex_groups groups(m_page, m_finest, m_order);
    const Level_maker maker(m_finest.graph, groups, m_options.threshold_is_absolute);
    const Hierarchy hierarchy(
        m_finest.graph, SMRG::parameters::threshold_is_absolute(m_options.threshold_is_absolute));
    const std::vector<double>& persistences = hierarchy.persistences();
    const std::size_t first_level = hierarchy.level(threshold());
    // a bound for the time that the levels take
    constexpr std::size_t work = 8000000, fewest = 10, most = 500;
    const std::size_t limit =
        std::clamp(work / (groups.vertices.size() + m_page.nodes.size() + 1), fewest, most);
    std::set<std::size_t> levels = levels_to_show(hierarchy.number_of_levels(), limit);
    levels.insert(first_level);

    m_page.is_graph_simplified = is_simplified_before_levels(m_options);
    m_page.number_of_levels = static_cast<std::uint32_t>(hierarchy.number_of_levels());
    Graph_recorder recorder(m_page);
    for (const std::size_t level : levels) {
      const bool is_first = level == first_level;
      const double t = is_first ? threshold() : hierarchy.threshold(level);
      for (const Graph_recorder::New_arc& arc : recorder.add(maker.level(t)))
        m_page.arcs[arc.arc].points = points_along(groups, arc.groups);
      if (is_first) {
        m_page.first_stop = static_cast<std::uint32_t>(m_page.stops.size());
        take_curves(recorder.arcs());
      }
      m_page.stops.push_back({level == 0 ? 0 : persistences[level - 1],
                              level == persistences.size() ? std::numeric_limits<double>::infinity()
                                                           : persistences[level],
                              static_cast<std::uint32_t>(level)});
      m_progress.say_part(static_cast<double>(m_page.stops.size()) /
                          static_cast<double>(levels.size()));
    }
    std::stable_sort(m_page.partings.begin(),
                     m_page.partings.end(),
                     [](const Page::Parting& p, const Page::Parting& q) { return p.arc < q.arc; });
  }

  // The inner points of an arc that some groups lie along.
  std::vector<Page::Point>
  points_along(const Vertex_groups& groups, const std::vector<std::uint32_t>& along) const
  {
    Graph graph(2);
    graph[1].id = 1;
    const auto arc = add_edge(0, 1, graph).first;
    std::vector<vertex_descriptor>& arc_vertices = graph[arc].vertices;
    for (const std::uint32_t group : along)
      for (const std::uint32_t i : groups.vertices[group])
        arc_vertices.push_back(vertex(m_page.vertices[i]));
    if (arc_vertices.empty())
      return {};
    std::sort(arc_vertices.begin(), arc_vertices.end(), [&](auto u, auto v) {
      return m_order.is_below(u, v);
    });
    graph[0].vertex = arc_vertices.front();
    graph[1].vertex = arc_vertices.back();
    return inner_points(SMRG::arc_polyline(arc, graph, m_result.mesh));
  }

  static std::vector<Page::Point> inner_points(const std::vector<Kernel::Point_3>& polyline)
  {
    std::vector<Page::Point> result;
    for (std::size_t i = 1; i + 1 < polyline.size(); ++i)
      result.push_back(place_of(polyline[i]));
    return result;
  }

  // Gives the arcs that the page shows first the curves that the other files have.
  void take_curves(const std::vector<std::uint32_t>& arcs)
  {
    const Graph& graph = m_result.graph;
    CGAL_assertion(arcs.size() == num_edges(graph));
    std::vector<std::vector<Page::Point>> points = inner_points_of_skeleton();
    std::size_t i = 0;
    for (const auto arc : boost::make_iterator_range(edges(graph))) {
      Page::Arc& page_arc = m_page.arcs[arcs[i++]];
      const auto lower = SMRG::lower_node(arc, graph), upper = SMRG::upper_node(arc, graph);
      CGAL_assertion(m_page.nodes[page_arc.lower].vertex ==
                     static_cast<std::uint32_t>(graph[lower].vertex));
      if (m_result.skeleton) {
        page_arc.points = std::move(points[graph[arc].id]);
        const Skeleton& skeleton = *m_result.skeleton;
        m_page.nodes[page_arc.lower].place = place_of(skeleton[graph[lower].id].point);
        m_page.nodes[page_arc.upper].place = place_of(skeleton[graph[upper].id].point);
      } else {
        page_arc.points = inner_points(SMRG::arc_polyline(arc, graph, m_result.mesh));
      }
    }
  }

  // By arc. The points of the nodes come first, and then those of the arcs, upwards.
  std::vector<std::vector<Page::Point>> inner_points_of_skeleton() const
  {
    std::vector<std::vector<Page::Point>> result(num_edges(m_result.graph));
    if (!m_result.skeleton)
      return result;
    const Skeleton& skeleton = *m_result.skeleton;
    for (std::size_t i = num_vertices(m_result.graph); i < num_vertices(skeleton); ++i)
      result[skeleton[*out_edges(i, skeleton).first].arc].push_back(place_of(skeleton[i].point));
    return result;
  }

  void add_pairs()
  {
    std::vector<SMRG::Persistence_pair<Graph>> pairs;
    SMRG::persistence_pairs(m_finest.graph, std::back_inserter(pairs));
    const std::vector<double> half_ranges = half_ranges_of_nodes(m_finest.graph);
    for (const auto& pair : pairs) {
      double persistence = pair.persistence();
      const double half_range = half_ranges[pair.birth];
      if (!m_options.threshold_is_absolute && half_range > 0 && persistence > 0)
        persistence = std::abs(pair.death_value / 2 - pair.birth_value / 2) / half_range;
      m_page.pairs.push_back({static_cast<std::uint32_t>(pair.kind),
                              static_cast<std::uint32_t>(pair.birth),
                              static_cast<std::uint32_t>(pair.death),
                              persistence});
    }
  }

  const Options& m_options;
  const Result& m_result;
  const Finest_graph& m_finest;
  Progress& m_progress;
  Node_order m_order;
  Page m_page;
};

} // namespace

bool is_simplified_before_levels(const Options& options)
{
  return options.close_loops > 0 || options.leaves != (std::numeric_limits<int>::max)();
}

Finest_graph finest_graph(const Result& result)
{
  Finest_graph finest;
  finest.graph = Graph(num_vertices(result.graph));
  for (const auto node : boost::make_iterator_range(vertices(result.graph)))
    finest.graph[node] = result.graph[node];
  for (const auto arc : boost::make_iterator_range(edges(result.graph)))
    finest
        .graph[add_edge(SMRG::lower_node(arc, result.graph),
                        SMRG::upper_node(arc, result.graph),
                        finest.graph)
                   .first]
        .id = result.graph[arc].id;
  for (const vertex_descriptor v : result.mesh.vertices())
    finest.arcs.push_back(result.arcs[v]);
  return finest;
}

Page make_page(const Options& options,
               const Result& result,
               const Finest_graph& finest,
               Progress& progress)
{
  return Page_maker(options, result, finest, progress).run();
}
