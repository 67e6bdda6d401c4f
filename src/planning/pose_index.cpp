// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/pose_index.h"

namespace smore {

void PoseIndex::add(const Pose& pose) {
  cells_[keyOf(cellOf(pose.translation()))].push_back(static_cast<std::uint32_t>(poses_.size()));
  poses_.push_back(pose);
  rotations_.emplace_back(pose.linear());
}

PoseIndex::Cell PoseIndex::cellOf(const Vec3& position) const {
  return (position / radius_).array().floor().cast<std::int64_t>();
}

}  // namespace smore
