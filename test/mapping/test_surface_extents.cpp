// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "at_a_decimetre.h"
#include "contact_at.h"
#include "smore/mapping/surface_extents.h"

namespace smore {
namespace {

constexpr double kStepShare = 0.8;  // of the contact distance, from point to point of a patch

// Two touches of the object 30 cm apart; what a third touched in the world lay at `obstacle` when
// the object was free. Whether matter joins the two.
bool joinsPastAnObstacleAt(const Vec3& obstacle) {
  const JointBeliefParameters lengths = atADecimetre();
  const FeatureParameters& feature = lengths.feature;
  FreeSpaceEvidence evidence(lengths.free_space, feature.conflictDistance());
  evidence.addPose(Pose::Identity());
  const Vec3 left(-0.15, 0.0, 0.03);
  const Vec3 right(0.15, 0.0, 0.03);
  const Vec3 far(2.0, 2.0, 2.0);
  const std::vector<ContactHypotheses> contacts = {
      contactAt(left, far, 1), contactAt(right, far, 2), contactAt(left, obstacle, 3)};
  const std::vector<Explanation> explanations(kHypotheses, Explanation(contacts.size(), 0));
  const BelievedPrior nothing_known;
  const SurfaceExtents surfaces(
      {contacts, evidence, explanations, ~HypothesisMask{0}, nothing_known}, feature,
      lengths.extent, false, 1);
  return std::any_of(surfaces.object().begin(), surfaces.object().end(),
                     [](const MaskedPoint& ball) { return std::abs(ball.point.x()) < 0.1F; });
}

TEST(SurfaceExtents, JoinTouchesInSpaceUnlessFreeSpaceSpeaksAgainstIt) {
  const double distance = atADecimetre().feature.conflictDistance();
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.0, 0.03}));
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.5 * distance, 0.03})) << "beside all touches";
  EXPECT_FALSE(joinsPastAnObstacleAt({0.0, 0.0, 0.03 - 0.5 * distance})) << "below all touches";
  EXPECT_TRUE(joinsPastAnObstacleAt({0.0, 2.0 * distance, 0.03}));
}

// Worlds in which the surface of a single touch goes on for at least so many steps of its lattice.
int worldsThatGoOnFor(int steps) {
  const JointBeliefParameters lengths = atADecimetre();
  const FreeSpaceEvidence no_evidence(lengths.free_space, lengths.feature.conflictDistance());
  std::vector<ContactHypotheses> contacts = {contactAt({0.0, 0.0, 0.1}, Vec3::Zero(), 1)};
  contacts[0].world_normal.set(0, Vec3::UnitZ());
  const std::vector<Explanation> explanations(kHypotheses, Explanation(1, 0));
  const SurfaceExtents surfaces({contacts, no_evidence, explanations, ~HypothesisMask{0}, {}},
                                lengths.feature, lengths.extent, false, 1);
  const double least = (steps - 0.5) * kStepShare * lengths.feature.conflictDistance();
  HypothesisMask worlds = 0;
  for (const MaskedPoint& ball : surfaces.world()) {
    if (ball.point.norm() >= least) worlds |= ball.mask;
  }
  return __builtin_popcountll(worlds);
}

TEST(SurfaceExtents, HaveSizesOfAllOrdersOfMagnitudeAlike) {
  const JointBeliefParameters lengths = atADecimetre();
  const double range = std::log(lengths.extent.world_longest / lengths.extent.shortest);
  for (const int steps : {1, 2, 4, 8, 16}) {
    const double size = steps * kStepShare * lengths.feature.conflictDistance();
    EXPECT_NEAR(worldsThatGoOnFor(steps),
                kHypotheses * std::log(lengths.extent.world_longest / size) / range, 1.0)
        << steps;
  }
}

