// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Agreement with vtkReebGraph, which shares neither code nor method with this package: it glues the
// triangles one after the other (Pascucci et al. 2007).
//
// Everything is compared as it is: the critical vertices and the arcs between them, on meshes with
// borders, several components and multiple saddles too. The brute-force oracle says who is wrong if
// they ever differ. Two things VTK does not have: a vertex without triangles is no node there, so
// the meshes have none; and it knows no plateaus, so the values are distinct.

#define BOOST_TEST_MODULE vtk_agreement

#include "random_Reeb_graph_cases.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>

#include <boost/test/unit_test.hpp>

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkEdgeListIterator.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReebGraph.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Algorithm = SMRG::Reeb_graph_algorithm;

// The critical vertices, and the arcs as (lower vertex, upper vertex), both sorted.
struct Critical_graph
{
  std::vector<std::size_t> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> arcs;

  void sort()
  {
    std::sort(vertices.begin(), vertices.end());
    std::sort(arcs.begin(), arcs.end());
  }

  friend bool operator==(const Critical_graph& a, const Critical_graph& b)
  {
    return a.vertices == b.vertices && a.arcs == b.arcs;
  }
};

Critical_graph graph_of_vtk(const Index_mesh& mesh, const std::vector<double>& values)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scalars;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    points->InsertNextPoint(mesh.points[v].data());
    scalars->InsertNextValue(values[v]);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.triangles)
    triangles->InsertNextCell({vtkIdType(t[0]), vtkIdType(t[1]), vtkIdType(t[2])});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);

  vtkNew<vtkReebGraph> graph;
  BOOST_REQUIRE(graph->Build(data, scalars) == 0);
  auto* const vertex_of_node =
      vtkIdTypeArray::SafeDownCast(graph->GetVertexData()->GetAbstractArray("Vertex Ids"));
  BOOST_REQUIRE(vertex_of_node != nullptr);

  Critical_graph result;
  for (vtkIdType node = 0; node < graph->GetNumberOfVertices(); ++node)
    result.vertices.push_back(vertex_of_node->GetValue(node));
  vtkNew<vtkEdgeListIterator> edges;
  graph->GetEdges(edges);
  while (edges->HasNext()) {
    const vtkEdgeType edge = edges->Next();
    result.arcs.emplace_back(vertex_of_node->GetValue(edge.Source),
                             vertex_of_node->GetValue(edge.Target));
  }
  result.sort();
  return result;
}

Critical_graph graph_of_this_package(const Index_mesh& mesh,
                                     const std::vector<double>& values,
                                     Algorithm algorithm)
{
  const Case c(mesh, values);
  Graph graph;
  SMRG::compute_Reeb_graph(c.mesh, c.values, graph, CGAL::parameters::algorithm(algorithm));
  Critical_graph result;
  for (const auto node : CGAL::make_range(vertices(graph)))
    result.vertices.push_back(graph[node].vertex);
  for (const auto arc : CGAL::make_range(edges(graph)))
    result.arcs.emplace_back(graph[source(arc, graph)].vertex, graph[target(arc, graph)].vertex);
  result.sort();
  return result;
}

Critical_graph graph_of_oracle(const Index_mesh& mesh, const std::vector<double>& values)
{
  Critical_graph result;
  const Brute_force_Reeb_graph graph = brute_force_Reeb_graph(mesh, rank_of_values(values));
  for (const auto& node : graph.nodes)
    result.vertices.push_back(node.vertex);
  for (const auto& arc : graph.arcs)
    result.arcs.emplace_back(arc.lower_vertex, arc.upper_vertex);
  result.sort();
  return result;
}

void check_agreement(const Index_mesh& mesh, const std::vector<double>& values)
{
  const Critical_graph vtk = graph_of_vtk(mesh, values);
  for (const Algorithm algorithm : {Algorithm::CUTTING, Algorithm::SWEEP}) {
    const Critical_graph ours = graph_of_this_package(mesh, values, algorithm);
    BOOST_TEST_CONTEXT((algorithm == Algorithm::SWEEP ? "sweep" : "cutting"))
    {
      if (!(ours == vtk)) {
        const Critical_graph truth = graph_of_oracle(mesh, values);
        BOOST_ERROR("the graphs differ; by brute force, this package is "
                    << (ours == truth ? "right" : "wrong") << " and VTK is "
                    << (vtk == truth ? "right" : "wrong"));
      }
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_on_random_closed_meshes)
{
  unsigned number_of_cases = 0;
  for (unsigned seed = 0; number_of_cases < number_of_random_cases(); ++seed) {
    std::mt19937 rng(seed);
    Index_mesh mesh = random_small_mesh(rng);
    if (!is_closed(mesh))
      continue;
    ++number_of_cases;
    remove_isolated_vertices(mesh);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_agreement(mesh, random_values(mesh.points.size(), rng));
    }
  }
}

BOOST_AUTO_TEST_CASE(agrees_on_random_meshes_with_borders)
{
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    std::mt19937 rng(seed);
    Index_mesh mesh = random_small_mesh(rng, seed % 4 == 3);
    remove_isolated_vertices(mesh);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_agreement(mesh, random_values(mesh.points.size(), rng));
    }
  }
}

// Fewer of them, since VTK is slow.
BOOST_AUTO_TEST_CASE(agrees_on_larger_surfaces_of_any_genus)
{
  for (unsigned seed = 0; seed < number_of_random_cases() / 50; ++seed) {
    std::mt19937 rng(seed);
    const std::size_t g = seed % 6;
    Index_mesh mesh = g == 0 ? sphere(3) : closed_surface(g, 12, 10);
    flip_random_edges(mesh, random_index(4 * mesh.triangles.size(), rng), rng);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_agreement(mesh, random_values(mesh.points.size(), rng));
    }
  }
}
