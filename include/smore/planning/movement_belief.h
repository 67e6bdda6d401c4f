// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"

namespace smore {

/// Says how likely movements are to succeed, from those that did and those that were blocked.
class MovementBelief {
 public:
  virtual ~MovementBelief() = default;

  /// Probability that the object can move along `path` (T_world_object) from its first pose, where
  /// it stands, to its last; in [0, 1], and 1 for a path of one pose.
  virtual double success(const Path& path) const = 0;
};

}  // namespace smore
