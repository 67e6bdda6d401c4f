// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/voxel_line.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace smore {
namespace {

// One axis of the traversal: where the segment's parameter (0 at a, 1 at b) next crosses a face.
struct Axis {
  int step = 0;
  int remaining = 0;  ///< faces still to cross
  double next = std::numeric_limits<double>::infinity();
  double increment = 0.0;
};

Axis makeAxis(double a, double b, int first, int last, double voxel_size) {
  Axis axis;
  axis.remaining = std::abs(last - first);
  if (axis.remaining == 0) return axis;
  axis.step = last > first ? 1 : -1;
  const double face = (axis.step > 0 ? first + 1 : first) * voxel_size;
  axis.next = (face - a) / (b - a);
  axis.increment = voxel_size / std::abs(b - a);
  return axis;
}

// The axis whose face comes first. One without faces left never wins, so that rounding cannot carry
// the traversal past the last voxel.
int nextAxis(const Axis (&axes)[3]) {
  int best = -1;
  for (int i = 0; i < 3; ++i) {
    if (axes[i].remaining > 0 && (best < 0 || axes[i].next < axes[best].next)) best = i;
  }
  return best;
}

}  // namespace

std::vector<VoxelKey> voxelsOnSegment(const Vec3& a, const Vec3& b, double voxel_size) {
  const VoxelKey first = voxelAt(a, voxel_size);
  const VoxelKey last = voxelAt(b, voxel_size);
  Axis axes[3] = {makeAxis(a.x(), b.x(), first.x, last.x, voxel_size),
                  makeAxis(a.y(), b.y(), first.y, last.y, voxel_size),
                  makeAxis(a.z(), b.z(), first.z, last.z, voxel_size)};
  std::vector<VoxelKey> keys{first};
  VoxelKey key = first;
  for (int i = nextAxis(axes); i >= 0; i = nextAxis(axes)) {
    std::int16_t& index = i == 0 ? key.x : i == 1 ? key.y : key.z;
    index = static_cast<std::int16_t>(index + axes[i].step);
    axes[i].next += axes[i].increment;
    --axes[i].remaining;
    keys.push_back(key);
  }
  return keys;
}

}  // namespace smore
