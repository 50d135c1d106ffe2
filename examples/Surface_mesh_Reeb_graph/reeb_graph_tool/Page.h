#ifndef REEB_GRAPH_TOOL_PAGE_H
#define REEB_GRAPH_TOOL_PAGE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What the HTML page shows, as plain lists.
//
// The graph is stored at all its stops, thresholds from the finest graph to the coarsest one: nodes
// and arcs have lives, from one stop to another one. When an arc's life ends, its region goes to one
// other arc, its heir, or is divided among several. Regions are made of groups of vertices: those
// of an arc of the finest graph between two neighboring heights of nodes, which never part.
struct Page
{
  using Point = std::array<double, 3>;

  static constexpr std::uint32_t none = 0xffffffff;

  struct Node
  {
    std::uint32_t vertex; // its index in the mesh
    double value;
    Point place;
    std::uint32_t end; // the first stop that it is missing at, or none
  };

  struct Arc
  {
    std::uint32_t lower, upper; // positions of nodes
    std::uint32_t begin, end;   // the first stop, and the first one after that it is missing at
    std::uint32_t heir = none;
    std::vector<Point> points = {}; // between the nodes
  };

  // Where a group goes when the life of its arc ends, and the arc has no single heir.
  struct Parting
  {
    std::uint32_t arc, group, heir;
  };

  struct Stop
  {
    double lower, upper; // the thresholds that are larger than `lower`, and not than `upper`
    std::uint32_t level;
  };

  struct Pair
  {
    std::uint32_t kind; // as Persistence_pair_kind
    std::uint32_t birth, death;
    double persistence; // as it is compared with the threshold
  };

  std::string name;     // of the mesh
  std::string function; // its name, or that of the file
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  bool is_threshold_absolute = false, is_graph_simplified = false;
  std::uint32_t number_of_levels = 1, first_stop = 0; // the stop to begin with

  // the picture: the mesh, or a coarser one
  bool is_decimated = false;
  std::vector<Point> points;
  std::vector<std::uint32_t> vertices; // their indices in the mesh
  std::vector<double> values;
  std::vector<std::uint32_t> groups; // none for isolated vertices
  std::vector<std::array<std::uint32_t, 3>> triangles;

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> arc_of_group; // in the finest graph
  std::vector<Parting> partings;           // by arc, then by group
  std::vector<Stop> stops;
  std::vector<Pair> pairs;
};

#endif // REEB_GRAPH_TOOL_PAGE_H
