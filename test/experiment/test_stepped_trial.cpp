// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "peg_in_fork.h"
#include "smore/common/result.h"
#include "smore/experiment/stepped_trial.h"

namespace smore {
namespace {

// Noise and perturbation tell seeds apart.
Scenario fork() {
  Scenario scenario = pegInFork();
  scenario.goal = makePose(Vec3(-0.08, 0, 0), Vec3(0, 0, 0.02));
  scenario.workspace = {Vec3(-0.1, -0.4, -0.01), Vec3(0.01, 0.4, 0.01)};
  scenario.wrench_noise.force_stddev = 0.02;
  scenario.wrench_noise.torque_stddev = 0.002;
  scenario.perturb.position = 0.001;
  return scenario;
}

Scenario ballInSpace() {
  Scenario scenario;
  scenario.name = "ball";
  scenario.motion = Motion::kSpatial;
  scenario.object = {{SphereShape{0.05}, Pose::Identity()}};
  scenario.start = makePose(Vec3(0.1, 0.2, 0.3), Vec3(0.3, -0.2, 0.5));
  scenario.goal = makePose(Vec3(0.11, 0.19, 0.32), Vec3(0.3, -0.2, 0.6));
  scenario.workspace = {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
  return scenario;
}

Eigen::VectorXd planar(double x, double y, double yaw) { return Eigen::Vector3d(x, y, yaw); }

Eigen::VectorXd randomAction(std::mt19937_64* random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double x = unit(*random);
  const double y = unit(*random);
  return planar(kLargestShift * x, kLargestShift * y, kLargestTurn * unit(*random));
}

Pose moved(const Pose& pose, const Eigen::VectorXd& action) {
  Pose target = pose;
  target.translation().head<2>() += action.head<2>();
  const Eigen::AngleAxisd turn(action[2], Vec3::UnitZ());
  target.linear() = Eigen::Quaterniond(turn * pose.linear()).normalized().matrix();
  return target;
}

TEST(SteppedTrialTest, feelsForTheSameMotionWhatTheExperimentFeels) {
  constexpr std::uint64_t kSeed = 5;
  SteppedTrial trial(fork(), kSeed);
  const Scenario scene = perturbScenario(fork(), kSeed);
  const auto simulated = makeSimulatedRobot(scene, kSeed);
  InProcessRobot robot(simulated.get(), sensingParameters(scene, *simulated), kSeed,
                       [](const ContactObservation& /*observation*/) {});
  // Along the prongs, then against one.
  for (const auto& action : {planar(-0.03, 0, 0), planar(-0.02, 0, 0), planar(0, 0.02, 0)}) {
    const MotionResult motion = robot.follow({robot.pose(), moved(robot.pose(), action)});
    const StepOutcome outcome = trial.step(action);
    EXPECT_EQ(outcome.end, motion.end);
    EXPECT_EQ(outcome.wrench.force, robot.wrench().force);
    EXPECT_EQ(outcome.wrench.torque, robot.wrench().torque);
    EXPECT_TRUE(outcome.T_world_object.isApprox(robot.pose(), 0.0));
  }
  EXPECT_EQ(trial.collisions(), 1);
  EXPECT_GT(robot.wrench().force.norm(), 4.0);
}

TEST(SteppedTrialTest, doesTheSameFromTheSameSeedAndSomethingElseFromAnother) {
  SteppedTrial first(fork(), 1);
  SteppedTrial same(fork(), 1);
  SteppedTrial other(fork(), 2);
  std::mt19937_64 random(7);
  bool differs = false;
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd action = randomAction(&random);
    const StepOutcome outcome = first.step(action);
    const StepOutcome again = same.step(action);
    EXPECT_EQ(outcome.wrench.force, again.wrench.force);
    EXPECT_EQ(outcome.T_world_object.matrix(), again.T_world_object.matrix());
    differs = differs || outcome.wrench.force != other.step(action).wrench.force;
  }
  EXPECT_EQ(first.time(), same.time());
  EXPECT_GT(first.collisions(), 0);
  EXPECT_TRUE(differs);
}

TEST(SteppedTrialTest, goesBackToTheStartAfterAContact) {
  SteppedTrial trial(fork(), 1);
  const StepOutcome outcome = trial.step(planar(0, 0.03, 0));
  EXPECT_EQ(outcome.end, MotionEnd::kContact);
  EXPECT_FALSE(outcome.at_goal);
  EXPECT_GT(outcome.T_world_object.translation().y(), 0.003);
  EXPECT_EQ(trial.pose().matrix(), fork().start.matrix());
}

TEST(SteppedTrialTest, backsOffAfterAContactWhereTheScenarioSaysSo) {
  Scenario scenario = fork();
  scenario.on_contact = OnContact::kRetreat;
  SteppedTrial trial(scenario, 1);
  for (int i = 0; i < 3; ++i) trial.step(planar(-0.03, 0, 0));
  const double before = trial.pose().translation().x();
  EXPECT_EQ(trial.step(planar(0, 0.03, 0)).end, MotionEnd::kContact);
  EXPECT_EQ(trial.step(planar(0, 0, 0)).end, MotionEnd::kReached);
  EXPECT_GT(trial.pose().translation().x(), before + 0.01);
  EXPECT_LT(trial.pose().translation().x(), -0.01);
}

TEST(SteppedTrialTest, clipsEachNumberOfAnAction) {
  SteppedTrial trial(ballInSpace(), 1);
  Eigen::VectorXd action(6);
  action << 1.0, -0.01, -7.0, 0.0, 0.0, 3.0;
  const StepOutcome outcome = trial.step(action);
  const Vec3 shift = outcome.T_world_object.translation() - ballInSpace().start.translation();
  EXPECT_TRUE(shift.isApprox(Vec3(kLargestShift, -0.01, -kLargestShift), 1e-9));
  EXPECT_NEAR(angleBetween(outcome.T_world_object, ballInSpace().start), kLargestTurn, 1e-9);
}

TEST(SteppedTrialTest, staysInTheWorkspace) {
  SteppedTrial trial(fork(), 1);
  for (int i = 0; i < 10; ++i) trial.step(planar(-0.03, 0, 0));
  EXPECT_NEAR(trial.pose().translation().x(), fork().workspace.min.x(), 1e-12);
  const StepOutcome outcome = trial.step(planar(-0.03, 0, 0.01));
  EXPECT_EQ(outcome.end, MotionEnd::kReached);
  EXPECT_NEAR(angleBetween(outcome.T_world_object, fork().start), 0.01, 1e-9);
}

TEST(SteppedTrialTest, refusesAnActionThatIsNoneAndDoesNotMove) {
  SteppedTrial trial(fork(), 1);
  const double time = trial.time();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(trial.step(planar(-0.01, bad, 0)), InputError);
  }
  EXPECT_THROW(trial.step(Eigen::VectorXd::Zero(6)), InputError);
  EXPECT_THROW(trial.step(Eigen::VectorXd()), InputError);
  EXPECT_EQ(trial.time(), time);
}

TEST(SteppedTrialTest, isAtTheGoalWhereTheDifferenceIsSmall) {
  Scenario scenario = fork();
  scenario.goal_position_tolerance = 0.001;
  scenario.goal_angle_tolerance = 0.001;
  SteppedTrial trial(scenario, 1);
  StepOutcome outcome;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(outcome.at_goal);
    outcome = trial.step(trial.difference());
  }
  EXPECT_TRUE(outcome.at_goal);
  EXPECT_LT(trial.difference().norm(), 1e-9);
}

