#include "repair_polygon_soup.h"

#include "Edge_uses.h"
#include "errors.h"
#include "text.h"
#include "weld_points.h"

#include <boost/functional/hash.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t none = Edge_uses::none;

// "vertices 1, 2 and 3", "faces 1, 2, 3, 4, 5 and 17 more"
std::string
listed(const std::string& one, const std::string& several, const std::vector<std::size_t>& numbers)
{
  constexpr std::size_t longest = 5;
  std::string result = numbers.size() == 1 ? one : several;
  const std::size_t shown = (std::min)(longest, numbers.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == numbers.size();
    result += (i == 0 ? " " : is_last ? " and " : ", ") + std::to_string(numbers[i]);
  }
  if (shown < numbers.size())
    result += " and " + std::to_string(numbers.size() - shown) + " more";
  return result;
}

std::string listed_faces(const std::vector<std::size_t>& faces)
{
  return listed("face", "faces", faces);
}

// The corners of a polygon, beginning with the least one: two polygons are the same if these are.
struct Polygon_hash
{
  const Polygon_soup& soup;
  bool ignores_order; // polygons that run the other way are the same

  std::vector<std::size_t> canonical(std::size_t polygon) const
  {
    std::vector<std::size_t> corners(
        soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first[polygon]),
        soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first[polygon + 1]));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (ignores_order && corners.back() < corners[1])
      std::reverse(corners.begin() + 1, corners.end());
    return corners;
  }

  std::size_t operator()(std::size_t polygon) const
  {
    const std::vector<std::size_t> corners = canonical(polygon);
    return boost::hash_range(corners.begin(), corners.end());
  }

  bool operator()(std::size_t a, std::size_t b) const { return canonical(a) == canonical(b); }
};

class Soup_repair
{
public:
  Soup_repair(Polygon_soup& soup, const Repair_options& options, std::vector<Repair>& repairs)
    : m_soup(soup), m_options(options), m_repairs(repairs), m_origin(soup.points.size())
  {
    std::iota(m_origin.begin(), m_origin.end(), std::size_t(0));
    m_face.resize(soup.number_of_polygons());
    std::iota(m_face.begin(), m_face.end(), std::size_t(0));
  }

  std::vector<std::size_t> run()
  {
    weld();
    leave_out_repeated_corners();
    if (has_crowded_side()) { // all sides of a repeated face are
      drop_repeated_faces(false);
      drop_repeated_faces(true);
    }
    match_sides();
    turn_faces();
    separate_fans();
    return std::move(m_origin);
  }

private:
  void
  say(const std::string& kind, std::size_t number, const std::string& text, bool is_wanted = false)
  {
    m_repairs.push_back({kind, number, text, is_wanted});
  }

  void weld()
  {
    if (m_options.weld_distance < 0)
      return;
    const std::size_t before = m_soup.points.size();
    m_origin = weld_points(m_soup, m_options.weld_distance);
    const std::size_t number = before - m_soup.points.size();
    if (number > 0)
      say("welded_vertices",
          number,
          counted(number, "vertex was", "vertices were") + " welded to others",
          true);
  }

