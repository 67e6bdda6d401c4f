// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/trail.h"

namespace smore {
namespace {

constexpr double kSpacing = 0.002;  // [m + rad]
// A robot that was stopped in a motion has run on by less [m + rad].
constexpr double kNear = 0.01;

}  // namespace

void Trail::setOutFrom(const Pose& here) {
  if (!endsAt(here)) clear();
  record(here);
}

void Trail::record(const Pose& pose) {
  if (poses_.empty() || gapBetween(poses_.back(), pose) >= kSpacing) poses_.push_back(pose);
}

void Trail::unwind(const Pose& here) {
  while (poses_.size() > 1 &&
         gapBetween(poses_[poses_.size() - 2], here) < gapBetween(poses_.back(), here)) {
    poses_.pop_back();
  }
}

bool Trail::endsAt(const Pose& here) const {
  return !poses_.empty() && gapBetween(poses_.back(), here) < kNear;
}

Path Trail::wayBack(const Pose& here, double distance) const {
  Path back;
  if (poses_.size() == 1 && gapBetween(poses_.front(), here) < kSpacing) return back;
  double travelled = 0.0;
  for (auto pose = poses_.rbegin(); pose != poses_.rend() && travelled < distance; ++pose) {
    travelled += gapBetween(back.empty() ? here : back.back(), *pose);
    back.push_back(*pose);
  }
  return back;
}

}  // namespace smore
