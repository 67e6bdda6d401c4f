// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/output_file.h"

#include <filesystem>
#include <fstream>

namespace smore {

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

}  // namespace smore
