// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/latest_job.h"

#include <utility>

namespace smore {

LatestJob::LatestJob() : thread_([this] { work(); }) {}

LatestJob::~LatestJob() { end(); }

void LatestJob::give(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = std::move(job);
  }
  given_.notify_one();
}

void LatestJob::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  given_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void LatestJob::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return ending_ || next_; });
    if (ending_) return;
    const std::function<void()> job = std::exchange(next_, nullptr);
    lock.unlock();
    job();
    lock.lock();
  }
}

}  // namespace smore
