// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/marginal_map.h"

#include <algorithm>
#include <limits>

namespace smore {
namespace {

// Probabilities stay off 0 and 1 by less than what one of the 64 worlds counts.
constexpr double kLeastProbability = 0.005;

// The masks of voxels, beside the empty grid that will hold their shares.
class MaskedVoxels {
 public:
  explicit MaskedVoxels(VoxelGrid* grid) : grid_(grid) {}

  void add(const VoxelKey& key, HypothesisMask mask) {
    const auto known = grid_->find(key);
    const std::size_t position = known ? *known : grid_->set(key, 0.0F);
    if (!known) masks_.push_back(0);
    masks_[position] |= mask;
  }

  // The voxel that holds the ball's centre, and each whose own centre the ball holds.
  void addBall(const Vec3& center, double radius, HypothesisMask mask) {
    const double size = grid_->voxelSize();
    constexpr double kVoxels = std::numeric_limits<std::int16_t>::max();
    if (center.cwiseAbs().maxCoeff() + radius >= kVoxels * size) return;
    const VoxelKey key = voxelAt(center, size);
    add(key, mask);
    const VoxelKey low = voxelAt(center - Vec3::Constant(radius), size);
    const VoxelKey high = voxelAt(center + Vec3::Constant(radius), size);
    VoxelKey near;
    for (near.z = low.z; near.z <= high.z; ++near.z) {
      for (near.y = low.y; near.y <= high.y; ++near.y) {
        for (near.x = low.x; near.x <= high.x; ++near.x) {
          if ((voxelCenter(near, size) - center).norm() <= radius) add(near, mask);
        }
      }
    }
  }

  void store() {
    for (std::size_t i = 0; i < masks_.size(); ++i) {
      const double share =
          std::clamp(SampledWorlds::shareOf(masks_[i]), kLeastProbability, 1.0 - kLeastProbability);
      grid_->setAt(i, static_cast<float>(share));
    }
  }

 private:
  VoxelGrid* grid_;
  std::vector<HypothesisMask> masks_;
};

}  // namespace

VoxelGrid marginalMap(const Worlds& worlds, MapSide side, double voxel_size) {
  VoxelGrid grid(voxel_size);
  MaskedVoxels voxels(&grid);
  const bool of_object = side == MapSide::kObject;
  const Pose T_grid_matter = of_object ? Pose::Identity() : worlds.frame.T_map_world().inverse();
  const auto add = [&](const std::vector<MaskedPoint>& balls, double radius) {
    for (const MaskedPoint& ball : balls) {
      voxels.addBall(T_grid_matter * ball.point.cast<double>(), radius, ball.mask);
    }
  };
  for (const WorldsAtUnit& part : worlds.sampled.parts()) {
    add(of_object ? part.object() : part.world(), part.radius());
    if (of_object) add(part.behindObject(), part.radius());
    for (const KnownBalls& known : of_object ? part.knownObject() : part.knownWorld()) {
      add(known.balls, known.radius);
    }
  }
  voxels.store();
  return grid;
}

const VoxelGrid& MarginalMaps::of(const std::shared_ptr<const Worlds>& worlds, MapSide side) {
  const std::lock_guard<std::mutex> lock(*making_);
  Made& made = made_[side];
  if (made.of.lock() != worlds) made = {worlds, marginalMap(*worlds, side, voxel_size_)};
  return *made.map;
}

}  // namespace smore
