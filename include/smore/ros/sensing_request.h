// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace smore {

/// A request of a service thread to the sensing thread, and its answer.
class SensingRequest {
 public:
  struct Answer {
    bool success = false;
    std::string message;
  };

  /// Asks and waits; nothing if there is no answer within `timeout` [s]: what was not taken by then
  /// is not asked any more.
  std::optional<Answer> ask(double timeout) {
    std::unique_lock<std::mutex> lock(mutex_);
    asked_ = true;
    answer_.reset();
    changed_.wait_for(lock, std::chrono::duration<double>(timeout),
                      [&] { return answer_.has_value(); });
    if (!answer_) asked_ = false;
    return answer_;
  }

  /// Whether somebody asked since the last call.
  bool take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(asked_, false);
  }

  /// Answers a request that was taken; one that was not stays open.
  void finish(const Answer& answer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (asked_ || answer_) return;
    answer_ = answer;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool asked_ = false;
  std::optional<Answer> answer_ = Answer{};  ///< of the last request; nothing while it is open
};

}  // namespace smore
