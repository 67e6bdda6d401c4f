// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/prior_source.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "smore/scenario/point_cloud.h"

namespace smore {
namespace {

std::string extensionOf(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return extension;
}

}  // namespace

std::optional<PriorFormat> priorFormatOf(const std::string& file) {
  static const std::map<std::string, PriorFormat> formats = {
      {".stl", PriorFormat::kMesh},  {".obj", PriorFormat::kMesh},  {".dae", PriorFormat::kMesh},
      {".pcd", PriorFormat::kCloud}, {".ot", PriorFormat::kOctree}, {".bt", PriorFormat::kOctree}};
  const std::string extension = extensionOf(file);
  if (extension == ".ply") return hasFaces(file) ? PriorFormat::kMesh : PriorFormat::kCloud;
  const auto known = formats.find(extension);
  if (known == formats.end()) return std::nullopt;
  return known->second;
}

}  // namespace smore
