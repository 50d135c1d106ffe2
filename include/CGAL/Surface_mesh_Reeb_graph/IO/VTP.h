// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_VTP_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_VTP_H

#include <CGAL/Surface_mesh_Reeb_graph/Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/mesh/vertex_point_map.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a mesh with a function and the arcs of its vertices as a VTK XML file (`.vtp`) for ParaView.
The arrays of the points are named `value` and `arc`; a vertex without an arc has the arc number -1.
ParaView reads finite numbers only: infinite values become the largest or the lowest of these.

\tparam VertexScalarMap a model of `ReadablePropertyMap` from vertices to numbers
\tparam VertexArcMap a model of `ReadablePropertyMap` from vertices to integers

\param out the stream
\param tmesh the mesh
\param values the function
\param arcs the arc numbers, as written by `compute_Reeb_graph()`
\param np an optional sequence of named parameters: `vertex_point_map`, by default that of the mesh

\return `true` if the stream is good afterwards
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexArcMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_VTP(std::ostream& out,
               const TriangleMesh& tmesh,
               VertexScalarMap values,
               VertexArcMap arcs,
               const NamedParameters& np = CGAL::parameters::default_values())
{
  using Number = typename boost::property_traits<VertexArcMap>::value_type;

  constexpr double largest = (std::numeric_limits<double>::max)();
  const auto vertex_point_map = internal::vertex_point_map(tmesh, np);
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);
  std::size_t number_of_vertices = 0;
  for (auto v : CGAL::make_range(vertices(tmesh)))
    put(number, v, number_of_vertices++);
  const auto face_range = faces(tmesh);
  const auto number_of_faces =
      static_cast<std::size_t>(std::distance(face_range.begin(), face_range.end()));

  const internal::Exact_output exact_output(out);
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "<PolyData>\n<Piece NumberOfPoints=\"" << number_of_vertices << "\" NumberOfPolys=\""
      << number_of_faces << "\">\n"
      << "<PointData Scalars=\"value\">\n"
      << "<DataArray type=\"Float64\" Name=\"value\" format=\"ascii\">\n";
  for (auto v : CGAL::make_range(vertices(tmesh)))
    out << (std::min)((std::max)(CGAL::to_double(get(values, v)), -largest), largest) << '\n';
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"arc\" format=\"ascii\">\n";
  for (auto v : CGAL::make_range(vertices(tmesh)))
    out << (get(arcs, v) == static_cast<Number>(null_arc) ? -1
                                                          : static_cast<long long>(get(arcs, v)))
        << '\n';
  out << "</DataArray>\n</PointData>\n<Points>\n"
      << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (auto v : CGAL::make_range(vertices(tmesh))) {
    const auto& p = get(vertex_point_map, v);
    out << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z())
        << '\n';
  }
  out << "</DataArray>\n</Points>\n<Polys>\n"
      << "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (auto f : CGAL::make_range(faces(tmesh))) {
    for (auto v : CGAL::vertices_around_face(halfedge(f, tmesh), tmesh))
      out << get(number, v) << ' ';
    out << '\n';
  }
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 1; i <= number_of_faces; ++i)
    out << 3 * i << '\n';
  out << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a mesh with a function and the arcs of its vertices to a VTK XML file (`.vtp`), which is
replaced if it exists.

\param filename the name of the file
\param tmesh the mesh
\param values the function
\param arcs the arc numbers
\param np named parameters

\return `true` if the file could be written
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class VertexArcMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool write_VTP(const std::string& filename,
               const TriangleMesh& tmesh,
               VertexScalarMap values,
               VertexArcMap arcs,
               const NamedParameters& np = CGAL::parameters::default_values())
{
  std::ofstream out(filename, std::ios_base::binary);
  IO::write_VTP(out, tmesh, values, arcs, np);
  out.close();
  return !out.fail();
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_VTP_H
