// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/voxel_bricks.h"

namespace smore {

VoxelBricks::VoxelBricks(const std::vector<VoxelKey>& keys) {
  std::size_t count = 16;
  while (count < 2 * keys.size()) count *= 2;  // at most half full, even with one voxel a brick
  slots_.resize(count);
  for (const VoxelKey& key : keys) {
    const std::uint64_t brick = pack({key.x >> kShift, key.y >> kShift, key.z >> kShift});
    const int mask = kWidth - 1;
    const int bit = (key.x & mask) | (key.y & mask) << kShift | (key.z & mask) << 2 * kShift;
    Slot& slot = slots_[slotOf(brick)];
    slot.brick = brick;
    slot.bits |= std::uint64_t{1} << bit;
  }
}

std::uint64_t VoxelBricks::pack(const Index& brick) {
  const auto bits = [](int index) { return static_cast<std::uint64_t>(index) & 0xFFFFU; };
  return bits(brick.x()) | bits(brick.y()) << 16 | bits(brick.z()) << 32;
}

std::size_t VoxelBricks::slotOf(std::uint64_t brick) const {
  const std::size_t mask = slots_.size() - 1;
  // Fibonacci hashing: the odd constant is 2^64 over the golden ratio; the high bits are well
  // mixed.
  std::size_t slot = (brick * 0x9E3779B97F4A7C15ULL) >> 20 & mask;
  while (slots_[slot].bits != 0 && slots_[slot].brick != brick) slot = (slot + 1) & mask;
  return slot;
}

std::uint64_t VoxelBricks::boxBits(const Index& low, const Index& high) {
  const std::uint64_t x = row(low.x(), high.x());
  std::uint64_t y = 0;  // a layer of four rows
  for (int i = low.y(); i <= high.y(); ++i) y |= x << 4 * i;
  std::uint64_t z = 0;  // four layers
  for (int i = low.z(); i <= high.z(); ++i) z |= y << 16 * i;
  return z;
}

}  // namespace smore
