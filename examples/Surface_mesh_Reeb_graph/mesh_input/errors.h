#ifndef MESH_INPUT_ERRORS_H
#define MESH_INPUT_ERRORS_H

#include <cstddef>
#include <stdexcept>
#include <string>

// Something is wrong with a file.
struct File_error : std::runtime_error
{
  File_error(const std::string& file, const std::string& what)
    : std::runtime_error(file + ": " + what)
  {}
};

// Something is wrong with the options, alone or together with the mesh that they are meant for.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Something is wrong with the content of a file whose name the thrower does not know.
struct Content_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// An element of a file in messages, such as "vertex 7". Numbers are those of the file, from 0 on.
struct Element
{
  const char* kind;
  std::size_t number;

  std::string name() const { return std::string(kind) + ' ' + std::to_string(number); }
};

// What is said of a polygon that names a vertex which is not there.
inline std::string
no_such_vertex(const Element& polygon, const std::string& vertex, std::size_t number_of_vertices)
{
  return polygon.name() + ": there is no vertex " + vertex + "; there are " +
         std::to_string(number_of_vertices) + ", numbered from 0";
}

#endif // MESH_INPUT_ERRORS_H
