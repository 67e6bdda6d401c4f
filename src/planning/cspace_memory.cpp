// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/cspace_memory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace smore {
namespace {

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

Cell cellOf(const Vec3& position, double width) {
  return (position / width).array().floor().cast<std::int64_t>();
}

/// Distinct for cells within 2^20 of the origin; beyond, cells may share a list, which costs time
/// only.
std::uint64_t keyOf(const Cell& cell) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x()) & kMask) |
         (static_cast<std::uint64_t>(cell.y()) & kMask) << 21 |
         (static_cast<std::uint64_t>(cell.z()) & kMask) << 42;
}

}  // namespace

CspaceMemory::CspaceMemory(const CspaceMemoryParameters& parameters) : parameters_(parameters) {
  if (!(parameters.radius > 0.0)) {
    throw std::invalid_argument("the radius of the C-space memory must be positive");
  }
}

void CspaceMemory::observe(const ContactObservation& observation) {
  if (observation.state != ContactState::kContact) return;
  if (last_contact_id_ == observation.contact_id) return;
  last_contact_id_ = observation.contact_id;
  const Cell cell = cellOf(observation.T_world_object.translation(), parameters_.radius);
  cells_[keyOf(cell)].push_back(static_cast<std::uint32_t>(poses_.size()));
  poses_.push_back(observation.T_world_object);
}

bool CspaceMemory::isValid(const Pose& pose, const Pose& known_free) const {
  const auto is_too_near = [&](std::uint32_t position) {
    const Pose& contact = poses_[position];
    if (distanceBetween(pose, contact) >= parameters_.radius) return false;
    const double distance = gapBetween(pose, contact);
    return distance < parameters_.radius && distance < gapBetween(known_free, contact);
  };
  // Origins within the radius lie in the same cell or in one that touches it.
  const Cell home = cellOf(pose.translation(), parameters_.radius);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const auto found = cells_.find(keyOf(home + Cell(dx, dy, dz)));
        if (found == cells_.end()) continue;
        const auto& near = found->second;
        if (std::any_of(near.begin(), near.end(), is_too_near)) return false;
      }
    }
  }
  return true;
}

void CspaceMemory::reset() {
  poses_.clear();
  cells_.clear();
  last_contact_id_.reset();
}

}  // namespace smore
