// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/output_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "smore/common/output_directory.h"
#include "smore/experiment/map_files.h"

namespace smore {
namespace {

// Whether the maps of trials whose directory this is may be written to the file.
bool isMapOf(const std::filesystem::path& directory, const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::path whole = std::filesystem::canonical(file, none);
  if (whole.filename() != kWorldMapFile && whole.filename() != kObjectMapFile) return false;
  const std::filesystem::path folder = whole.parent_path();
  const bool of_one_of_several = folder.filename().string().compare(0, 5, "seed_") == 0;
  return std::filesystem::equivalent(folder, directory, none) ||
         (of_one_of_several && std::filesystem::equivalent(folder.parent_path(), directory, none));
}

// Of a link the file that it leads to.
void removeIfEmpty(const std::string& file) {
  std::error_code none;
  const std::filesystem::path whole = std::filesystem::canonical(file, none);
  if (!none && std::filesystem::file_size(whole, none) == 0) std::filesystem::remove(whole, none);
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
  const bool was_there = std::filesystem::exists(file, none);
  if (!std::ofstream(file, std::ios::app)) {
    return file + ": cannot be written; check its directory and its permissions";
  }
  if (!was_there) removeIfEmpty(file);  // it would pass for a result
  return "";
}

std::string problemOfMapsDirectory(const std::string& directory,
                                   const std::vector<std::string>& inputs) {
  const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const std::string& file) {
    return isMapOf(directory, file);
  });
  if (input == inputs.end()) return problemOfDirectory(directory);
  return directory + ": " + *input +
         " is read as well, and would be written over; give another directory";
}

}  // namespace smore
