// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "smore/common/cell_key.h"
#include "smore/common/geometry.h"

namespace smore {

/// Poses, found by where their origins lie; they may be added at any time.
class PoseIndex {
 public:
  /// `radius` [m], positive: how near the origins are that will be asked for.
  explicit PoseIndex(double radius) : radius_(radius) {}

  void add(const Pose& pose);

  /// In the order in which they were added.
  const std::vector<Pose>& poses() const { return poses_; }

  /// Calls visit(i, gap), with gap as gapBetween has it, for each poses()[i] whose origin is nearer
  /// to that of `pose` than the radius, until it returns true. Whether it did.
  template <typename Visit>
  bool anyNear(const Pose& pose, Visit visit) const {
    const Cell home = cellOf(pose.translation());
    const Eigen::Quaterniond rotation(pose.linear());
    // Origins within the radius lie in the same cell or in one that touches it.
    for (int neighbor = 0; neighbor < 27; ++neighbor) {
      const Cell offset(neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
      const auto found = cells_.find(keyOf(home + offset));
      if (found == cells_.end()) continue;
      for (const std::uint32_t position : found->second) {
        const double distance = distanceBetween(pose, poses_[position]);
        if (distance >= radius_) continue;
        const double gap = distance + rotation.angularDistance(rotations_[position]);
        if (visit(position, gap)) return true;
      }
    }
    return false;
  }

 private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  Cell cellOf(const Vec3& position) const;
  /// Cells far away may share a list, which costs time only.
  static std::uint64_t keyOf(const Cell& cell) { return cellKey(cell.x(), cell.y(), cell.z()); }

  double radius_;
  std::vector<Pose> poses_;
  std::vector<Eigen::Quaterniond> rotations_;  ///< of poses_: to make them takes time
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  ///< positions in poses_
};

}  // namespace smore
