// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <utility>

#include "smore/planning/collision_checker.h"
#include "smore/planning/fcl_collision_checker.h"
#include "smore/planning/grid_collision_checker.h"
#include "smore/planning/occupied_voxels.h"
#include "voxel_oracle.h"

namespace smore {
namespace {

using oracle::deepestOverlap;
using oracle::PoseSource;
using oracle::voxelize;

/// What every backend of CollisionChecker must do.
template <typename Checker>
class CollisionCheckerTest : public testing::Test {
 protected:
  static void expectAgreement(double voxel_size, bool planar, unsigned seed) {
    const OccupiedVoxels object = voxelize(oracle::sShape(), voxel_size);
    const OccupiedVoxels world = voxelize(oracle::twoPegs(), voxel_size);
    const Checker checker(object, world);
    PoseSource poses(seed, 0.4, planar);
    int collisions = 0;
    for (int i = 0; i < 10000; ++i) {
      const Pose pose = poses.next();
      const double depth = deepestOverlap(object, world, pose);
      collisions += depth > 0.0 ? 1 : 0;
      if (std::abs(depth) < 2.0 * kTouchingShare * voxel_size) continue;
      ASSERT_EQ(checker.inCollision(pose), depth > 0.0) << "pose " << i << ", depth " << depth;
    }
    EXPECT_GT(collisions, 500);
    EXPECT_LT(collisions, 9500);
  }
};

using Backends = testing::Types<FclCollisionChecker, GridCollisionChecker>;
TYPED_TEST_SUITE(CollisionCheckerTest, Backends);

TYPED_TEST(CollisionCheckerTest, agreesWithAllPairsInThePlaneAt3Cm) {
  this->expectAgreement(0.03, true, 1);
}

TYPED_TEST(CollisionCheckerTest, agreesWithAllPairsInThePlaneAt5Cm) {
  this->expectAgreement(0.05, true, 2);
}

TYPED_TEST(CollisionCheckerTest, agreesWithAllPairsInSpaceAt3Cm) {
  this->expectAgreement(0.03, false, 3);
}

TYPED_TEST(CollisionCheckerTest, agreesWithAllPairsInSpaceAt5Cm) {
  this->expectAgreement(0.05, false, 4);
}

TYPED_TEST(CollisionCheckerTest, freeWhereAMapIsEmpty) {
  const OccupiedVoxels some = voxelize(oracle::twoPegs(), 0.03);
  const OccupiedVoxels none{0.03, {}};
  for (const auto& [object, world] :
       {std::make_pair(some, none), std::make_pair(none, some), std::make_pair(none, none)}) {
    const TypeParam checker(object, world);
    EXPECT_FALSE(checker.inCollision(Pose::Identity()));
    EXPECT_GE(checker.clearance(Pose::Identity(), 0.7), 0.7);
  }
  EXPECT_EQ(TypeParam(none, some).objectRadius(), 0.0);
}

TYPED_TEST(CollisionCheckerTest, touchingFacesEdgesAndCornersAreFree) {
  constexpr double kSize = 0.03;
  const TypeParam checker({kSize, {{0, 0, 0}}}, {kSize, {{0, 0, 0}}});
  for (const Vec3& step : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 1)}) {
    EXPECT_FALSE(checker.inCollision(makePose(kSize * step))) << step.transpose();
    EXPECT_TRUE(checker.inCollision(makePose((1.0 - 1e-4) * kSize * step))) << step.transpose();
    EXPECT_FALSE(checker.inCollision(makePose((1.0 + 1e-4) * kSize * step))) << step.transpose();
  }
}

TYPED_TEST(CollisionCheckerTest, wholeTouchingSidesAreFree) {
  constexpr double kSize = 0.05;
  const OccupiedVoxels slab = voxelize({{{-0.5, -0.5, 0.0}, {0.5, 0.5, 0.05}}}, kSize);
  const TypeParam checker(slab, slab);
  EXPECT_FALSE(checker.inCollision(makePose(Vec3(0.0, 0.0, kSize))));
  EXPECT_FALSE(checker.inCollision(makePose(Vec3(0.013, 0.02, kSize), Vec3(0, 0, 0.4))));
  EXPECT_TRUE(checker.inCollision(makePose(Vec3(0.013, 0.02, 0.999 * kSize), Vec3(0, 0, 0.4))));
}

TYPED_TEST(CollisionCheckerTest, farKeysAreKeptApart) {
  const TypeParam checker({0.01, {{-30000, 30000, 0}}}, {0.01, {{30000, -30000, 5}}});
  EXPECT_FALSE(checker.inCollision(Pose::Identity()));
  EXPECT_TRUE(checker.inCollision(makePose(Vec3(600.0, -600.0, 0.05))));
  EXPECT_FALSE(checker.inCollision(makePose(Vec3(1e9, 0, 0))));
}

