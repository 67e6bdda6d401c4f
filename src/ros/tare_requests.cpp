// SPDX-License-Identifier: BSD-3-Clause
#include "tare_requests.h"

#include "smore/ros/messages.h"

namespace smore {
namespace {

using Event = smore_msgs::SensingEvent;

// What speaks against a request may pass by then [s]: a driver's zeroing has come through, and a
// robot that has just stopped stands.
constexpr double kPasses = 1.0;
constexpr double kLongestSuspension = 3.0;  // [s]; twice what a zeroing is waited for

}  // namespace

std::optional<std::uint8_t> TareRequests::apply(double time, ContactSensing* sensing) {
  if (suspension_.take()) zeroing_asked_at_ = time;
  if (zeroing_asked_at_) return suspend(time, sensing);
  const bool over = suspended_until_ && time > *suspended_until_;
  if (over) suspended_until_.reset();
  by_itself_ = by_itself_ || over;
  if (tare_.take()) asked_at_ = time;
  if (!tareWaits()) return std::nullopt;
  return begin(time, sensing);
}

std::optional<std::uint8_t> TareRequests::suspend(double time, ContactSensing* sensing) {
  const std::string objection = sensing->zeroingObjection();
  if (!objection.empty() && time - *zeroing_asked_at_ < kPasses) return std::nullopt;
  zeroing_asked_at_.reset();
  suspension_.finish({objection.empty(), objection});
  if (!objection.empty()) return std::nullopt;
  sensing->suspend();
  by_itself_ = false;
  suspended_until_ = time + kLongestSuspension;
  return Event::SUSPEND;
}

std::optional<std::uint8_t> TareRequests::begin(double time, ContactSensing* sensing) {
  const std::string objection = sensing->tareObjection();
  if (!objection.empty()) {
    // Who asked is told; a tare that begins by itself goes on waiting: without it nothing is felt.
    if (!asked_at_ || time - *asked_at_ < kPasses) return std::nullopt;
    asked_at_.reset();
    tare_.finish({false, objection});
    return std::nullopt;
  }
  forget();
  sensing->startTare();
  return Event::TARE;
}

void TareRequests::forget() {
  asked_at_.reset();
  zeroing_asked_at_.reset();
  suspended_until_.reset();
  by_itself_ = false;
}

}  // namespace smore
