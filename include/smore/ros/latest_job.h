// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace smore {

/// Does jobs in a thread of its own, of those that wait only the newest: whoever gives one goes on
/// at once, and no backlog grows where jobs come faster than they are done.
class LatestJob {
 public:
  LatestJob();
  ~LatestJob();

  /// Takes the place of a job that has not begun.
  void give(std::function<void()> job);

  /// Waits for the job that is being done; no other begins any more.
  void end();

 private:
  void work();

  std::mutex mutex_;  ///< guards all below but the thread
  std::condition_variable given_;
  std::function<void()> next_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace smore
