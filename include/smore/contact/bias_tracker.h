// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// contact: from raw wrenches to observations: free, or touched, and along which line; when a robot
// must stop.

#include <deque>

#include "smore/common/geometry.h"
#include "smore/contact/sample_window.h"
#include "smore/contact/sensor_noise.h"

namespace smore {

/// Follows a sensor's bias as it drifts: a Kalman filter of a random walk, the same gain on all
/// axes of force and torque, that learns from samples in free space alone.
///
/// A sample counts once it is out of the window `delay` and everything since has been free: the
/// first samples of a contact, which come before it is confirmed, never count. Without drift the
/// bias stays.
class BiasTracker {
 public:
  /// `bias` as of time `time` [s], its force known to `stddev` [N] on each axis.
  BiasTracker(const SensorNoise& noise, const SampleWindow& delay, const Wrench& bias,
              double stddev);

  /// Takes a wrench without weight at `time` [s]; whether nothing touches.
  void observe(double time, const Wrench& unloaded, bool free);

  const Wrench& bias() const { return bias_; }

  /// How well the force's bias is known now, per axis [N].
  double stddev() const;

  /// Time of the newest sample that the bias has learnt from [s]; negative if there is none.
  double learntAt() const { return learnt_at_; }

 private:
  struct Sample {
    double time = 0.0;
    Wrench unloaded;
  };

  void age(double time);
  void learn(const Sample& sample);

  SensorNoise noise_;
  SampleWindow delay_;
  Wrench bias_;
  double variance_;            ///< of the force's bias at known_at_, per axis [N^2]
  double known_at_ = -1.0;     ///< [s]; negative before the first sample
  double newest_ = -1.0;       ///< [s]
  double free_since_ = -1.0;   ///< [s]; negative while something may touch
  double learnt_at_ = -1.0;    ///< [s]
  std::deque<Sample> recent_;  ///< within the delay
};

}  // namespace smore
