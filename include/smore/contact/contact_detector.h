// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "smore/contact/contact_observation.h"
#include "smore/contact/sample_window.h"
#include "smore/contact/sensor_noise.h"

namespace smore {

struct ContactDetectorParameters {
  double contact_force = 5.0;   ///< mean force over the fast window at or above: touching [N]
  double free_force = 0.5;      ///< mean force over the slow window below: nothing touches [N]
  double release_force = 2.5;   ///< release mean below: the contact may have ended [N]
  double residual_force = 3.0;  ///< what a gripper may keep after a touch (ResidualWatch) [N]
  double dwell = 0.004;         ///< how long the contact force must last; impacts are shorter [s]
  /// How long the mean must stay below the release force [s]: an object that swings in its grip
  /// after a stop passes through no force at all, again and again, while it presses on.
  double release_dwell = 0.06;
  SampleWindow fast_window{0.004};     ///< short: the stop waits for it
  SampleWindow release_window{0.004};  ///< at least the fast one; in it contact is found to end
  SampleWindow slow_window{0.02};      ///< long: sensor noise must fall below free_force in it
};

/// Tells contact from free space by the force's magnitude, with hysteresis against noise and a
/// dwell against impact spikes. The mean is taken over force vectors, so that noise cancels.
///
/// Samples may come at any rate, unevenly, with gaps. A window is full by the time that has passed
/// and the samples that came, not by how old its oldest sample happens to be. After a gap of
/// `kLongestGap` what was felt before says nothing any more.
class ContactDetector {
 public:
  /// A silence after which the object may have been anywhere [s]: a dozen samples of a slow sensor
  /// (50 Hz) may be lost in a row before.
  static constexpr double kLongestGap = 0.25;

  /// Stamps may be off by half of `noise`'s sample period.
  explicit ContactDetector(const ContactDetectorParameters& parameters,
                           const SensorNoise& noise = {});

  /// State after a sample of force [N] at `time` [s]; times must rise. `bias_stddev` [N]: how far,
  /// on each axis, all samples may be off together. What noise and bias explain of the slow mean is
  /// free space too, up to the release force.
  ContactState process(double time, const Vec3& force, double bias_stddev = 0.0);

  /// Whether the last slow mean may be noise and a bias that has drifted: nothing need touch. True
  /// wherever the state is free, and for all but kMissedDrift of free space.
  bool mayBeDrift() const { return may_be_drift_; }

  bool inContact() const { return in_contact_; }

  /// Whether the contact may have ended: its force has fallen below the release force.
  bool mayHaveEnded() const { return below_since_.has_value(); }

  /// Mean force over the release window [N]; zero before the first sample.
  Vec3 meanForce() const;

  /// Takes `force` [N] off all samples so far: they were off by it.
  void takeOff(const Vec3& force);

  /// Contacts confirmed so far.
  int contactCount() const { return contact_count_; }

  /// Forgets the samples and the state; the count goes on.
  void reset();

 private:
  struct Sample {
    double time = 0.0;
    Vec3 force;
  };

  struct Mean {
    Vec3 force;
    int samples = 0;
    double since = 0.0;  ///< time of the oldest sample in it [s]
  };

  void keep(double time, const Vec3& force);
  bool hasPassed(double duration, double elapsed) const;
  /// Whether something that is so now, or not, has been so for `dwell`; `since` is when it began.
  bool hasLasted(bool is_so, double dwell, std::optional<double>* since) const;
  Mean meanOver(const SampleWindow& window) const;
  void updateContact();
  void judgeSlowMean(double bias_stddev);

  ContactDetectorParameters parameters_;
  SensorNoise noise_;
  double tolerance_;  ///< of stamps [s]
  std::deque<Sample> samples_;
  double started_ = 0.0;  ///< time of the first sample since the last reset or gap [s]
  bool in_contact_ = false;
  bool quiet_ = false;  ///< the slow mean is that of free space
  bool may_be_drift_ = false;
  double contact_since_ = 0.0;         ///< oldest sample in the mean that confirmed the contact [s]
  std::optional<double> above_since_;  ///< when the contact force was reached, if it is [s]
  std::optional<double> below_since_;  ///< the same of falling below the release force
  int contact_count_ = 0;
};

}  // namespace smore
