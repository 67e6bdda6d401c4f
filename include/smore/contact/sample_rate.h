// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace smore {

/// Measures how often samples come: the mean period over a second after the other.
class SampleRate {
 public:
  /// Takes a sample's time [s]; times must rise. A silence of more than a quarter of a second is a
  /// gap and says nothing about the rate.
  void add(double time) {
    if (!begin_ || time - newest_ > kGap) {
      begin_ = time;
      count_ = 0;
    } else {
      ++count_;
    }
    newest_ = time;
    if (time - *begin_ < kMeasured) return;
    period_ = (time - *begin_) / count_;
    begin_ = time;
    count_ = 0;
  }

  /// [s]; nothing before the first second without a gap.
  std::optional<double> period() const { return period_; }

 private:
  static constexpr double kGap = 0.25;      // [s]
  static constexpr double kMeasured = 1.0;  // [s]

  std::optional<double> begin_;  ///< of the second that is measured [s]
  double newest_ = 0.0;          ///< [s]
  int count_ = 0;                ///< since then
  std::optional<double> period_;
};

}  // namespace smore
