// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/planner_status.h"

#include <algorithm>

namespace smore {

void PlannerStatus::begin() {
  const std::lock_guard<std::mutex> lock(mutex_);
  planning_ = true;
  begun_ = ros::WallTime::now();
}

void PlannerStatus::end() {
  planning_ = false;
  last_ = sinceBegin();
  longest_ = std::max(longest_, last_);
}

void PlannerStatus::find(double length, std::optional<double> risk) {
  const std::lock_guard<std::mutex> lock(mutex_);
  end();
  ++found_;
  length_ = length;
  risk_ = risk;
  reason_.clear();
}

void PlannerStatus::refuse(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  end();
  ++refused_;
  reason_ = reason;
}

void PlannerStatus::compose(Status* status) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (planning_) {
    status->summaryf(Status::OK, "planning for %.1f s", sinceBegin());
  } else if (!reason_.empty()) {
    status->summary(Status::WARN, "the last plan was refused: " + reason_);
  } else if (found_ == 0) {
    status->summary(Status::OK, "no plan asked for yet");
  } else {
    status->summaryf(Status::OK, "the last plan took %.2f s", last_);
  }
  status->add("plans", found_);
  status->add("plans refused", refused_);
  status->add("time of the last plan [s]", last_);
  status->add("longest time of a plan [s]", longest_);
  if (length_) status->add("length of the last plan [m]", *length_);
  if (risk_) status->add("risk of the last plan", *risk_);
}

}  // namespace smore
