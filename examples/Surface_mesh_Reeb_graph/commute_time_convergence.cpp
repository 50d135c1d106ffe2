// How the commute-time function depends on the number of eigenpairs: a table in Markdown.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/Surface_mesh_Reeb_graph/commute_time_function.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/feature_points.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/spectral_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<Vertex, double>;

double smallest(const Mesh& mesh, Value_map values)
{
  double result = values[*mesh.vertices().begin()];
  for (Vertex v : mesh.vertices())
    result = (std::min)(result, values[v]);
  return result;
}

double largest(const Mesh& mesh, Value_map values)
{
  double result = 0;
  for (Vertex v : mesh.vertices())
    result = (std::max)(result, values[v]);
  return result;
}

std::size_t number_of_maxima(const Mesh& mesh, Value_map values)
{
  SMRG::Reeb_graph<Mesh> graph;
  SMRG::compute_Reeb_graph(mesh, values, graph);
  SMRG::simplify_Reeb_graph(mesh, values, graph, SMRG::parameters::persistence_threshold(0.03));
  std::size_t number = 0;
  for (auto node : CGAL::make_range(vertices(graph)))
    number += graph[node].type == SMRG::Reeb_node_type::MAXIMUM;
  return number;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  Mesh mesh;
  if (!(std::ifstream(filename) >> mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << filename << ": no triangle mesh in the format OFF\n";
    return EXIT_FAILURE;
  }
  const std::size_t most = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 320;
  const Value_map values = mesh.add_property_map<Vertex, double>("v:value").first;

  // the same feature points for all numbers
  std::vector<Vertex> points;
  SMRG::commute_time_function(
      mesh, values, SMRG::parameters::output_iterator(std::back_inserter(points)));

  std::cout << "| eigenpairs | largest value | growth of its square | by Weyl's law | smallest / "
               "largest value | maxima | largest biharmonic distance |\n"
               "|--:|--:|--:|--:|--:|--:|--:|\n"
            << std::fixed << std::setprecision(3);
  double previous = 0;
  for (std::size_t number = 20; number <= most; number *= 2) {
    const SMRG::Laplace_Beltrami_eigenbasis<Mesh> basis(
        mesh, SMRG::parameters::number_of_eigenpairs(number));
    SMRG::commute_time_function(basis, points, values);
    const double highest = largest(mesh, values);
    std::cout << "| " << number << " | " << highest << " | ";
    if (previous > 0) {
      // the squared distance grows as lambda_1 A / (2 pi) times the logarithm of the number
      const std::size_t c = basis.component(points.front());
      constexpr double two_pi = 6.28318530717958647692;
      std::cout << highest * highest - previous * previous << " | "
                << basis.eigenvalue(c, 1) * basis.area(c) / two_pi * std::log(2.);
    } else {
      std::cout << " | ";
    }
    previous = highest;
    std::cout << " | " << smallest(mesh, values) / highest << " | "
              << number_of_maxima(mesh, values);
    SMRG::biharmonic_distances(basis, points.front(), values);
    std::cout << " | " << largest(mesh, values) << " |\n";
  }
}
