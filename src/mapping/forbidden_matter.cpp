// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/forbidden_matter.h"

#include <utility>

namespace smore {

ForbiddenMatter::ForbiddenMatter(const std::vector<MaskedPoint>& other,
                                 std::vector<Eigen::Isometry3f> poses, float distance, float cell)
    : other_(other, distance, cell), poses_(std::move(poses)), cell_(cell) {}

HypothesisMask ForbiddenMatter::at(const Eigen::Vector3f& point) {
  const auto found = known_.emplace(MaskedPoints::cellKey(point, cell_), 0);
  HypothesisMask& mask = found.first->second;
  if (!found.second) return mask;
  const Eigen::Vector3f center = (point / cell_).array().round().matrix() * cell_;
  for (const Eigen::Isometry3f& T : poses_) {
    mask |= other_.at(T * center);
    if (mask == ~HypothesisMask{0}) break;
  }
  return mask;
}

}  // namespace smore
