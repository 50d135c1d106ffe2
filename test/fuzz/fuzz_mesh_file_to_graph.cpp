// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a mesh file, and from there to its Reeb graph: if the file can be read, the mesh is
// valid, and both algorithms find a graph with as many components and the same numbers.

#include "mesh_file_from_bytes.h"

#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/build_mesh.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/errors.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdint>

namespace {

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void compute(Mesh& mesh)
{
  require(mesh.is_valid(), "the mesh is valid");
  require(CGAL::is_triangle_mesh(mesh), "the mesh has triangles");
  const auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  for (const auto v : mesh.vertices())
    values[v] = mesh.point(v).z();
  SMRG::Reeb_graph<Mesh> graph, other;
  SMRG::compute_Reeb_graph(
      mesh, values, graph, CGAL::parameters::algorithm(SMRG::Reeb_graph_algorithm::SWEEP));
  SMRG::compute_Reeb_graph(
      mesh, values, other, CGAL::parameters::algorithm(SMRG::Reeb_graph_algorithm::CUTTING));
  require(num_vertices(graph) == num_vertices(other) && num_edges(graph) == num_edges(other),
          "both algorithms find the same");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  const Mesh_file_from_bytes file(data, size);
  Mesh mesh;
  try {
    Mesh_input input;
    build_mesh(parse_repaired_triangles(file.content, file.extension, file.options, input), mesh);
  } catch (const Content_error&) {
    return 0;
  }
  compute(mesh);
  return 0;
}
