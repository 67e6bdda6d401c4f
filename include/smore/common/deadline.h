// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/elapsed_time.h"

namespace smore {

/// The moment from which on work that can be given up is given up.
class Deadline {
 public:
  /// `seconds` of wall time from now; at or below 0 it has passed already.
  explicit Deadline(double seconds) : begin_(SteadyClock::now()), allowed_(seconds) {}

  bool passed() const { return secondsSince(begin_) >= allowed_; }

 private:
  SteadyClock::time_point begin_;
  double allowed_;
};

}  // namespace smore
