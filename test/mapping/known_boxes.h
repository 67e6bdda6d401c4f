// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/common/geometry.h"
#include "smore/mapping/prior.h"

namespace smore {

/// What is matter within a box, and free beside it, in voxels of a centimetre in the plane z = 0.
inline Prior boxKnown(const Vec3& min, const Vec3& max, double margin, double confidence = 0.999) {
  constexpr double kSize = 0.01;
  Prior prior{VoxelGrid(kSize), confidence};
  const Bounds box{min, max};
  const VoxelKey first = voxelAt({min.x() - margin, min.y() - margin, 0.0}, kSize);
  const VoxelKey last = voxelAt({max.x() + margin, max.y() + margin, 0.0}, kSize);
  for (VoxelKey key = first; key.x <= last.x; ++key.x) {
    for (key.y = first.y; key.y <= last.y; ++key.y) {
      Vec3 center = voxelCenter(key, kSize);
      center.z() = 0.5 * (min.z() + max.z());
      prior.known.set(key, box.contains(center) ? 1.0F : 0.0F);
    }
  }
  return prior;
}

/// The bar of wallObservations: 4 cm wide, it reaches 0.2 m ahead of the hand.
inline Prior barKnown(double confidence = 0.999) {
  return boxKnown({0.0, -0.02, -0.1}, {0.2, 0.02, 0.1}, 0.2, confidence);
}

}  // namespace smore
