// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/contact/contact_observation.h"

namespace smore {

struct TareParameters {
  int samples = 100;               ///< averaged into the bias; at least 2
  double max_force_stddev = 3.0;   ///< above, per axis: the robot was not still [N]
  double max_torque_stddev = 0.3;  ///< above, per axis: the robot was not still [N m]
};

/// What the wrist carries besides the contact.
struct Payload {
  double mass = 0.0;                          ///< [kg], not negative
  Vec3 center_of_mass_object = Vec3::Zero();  ///< in the object frame [m]
};

/// Removes the sensor's bias and the payload's weight from raw wrenches.
///
/// The bias is the mean over `samples` still samples less the payload's weight in each; a tare
/// during which a component varied more than allowed is refused, with the reason, and starts again.
class WrenchCompensator {
 public:
  explicit WrenchCompensator(const TareParameters& tare, const Payload& payload = {});

  /// Forgets the bias and collects samples for a new one.
  void startTare();

  bool tared() const { return bias_.has_value(); }

  /// Why the last full set of samples was refused; empty if it was not.
  const std::string& tareProblem() const { return tare_problem_; }

  /// While not tared, uses up the sample for the tare and gives nothing. Else the wrench that the
  /// environment exerts on the object. The sample must be finite.
  std::optional<Wrench> process(const WrenchSample& raw);

 private:
  Wrench weight(const Pose& T_world_object) const;
  void finishTare();

  TareParameters parameters_;
  Payload payload_;
  std::vector<Wrench> still_;
  std::optional<Wrench> bias_;
  std::string tare_problem_;
};

}  // namespace smore
