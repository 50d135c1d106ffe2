// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_EXACT_OUTPUT_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_EXACT_OUTPUT_H

#include <boost/io/ios_state.hpp>

#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// While it lives, a stream writes doubles such that they can be read back exactly, whatever format
// and locale its user has set; these come back afterwards.
class Exact_output
{
public:
  explicit Exact_output(std::ostream& out)
    : m_flags(out), m_precision(out), m_locale(out, std::locale::classic())
  {
    out.flags(std::ios_base::dec);
    out.precision(std::numeric_limits<double>::max_digits10);
  }

private:
  boost::io::ios_flags_saver m_flags;
  boost::io::ios_precision_saver m_precision;
  boost::io::ios_locale_saver m_locale;
};

// The parts as text, the same whatever the global locale: with one that groups digits, a stream of
// its own would write 1279 as 1.279.
template <class... Part>
std::string exact_text(const Part&... parts)
{
  std::ostringstream text;
  const Exact_output exact_output(text);
  (text << ... << parts);
  return text.str();
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_EXACT_OUTPUT_H
