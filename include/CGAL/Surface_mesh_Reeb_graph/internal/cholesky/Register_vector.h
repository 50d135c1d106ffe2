// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_REGISTER_VECTOR_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_REGISTER_VECTOR_H

#include <Eigen/Core>

#include <utility>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

enum class Packet_size { FULL, HALF, ONE };

// Eigen's packet of the given size, and how many numbers it has. The size is not asked for by the
// type: a type with attributes as a template argument makes compilers warn.
template <class Scalar, Packet_size>
struct Packet_of
{
  using type = typename Eigen::internal::packet_traits<Scalar>::type;
  static constexpr int size = Eigen::internal::packet_traits<Scalar>::size;
};

template <class Scalar>
struct Packet_of<Scalar, Packet_size::HALF>
{
  using type = typename Eigen::internal::packet_traits<Scalar>::half;
  static constexpr int size = Eigen::internal::packet_traits<Scalar>::size / 2;
};

template <class Scalar>
struct Packet_of<Scalar, Packet_size::ONE>
{
  using type = Scalar;
  static constexpr int size = 1;
};

// `Size` numbers that stay in registers, in Eigen's packets where these fit. Eigen's own vectors of
// fixed size leave temporaries in memory unless the compiler optimizes for speed at any size.
template <class Scalar, int Size>
class Register_vector
{
  using Traits = Eigen::internal::packet_traits<Scalar>;
  static constexpr bool has_half = Traits::HasHalfPacket;

  using Choice = Packet_of<Scalar,
                           Size % Traits::size == 0 ? Packet_size::FULL
                           : has_half && Size % (Traits::size > 1 ? Traits::size / 2 : 1) == 0
                               ? Packet_size::HALF
                               : Packet_size::ONE>;
  using Packet = typename Choice::type;

  static constexpr int packet_size = Choice::size;
  using Indices = std::make_integer_sequence<int, Size / packet_size>;

public:
  static EIGEN_STRONG_INLINE Register_vector load(const Scalar* x) { return {x, Indices()}; }

  EIGEN_STRONG_INLINE void store(Scalar* x) const { store(x, Indices()); }

  // *this -= factor * x
  EIGEN_STRONG_INLINE void subtract(const Scalar factor, const Register_vector& x)
  {
    subtract(Eigen::internal::pset1<Packet>(factor), x, Indices());
  }

  EIGEN_STRONG_INLINE void multiply(const Scalar factor)
  {
    multiply(Eigen::internal::pset1<Packet>(factor), Indices());
  }

private:
  template <int... I>
  EIGEN_STRONG_INLINE Register_vector(const Scalar* x, std::integer_sequence<int, I...>)
    : m_packets{Eigen::internal::ploadu<Packet>(x + I * packet_size)...}
  {}

  template <int... I>
  EIGEN_STRONG_INLINE void store(Scalar* x, std::integer_sequence<int, I...>) const
  {
    (Eigen::internal::pstoreu(x + I * packet_size, m_packets[I]), ...);
  }

  template <int... I>
  EIGEN_STRONG_INLINE void
  subtract(const Packet& factor, const Register_vector& x, std::integer_sequence<int, I...>)
  {
    using Eigen::internal::pmul;
    using Eigen::internal::psub;
    ((m_packets[I] = psub(m_packets[I], pmul(factor, x.m_packets[I]))), ...);
  }

  template <int... I>
  EIGEN_STRONG_INLINE void multiply(const Packet& factor, std::integer_sequence<int, I...>)
  {
    ((m_packets[I] = Eigen::internal::pmul(factor, m_packets[I])), ...);
  }

  Packet m_packets[Size / packet_size];
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_CHOLESKY_REGISTER_VECTOR_H
