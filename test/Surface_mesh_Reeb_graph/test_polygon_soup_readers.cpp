// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readers of mesh files on small files: what people and programs write, and what is no mesh.

#define BOOST_TEST_MODULE polygon_soup_readers

#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/errors.h"
#include "../../examples/Surface_mesh_Reeb_graph/mesh_input/read_polygon_soup.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
  for (std::size_t i = text.find(what); i != text.npos; i = text.find(what, i + with.size()))
    text.replace(i, what.size(), with);
  return text;
}

std::string upper(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

// Numbers in binary files.
template <class Number>
std::string bytes_of(Number number, bool is_big_endian = false)
{
  std::string bytes(sizeof(Number), ' ');
  std::memcpy(&bytes[0], &number, sizeof(Number)); // this machine is taken to be little-endian
  if (is_big_endian)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

using Points = std::vector<std::array<double, 3>>;
using Faces = std::vector<std::vector<std::size_t>>;

// All test files that are read hold this tetrahedron.
const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -2.5}}};
const Faces faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

const std::string vertex_lines = "0 0 0\n1 0 0\n0 1 0\n0 0 -2.5\n";
const std::string face_lines = "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";
const std::string off = "OFF\n4 4 6\n" + vertex_lines + face_lines;
const std::string obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -2.5\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

void check_tetrahedron(const std::string& extension,
                       const std::string& content,
                       std::size_t number_of_notices = 0)
{
  BOOST_TEST_CONTEXT(extension << ": " << content.substr(0, 300))
  {
    Polygon_soup soup;
    BOOST_REQUIRE_NO_THROW(soup = parse_polygon_soup(content, extension));
    BOOST_TEST((soup.points == points));
    Faces found;
    for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
      found.emplace_back(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first[i]),
                         soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first[i + 1]));
    BOOST_TEST((found == faces));
    BOOST_TEST(soup.notices.size() == number_of_notices);
  }
}

// The message has all the words in it.
void check_error(const std::string& extension,
                 const std::string& content,
                 const std::vector<std::string>& words)
{
  BOOST_TEST_CONTEXT(extension << ": " << content.substr(0, 300))
  {
    std::string message = "no error";
    try {
      parse_polygon_soup(content, extension);
    } catch (const Content_error& error) {
      message = error.what();
    }
    for (const std::string& word : words)
      BOOST_TEST(message.find(word) != message.npos, message << " does not say " << word);
    BOOST_TEST(message.find('\n') == message.npos);
  }
}

// ---- PLY and STL in all their kinds ---------------------------------------------------------------

enum Encoding { TEXT, LITTLE, BIG };

template <class Number>
void append(std::string& data, Encoding encoding, Number number)
{
  if (encoding == TEXT)
    data += std::to_string(number) + ' ';
  else
    data += bytes_of(number, encoding == BIG);
}

std::string ply_header(Encoding encoding,
                       const std::string& vertex_properties,
                       const std::string& face_properties,
                       bool has_faces_first = false)
{
  const std::string vertex = "element vertex 4\n" + vertex_properties,
                    face = "element face 4\n" + face_properties;
  const char* const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  return std::string("ply\nformat ") + names[encoding] + " 1.0\n" +
         (has_faces_first ? face + vertex : vertex + face) + "end_header\n";
}

template <class Coordinate>
std::string ply_vertices(Encoding encoding)
{
  std::string data;
  for (const auto& p : points) {
    for (const double x : p)
      append(data, encoding, static_cast<Coordinate>(x));
    data += encoding == TEXT ? "\n" : "";
  }
  return data;
}

