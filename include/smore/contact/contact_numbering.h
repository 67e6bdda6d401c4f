// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace smore {

/// Numbers of contacts that stay apart where their source begins at 0 again (a listener that was
/// started anew), and where earlier ones come from a file.
class ContactNumbering {
 public:
  /// The number of a contact that its source calls `id`, not negative. Sources count up.
  int numberOf(int id) {
    if (id < last_id_) offset_ += last_id_;
    last_id_ = id;
    return offset_ + id;
  }

  /// From now on numbers are above `number`, those of contacts that the source has not left yet
  /// among them.
  void continueAfter(int number) { offset_ = std::max(offset_, number); }

 private:
  int offset_ = 0;
  int last_id_ = 0;
};

}  // namespace smore
