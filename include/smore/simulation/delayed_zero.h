// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "smore/common/geometry.h"

namespace smore {

/// What a sensor takes off its wrenches. It is zeroed some time after it was asked to be: by the
/// mean since then, as a single sample would leave its noise in all that follow.
class DelayedZero {
 public:
  /// Asks for the zeroing at the time `at` [s]; an earlier request is dropped.
  void ask(double at) {
    at_ = at;
    sum_ = {};
    samples_ = 0;
  }

  /// The sensor's own reading at `now` [s], nothing taken off.
  void observe(double now, const Wrench& reading) {
    if (!at_) return;
    sum_.force += reading.force;
    sum_.torque += reading.torque;
    ++samples_;
    if (now < *at_) return;
    offset_ = {sum_.force / samples_, sum_.torque / samples_};
    at_.reset();
  }

  const Wrench& offset() const { return offset_; }

 private:
  std::optional<double> at_;
  Wrench sum_;
  int samples_ = 0;
  Wrench offset_;
};

}  // namespace smore
