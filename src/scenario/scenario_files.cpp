// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/scenario_files.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "smore/common/result.h"

namespace smore {
namespace {

namespace fs = std::filesystem;

std::string namesIn(const std::string& directory) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(directory, unreadable)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "(none)" : list;
}

bool isReadableFile(const std::string& path) {
  return fs::is_regular_file(path) && std::ifstream(path).good();
}

bool looksLikePath(const std::string& text) {
  return text.find('/') != std::string::npos || fs::path(text).extension() == ".yaml";
}

std::string noSuchPath(const std::string& path) {
  if (fs::path(path).is_absolute()) return "there is no readable file; check the path";
  // roslaunch starts nodes in a directory of its own.
  return "no readable file in " + fs::current_path().string() +
         ", from where this program reads; give the absolute path";
}

}  // namespace

std::string shippedScenarioDirectory() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&shippedScenarioDirectory), &library) != 0) {
    const fs::path prefix = fs::absolute(library.dli_fname).parent_path().parent_path();
    const fs::path installed = prefix / "share/smore/config/scenarios";
    if (fs::is_directory(installed)) return installed.string();
  }
  return SMORE_SOURCE_SCENARIOS;
}

std::string findScenario(const std::string& name_or_path, const std::string& directory) {
  if (isReadableFile(name_or_path)) return name_or_path;
  std::string file = directory + "/" + name_or_path + ".yaml";
  if (!looksLikePath(name_or_path) && isReadableFile(file)) return file;
  const std::string scenario = "scenario '" + name_or_path + "': ";
  if (fs::is_directory(name_or_path)) {
    throw InputError(scenario + "is a directory; give a scenario file in it");
  }
  if (looksLikePath(name_or_path)) throw InputError(scenario + noSuchPath(name_or_path));
  throw InputError(scenario + "not a name in " + directory +
                   "; give the path of a file or one of: " + namesIn(directory));
}

}  // namespace smore
