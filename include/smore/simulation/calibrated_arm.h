// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// simulation: Bullet scenes with an arm and a wrist sensor; knows nothing of maps or planners.

#include <cstdint>
#include <string>

#include "smore/kinematics/urdf_model.h"

namespace smore {

/// The arm of a scenario as it came out of its factory: each of its six joints off by a normal
/// error of `stddev` [m] on each axis and [rad] about each, drawn from the seed; the maker's
/// nominal one for 0.
UrdfModel calibratedArm(const Scenario& scenario, double stddev, std::uint64_t seed);

/// A robot description with the arm's six joints and their links, and how these look, as text: what
/// a user's description, made with the factory's calibration, knows of the arm.
std::string jointsDescription(const UrdfModel& arm);

}  // namespace smore
