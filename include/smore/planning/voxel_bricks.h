// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "smore/planning/occupied_voxels.h"

namespace smore {

/// A set of voxels as bricks of 4 by 4 by 4 bits, found by an open-addressing index: all voxels of
/// a small box in a few look-ups.
class VoxelBricks {
 public:
  explicit VoxelBricks(const std::vector<VoxelKey>& keys);

  /// Calls `visit(VoxelKey)` for the voxels of the set with low <= index <= high on each axis, in
  /// an order that depends on nothing else. The bounds must be in the range of keys.
  template <typename Visitor>
  void visitBox(const Eigen::Vector3i& low, const Eigen::Vector3i& high,
                const Visitor& visit) const;

 private:
  using Index = Eigen::Vector3i;

  struct Slot {
    std::uint64_t brick = 0;  ///< packed index
    std::uint64_t bits = 0;   ///< 0: the slot is empty
  };

  static constexpr int kShift = 2;  ///< voxels per brick and axis: 2^kShift
  static constexpr int kWidth = 1 << kShift;

  static std::uint64_t pack(const Index& brick);
  /// The slot of a brick, or the empty one where it belongs.
  std::size_t slotOf(std::uint64_t brick) const;
  /// Bits of the voxels from low to high (within one brick, on one axis) in a row of 4 bits.
  static std::uint64_t row(int low, int high) { return ((2U << high) - 1U) & ~((1U << low) - 1U); }
  static std::uint64_t boxBits(const Index& low, const Index& high);

  std::vector<Slot> slots_;  ///< a power of two
};

template <typename Visitor>
void VoxelBricks::visitBox(const Index& low, const Index& high, const Visitor& visit) const {
  const auto brick_of = [](int index) { return index >> kShift; };  // rounds down
  const Index first = low.unaryExpr(brick_of);
  const Index last = high.unaryExpr(brick_of);
  for (Index brick = first; brick.z() <= last.z(); ++brick.z()) {
    for (brick.y() = first.y(); brick.y() <= last.y(); ++brick.y()) {
      for (brick.x() = first.x(); brick.x() <= last.x(); ++brick.x()) {
        std::uint64_t bits = slots_[slotOf(pack(brick))].bits;
        if (bits == 0) continue;
        const Index corner = kWidth * brick;
        bits &= boxBits((low - corner).cwiseMax(0), (high - corner).cwiseMin(kWidth - 1));
        for (; bits != 0; bits &= bits - 1) {
          const int bit = __builtin_ctzll(bits);
          visit(VoxelKey{static_cast<std::int16_t>(corner.x() + (bit & 3)),
                         static_cast<std::int16_t>(corner.y() + (bit >> 2 & 3)),
                         static_cast<std::int16_t>(corner.z() + (bit >> 4))});
        }
      }
    }
  }
}

}  // namespace smore
