// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/point_cloud.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "smore/common/result.h"

namespace smore {
namespace {

using ReadNumber = double (*)(const char* bytes);

template <typename T>
double readAs(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

struct NumberType {
  int size = 0;  ///< [bytes]
  ReadNumber read = nullptr;
};

template <typename T>
NumberType numberType() {
  return {sizeof(T), &readAs<T>};
}

/// How the points of a file lie in it.
struct Layout {
  bool ascii = true;
  std::size_t points = 0;
  std::vector<std::string> names;  ///< of the numbers of each point
  std::vector<NumberType> types;
};

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
  throw InputError(file + ": " + problem);
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

NumberType plyType(const std::string& name) {
  static const std::map<std::string, NumberType> types = {
      {"char", numberType<std::int8_t>()},     {"int8", numberType<std::int8_t>()},
      {"uchar", numberType<std::uint8_t>()},   {"uint8", numberType<std::uint8_t>()},
      {"short", numberType<std::int16_t>()},   {"int16", numberType<std::int16_t>()},
      {"ushort", numberType<std::uint16_t>()}, {"uint16", numberType<std::uint16_t>()},
      {"int", numberType<std::int32_t>()},     {"int32", numberType<std::int32_t>()},
      {"uint", numberType<std::uint32_t>()},   {"uint32", numberType<std::uint32_t>()},
      {"float", numberType<float>()},          {"float32", numberType<float>()},
      {"double", numberType<double>()},        {"float64", numberType<double>()}};
  const auto known = types.find(name);
  return known == types.end() ? NumberType{} : known->second;
}

NumberType pcdType(const std::string& kind, const std::string& size) {
  static const std::map<std::string, NumberType> types = {
      {"I1", numberType<std::int8_t>()},  {"U1", numberType<std::uint8_t>()},
      {"I2", numberType<std::int16_t>()}, {"U2", numberType<std::uint16_t>()},
      {"I4", numberType<std::int32_t>()}, {"U4", numberType<std::uint32_t>()},
      {"I8", numberType<std::int64_t>()}, {"U8", numberType<std::uint64_t>()},
      {"F4", numberType<float>()},        {"F8", numberType<double>()}};
  const auto known = types.find(kind + size);
  return known == types.end() ? NumberType{} : known->second;
}

std::size_t countOf(const std::string& word, const std::string& file) {
  std::istringstream stream(word);
  std::size_t count = 0;
  if (!(stream >> count) || !stream.eof() || word.front() == '-')
    refuse(file, "'" + word + "' is no number of points");
  return count;
}

// The vertices must come first: what stands before them would have to be measured.
Layout readPlyHeader(std::istream* stream, const std::string& file) {
  Layout layout;
  bool of_vertices = false;
  bool others_before = false;
  for (std::string line; std::getline(*stream, line);) {
    const std::vector<std::string> words = wordsOf(line);
    if (words.empty()) continue;
    if (words[0] == "end_header") return layout;
    if (words[0] == "format" && words.size() > 1) {
      layout.ascii = words[1] == "ascii";
      if (words[1] == "binary_big_endian") refuse(file, "big-endian; write it as ascii");
    }
    if (words[0] == "element" && words.size() > 2) {
      of_vertices = words[1] == "vertex";
      if (of_vertices && others_before)
        refuse(file, "elements before the vertices; export it anew");
      if (of_vertices) layout.points = countOf(words[2], file);
      others_before = others_before || !of_vertices;
    }
    if (words[0] == "property" && of_vertices) {
      const NumberType type = words.size() == 3 ? plyType(words[1]) : NumberType{};
      if (type.size == 0) refuse(file, "property '" + line + "' of a vertex is not known");
      layout.names.push_back(words[2]);
      layout.types.push_back(type);
    }
  }
  refuse(file, "no end_header; the file is damaged");
}

struct PcdFields {
  std::vector<std::string> names, sizes, kinds, counts;
};

Layout layoutOf(const PcdFields& fields, const std::string& file) {
  Layout layout;
  if (fields.sizes.size() != fields.names.size() || fields.kinds.size() != fields.names.size()) {
    refuse(file, "FIELDS, SIZE and TYPE are not of one length; the file is damaged");
  }
  for (std::size_t i = 0; i < fields.names.size(); ++i) {
    const NumberType type = pcdType(fields.kinds[i], fields.sizes[i]);
    if (type.size == 0) refuse(file, "field '" + fields.names[i] + "' has an unknown type");
    const std::size_t count = i < fields.counts.size() ? countOf(fields.counts[i], file) : 1;
    constexpr std::size_t kMostNumbers = 10000;  // of a field: a histogram has some hundred
    if (count > kMostNumbers) refuse(file, "field '" + fields.names[i] + "' is too long");
    layout.names.insert(layout.names.end(), count, fields.names[i]);
    layout.types.insert(layout.types.end(), count, type);
  }
  return layout;
}

Layout readPcdHeader(std::istream* stream, const std::string& file) {
  PcdFields fields;
  std::size_t points = 0;
  for (std::string line; std::getline(*stream, line);) {
    std::vector<std::string> words = wordsOf(line);
    if (words.size() < 2) continue;
    const std::string key = words[0];
    words.erase(words.begin());
    if (key == "FIELDS") fields.names = words;
    if (key == "SIZE") fields.sizes = words;
    if (key == "TYPE") fields.kinds = words;
    if (key == "COUNT") fields.counts = words;
    if (key == "POINTS") points = countOf(words[0], file);
    if (key != "DATA") continue;
    if (words[0] != "ascii" && words[0] != "binary") {
      refuse(file, "DATA " + words[0] + " is not read; write it as ascii or binary " +
                       "(pcl_convert_pcd_ascii_binary)");
    }
    if (points == 0) refuse(file, "no POINTS, or none of them; export it anew");
    Layout layout = layoutOf(fields, file);
    layout.ascii = words[0] == "ascii";
    layout.points = points;
    return layout;
  }
  refuse(file, "no DATA; the file is damaged");
}

std::array<std::size_t, 3> coordinatesOf(const Layout& layout, const std::string& file) {
  std::array<std::size_t, 3> columns{};
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    std::size_t& column = columns[axis];
    while (column < layout.names.size() && layout.names[column] != axes[axis]) ++column;
    if (column == layout.names.size()) refuse(file, "points without " + axes[axis]);
  }
  return columns;
}

double numberOf(const std::string& word, const std::string& file) {
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);  // reads nan, too
  if (*end != '\0') refuse(file, "'" + word + "' of a point is no number; write decimal points");
  return number;
}

// The numbers of the next point; false where the file ends before.
bool nextPoint(std::istream* stream, const Layout& layout, const std::string& file,
               std::vector<char>* bytes, std::vector<double>* numbers) {
  if (layout.ascii) {
    for (double& number : *numbers) {
      std::string word;
      if (!(*stream >> word)) return false;
      number = numberOf(word, file);
    }
    return true;
  }
  if (!stream->read(bytes->data(), static_cast<std::streamsize>(bytes->size()))) return false;
  const char* at = bytes->data();
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    (*numbers)[i] = layout.types[i].read(at);
    at += layout.types[i].size;
  }
  return true;
}

