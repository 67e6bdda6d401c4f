// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/kinematics/urdf_model.h"
#include "smore/scenario/scenario.h"

namespace smore {

/// The arm of a scenario with its gripper and primitives (armUrdf), its six joints standing where
/// `description` has them and limited as there: that of the user, with the arm's factory
/// calibration, as Universal Robots' ur_description makes it. The directions of their axes, what is
/// fixed between the links, meshes and what else hangs on it are not looked at.
///
/// InputError where a joint is missing, hangs between other links, has no limits, or stands more
/// than 5 cm or 0.1 rad from where the arm's own URDF has it: it is another arm's then. The message
/// names the source of `description`; that of the result names both.
UrdfModel describedArm(const Scenario& scenario, const UrdfModel& description);

/// Whether `arm`, of describedArm or armUrdf, carries a factory calibration: one of its joints
/// stands elsewhere than the maker's table has it, by more than rounding.
bool isCalibrated(const Scenario& scenario, const UrdfModel& arm);

}  // namespace smore
