// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "arm_scenes.h"
#include "contact_trials.h"
#include "smore/common/result.h"

namespace smore {
namespace {

Scenario farScene(Motion motion) {
  const Shape ball{SphereShape{0.1}, makePose(Vec3(2, 0, 0), Vec3(0.1, 0.2, 0.3))};
  Scenario scenario = sceneOf(sShape(), {ball});
  scenario.motion = motion;
  scenario.perturb = {0.015, 0.05};
  return scenario;
}

TEST(Perturbation, planarStaysInThePlaneOfTheStart) {
  Scenario scenario = farScene(Motion::kPlanar);
  scenario.start = makePose(Vec3(-1, 0, 0), Vec3(M_PI_2, 0, 0));  // its z axis is the world's -y
  Vec3 least = Vec3::Constant(1.0);
  Vec3 most = -least;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Scenario perturbed = perturbScenario(scenario, seed);
    const Vec3 shift = perturbed.environment[0].pose.translation() - Vec3(2, 0, 0);
    least = least.cwiseMin(shift);
    most = most.cwiseMax(shift);
    const Eigen::AngleAxisd turn(perturbed.object[1].pose.linear());
    EXPECT_LE(turn.angle(), 0.05);
    EXPECT_NEAR(std::abs(turn.axis().z()), 1.0, 1e-9);
    EXPECT_NEAR(perturbed.object[1].pose.translation().norm(), 0.0, 1e-12);
  }
  for (const int axis : {0, 2}) {
    EXPECT_LT(least[axis], -0.014);
    EXPECT_GT(most[axis], 0.014);
    EXPECT_GE(least[axis], -0.015);
    EXPECT_LE(most[axis], 0.015);
  }
  EXPECT_NEAR(least.y(), 0.0, 1e-12);
  EXPECT_NEAR(most.y(), 0.0, 1e-12);
}

TEST(Perturbation, spatialUsesAllAxes) {
  Vec3 most = Vec3::Zero();
  Vec3 most_turn = Vec3::Zero();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Scenario perturbed = perturbScenario(farScene(Motion::kSpatial), seed);
    const Eigen::AngleAxisd turn(perturbed.object[0].pose.linear());
    EXPECT_LE(turn.angle(), 0.05);
    most_turn = most_turn.cwiseMax((turn.angle() * turn.axis()).cwiseAbs());
    most = most.cwiseMax((perturbed.environment[0].pose.translation() - Vec3(2, 0, 0)).cwiseAbs());
  }
  EXPECT_LE(most.maxCoeff(), 0.015);
  EXPECT_GT(most.minCoeff(), 0.014);
  EXPECT_GT(most_turn.minCoeff(), 0.03);
}

TEST(Perturbation, theSeedDecides) {
  const Scenario scenario = farScene(Motion::kSpatial);
  const auto shift = [&scenario](std::uint64_t seed) {
    return Vec3(perturbScenario(scenario, seed).environment[0].pose.translation());
  };
  EXPECT_EQ(shift(3), shift(3));
  EXPECT_NE(shift(3), shift(4));
}

TEST(Perturbation, isDrawnUntilStartAndGoalAreFree) {
  const Shape wall{BoxShape{Vec3(0.1, 2, 2)}, makePose(Vec3(0.265, 0, 0))};
  Scenario scenario = sceneOf(sShape(), {wall});  // 5 mm of clearance at the goal
  scenario.goal = Pose::Identity();
  scenario.perturb = {0.02, 0.0};
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scenario perturbed = perturbScenario(scenario, seed);
    EXPECT_NO_THROW(checkStartAndGoalFree(perturbed));
    EXPECT_GT(perturbed.environment[0].pose.translation().x(), 0.26);
  }
}

