// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The memory that a part of a program has in use at most, whoever hands it out: libraries in C and
// Eigen do not ask `operator new`. For Linux, which lets a process forget its peak.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_RESIDENT_MEMORY_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_RESIDENT_MEMORY_H

#include <cstddef>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>
#include <sys/mman.h>

namespace Reeb_graph_benchmark {

// Uses so many bytes and frees them again. Virtual machines take seconds per gigabyte for memory
// that is used for the first time after a while, which would be charged to whoever comes first.
inline void warm_up_memory(const std::size_t bytes)
{
  // not by malloc(), which would remember the size
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    return;
  madvise(memory, bytes, MADV_HUGEPAGE);
  std::memset(memory, 1, bytes);
  munmap(memory, bytes);
}

// The bytes of pages in use since its construction: at most, without those in use before.
class Resident_memory_meter
{
public:
  Resident_memory_meter()
  {
    // what was freed before would be used again, and not be seen
    malloc_trim(0);
    std::ofstream clear("/proc/self/clear_refs");
    if (!(clear << "5" << std::flush))
      throw std::runtime_error("the peak of the memory in use cannot be reset");
    m_before = bytes_of("VmRSS:");
  }

  std::size_t peak() const
  {
    const std::size_t peak = bytes_of("VmHWM:");
    return peak > m_before ? peak - m_before : 0;
  }

private:
  static std::size_t bytes_of(const std::string& entry)
  {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
      std::size_t kilobytes;
      if (word == entry && status >> kilobytes)
        return 1024 * kilobytes;
    }
    throw std::runtime_error("the memory in use cannot be read");
  }

  std::size_t m_before;
};

} // namespace Reeb_graph_benchmark

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_RESIDENT_MEMORY_H
