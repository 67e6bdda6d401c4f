// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/marginal_map.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "smore/mapping/mask_bricks.h"
#include "smore/mapping/sheet_voxels.h"

namespace smore {
namespace {

// Probabilities stay off 0 and 1 by less than what one of the 64 worlds counts.
constexpr double kLeastProbability = 0.005;

// The worlds in which voxels hold matter.
class MaskedVoxels {
 public:
  explicit MaskedVoxels(double voxel_size) : voxel_size_(voxel_size) {}

  // The voxel that holds the ball's centre, and each whose own centre the ball holds.
  void addBall(const Vec3& center, double radius, HypothesisMask mask) {
    constexpr double kVoxels = std::numeric_limits<std::int16_t>::max();
    if (center.cwiseAbs().maxCoeff() + radius >= kVoxels * voxel_size_) return;
    add(voxelAt(center, voxel_size_), mask);
    const VoxelKey low = voxelAt(center - Vec3::Constant(radius), voxel_size_);
    const VoxelKey high = voxelAt(center + Vec3::Constant(radius), voxel_size_);
    visitVoxels(low, high, [&](const VoxelKey& near) {
      if ((voxelCenter(near, voxel_size_) - center).norm() <= radius) add(near, mask);
    });
  }

  void addSheet(const SurfaceSheet& sheet, const Pose& T_grid_sheet, HypothesisMask mask) {
    visitSheet(sheet, T_grid_sheet, voxel_size_, [&](const VoxelKey& key) { add(key, mask); });
  }

  VoxelGrid shares() const {
    VoxelGrid grid(voxel_size_);
    for (const MaskBricks::Cell& lowest : masks_.bricks()) addShares(lowest, &grid);
    return grid;
  }

 private:
  void add(const VoxelKey& key, HypothesisMask mask) { masks_.mark(key.x, key.y, key.z, mask); }

  void addShares(const MaskBricks::Cell& lowest, VoxelGrid* grid) const {
    const auto visit = [&](const VoxelKey& key) {
      const HypothesisMask mask = masks_.at(key.x, key.y, key.z);
      if (mask == 0) return;
      const double share =
          std::clamp(SampledWorlds::shareOf(mask), kLeastProbability, 1.0 - kLeastProbability);
      grid->set(key, static_cast<float>(share));
    };
    constexpr int kLast = MaskBricks::kSide - 1;
    visitVoxels(keyOf(lowest), keyOf({lowest[0] + kLast, lowest[1] + kLast, lowest[2] + kLast}),
                visit);
  }

  static VoxelKey keyOf(const MaskBricks::Cell& cell) {
    return {static_cast<std::int16_t>(cell[0]), static_cast<std::int16_t>(cell[1]),
            static_cast<std::int16_t>(cell[2])};
  }

  double voxel_size_;
  MaskBricks masks_;
};

// A map of one side while it is made.
class MapInTheMaking {
 public:
  MapInTheMaking(const Pose& T_grid_matter, double voxel_size)
      : T_grid_matter_(T_grid_matter), voxels_(voxel_size) {}

  void add(const std::vector<MaskedPoint>& balls, double radius) {
    for (const MaskedPoint& ball : balls) {
      voxels_.addBall(T_grid_matter_ * ball.point.cast<double>(), radius, ball.mask);
    }
  }
  void add(const std::vector<KnownBalls>& pieces) {
    for (const KnownBalls& known : pieces) add(known.balls, known.radius);
  }
  void add(const SheetsByHypothesis& sheets) {
    for (int m = 0; m < kHypotheses; ++m) {
      for (const SurfaceSheet& sheet : sheets[m]) {
        voxels_.addSheet(sheet, T_grid_matter_, HypothesisMask{1} << m);
      }
    }
  }
  VoxelGrid made() const { return voxels_.shares(); }

 private:
  Pose T_grid_matter_;
  MaskedVoxels voxels_;
};

}  // namespace

VoxelGrid marginalMap(const Worlds& worlds, MapSide side, double voxel_size) {
  const bool of_object = side == MapSide::kObject;
  const Pose T_grid_matter = of_object ? Pose::Identity() : worlds.frame.T_map_world().inverse();
  MapInTheMaking map(T_grid_matter, voxel_size);
  for (const WorldsAtUnit& part : worlds.sampled.parts()) {
    if (of_object) {
      map.add(part.object(), part.radius());
      map.add(part.behindObject(), part.radius());
    } else if (part.planar()) {
      map.add(part.world(), part.radius());
    } else {
      map.add(part.worldSheets());
    }
    map.add(of_object ? part.knownObject() : part.knownWorld());
  }
  return map.made();
}

const VoxelGrid& MarginalMaps::of(const std::shared_ptr<const Worlds>& worlds, MapSide side) {
  const std::lock_guard<std::mutex> lock(*making_);
  Made& made = made_[side];
  if (made.of.lock() != worlds) made = {worlds, marginalMap(*worlds, side, voxel_size_)};
  return *made.map;
}

}  // namespace smore
