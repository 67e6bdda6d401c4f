// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace smore {

/// Measures how often and how evenly samples come, over a second after the other.
class SampleRate {
 public:
  /// Takes a sample's time [s]; times must rise. A silence of more than a quarter of a second is a
  /// gap and says nothing about the rate.
  void add(double time) {
    if (!begin_ || time - newest_ > kGap) {
      begin(time);
    } else {
      ++count_;
      squares_ += (time - newest_) * (time - newest_);
    }
    newest_ = time;
    if (time - *begin_ < kMeasured) return;
    period_ = (time - *begin_) / count_;
    jitter_ = std::sqrt(std::max(0.0, squares_ / count_ - *period_ * *period_));
    begin(time);
  }

  /// [s]; nothing before the first second without a gap.
  std::optional<double> period() const { return period_; }

  /// Standard deviation of the times between two samples in that second [s]; nothing as above.
  std::optional<double> jitter() const { return jitter_; }

 private:
  void begin(double time) {
    begin_ = time;
    count_ = 0;
    squares_ = 0.0;
  }

  static constexpr double kGap = 0.25;      // [s]
  static constexpr double kMeasured = 1.0;  // [s]

  std::optional<double> begin_;  ///< of the second that is measured [s]
  double newest_ = 0.0;          ///< [s]
  int count_ = 0;                ///< since then
  double squares_ = 0.0;         ///< of the times between two samples since then, summed [s^2]
  std::optional<double> period_, jitter_;
};

}  // namespace smore
