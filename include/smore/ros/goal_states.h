// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatus.h>

namespace smore {

/// Whether an action's goal has not ended yet.
inline bool isUnderWay(const actionlib_msgs::GoalStatus& goal) {
  using Status = actionlib_msgs::GoalStatus;
  return goal.status == Status::PENDING || goal.status == Status::ACTIVE ||
         goal.status == Status::PREEMPTING || goal.status == Status::RECALLING;
}

}  // namespace smore
