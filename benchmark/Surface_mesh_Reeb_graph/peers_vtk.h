// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Reeb graph of VTK.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_VTK_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_VTK_H

#include "meshes.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReebGraph.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Reeb_graph_benchmark {

// The mesh and the function in the form that VTK takes, made once and outside the time measured.
class Vtk_input
{
public:
  Vtk_input(const Mesh& mesh, const std::vector<double>& values)
  {
    vtkNew<vtkPoints> points;
    for (const Mesh::Vertex_index v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      points->InsertNextPoint(p.x(), p.y(), p.z());
      m_values->InsertNextValue(values[v]);
    }
    vtkNew<vtkCellArray> triangles;
    for (const Mesh::Face_index f : mesh.faces()) {
      triangles->InsertNextCell(3);
      for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        triangles->InsertCellPoint(static_cast<vtkIdType>(v));
    }
    m_mesh->SetPoints(points);
    m_mesh->SetPolys(triangles);
  }

  // returns the number of nodes
  std::size_t compute_Reeb_graph()
  {
    vtkNew<vtkReebGraph> graph;
    if (graph->Build(m_mesh, m_values) != 0)
      throw std::runtime_error("vtkReebGraph does not take the mesh");
    return static_cast<std::size_t>(graph->GetNumberOfVertices());
  }

private:
  vtkNew<vtkPolyData> m_mesh;
  vtkNew<vtkDoubleArray> m_values;
};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_PEERS_VTK_H
