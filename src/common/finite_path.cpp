// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/finite_path.h"

#include <algorithm>

#include "smore/common/result.h"

namespace smore {

void requireFinite(const Path& path) {
  if (!std::all_of(path.begin(), path.end(), [](const Pose& pose) { return isFinite(pose); })) {
    throw InputError(
        "a commanded pose has a value that is not finite; send finite positions and a unit "
        "quaternion");
  }
}

}  // namespace smore
