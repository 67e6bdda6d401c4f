// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Index of a voxel: it spans [i, i + 1) voxel sizes on each axis. The range is OctoMap's, so that
/// each key is also a key of an octree of the same resolution.
struct VoxelKey {
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t z = 0;

  bool operator==(const VoxelKey& other) const {
    return x == other.x && y == other.y && z == other.z;
  }
  bool operator!=(const VoxelKey& other) const { return !(*this == other); }
  /// Lexicographic, for ties and canonical orders.
  bool operator<(const VoxelKey& other) const;
};

/// The voxel that holds `point` [m]; points on a face belong to the voxel above. std::out_of_range
/// for points outside of the key range or not finite.
VoxelKey voxelAt(const Vec3& point, double voxel_size);

/// Centre of a voxel [m].
Vec3 voxelCenter(const VoxelKey& key, double voxel_size);

/// The key so far from `key` on each axis; nothing beyond the range of keys.
std::optional<VoxelKey> neighbourOf(const VoxelKey& key, int dx, int dy, int dz);

using VoxelVisitor = std::function<void(const VoxelKey& key)>;

/// Visits the voxels of the box between two of them, both included, row by row along x.
void visitVoxels(const VoxelKey& first, const VoxelKey& last, const VoxelVisitor& visitor);

/// Sparse grid of occupancy probabilities. A voxel that is not stored is unknown.
///
/// Voxels stand in one array in the order of their insertion (iteration is a scan and does not
/// depend on hashing), found by an open-addressing index: at most 28 bytes a voxel.
class VoxelGrid {
 public:
  struct Voxel {
    VoxelKey key;
    float probability = 0.0F;
  };

  /// `voxel_size` [m], positive.
  explicit VoxelGrid(double voxel_size);

  double voxelSize() const { return voxel_size_; }
  std::size_t size() const { return voxels_.size(); }
  bool empty() const { return voxels_.empty(); }

  /// All stored voxels in the order of their insertion.
  const std::vector<Voxel>& voxels() const { return voxels_; }

  /// Position of a voxel in `voxels()`, or nothing where it is unknown.
  std::optional<std::size_t> find(const VoxelKey& key) const;

  /// Probability of a voxel, or nothing where it is unknown.
  std::optional<float> probability(const VoxelKey& key) const;

  /// Stores `probability` in [0, 1], over an earlier value; returns the position in `voxels()`.
  std::size_t set(const VoxelKey& key, float probability);

  /// Changes the value of the voxel at `position` in `voxels()`.
  void setAt(std::size_t position, float probability) {
    voxels_[position].probability = probability;
  }

 private:
  std::size_t slotOf(const VoxelKey& key) const;
  void rebuildIndex(std::size_t slots);

  double voxel_size_;
  std::vector<Voxel> voxels_;
  std::vector<std::uint32_t> index_;  ///< position in voxels_ plus one; 0 is an empty slot
};

}  // namespace smore
