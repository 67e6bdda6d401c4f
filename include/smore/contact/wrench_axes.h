// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "smore/common/geometry.h"
#include "smore/common/parameters.h"

namespace smore {

/// How a driver gives a wrench, against what its frame_id says and what a wrench is here (exerted
/// by the environment on the object): turned by quarter turns, and perhaps with the other sign.
struct WrenchAxes {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< from the driver's axes to the frame's
  double sign = 1.0;                                   ///< 1 or -1
};

/// The wrench that the driver's stands for; a turn leaves force and torque a pair.
Wrench inFrame(const WrenchAxes& axes, const Wrench& of_driver);

/// First `first`, then `second`.
WrenchAxes compose(const WrenchAxes& second, const WrenchAxes& first);

/// All 48 of them, the identity first.
std::vector<WrenchAxes> allWrenchAxes();

/// As parameters are written: "wrench_sign: -1, wrench_axes: y -x z".
std::string toText(const WrenchAxes& axes);

/// Reads `wrench_sign` (1 or -1) and `wrench_axes`, the driver's axes that are the frame's x, y and
/// z, as "y -x z"; neither need be given. Errors are noted in `reader`: axes that do not make a
/// right-handed frame, too.
WrenchAxes readWrenchAxes(ParameterReader* reader);

}  // namespace smore
