// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/voxel_grid.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace smore {
namespace {

constexpr std::size_t kInitialSlots = 64;  // a power of two, as every index size

std::int16_t indexAt(double coordinate, double voxel_size) {
  const double index = std::floor(coordinate / voxel_size);
  if (!(index >= std::numeric_limits<std::int16_t>::min() &&
        index <= std::numeric_limits<std::int16_t>::max())) {
    throw std::out_of_range("no voxel of size " + std::to_string(voxel_size) + " m at coordinate " +
                            std::to_string(coordinate) + " m");
  }
  return static_cast<std::int16_t>(index);
}

std::uint64_t hash(const VoxelKey& key) {
  const std::uint64_t packed = static_cast<std::uint64_t>(static_cast<std::uint16_t>(key.x)) |
                               static_cast<std::uint64_t>(static_cast<std::uint16_t>(key.y)) << 16 |
                               static_cast<std::uint64_t>(static_cast<std::uint16_t>(key.z)) << 32;
  // Fibonacci hashing: the odd constant is 2^64 over the golden ratio; the high bits are well
  // mixed.
  return (packed * 0x9E3779B97F4A7C15ULL) >> 20;
}

}  // namespace

bool VoxelKey::operator<(const VoxelKey& other) const {
  return std::tie(x, y, z) < std::tie(other.x, other.y, other.z);
}

VoxelKey voxelAt(const Vec3& point, double voxel_size) {
  return {indexAt(point.x(), voxel_size), indexAt(point.y(), voxel_size),
          indexAt(point.z(), voxel_size)};
}

Vec3 voxelCenter(const VoxelKey& key, double voxel_size) {
  return voxel_size * Vec3(key.x + 0.5, key.y + 0.5, key.z + 0.5);
}

void visitVoxels(const VoxelKey& first, const VoxelKey& last, const VoxelVisitor& visitor) {
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        visitor({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                 static_cast<std::int16_t>(z)});
      }
    }
  }
}

std::optional<VoxelKey> neighbourOf(const VoxelKey& key, int dx, int dy, int dz) {
  constexpr int kMin = std::numeric_limits<std::int16_t>::min();
  constexpr int kMax = std::numeric_limits<std::int16_t>::max();
  const std::array<int, 3> at = {key.x + dx, key.y + dy, key.z + dz};
  for (const int index : at) {
    if (index < kMin || index > kMax) return std::nullopt;
  }
  return VoxelKey{static_cast<std::int16_t>(at[0]), static_cast<std::int16_t>(at[1]),
                  static_cast<std::int16_t>(at[2])};
}

VoxelGrid::VoxelGrid(double voxel_size) : voxel_size_(voxel_size), index_(kInitialSlots, 0) {
  if (!(voxel_size > 0.0) || !std::isfinite(voxel_size)) {
    throw std::invalid_argument("voxel size must be positive, got " + std::to_string(voxel_size));
  }
}

std::size_t VoxelGrid::slotOf(const VoxelKey& key) const {
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = hash(key) & mask;
  while (index_[slot] != 0 && voxels_[index_[slot] - 1].key != key) slot = (slot + 1) & mask;
  return slot;
}

std::optional<std::size_t> VoxelGrid::find(const VoxelKey& key) const {
  const std::uint32_t entry = index_[slotOf(key)];
  if (entry == 0) return std::nullopt;
  return entry - 1;
}

std::optional<float> VoxelGrid::probability(const VoxelKey& key) const {
  const auto position = find(key);
  if (!position) return std::nullopt;
  return voxels_[*position].probability;
}

std::size_t VoxelGrid::set(const VoxelKey& key, float probability) {
  if (const auto position = find(key)) {
    voxels_[*position].probability = probability;
    return *position;
  }
  if (2 * (voxels_.size() + 1) > index_.size()) rebuildIndex(2 * index_.size());
  voxels_.push_back({key, probability});
  index_[slotOf(key)] = static_cast<std::uint32_t>(voxels_.size());
  return voxels_.size() - 1;
}

void VoxelGrid::rebuildIndex(std::size_t slots) {
  index_.assign(slots, 0);
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    index_[slotOf(voxels_[i].key)] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace smore
