// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_IO_SHAPE_SIGNATURE_FILE_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_IO_SHAPE_SIGNATURE_FILE_H

#include <CGAL/Surface_mesh_Reeb_graph/Shape_signature.h>
#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/exact_output.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/write_file.h>

#include <boost/io/ios_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <istream>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

constexpr const char* shape_signature_title = "Surface_mesh_Reeb_graph shape signature 1";

inline std::size_t signature_size(const std::string& name)
{
  if (name == "function_quantiles")
    return number_of_function_quantiles;
  if (name == "component_quantiles")
    return number_of_component_quantiles;
  if (name == "branch_persistences")
    return number_of_branch_persistences;
  if (name == "section_lengths")
    return number_of_section_levels * number_of_sections;
  if (name == "eigenvalues")
    return number_of_signature_eigenvalues;
  return number_of_bands * (number_of_bands + 1) / 2 * number_of_distance_quantiles;
}

// Calls a function with the name and the values of every list of a signature, in the order of files.
template <class Signature, class Function>
void for_each_list(Signature& signature, const Function& function)
{
  function("function_quantiles", signature.graph.function_quantiles);
  function("component_quantiles", signature.graph.component_quantiles);
  function("branch_persistences", signature.graph.branch_persistences);
  function("section_lengths", signature.section_lengths);
  function("eigenvalues", signature.eigenvalues);
  function("band_distances", signature.band_distances);
}

// Reads a signature word by word; the stream has the classic locale.
class Shape_signature_reader
{
public:
  explicit Shape_signature_reader(std::istream& in) : m_in(in) {}

  Shape_signature read()
  {
    std::string title;
    std::getline(m_in, title);
    if (!m_in || title != shape_signature_title)
      throw Input_error(std::string("the first line of a signature is not '") +
                        shape_signature_title + "'");
    Shape_signature signature;
    for_each_list(signature, [this](const char* name, std::vector<double>& values) {
      if (read_size(name) != signature_size(name))
        throw Input_error(std::string("the signature has another number of ") + name);
      for (std::size_t i = 0; i < signature_size(name); ++i) {
        values.push_back(read_number(name));
        if (values.back() < 0 && name != std::string("function_quantiles"))
          throw Input_error(std::string("the signature has a negative number among its ") + name);
      }
    });
    if (read_size("volume") != 1)
      throw Input_error("the signature has another number of volumes");
    signature.volume = read_number("volume");
    if (signature.volume < 0)
      throw Input_error("the signature has a negative volume");
    const std::size_t size = read_size("diagram");
    for (std::size_t i = 0; i < size; ++i)
      signature.graph.diagram.push_back(read_point());
    if (!std::is_sorted(
            signature.graph.diagram.begin(), signature.graph.diagram.end(), comes_before))
      throw Input_error("the diagram of the signature is not sorted");
    std::string word;
    if (m_in >> word)
      throw Input_error("after the end of the signature there is '" + word + "'");
    return signature;
  }

private:
  std::size_t read_size(const std::string& name)
  {
    std::string word;
    long long size = -1;
    if (!(m_in >> word) || word != name || !(m_in >> size) || size < 0)
      throw Input_error("the signature has no '" + name + "' with a number where it should be");
    return static_cast<std::size_t>(size);
  }

  double read_number(const std::string& name)
  {
    double number = 0;
    if (!(m_in >> number) || !std::isfinite(number))
      throw Input_error("the signature is cut off or has no number among its '" + name + "'");
    return number;
  }

  Persistence_diagram_point read_point()
  {
    int kind = -1;
    Persistence_diagram_point point;
    if (!(m_in >> kind) || kind < 0 || kind > static_cast<int>(Persistence_pair_kind::LOOP))
      throw Input_error("the signature is cut off or has an unknown kind in its diagram");
    point.kind = static_cast<Persistence_pair_kind>(kind);
    point.lower = read_number("diagram");
    point.upper = read_number("diagram");
    if (point.upper < point.lower)
      throw Input_error("a point of the diagram of the signature lies below the diagonal");
    return point;
  }

  std::istream& m_in;
};

} // namespace internal

namespace IO {

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a signature as text: a line with the name and the version of the format, then for every list
its name, the number of its entries, and these, last the diagram with the kind (a number in the order
of `Persistence_pair_kind`), the lower and the higher value of every point. What is read back is
exactly the same, on any machine and with any locale.

\param out the stream
\param signature the signature

\return `true` if the stream is good afterwards

\sa `read_shape_signature()`
*/
inline bool write_shape_signature(std::ostream& out, const Shape_signature& signature)
{
  const internal::Exact_output exact_output(out);
  out << internal::shape_signature_title << '\n';
  internal::for_each_list(signature, [&out](const char* name, const std::vector<double>& values) {
    out << name << ' ' << values.size();
    for (std::size_t i = 0; i < values.size(); ++i)
      out << (i % 8 == 0 ? '\n' : ' ') << values[i];
    out << '\n';
  });
  out << "volume 1\n" << signature.volume << "\ndiagram " << signature.graph.diagram.size() << '\n';
  for (const Persistence_diagram_point& point : signature.graph.diagram)
    out << static_cast<int>(point.kind) << ' ' << point.lower << ' ' << point.upper << '\n';
  return out.good();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

writes a signature to a file, which is replaced if it exists.

\param filename the name of the file
\param signature the signature

\return `true` if the file could be written
*/
inline bool write_shape_signature(const std::string& filename, const Shape_signature& signature)
{
  return internal::write_file(
      filename, [&](std::ostream& out) { IO::write_shape_signature(out, signature); });
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

reads a signature that `write_shape_signature()` has written, and checks everything that
`shape_distance()` relies on.

\param in the stream; it is read to its end

\throws Input_error if the text is no signature of this version of the format, is cut off or goes on,
        or if a number is not finite, or negative where it cannot be
*/
inline Shape_signature read_shape_signature(std::istream& in)
{
  const boost::io::ios_flags_saver flags(in);
  const boost::io::ios_locale_saver locale(in, std::locale::classic());
  in.flags(std::ios_base::dec | std::ios_base::skipws);
  return internal::Shape_signature_reader(in).read();
}

/*!
\ingroup PkgSurfaceMeshReebGraphIO

reads a signature from a file.

\param filename the name of the file

\throws Input_error as for a stream, or if the file cannot be opened; the message begins with the name
*/
inline Shape_signature read_shape_signature(const std::string& filename)
{
  std::ifstream in(filename);
  if (!in)
    throw Input_error(filename + ": cannot be opened");
  try {
    return IO::read_shape_signature(in);
  } catch (const Input_error& error) {
    throw Input_error(filename + ": " + error.what());
  }
}

} // namespace IO
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_IO_SHAPE_SIGNATURE_FILE_H
