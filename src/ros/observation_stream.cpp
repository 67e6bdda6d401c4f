// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/observation_stream.h"

#include <chrono>

namespace smore {

void ObservationStream::push(const ContactObservation& observation) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ = observation;
    if (open_) queue_.push_back(observation);
  }
  arrived_.notify_all();
}

void ObservationStream::open() {
  const std::lock_guard<std::mutex> lock(mutex_);
  queue_.clear();
  open_ = true;
}

void ObservationStream::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  queue_.clear();
  open_ = false;
}

std::optional<ContactObservation> ObservationStream::next(double timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto some = [&] { return !queue_.empty(); };
  if (!arrived_.wait_for(lock, std::chrono::duration<double>(timeout), some)) return std::nullopt;
  const ContactObservation observation = queue_.front();
  queue_.pop_front();
  return observation;
}

std::optional<ContactObservation> ObservationStream::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_;
}

}  // namespace smore
