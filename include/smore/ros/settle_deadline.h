// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace smore {

/// When to give up that the sensor settles: gives the line of a contact, or says that the object is
/// free. Its windows are times that are lengthened to numbers of samples where noise asks for it;
/// at 500 Hz a contact takes a tenth of both limits, and a residual that is waited out the half.
class SettleDeadline {
 public:
  /// Whether the observation at `time` [s] comes too late. Each is told, in its order.
  bool passedAt(double time) {
    if (!begin_) begin_ = time;
    ++samples_;
    return samples_ > kSamples && time - *begin_ > kDuration;
  }

 private:
  static constexpr int kSamples = 1000;
  static constexpr double kDuration = 2.0;  // [s]

  std::optional<double> begin_;
  int samples_ = 0;
};

}  // namespace smore
