// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_WRITE_FILE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_WRITE_FILE_H

#include <fstream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Writes to a file what `write(out)` writes to a stream. If that throws, the file is left as it
// was. Returns whether the file could be written.
template <class Write>
bool write_file(const std::string& filename, const Write& write)
{
  std::ostringstream text;
  write(text);
  std::ofstream out(filename, std::ios_base::binary);
  out << text.str();
  out.close();
  return !out.fail();
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_WRITE_FILE_H
