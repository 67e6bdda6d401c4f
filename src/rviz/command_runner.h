// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace smore {

/// Runs commands that may take long, each in a thread of its own: none waits for another, who
/// starts them goes on at once, and the end of the program waits for none.
class CommandRunner {
 public:
  /// Does it and says what became of it. It may outlive the runner: what it uses it must own.
  using Command = std::function<std::string()>;

  CommandRunner();

  /// Begins `command`, whether others of this name run or not.
  void start(const std::string& name, Command command);

  /// Whether a command of this name has not ended yet.
  bool running(const std::string& name) const;

  /// What the last command that ended says, after its name; empty: none has.
  std::string answer() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
};

}  // namespace smore
