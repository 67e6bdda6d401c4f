// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/free_tracks.h"

namespace smore {
namespace {

constexpr double kSpacing = 0.5;  // [units of length]
constexpr double kAngle = 0.15;   // [rad]

}  // namespace

bool isThinnedOut(const Pose& a, const Pose& b, double unit) {
  return distanceBetween(a, b) <= kSpacing * unit && angleBetween(a, b) <= kAngle;
}

std::vector<Path> freeTracks(const Path& trail, double unit) {
  std::vector<Path> tracks;
  for (std::size_t i = 0; i < trail.size(); ++i) {
    if (i == 0 || !isThinnedOut(trail[i - 1], trail[i], unit)) {
      tracks.push_back({trail[i]});
    } else if (!isThinnedOut(tracks.back().back(), trail[i], unit)) {
      tracks.back().push_back(trail[i]);
    }
  }
  return tracks;
}

}  // namespace smore