template <class Size, class Index>
std::string ply_faces(Encoding encoding)
{
  std::string data;
  for (const auto& face : faces) {
    append(data, encoding, static_cast<Size>(face.size()));
    for (const std::size_t v : face)
      append(data, encoding, static_cast<Index>(v));
    data += encoding == TEXT ? "\n" : "";
  }
  return data;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "property list uchar int vertex_indices\n";

template <class Size, class Index>
void check_index_types(const std::string& size_name, const std::string& index_name)
{
  for (const Encoding encoding : {TEXT, LITTLE, BIG})
    check_tetrahedron(
        ".ply",
        ply_header(
            encoding, xyz, "property list " + size_name + ' ' + index_name + " vertex_index\n") +
            ply_vertices<float>(encoding) + ply_faces<Size, Index>(encoding));
}

std::string stl_text()
{
  std::string text = "solid a name\n";
  for (const auto& face : faces) {
    text += " facet normal 0 0 1\n  outer loop\n";
    for (const std::size_t v : face) {
      const auto& p = points[v];
      text += "   vertex " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' +
              std::to_string(p[2]) + '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a name\n";
}

std::string stl_binary(const std::string& header)
{
  std::string bytes = header + std::string(80 - header.size(), '\0') + bytes_of(std::uint32_t(4));
  for (const auto& face : faces) {
    bytes += std::string(12, '\xff'); // a normal that is not a number
    for (const std::size_t v : face)
      for (const double x : points[v])
        bytes += bytes_of(static_cast<float>(x));
    bytes += "\x12\x34";
  }
  return bytes;
}

} // namespace

BOOST_AUTO_TEST_CASE(OFF_files)
{
  check_tetrahedron(".off", off);
  for (const std::string header : {"OFF 4 4 6\n",
                                   "OFF4 4 6\n",
                                   "OFF  \t\n4 4\n",
                                   "\xef\xbb\xbfOFF\n4 4 6\n",
                                   "4 4 6\n",
                                   "# text\nOFF # of\n\n# counts\n4 4 6 # all\n\n",
                                   "OFF\n4\n4\n",
                                   "off\n4 4 6\n"})
    check_tetrahedron(".off", header + vertex_lines + face_lines);
  for (const std::string end : {"\r\n", "\r"})
    check_tetrahedron(".off", replaced(off, "\n", end));
  check_tetrahedron(".off", off.substr(0, off.size() - 1));
  check_tetrahedron(".off", replaced(off, " ", "\t "));
  check_tetrahedron(".off", replaced(off, "3 0 1 2", "3 0 1 2 255 0 0"));
  check_tetrahedron(".off", replaced(off, "3 0 1 2", "3 0 1 2 0.5 1 0.5 1 # red"));
  check_tetrahedron(".off", replaced(off, "0 0 -2.5", "+0 0e0 -25e-1"));
  check_tetrahedron(".off", off + "\n# end\n\n");
  check_tetrahedron(".off", off + "3 0 1 2\n", 1);
  // attributes
  const auto vertices_with = [](const std::string& attributes) {
    return replaced(vertex_lines, "\n", attributes + '\n') + face_lines;
  };
  for (const std::string prefix : {"C", "N", "CN", "NC", "ST", "STCN", ""})
    check_tetrahedron(".off", prefix + "OFF\n4 4 6\n" + vertices_with(" 1 0 0 1"));
  check_tetrahedron(".off", "4OFF\n4 4 6\n" + vertices_with(" 1"));
  check_tetrahedron(".off", "4OFF\n4 4 6\n0 0 0 3\n2 0 0 2\n0 2 0 2\n0 0 -5 2\n" + face_lines);
  // binary
  std::string binary = "COFF BINARY\n";
  for (const int count : {4, 4, 6})
    binary += bytes_of(count, true);
  for (const auto& p : points) {
    for (const double x : p)
      binary += bytes_of(static_cast<float>(x), true);
    binary += std::string(16, '\x7f');
  }
  for (const auto& face : faces) {
    binary += bytes_of(3, true);
    for (const std::size_t v : face)
      binary += bytes_of(static_cast<int>(v), true);
    binary += bytes_of(1, true) + std::string(4, 'x');
  }
  check_tetrahedron(".off", binary);
  check_tetrahedron(".off", binary + "more", 1);
  for (std::size_t size = 13; size < binary.size(); ++size)
    check_error(".off", binary.substr(0, size), {"byte", "ends within"});
}

BOOST_AUTO_TEST_CASE(damaged_OFF_files)
{
  check_error(".off", "", {"empty"});
  check_error(".off", "# nothing\n", {"nothing but comments"});
  check_error(".off", "no mesh at all", {"line 1", "'no'", "OFF"});
  check_error(".off", "XOFF\n" + off.substr(4), {"line 1", "'XOFF'"});
  check_error(".off", "NNOFF\n" + off.substr(4), {"line 1", "'NNOFF'"});
  check_error(".off", "nOFF\n3\n" + off.substr(4), {"line 1", "dimensions"});
  check_error(".off", "OFF\n", {"ends before its numbers"});
  check_error(".off", "OFF\n4 x 6\n", {"line 2", "'x'", "faces"});
  check_error(".off", "OFF\n-4 1 6\n", {"line 2", "'-4'", "vertices"});
  check_error(".off", "OFF\n99999999999999999999 1 6\n", {"line 2", "vertices"});
  check_error(".off", "OFF\n4000000000 1 0\n0 0 0\n", {"ends before vertex 1 of 4000000000"});
  check_error(".off", "OFF\n4 2000000000 0\n" + vertex_lines, {"ends before face 0 of 2000000000"});
  check_error(".off", replaced(off, "1 0 0\n", "1 0\n"), {"line 4", "vertex 1", "2 coordinates"});
  check_error(".off", replaced(off, "1 0 0\n", "1,5 0 0\n"), {"line 4", "vertex 1", "'1,5'"});
  check_error(".off", replaced(off, "1 0 0\n", "nan 0 0\n"), {"line 4", "vertex 1", "'nan'"});
  check_error(".off", replaced(off, "1 0 0\n", "1e999 0 0\n"), {"line 4", "vertex 1", "finite"});
  check_error(".off", replaced(off, "1 0 0\n", "1x 0 0\n"), {"line 4", "vertex 1", "'1x'"});
  check_error(
      ".off", replaced(off, "3 0 2 3", "3 0 2 4"), {"line 8", "face 1", "vertex '4'", "4,"});
  check_error(".off", replaced(off, "3 0 2 3", "3 0 2 -1"), {"line 8", "face 1", "'-1'"});
  check_error(".off", replaced(off, "3 0 2 3", "3 0 2 3.5"), {"line 8", "face 1", "'3.5'"});
  check_error(".off", replaced(off, "3 0 2 3", "3 0 2"), {"line 8", "face 1", "2 corners instead"});
  check_error(".off", replaced(off, "3 0 2 3", "2 0 2"), {"line 8", "face 1", "2 corners"});
  check_error(".off", replaced(off, "3 0 2 3", "1 0"), {"line 8", "face 1", "1 corner"});
  check_error(".off", replaced(off, "3 0 2 3", "0"), {"line 8", "face 1", "0 corners"});
  check_error(".off", replaced(off, "3 0 2 3", "-3 0 2 3"), {"line 8", "face 1", "'-3'"});
  check_error(".off", replaced(off, "3 0 2 3", "x"), {"line 8", "face 1", "'x'"});
  check_error(".off", off.substr(0, off.rfind("3 1")), {"ends before face 3 of 4"});
  check_error(".off", "4OFF\n4 4 6\n" + vertex_lines + face_lines, {"line 3", "fourth"});
  check_error(".off", "4OFF\n1 0 0\n1 1 1 0\n", {"vertex 0", "finite"});
  check_error(".off", "OFF BINARY\n" + bytes_of(-1, true), {"negative"});
  check_error(".off", "\xff\xfeO", {"UTF-16"});
  check_error(".off", "\x1f\x8b", {"gzip"});
  check_error(".off", "<!DOCTYPE html>", {"web page"});
  check_error(".off", "version https://git-lfs.github.com/spec/v1\n", {"Git LFS"});
}

BOOST_AUTO_TEST_CASE(OBJ_files)
{
  check_tetrahedron(".obj", obj);
  for (const std::string end : {"\r\n", "\r", " \n", "\t\r\n"})
    check_tetrahedron(".obj", replaced(obj, "\n", end));
  check_tetrahedron(".obj", replaced(obj, " ", "\t"));
  check_tetrahedron(".obj", replaced(obj, " ", "   "));
  check_tetrahedron(".obj", "  " + replaced(obj, "\n", "\n\t"));
  check_tetrahedron(".obj", obj.substr(0, obj.size() - 1));
  check_tetrahedron(".obj", obj + '\x1a');
  check_tetrahedron(".obj", "\xef\xbb\xbf" + obj);
  check_tetrahedron(".obj", "\xef\xbb\xbf# text\n" + obj);
  check_tetrahedron(".obj", replaced(obj, " 3", " \\\n3"));
  check_tetrahedron(".obj", replaced(obj, " -2.5", " \\\n \\ \n -2.5"));
  check_tetrahedron(".obj", replaced(obj, "\n", " # text\n"));
  check_tetrahedron(".obj", "# C:\\folder\\\nmtllib C:\\folder\\\n" + obj);
  check_tetrahedron(".obj", replaced(obj, "1 0 0\n", "1 0 0 1\n"));
  check_tetrahedron(".obj", replaced(obj, "1 0 0\n", "1 0 0 0.5 0.5 0.5\n"));
  for (const std::string attributes : {"/1", "/1/2", "//2", "/", "//", "/-1/-2"})
    check_tetrahedron(".obj", replaced(obj, "f 1 2 3", "f 1" + attributes + " 2 3" + attributes));
  check_tetrahedron(".obj", replaced(obj, "f 1 2 3", "f -4 -3 -2"));
  check_tetrahedron(".obj", replaced(obj, "f 1 2 3", "fo 1 2 3"));
  check_tetrahedron(".obj", obj.substr(obj.find('f')) + obj.substr(0, obj.find('f')));
  check_tetrahedron(".obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 -2.5\nf 1 3 4\n"
                    "f -4 -1 -3\nf 2 4 3\n");
  check_tetrahedron(".obj",
                    "o a\ng b c\ns off\nusemtl d\nvt 0 0\nvn 0 0 nan\n" + obj + "l 1 2\np 1\n");
  check_tetrahedron(".obj", obj + "curv 0 1 2\nsurf 0 1\n", 1);
}

BOOST_AUTO_TEST_CASE(damaged_OBJ_files)
{
  check_error(".obj", "hello\n", {"no vertices"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 0 3 4"), {"line 6", "face 1", "vertex 0"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 6"), {"line 6", "vertex 6", "4,"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 9999999999"), {"line 6", "9999999999"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 99999999999999999999"), {"line 6", "'9999"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 -5"), {"line 6", "-5", "4 vertices"});
  check_error(".obj", "v 0 0 0\nf -1 -2 -3\nv 0 0 0\nv 0 0 0\n", {"line 2", "-2", "1 vertex"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 4.7"), {"line 6", "face 1", "'4.7'"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 a"), {"line 6", "face 1", "'a'"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3 4/x"), {"line 6", "face 1", "'4/x'"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f 1 3"), {"line 6", "face 1", "2 corners"});
  check_error(".obj", replaced(obj, "f 1 3 4", "f"), {"line 6", "face 1", "0 corners"});
  check_error(".obj", replaced(obj, "f 1 3 4", "F 1 3 4"), {"line 6", "'F'"});
  check_error(".obj", replaced(obj, "v 1 0 0", "V 1 0 0"), {"line 2", "'V'"});
  check_error(".obj", replaced(obj, "v 1 0 0", "v1 0 0"), {"line 2", "'v1'"});
  check_error(".obj", replaced(obj, "v 1 0 0", "v 1 0"), {"line 2", "vertex 1", "2 coordinates"});
  check_error(".obj", replaced(obj, "v 1 0 0", "v 1,5 0 0"), {"line 2", "vertex 1", "'1,5'"});
  check_error(".obj", replaced(obj, "v 1 0 0", "v inf 0 0"), {"line 2", "vertex 1", "'inf'"});
}

BOOST_AUTO_TEST_CASE(PLY_files)
{
  for (const Encoding encoding : {TEXT, LITTLE, BIG}) {
    const std::string vertices = ply_vertices<float>(encoding),
                      polygons = ply_faces<std::uint8_t, std::int32_t>(encoding);
    const std::string header = ply_header(encoding, xyz, indices);
    check_tetrahedron(".ply", header + vertices + polygons);
    check_tetrahedron(".ply", "\xef\xbb\xbf" + header + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, "\n", "\r\n") + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, "\n", "\r") + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, "end_header", "end_header  ") + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, " vertex ", "  vertex\t") + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, "float", "float32") + vertices + polygons);
    check_tetrahedron(".ply", replaced(header, " 1.0", "") + vertices + polygons);
    check_tetrahedron(
        ".ply",
        replaced(header, "element vertex", "comment element vertex 3\nobj_info a\nelement vertex") +
            vertices + polygons);
    check_tetrahedron(".ply", ply_header(encoding, xyz, indices, true) + polygons + vertices);
    check_tetrahedron(".ply",
                      ply_header(encoding, replaced(xyz, "float", "double"), indices) +
                          ply_vertices<double>(encoding) + polygons);
    // other elements, also with lists
    std::string camera;
    append(camera, encoding, 1.5f);
    append(camera, encoding, std::int16_t(2));
    append(camera, encoding, std::int32_t(7));
    append(camera, encoding, std::int32_t(8));
    check_tetrahedron(".ply",
                      replaced(header,
                               "element face",
                               "element camera 1\nproperty float f\nproperty list short int l\n"
                               "element face") +
                          vertices + camera + (encoding == TEXT ? "\n" : "") + polygons);
    // other properties, before and behind; numbers that are none
    std::string more_vertices, more_faces;
    for (const auto& p : points) {
      append(more_vertices, encoding, std::uint8_t(200));
      append(more_vertices, encoding, static_cast<float>(p[2]));
      append(more_vertices, encoding, std::nanf(""));
      append(more_vertices, encoding, static_cast<float>(p[0]));
      append(more_vertices, encoding, static_cast<float>(p[1]));
      append(more_vertices, encoding, std::uint8_t(1));
      append(more_vertices, encoding, INFINITY);
      more_vertices += encoding == TEXT ? "\n" : "";
    }
    for (const auto& face : faces) {
      append(more_faces, encoding, std::uint8_t(2));
      append(more_faces, encoding, 0.5f);
      append(more_faces, encoding, 0.25f);
      append(more_faces, encoding, std::int32_t(-1));
      append(more_faces, encoding, std::uint8_t(face.size()));
      for (const std::size_t v : face)
        append(more_faces, encoding, std::uint16_t(v));
      append(more_faces, encoding, std::uint8_t(0));
      more_faces += encoding == TEXT ? "\n" : "";
    }
    check_tetrahedron(".ply",
                      ply_header(encoding,
                                 "property uchar red\nproperty float z\nproperty float nx\n"
                                 "property float x\nproperty float y\n"
                                 "property list uchar float quality\n",
                                 "property list uchar float texcoord\nproperty int texnumber\n"
                                 "property list uint8 ushort vertex_indices\n"
                                 "property uchar flags\n") +
                          more_vertices + more_faces);
    // a strip, of which each second triangle is turned; -1 begins another one
    std::string strip;
    for (const int number : {11, 1, 0, 2, 3, 1, -1, 0, 1, 3, 3, 3})
      append(strip, encoding, number);
    const Polygon_soup soup = parse_polygon_soup(
        replaced(ply_header(encoding, xyz, "property list int int vertex_indices\n"),
                 "face 4",
                 "tristrips 1") +
            vertices + strip,
        ".ply");
    BOOST_TEST(soup.corners == (std::vector<std::size_t>{1, 0, 2, 2, 0, 3, 2, 3, 1, 0, 1, 3}),
               boost::test_tools::per_element());
  }
  check_index_types<std::uint8_t, std::int8_t>("uchar", "char");
  check_index_types<std::int8_t, std::uint8_t>("char", "uchar");
  check_index_types<std::uint16_t, std::int16_t>("ushort", "short");
  check_index_types<std::int16_t, std::uint16_t>("short", "ushort");
  check_index_types<std::uint32_t, std::uint32_t>("uint", "uint32");
  check_index_types<std::int32_t, std::int32_t>("int32", "int");
}

