#ifndef MESH_INPUT_BINARY_H
#define MESH_INPUT_BINARY_H

#include "errors.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

enum class Scalar_type {
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

inline std::size_t size_of(Scalar_type type)
{
  switch (type) {
  case Scalar_type::INT8:
  case Scalar_type::UINT8:
    return 1;
  case Scalar_type::INT16:
  case Scalar_type::UINT16:
    return 2;
  case Scalar_type::INT32:
  case Scalar_type::UINT32:
  case Scalar_type::FLOAT32:
    return 4;
  default:
    return 8;
  }
}

inline bool is_integer(Scalar_type type)
{
  return type != Scalar_type::FLOAT32 && type != Scalar_type::FLOAT64;
}

// Reads numbers from a part of a file, and never more than there is. `what` is the element that is
// being read, for the message.
class Bytes_in_file
{
public:
  Bytes_in_file(std::string_view file, std::size_t begin, bool is_big_endian)
    : m_file(file), m_position(begin), m_is_big_endian(is_big_endian)
  {}

  std::size_t left() const { return m_file.size() - m_position; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Content_error("byte " + std::to_string(m_position) + ": " + what);
  }

  void skip(std::size_t size, const Element& what)
  {
    if (size > left())
      fail_at_end(what);
    m_position += size;
  }

  void skip_each(std::size_t number, std::size_t size, const Element& what)
  {
    if (size > 0 && number > left() / size)
      fail_at_end(what);
    m_position += number * size;
  }

  // A number of an integral type. Those that do not fit become negative.
  std::int64_t integer(Scalar_type type, const Element& what)
  {
    const std::uint64_t bits = next(size_of(type), what);
    switch (type) {
    case Scalar_type::INT8:
      return static_cast<std::int8_t>(bits);
    case Scalar_type::INT16:
      return static_cast<std::int16_t>(bits);
    case Scalar_type::INT32:
      return static_cast<std::int32_t>(bits);
    default:
      return static_cast<std::int64_t>(bits);
    }
  }

  double number(Scalar_type type, const Element& what)
  {
    if (type == Scalar_type::FLOAT32) {
      const auto bits = static_cast<std::uint32_t>(next(4, what));
      float result;
      std::memcpy(&result, &bits, 4);
      return result;
    }
    if (type == Scalar_type::FLOAT64) {
      const std::uint64_t bits = next(8, what);
      double result;
      std::memcpy(&result, &bits, 8);
      return result;
    }
    if (type == Scalar_type::UINT64)
      return static_cast<double>(next(8, what));
    return static_cast<double>(integer(type, what));
  }

private:
  std::uint64_t next(std::size_t size, const Element& what)
  {
    if (size > left())
      fail_at_end(what);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t byte = m_is_big_endian ? i : size - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(m_file[m_position + byte]);
    }
    m_position += size;
    return bits;
  }

  [[noreturn]] void fail_at_end(const Element& what) const
  {
    fail("the file ends within " + what.name());
  }

  std::string_view m_file;
  std::size_t m_position;
  bool m_is_big_endian;
};

#endif // MESH_INPUT_BINARY_H
