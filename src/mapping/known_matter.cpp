// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/known_matter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "smore/mapping/counter_random.h"
#include "smore/mapping/mask_grid.h"
#include "smore/mapping/octomap_export.h"
#include "smore/mapping/plane_in_grid.h"
#include "smore/mapping/point_index.h"

namespace smore {
namespace {

// Neighbours that a normal is taken from, in voxels: two on each side even out the steps.
constexpr int kNormalReach = 2;

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

std::uint64_t bitsOf(const VoxelKey& key) {
  const auto axis = [](std::int16_t index) {
    return std::uint64_t{static_cast<std::uint16_t>(index)};
  };
  return axis(key.x) | axis(key.y) << 16 | axis(key.z) << 32;
}

bool isMatter(const VoxelGrid::Voxel& voxel) { return voxel.probability >= kOccupied; }

}  // namespace

double logOddsOf(double probability) { return std::log(probability) - std::log1p(-probability); }

KnownMatter::KnownMatter(MapSide side, const Prior& prior, const Pose& T_frame_grid, bool planar)
    : side_(side),
      known_(prior.known),
      T_frame_grid_(T_frame_grid),
      T_grid_frame_(T_frame_grid.inverse()),
      planar_(planar),
      log_odds_(logOddsOf(prior.confidence)) {
  std::vector<VoxelGrid::Voxel> voxels = known_.voxels();
  std::sort(voxels.begin(), voxels.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  id_ = mixBits(static_cast<std::uint64_t>(side),
                mixBits(bitsOf(prior.confidence), bitsOf(known_.voxelSize())));
  const PlaneInGrid plane(T_frame_grid);
  std::vector<VoxelKey> matter;
  for (const VoxelGrid::Voxel& voxel : voxels) {
    id_ = mixBits(id_, bitsOf(voxel.key) << 1 | (isMatter(voxel) ? 1 : 0));
    if (!isMatter(voxel)) {
      knows_free_space_ = true;
    } else if (!planar_ ||
               plane.passes(voxelCenter(voxel.key, known_.voxelSize()), known_.voxelSize())) {
      matter.push_back(voxel.key);
    }
  }
  addSurface(matter);
}

void KnownMatter::addSurface(const std::vector<VoxelKey>& matter) {
  const double size = known_.voxelSize();
  for (const VoxelKey& key : matter) {
    Vec3 center = T_frame_grid_ * voxelCenter(key, size);
    if (planar_) center.z() = 0.0;
    matter_.push_back(center.cast<float>());
    if (knows_free_space_ && !meetsFreeSpace(key)) continue;
    const Vec3 inward = inwardOf(key);
    surface_.push_back({(center - 0.5 * size * inward).cast<float>(), inward.cast<float>()});
  }
}

bool KnownMatter::meetsFreeSpace(const VoxelKey& key) const {
  constexpr std::array<std::array<int, 3>, 6> kFaces = {
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  return std::any_of(kFaces.begin(), kFaces.end(), [&](const std::array<int, 3>& face) {
    const auto next = neighbourOf(key, face[0], face[1], face[2]);
    const auto probability = next ? known_.probability(*next) : std::nullopt;
    return probability && *probability < kOccupied;
  });
}

Vec3 KnownMatter::inwardOf(const VoxelKey& key) const {
  if (!knows_free_space_) return Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (int dx = -kNormalReach; dx <= kNormalReach; ++dx) {
    for (int dy = -kNormalReach; dy <= kNormalReach; ++dy) {
      for (int dz = -kNormalReach; dz <= kNormalReach; ++dz) {
        const auto next = neighbourOf(key, dx, dy, dz);
        const auto probability = next ? known_.probability(*next) : std::nullopt;
        if (probability) sum += (*probability >= kOccupied ? 1.0 : -1.0) * Vec3(dx, dy, dz);
      }
    }
  }
  sum = T_frame_grid_.linear() * sum;
  if (planar_) sum.z() = 0.0;
  return sum.norm() < 1.0 ? Vec3::Zero() : Vec3(sum.normalized());
}

std::optional<bool> KnownMatter::matterAt(const Eigen::Vector3f& place) const {
  const Vec3 in_grid = T_grid_frame_ * Vec3(place.cast<double>());
  const double end = std::numeric_limits<std::int16_t>::max() * known_.voxelSize();
  if (!(in_grid.cwiseAbs().maxCoeff() < end)) return std::nullopt;
  const auto probability = known_.probability(voxelAt(in_grid, known_.voxelSize()));
  if (!probability) return std::nullopt;
  return *probability >= kOccupied;
}

std::optional<float> KnownMatter::reach() const {
  if (!knows_free_space_ || matter_.empty()) return std::nullopt;
  float farthest = 0.0F;
  for (const Eigen::Vector3f& place : matter_) farthest = std::max(farthest, place.norm());
  return farthest;
}

std::vector<Eigen::Vector3f> KnownMatter::balls(float radius) const {
  std::vector<Eigen::Vector3f> places;
  std::vector<Eigen::Vector3f> result;
  for (const SurfacePoint& point : surface_) {
    places.push_back(point.place);
    result.push_back(point.place + radius * point.inward);
  }
  PointIndex near_surface(radius);
  near_surface.build(places);
  MaskedPoints inside(radius);
  for (const Eigen::Vector3f& place : matter_) {
    bool deep = true;
    near_surface.forNear(place, [&deep](int /*point*/) { deep = false; });
    if (deep) inside.add(place, 1);
  }
  for (const MaskedPoint& ball : inside.points()) result.push_back(ball.point);
  return result;
}

std::vector<LeverOfContact> leversOfObject(const KnownPieces& known) {
  std::vector<LeverOfContact> levers;
  for (const auto& piece : known) {
    if (piece->side() != MapSide::kObject) continue;
    for (const KnownMatter::SurfacePoint& point : piece->surface()) {
      if (point.inward.isZero()) continue;  // of a cloud: which way a contact would push is unknown
      const Eigen::Vector3f across = point.place - point.place.dot(point.inward) * point.inward;
      levers.push_back({across.norm(), 0.0, Vec3::Zero()});
    }
  }
  return levers;
}

}  // namespace smore
