// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/prior_evidence.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "smore/mapping/forbidden_matter.h"
#include "smore/mapping/point_index.h"

namespace smore {
namespace {

// A touch so many scales from the surface is not on it ...
constexpr float kSurfaceEnd = 2.0F;
// ... and nearer than so many it adds nothing to it.
constexpr float kOnSurface = 0.5F;

float kernel(float distance, float scale) {
  const float ratio = distance / scale;
  const float falling = 1.0F / (1.0F + ratio * ratio);
  return falling * falling;
}

/// The surface of a piece, asked for how well it explains touches.
class KnownSurface {
 public:
  KnownSurface(const std::vector<KnownMatter::SurfacePoint>& surface, float scale)
      : surface_(surface), scale_(scale), index_(kSurfaceEnd * scale) {
    std::vector<Eigen::Vector3f> places;
    places.reserve(surface.size());
    for (const KnownMatter::SurfacePoint& point : surface) places.push_back(point.place);
    index_.build(places);
  }

  /// From 0 to 1, for a touch at `place` with the normal `inward`: less for a surface that stands
  /// obliquely to it. Edges are touched with any normal between those of their faces.
  float explains(const Eigen::Vector3f& place, const Eigen::Vector3f& inward) const {
    float best = 0.0F;
    index_.forNear(place, [&](int i) {
      const KnownMatter::SurfacePoint& point = surface_[i];
      const bool directed = point.inward.squaredNorm() > 0.0F;
      const float facing = directed ? std::max(0.0F, point.inward.dot(inward)) : 1.0F;
      best = std::max(best, facing * kernel((point.place - place).norm(), scale_));
    });
    return best;
  }

 private:
  const std::vector<KnownMatter::SurfacePoint>& surface_;
  float scale_;
  PointIndex index_;
};

struct Touch {
  Eigen::Vector3f place;
  Eigen::Vector3f inward;  // into the touched matter
};

Touch touchOf(MapSide side, const ContactHypotheses& contact, int i, float radius) {
  const bool on_object = side == MapSide::kObject;
  const Eigen::Vector3f inward =
      on_object ? contact.object_normal.at(i) : Eigen::Vector3f(-contact.world_normal.at(i));
  return {(on_object ? contact.object : contact.world).at(i) - radius * inward, inward};
}

MapSide otherSide(MapSide side) {
  return side == MapSide::kObject ? MapSide::kWorld : MapSide::kObject;
}

// From the frame of one side to that of the other.
std::vector<Eigen::Isometry3f> posesTo(MapSide side, const FreeSpaceEvidence& free) {
  std::vector<Eigen::Isometry3f> poses = free.poses();
  if (side == MapSide::kWorld) return poses;
  for (Eigen::Isometry3f& T : poses) T = T.inverse();
  return poses;
}

template <typename Visit>
void forEachBit(PriorMask mask, Visit visit) {
  for (int piece = 0; mask != 0; ++piece, mask >>= 1) {
    if ((mask & 1U) != 0) visit(piece);
  }
}

// Where a piece of the object and one of the world overlapped: [of the object][of the world].
using OverlapCells = std::vector<std::vector<std::set<std::uint64_t>>>;

// Matter must overlap by the tolerances of both sides: poses are known to a cell. Where balls are
// hardly thicker than that, three quarters of them must.
void addOverlaps(const KnownBalls& object, const KnownBalls& world, const FreeSpaceEvidence& free,
                 float cell, bool planar, OverlapCells* cells) {
  const double touching = object.radius + world.radius;
  const auto distance =
      static_cast<float>(std::max(touching - object.tolerance - world.tolerance, 0.25 * touching));
  const ForbiddenMatter forbidden(world.balls, posesTo(MapSide::kObject, free), distance,
                                  distance / 3.0F, planar);
  for (const MaskedPoint& ball : object.balls) {
    const PriorMask in_world = forbidden.at(ball.point);
    forEachBit(ball.mask, [&](int p) {
      forEachBit(in_world,
                 [&](int q) { (*cells)[p][q].insert(MaskedPoints::cellKey(ball.point, cell)); });
    });
  }
}

}  // namespace

PriorEvidence::PriorEvidence(const KnownPieces& known,
                             const std::vector<ContactHypotheses>& contacts,
                             const FreeSpaceEvidence& free, const PriorParameters& parameters,
                             const FeatureParameters& feature, bool planar)
    : known_(known),
      touched_radius_(feature.radius),
      object_(ballsOf(MapSide::kObject, feature, planar)),
      world_(ballsOf(MapSide::kWorld, feature, planar)) {
  if (known.empty()) return;
  sayings_.assign(known_.size(), std::vector<Saying>(contacts.size()));
  for (int piece = 0; piece < count(); ++piece) compare(piece, contacts, parameters, feature);
  addFreeSpace(MapSide::kObject, contacts, free, planar);
  addFreeSpace(MapSide::kWorld, contacts, free, planar);
  comparePieces(free, feature, planar);
}

std::vector<KnownBalls> PriorEvidence::ballsOf(MapSide side, const FeatureParameters& feature,
                                               bool planar) const {
  std::map<double, PriorMask> by_voxel;
  for (int piece = 0; piece < count(); ++piece) {
    if (known(piece).side() == side) by_voxel[known(piece).voxelSize()] |= PriorMask{1} << piece;
  }
  std::vector<KnownBalls> result;
  for (const auto& [voxel, pieces] : by_voxel) {
    const double half_diagonal = 0.5 * std::sqrt(planar ? 2.0 : 3.0) * voxel;
    const double radius = std::max(0.5 * feature.radius, half_diagonal);
    MaskedPoints balls(0.5F * static_cast<float>(radius));
    forEachBit(pieces, [&](int piece) {
      for (const Eigen::Vector3f& ball : known(piece).balls(static_cast<float>(radius))) {
        balls.add(ball, PriorMask{1} << piece);
      }
    });
    result.push_back({balls.points(), radius, std::max(feature.tolerance, 0.5 * voxel)});
  }
  return result;
}

void PriorEvidence::compare(int piece, const std::vector<ContactHypotheses>& contacts,
                            const PriorParameters& parameters, const FeatureParameters& feature) {
  const KnownMatter& matter = known(piece);
  const auto scale = static_cast<float>(std::max(parameters.scale, matter.voxelSize()));
  const KnownSurface surface(matter.surface(), scale);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    Saying& saying = sayings_[piece][k];
    for (int i = 0; i < contacts[k].count; ++i) {
      const Touch touch =
          touchOf(matter.side(), contacts[k], i, static_cast<float>(feature.radius));
      const float explained = surface.explains(touch.place, touch.inward);
      saying.pull[i] = static_cast<float>(parameters.weight) * explained;
      if (!matter.matterAt(touch.place).has_value()) continue;
      saying.covered[i] = explained > kernel(kOnSurface, 1.0F);
      if (explained <= kernel(kSurfaceEnd, 1.0F)) ++saying.conflicts[i];
    }
  }
}

