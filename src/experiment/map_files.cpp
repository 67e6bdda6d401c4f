// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/map_files.h"

#include <octomap/octomap.h>

#include <filesystem>
#include <stdexcept>

#include "smore/mapping/octomap_export.h"

namespace smore {

void saveMaps(const TwinMap& maps, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::runtime_error(directory + ": cannot be made: " + error.message());
  writeOctree(*toOctree(maps.world()), directory + "/" + kWorldMapFile);
  writeOctree(*toOctree(maps.object()), directory + "/" + kObjectMapFile);
}

}  // namespace smore