TEST(SteppedTrialTest, saysTheDifferenceInTheAxesOfTheWorldInSpace) {
  const SteppedTrial trial(ballInSpace(), 1);
  const Scenario scenario = ballInSpace();
  const Eigen::VectorXd difference = trial.difference();
  ASSERT_EQ(difference.size(), 6);
  EXPECT_TRUE(difference.head<3>().isApprox(Vec3(0.01, -0.01, 0.02), 1e-9));
  const Vec3 turn = difference.tail<3>();
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(turn.norm(), turn.normalized()) * scenario.start.linear();
  EXPECT_TRUE(turned.isApprox(scenario.goal.linear(), 1e-9));
}

TEST(SteppedTrialTest, saysTheDifferenceInTheAxesOfATiltedPlane) {
  Scenario scenario = ballInSpace();
  scenario.motion = Motion::kPlanar;
  scenario.goal = scenario.start * makePose(Vec3(0.1, -0.2, 0), Vec3(0, 0, -3.0));
  SteppedTrial trial(scenario, 1);
  EXPECT_TRUE(trial.difference().isApprox(planar(0.1, -0.2, -3.0), 1e-9));
  trial.step(planar(0.03, -0.02, 0.3));
  EXPECT_TRUE(trial.difference().isApprox(planar(0.07, -0.18, 2.0 * M_PI - 3.3), 1e-9));
}

TEST(SteppedTrialTest, keepsTheMapsOfAMethodThatHasSome) {
  EXPECT_THROW(SteppedTrial(fork(), 1, MethodKind::kCspace), InputError);
  EXPECT_THROW(SteppedTrial(fork(), 1).maps(), InputError);
  for (const MethodKind kind : {MethodKind::kPaper, MethodKind::kSmore}) {
    SteppedTrial trial(fork(), 1, kind);
    trial.step(planar(0, 0.03, 0));
    const std::size_t known = trial.maps().world().size();
    EXPECT_GT(known, 0U);
    trial.restart();
    EXPECT_GE(trial.maps().world().size(), known);
  }
}

TEST(SteppedTrialTest, refusesATaskWithoutAScene) {
  Scenario task = fork();
  task.object.clear();
  task.environment.clear();
  EXPECT_THROW(SteppedTrial(task, 1), InputError);
}

TEST(SteppedTrialTest, refusesATaskWithoutAGoal) {
  Scenario scene = fork();
  scene.task = Task::kReconstruct;
  EXPECT_THROW(SteppedTrial(scene, 1), InputError);
}

}  // namespace
}  // namespace smore
