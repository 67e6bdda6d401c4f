// SPDX-License-Identifier: BSD-3-Clause
#include "tare_requests.h"

#include "smore/ros/messages.h"

namespace smore {
namespace {

using Event = smore_msgs::SensingEvent;

constexpr double kZeroingShows = 0.5;       // [s] from a driver's zeroing until it has come through
constexpr double kLongestSuspension = 3.0;  // [s]; twice what a zeroing is waited for

}  // namespace

std::optional<std::uint8_t> TareRequests::apply(double time, ContactSensing* sensing) {
  if (suspension_.take()) return suspend(time, sensing);
  const bool over = suspended_until_ && time > *suspended_until_;
  if (over) suspended_until_.reset();
  if (tare_.take() || over) asked_at_ = time;
  if (!asked_at_) return std::nullopt;
  return begin(time, sensing);
}

std::optional<std::uint8_t> TareRequests::suspend(double time, ContactSensing* sensing) {
  const std::string objection = sensing->tareObjection();
  suspension_.finish({objection.empty(), objection});
  if (!objection.empty()) return std::nullopt;
  sensing->suspend();
  suspended_until_ = time + kLongestSuspension;
  return Event::SUSPEND;
}

// A zeroing at the driver shows in the signal only after a while: what presses may be it.
std::optional<std::uint8_t> TareRequests::begin(double time, ContactSensing* sensing) {
  const std::string objection = sensing->tareObjection();
  if (!objection.empty() && time - *asked_at_ < kZeroingShows) return std::nullopt;
  forget();
  if (!objection.empty()) {
    tare_.finish({false, objection});
    return std::nullopt;
  }
  sensing->startTare();
  return Event::TARE;
}

void TareRequests::forget() {
  asked_at_.reset();
  suspended_until_.reset();
}

}  // namespace smore
