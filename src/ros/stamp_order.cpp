// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/stamp_order.h"

namespace smore {
namespace {

constexpr double kJump = 1.0;  // [s]; stamps that differ by less are late, or out of order

}  // namespace

// In seconds: the difference of two times may be more than a duration holds.
StampOrder::Verdict StampOrder::add(const ros::Time& stamp) {
  const double ahead = stamp.toSec() - newest_.toSec();
  if (!begun_ || (ahead > 0.0 && ahead <= kJump)) {
    begun_ = true;
    newest_ = stamp;
    doubtful_.reset();
    return Verdict::kNew;
  }
  if (ahead <= 0.0 && ahead >= -kJump) {
    doubtful_.reset();
    return Verdict::kRepeated;
  }
  if (!isConfirmed(stamp)) {
    doubtful_ = stamp;
    return Verdict::kDoubtful;
  }
  newest_ = stamp;
  doubtful_.reset();
  return ahead > 0.0 ? Verdict::kNew : Verdict::kWentBack;
}

// By a later one on the same side of the newest.
bool StampOrder::isConfirmed(const ros::Time& stamp) const {
  return doubtful_ && stamp > *doubtful_ && (stamp > newest_) == (*doubtful_ > newest_);
}

}  // namespace smore
