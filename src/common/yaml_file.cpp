// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/yaml_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

#include "smore/common/result.h"
#include "utf8.h"

namespace smore {
namespace {

[[noreturn]] void failAtLine(const std::string& file, int line, const std::string& problem) {
  throw InputError(file + ": line " + std::to_string(line) + ": " + problem);
}

std::string readBytes(const std::string& file) {
  std::error_code unreadable;
  if (std::filesystem::is_directory(file, unreadable)) {
    throw InputError(file + ": is a directory; give the path of a YAML file in it");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read; check the path and the permissions");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void checkEncoding(const std::string& file, const std::string& bytes) {
  if (isUtf16(bytes)) throw InputError(file + ": the text is UTF-16; save the file as UTF-8");
  const std::size_t good = validUtf8Prefix(bytes);
  if (good == bytes.size()) return;
  const auto lines = std::count(bytes.begin(), bytes.begin() + static_cast<long>(good), '\n');
  failAtLine(file, static_cast<int>(lines) + 1,
             "not UTF-8 (byte " + std::to_string(static_cast<unsigned char>(bytes[good])) +
                 "); save the file as UTF-8");
}

// yaml-cpp keeps a key as often as it stands, and looks up the first.
void checkKeysAreUnique(const std::string& file, const YAML::Node& node, int depth) {
  constexpr int kMaxDepth = 100;  // an alias may lead back into its own anchor
  if (depth > kMaxDepth) failAtLine(file, node.Mark().line + 1, "nested too deeply; write it out");
  std::set<std::string> keys;
  for (const auto& entry : node) {
    const YAML::Node& value = node.IsMap() ? entry.second : entry;
    if (node.IsMap() && entry.first.IsScalar() && !keys.insert(entry.first.Scalar()).second) {
      failAtLine(file, entry.first.Mark().line + 1,
                 "the key '" + entry.first.Scalar() + "' is given twice; keep one of them");
    }
    checkKeysAreUnique(file, value, depth + 1);
  }
}

}  // namespace

YAML::Node loadYaml(const std::string& file) {
  const std::string bytes = readBytes(file);
  checkEncoding(file, bytes);
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(bytes);
  } catch (const YAML::Exception& error) {
    failAtLine(file, error.mark.line + 1, "not valid YAML: " + error.msg);
  }
  if (documents.size() > 1) {
    failAtLine(file, documents[1].Mark().line + 1,
               "a second document ('---') begins; keep one in a file");
  }
  if (documents.empty()) return YAML::Node();
  checkKeysAreUnique(file, documents.front(), 0);
  return documents.front();
}

}  // namespace smore
