// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_INTERLEAVED_TASKS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_INTERLEAVED_TASKS_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// Works on tasks of many small steps, each of which begins with a cache miss: several of them are
// interleaved, so that their misses overlap (asynchronous memory access chaining, AMAC).
// `begin(task)` sets up the next task and returns false if there is none, `advance(task)` takes a
// step and returns false if the task is done. The tasks are objects that are used again.
//
// `stages` are what every step begins with. Each is done for all tasks before the next one, so that
// what a stage reads is in the cache when the next one needs it: a stage should read and not branch
// on what it reads.
template <class Task, class Begin, class Advance, class... Stages>
void run_interleaved(std::vector<Task>& tasks,
                     const Begin& begin,
                     const Advance& advance,
                     const Stages&... stages)
{
  std::vector<Task*> active;
  active.reserve(tasks.size());
  for (Task& task : tasks)
    if (begin(task))
      active.push_back(&task);
  [[maybe_unused]] const auto for_each_active = [&active](const auto& stage) {
    for (Task* task : active)
      stage(*task);
  };
  while (!active.empty()) {
    (for_each_active(stages), ...);
    for (std::size_t i = 0; i < active.size();) {
      if (advance(*active[i]) || begin(*active[i])) {
        ++i;
      } else {
        active[i] = active.back();
        active.pop_back();
      }
    }
  }
}

// About as many cache misses as a processor can have outstanding.
constexpr std::size_t number_of_interleaved_tasks = 16;

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_INTERLEAVED_TASKS_H
