// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/residual_watch.h"

#include <algorithm>

#include "smore/contact/sensor_noise.h"

namespace smore {
namespace {

constexpr double kLeastNearness = 1e-4;  // [m + rad]
constexpr double kNearness = 0.1;        // of the way to the touch
constexpr size_t kMostPoses = 10000;     // a metre of the way in steps of the least nearness

}  // namespace

std::optional<Wrench> ResidualWatch::observe(double time, const Pose& T_world_object,
                                             const Wrench& wrench, double mean_stddev,
                                             ContactState state) {
  if (state == ContactState::kFree) {
    rememberFree(time, T_world_object);
    touched_.reset();
    earlier_.reset();
    mean_.reset();
    return std::nullopt;
  }
  lately_free_.clear();
  if (state == ContactState::kContact && !touched_) touched_ = T_world_object;
  if (!touched_) return std::nullopt;
  if (!mean_) mean_ = Mean{time, T_world_object, {}, 0};
  mean_->sum.force += wrench.force;
  mean_->sum.torque += wrench.torque;
  ++mean_->count;
  if (!complete(time)) return std::nullopt;
  std::optional<Wrench> residual;
  if (earlier_ && isSmallAndSteady(*earlier_, *mean_, mean_stddev) &&
      wasFree(earlier_->first_pose) && wasFree(mean_->first_pose) && wasFree(T_world_object)) {
    residual = meanOf(*earlier_, *mean_);
  }
  earlier_ = residual ? std::nullopt : mean_;
  mean_.reset();
  return residual;
}

void ResidualWatch::clear() { *this = ResidualWatch(parameters_); }

void ResidualWatch::rememberFree(double time, const Pose& pose) {
  lately_free_.push_back({time, pose});
  const SampleWindow& window = parameters_.slow_window;
  while (static_cast<int>(lately_free_.size()) > window.samples &&
         time - lately_free_.front().time > window.duration) {
    const Pose& proven = lately_free_.front().pose;
    if (free_poses_.empty() || gapBetween(free_poses_.back(), proven) > 0.5 * kLeastNearness) {
      free_poses_.push_back(proven);
    }
    lately_free_.pop_front();
  }
  while (free_poses_.size() > kMostPoses) free_poses_.pop_front();
}

bool ResidualWatch::complete(double time) const {
  const SampleWindow& window = parameters_.mean_window;
  return time - mean_->since >= window.duration && mean_->count >= window.samples;
}

bool ResidualWatch::isSmallAndSteady(const Mean& earlier, const Mean& later,
                                     double mean_stddev) const {
  static const double quantile = maxwellQuantile(kMissedFreeSpace);
  const Vec3 change = later.sum.force / later.count - earlier.sum.force / earlier.count;
  return change.norm() <= parameters_.steady_force &&
         meanOf(earlier, later).force.norm() <= parameters_.max_force + quantile * mean_stddev;
}

Wrench ResidualWatch::meanOf(const Mean& earlier, const Mean& later) {
  const double count = earlier.count + later.count;
  return {(earlier.sum.force + later.sum.force) / count,
          (earlier.sum.torque + later.sum.torque) / count};
}

bool ResidualWatch::wasFree(const Pose& pose) const {
  const double near = std::max(kLeastNearness, kNearness * gapBetween(pose, *touched_));
  return std::any_of(free_poses_.rbegin(), free_poses_.rend(),
                     [&](const Pose& free) { return gapBetween(pose, free) <= near; });
}

}  // namespace smore
