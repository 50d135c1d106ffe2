// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_EXCEPTIONS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_EXCEPTIONS_H

#include <exception>
#include <stdexcept>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {

/*!
\ingroup PkgSurfaceMeshReebGraphExceptions

The base class of what is thrown when the *data* make a computation impossible: what only the
computation itself can find out about a mesh, a function or a graph. It is thrown in every build mode;
`what()` says what was found and where. All outputs of the function that throws are left as they were.

An argument that the programmer chooses and can check (an index out of range, a negative threshold,
time or number of samples, an axis without direction) is a precondition instead, as everywhere in
\cgal: `CGAL::Precondition_exception`, unless preconditions are switched off, as `NDEBUG` does.
Whoever takes such arguments from a user, as the command-line tool does, checks them before.
*/
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
\ingroup PkgSurfaceMeshReebGraphExceptions

The exception thrown when the input is none that the function is defined for: a face that is not a
triangle, a vertex with several fans of faces, a value or a coordinate that is not a number, a
surface without area, a Reeb graph that is not that of the function.
*/
class Input_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgSurfaceMeshReebGraphExceptions

The exception thrown when nothing is wrong with the input but floating-point numbers, or the limits
of an iteration, do not suffice: a factorization that failed, an eigensolver that did not converge.
*/
class Numerical_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgSurfaceMeshReebGraphExceptions

The exception thrown when an algorithm meets what its invariants rule out although the input has
been found valid. It is a defect of this package, not of the input; please report it.
*/
class Internal_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgSurfaceMeshReebGraphExceptions

The exception thrown when the function that the user gave by the named parameter `callback` returned
`false`. It is no error and does not derive from `Error`. All outputs are left as they were.
*/
class Interruption : public std::exception
{
public:
  const char* what() const noexcept override
  {
    return "the computation was interrupted by the callback";
  }
};

} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_EXCEPTIONS_H