// Whether the surface of one touch goes on to where the object's ball was free beside the farthest
// point of the largest patch.
TEST(SurfaceExtents, EndAtFreeSpaceBesideTheLargestPatch) {
  const JointBeliefParameters lengths = atADecimetre();
  const double distance = lengths.feature.conflictDistance();
  const Vec3 on_object(0.0, 0.1, 0.0);
  std::vector<ContactHypotheses> contacts = {contactAt(on_object, Vec3::Zero(), 1)};
  contacts[0].object_normal.set(0, Vec3::UnitX());
  contacts[0].world_normal.set(0, Vec3::UnitY());
  const std::vector<Explanation> explanations(kHypotheses, Explanation(1, 0));
  const Vec3 beside(lengths.extent.world_longest + 0.2 * distance, 0.0, 0.0);
  const Pose pose = FreeCells(lengths.free_space).centerOf(makePose(beside - on_object));
  const Vec3 free = pose * on_object;
  const auto nearest = [&](const FreeSpaceEvidence& evidence) {
    const SurfaceExtents surfaces({contacts, evidence, explanations, ~HypothesisMask{0}, {}},
                                  lengths.feature, lengths.extent, true, 1);
    double least = lengths.extent.world_longest;
    for (const MaskedPoint& ball : surfaces.world()) {
      least = std::min(least, (ball.point.cast<double>() - free).norm());
    }
    return least;
  };
  FreeSpaceEvidence evidence(lengths.free_space, distance);
  EXPECT_LT(nearest(evidence), 0.9 * distance);
  evidence.addPose(pose);
  EXPECT_GE(nearest(evidence), 0.9 * distance);
}

// The object's matter; all contacts are at their first places, and all worlds hold what is known to
// be true.
std::vector<MaskedPoint> objectOf(const std::vector<ContactHypotheses>& contacts,
                                  const FreeSpaceEvidence& evidence, bool planar,
                                  const KnownPieces& known = {}) {
  const JointBeliefParameters lengths = atADecimetre();
  const std::vector<Explanation> explanations(kHypotheses, Explanation(contacts.size(), 0));
  const BelievedPrior believed{
      PriorEvidence(known, contacts, evidence, lengths.prior, lengths.feature, planar),
      std::vector<HypothesisMask>(known.size(), ~HypothesisMask{0})};
  const SurfaceExtents surfaces({contacts, evidence, explanations, ~HypothesisMask{0}, believed},
                                lengths.feature, lengths.extent, planar, 1);
  std::vector<MaskedPoint> object = surfaces.object();
  object.insert(object.end(), surfaces.behindObject().begin(), surfaces.behindObject().end());
  return object;
}

// Worlds in which the object, touched at its left ends at two heights, goes on for more than 20 cm
// behind the upper touch; `ahead` of the lower one what was touched in the world lay free.
int worldsOfDepth(double ahead, bool planar, const KnownPieces& known = {}) {
  const JointBeliefParameters lengths = atADecimetre();
  FreeSpaceEvidence evidence(lengths.free_space, lengths.feature.conflictDistance());
  evidence.addPose(Pose::Identity());
  const Vec3 lower(0.0, -0.3, 0.0);
  const Vec3 upper(0.0, 0.3, 0.0);
  const Vec3 far(5.0, 5.0, 0.0);
  std::vector<ContactHypotheses> contacts = {
      contactAt(upper, far, 1), contactAt(lower, Vec3(lower + ahead * Vec3::UnitX()), 2)};
  for (ContactHypotheses& contact : contacts) contact.object_normal.set(0, Vec3::UnitX());
  HypothesisMask worlds = 0;
  for (const MaskedPoint& ball : objectOf(contacts, evidence, planar, known)) {
    if (ball.point.x() > 0.2F && std::abs(ball.point.y() - 0.3F) < 0.02F) worlds |= ball.mask;
  }
  return __builtin_popcountll(worlds);
}

TEST(SurfaceExtents, GoOnBehindAllTouchesAsDeepAsFreeSpaceAllowsBehindEach) {
  const ExtentParameters extent = atADecimetre().extent;
  const double deeper = std::log(extent.object_longest / 0.2) /
                        std::log(extent.object_longest / extent.shortest) * kHypotheses;
  for (const bool planar : {true, false}) {
    EXPECT_NEAR(worldsOfDepth(3.0, planar), deeper, 4.0) << planar;
    EXPECT_EQ(worldsOfDepth(0.1, planar), 0) << "the object is thinner than that elsewhere";
  }
}

