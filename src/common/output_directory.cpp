// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/output_directory.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace smore {

std::string problemOfDirectory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return directory + ": cannot be made: " + error.message() + "; give another directory";
  }
  const std::filesystem::path probe = std::filesystem::path(directory) / ".smore_write_test";
  if (!std::ofstream(probe)) return directory + ": cannot be written; check its permissions";
  std::filesystem::remove(probe, error);
  return "";
}

}  // namespace smore