TEST(Perturbation, givesUpWithAReason) {
  const Shape wall{BoxShape{Vec3(0.1, 2, 2)}, Pose::Identity()};
  Scenario scenario = sceneOf(sShape(), {wall});
  scenario.goal = Pose::Identity();
  const auto problemOf = [](const Scenario& asked) -> std::string {
    try {
      perturbScenario(asked, 1);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(problemOf(scenario).find("goal: the object touches"), std::string::npos)
      << "without any perturbation";
  // In a frame with 0.3 mm to spare.
  std::vector<Shape> frame;
  for (const double side : {-1.0, 1.0}) {
    frame.push_back({BoxShape{Vec3(0.1, 1, 1)}, makePose(Vec3(0.1003 * side, 0, 0))});
    frame.push_back({BoxShape{Vec3(1, 0.1, 1)}, makePose(Vec3(0, 0.1003 * side, 0))});
  }
  Scenario tight = sceneOf({{BoxShape{Vec3(0.1, 0.1, 0.1)}, Pose::Identity()}}, frame);
  tight.start = tight.goal = Pose::Identity();
  tight.perturb = {0.09, 0.0};
  EXPECT_NE(problemOf(tight).find("lower perturb.position"), std::string::npos);
}

// Turned about an origin that is far from the handle, the gripper would miss the handle.
TEST(Perturbation, leavesTheObjectInTheGripper) {
  Scenario scenario = ballInHand(makePose(Vec3(0.45, 0.1, 0.2)));
  const Pose T_ball_origin = makePose(Vec3(0.0, 0.0, -0.15));
  for (Shape& shape : scenario.object) shape.pose = T_ball_origin.inverse() * shape.pose;
  scenario.T_gripper_object = scenario.T_gripper_object * T_ball_origin;
  scenario.start = scenario.goal = scenario.start * T_ball_origin;
  scenario.workspace.min += T_ball_origin.translation();
  scenario.workspace.max += T_ball_origin.translation();
  scenario.perturb = {0.0, 0.4};
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario perturbed = perturbScenario(scenario, seed);
    EXPECT_NO_THROW((void)makeSimulatedRobot(perturbed, seed));
    most = std::max(most, angleBetween(perturbed.object[0].pose, scenario.object[0].pose));
  }
  EXPECT_GT(most, 0.01);
}

TEST(StartAndGoal, areNamedWhereTheyTouch) {
  Scenario scenario = sceneOf(sShape(), {{SphereShape{0.05}, Pose::Identity()}});
  EXPECT_NO_THROW(makeSimulatedRobot(scenario, 1));
  scenario.goal = makePose(Vec3(0, 0.05, 0));
  try {
    makeSimulatedRobot(scenario, 1);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("trial: goal: the object touches"), std::string::npos) << text;
    EXPECT_EQ(text.find("start:"), std::string::npos) << text;
  }
}

TEST(StartAndGoal, withinAHollowConcaveMeshTouch) {
  // A tetrahedron with one face pushed in: concave, so that it is a surface to the physics engine.
  MeshShape mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.9, 0.9, 0.9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
  Scenario scenario = sceneOf({{SphereShape{0.05}, Pose::Identity()}}, {{mesh, Pose::Identity()}});
  SceneCheck check(scenario);
  EXPECT_TRUE(check.touches(makePose(Vec3(0.4, 0.4, 0.4))));
  EXPECT_FALSE(check.touches(makePose(Vec3(1.2, 1.2, 1.2))));
  EXPECT_TRUE(check.touches(makePose(Vec3(-0.04, 0.5, 0.5))));
}

// A U with a peg of 3 cm radius in its notch, 20 cm wide: the hull would touch it everywhere.
TEST(SceneCheck, aConcaveObjectTouchesWithItsParts) {
  SceneCheck check(loadScenario(SMORE_SOURCE_DIR "/test/data/cases/ngon/u_object.yaml"));
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_FALSE(check.touches(makePose(Vec3(sign * 0.069, 0, 0))));
    EXPECT_TRUE(check.touches(makePose(Vec3(sign * 0.071, 0, 0))));
  }
  EXPECT_FALSE(check.touches(makePose(Vec3(0, 0.119, 0))));
  EXPECT_TRUE(check.touches(makePose(Vec3(0, 0.121, 0))));
}

// The collision geometry against distances of points strewn over the object.
TEST(SceneCheck, agreesWithSampledPointsOfTheObject) {
  RandomContacts trials(11);
  int touching = 0;
  for (int i = 0; i < 100; ++i) {
    const Scenario scenario = trials.scene();
    SceneCheck check(scenario);
    Pose pose = scenario.start;
    pose.translation() *= trials.uniform(0.0, 1.0);
    double least = 1.0;
    for (int k = 0; k < 20000; ++k) {
      const Shape& bar = scenario.object[static_cast<size_t>(k % 5)];
      const Vec3 cube(trials.uniform(-0.5, 0.5), trials.uniform(-0.5, 0.5),
                      trials.uniform(-0.5, 0.5));
      const Vec3 point = bar.pose * cube.cwiseProduct(std::get<BoxShape>(bar.geometry).size);
      least = std::min(least, signedDistance(scenario.environment, pose * point));
    }
    constexpr double kSampling = 0.01;  // spacing of the points
    const bool touches = check.touches(pose);
    EXPECT_TRUE(touches || least >= 0.0);
    EXPECT_TRUE(!touches || least <= kSampling);
    touching += least < 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, 20);
  EXPECT_LT(touching, 80);
}

TEST(ShippedScenarios, startAndGoalAreFreeInAllOfThemAndInTheirTrials) {
  for (const auto& entry :
       std::filesystem::directory_iterator(SMORE_SOURCE_DIR "/config/scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    const Scenario scenario = loadScenario(entry.path().string());
    EXPECT_NO_THROW(checkStartAndGoalFree(scenario));
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      EXPECT_NO_THROW(perturbScenario(scenario, seed));
  }
}

}  // namespace
}  // namespace smore
