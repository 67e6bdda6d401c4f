// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/output_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "smore/common/output_directory.h"
#include "smore/experiment/map_files.h"

namespace smore {
namespace {

bool liesIn(const std::filesystem::path& file, const std::filesystem::path& directory) {
  std::error_code none;
  const auto whole_file = std::filesystem::weakly_canonical(file, none);
  const auto whole_directory = std::filesystem::weakly_canonical(directory, none);
  return std::mismatch(whole_directory.begin(), whole_directory.end(), whole_file.begin(),
                       whole_file.end())
             .first == whole_directory.end();
}

}  // namespace

std::string problemOfFile(const std::string& file, const std::vector<std::string>& inputs) {
  if (std::filesystem::path(file).extension() == ".evidence") {
    return file + ": is the name of recorded evidence; give another one";
  }
  for (const std::string& input : inputs) {
    std::error_code none;
    if (!std::filesystem::equivalent(file, input, none)) continue;
    return file + ": is read as well, and would be written over; give another name";
  }
  std::error_code none;  // what cannot be made shows below
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), none);
  if (std::ofstream(file, std::ios::app)) return "";
  return file + ": cannot be written; check its directory and its permissions";
}

std::string problemOfMapsDirectory(const std::string& directory,
                                   const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    const std::string name = std::filesystem::path(input).filename();
    if ((name == kWorldMapFile || name == kObjectMapFile) && liesIn(input, directory)) {
      return directory + ": " + input +
             " is read as well, and would be written over; give another directory";
    }
  }
  return problemOfDirectory(directory);
}

}  // namespace smore
