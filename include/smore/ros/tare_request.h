// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace smore {

/// A request of a service thread to the sensing thread, and its answer.
class TareRequest {
 public:
  /// Asks for a tare and waits; false if it is not done within `timeout` [s].
  bool ask(double timeout) {
    std::unique_lock<std::mutex> lock(mutex_);
    asked_ = true;
    done_ = false;
    return changed_.wait_for(lock, std::chrono::duration<double>(timeout), [&] { return done_; });
  }

  /// Whether somebody asked since the last call.
  bool take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(asked_, false);
  }

  void finish() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (asked_) return;
    done_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool asked_ = false;
  bool done_ = false;
};

}  // namespace smore
