// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smore/contact/line_of_action.h"

namespace smore {

/// Tells from the first touches whether the wrench has the right sign, by the work that their
/// forces do (touchWorkShare).
class SignCheck {
 public:
  /// Takes a touch and the object's last way there, `from` -> `to` (T_world_object, some
  /// millimetres); the line is in the object frame. Why they contradict each other, with the
  /// remedy; empty where they do not, where neither is clear, and once a touch has told that the
  /// sign is right.
  std::string contradiction(const LineOfAction& line, const Pose& from, const Pose& to);

 private:
  bool known_ = false;
};

}  // namespace smore
