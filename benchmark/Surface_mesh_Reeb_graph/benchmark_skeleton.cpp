// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curve skeletons beside those of CGAL's mean curvature flow.
//
//   benchmark_skeleton [--smoothing S] [--subdivide N] MESH|FOLDER...
//
// --subdivide makes four triangles of each, N times (Loop). Of folders, all OFF files; what is not a
// closed triangle mesh is passed over. A row for every mesh and the least and the middle one of them go
// to the standard output, in Markdown: the part of the length that is inside, how centered it is, and
// how it turns. The graph is that of the commute-time function with the branches below a tenth of the
// range cancelled.

#include "seconds_for.h"
#include "skeleton/Skeleton_quality.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_curve_skeleton.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using namespace Reeb_graph_benchmark;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Mean_curvature_flow = CGAL::Mean_curvature_flow_skeletonization<Mesh>;

struct Row
{
  std::string name;
  std::size_t vertices = 0;
  Skeleton_quality ours = {}, peer = {};
  std::size_t outside = 0; // segments of ours
  std::size_t cycles = 0, peer_cycles = 0;
  double graph_seconds = 0, seconds = 0, peer_seconds = 0;
};

template <class Skeleton>
std::size_t number_of_cycles(const Skeleton& skeleton)
{
  std::vector<std::size_t> component(num_vertices(skeleton));
  const auto components =
      static_cast<std::size_t>(boost::connected_components(skeleton, component.data()));
  return num_edges(skeleton) + components - num_vertices(skeleton);
}

Row measure(Mesh& mesh, double smoothing)
{
  Row row;
  row.vertices = mesh.number_of_vertices();
  SMRG::internal::Surface_tree surface;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto corner = [&](auto g) {
      return SMRG::internal::coordinates(mesh.point(mesh.target(g)));
    };
    surface.add(corner(h), corner(mesh.next(h)), corner(mesh.prev(h)));
  }
  surface.build();
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double diagonal =
      std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  SMRG::Reeb_graph<Mesh> graph;
  row.graph_seconds = seconds_for([&]() {
    SMRG::commute_time_Reeb_graph(
        mesh,
        graph,
        SMRG::parameters::persistence_threshold(0.1).vertex_value_map(values).collect_arc_vertices(
            true));
  });
  SMRG::Curve_skeleton<Mesh> skeleton;
  row.seconds = seconds_for([&]() {
    SMRG::compute_curve_skeleton(
        mesh, values, graph, skeleton, SMRG::parameters::smoothing(smoothing));
  });
  for (const auto edge : CGAL::make_range(edges(skeleton)))
    row.outside += skeleton[edge].is_inside ? 0 : 1;
  row.cycles = number_of_cycles(skeleton);
  row.ours = Skeleton_quality::measure(polylines_of(skeleton), surface, diagonal);

  Mean_curvature_flow::Skeleton peer;
  row.peer_seconds = seconds_for([&]() {
    Mean_curvature_flow flow(mesh);
    flow(peer);
  });
  row.peer_cycles = number_of_cycles(peer);
  row.peer = Skeleton_quality::measure(polylines_of(peer), surface, diagonal);
  return row;
}

void print(const Row& row)
{
  std::cout << std::fixed << "| " << row.name << " | " << row.vertices << std::setprecision(3)
            << " | " << row.ours.inside << " / " << row.peer.inside << " | " << row.outside
            << std::setprecision(2) << " | " << row.ours.centered << " / " << row.peer.centered
            << std::setprecision(0) << " | " << row.ours.turning << " / " << row.peer.turning
            << " | " << row.cycles << " / " << row.peer_cycles << std::setprecision(2) << " | "
            << row.graph_seconds << " | " << row.seconds << " / " << row.peer_seconds << " |"
            << std::endl;
}

template <class Value>
std::string least_and_median(const std::vector<Row>& rows, int digits, const Value& value)
{
  std::vector<double> values;
  for (const Row& row : rows)
    values.push_back(value(row));
  std::sort(values.begin(), values.end());
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << values.front() << ", "
      << values[values.size() / 2];
  return out.str();
}

void print_summary(const std::vector<Row>& rows)
{
  const auto print_line = [&](const std::string& name, int digits, auto value, auto peer_value) {
    std::cout << "| " << name << " | " << least_and_median(rows, digits, value) << " | "
              << least_and_median(rows, digits, peer_value) << " |\n";
  };
  std::size_t centered = 0, half = 0, inside = 0;
  for (const Row& row : rows) {
    centered += row.ours.centered >= row.peer.centered ? 1 : 0;
    half += row.ours.turning < row.peer.turning / 2 ? 1 : 0;
    inside += row.outside == 0 ? 1 : 0;
  }
  std::cout << "\nThe least one and the median of " << rows.size() << " meshes:\n\n"
            << "| | ours | mean curvature flow |\n|---|---|---|\n";
  print_line(
      "inside",
      3,
      [](const Row& row) { return row.ours.inside; },
      [](const Row& row) { return row.peer.inside; });
  print_line(
      "centered",
      2,
      [](const Row& row) { return row.ours.centered; },
      [](const Row& row) { return row.peer.centered; });
  print_line(
      "degrees per diagonal",
      0,
      [](const Row& row) { return row.ours.turning; },
      [](const Row& row) { return row.peer.turning; });
  print_line(
      "seconds, the graph apart",
      2,
      [](const Row& row) { return row.seconds; },
      [](const Row& row) { return row.peer_seconds; });
  std::cout << "\nOn " << inside << " of them all segments are inside, on " << centered
            << " ours are at least as centered, on " << half << " they turn less than half.\n";
}

} // namespace

int main(int argc, char* argv[])
{
  double smoothing = 1;
  unsigned subdivisions = 0;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--smoothing" && i + 1 < argc) {
      smoothing = std::atof(argv[++i]);
    } else if (argument == "--subdivide" && i + 1 < argc) {
      subdivisions = static_cast<unsigned>(std::atoi(argv[++i]));
    } else if (std::filesystem::is_directory(argument)) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator(argument))
        if (entry.path().extension() == ".off")
          files.push_back(entry.path());
    } else {
      files.push_back(argument);
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    std::cerr << "usage: benchmark_skeleton [--smoothing S] [--subdivide N] MESH|FOLDER...\n";
    return EXIT_FAILURE;
  }

  std::cout
      << "| mesh | vertices | inside | segments not inside | centered | degrees per diagonal | "
         "cycles | seconds of the graph | of the skeleton |\n"
         "|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  std::vector<Row> rows;
  for (const std::filesystem::path& file : files)
    try {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(file.string(), mesh) || mesh.is_empty() ||
          !CGAL::is_triangle_mesh(mesh) || !CGAL::is_closed(mesh))
        continue;
      CGAL::Subdivision_method_3::Loop_subdivision(
          mesh, CGAL::parameters::number_of_iterations(subdivisions));
      Row row = measure(mesh, smoothing);
      row.name = file.stem().string();
      print(row);
      rows.push_back(row);
    } catch (const std::exception& error) {
      std::cerr << file.string() << ": " << error.what() << '\n';
    }
  if (!rows.empty())
    print_summary(rows);
  return EXIT_SUCCESS;
}
