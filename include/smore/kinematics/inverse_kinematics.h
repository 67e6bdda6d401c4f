// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/kinematics/arm_model.h"
#include "smore/kinematics/ur_branches.h"

namespace smore {

/// Configurations that bring the tool to a pose, to 1e-9 m and rad.
///
/// Damped Newton steps on the URDF's own kinematics, so that a calibrated arm is met exactly. They
/// start from the closed form where the arm is built as Universal Robots', else from a fixed set of
/// configurations spread over the joints' ranges; the latter may miss a branch.
class InverseKinematics {
 public:
  /// `arm` must outlive this.
  explicit InverseKinematics(const ArmModel* arm);

  /// All configurations known, each joint in [-pi, pi], without regard to limits; those that differ
  /// by less than a milliradian are one. Empty where the pose is out of reach.
  std::vector<JointVector> branches(const Pose& T_base_tool) const;

  /// The configuration that Newton's steps from `seed` lead to: for a pose near that of the seed
  /// the one on the same branch, which is what keeps a motion in one piece. Nothing where they do
  /// not arrive.
  std::optional<JointVector> solveNear(const Pose& T_base_tool, const JointVector& seed) const;

  /// Smallest singular value of the Jacobian, in m/s and rad/s of the tool per rad/s: a motion of
  /// the tool at unit speed (1 m/s or 1 rad/s) may ask of the joints as much as its inverse.
  double singularity(const JointVector& q) const;

 private:
  std::vector<JointVector> seeds(const Pose& T_base_tool) const;

  const ArmModel* arm_;
  std::optional<UrGeometry> ur_;
};

}  // namespace smore
