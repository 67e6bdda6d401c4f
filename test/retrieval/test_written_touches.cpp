// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../scenario/temporary_directory.h"
#include "scripted_robot.h"
#include "smore/common/result.h"
#include "smore/retrieval/reconstruction.h"
#include "smore/retrieval/written_touches.h"

namespace smore {
namespace {

MotionSpace cube() {
  MotionSpace space;
  space.motion = Motion::kSpatial;
  space.workspace = {Vec3::Constant(-1), Vec3::Constant(1)};
  return space;
}

std::string problemOf(const std::string& text) {
  const TemporaryDirectory directory;
  try {
    loadMotions(directory.write("touches.yaml", text), cube());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WrittenTouches, areReadPoseByPose) {
  const TemporaryDirectory directory;
  const auto motions = loadMotions(directory.write("touches.yaml", R"(
motions:
- poses:
  - {position: [0.1, 0.2, 0.3], rpy: [0, 1.5, 0]}
  - {position: [-0.1, 0.2, 0.3]}
- poses: [{position: [0, 0, 1]}]
)"),
                                   cube());
  ASSERT_EQ(motions.size(), 2U);
  ASSERT_EQ(motions[0].size(), 2U);
  EXPECT_TRUE(motions[0][0].isApprox(makePose(Vec3(0.1, 0.2, 0.3), Vec3(0, 1.5, 0))));
  EXPECT_TRUE(motions[0][1].isApprox(makePose(Vec3(-0.1, 0.2, 0.3))));
  EXPECT_TRUE(motions[1][0].isApprox(makePose(Vec3(0, 0, 1))));
}

TEST(WrittenTouches, tellAllThatIsWrongWithTheirFile) {
  const std::string problem = problemOf(R"(
motions:
- poses: [{position: [0, 0, 0]}, {position: [0, 3, 0]}]
- poses: [{place: [0, 0, 0]}]
)");
  EXPECT_NE(problem.find("(0 3 0) is outside of the workspace"), std::string::npos) << problem;
  EXPECT_NE(problem.find("place: unknown key"), std::string::npos) << problem;
  EXPECT_NE(problemOf("motions: []").find("motions"), std::string::npos);
}

TEST(WrittenTouches, beginWhereTheRobotIsAndGoOnAfterAContact) {
  const Pose first = makePose(Vec3(0, 0, 0.5));
  const Pose second = makePose(Vec3(0, 0.5, 0));
  const Pose from = makePose(Vec3(0.2, 0, 0));
  WrittenTouches touches({{first, second}, {second}});
  const Path path = *touches.nextTouch(from);
  ASSERT_EQ(path.size(), 3U);
  EXPECT_TRUE(path[0].isApprox(from));
  EXPECT_TRUE(path[1].isApprox(first));
  EXPECT_TRUE(path[2].isApprox(second));
  EXPECT_EQ(touches.nextTouch(first)->size(), 2U);
  EXPECT_TRUE(touches.nextTouch(first)->empty());
}

TEST(WrittenTouches, endATrialThatHasTouchesLeft) {
  MotionResult contact;
  contact.end = MotionEnd::kContact;
  ScriptedRobot robot;
  robot.script = {contact, {}, contact};
  const Pose pose = makePose(Vec3(0, 0, 0.5));
  WrittenTouches touches({{pose}, {pose}, {pose}});
  ReconstructionParameters parameters;
  parameters.touches = 10;
  const RetrievalOutcome outcome = reconstruct(parameters, &robot, &touches, {}, {});
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.collisions, 2);
  EXPECT_EQ(outcome.reason, "no touch is left that is worth making");
}

}  // namespace
}  // namespace smore