// Integers as coordinates, and the properties that can be asked for.
BOOST_AUTO_TEST_CASE(PLY_properties)
{
  for (const Encoding encoding : {TEXT, LITTLE, BIG}) {
    std::string vertices;
    for (const int i : {0, 1, 2, 3}) {
      for (const int x : {i, -i, 7})
        append(vertices, encoding, std::int16_t(x));
      append(vertices, encoding, 0.5 * i);
      vertices += encoding == TEXT ? "\n" : "";
    }
    const std::string file =
        ply_header(
            encoding, replaced(xyz, "float", "short") + "property double quality\n", indices) +
        vertices + ply_faces<std::uint8_t, std::int32_t>(encoding);
    const Polygon_soup soup = parse_polygon_soup(file, ".ply", "quality");
    BOOST_TEST(soup.has_property);
    BOOST_TEST(soup.property == (std::vector<double>{0, 0.5, 1, 1.5}),
               boost::test_tools::per_element());
    BOOST_TEST(soup.property_names == (std::vector<std::string>{"x", "y", "z", "quality"}),
               boost::test_tools::per_element());
    BOOST_TEST((soup.points[3] == std::array<double, 3>{{3, -3, 7}}));
    BOOST_TEST(parse_polygon_soup(file, ".ply", "y").property ==
                   (std::vector<double>{0, -1, -2, -3}),
               boost::test_tools::per_element());
    BOOST_TEST(!parse_polygon_soup(file, ".ply", "colour").has_property);
  }
}

