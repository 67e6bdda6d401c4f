// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/known_matter.h"
#include "smore/mapping/mask_grid.h"

namespace smore {

/// One bit for each piece of prior knowledge, at most kMostPriors.
using PriorMask = std::uint64_t;
constexpr int kMostPriors = 64;

/// How known matter is compared with touches. Lengths are in metres where they are used, by default
/// in units of length.
struct PriorParameters {
  double scale = 0.15;  ///< a touch that is twice as far from the known surfaces is not on them
  double weight = 1.0;  ///< of a known surface, in touches at one place
};

/// Matter of pieces that were told in voxels of one size, as balls below its surface.
struct KnownBalls {
  std::vector<MaskedPoint> balls;
  /// Of the balls [m]: half of that of touched ones, whose depth is a guess, or what holds a voxel,
  /// so that nothing passes between them.
  double radius = 0.0;
  /// The surface may be so far from where it was told [m]: half a voxel, or the tolerance of
  /// touches where that is larger.
  double tolerance = 0.0;

  /// Centres of one of these and of a touched ball that are nearer overlap for sure [m].
  float overlapDistance(double touched_radius) const {
    return static_cast<float>(touched_radius + radius - tolerance);
  }
};

/// What pieces of prior knowledge say about the places of all contacts, if they are true, and about
/// one another (docs/belief.md, docs/priors.md).
class PriorEvidence {
 public:
  /// Nothing is known.
  PriorEvidence() = default;

  /// `known` at most kMostPriors.
  PriorEvidence(const KnownPieces& known, const std::vector<ContactHypotheses>& contacts,
                const FreeSpaceEvidence& free, const PriorParameters& parameters,
                const FeatureParameters& feature, bool planar);

  int count() const { return static_cast<int>(known_.size()); }
  const KnownMatter& known(int piece) const { return *known_[piece]; }
  const KnownPieces& pieces() const { return known_; }

  /// Adds to each place of a contact what the pieces in the mask say for it, in touches: those of
  /// one side only.
  void addPulls(MapSide side, int contact, PriorMask believed, float* pulls) const;
  float pull(MapSide side, int contact, int place, PriorMask believed) const;

  /// Adds for each place of a contact how many of these pieces it contradicts.
  void addConflicts(int contact, PriorMask believed, float* conflicts) const;
  int conflicts(int contact, int place, PriorMask believed) const;

  /// Contradictions between a piece and these: matter of the object and of the world that
  /// overlapped at a pose that was free.
  int conflictsOf(int piece, PriorMask believed) const;

  /// The pieces of one side on whose surface the place of a contact is, so that their matter is all
  /// that it tells of.
  PriorMask covering(MapSide side, int contact, int place) const;

  /// The matter of all pieces of one side, with the pieces that it belongs to.
  const std::vector<KnownBalls>& balls(MapSide side) const {
    return side == MapSide::kObject ? object_ : world_;
  }

 private:
  /// What one piece says about one contact's places.
  struct Saying {
    std::array<float, kCandidates> pull{};
    std::array<bool, kCandidates> covered{};            ///< whether this piece's surface is there
    std::array<std::uint8_t, kCandidates> conflicts{};  ///< how often it contradicts the piece
  };

  std::vector<KnownBalls> ballsOf(MapSide side, const FeatureParameters& feature,
                                  bool planar) const;
  void compare(int piece, const std::vector<ContactHypotheses>& contacts,
               const PriorParameters& parameters, const FeatureParameters& feature);
  void addFreeSpace(MapSide side, const std::vector<ContactHypotheses>& contacts,
                    const FreeSpaceEvidence& free, bool planar);
  void comparePieces(const FreeSpaceEvidence& free, const FeatureParameters& feature, bool planar);

  KnownPieces known_;
  double touched_radius_ = 0.0;
  std::vector<KnownBalls> object_;
  std::vector<KnownBalls> world_;
  std::vector<std::vector<Saying>> sayings_;  ///< [piece][contact]
  std::vector<std::vector<int>> between_;     ///< [piece][piece]
};

}  // namespace smore
