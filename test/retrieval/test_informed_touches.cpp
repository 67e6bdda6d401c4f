// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "smore/planning/contact_risk.h"
#include "smore/retrieval/informed_touches.h"
#include "smore/retrieval/method.h"

namespace smore {
namespace {

MotionSpace space() {
  MotionSpace space;
  space.workspace = {Vec3(-0.5, -0.5, -0.01), Vec3(0.5, 0.5, 0.01)};
  return space;
}

// The object moved 20 cm along x without touching, and was stopped by something head on.
JointBelief touchedOnce() {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  parameters.T_world_plane = Pose::Identity();
  JointBelief belief(parameters);
  ContactObservation observation;
  observation.state = ContactState::kFree;
  for (int i = 0; i < 20; ++i) {
    observation.T_world_object = makePose(Vec3(0.01 * i, 0, 0));
    belief.observe(observation);
  }
  observation.state = ContactState::kContact;
  observation.T_world_object = makePose(Vec3(0.2, 0, 0));
  observation.line = LineOfAction{Vec3::Zero(), -Vec3::UnitX(), 6.0};
  belief.observe(observation);
  return belief;
}

TEST(InformedTouches, goAlongFreePosesAndThenOnWithinTheWorkspace) {
  const JointBelief belief = touchedOnce();
  InformedTouches touches(belief, space(), {}, 1);
  for (int i = 0; i < 20; ++i) {
    const Path path = *touches.nextTouch(makePose(Vec3(0, 0, 0)));
    ASSERT_GE(path.size(), 2u);
    EXPECT_TRUE(path.front().isApprox(Pose::Identity()));
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      EXPECT_TRUE(belief.worlds()->free.knows(path[k]));
    }
    EXPECT_TRUE(space().contains(path.back()));
  }
}

TEST(InformedTouches, tellMoreThanTheyMust) {
  const JointBelief belief = touchedOnce();
  InformedTouches touches(belief, space(), {}, 1);
  const Path path = *touches.nextTouch(Pose::Identity());
  ASSERT_GE(path.size(), 2u);
  const Path probe(path.end() - 2, path.end());
  EXPECT_DOUBLE_EQ(ContactRisk(belief.worlds()).informationOf(probe), touches.information());
  EXPECT_GE(touches.information(), InformedTouchParameters{}.least_information);
}

TEST(InformedTouches, keepWithinTheHalfTurnOfAnArm) {
  const JointBelief belief = touchedOnce();
  MotionSpace arm = space();
  arm.full_turns = false;
  arm.T_world_plane = makePose(Vec3::Zero(), Vec3(0, 0, -3.0));
  InformedTouches touches(belief, arm, {}, 1);
  int turning = 0;
  for (int i = 0; i < 20; ++i) {
    const Path path = *touches.nextTouch(Pose::Identity());
    ASSERT_GE(path.size(), 2u);
    EXPECT_TRUE(arm.allowsTurn(path[path.size() - 2], path.back()));
    if (!path.back().linear().isApprox(path[path.size() - 2].linear(), 0.2)) ++turning;
  }
  EXPECT_GT(turning, 0);
}

// The free poses lie on a lattice of the world, not in the plane.
TEST(InformedTouches, areFoundInAPlaneBesideThePosesThatWereFree) {
  const JointBelief belief = touchedOnce();
  MotionSpace lifted = space();
  lifted.T_world_plane = makePose(Vec3(0, 0, 0.0003), Vec3(0.001, 0, 0));
  InformedTouches touches(belief, lifted, {}, 1);
  const Path path = *touches.nextTouch(Pose::Identity());
  ASSERT_GE(path.size(), 2u);
  EXPECT_TRUE(lifted.contains(path.back()));
}

TEST(InformedTouches, endWhereNothingTellsEnough) {
  const JointBelief belief = touchedOnce();
  InformedTouchParameters parameters;
  parameters.least_information = 10.0;  // more than 64 worlds can tell
  InformedTouches touches(belief, space(), parameters, 1);
  EXPECT_TRUE(touches.nextTouch(Pose::Identity())->empty());
}

TEST(InformedTouches, repeatForASeedAndBeginAtRandom) {
  JointBeliefParameters parameters;
  parameters.unit = 0.1;
  parameters.T_world_plane = Pose::Identity();
  const JointBelief nothing(parameters);
  const JointBelief belief = touchedOnce();
  for (const JointBelief* known : {&nothing, &belief}) {
    InformedTouches first(*known, space(), {}, 4);
    InformedTouches second(*known, space(), {}, 4);
    for (int i = 0; i < 3; ++i) {
      const Path path = *first.nextTouch(Pose::Identity());
      ASSERT_FALSE(path.empty());
      EXPECT_TRUE(path.back().isApprox(second.nextTouch(Pose::Identity())->back()));
    }
  }
}

TEST(InformedTouches, areTheMethodsOwnInThePlaneAlone) {
  for (const Motion motion : {Motion::kPlanar, Motion::kSpatial}) {
    Scenario scenario;
    scenario.motion = motion;
    const Method method = makeMethod(MethodKind::kSmore, scenario, 1);
    const bool informed = dynamic_cast<InformedTouches*>(method.touches.get()) != nullptr;
    EXPECT_EQ(informed, motion == Motion::kPlanar);
    EXPECT_NE(makeInformedTouches(method, scenario, 1), nullptr);
  }
}

}  // namespace
}  // namespace smore