BOOST_AUTO_TEST_CASE(damaged_PLY_files)
{
  const std::string header = ply_header(TEXT, xyz, indices);
  const std::string file = header + vertex_lines + face_lines;
  const auto check =
      [&](const std::string& what, const std::string& with, const std::vector<std::string>& words) {
        BOOST_REQUIRE(file.find(what) != file.npos);
        check_error(".ply", replaced(file, what, with), words);
      };
  check_tetrahedron(".ply", file);
  check_tetrahedron(".ply", file + "3 0 1 2\n", 1);
  check("ply\n", "plyx\n", {"line 1", "'plyx'"});
  check("format ascii 1.0\n", "", {"format"});
  check("ascii", "asci", {"line 2", "'asci'"});
  check("element vertex 4", "element vertex -4", {"line 3", "'-4'", "vertex"});
  check("element vertex", "element vertices", {"no element 'vertex'"});
  check("element face", "element polygon", {"'polygon'", "lists of vertices"});
  check("element face", "element vertex", {"two elements 'vertex'"});
  check("vertex_indices", "corners", {"'face'", "vertex_indices"});
  check("uchar int vertex", "uchar float vertex", {"vertex_indices", "integers"});
  check("list uchar", "list float", {"line 8", "integers"});
  check("property float y\n", "", {"'vertex'", "'y'"});
  check("float y", "float Y", {"'vertex'", "'y'"});
  check("float y", "float x", {"two properties 'x'"});
  check("float y", "real y", {"line 5", "'real'"});
  check("property float y", "property", {"line 5", "type"});
  check("property float y", "properties float y", {"line 5", "'properties'"});
  check("element vertex 4\n", "", {"line 3", "before the first element"});
  check("1 0 0\n", "1 0\n", {"line 12", "vertex 1", "more numbers"});
  check("1 0 0\n", "1 0 0 0\n", {"more numbers"});
  check("1 0 0\n", "1 0 nan\n", {"vertex 1", "coordinate z", "finite"});
  check("1 0 0\n", "1 0 O\n", {"vertex 1", "'O'"});
  check("3 0 2 3", "3 0 2 4", {"face 1", "vertex 4", "4,"});
  check("3 0 2 3", "3 0 2 -1", {"face 1", "vertex -1"});
  check("3 0 2 3", "3 0 2 1.5", {"face 1", "'1.5'"});
  check("3 0 2 3", "2 0 2", {"face 1", "2 corners"});
  check("3 0 2 3", "0", {"face 1", "0 corners"});
  check("3 0 2 3", "-3 0 2 3", {"face 1", "-3"});
  check("3 0 2 3", "999999999 0 2 3", {"face 1", "999999999"});
  check("3 1 3 2\n", "", {"ends within face 3"});
  check("element vertex 4", "element vertex 4000000000", {"too short", "4000000000"});
  check_error(
      ".ply", header.substr(0, header.find("property float z")), {"ends within its header"});

  const std::string binary = ply_header(LITTLE, xyz, indices) + ply_vertices<float>(LITTLE) +
                             ply_faces<std::uint8_t, std::int32_t>(LITTLE);
  for (std::size_t size = 4; size < binary.size(); ++size)
    check_error(".ply", binary.substr(0, size), {});
  check_tetrahedron(".ply", binary + "xyz", 1);
  check_error(".ply",
              replaced(binary, "element vertex 4", "element vertex 18446744073709551615"),
              {"too short"});
  check_error(".ply",
              ply_header(LITTLE, xyz, replaced(indices, "uchar", "uint")) +
                  ply_vertices<float>(LITTLE) + std::string(16, '\xff'),
              {"face 0", "4294967295"});
}

