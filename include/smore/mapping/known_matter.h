// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "smore/mapping/prior.h"
#include "smore/mapping/unit_of_length.h"

namespace smore {

/// A piece of prior knowledge, prepared to be asked in the frame in which a belief infers: that of
/// the object, or that of the map.
class KnownMatter {
 public:
  /// A place on the surface and the unit normal into the matter; zero where it is not known, as of
  /// a cloud of points or a sheet.
  struct SurfacePoint {
    Eigen::Vector3f place;
    Eigen::Vector3f inward;
  };

  /// `T_frame_grid`: where the voxels are. In `planar` motion what lies in the plane z = 0 counts.
  KnownMatter(MapSide side, const Prior& prior, const Pose& T_frame_grid, bool planar);

  MapSide side() const { return side_; }
  std::uint64_t id() const { return id_; }  ///< hash of the content
  double logOdds() const { return log_odds_; }
  double voxelSize() const { return known_.voxelSize(); }

  /// Whether there is matter at this place; nothing where it does not say.
  std::optional<bool> matterAt(const Eigen::Vector3f& place) const;

  bool hasMatter() const { return !matter_.empty(); }

  /// Distance of the farthest matter from the frame's origin [m]; nothing where no free space is
  /// known, so that there may be more.
  std::optional<float> reach() const;

  /// Where matter meets space that is known to be free; all matter where no free space is known.
  const std::vector<SurfacePoint>& surface() const { return surface_; }

  /// Centres of balls of `radius` [m] that stand for its matter: below its surface, and inside.
  /// Matter that is thinner than a ball is thickened to it.
  std::vector<Eigen::Vector3f> balls(float radius) const;

 private:
  void addSurface(const std::vector<VoxelKey>& matter);
  bool meetsFreeSpace(const VoxelKey& key) const;
  Vec3 inwardOf(const VoxelKey& key) const;

  MapSide side_;
  VoxelGrid known_;
  Pose T_frame_grid_;
  Pose T_grid_frame_;
  bool planar_;
  bool knows_free_space_ = false;
  std::uint64_t id_ = 0;
  double log_odds_ = 0.0;
  std::vector<SurfacePoint> surface_;
  std::vector<Eigen::Vector3f> matter_;  ///< centres of its voxels
};

/// Everything that is known beforehand of both sides.
using KnownPieces = std::vector<std::shared_ptr<const KnownMatter>>;

/// Levers that contacts all over the known surface of the object would have, square to it; none
/// where no normal of it is known.
std::vector<LeverOfContact> leversOfObject(const KnownPieces& known);

/// Probability from its odds' logarithm is 1 / (1 + exp(-it)); the inverse. `probability` above 0
/// and below 1.
double logOddsOf(double probability);

}  // namespace smore