TYPED_TEST(CollisionCheckerTest, objectRadiusReachesTheFarthestCorner) {
  const TypeParam checker({0.1, {{0, 0, 0}, {-3, 0, 0}}}, {0.1, {{9, 9, 9}}});
  EXPECT_NEAR(checker.objectRadius(), std::sqrt(0.09 + 0.01 + 0.01), 1e-12);
  EXPECT_EQ(checker.voxelSize(), 0.1);
}

TYPED_TEST(CollisionCheckerTest, clearanceIsNeverMoreThanTheTrueGap) {
  const OccupiedVoxels object = voxelize(oracle::sShape(), 0.03);
  const OccupiedVoxels world = voxelize(oracle::twoPegs(), 0.03);
  const TypeParam checker(object, world);
  PoseSource poses(5, 0.6, false);
  PoseSource pushes(6, 1.0, false);
  for (int i = 0; i < 3000; ++i) {
    const Pose pose = poses.next();
    const double clearance = checker.clearance(pose, 0.1);
    ASSERT_EQ(clearance < 0.0, checker.inCollision(pose));
    if (clearance <= 0.0) continue;
    Pose pushed = pose;
    pushed.translation() += 0.9999 * clearance * pushes.next().translation().normalized();
    ASSERT_LE(deepestOverlap(object, world, pushed), 0.0) << "pose " << i;
  }
}

TYPED_TEST(CollisionCheckerTest, clearanceInTheOpenIsAsMuchAsAskedFor) {
  const TypeParam checker(voxelize(oracle::sShape(), 0.03), voxelize(oracle::twoPegs(), 0.03));
  EXPECT_GE(checker.clearance(makePose(Vec3(-2.0, 0.0, 0.0)), 0.3), 0.3);
}

TYPED_TEST(CollisionCheckerTest, voxelSizesMustAgree) {
  EXPECT_THROW(TypeParam({0.03, {}}, {0.05, {}}), std::invalid_argument);
  EXPECT_THROW(TypeParam({0.0, {}}, {0.0, {}}), std::invalid_argument);
}

TYPED_TEST(CollisionCheckerTest, motionThroughAThinWallIsNotFree) {
  const OccupiedVoxels object{0.03, {{0, 0, 0}}};
  const OccupiedVoxels wall = voxelize({{{0.3, -0.5, -0.1}, {0.33, 0.5, 0.1}}}, 0.03);
  const TypeParam checker(object, wall);
  const Pose far_side = makePose(Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 3.0));
  EXPECT_FALSE(isMotionFree(checker, Pose::Identity(), far_side, 0.0015));
  EXPECT_FALSE(isMotionFree(checker, far_side, Pose::Identity(), 0.0015));
  const Pose same_side = makePose(Vec3(0.2, 0.4, 0.0), Vec3(0.0, 0.0, 3.0));
  EXPECT_TRUE(isMotionFree(checker, Pose::Identity(), same_side, 0.0015));
}

TYPED_TEST(CollisionCheckerTest, freeMotionsOverlapByNoMoreThanTheDepth) {
  constexpr double kDepth = 0.0015;
  const OccupiedVoxels object = voxelize(oracle::sShape(), 0.03);
  const OccupiedVoxels world = voxelize(oracle::twoPegs(), 0.03);
  const TypeParam checker(object, world);
  PoseSource poses(7, 0.3, false);
  int free = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose from = poses.next();
    const Pose to = interpolate(from, poses.next(), 0.1);
    if (checker.inCollision(from) || !isMotionFree(checker, from, to, kDepth)) continue;
    ++free;
    for (int k = 0; k <= 25; ++k) {
      ASSERT_LE(deepestOverlap(object, world, interpolate(from, to, 0.04 * k)), kDepth);
    }
  }
  EXPECT_GT(free, 100);
}

TEST(OccupiedVoxelsTest, areThoseFromOneHalfOn) {
  VoxelGrid grid(0.1);
  grid.set({1, 2, 3}, 0.5F);
  grid.set({1, 2, 4}, 0.49F);
  grid.set({-1, 2, 4}, 1.0F);
  const OccupiedVoxels voxels = occupiedVoxels(grid);
  EXPECT_EQ(voxels.keys, (std::vector<VoxelKey>{{1, 2, 3}, {-1, 2, 4}}));
}

}  // namespace
}  // namespace smore
