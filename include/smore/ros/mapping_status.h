// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "smore/ros/map_keeper.h"
#include "smore/ros/status_publisher.h"

namespace smore {

/// What the mapping knows of its maps.
struct MappingReport {
  /// Since the pose of the newest observation, by its stamp, or since it came where the clock
  /// stands still [s]; nothing before the first.
  std::optional<double> pose_age;
  std::size_t waiting = 0;       ///< observations that the maps have not taken yet
  std::size_t lines = 0;         ///< contacts with a line of action
  std::size_t observations = 0;  ///< that said something new, contacts and free poses
  std::uint64_t revision = 0;    ///< rises whenever a map changes
  /// Voxels of each map when it was last given to somebody; nothing before.
  std::optional<std::size_t> world_voxels, object_voxels;
  double shown_from = 0.3;  ///< least probability of the voxels that are shown
  std::string journal_end;  ///< why the journal is no longer written; empty: it is, or is none
  std::string left_out;     ///< why the last observation that was left out was; empty: none was
  std::chrono::steady_clock::time_point left_out_at;  ///< when that was told
};

/// Puts into the report what has come and how old it is now.
void note(const Arrivals& arrivals, MappingReport* report);

/// Puts into the report what went wrong just now.
void note(const KeeperProblems& problems, MappingReport* report);

/// The mapping's status `maps`: sizes, memory of the process, age of the transform. STALE where no
/// observations come, WARN where the maps fall behind them. Beside that, and never hidden by it,
/// WARN where an observation was left out in the last ten seconds, and from the journal's end on.
void compose(const MappingReport& now, Status* status);

/// Of this process, resident [bytes]; 0 where the system does not tell.
std::size_t residentMemory();

}  // namespace smore