void PriorEvidence::addFreeSpace(MapSide side, const std::vector<ContactHypotheses>& contacts,
                                 const FreeSpaceEvidence& free, bool planar) {
  std::vector<MaskedPoint> places;
  for (const ContactHypotheses& contact : contacts) {
    const PointArray& points = side == MapSide::kObject ? contact.object : contact.world;
    for (int i = 0; i < contact.count; ++i) places.push_back({points.at(i), 1});
  }
  for (const KnownBalls& other : balls(otherSide(side))) {
    const auto distance = other.overlapDistance(touched_radius_);
    const ForbiddenMatter forbidden(other.balls, posesTo(side, free), distance, distance / 3.0F,
                                    planar);
    auto place = places.begin();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      for (int i = 0; i < contacts[k].count; ++i, ++place) {
        forEachBit(forbidden.at(place->point),
                   [&](int piece) { ++sayings_[piece][k].conflicts[i]; });
      }
    }
  }
}

// What lies within one contact distance counts as one contradiction.
void PriorEvidence::comparePieces(const FreeSpaceEvidence& free, const FeatureParameters& feature,
                                  bool planar) {
  OverlapCells cells(known_.size(), std::vector<std::set<std::uint64_t>>(known_.size()));
  const auto cell = static_cast<float>(feature.conflictDistance());
  for (const KnownBalls& object : object_) {
    for (const KnownBalls& world : world_) addOverlaps(object, world, free, cell, planar, &cells);
  }
  between_.assign(known_.size(), std::vector<int>(known_.size(), 0));
  for (std::size_t p = 0; p < known_.size(); ++p) {
    for (std::size_t q = 0; q < known_.size(); ++q) {
      between_[p][q] = static_cast<int>(cells[p][q].size() + cells[q][p].size());
    }
  }
}

void PriorEvidence::addPulls(MapSide side, int contact, PriorMask believed, float* pulls) const {
  forEachBit(believed, [&](int piece) {
    if (known(piece).side() != side) return;
    const auto& pull = sayings_[piece][contact].pull;
    for (int i = 0; i < kCandidates; ++i) pulls[i] += pull[i];
  });
}

float PriorEvidence::pull(MapSide side, int contact, int place, PriorMask believed) const {
  float sum = 0.0F;
  forEachBit(believed, [&](int piece) {
    if (known(piece).side() == side) sum += sayings_[piece][contact].pull[place];
  });
  return sum;
}

void PriorEvidence::addConflicts(int contact, PriorMask believed, float* conflicts) const {
  forEachBit(believed, [&](int piece) {
    const auto& counts = sayings_[piece][contact].conflicts;
    for (int i = 0; i < kCandidates; ++i) conflicts[i] += counts[i];
  });
}

int PriorEvidence::conflicts(int contact, int place, PriorMask believed) const {
  int sum = 0;
  forEachBit(believed, [&](int piece) { sum += sayings_[piece][contact].conflicts[place]; });
  return sum;
}

int PriorEvidence::conflictsOf(int piece, PriorMask believed) const {
  int sum = 0;
  forEachBit(believed, [&](int other) { sum += between_[piece][other]; });
  return sum;
}

PriorMask PriorEvidence::covering(MapSide side, int contact, int place) const {
  PriorMask mask = 0;
  for (int piece = 0; piece < count(); ++piece) {
    if (known(piece).side() != side || !sayings_[piece][contact].covered[place]) continue;
    mask |= PriorMask{1} << piece;
  }
  return mask;
}

}  // namespace smore
