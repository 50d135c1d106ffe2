// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh file from any bytes: the first one is a digit that chooses the format, the others are the
// file. So the seeds in the folder mesh_files are mesh files with a digit before them.

#ifndef SURFACE_MESH_REEB_GRAPH_FUZZ_MESH_FILE_FROM_BYTES_H
#define SURFACE_MESH_REEB_GRAPH_FUZZ_MESH_FILE_FROM_BYTES_H

#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/prepare_polygon_soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

struct Mesh_file_from_bytes
{
  std::string extension, content;
  Mesh_input_options options;

  Mesh_file_from_bytes(const std::uint8_t* data, std::size_t size)
  {
    constexpr std::size_t number_of_formats = 5;
    constexpr std::array<const char*, number_of_formats> extensions = {
        ".off", ".obj", ".ply", ".stl", ".vtk"};
    const std::size_t choice = size > 0 ? data[0] : 0;
    extension = extensions[choice % number_of_formats];
    if (size > 1)
      content.assign(reinterpret_cast<const char*>(data + 1), size - 1);
    // the digits are 48 to 57: in the upper half of them, what is off by default is on
    if (choice / number_of_formats % 2 == 0) {
      options.repair.split_nonmanifold_edges = true;
      options.repair.weld_distance = 0.01;
      options.property = "z";
    }
  }
};

inline void require(bool condition, const char* what)
{
  if (condition)
    return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

#endif // SURFACE_MESH_REEB_GRAPH_FUZZ_MESH_FILE_FROM_BYTES_H
