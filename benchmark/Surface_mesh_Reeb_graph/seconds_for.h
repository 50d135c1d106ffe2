// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time that a task takes.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_SECONDS_FOR_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_SECONDS_FOR_H

#include <chrono>

namespace Reeb_graph_benchmark {

template <class Task>
double seconds_for(const Task& task)
{
  const auto start = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_SECONDS_FOR_H
