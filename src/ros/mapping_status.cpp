// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/mapping_status.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace smore {
namespace {

constexpr double kOldPose = 1.0;  // [s]; poses come with each wrench, 50 times a second at least
// Observations of two seconds at 500 Hz: a belief update after a contact takes less.
constexpr std::size_t kManyWaiting = 1000;
// Long enough to be read by who looks up at a warning. Our choice.
constexpr std::chrono::seconds kLeftOutShown(10);
constexpr double kMebi = 1024.0 * 1024.0;

void addVoxels(const char* key, const std::optional<std::size_t>& voxels, Status* status) {
  if (voxels) {
    status->add(key, *voxels);
  } else {
    status->add(key, "nobody has asked for the map");
  }
}

void summarizeArrivals(const MappingReport& now, Status* status) {
  if (!now.pose_age) {
    status->summary(Status::STALE, "no observation has come; is the listener running and tared?");
  } else if (now.waiting > kManyWaiting) {
    status->summaryf(Status::WARN, "the maps fall behind: %lu observations wait",
                     static_cast<unsigned long>(now.waiting));
  } else if (*now.pose_age > kOldPose) {
    status->summaryf(Status::STALE,
                     "the newest observation is %.1f s old; do wrenches and "
                     "transforms come?",
                     *now.pose_age);
  } else {
    status->summaryf(Status::OK, "maps of %lu contacts", static_cast<unsigned long>(now.lines));
  }
}

void addValues(const MappingReport& now, Status* status) {
  status->add("contacts with a line", now.lines);
  status->add("observations kept", now.observations);
  status->add("observations waiting", now.waiting);
  addVoxels("voxels of the world map", now.world_voxels, status);
  addVoxels("voxels of the object map", now.object_voxels, status);
  status->add("shown from probability", now.shown_from);
  status->add("revision", now.revision);
  status->add("memory [MiB]", static_cast<double>(residentMemory()) / kMebi);
  if (now.pose_age) status->add("age of the transform [s]", *now.pose_age);
}

}  // namespace

void note(const Arrivals& arrivals, MappingReport* report) {
  report->waiting = arrivals.waiting;
  if (!arrivals.at) return;
  const std::chrono::duration<double> ago = std::chrono::steady_clock::now() - *arrivals.at;
  report->pose_age = std::max(ago.count(), ros::Time::now().toSec() - arrivals.newest);
}

void note(const KeeperProblems& problems, MappingReport* report) {
  if (!problems.journal_end.empty()) report->journal_end = problems.journal_end;
  if (problems.left_out.empty()) return;
  report->left_out = problems.left_out;
  report->left_out_at = std::chrono::steady_clock::now();
}

void compose(const MappingReport& now, Status* status) {
  summarizeArrivals(now, status);
  if (!now.journal_end.empty()) status->mergeSummary(Status::WARN, now.journal_end);
  const auto since_left_out = std::chrono::steady_clock::now() - now.left_out_at;
  if (!now.left_out.empty() && since_left_out < kLeftOutShown) {
    status->mergeSummary(Status::WARN, now.left_out);
  }
  addValues(now, status);
}

std::size_t residentMemory() {
  std::ifstream statm("/proc/self/statm");  // Linux: sizes in pages, the second is the resident one
  std::size_t whole = 0;
  std::size_t resident = 0;
  statm >> whole >> resident;
  return statm ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace smore
