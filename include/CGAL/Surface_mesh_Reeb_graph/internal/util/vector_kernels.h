// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_VECTOR_KERNELS_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_VECTOR_KERNELS_H

#include <Eigen/Core>

#include <cstring>

// Kernels are written once, with vectors of `width` numbers, as static functions `run()` of a class:
//
//   struct Kernel
//   {
//     template <int width>
//     static CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void run(...);
//   };
//
// Programs for any 64-bit processor of Intel's or AMD's have vectors of two numbers of type double.
// `run_kernel<Kernel>(...)` compiles a kernel for processors with AVX2 and FMA as well, whose
// vectors have four, and calls what the processor at hand can do: that takes half of the time. The
// attribute `target_clones` would do the same, but needs a loader that resolves indirect functions,
// which some systems do not have, and which tools that instrument a program do not like.
//
// Both versions are templates or inline functions, none of them is inlined into its caller, and the
// version without AVX2 is the only one for other processors. Where the compiler has no vectors of its
// own, those of Eigen take their place.

#if defined(__GNUC__)
#define CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE __attribute__((always_inline)) inline
#define CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE __attribute__((noinline))
#define CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL _Pragma("GCC unroll 32")
#if defined(__x86_64__) && !(defined(__AVX2__) && defined(__FMA__))
#define CGAL_SURFACE_MESH_REEB_GRAPH_DISPATCHES_KERNELS
#endif
#else
#define CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE inline
#define CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE
#define CGAL_SURFACE_MESH_REEB_GRAPH_UNROLL
#endif

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

#if defined(__GNUC__)
template <class Scalar, int width>
struct Vector_type
{
  using type __attribute__((vector_size(width * sizeof(Scalar)))) = Scalar;
};

template <class Scalar, int width>
using Vector = typename Vector_type<Scalar, width>::type;
#else
template <class Scalar, int width>
using Vector = Eigen::Array<Scalar, width, 1>;
#endif

// No vector is passed by value: how that is done depends on the instructions that are enabled.
template <class V, class Scalar>
CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void load(V& v, const Scalar* from)
{
  std::memcpy(&v, from, sizeof(V));
}

// Numbers of type float or double as those of type double.
template <int width, class Number>
CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void
load_converted(Vector<double, width>& v, const Number* from)
{
  Vector<Number, width> x;
  load(x, from);
#if defined(__GNUC__)
  v = __builtin_convertvector(x, Vector<double, width>);
#else
  v = x.template cast<double>();
#endif
}

template <class V, class Scalar>
CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void store(const V& v, Scalar* to)
{
  std::memcpy(to, &v, sizeof(V));
}

template <class V, class Scalar>
CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void fill(V& v, Scalar x)
{
#if defined(__GNUC__)
  v = x - V{};
#else
  v.setConstant(x);
#endif
}

// `v = max(v, w)`
template <class V>
CGAL_SURFACE_MESH_REEB_GRAPH_ALWAYS_INLINE void raise(V& v, const V& w)
{
#if defined(__GNUC__)
  v = v < w ? w : v;
#else
  v = v.max(w);
#endif
}

#ifdef CGAL_SURFACE_MESH_REEB_GRAPH_DISPATCHES_KERNELS

inline bool has_avx2()
{
  static const bool result = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return result;
}

template <class Kernel, class... Arguments>
__attribute__((target("avx2,fma"), noinline)) void run_with_avx2(Arguments... arguments)
{
  Kernel::template run<4>(arguments...);
}

template <class Kernel, class... Arguments>
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE void run_without_avx2(Arguments... arguments)
{
  Kernel::template run<2>(arguments...);
}

template <class Kernel, class... Arguments>
void run_kernel(Arguments... arguments)
{
  (has_avx2() ? run_with_avx2<Kernel, Arguments...>
              : run_without_avx2<Kernel, Arguments...>)(arguments...);
}

#else

template <class Kernel, class... Arguments>
CGAL_SURFACE_MESH_REEB_GRAPH_NOINLINE void run_kernel(Arguments... arguments)
{
#if defined(__AVX2__) && defined(__FMA__)
  Kernel::template run<4>(arguments...);
#else
  Kernel::template run<2>(arguments...);
#endif
}

#endif

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_UTIL_VECTOR_KERNELS_H
