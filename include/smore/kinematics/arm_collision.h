// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// kinematics: arms: from their URDF to trajectories of the joints along a path of the object.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "smore/kinematics/arm_model.h"

namespace smore {

/// Tells whether links of the arm, gripper included, are in each other's way. Links that stand
/// together or are joined by one joint are not compared.
class ArmCollision {
 public:
  /// `arm` must outlive this. InputError for a collision mesh.
  ArmCollision(const UrdfModel& urdf, const ArmModel* arm);
  ~ArmCollision();
  ArmCollision(const ArmCollision&) = delete;
  ArmCollision& operator=(const ArmCollision&) = delete;

  /// Two links that are nearer to one another than 5 mm, if there are any.
  std::optional<std::pair<std::string, std::string>> collidingLinks(const JointVector& q) const;

  /// Height of the lowest point of all moving links over the base's mounting plane [m], by their
  /// bounding boxes: not above the true height.
  double lowestPoint(const JointVector& q) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smore