BOOST_AUTO_TEST_CASE(STL_files)
{
  const std::string text = stl_text();
  check_tetrahedron(".stl", text);
  check_tetrahedron(".stl", upper(text));
  for (const std::string name : {"solid",
                                 "solid a",
                                 "solid\ta",
                                 "Solid a",
                                 "solid my solid",
                                 "solid a endsolid",
                                 "solid facet 12",
                                 "solid outer loop vertex 1 2",
                                 "  solid",
                                 "\tsolid x",
                                 "\xef\xbb\xbfsolid a"})
    check_tetrahedron(".stl", name + text.substr(text.find('\n')));
  for (const std::string end : {"\r\n", "\r", " \n"})
    check_tetrahedron(".stl", replaced(text, "\n", end));
  check_tetrahedron(".stl", replaced(text, "endloop", "end loop"));
  check_tetrahedron(".stl", replaced(text, "endfacet", "end facet"));
  check_tetrahedron(".stl", replaced(text, "endsolid", "end solid"));
  check_tetrahedron(".stl", replaced(text, "endsolid a name", "ENDSOLID"));
  check_tetrahedron(".stl", replaced(text, "normal 0 0 1", "normal nan -nan(ind) 1.#QNAN"));
  check_tetrahedron(".stl", replaced(text, "normal 0 0 1", ""));
  check_tetrahedron(".stl", replaced(text, "0.000000", "-0"));
  const std::size_t second = text.find(" facet", text.find("endfacet"));
  check_tetrahedron(".stl", text.substr(0, second) + "endsolid\nsolid b\n" + text.substr(second));
  check_tetrahedron(".stl", text.substr(0, second) + "solid b\n" + text.substr(second));
  check_tetrahedron(".stl", text.substr(0, text.find("endsolid")), 1);

  for (const std::string header : {"", "binary", "solid", "\n\nsolid", "COLOR=abcd"})
    check_tetrahedron(".stl", stl_binary(header));
  check_tetrahedron(".stl", stl_binary("x") + "37 bytes", 1);
}

