// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "smore/contact/contact_observation.h"

namespace smore {

/// Contact observations on their way to the thread that follows a motion.
class ObservationStream {
 public:
  void push(const ContactObservation& observation);

  /// From now on observations are kept for `next`; what came before is not.
  void open();
  /// Keeps the latest only.
  void close();

  /// The next observation since `open`; nothing if none comes within `timeout` of wall time [s].
  std::optional<ContactObservation> next(double timeout);

  /// The newest of all; nothing before the first.
  std::optional<ContactObservation> latest() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<ContactObservation> queue_;
  std::optional<ContactObservation> latest_;
  bool open_ = false;
};

}  // namespace smore
