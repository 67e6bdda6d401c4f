// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/output_paths.h"

#include <filesystem>
#include <fstream>

namespace smore {

std::string problemOfDirectory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return directory + ": cannot be made: " + error.message();
  const std::filesystem::path probe = std::filesystem::path(directory) / ".smore_write_test";
  if (!std::ofstream(probe)) return directory + ": cannot be written; check its permissions";
  std::filesystem::remove(probe, error);
  return "";
}

std::string problemOfFile(const std::string& file, const std::vector<std::string>& inputs) {
  if (std::filesystem::path(file).extension() == ".evidence") {
    return file + ": is the name of recorded evidence; give another one";
  }
  for (const std::string& input : inputs) {
    std::error_code none;
    if (!std::filesystem::equivalent(file, input, none)) continue;
    return file + ": is read as well, and would be written over; give another name";
  }
  if (std::ofstream(file, std::ios::app)) return "";
  return file + ": cannot be written; check that its directory is there, and its permissions";
}

}  // namespace smore
