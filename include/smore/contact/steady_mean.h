// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "smore/common/geometry.h"
#include "smore/contact/sample_window.h"
#include "smore/contact/sensor_noise.h"

namespace smore {

/// Mean of the newest wrenches of a contact, and whether they stand still. What is held swings
/// after a touch, and its inertia is then in the wrench: by how much and how long depends on the
/// object and the gripper, and cannot be told beforehand.
///
/// The window is cut into three parts of equally many samples. The wrench stands still where the
/// means of all three agree: two alone agree about each turning point of a swing too.
class SteadyMean {
 public:
  /// Over `window`, three samples at least, of a sensor with this noise per sample.
  SteadyMean(const SampleWindow& window, const SensorNoise& noise);

  /// `time` [s] rises; samples that are older than the window are forgotten.
  void add(double time, const Wrench& wrench);

  /// Whether the samples fill the window.
  bool full() const;

  /// Whether what swings moves the line of action by less than 2 % of its lever and 1 mm, and turns
  /// it by less than 0.02 rad.
  bool steady() const;

  int count() const { return static_cast<int>(samples_.size()); }

  /// Of all samples that are kept; at least one.
  Wrench mean() const;

  /// How far the means of two parts are apart at most, beyond what noise explains (99 %): in force
  /// [N] and in torque [N m].
  struct Swing {
    double force = 0.0;
    double torque = 0.0;
  };
  Swing swing() const;

 private:
  struct Sample {
    double time;
    Wrench wrench;
  };

  Wrench meanOf(std::size_t begin, std::size_t end) const;

  SampleWindow window_;
  SensorNoise noise_;
  std::deque<Sample> samples_;
};

}  // namespace smore
