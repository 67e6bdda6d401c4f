// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/contact/line_of_action.h"

namespace smore {

/// The work F.dx + M.dr that a touch's force does on the object on its last way `from` -> `to`
/// (T_world_object, some millimetres), as a share of the most that a force so far from the object's
/// origin could do, -1 to 1; 0 where it has not moved. The line is in the object frame.
///
/// What stands still can only take work from what moves against it (power F.v + M.w <= 0), whatever
/// the friction: a share clearly above 0 says that the wrench has the wrong sign or axes.
double touchWorkShare(const LineOfAction& line, const Pose& from, const Pose& to);

}  // namespace smore
