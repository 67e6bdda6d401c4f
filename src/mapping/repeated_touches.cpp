// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/repeated_touches.h"

#include <algorithm>

namespace smore {

std::vector<Pose> repeatedTouches(const std::vector<Pose>& poses, double tolerance, double reach) {
  std::vector<Pose> repeated;
  for (const Pose& pose : poses) {
    const auto near = std::count_if(poses.begin(), poses.end(), [&](const Pose& other) {
      const double shift = distanceBetween(pose, other);
      return shift <= tolerance && shift + reach * angleBetween(pose, other) <= tolerance;
    });
    if (near > 1) repeated.push_back(pose);  // one is itself
  }
  return repeated;
}

}  // namespace smore
