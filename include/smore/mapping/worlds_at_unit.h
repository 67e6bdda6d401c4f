// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "smore/mapping/believed_prior.h"
#include "smore/mapping/contact_hypotheses.h"
#include "smore/mapping/free_space_evidence.h"
#include "smore/mapping/joint_distribution.h"
#include "smore/mapping/matter_overlap.h"
#include "smore/mapping/unknown_places.h"

namespace smore {

/// How far touched matter goes on, in units of length: each world has one radius of all patches
/// around its touches, in planar motion one of those around the object's, and one depth of the
/// object behind its surface, log-uniform from the shortest to the longest.
struct ExtentParameters {
  double shortest = 0.2;        ///< as large as a patch that is just told from a point
  double object_longest = 6.0;  ///< on the object and behind its surface: what a gripper holds
  double world_longest = 6.0;   ///< in the world
};

/// The surroundings of a joint sample: all that WorldsAtUnit is made from. Views.
struct WorldSamples {
  const std::vector<ContactHypotheses>& contacts;
  const FreeSpaceEvidence& evidence;
  const std::vector<Explanation>& explanations;  ///< kHypotheses of them
  HypothesisMask members;                        ///< those of them that count
  const BelievedPrior& prior;
};

/// Worlds of one unit of length that the evidence allows, side by side in the bits of machine
/// words: each an explanation of all contacts, with the touched surfaces continued at random until
/// free space ends them, and with the matter that it believes to be known.
class WorldsAtUnit {
 public:
  WorldsAtUnit(const WorldSamples& samples, const FeatureParameters& feature,
               const ExtentParameters& extent, bool planar, std::uint64_t seed);

  /// Makes what `touching` looks things up in, which the first call does else, and takes a moment.
  void prepareTouching() const { (void)overlaps(); }

  /// From now on the object touches in every world at poses like this one, at which it did touch:
  /// those from which no matter within `reach` [m] of the object frame's origin has moved by more
  /// than half the distance at which two balls touch.
  void setTouching(const Eigen::Isometry3f& T_map_object, double reach);

  /// The worlds in which the object touches at this pose in the map frame. Once they are more than
  /// `enough`, the rest may be missing.
  HypothesisMask touching(const Eigen::Isometry3f& T_map_object,
                          int enough = kHypotheses - 1) const;

  /// As UnknownPlaces::worldsAt, within the reach.
  double unknownWorldsAt(const Eigen::Isometry3f& T_map_object) const {
    return unknown_.worldsAt(T_map_object);
  }

  /// Centres of the balls of touched matter, in the object's and the map's frame.
  const std::vector<MaskedPoint>& object() const { return object_; }
  const std::vector<MaskedPoint>& world() const { return world_; }
  /// The same of the matter in the balls behind the object's touches (SurfaceExtents): maps tell of
  /// it, touches are not looked up in it.
  const std::vector<MaskedPoint>& behindObject() const { return behind_object_; }
  double radius() const { return radius_; }  ///< of these balls [m]

  /// Matter that was known beforehand.
  const std::vector<KnownBalls>& knownObject() const { return known_object_; }
  const std::vector<KnownBalls>& knownWorld() const { return known_world_; }

  /// Distance of two touched balls' centres at which they touch [m].
  double contactDistance() const { return contact_distance_; }

 private:
  /// A pose at which the object touched, and poses like it.
  struct TouchingPose {
    Eigen::Isometry3f T_map_object;
    float reach;
  };
  struct Overlaps {
    std::once_flag made;
    std::vector<MatterOverlap> all;
  };
  /// Of touched matter and known one.
  TouchDistance touchDistance(const KnownBalls& known) const;
  /// Of touched or known matter of either side. Made when they are first asked for: they are large,
  /// and maps do without. Threads may ask at the same time.
  const std::vector<MatterOverlap>& overlaps() const;
  std::vector<MatterOverlap> makeOverlaps() const;
  bool isLikeATouchingPose(const Eigen::Isometry3f& T_map_object) const;

  double radius_;
  double contact_distance_;
  bool planar_;
  HypothesisMask members_;
  UnknownPlaces unknown_;
  std::vector<TouchingPose> touching_poses_;
  std::vector<MaskedPoint> object_;
  std::vector<MaskedPoint> behind_object_;
  std::vector<MaskedPoint> world_;
  std::vector<KnownBalls> known_object_;
  std::vector<KnownBalls> known_world_;
  std::unique_ptr<Overlaps> overlaps_ = std::make_unique<Overlaps>();
};

}  // namespace smore
