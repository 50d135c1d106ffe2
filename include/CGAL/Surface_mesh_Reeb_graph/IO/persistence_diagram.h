// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_PERSISTENCE_DIAGRAM_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_PERSISTENCE_DIAGRAM_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>

#include <CGAL/number_utils.h>

#include <iterator>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the persistence pairs of a Reeb graph as text that GUDHI reads
(`read_persistence_intervals_in_dimension()` and the like). A line for every pair has a dimension
and the lower and the higher one of the two values, so that the intervals are proper ones for all
tools there:

| kind of pair | dimension | interval |
|--------------|-----------|----------|
| `Persistence_pair_kind::MINIMUM` | 0 | value of the minimum, value of the merge |
| `Persistence_pair_kind::COMPONENT` | 0 | value of the minimum, value of the maximum |
| `Persistence_pair_kind::MAXIMUM` | 1 | value of the split, value of the maximum |
| `Persistence_pair_kind::LOOP` | 1 | value of the split, value of the merge |

The dimensions are those of extended persistence, where the birth of a pair of dimension 1 is the
higher value. The kinds come in this order, each after a line that begins with `#` and says which it
is. No interval ends at infinity unless the function does: extended persistence pairs all nodes.
Intervals of length 0 are written, too.

Values are converted to `double` and written such that these can be read back exactly.

\param out the stream
\param graph the Reeb graph, as for `persistence_pairs()`

\return `true` if the stream is good afterwards

\throws Input_error as `persistence_pairs()`; nothing is written then

\sa `persistence_pairs()`
*/
template <class Graph>
bool write_persistence_diagram(std::ostream& out, const Graph& graph)
{
  std::vector<Persistence_pair<Graph>> pairs;
  persistence_pairs(graph, std::back_inserter(pairs));

  const internal::Exact_output exact_output(out);
  const auto write_pairs = [&](Persistence_pair_kind kind, int dimension, const char* title) {
    out << "# " << title << '\n';
    for (const Persistence_pair<Graph>& pair : pairs) {
      if (pair.kind != kind)
        continue;
      const double birth = CGAL::to_double(pair.birth_value);
      const double death = CGAL::to_double(pair.death_value);
      out << dimension << ' ' << (dimension == 0 ? birth : death) << ' '
          << (dimension == 0 ? death : birth) << '\n';
    }
  };
  out << "# dimension, lower value, higher value\n";
  write_pairs(Persistence_pair_kind::MINIMUM, 0, "minimum, merge");
  write_pairs(Persistence_pair_kind::COMPONENT, 0, "component: minimum, maximum");
  write_pairs(Persistence_pair_kind::MAXIMUM, 1, "split, maximum");
  write_pairs(Persistence_pair_kind::LOOP, 1, "loop: split, merge");
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes the persistence pairs of a Reeb graph to a file, which is replaced if it exists.

\param filename the name of the file
\param graph the Reeb graph

\return `true` if the file could be written

\throws Input_error as `persistence_pairs()`; the file is then left as it was
*/
template <class Graph>
bool write_persistence_diagram(const std::string& filename, const Graph& graph)
{
  return internal::write_file(
      filename, [&](std::ostream& out) { IO::write_persistence_diagram(out, graph); });
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_PERSISTENCE_DIAGRAM_H
