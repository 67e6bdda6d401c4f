// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "scripted_robot.h"
#include "smore/retrieval/reconstruction.h"

namespace smore {
namespace {

MotionSpace space(Motion motion) {
  MotionSpace space;
  space.motion = motion;
  space.T_world_plane = makePose(Vec3(0.1, 0.2, 0.3));
  space.workspace = {Vec3(-1, -0.5, 0.29), Vec3(1, 0.5, 0.31)};
  return space;
}

ReconstructionParameters parameters(int touches) {
  ReconstructionParameters parameters;
  parameters.touches = touches;
  return parameters;
}

MotionResult contact() {
  MotionResult result;
  result.end = MotionEnd::kContact;
  return result;
}

TEST(RandomTouches, stayInTheMotionSpaceAndRepeatForASeed) {
  for (const Motion motion : {Motion::kPlanar, Motion::kSpatial}) {
    RandomTouches first(space(motion), 3);
    RandomTouches second(space(motion), 3);
    for (int i = 0; i < 200; ++i) {
      const Path path = *first.nextTouch(Pose::Identity());
      EXPECT_TRUE(space(motion).contains(path.back()));
      EXPECT_TRUE(path.back().isApprox(second.nextTouch(Pose::Identity())->back()));
    }
  }
}

// What lies beside a plane is projected onto it.
TEST(RandomTouches, stayInTheWorkspaceOfATiltedPlane) {
  MotionSpace tilted = space(Motion::kPlanar);
  tilted.workspace = {Vec3(-1, -1, -0.1), Vec3(1, 1, 0.1)};
  tilted.T_world_plane = makePose(Vec3::Zero(), Vec3(M_PI_4, 0, 0));
  RandomTouches touches(tilted, 3);
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(tilted.contains(touches.nextTouch(Pose::Identity())->back()));
  }
}

// The plane passes a workspace that is flat in a line, which no draw hits.
TEST(RandomTouches, endWithoutAPoseWhereThePlaneHardlyPassesTheWorkspace) {
  MotionSpace flat = space(Motion::kPlanar);
  flat.workspace = {Vec3(-1, -1, 0), Vec3(1, 1, 0)};
  flat.T_world_plane = makePose(Vec3::Zero(), Vec3(M_PI_4, 0, 0));
  const Result<Path> touch = RandomTouches(flat, 3).nextTouch(Pose::Identity());
  ASSERT_FALSE(touch);
  EXPECT_NE(touch.reason().find("make it wider"), std::string::npos);
}

TEST(RandomTouches, keepWithinTheHalfTurnOfAnArm) {
  MotionSpace arm = space(Motion::kPlanar);
  arm.full_turns = false;
  const Pose turned = arm.T_world_plane * makePose(Vec3::Zero(), Vec3(0, 0, 3.0));
  const auto leaving = [&](const MotionSpace& asked) {
    RandomTouches touches(asked, 3);
    int count = 0;
    for (int i = 0; i < 200; ++i) {
      if (!arm.allowsTurn(turned, touches.nextTouch(turned)->back())) ++count;
    }
    return count;
  };
  EXPECT_EQ(leaving(arm), 0);
  EXPECT_GT(leaving(space(Motion::kPlanar)), 50);
}

// They are no motions: an arm cannot be at most of the places that are drawn.
TEST(Reconstruct, goesOnPastWhatTheRobotRefuses) {
  MotionResult refusal;
  refusal.end = MotionEnd::kUnreachable;
  ScriptedRobot robot;
  for (int touch = 0; touch < 2; ++touch) {
    robot.script.insert(robot.script.end(), 40, refusal);
    robot.script.push_back(contact());
  }
  RandomTouches touches(space(Motion::kPlanar), 1);
  const RetrievalOutcome outcome = reconstruct(parameters(2), &robot, &touches, {}, {});
  EXPECT_TRUE(outcome.success) << outcome.reason;
  EXPECT_EQ(outcome.collisions, 2);
  robot.script.assign(200, refusal);
  EXPECT_FALSE(reconstruct(parameters(2), &robot, &touches, {}, {}).success);
}

TEST(Reconstruct, countsTouchesUntilTheBudget) {
  ScriptedRobot robot;
  robot.script = {{}, contact(), {}, contact(), contact()};
  RandomTouches touches(space(Motion::kPlanar), 1);
  const RetrievalOutcome outcome = reconstruct(parameters(3), &robot, &touches, {}, {});
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.collisions, 3);
  EXPECT_EQ(outcome.plans, 5);
  EXPECT_EQ(std::count(robot.calls.begin(), robot.calls.end(), "reset"), 3);
}

TEST(Reconstruct, endsInAnEmptyScene) {
  ScriptedRobot robot;
  RandomTouches touches(space(Motion::kPlanar), 1);
  const RetrievalOutcome outcome = reconstruct(parameters(2), &robot, &touches, {}, {});
  EXPECT_FALSE(outcome.success);
  EXPECT_NE(outcome.reason.find("too few touches"), std::string::npos);
}

// A planner that is asked to stop says that it has none; that is not why it ended.
TEST(Reconstruct, saysThatItWasStoppedWhileATouchWasSought) {
  class Stopped : public TouchPlanner {
   public:
    Result<Path> nextTouch(const Pose& /*from*/) override {
      asked = true;
      return Failure{"no answer"};
    }
    bool asked = false;
  };
  ScriptedRobot robot;
  Stopped touches;
  const RetrievalOutcome outcome =
      reconstruct(parameters(2), &robot, &touches, {}, [&] { return touches.asked; });
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.reason, "stopped by the user");
}

TEST(Reconstruct, stopsWhenAskedTo) {
  ScriptedRobot robot;
  RandomTouches touches(space(Motion::kPlanar), 1);
  const RetrievalOutcome outcome =
      reconstruct(parameters(2), &robot, &touches, {}, [] { return true; });
  EXPECT_FALSE(outcome.success);
  EXPECT_TRUE(robot.calls.empty());
}

}  // namespace
}  // namespace smore
