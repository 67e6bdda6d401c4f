// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// What the wrist sensor carries besides the contact, as far as nobody else has taken it off: where
/// a controller takes off the weight that was set there, the rest is small, and of either sign.
struct Payload {
  double mass = 0.0;                  ///< [kg]; negative where too much was taken off
  Vec3 moment_object = Vec3::Zero();  ///< mass times centre of mass, in the object frame [kg m]; it
                                      ///< may be finite where the mass is zero
  double unknown_mass = 0.0;  ///< what may be carried beyond it [kg], not negative; 0: nothing
};

/// Gravity in the axes of the object frame [m/s^2].
inline Vec3 gravityIn(const Pose& T_world_object) {
  return T_world_object.linear().transpose() * gravity();
}

}  // namespace smore
