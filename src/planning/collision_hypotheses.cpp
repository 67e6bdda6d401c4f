// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/collision_hypotheses.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "smore/common/cell_key.h"
#include "smore/planning/occupied_voxels.h"

namespace smore {
namespace {

// Cells of the world over voxels of the object: points so near to one another leave out no cell,
// however the object is turned.
constexpr double kCoarser = 2.0;

// How far beyond a contact the object is thought to go on, in cells: on a turn, what lies nearer to
// the origin must come to its next cell as well.
constexpr double kStepInCells = 2.0;

// Poses of a path that are looked at are this many cells apart: less than one, to enter each.
constexpr double kCheckInCells = 0.75;

// A set is wrong with this probability: where an obstacle ends within a cell, the object sweeps
// the cell that it has touched.
constexpr double kDoubt = 0.01;

double cellFor(const std::vector<Prior>& object) {
  double widest = 0.0;
  for (const Prior& piece : object) widest = std::max(widest, piece.known.voxelSize());
  return kCoarser * widest;
}

bool isInside(const std::set<VoxelKey>& matter, const VoxelKey& key, bool planar) {
  const auto at = [&](int dx, int dy, int dz) {
    const std::optional<VoxelKey> next = neighbourOf(key, dx, dy, dz);
    return next && matter.count(*next) > 0;
  };
  return at(1, 0, 0) && at(-1, 0, 0) && at(0, 1, 0) && at(0, -1, 0) &&
         (planar || (at(0, 0, 1) && at(0, 0, -1)));
}

}  // namespace

CollisionHypotheses::CollisionHypotheses(const std::vector<Prior>& object, bool planar)
    : cell_(cellFor(object)) {
  for (const Prior& piece : object) addMatter(piece.known, planar);
  if (points_.empty()) {
    throw std::invalid_argument("collision hypotheses need the object's matter");
  }
  trail_.emplace(kStepInCells * cell_, reach_);
}

// The plane passes between two layers of voxels: the upper one stands for what is in either.
void CollisionHypotheses::addMatter(const VoxelGrid& known, bool planar) {
  std::set<VoxelKey> matter;
  for (VoxelKey key : occupiedVoxels(known).keys) {
    if (planar && key.z != 0 && key.z != -1) continue;
    if (planar) key.z = 0;
    matter.insert(key);
  }
  for (const VoxelKey& key : matter) {
    Vec3 point = voxelCenter(key, known.voxelSize());
    if (planar) point.z() = 0.0;
    points_.push_back(point);
    reach_ = std::max(reach_, point.norm());
    if (!isInside(matter, key, planar)) surface_.push_back(point);
  }
}

void CollisionHypotheses::observe(const ContactObservation& observation) {
  const Pose& pose = observation.T_world_object;
  if (observation.state == ContactState::kFree) {
    trail_->record(pose);
    const bool moved = !swept_last_ || distanceBetween(*swept_last_, pose) +
                                               reach_ * angleBetween(*swept_last_, pose) >=
                                           0.5 * cell_;
    if (moved) sweep(pose);
  } else if (contacts_.isFirst(observation)) {
    sweep(pose);
    suppose(trail_->beyond(pose));
  }
}

void CollisionHypotheses::sweep(const Pose& T_world_object) {
  swept_last_ = T_world_object;
  for (const Vec3& point : points_) {
    const Cell cell = cellAt(T_world_object * point);
    if (!free_.insert(cell).second) continue;
    const auto suspected = suspected_.find(cell);
    if (suspected == suspected_.end()) continue;
    for (const int set : suspected->second) --sizes_[set];
    suspected_.erase(suspected);
  }
}

void CollisionHypotheses::suppose(const Pose& T_world_object) {
  std::unordered_set<Cell> entered;
  for (const Vec3& point : points_) {
    const Cell cell = cellAt(T_world_object * point);
    if (free_.count(cell) == 0) entered.insert(cell);
  }
  for (const Cell cell : entered) suspected_[cell].push_back(static_cast<int>(sizes_.size()));
  sizes_.push_back(static_cast<int>(entered.size()));
}

double CollisionHypotheses::success(const Path& path) const {
  if (suspected_.empty()) return 1.0;
  const double spacing = kCheckInCells * cell_;
  const Path poses = densify(path, spacing, spacing / std::max(reach_, cell_));
  std::unordered_set<Cell> swept;
  std::unordered_map<int, int> hits;  // of each set
  for (std::size_t i = 1; i < poses.size(); ++i) {
    // What enters a cell first is the surface.
    for (const Vec3& point : surface_) {
      const Cell cell = cellAt(poses[i] * point);
      const auto suspected = suspected_.find(cell);
      if (suspected == suspected_.end() || !swept.insert(cell).second) continue;
      for (const int set : suspected->second) ++hits[set];
    }
  }
  double product = 1.0;
  for (const auto& [set, count] : hits) product *= 1.0 - (1.0 - kDoubt) * count / sizes_[set];
  return product;
}

CollisionHypotheses::Cell CollisionHypotheses::cellAt(const Vec3& point_world) const {
  // In planar motion points lie in a face between cells, where rounding would choose for each anew.
  constexpr double kOffFaces = 0.25;
  const auto cell = (point_world.array() / cell_ + kOffFaces).floor().cast<std::int64_t>().eval();
  return cellKey(cell.x(), cell.y(), cell.z());
}

}  // namespace smore
