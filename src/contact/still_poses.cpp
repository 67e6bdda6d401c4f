// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/still_poses.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

// Angle that gravity turns by in the object's axes from one pose to the other [rad].
double tiltBetween(const Pose& a, const Pose& b) {
  const Vec3 down_a = gravityIn(a);
  const Vec3 down_b = gravityIn(b);
  return std::atan2(down_a.cross(down_b).norm(), down_a.dot(down_b));
}

}  // namespace

StillPoses::StillPoses(const StillPosesParameters& parameters) : parameters_(parameters) {}

bool StillPoses::add(const WrenchSample& sample) {
  const Pose& pose = sample.T_world_object;
  if (!stand_ || gapBetween(*stand_, pose) > parameters_.moved) {
    stand_ = pose;
    beginAverage(sample, parameters_.settle);
  }
  const double age = sample.time - average_from_;
  if (age < 0.0) return false;
  sum_.force += sample.wrench.force;
  sum_.torque += sample.wrench.torque;
  ++count_;
  if (age < parameters_.window.duration || count_ < parameters_.window.samples) return false;
  keep({sample.time,
        {sum_.force / count_, sum_.torque / count_},
        pose,
        sample.sensor_object,
        sample.sensor_axes_object});
  beginAverage(sample, 0.0);
  return true;
}

void StillPoses::clear() {
  poses_.clear();
  stand_.reset();
}

void StillPoses::beginAverage(const WrenchSample& sample, double settle) {
  average_from_ = sample.time + settle;
  sum_ = Wrench();
  count_ = 0;
}

void StillPoses::keep(const StillWrench& still) {
  const auto outdated = [&](const StillWrench& other) {
    return still.time - other.time > parameters_.max_age ||
           tiltBetween(still.T_world_object, other.T_world_object) < parameters_.distinct;
  };
  poses_.erase(std::remove_if(poses_.begin(), poses_.end(), outdated), poses_.end());
  poses_.push_back(still);
}

}  // namespace smore
