// SPDX-License-Identifier: BSD-3-Clause
#include "command_runner.h"

#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace smore {

struct CommandRunner::Shared {
  std::mutex mutex;  ///< guards all below
  std::multiset<std::string> running;
  std::string answer;
};

CommandRunner::CommandRunner() : shared_(std::make_shared<Shared>()) {}

void CommandRunner::start(const std::string& name, Command command) {
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->running.insert(name);
  }
  std::thread([name, command = std::move(command), shared = shared_] {
    const std::string said = command();
    const std::lock_guard<std::mutex> lock(shared->mutex);
    shared->running.erase(shared->running.find(name));
    shared->answer = name;
    shared->answer.append(": ").append(said);
  }).detach();
}

bool CommandRunner::running(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return shared_->running.count(name) > 0;
}

std::string CommandRunner::answer() const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return shared_->answer;
}

}  // namespace smore