BOOST_AUTO_TEST_CASE(damaged_STL_files)
{
  const std::string text = stl_text();
  const std::size_t first = text.find(" facet");
  const auto changed = [&](const std::string& what, const std::string& with) {
    std::string result = text; // once, in the second facet
    const std::size_t place = result.find(what, result.find("endfacet"));
    return result.replace(place, what.size(), with);
  };
  check_error(".stl", "hello", {"line 1", "'hello'", "solid"});
  check_error(".stl", text.substr(first), {"line 1", "'facet'", "solid"});
  check_error(".stl", "solid a\nendsolid a\n", {"no facets"});
  check_error(".stl", changed(" facet normal 0 0 1\n", ""), {"line 9", "facet 1", "'outer'"});
  check_error(".stl", changed(" facet", " facets"), {"line 9", "facet 1", "'facets'"});
  check_error(".stl", changed("outer ", ""), {"line 10", "facet 1", "'outer'"});
  check_error(
      ".stl", changed("  endloop\n", ""), {"line 14", "facet 1", "'endfacet'", "'endloop'"});
  check_error(".stl", changed("endloop\n endfacet\n", "endloop\n"), {"line 15", "'endfacet'"});
  check_error(
      ".stl", changed("   vertex 0.000000 0.000000 0.000000\n", ""), {"facet 1", "2 corners"});
  check_error(".stl", changed("0.000000 -2.5", "-2.5"), {"facet 1", "2 coordinates"});
  check_error(".stl", changed("-2.500000", "-2,5"), {"facet 1", "'-2,5'"});
  check_error(".stl", changed("-2.500000", "inf"), {"facet 1", "'inf'", "finite"});
  check_error(".stl", text.substr(0, text.find("endfacet")), {"facet 0", "ends", "'endfacet'"});

  const std::string binary = stl_binary("x");
  for (std::size_t size = 84; size < binary.size(); ++size)
    check_error(".stl", binary.substr(0, size), {"byte 80", "4 facets", "space"});
  std::string wrong_number = binary;
  wrong_number[80] = 0;
  check_error(".stl", wrong_number, {"0 facets", "space for 4"});
  std::string not_finite = binary;
  not_finite.replace(84 + 50 + 12, 4, "\xff\xff\xff\xff");
  check_error(".stl", not_finite, {"facet 1", "finite"});
}

