// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// What the wrist sensor carries besides the contact.
struct Payload {
  double mass = 0.0;                          ///< [kg], not negative
  Vec3 center_of_mass_object = Vec3::Zero();  ///< in the object frame [m]
  double unknown_mass = 0.0;  ///< what may be carried beyond it [kg], not negative; 0: nothing
};

/// Gravity in the axes of the object frame [m/s^2].
inline Vec3 gravityIn(const Pose& T_world_object) {
  return T_world_object.linear().transpose() * gravity();
}

}  // namespace smore
