// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_extents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "smore/common/parallel_for.h"
#include "smore/mapping/counter_random.h"
#include "smore/mapping/filled_balls.h"
#include "smore/mapping/joined_touches.h"

namespace smore {
namespace {

// Points of a patch lie this share of the distance apart at which two balls touch: nothing passes
// between them.
constexpr double kPlanarStep = 0.5;
constexpr double kSpatialStep = 0.8;

// Cells of the lattice of points from one to the next in the balls behind the object's touches:
// with two, balls of matter around them leave nothing out.
constexpr float kFilledCells = 2.0F;

// Of a force from the normal, about each of two axes [rad]: 0.29 rad, the edge of the cone of
// friction with a coefficient of .3, in any direction. The coefficient is our choice.
constexpr float kFrictionTilt = 0.2F;

// Points are merged and looked up on lattices that are fine against the balls.
float latticeCell(const FeatureParameters& feature) {
  return static_cast<float>(feature.conflictDistance()) / 3.0F;
}

// Spread evenly over all orders of magnitude between the two.
double sizeOf(int hypothesis, double shortest, double longest) {
  return shortest * std::pow(longest / shortest, (hypothesis + 0.5) / kHypotheses);
}

// The object's size, its depth and the world's size are drawn independently: further orders of the
// hypotheses.
int secondOrder(int hypothesis) { return (37 * hypothesis + 11) % kHypotheses; }
int thirdOrder(int hypothesis) { return (23 * hypothesis + 5) % kHypotheses; }

// As deep as the matter straight behind the touch.
TouchedBall ballBehind(const SurfacePatch& patch, HypothesisMask mask) {
  const float radius = 0.5F * static_cast<float>(patch.depth) * patch.step;
  return {patch.center, patch.center - radius * patch.normal, radius, mask};
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
  grow(MapSide::kObject);
  grow(MapSide::kWorld);
}

void SurfaceExtents::addTouches() {
  for (int m = 0; m < kHypotheses; ++m) {
    const HypothesisMask bit = HypothesisMask{1} << m;
    for (const Touch& touch : touches(MapSide::kObject, m)) {
      object_.add(touch.contact->object.at(touch.place), bit);
    }
    for (const Touch& touch : touches(MapSide::kWorld, m)) {
      world_.add(touch.contact->world.at(touch.place), bit);
    }
  }
}

std::vector<SurfaceExtents::Touch> SurfaceExtents::touches(MapSide side, int hypothesis) const {
  std::vector<Touch> result;
  for (std::size_t k = 0; k < samples_.contacts.size(); ++k) {
    const int place = samples_.explanations[hypothesis][k];
    if (place == kFalseContact) continue;
    const PriorMask covering = samples_.prior.evidence.covering(side, static_cast<int>(k), place);
    const bool is_known = (samples_.prior.worldsOf(covering) >> hypothesis & 1U) != 0;
    if (!is_known) result.push_back({&samples_.contacts[k], place});
  }
  return result;
}

// Each hypothesis by itself, on all processor cores; what comes out does not depend on how many
// there are.
void SurfaceExtents::grow(MapSide side) {
  const std::vector<ForbiddenMatter> forbidden = forbiddenFor(side);
  std::array<std::vector<Eigen::Vector3f>, kHypotheses> grown;
  TouchedByHypothesis touched;
  parallelFor(kHypotheses, [&](std::size_t i) {
    const int m = static_cast<int>(i);
    const MatterAllowed allowed = allowedFor(side, m, forbidden, Known::kIsNotTouched);
    const MatterAllowed behind = allowedFor(side, m, forbidden, Known::kMatterGoesOn);
    touched[m] = touchedPatches(side, m, behind);
    grown[m] = patches(side, m, touched[m], allowed);
    if (side == MapSide::kObject) {
      const std::vector<Eigen::Vector3f> joints = joined(m, allowed);
      grown[m].insert(grown[m].end(), joints.begin(), joints.end());
    }
  });
  MaskedPoints& matter = side == MapSide::kObject ? object_ : world_;
  for (int m = 0; m < kHypotheses; ++m) {
    for (const Eigen::Vector3f& point : grown[m]) matter.add(point, HypothesisMask{1} << m);
  }
  if (side == MapSide::kObject && !planar_) fillBehind(touched, forbidden);
}

void SurfaceExtents::fillBehind(const TouchedByHypothesis& touched,
                                const std::vector<ForbiddenMatter>& forbidden) {
  std::vector<TouchedBall> balls;
  for (int m = 0; m < kHypotheses; ++m) {
    for (const TouchedPatch& at : touched[m]) {
      balls.push_back(ballBehind(at.patch, HypothesisMask{1} << m));
    }
  }
  const float step = kFilledCells * latticeCell(feature_);
  behind_object_ = fillBalls(balls, step, [&](const Eigen::Vector3f& point, HypothesisMask asked) {
    return forbiddenAt(MapSide::kObject, point, asked, forbidden, Known::kIsNotTouched);
  });
}

// By touched matter of the other side, and by what is known of it beforehand.
std::vector<ForbiddenMatter> SurfaceExtents::forbiddenFor(MapSide side) const {
  const bool on_object = side == MapSide::kObject;
  std::vector<Eigen::Isometry3f> poses = samples_.evidence.poses();
  if (on_object) {
    for (Eigen::Isometry3f& T : poses) T = T.inverse();
  }
  const auto distance = static_cast<float>(feature_.conflictDistance());
  const float cell = latticeCell(feature_);
  std::vector<ForbiddenMatter> forbidden;
  forbidden.emplace_back(on_object ? world_.points() : object_.points(), poses, distance, cell,
                         planar_);
  const MapSide other = on_object ? MapSide::kWorld : MapSide::kObject;
  for (const KnownBalls& known : samples_.prior.balls(other)) {
    forbidden.emplace_back(known.balls, poses, known.overlapDistance(feature_.radius), cell,
                           planar_);
  }
  return forbidden;
}

HypothesisMask SurfaceExtents::forbiddenAt(MapSide side, const Eigen::Vector3f& point,
                                           HypothesisMask asked,
                                           const std::vector<ForbiddenMatter>& forbidden,
                                           Known known) const {
  const auto reach = static_cast<float>(feature_.reach);
  if (side == MapSide::kObject && point.norm() > reach) return asked;
  HypothesisMask result = known == Known::kMatterGoesOn ? samples_.prior.knowingFree(side, point)
                                                        : samples_.prior.knowing(side, point);
  for (const ForbiddenMatter& matter : forbidden) {
    if ((asked & ~result) == 0) break;
    result |= matter.at(point);
  }
  return result & asked;
}

MatterAllowed SurfaceExtents::allowedFor(MapSide side, int hypothesis,
                                         const std::vector<ForbiddenMatter>& forbidden,
                                         Known known) const {
  const HypothesisMask bit = HypothesisMask{1} << hypothesis;
  return [this, &forbidden, known, side, bit](const Eigen::Vector3f& point) {
    return forbiddenAt(side, point, bit, forbidden, known) == 0;
  };
}

bool SurfaceExtents::goesOnAlong(MapSide side) const { return planar_ || side == MapSide::kWorld; }

double SurfaceExtents::longestRadius(MapSide side) const {
  return side == MapSide::kObject ? extent_.object_longest : extent_.world_longest;
}

double SurfaceExtents::radiusOf(MapSide side, int hypothesis) const {
  const int order = side == MapSide::kObject ? secondOrder(hypothesis) : hypothesis;
  return sizeOf(order, extent_.shortest, longestRadius(side));
}

double SurfaceExtents::stepOf() const {
  return (planar_ ? kPlanarStep : kSpatialStep) * feature_.conflictDistance();
}

std::vector<TouchedPoint> SurfaceExtents::touchedPoints(MapSide side,
                                                        const std::vector<Touch>& touches) const {
  const bool on_object = side == MapSide::kObject;
  std::vector<TouchedPoint> points;
  points.reserve(touches.size());
  for (const Touch& touch : touches) {
    const ContactHypotheses& contact = *touch.contact;
    // The common normal of a contact points into the object.
    points.push_back({(on_object ? contact.object : contact.world).at(touch.place),
                      on_object ? Eigen::Vector3f(-contact.object_normal.at(touch.place))
                                : contact.world_normal.at(touch.place)});
  }
  return points;
}

// In space the world's surfaces lie as touches on the same surface say, but not the object's, which
// is touched at corners there. In planar motion it has not been tried.
std::vector<SurfaceExtents::TouchedPatch> SurfaceExtents::touchedPatches(
    MapSide side, int hypothesis, const MatterAllowed& behind) const {
  const std::vector<Touch> those = touches(side, hypothesis);
  const std::vector<TouchedPoint> points = touchedPoints(side, those);
  const bool turns = !planar_ && side == MapSide::kWorld;
  const auto height = static_cast<float>(2.0 * feature_.tolerance);
  const SurfaceSpread spread{kFrictionTilt, height, static_cast<float>(feature_.reach)};
  const std::vector<Eigen::Vector3f> turned =
      turns ? surfaceNormals(points, spread) : std::vector<Eigen::Vector3f>{};
  SurfacePatch patch;
  patch.step = static_cast<float>(stepOf());
  patch.radius = goesOnAlong(side) ? static_cast<float>(radiusOf(side, hypothesis)) : 0.0F;
  std::vector<TouchedPatch> result;
  result.reserve(those.size());
  for (std::size_t k = 0; k < those.size(); ++k) {
    patch.center = points[k].point;
    patch.normal = turns ? turned[k] : points[k].normal;
    result.push_back({those[k].contact->id, patch});
  }
  const int depth = side == MapSide::kObject ? objectDepth(hypothesis, result, behind) : 0;
  for (TouchedPatch& at : result) at.patch.depth = depth;
  return result;
}

int SurfaceExtents::objectDepth(int hypothesis, const std::vector<TouchedPatch>& touched,
                                const MatterAllowed& behind) const {
  const double drawn = sizeOf(thirdOrder(hypothesis), extent_.shortest, extent_.object_longest);
  auto depth = static_cast<int>(drawn / stepOf());
  for (TouchedPatch at : touched) {
    at.patch.depth = depth;
    depth = depthBehind(at.patch, behind);
  }
  return depth;
}

std::vector<Eigen::Vector3f> SurfaceExtents::patches(MapSide side, int hypothesis,
                                                     const std::vector<TouchedPatch>& touched,
                                                     const MatterAllowed& allowed) const {
  const bool on_object = side == MapSide::kObject;
  std::vector<Eigen::Vector3f> result;
  for (const TouchedPatch& at : touched) {
    CounterRandom random(mixBits(at.id, mixBits(seed_, 2 * hypothesis + (on_object ? 1 : 0))));
    const std::vector<Eigen::Vector3f> points = growPatch(at.patch, planar_, allowed, &random);
    result.insert(result.end(), points.begin(), points.end());
  }
  return result;
}

std::vector<Eigen::Vector3f> SurfaceExtents::joined(int hypothesis,
                                                    const MatterAllowed& allowed) const {
  // By their ids, so that the order of the observations does not matter.
  std::map<std::uint64_t, Eigen::Vector3f> by_id;
  for (const Touch& touch : touches(MapSide::kObject, hypothesis)) {
    by_id.emplace(touch.contact->id, touch.contact->object.at(touch.place));
  }
  std::vector<Eigen::Vector3f> places;
  places.reserve(by_id.size());
  for (const auto& entry : by_id) places.push_back(entry.second);
  // As far as two patches of the object reach towards each other.
  const auto longest_closing = static_cast<float>(2.0 * radiusOf(MapSide::kObject, hypothesis));
  return joinTouches(places, static_cast<float>(feature_.conflictDistance()), longest_closing,
                     allowed);
}

}  // namespace smore