// The cells of the old form and of version 5, as text and binary, and arrays that can be asked for.
BOOST_AUTO_TEST_CASE(VTK_files)
{
  const std::string head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n",
                    text = head + "POINTS 4 float\n" + vertex_lines + "LINES 1 3\n2 0 1\n" +
                           "POLYGONS 4 16\n" + face_lines + "METADATA\nINFORMATION 0\n\n" +
                           "CELL_DATA 5\nSCALARS a int\nLOOKUP_TABLE default\n0 1 2 3 4\n" +
                           "POINT_DATA 4\nNORMALS n float\n" + vertex_lines +
                           "FIELD f 1\nb%20c 1 4 double\n0 0.5 1 nan\n";
  check_tetrahedron(".vtk", text);
  check_tetrahedron(".vtk", replaced(text, "\n", "\r\n"));
  const Polygon_soup soup = parse_polygon_soup(replaced(text, "nan", "-3"), ".vtk", "b c");
  BOOST_TEST(soup.property == (std::vector<double>{0, 0.5, 1, -3}),
             boost::test_tools::per_element());
  std::string binary = replaced(head, "ASCII", "BINARY") + "POINTS 4 double\n", connectivity;
  for (const auto& p : points)
    for (const double x : p)
      binary += bytes_of(x, true);
  binary += "\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n";
  for (const std::int64_t offset : {0, 3, 6, 9, 12})
    binary += bytes_of(offset, true);
  for (const auto& face : faces)
    for (const std::size_t v : face)
      connectivity += bytes_of(static_cast<std::int64_t>(v), true);
  binary += "\nCONNECTIVITY vtktypeint64\n" + connectivity + '\n';
  check_tetrahedron(".vtk", binary);
  for (std::size_t size = 1; size < binary.size() - 1; ++size)
    if (size < binary.find("\nPOLYGONS") || size > binary.find("POLYGONS") + 7)
      check_error(".vtk", binary.substr(0, size), {});
  check_error(".vtk", replaced(text, "3 0 2 3", "3 0 2 7"), {"face 1", "vertex 7", "4,"});
  check_error(".vtk", replaced(text, "3 0 2 3", "99 0 2 3"), {"polygon 1", "99 corners"});
  check_error(".vtk", replaced(text, "POLYDATA", "STRUCTURED_GRID"), {"line 4", "POLYDATA"});
  check_error(
      ".vtk", replaced(text, "POINTS 4 ", "POINTS 4000000000 "), {"too short", "4000000000"});
  check_error(
      ".vtk", replaced(text, "POINT_DATA 4", "POINT_DATA 5"), {"POINT_DATA", "5", "4 points"});
}