  // Cuts every polygon where it comes back to a vertex.
  void leave_out_repeated_corners()
  {
    Polygon_soup result;
    std::vector<std::size_t> faces, simplified, dropped;
    std::vector<std::size_t> position(m_soup.points.size(), none), path;
    const auto add_polygon = [&](std::size_t begin, std::size_t face) {
      if (path.size() - begin < 3)
        return;
      result.corners.insert(
          result.corners.end(), path.begin() + static_cast<std::ptrdiff_t>(begin), path.end());
      result.end_polygon();
      faces.push_back(face);
    };
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i) {
      const std::size_t polygons_before = result.number_of_polygons();
      bool is_simple = true;
      path.clear();
      for (std::size_t k = m_soup.first[i]; k < m_soup.first[i + 1]; ++k) {
        const std::size_t vertex = m_soup.corners[k];
        if (position[vertex] != none) {
          is_simple = false;
          const std::size_t begin = position[vertex];
          add_polygon(begin, m_face[i]);
          for (std::size_t p = begin; p < path.size(); ++p)
            position[path[p]] = none;
          path.resize(begin);
        }
        position[vertex] = path.size();
        path.push_back(vertex);
      }
      add_polygon(0, m_face[i]);
      for (const std::size_t vertex : path)
        position[vertex] = none;
      if (!is_simple)
        (result.number_of_polygons() > polygons_before ? simplified : dropped).push_back(m_face[i]);
    }
    m_soup.corners.swap(result.corners);
    m_soup.first.swap(result.first);
    m_face.swap(faces);
    if (!simplified.empty())
      say("simplified_faces",
          simplified.size(),
          counted(simplified.size(),
                  "face that repeats a corner was",
                  "faces that repeat a corner were") +
              " simplified (" + listed_faces(simplified) + ")");
    if (!dropped.empty())
      say("dropped_degenerate_faces",
          dropped.size(),
          counted(dropped.size(), "face", "faces") + " with fewer than three different corners " +
              (dropped.size() == 1 ? "was" : "were") + " dropped (" + listed_faces(dropped) + ")");
  }

  void drop_repeated_faces(bool ignores_order)
  {
    const Polygon_hash hash = {m_soup, ignores_order};
    std::unordered_set<std::size_t, Polygon_hash, Polygon_hash> seen(
        m_soup.number_of_polygons() + 1, hash, hash);
    const std::vector<char> is_crowded = ignores_order ? crowded_polygons() : std::vector<char>();
    if (ignores_order && std::find(is_crowded.begin(), is_crowded.end(), 1) == is_crowded.end())
      return;
    Polygon_soup result;
    std::vector<std::size_t> faces, dropped;
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i) {
      if (!seen.insert(i).second && (!ignores_order || is_crowded[i])) {
        dropped.push_back(m_face[i]);
        continue;
      }
      result.corners.insert(result.corners.end(),
                            m_soup.corners.begin() + static_cast<std::ptrdiff_t>(m_soup.first[i]),
                            m_soup.corners.begin() +
                                static_cast<std::ptrdiff_t>(m_soup.first[i + 1]));
      result.end_polygon();
      faces.push_back(m_face[i]);
    }
    if (dropped.empty())
      return;
    m_soup.corners.swap(result.corners);
    m_soup.first.swap(result.first);
    m_face.swap(faces);
    say("dropped_repeated_faces",
        dropped.size(),
        counted(dropped.size(), "face", "faces") + " with the vertices of an earlier one" +
            (ignores_order ? ", turned around, " : " ") + (dropped.size() == 1 ? "was" : "were") +
            " dropped (" + listed_faces(dropped) + ")");
  }

  // Polygons with an edge that has more than two.
  std::vector<char> crowded_polygons() const
  {
    const std::vector<std::size_t> polygon = polygons_of_corners();
    std::vector<char> result(m_soup.number_of_polygons(), 0);
    Edge_uses(m_soup).for_each_edge([&](auto begin, auto end) {
      if (end - begin > 2)
        for (auto use = begin; use != end; ++use)
          result[polygon[use->corner]] = 1;
    });
    return result;
  }

  // Whether two sides run along an edge in the same direction.
  bool has_crowded_side() const
  {
    bool result = false;
    const Edge_uses edges(m_soup);
    edges.for_each_edge([&](auto begin, auto end) {
      result |= end - begin > 2 || (end - begin == 2 &&
                                    edges.runs_upwards(*begin) == edges.runs_upwards(*(begin + 1)));
    });
    return result;
  }

  std::vector<std::size_t> polygons_of_corners() const
  {
    std::vector<std::size_t> polygon(m_soup.corners.size());
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i)
      for (std::size_t k = m_soup.first[i]; k < m_soup.first[i + 1]; ++k)
        polygon[k] = i;
    return polygon;
  }

  std::size_t next(std::size_t corner) const
  {
    const std::size_t polygon = m_polygon[corner];
    return corner + 1 < m_soup.first[polygon + 1] ? corner + 1 : m_soup.first[polygon];
  }

  std::string edge_at(std::size_t corner) const
  {
    return "the edge between the vertices " + std::to_string(m_origin[m_soup.corners[corner]]) +
           " and " + std::to_string(m_origin[m_soup.corners[next(corner)]]);
  }

  // The two sides of each edge that has two.
  void match_sides()
  {
    m_polygon = polygons_of_corners();
    m_partner.assign(m_soup.corners.size(), none);
    m_agrees.assign(m_soup.corners.size(), 1);
    m_is_at_split_edge.assign(m_soup.points.size(), 0);
    std::size_t number_of_split_edges = 0;
    const Edge_uses edges(m_soup);
    edges.for_each_edge([&](auto begin, auto end) {
      if (end - begin > 2) {
        if (!m_options.split_nonmanifold_edges) {
          std::vector<std::size_t> faces;
          for (auto use = begin; use != end; ++use)
            faces.push_back(m_face[m_polygon[use->corner]]);
          throw Content_error("is no 2-manifold: " + edge_at(begin->corner) + " has " +
                              std::to_string(faces.size()) + " faces (" + listed_faces(faces) +
                              "); --split-nonmanifold-edges separates them");
        }
        ++number_of_split_edges;
        m_is_at_split_edge[begin->low] = m_is_at_split_edge[begin->high] = 1;
      } else if (end - begin == 2) {
        const std::size_t a = begin->corner, b = (begin + 1)->corner;
        m_partner[a] = b;
        m_partner[b] = a;
        m_agrees[a] = m_agrees[b] =
            edges.runs_upwards(*begin) != edges.runs_upwards(*(begin + 1)) ? 1 : 0;
      }
    });
    if (number_of_split_edges > 0)
      say("split_edges",
          number_of_split_edges,
          counted(number_of_split_edges, "edge") + " with more than two faces " +
              (number_of_split_edges == 1 ? "was" : "were") + " split",
          true);
  }

  // Decides which polygons to turn, by breadth-first search from polygon to polygon.
  void turn_faces()
  {
    constexpr char undecided = 2;
    std::vector<char> turn(m_soup.number_of_polygons(), undecided);
    std::vector<std::size_t> component, turned;
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i) {
      if (turn[i] != undecided)
        continue;
      component.assign(1, i);
      turn[i] = 0;
      std::size_t number_of_turned = 0;
      for (std::size_t reached = 0; reached < component.size(); ++reached) {
        const std::size_t polygon = component[reached];
        number_of_turned += turn[polygon] == 1;
        for (std::size_t k = m_soup.first[polygon]; k < m_soup.first[polygon + 1]; ++k)
          if (m_partner[k] != none)
            visit_neighbor(k, turn, component);
      }
      const bool is_inverse = number_of_turned > component.size() - number_of_turned;
      for (const std::size_t polygon : component) {
        turn[polygon] = turn[polygon] != is_inverse;
        if (turn[polygon] == 1)
          turned.push_back(m_face[polygon]);
      }
    }
    if (turned.empty())
      return;
    for (std::size_t i = 0; i < m_soup.number_of_polygons(); ++i)
      if (turn[i] == 1)
        std::reverse(m_soup.corners.begin() + static_cast<std::ptrdiff_t>(m_soup.first[i] + 1),
                     m_soup.corners.begin() + static_cast<std::ptrdiff_t>(m_soup.first[i + 1]));
    std::sort(turned.begin(), turned.end());
    say("turned_faces",
        turned.size(),
        counted(turned.size(), "face was", "faces were") + " turned to agree with the neighbors (" +
            listed_faces(turned) + ")");
    rematch_sides();
  }

  void visit_neighbor(std::size_t corner,
                      std::vector<char>& turn,
                      std::vector<std::size_t>& component) const
  {
    constexpr char undecided = 2;
    const std::size_t polygon = m_polygon[corner], other = m_polygon[m_partner[corner]];
    const char wanted = m_agrees[corner] ? turn[polygon] : char(1 - turn[polygon]);
    if (turn[other] == undecided) {
      turn[other] = wanted;
      component.push_back(other);
    } else if (turn[other] != wanted) {
      throw Content_error("is not orientable: the surface has one side only, as a Moebius strip "
                          "has; the faces " +
                          std::to_string(m_face[polygon]) + " and " +
                          std::to_string(m_face[other]) + " at " + edge_at(corner) +
                          " cannot agree with all others");
    }
  }

  // After polygons have been turned, their sides begin at other corners.
  void rematch_sides()
  {
    const Edge_uses edges(m_soup);
    m_partner.assign(m_soup.corners.size(), none);
    edges.for_each_edge([&](auto begin, auto end) {
      if (end - begin == 2) {
        m_partner[begin->corner] = (begin + 1)->corner;
        m_partner[(begin + 1)->corner] = begin->corner;
      }
    });
  }

  // Neighboring polygons have their two corners at an end of the common edge in one fan. Fans that end
  // at the border, of one vertex, are not separated.
  void separate_fans()
  {
    boost::disjoint_sets_with_storage<> fans(m_soup.corners.size());
    for (std::size_t k = 0; k < m_soup.corners.size(); ++k)
      if (m_partner[k] != none)
        fans.union_set(next(k), m_partner[k]);
    std::vector<std::size_t> first_open_corner(m_soup.points.size(), none);
    for (std::size_t k = 0; k < m_soup.corners.size(); ++k)
      if (m_partner[k] == none)
        for (const std::size_t corner : {k, next(k)}) {
          const std::size_t vertex = m_soup.corners[corner];
          if (m_is_at_split_edge[vertex])
            continue;
          if (first_open_corner[vertex] == none)
            first_open_corner[vertex] = corner;
          fans.union_set(first_open_corner[vertex], corner);
        }

    std::vector<std::size_t> vertex_of_fan(m_soup.corners.size(), none);
    std::vector<std::size_t> number_of_fans(m_soup.points.size(), 0);
    for (std::size_t k = 0; k < m_soup.corners.size(); ++k) {
      std::size_t& corner = m_soup.corners[k];
      std::size_t& vertex = vertex_of_fan[fans.find_set(k)];
      if (vertex == none) {
        vertex = corner;
        if (number_of_fans[corner]++ > 0) {
          vertex = m_soup.points.size();
          m_soup.points.push_back(m_soup.points[corner]);
          m_origin.push_back(m_origin[corner]);
        }
      }
      corner = vertex;
    }
    say_duplicated(number_of_fans);
  }

  void say_duplicated(const std::vector<std::size_t>& number_of_fans)
  {
    std::vector<std::size_t> vertices;
    std::size_t least = none, most = 0;
    for (std::size_t v = 0; v < number_of_fans.size(); ++v) {
      if (number_of_fans[v] < 2)
        continue;
      vertices.push_back(m_origin[v]);
      least = (std::min)(least, number_of_fans[v]);
      most = (std::max)(most, number_of_fans[v]);
    }
    if (vertices.empty())
      return;
    const std::string fans = least == most ? std::to_string(least)
                                           : std::to_string(least) + " to " + std::to_string(most);
    say("duplicated_vertices",
        vertices.size(),
        counted(vertices.size(), "vertex", "vertices") + " with " + fans + " fans of faces " +
            (vertices.size() == 1 ? "was" : "were") + " duplicated (" +
            listed("vertex", "vertices", vertices) + ")",
        m_options.split_nonmanifold_edges);
  }

  Polygon_soup& m_soup;
  const Repair_options& m_options;
  std::vector<Repair>& m_repairs;
  std::vector<std::size_t> m_origin;    // of the points: their numbers in the file
  std::vector<std::size_t> m_face;      // of the polygons: their numbers in the file
  std::vector<std::size_t> m_polygon;   // of the corners
  std::vector<std::size_t> m_partner;   // the other side of the edge, or none, by corners
  std::vector<char> m_is_at_split_edge; // by points
  std::vector<char> m_agrees;           // whether the two sides run in opposite directions
};

} // namespace

std::vector<std::size_t>
repair_polygon_soup(Polygon_soup& soup, const Repair_options& options, std::vector<Repair>& repairs)
{
  return Soup_repair(soup, options, repairs).run();
}