std::vector<Vec3> readPoints(std::istream* stream, const Layout& layout, const std::string& file) {
  const std::array<std::size_t, 3> columns = coordinatesOf(layout, file);
  std::size_t size = 0;
  for (const NumberType& type : layout.types) size += static_cast<std::size_t>(type.size);
  std::vector<char> bytes(size);
  std::vector<double> numbers(layout.types.size());
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < layout.points; ++i) {
    if (!nextPoint(stream, layout, file, &bytes, &numbers)) {
      refuse(file, "ends after " + std::to_string(i) + " of " + std::to_string(layout.points) +
                       " points; the file is damaged");
    }
    const Vec3 point(numbers[columns[0]], numbers[columns[1]], numbers[columns[2]]);
    if (point.allFinite()) points.push_back(point);
  }
  if (points.empty()) refuse(file, "no point that is finite");
  return points;
}

bool isPly(std::istream* stream) {
  std::string first;
  return std::getline(*stream, first) && first.substr(0, 3) == "ply";
}

}  // namespace

bool hasFaces(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!isPly(&stream)) return false;
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = wordsOf(line);
    if (words.empty()) continue;
    if (words[0] == "end_header") return false;
    if (words[0] == "element" && words.size() > 2 && words[1] == "face") return words[2] != "0";
  }
  return false;
}

std::vector<Vec3> loadPointCloud(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(file, "cannot be read; check the path");
  if (isPly(&stream)) return readPoints(&stream, readPlyHeader(&stream, file), file);
  stream.clear();
  stream.seekg(0);
  return readPoints(&stream, readPcdHeader(&stream, file), file);
}

}  // namespace smore