// No part of a file, and no file with changed bytes, is more than an error.
BOOST_AUTO_TEST_CASE(any_bytes)
{
  const std::string ply = ply_header(BIG, xyz, indices) + ply_vertices<float>(BIG) +
                          ply_faces<std::uint8_t, std::int32_t>(BIG);
  const std::vector<std::pair<std::string, std::string>> files = {
      {".off", off},
      {".obj", obj},
      {".ply", ply_header(TEXT, xyz, indices) + vertex_lines + face_lines},
      {".ply", ply},
      {".stl", stl_text()},
      {".stl", stl_binary("solid")}};
  std::size_t number_of_errors = 0, number_of_meshes = 0;
  for (const auto& [extension, content] : files) {
    for (unsigned seed = 0; seed < 2000; ++seed) {
      BOOST_TEST_CONTEXT(extension << ", seed " << seed)
      {
        std::mt19937 rng(seed);
        std::string changed =
            content.substr(0, seed % 3 == 0 ? rng() % content.size() : content.npos);
        for (unsigned i = 0; i < 1 + rng() % 4 && !changed.empty(); ++i) {
          const char pool[] = " \n\r\t-+.0123456789eE/#\\vf\0\xff";
          changed[rng() % changed.size()] = pool[rng() % (sizeof(pool) - 1)];
        }
        try {
          const Polygon_soup soup = parse_polygon_soup(changed, extension);
          ++number_of_meshes;
          for (const std::size_t corner : soup.corners)
            BOOST_TEST(corner < soup.points.size());
          for (const auto& p : soup.points)
            BOOST_TEST((std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])));
        } catch (const Content_error&) {
          ++number_of_errors;
        }
      }
    }
  }
  BOOST_TEST(number_of_errors > 1000u);
  BOOST_TEST(number_of_meshes > 1000u);
}
