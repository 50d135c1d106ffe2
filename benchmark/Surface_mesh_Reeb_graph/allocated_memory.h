// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts the memory that `operator new` hands out, in one thread. It replaces the global operators,
// so only one source file of a program may include it.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEMORY_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEMORY_H

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace Reeb_graph_benchmark {

// Several threads may allocate, but the peak is exact for one only.
inline std::atomic<std::size_t> live_bytes(0);
inline std::atomic<std::size_t> peak_bytes(0);

// What was allocated since its construction: at most, and now.
class Memory_meter
{
public:
  Memory_meter() : m_before(live_bytes) { peak_bytes = live_bytes.load(); }

  std::size_t peak() const { return peak_bytes - m_before; }
  std::size_t live() const { return live_bytes - m_before; }

private:
  std::size_t m_before;
};

} // namespace Reeb_graph_benchmark

// Not inlined, because compilers pair what they see inside, malloc() with delete, and warn.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  using namespace Reeb_graph_benchmark;
  void* const block = std::malloc(size);
  if (block == nullptr)
    throw std::bad_alloc();
  const std::size_t size_of_block = malloc_usable_size(block);
  const std::size_t live =
      live_bytes.fetch_add(size_of_block, std::memory_order_relaxed) + size_of_block;
  if (peak_bytes.load(std::memory_order_relaxed) < live)
    peak_bytes.store(live, std::memory_order_relaxed);
  return block;
}

[[gnu::noinline]] void operator delete(void* block) noexcept
{
  Reeb_graph_benchmark::live_bytes.fetch_sub(malloc_usable_size(block), std::memory_order_relaxed);
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_MEMORY_H
