// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/pose_index.h"

namespace smore {

void PoseIndex::add(const Pose& pose) {
  cells_[keyOf(cellOf(pose.translation()))].push_back(static_cast<std::uint32_t>(poses_.size()));
  poses_.push_back(pose);
  rotations_.emplace_back(pose.linear());
}

void PoseIndex::clear() {
  poses_.clear();
  rotations_.clear();
  cells_.clear();
}

PoseIndex::Cell PoseIndex::cellOf(const Vec3& position) const {
  return (position / radius_).array().floor().cast<std::int64_t>();
}

/// Distinct for cells within 2^20 of the origin; beyond, cells may share a list, which costs time
/// only.
std::uint64_t PoseIndex::keyOf(const Cell& cell) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x()) & kMask) |
         (static_cast<std::uint64_t>(cell.y()) & kMask) << 21 |
         (static_cast<std::uint64_t>(cell.z()) & kMask) << 42;
}

}  // namespace smore
