// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_file.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "smore/common/result.h"

namespace smore {
namespace {

// Binary STL: 80 bytes of text, a 32-bit count, then 50 bytes a triangle (normal, three vertices,
// all 32-bit floats, and two spare bytes), little endian.
constexpr size_t kHeaderBytes = 80;
constexpr size_t kTriangleBytes = 50;
constexpr size_t kNormalBytes = 12;

std::string readFile(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  if (!stream || !(content << stream.rdbuf())) {
    throw InputError(file +
                     ": mesh cannot be read; check the path (relative to the scenario file)");
  }
  return content.str();
}

bool isBinaryStl(const std::string& content) {
  if (content.size() < kHeaderBytes + sizeof(std::uint32_t)) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + kHeaderBytes, sizeof(count));
  return content.size() == kHeaderBytes + sizeof(count) + kTriangleBytes * count;
}

TriangleSoup parseBinaryStl(const std::string& content) {
  TriangleSoup triangles;
  for (size_t at = kHeaderBytes + sizeof(std::uint32_t); at < content.size();
       at += kTriangleBytes) {
    std::array<float, 9> values{};
    std::memcpy(values.data(), content.data() + at + kNormalBytes, sizeof(values));
    std::array<Vec3, 3> triangle;
    for (size_t i = 0; i < 3; ++i) {
      triangle[i] = Vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

[[noreturn]] void failAtLine(const std::string& file, int line, const std::string& problem) {
  throw InputError(file + ": line " + std::to_string(line) + ": " + problem +
                   "; export the mesh anew as STL or OBJ");
}

Vec3 parseVertex(std::istringstream* words, const std::string& file, int line) {
  Vec3 vertex;
  if (!(*words >> vertex.x() >> vertex.y() >> vertex.z())) {
    failAtLine(file, line, "expected three coordinates");
  }
  return vertex;
}

TriangleSoup parseAsciiStl(const std::string& content, const std::string& file) {
  TriangleSoup triangles;
  std::vector<Vec3> loop;
  std::istringstream lines(content);
  std::string text;
  for (int line = 1; std::getline(lines, text); ++line) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    if (word == "vertex") loop.push_back(parseVertex(&words, file, line));
    if (word != "endloop") continue;
    if (loop.size() != 3) failAtLine(file, line, "expected three vertices in each facet");
    triangles.push_back({loop[0], loop[1], loop[2]});
    loop.clear();
  }
  return triangles;
}

// OBJ indices count from 1, or backwards from the last vertex where negative; "7/2/3" is vertex 7.
Vec3 vertexOf(const std::string& word, const std::vector<Vec3>& vertices, const std::string& file,
              int line) {
  const long index = std::strtol(word.c_str(), nullptr, 10);
  const long position = index > 0 ? index - 1 : static_cast<long>(vertices.size()) + index;
  if (index == 0 || position < 0 || position >= static_cast<long>(vertices.size())) {
    failAtLine(file, line, "no vertex '" + word + "'");
  }
  return vertices[static_cast<size_t>(position)];
}

TriangleSoup parseObj(const std::string& content, const std::string& file) {
  TriangleSoup triangles;
  std::vector<Vec3> vertices;
  std::istringstream lines(content);
  std::string text;
  for (int line = 1; std::getline(lines, text); ++line) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    if (word == "v") vertices.push_back(parseVertex(&words, file, line));
    if (word != "f") continue;
    std::vector<Vec3> corners;
    while (words >> word) corners.push_back(vertexOf(word, vertices, file, line));
    if (corners.size() < 3) failAtLine(file, line, "expected three vertices or more in each face");
    for (size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return triangles;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

TriangleSoup readTriangles(const std::string& file) {
  const std::string content = readFile(file);
  if (endsWith(file, ".obj") || endsWith(file, ".OBJ")) return parseObj(content, file);
  if (isBinaryStl(content)) return parseBinaryStl(content);
  if (content.compare(0, 5, "solid") == 0) return parseAsciiStl(content, file);
  throw InputError(file + ": neither STL nor OBJ, or cut short; export the mesh anew");
}

}  // namespace smore
