// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/contact/line_of_action.h"

namespace smore {

enum class ContactState {
  kFree,     ///< the filtered force is below the free-space threshold: nothing touches
  kUnsure,   ///< in between: no statement
  kContact,  ///< confirmed contact
};

/// One sample of the wrist: its wrench without bias and weight, at the origin and in the axes of
/// the object frame, and the pose at the same instant.
struct WrenchSample {
  double time = 0.0;  ///< [s]
  Wrench wrench;      ///< exerted by the environment on the object
  Pose T_world_object = Pose::Identity();
  Vec3 sensor_object = Vec3::Zero();  ///< the sensor's origin in the object frame [m]: its torque's
                                      ///< errors are errors about this point
  Eigen::Matrix3d sensor_axes_object =
      Eigen::Matrix3d::Identity();  ///< the sensor's axes in the object frame, as columns
};

/// No robot's object is farther from the world's origin, on any axis [m]: a pose beyond comes from
/// a fault. The choice is ours: room for frames of surveys. Maps of small voxels end nearer, and
/// leave out what is beyond them.
constexpr double kFarthestPlace = 1e4;

/// What touch says about the pose at one instant.
struct ContactObservation {
  double time = 0.0;  ///< [s]
  Pose T_world_object = Pose::Identity();
  ContactState state = ContactState::kUnsure;
  int contact_id = 0;  ///< contacts confirmed so far: rises by one at each new contact, starts at 0
  std::optional<LineOfAction> line;  ///< in the object frame; given once in each contact
};

/// Learns from touch: a map, a memory of invalid poses.
class ContactObserver {
 public:
  virtual ~ContactObserver() = default;

  /// Takes one observation. The order and the rate of free observations must not matter beyond what
  /// the implementation's documentation says.
  virtual void observe(const ContactObservation& observation) = 0;
};

}  // namespace smore