// In space matter fills the ball that touches the surface there and is as deep as the object: a
// point at x behind the touch and y beside that lies in those of at least (x^2 + y^2) / x.
TEST(SurfaceExtents, FillBallsBehindTouchesInSpace) {
  const JointBeliefParameters lengths = atADecimetre();
  const FreeSpaceEvidence no_evidence(lengths.free_space, lengths.feature.conflictDistance());
  std::vector<ContactHypotheses> contacts = {contactAt(Vec3::Zero(), {5.0, 5.0, 0.0}, 1)};
  contacts[0].object_normal.set(0, Vec3::UnitX());
  const std::vector<MaskedPoint> object = objectOf(contacts, no_evidence, false);
  const double range = std::log(lengths.extent.object_longest / lengths.extent.shortest);
  for (const Vec3& inside : {Vec3(0.15, 0.1, 0.0), Vec3(0.15, 0.0, -0.1), Vec3(0.3, 0.1, 0.0)}) {
    HypothesisMask worlds = 0;
    for (const MaskedPoint& ball : object) {
      const double distance = (ball.point.cast<double>() - inside).norm();
      if (distance < lengths.feature.radius) worlds |= ball.mask;
    }
    const double depth = inside.squaredNorm() / inside.x();
    const double deeper = std::log(lengths.extent.object_longest / depth) / range * kHypotheses;
    EXPECT_NEAR(__builtin_popcountll(worlds), deeper, 4.0) << inside.transpose();
  }
}

// What is known to be matter goes on behind a touch as much as what is not known does; what is
// known to be free does not.
TEST(SurfaceExtents, GoOnThroughKnownMatterAndEndWhereNothingIsKnownToBe) {
  for (const bool planar : {true, false}) {
    const auto behindTheLower = [planar](float probability) -> KnownPieces {
      Prior prior{VoxelGrid(0.01), 0.999};
      visitVoxels(voxelAt({0.05, -0.35, -0.05}, 0.01), voxelAt({0.8, -0.25, 0.05}, 0.01),
                  [&](const VoxelKey& key) { prior.known.set(key, probability); });
      return {
          std::make_shared<const KnownMatter>(MapSide::kObject, prior, Pose::Identity(), planar)};
    };
    EXPECT_EQ(worldsOfDepth(3.0, planar, behindTheLower(1.0F)), worldsOfDepth(3.0, planar));
    EXPECT_EQ(worldsOfDepth(3.0, planar, behindTheLower(0.0F)), 0);
  }
}

// Touches of a wall whose forces friction tilts: where one surface goes on far, its matter is in
// the wall.
TEST(SurfaceExtents, GoOnInThePlaneThatTouchesInSpaceShare) {
  const JointBeliefParameters lengths = atADecimetre();
  const FreeSpaceEvidence no_evidence(lengths.free_space, lengths.feature.conflictDistance());
  std::vector<ContactHypotheses> contacts;
  for (int i = 0; i < 8; ++i) {
    const double turn = 2.0 * M_PI * i / 8.0;
    const Vec3 around(std::cos(turn), std::sin(turn), 0.0);
    contacts.push_back(contactAt({0.0, 0.0, 0.1}, Vec3(0.15 * around), i + 1));
    contacts.back().world_normal.set(0, (Vec3::UnitZ() + 0.25 * around).normalized());
  }
  const std::vector<Explanation> explanations(kHypotheses, Explanation(contacts.size(), 0));
  const SurfaceExtents surfaces({contacts, no_evidence, explanations, ~HypothesisMask{0}, {}},
                                lengths.feature, lengths.extent, false, 1);
  // Along the forces it would be up to a quarter of this beside the wall.
  for (const MaskedPoint& ball : surfaces.world()) {
    EXPECT_LT(std::abs(ball.point.z()), 0.1F * lengths.extent.world_longest);
  }
}

TEST(SurfaceExtents, JoinTouchesInThePlaneToo) {
  const JointBeliefParameters lengths = atADecimetre();
  const FreeSpaceEvidence no_evidence(lengths.free_space, lengths.feature.conflictDistance());
  const Vec3 far(5.0, 5.0, 0.0);
  std::vector<ContactHypotheses> contacts = {contactAt({-0.2, 0.0, 0.0}, far, 1),
                                             contactAt({0.2, 0.0, 0.0}, far, 2)};
  contacts[0].object_normal.set(0, Vec3::UnitX());
  contacts[1].object_normal.set(0, -Vec3::UnitX());
  HypothesisMask joined = 0;
  for (const MaskedPoint& ball : objectOf(contacts, no_evidence, true)) {
    if (ball.point.norm() < 0.02F) joined |= ball.mask;
  }
  EXPECT_EQ(joined, ~HypothesisMask{0});
}

}  // namespace
}  // namespace smore
