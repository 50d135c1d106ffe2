#ifndef MESH_INPUT_TEXT_H
#define MESH_INPUT_TEXT_H

#include "errors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// Numbers, words and lines of text, in every locale the same.

inline bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n';
}

inline char to_lower(char c)
{
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline bool equal_ignoring_case(std::string_view a, std::string_view b)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char c, char d) {
           return to_lower(c) == to_lower(d);
         });
}

inline bool begins_with(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

// What is found where something else should be, for a message: short, and without bytes that a
// terminal would not show.
inline std::string quoted(std::string_view text)
{
  constexpr std::size_t longest = 20;
  std::string result = "'";
  for (const char c : text.substr(0, longest))
    result += ' ' <= c && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

// Removes and returns the first word of `line`; empty if there is none.
inline std::string_view next_word(std::string_view& line)
{
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end]))
    ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

template <class Integer>
bool parse_integer(std::string_view word, Integer& number)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

// Numbers out of the range of doubles become zero or infinite.
inline bool parse_double(std::string_view word, double& number)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (end != word.data() + word.size())
    return false;
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_tiny = exponent != std::string_view::npos ? word.substr(exponent + 1, 1) == "-"
                                                            : word.find('.') != word.npos;
    number = is_tiny ? 0 : std::numeric_limits<double>::infinity();
    return true;
  }
  return error == std::errc();
}

// The lines of a text. They end with a line feed, a carriage return, or both.
class Lines
{
public:
  explicit Lines(std::string_view text) : m_rest(text) {}

  bool next(std::string_view& line)
  {
    if (m_rest.empty())
      return false;
    ++m_number;
    const std::size_t end = (std::min)(m_rest.find_first_of("\r\n"), m_rest.size());
    line = m_rest.substr(0, end);
    const bool has_two = m_rest.substr(end, 2) == "\r\n";
    m_rest.remove_prefix((std::min)(m_rest.size(), end + (has_two ? 2 : 1)));
    return true;
  }

  // The next line that has a word in it; what follows a `comment` character is left out.
  bool next_with_words(std::string_view& line, char comment)
  {
    while (next(line)) {
      line = line.substr(0, line.find(comment));
      std::string_view copy = line;
      if (!next_word(copy).empty())
        return true;
    }
    return false;
  }

  // Passes over bytes that are no lines.
  void skip(std::size_t size) { m_rest.remove_prefix(size); }

  std::size_t number() const { return m_number; } // of the line that was read last, from 1 on
  std::string_view rest() const { return m_rest; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Content_error("line " + std::to_string(m_number) + ": " + what);
  }

private:
  std::string_view m_rest;
  std::size_t m_number = 0;
};

// "1 face", "2 faces"
inline std::string counted(std::size_t number, const std::string& one, const std::string& several)
{
  return std::to_string(number) + ' ' + (number == 1 ? one : several);
}

inline std::string counted(std::size_t number, const std::string& one)
{
  return counted(number, one, one + 's');
}

// Removes and returns three coordinates from the beginning of `line`, which are those of `element`.
inline std::array<double, 3>
read_coordinates(const Lines& lines, std::string_view& line, const Element& element)
{
  std::array<double, 3> point = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = next_word(line);
    if (word.empty())
      lines.fail(element.name() + " has " + counted(i, "coordinate") + " instead of 3");
    if (!parse_double(word, point[i]))
      lines.fail(element.name() + ": the coordinate " + quoted(word) + " is not a number");
    if (!std::isfinite(point[i]))
      lines.fail(element.name() + ": the coordinate " + quoted(word) + " is not finite");
  }
  return point;
}

#endif // MESH_INPUT_TEXT_H
