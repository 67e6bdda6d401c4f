// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/unknown_places.h"

#include <algorithm>

#include "smore/mapping/counter_random.h"

namespace smore {
namespace {

// They tell shares apart by a hundredth.
constexpr int kPlaces = 128;

// One piece that may go on farther than it says is enough for no limit.
float reachOfKnownObject(const KnownPieces& pieces, float otherwise) {
  float farthest = 0.0F;
  bool any = false;
  for (const auto& piece : pieces) {
    if (piece->side() != MapSide::kObject || !piece->hasMatter()) continue;
    any = true;
    farthest = std::max(farthest, piece->reach().value_or(otherwise));
  }
  return any ? std::min(farthest, otherwise) : otherwise;
}

std::vector<Eigen::Vector3f> placesWithin(float reach, bool planar) {
  CounterRandom random(0);
  std::vector<Eigen::Vector3f> places;
  while (static_cast<int>(places.size()) < kPlaces) {
    const Vec3 place = random.inCube(planar ? 2 : 3);
    if (place.norm() <= 1.0) places.push_back(reach * place.cast<float>());
  }
  return places;
}

}  // namespace

UnknownPlaces::UnknownPlaces(const BelievedPrior& prior, HypothesisMask members, double reach,
                             bool planar)
    : members_(members) {
  for (int piece = 0; piece < prior.evidence.count(); ++piece) {
    pieces_.push_back({prior.evidence.pieces()[piece], prior.worlds[piece]});
  }
  if (pieces_.empty()) return;
  const auto largest = static_cast<float>(reach);
  places_ = placesWithin(reachOfKnownObject(prior.evidence.pieces(), largest), planar);
}

double UnknownPlaces::worldsAt(const Eigen::Isometry3f& T_map_object) const {
  if (pieces_.empty()) return __builtin_popcountll(members_);
  int sum = 0;
  for (const Eigen::Vector3f& place : places_) {
    sum += __builtin_popcountll(unknownAt(place, T_map_object * place));
  }
  return static_cast<double>(sum) / kPlaces;
}

HypothesisMask UnknownPlaces::unknownAt(const Eigen::Vector3f& on_object,
                                        const Eigen::Vector3f& in_map) const {
  HypothesisMask free = 0;
  HypothesisMask object_known = 0;
  HypothesisMask world_known = 0;
  for (const Piece& piece : pieces_) {
    const bool of_object = piece.known->side() == MapSide::kObject;
    const auto matter = piece.known->matterAt(of_object ? on_object : in_map);
    if (!matter) continue;
    (of_object ? object_known : world_known) |= piece.worlds;
    if (!*matter) free |= piece.worlds;
  }
  return members_ & ~free & ~(object_known & world_known);
}

}  // namespace smore
