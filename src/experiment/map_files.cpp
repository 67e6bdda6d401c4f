// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/map_files.h"

#include <octomap/octomap.h>

#include <filesystem>
#include <stdexcept>

#include "smore/mapping/octomap_export.h"

namespace smore {
namespace {

void writeTree(const VoxelGrid& grid, const std::filesystem::path& file) {
  if (!toOctree(grid)->write(file.string())) {
    throw std::runtime_error(file.string() + ": cannot be written; check the disk");
  }
}

}  // namespace

void saveMaps(const TwinMap& maps, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::runtime_error(directory + ": cannot be made: " + error.message());
  writeTree(maps.world(), std::filesystem::path(directory) / "world.ot");
  writeTree(maps.object(), std::filesystem::path(directory) / "object.ot");
}

}  // namespace smore
