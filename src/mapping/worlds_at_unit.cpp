// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/worlds_at_unit.h"

#include <algorithm>

#include "smore/mapping/surface_extents.h"

namespace smore {
namespace {

// Two contact distances: coarse enough to skip much, fine enough to be mostly right.
constexpr float kBlockSizes = 2.0F;

}  // namespace

WorldsAtUnit::WorldsAtUnit(const WorldSamples& samples, const FeatureParameters& feature,
                           const ExtentParameters& extent, bool planar, std::uint64_t seed)
    : radius_(feature.radius),
      contact_distance_(feature.conflictDistance()),
      planar_(planar),
      members_(samples.members),
      unknown_(samples.prior, samples.members, feature.reach, planar),
      known_object_(samples.prior.balls(MapSide::kObject)),
      known_world_(samples.prior.balls(MapSide::kWorld)) {
  const SurfaceExtents surfaces(samples, feature, extent, planar, seed);
  object_ = surfaces.object();
  behind_object_ = surfaces.behindObject();
  world_ = surfaces.world();
}

const std::vector<MatterOverlap>& WorldsAtUnit::overlaps() const {
  std::call_once(overlaps_->made, [this] { overlaps_->all = makeOverlaps(); });
  return overlaps_->all;
}

std::vector<MatterOverlap> WorldsAtUnit::makeOverlaps() const {
  std::vector<MatterOverlap> result;
  const auto touched = static_cast<float>(contact_distance_);
  const auto add = [&](const auto& object, const auto& world, TouchDistance distance) {
    if (object.empty() || world.empty()) return;
    result.emplace_back(object, world, distance, kBlockSizes * touched, planar_);
  };
  add(object_, world_, {touched});
  for (const KnownBalls& known : known_object_) add(known.balls, world_, touchDistance(known));
  for (const KnownBalls& known : known_world_) add(object_, known.balls, touchDistance(known));
  for (const KnownBalls& object : known_object_) {
    for (const KnownBalls& world : known_world_) {
      const double mean = object.radius + world.radius;
      const double spread = object.tolerance + world.tolerance;
      add(object.balls, world.balls, {static_cast<float>(mean), static_cast<float>(spread)});
    }
  }
  return result;
}

TouchDistance WorldsAtUnit::touchDistance(const KnownBalls& known) const {
  return {static_cast<float>(radius_ + known.radius), static_cast<float>(known.tolerance)};
}

void WorldsAtUnit::setTouching(const Eigen::Isometry3f& T_map_object, double reach) {
  touching_poses_.push_back({T_map_object, static_cast<float>(reach)});
}

bool WorldsAtUnit::isLikeATouchingPose(const Eigen::Isometry3f& T_map_object) const {
  const auto largest = 0.5F * static_cast<float>(contact_distance_);
  return std::any_of(
      touching_poses_.begin(), touching_poses_.end(), [&](const TouchingPose& touching) {
        const float shift =
            (touching.T_map_object.translation() - T_map_object.translation()).norm();
        if (shift > largest) return false;
        const Eigen::Matrix3f turn =
            touching.T_map_object.linear().transpose() * T_map_object.linear();
        return shift + touching.reach * Eigen::AngleAxisf(turn).angle() <= largest;
      });
}

HypothesisMask WorldsAtUnit::touching(const Eigen::Isometry3f& T_map_object, int enough) const {
  if (isLikeATouchingPose(T_map_object)) return members_;
  HypothesisMask result = 0;
  for (const MatterOverlap& overlap : overlaps()) {
    result |= overlap.at(T_map_object, enough);
    if (__builtin_popcountll(result) > enough) break;
  }
  return result;
}

}  // namespace smore
