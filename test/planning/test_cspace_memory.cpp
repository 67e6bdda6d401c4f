// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/planning/cspace_memory.h"
#include "smore/planning/cspace_planner.h"
#include "voxel_oracle.h"

namespace smore {
namespace {

ContactObservation contactAt(const Pose& pose, int id) {
  ContactObservation observation;
  observation.state = ContactState::kContact;
  observation.T_world_object = pose;
  observation.contact_id = id;
  return observation;
}

const Pose kFarAway = makePose(Vec3(100.0, 0.0, 0.0));

TEST(CspaceMemoryTest, posesNearAContactAreInvalid) {
  CspaceMemory memory;
  memory.observe(contactAt(Pose::Identity(), 1));
  EXPECT_FALSE(memory.isValid(Pose::Identity(), kFarAway));
  EXPECT_FALSE(memory.isValid(makePose(Vec3(0.0299, 0, 0)), kFarAway));
  EXPECT_TRUE(memory.isValid(makePose(Vec3(0.0301, 0, 0)), kFarAway));
  EXPECT_FALSE(memory.isValid(makePose(Vec3::Zero(), Vec3(0, 0.0299, 0)), kFarAway));
  EXPECT_TRUE(memory.isValid(makePose(Vec3::Zero(), Vec3(0.0301, 0, 0)), kFarAway));
  EXPECT_TRUE(memory.isValid(makePose(Vec3(0, 0.02, 0), Vec3(0, 0, 0.02)), kFarAway));
}

TEST(CspaceMemoryTest, eachContactIsRememberedOnceWhereItBegan) {
  CspaceMemory memory;
  memory.observe(contactAt(makePose(Vec3(1, 0, 0)), 1));
  memory.observe(contactAt(makePose(Vec3(1.1, 0, 0)), 1));
  ContactObservation free = contactAt(makePose(Vec3(2, 0, 0)), 1);
  free.state = ContactState::kFree;
  memory.observe(free);
  free.state = ContactState::kUnsure;
  memory.observe(free);
  memory.observe(contactAt(makePose(Vec3(3, 0, 0)), 2));
  ASSERT_EQ(memory.contactPoses().size(), 2U);
  EXPECT_EQ(memory.contactPoses()[0].translation().x(), 1.0);
  EXPECT_EQ(memory.contactPoses()[1].translation().x(), 3.0);
}

TEST(CspaceMemoryTest, agreesWithAllPairsOverThousandsOfPoses) {
  CspaceMemory memory({0.08});
  oracle::PoseSource source(1, 0.3, true);
  for (int i = 0; i < 3000; ++i) memory.observe(contactAt(source.next(), i + 1));
  int valid = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pose pose = source.next();
    const auto& poses = memory.contactPoses();
    const bool truth = std::none_of(poses.begin(), poses.end(), [&](const Pose& contact) {
      return gapBetween(contact, pose) < 0.08;
    });
    ASSERT_EQ(memory.isValid(pose, kFarAway), truth);
    valid += truth ? 1 : 0;
  }
  EXPECT_GT(valid, 300);
  EXPECT_LT(valid, 2700);
}

TEST(CspaceMemoryTest, contactsNearTheStartNeverMakeItInvalid) {
  CspaceMemory memory;
  const Pose start = makePose(Vec3(0.2, 0.1, 0.0));
  const Pose contact = makePose(Vec3(0.21, 0.1, 0.0));
  memory.observe(contactAt(contact, 1));
  memory.observe(contactAt(start, 2));
  EXPECT_TRUE(memory.isValid(start, start));
  EXPECT_FALSE(memory.isValid(contact, start));
  EXPECT_FALSE(memory.isValid(makePose(Vec3(0.219, 0.1, 0.0)), start));
  EXPECT_TRUE(memory.isValid(makePose(Vec3(0.19, 0.1, 0.0)), start));
}

TEST(CspaceMemoryTest, refusesARadiusThatIsNotPositive) {
  EXPECT_THROW(CspaceMemory({0.0}), std::invalid_argument);
}

TEST(CspacePlannerTest, goesAroundTheContactsThatItKnows) {
  MotionSpace space;
  space.workspace = {Vec3(-0.1, -0.3, 0.0), Vec3(0.6, 0.3, 0.0)};
  CspaceMemory memory({0.1});
  for (int i = 0; i < 9; ++i) {
    for (int yaw = -20; yaw <= 20; ++yaw) {
      const Pose pose = makePose(Vec3(0.25, -0.2 + 0.04 * i, 0.0), Vec3(0, 0, 0.05 * yaw));
      memory.observe(contactAt(pose, 100 * i + yaw + 50));
    }
  }
  CspacePlanner planner(memory, space, {}, 1);
  const Pose goal = makePose(Vec3(0.5, 0.0, 0.0));
  const auto plan = planner.plan(Pose::Identity(), goal);
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_EQ(plan->path.back().matrix(), goal.matrix());
  EXPECT_EQ(plan->risk, 0.0);
  for (const Pose& pose : densify(plan->path, 0.001, 0.001)) {
    for (const Pose& contact : memory.contactPoses()) {
      ASSERT_GE(gapBetween(pose, contact), 0.9 * 0.1);
    }
  }
}

TEST(CspacePlannerTest, saysWhenTheGoalWasAContact) {
  MotionSpace space;
  space.workspace = {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
  CspaceMemory memory;
  const Pose goal = makePose(Vec3(0.5, 0.0, 0.0));
  memory.observe(contactAt(goal, 1));
  CspacePlanner planner(memory, space, {}, 1);
  const auto plan = planner.plan(Pose::Identity(), goal);
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.reason().find("goal"), std::string::npos) << plan.reason();
}

}  // namespace
}  // namespace smore
