// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/motion_stream.h"

#include <algorithm>

namespace smore {
namespace {

// Between two horizons [s]: several may be late or lost before the robot brakes.
constexpr double kRenewal = 0.02;

}  // namespace

void MotionStream::begin(const JointTrajectory& motion) {
  motion_ = motion;
  time_ = 0.0;
  stamp_.reset();
  since_horizon_ = kRenewal;
}

std::optional<JointTrajectory> MotionStream::advance(double stamp, double scaling) {
  // What a robot does that hears nothing for longer has ended with its last horizon.
  const double passed = std::clamp(stamp - stamp_.value_or(stamp), 0.0, parameters_.duration);
  stamp_ = std::max(stamp, stamp_.value_or(stamp));
  time_ += scaling * passed;
  since_horizon_ += passed;
  if (since_horizon_ < kRenewal || scaling < kLeastScaling) return std::nullopt;
  since_horizon_ = 0.0;
  const double end = motion_.points.back().time;
  if (time_ >= end) {
    this->end();
    return std::nullopt;
  }
  const JointTrajectory horizon = horizonOf(motion_, time_, scaling, parameters_);
  if (time_ + scaling * parameters_.duration >= end) this->end();
  return horizon;
}

}  // namespace smore
