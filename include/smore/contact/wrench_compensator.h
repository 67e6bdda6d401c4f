// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/contact/bias_tracker.h"
#include "smore/contact/contact_observation.h"
#include "smore/contact/payload.h"

namespace smore {

struct TareParameters {
  int samples = 100;               ///< averaged into the bias at least; 2 or more
  int noise_samples = 0;           ///< so many where noise asks for more and drift allows
  double max_force_stddev = 3.0;   ///< above, per axis: the robot was not still [N]
  double max_torque_stddev = 0.3;  ///< above, per axis: the robot was not still [N m]
};

/// Removes the sensor's bias and the payload's weight from raw wrenches.
///
/// The bias is the mean over still samples less the payload's weight in each: `samples` of them,
/// and up to `noise_samples` until the sensor's drift outweighs what averaging gains. A tare during
/// which a component varied more than allowed, and more than the sensor's noise explains, is
/// refused, with the reason, and starts again. Where the sensor drifts, the bias is tracked in free
/// space from then on.
class WrenchCompensator {
 public:
  /// A sample in free space counts for the bias once it is out of `track_delay` (BiasTracker).
  explicit WrenchCompensator(const TareParameters& tare, const Payload& payload = {},
                             const SensorNoise& noise = {}, const SampleWindow& track_delay = {});

  /// What the wrist carries from now on. The bias that was found with another payload is forgotten:
  /// a new tare begins.
  void setPayload(const Payload& payload);
  const Payload& payload() const { return payload_; }

  /// Forgets the bias and collects samples for a new one.
  void startTare();

  /// Forgets the bias, and collects no samples for a new one until a tare is started.
  void suspend();

  /// What was felt before a silence does not count in a tare that lasts.
  void interruptTare() { still_.clear(); }

  bool tared() const { return bias_.has_value(); }

  /// Why the last full set of samples was refused; empty if it was not.
  const std::string& tareProblem() const { return tare_problem_; }

  /// While not tared, uses up the sample for the tare and gives nothing. Else the wrench that the
  /// environment exerts on the object. The sample must be finite.
  std::optional<Wrench> process(const WrenchSample& raw);

  /// Lets the bias follow the sensor's drift: whether nothing touches in this sample, after it was
  /// processed.
  void track(const WrenchSample& raw, bool free);

  /// Takes `residual`, known to `stddev` [N] on each axis, into the bias as of `time` [s].
  void addToBias(double time, const Wrench& residual, double stddev);

  /// Of the sensor, at the origin and in the axes of the object frame; zero while not tared.
  Wrench bias() const { return bias_ ? bias_->bias() : Wrench{}; }

  /// How well the force's bias is known, per axis [N]; 0 while not tared.
  double biasStddev() const { return bias_ ? bias_->stddev() : 0.0; }

  /// How much of the compensated force the weight of an unknown mass may be [N]: the tare took it
  /// away, and it comes back as far as gravity turns in the object's axes. 0 while not tared.
  double unknownWeight(const Pose& T_world_object) const;

  /// In the axes of the object frame at the tare [m/s^2]; zero before the first one.
  const Vec3& gravityAtTare() const { return gravity_tared_; }

  /// When the bias was last learnt from a sample [s]; nothing while not tared.
  std::optional<double> biasTime() const;

 private:
  Wrench weight(const Pose& T_world_object) const;
  bool enoughForTare(double now) const;
  void finishTare(const WrenchSample& last);

  TareParameters parameters_;
  Payload payload_;
  SensorNoise noise_;
  SampleWindow track_delay_;
  std::vector<Wrench> still_;
  bool suspended_ = false;
  std::optional<BiasTracker> bias_;
  double tare_since_ = 0.0;            ///< time of the first still sample [s]
  double tared_at_ = 0.0;              ///< [s]
  Vec3 gravity_tared_ = Vec3::Zero();  ///< in the object's axes at the tare [m/s^2]
  std::string tare_problem_;
};

}  // namespace smore
