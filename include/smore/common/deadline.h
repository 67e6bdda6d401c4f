// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace smore {

/// The moment from which on work that can be given up is given up, by a clock that never jumps.
class Deadline {
 public:
  /// `seconds` of wall time from now; at or below 0 it has passed already.
  explicit Deadline(double seconds) : begin_(std::chrono::steady_clock::now()), allowed_(seconds) {}

  bool passed() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return elapsed.count() >= allowed_;
  }

 private:
  std::chrono::steady_clock::time_point begin_;
  double allowed_;
};

}  // namespace smore
