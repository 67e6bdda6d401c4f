// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_extents.h"

#include <cmath>
#include <map>

#include "smore/mapping/counter_random.h"
#include "smore/mapping/joined_touches.h"

namespace smore {
namespace {

// Points of a patch lie this share of the distance apart at which two balls touch: nothing passes
// between them.
constexpr double kPlanarStep = 0.5;
constexpr double kSpatialStep = 0.8;

// Points are merged and looked up on lattices that are fine against the balls.
float latticeCell(const FeatureParameters& feature) {
  return static_cast<float>(feature.conflictDistance()) / 3.0F;
}

// The object's size and the world's are drawn independently: a second order of the hypotheses.
int otherOrder(int hypothesis) { return (37 * hypothesis + 11) % kHypotheses; }

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
  growObject();
  growWorld();
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

void SurfaceExtents::growObject() {
  ForbiddenMatter forbidden = forbiddenFor(Side::kObject);
  growPatches(Side::kObject, &forbidden);
  if (planar_) return;
  for (int m = 0; m < kHypotheses; ++m) joinObject(m, &forbidden);
}

void SurfaceExtents::growWorld() {
  ForbiddenMatter forbidden = forbiddenFor(Side::kWorld);
  growPatches(Side::kWorld, &forbidden);
}

ForbiddenMatter SurfaceExtents::forbiddenFor(Side side) const {
  const bool on_object = side == Side::kObject;
  std::vector<Eigen::Isometry3f> poses;
  poses.reserve(samples_.evidence.poses().size());
  for (const Eigen::Isometry3f& T : samples_.evidence.poses()) {
    poses.push_back(on_object ? T : T.inverse());
  }
  return {on_object ? world_.points() : object_.points(), std::move(poses),
          static_cast<float>(feature_.conflictDistance()), latticeCell(feature_)};
}

MatterAllowed SurfaceExtents::allowedFor(Side side, int hypothesis,
                                         ForbiddenMatter* forbidden) const {
  const HypothesisMask bit = HypothesisMask{1} << hypothesis;
  const bool on_object = side == Side::kObject;
  const auto reach = static_cast<float>(feature_.reach);
  return [=](const Eigen::Vector3f& point) {
    return (!on_object || point.norm() <= reach) && (forbidden->at(point) & bit) == 0;
  };
}

double SurfaceExtents::patchRadius(Side side, int hypothesis) const {
  const bool on_object = side == Side::kObject;
  const double longest = !on_object ? extent_.world_longest
                                    : (planar_ ? extent_.object_longest : extent_.corner_longest);
  const double place = (on_object ? otherOrder(hypothesis) : hypothesis) + 0.5;
  return extent_.shortest * std::pow(longest / extent_.shortest, place / kHypotheses);
}

void SurfaceExtents::growPatches(Side side, ForbiddenMatter* forbidden) {
  const bool on_object = side == Side::kObject;
  MaskedPoints& matter = on_object ? object_ : world_;
  SurfacePatch patch;
  patch.step =
      static_cast<float>((planar_ ? kPlanarStep : kSpatialStep) * feature_.conflictDistance());
  for (int m = 0; m < kHypotheses; ++m) {
    const MatterAllowed allowed = allowedFor(side, m, forbidden);
    patch.radius = static_cast<float>(patchRadius(side, m));
    for (std::size_t k = 0; k < samples_.contacts.size(); ++k) {
      const ContactHypotheses& contact = samples_.contacts[k];
      const int place = samples_.explanations[m][k];
      if (place == kFalseContact) continue;
      patch.center = (on_object ? contact.object : contact.world).at(place);
      patch.normal = (on_object ? contact.object_normal : contact.world_normal).at(place);
      CounterRandom random(mixBits(contact.id, mixBits(seed_, 2 * m + (on_object ? 1 : 0))));
      for (const Eigen::Vector3f& point : growPatch(patch, planar_, allowed, &random)) {
        matter.add(point, HypothesisMask{1} << m);
      }
    }
  }
}

void SurfaceExtents::joinObject(int hypothesis, ForbiddenMatter* forbidden) {
  // By their ids, so that the order of the observations does not matter.
  std::map<std::uint64_t, Eigen::Vector3f> by_id;
  for (std::size_t k = 0; k < samples_.contacts.size(); ++k) {
    const int place = samples_.explanations[hypothesis][k];
    if (place == kFalseContact) continue;
    by_id.emplace(samples_.contacts[k].id, samples_.contacts[k].object.at(place));
  }
  std::vector<Eigen::Vector3f> places;
  places.reserve(by_id.size());
  for (const auto& entry : by_id) places.push_back(entry.second);
  CounterRandom random(mixBits(~seed_, hypothesis));
  const auto distance = static_cast<float>(feature_.conflictDistance());
  for (const Eigen::Vector3f& point :
       joinTouches(places, distance, allowedFor(Side::kObject, hypothesis, forbidden), &random)) {
    object_.add(point, HypothesisMask{1} << hypothesis);
  }
}

}  // namespace smore
