#include "read_polygon_soup.h"

#include "errors.h"
#include "readers.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

namespace {

#ifdef MESH_INPUT_WITH_VTK
constexpr std::array<std::string_view, 6> extensions = {
    ".off", ".obj", ".ply", ".stl", ".vtk", ".vtp"};
#else
constexpr std::array<std::string_view, 5> extensions = {".off", ".obj", ".ply", ".stl", ".vtk"};
#endif

std::string lower_extension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), to_lower);
  return extension;
}

// What programs take for a mesh by mistake.
void check_kind(std::string_view bytes)
{
  if (bytes.empty())
    throw Content_error("is empty");
  if (begins_with(bytes, "\x1f\x8b"))
    throw Content_error("is compressed by gzip; please unpack it");
  if (begins_with(bytes, "PK\x03\x04"))
    throw Content_error("is a zip archive; please unpack it");
  if (begins_with(bytes, "\xff\xfe") || begins_with(bytes, "\xfe\xff"))
    throw Content_error("is text in UTF-16; please save it as UTF-8 or ASCII");
  if (begins_with(bytes, "version https://git-lfs"))
    throw Content_error("is a pointer to a file of Git LFS, which has not been fetched");
  if (begins_with(bytes, "<!DOCTYPE") || begins_with(bytes, "<html"))
    throw Content_error("is a web page");
}

// What some editors write at the beginning of text, and old systems at its end.
std::string_view without_byte_order_mark(std::string_view bytes)
{
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return bytes.substr(begins_with(bytes, mark) ? mark.size() : 0);
}

std::string_view without_end_of_file(std::string_view bytes)
{
  constexpr char end_of_file = 0x1a;
  return bytes.substr(0, bytes.find_last_not_of(end_of_file) + 1);
}

} // namespace

std::string readable_formats()
{
#ifdef MESH_INPUT_WITH_VTK
  return "OFF, OBJ, PLY, STL, VTK and VTP";
#else
  return "OFF, OBJ, PLY, STL and VTK";
#endif
}

bool has_readable_format(const std::string& file)
{
  return std::find(extensions.begin(), extensions.end(), lower_extension(file)) != extensions.end();
}

bool format_has_properties(const std::string& file)
{
  const std::string extension = lower_extension(file);
  return extension == ".ply" || extension == ".vtp" || extension == ".vtk";
}

Polygon_soup
parse_polygon_soup(std::string_view bytes, std::string extension, const std::string& property)
{
  check_kind(bytes);
  Polygon_soup soup;
  if (extension == ".off")
    read_OFF(without_byte_order_mark(bytes), soup);
  else if (extension == ".obj")
    read_OBJ(without_byte_order_mark(without_end_of_file(bytes)), soup);
  else if (extension == ".ply")
    read_PLY(without_byte_order_mark(bytes), property, soup);
  else if (extension == ".stl")
    read_STL(without_byte_order_mark(bytes), soup);
  else if (extension == ".vtk")
    read_legacy_VTK(without_byte_order_mark(bytes), property, soup);
#ifdef MESH_INPUT_WITH_VTK
  else
    read_VTP(without_byte_order_mark(bytes), property, soup);
#endif
  return soup;
}

std::string read_bytes(const std::string& file)
{
  std::error_code error;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, error))
    throw File_error(file, "cannot be opened");
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad())
    throw File_error(file, "cannot be read");
  return bytes;
}

Polygon_soup read_polygon_soup(const std::string& file, const std::string& property)
{
  const std::string bytes = read_bytes(file);
  if (!has_readable_format(file))
    throw File_error(file, "is of an unknown type; " + readable_formats() + " files can be read");
  try {
    return parse_polygon_soup(bytes, lower_extension(file), property);
  } catch (const Content_error& error) {
    throw File_error(file, error.what());
  }
}
