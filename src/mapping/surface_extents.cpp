// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_extents.h"

#include <cmath>

#include "smore/mapping/counter_random.h"

namespace smore {
namespace {

constexpr int kSpatialRays = 6;
constexpr double kPi = 3.14159265358979323846;

// Points are merged and looked up on lattices that are fine against the balls.
float latticeCell(const FeatureParameters& feature) {
  return static_cast<float>(feature.conflictDistance()) / 3.0F;
}

}  // namespace

SurfaceExtents::SurfaceExtents(const WorldSamples& samples, const FeatureParameters& feature,
                               const ExtentParameters& extent, bool planar, std::uint64_t seed)
    : samples_(samples),
      feature_(feature),
      extent_(extent),
      planar_(planar),
      seed_(seed),
      object_(latticeCell(feature)),
      world_(latticeCell(feature)) {
  addTouches();
  growAll(Side::kObject);
  growAll(Side::kWorld);
}

void SurfaceExtents::addTouches() {
  for (int m = 0; m < kHypotheses; ++m) {
    const HypothesisMask bit = HypothesisMask{1} << m;
    for (std::size_t k = 0; k < samples_.contacts.size(); ++k) {
      const int place = samples_.explanations[m][k];
      if (place == kFalseContact) continue;
      object_.add(samples_.contacts[k].object.at(place), bit);
      world_.add(samples_.contacts[k].world.at(place), bit);
    }
  }
}

void SurfaceExtents::growAll(Side side) {
  const auto radius = static_cast<float>(feature_.conflictDistance());
  opposite_ = MaskGrid(side == Side::kObject ? world_.points() : object_.points(), radius,
                       latticeCell(feature_));
  known_.clear();
  poses_.clear();
  for (const Eigen::Isometry3f& T : samples_.evidence.poses()) {
    poses_.push_back(side == Side::kObject ? T : T.inverse());
  }
  for (std::size_t k = 0; k < samples_.contacts.size(); ++k) {
    for (int m = 0; m < kHypotheses; ++m) grow(side, static_cast<int>(k), m);
  }
}

void SurfaceExtents::grow(Side side, int contact, int hypothesis) {
  const int place = samples_.explanations[hypothesis][contact];
  if (place == kFalseContact) return;
  const ContactHypotheses& touched = samples_.contacts[contact];
  const bool on_object = side == Side::kObject;
  const Eigen::Vector3f start = (on_object ? touched.object : touched.world).at(place);
  const double length = on_object ? extent_.object_length : extent_.world_length;
  const auto step = static_cast<float>(0.5 * feature_.conflictDistance());
  const double go_on = std::exp(-step / length);
  const std::uint64_t seed =
      mixBits(touched.id, mixBits(seed_, 2 * hypothesis + (on_object ? 1 : 0)));
  const HypothesisMask bit = HypothesisMask{1} << hypothesis;
  CounterRandom random(~seed);
  for (const Eigen::Vector3f& tangent :
       tangents((on_object ? touched.object_normal : touched.world_normal).at(place), seed)) {
    Eigen::Vector3f point = start;
    while (random.uniform() < go_on) {
      point += step * tangent;
      if (on_object && point.norm() > feature_.reach) break;
      if ((contradictions(point) & bit) != 0) break;
      (on_object ? object_ : world_).add(point, bit);
    }
  }
}

std::vector<Eigen::Vector3f> SurfaceExtents::tangents(const Eigen::Vector3f& normal,
                                                      std::uint64_t seed) const {
  if (planar_) {
    const Eigen::Vector3f tangent(-normal.y(), normal.x(), 0.0F);
    return {tangent, -tangent};
  }
  const Eigen::Vector3f first = normal.unitOrthogonal();
  const Eigen::Vector3f second = normal.cross(first);
  const double turn = 2.0 * kPi * CounterRandom(seed).uniform();
  std::vector<Eigen::Vector3f> result;
  for (int ray = 0; ray < kSpatialRays; ++ray) {
    const auto angle = static_cast<float>(turn + 2.0 * kPi * ray / kSpatialRays);
    result.emplace_back(std::cos(angle) * first + std::sin(angle) * second);
  }
  return result;
}

HypothesisMask SurfaceExtents::contradictions(const Eigen::Vector3f& point) {
  const float cell = latticeCell(feature_);
  const auto found = known_.emplace(MaskedPoints::cellKey(point, cell), 0);
  HypothesisMask& mask = found.first->second;
  if (!found.second) return mask;
  const Eigen::Vector3f center = (point / cell).array().round().matrix() * cell;
  for (const Eigen::Isometry3f& T : poses_) {
    mask |= opposite_.at(T * center);
    if (mask == ~HypothesisMask{0}) break;
  }
  return mask;
}

}  // namespace smore
