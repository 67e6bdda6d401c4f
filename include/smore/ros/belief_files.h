// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/ros/map_keeper.h"

namespace smore {

/// `path` where it is absolute, else below the directory of ROS (ROS_HOME, by default ~/.ros).
std::string belowRosHome(const std::string& path);

/// Writes both maps as `world.ot` and `object.ot` into an absolute directory, which is made where
/// it is missing. InputError for another path, std::runtime_error where it cannot be written.
void saveMaps(const MapKeeper& keeper, const std::string& directory);

/// What a mapping node saves and loads: files of evidence below one folder.
class BeliefFiles {
 public:
  /// `folder` need not exist yet. `source` is written into each file; what is loaded must be of its
  /// kind of motion, and of its plane.
  BeliefFiles(std::string folder, EvidenceSource source);

  /// Writes what the keeper's maps are made of and gives the file's path. InputError for a name
  /// that is empty or leads out of the folder, and for a file that is there unless `overwrite`;
  /// std::runtime_error where it cannot be written.
  std::string save(const MapKeeper& keeper, const std::string& name, bool overwrite) const;

  /// Has the keeper take what the file says, and tells what it was. InputError, and nothing
  /// changes, for a bad name or file, or observations that do not fit.
  std::string load(const std::string& name, MapKeeper* keeper) const;

  /// The same from a file anywhere.
  std::string loadFrom(const std::string& file, MapKeeper* keeper) const;

 private:
  std::string pathOf(const std::string& name) const;

  std::string folder_;
  EvidenceSource source_;
};

}  // namespace smore
