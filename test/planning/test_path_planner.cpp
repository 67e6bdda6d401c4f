// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "maze.h"
#include "smore/planning/fcl_collision_checker.h"
#include "smore/planning/grid_collision_checker.h"
#include "smore/planning/path_planner.h"

namespace smore {
namespace {

constexpr double kVoxelSize = 0.03;
constexpr double kDepth = 0.045 * kVoxelSize;

/// A planning problem among voxels.
struct Problem {
  OccupiedVoxels object;
  OccupiedVoxels world;
  MotionSpace space;
  Pose start;
  Pose goal;
};

Problem planarProblem() {
  Problem problem;
  problem.object = oracle::voxelize(oracle::bar(), kVoxelSize);
  problem.world = oracle::voxelize(oracle::slalom(), kVoxelSize);
  problem.space.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.6, 0.4, 0.01)};
  problem.start = makePose(Vec3(-0.42, 0.0, 0.0), Vec3(0, 0, M_PI / 2));
  problem.goal = makePose(Vec3(0.42, 0.0, 0.0), Vec3(0, 0, M_PI / 2));
  return problem;
}

Problem spatialProblem() {
  Problem problem;
  problem.object = oracle::voxelize(oracle::bar(), kVoxelSize);
  problem.world = oracle::voxelize(oracle::slottedWall(), kVoxelSize);
  problem.space.motion = Motion::kSpatial;
  problem.space.workspace = {Vec3(-0.5, -0.3, -0.3), Vec3(0.5, 0.3, 0.3)};
  problem.start = makePose(Vec3(-0.36, 0.1, 0.05), Vec3(0.3, 0.2, M_PI / 2));
  problem.goal = makePose(Vec3(0.36, -0.1, 0.0), Vec3(0, M_PI / 2, 0));
  return problem;
}

Result<Path> solve(const Problem& problem, const CollisionChecker& checker,
                   const PathPlannerParameters& parameters, std::uint32_t seed) {
  PathPlanner planner(problem.space, parameters, seed);
  return planner.plan(
      problem.start, problem.goal, [&](const Pose& pose) { return !checker.inCollision(pose); },
      [&](const Pose& from, const Pose& to) { return isMotionFree(checker, from, to, kDepth); });
}

/// The promise: looked at 20 times more finely than a step of a tenth of a voxel, no overlap is
/// deeper than 5 % of the voxel size.
void expectFree(const Problem& problem, const Path& path) {
  const double spacing = 0.1 * kVoxelSize / 20.0;
  const GridCollisionChecker checker(problem.object, problem.world);
  for (const Pose& pose : densify(path, spacing, spacing / checker.objectRadius())) {
    ASSERT_TRUE(problem.space.contains(pose));
    if (checker.clearance(pose, kVoxelSize) > 0.0) continue;
    ASSERT_LE(oracle::deepestOverlap(problem.object, problem.world, pose), 0.05 * kVoxelSize);
  }
}

void expectEnds(const Problem& problem, const Path& path) {
  EXPECT_EQ(path.front().matrix(), problem.start.matrix());
  EXPECT_EQ(path.back().matrix(), problem.goal.matrix());
}

class PathPlannerMazeTest
    : public testing::TestWithParam<std::tuple<PlannerAlgorithm, Motion, bool>> {};

TEST_P(PathPlannerMazeTest, pathsKeepTheirPromise) {
  const auto [algorithm, motion, by_fcl] = GetParam();
  const Problem problem = motion == Motion::kPlanar ? planarProblem() : spatialProblem();
  std::unique_ptr<CollisionChecker> checker;
  if (by_fcl) {
    checker = std::make_unique<FclCollisionChecker>(problem.object, problem.world);
  } else {
    checker = std::make_unique<GridCollisionChecker>(problem.object, problem.world);
  }
  PathPlannerParameters parameters;
  parameters.algorithm = algorithm;
  parameters.max_iterations = 100000;
  parameters.step = motion == Motion::kPlanar ? 0.03 : 0.2;
  const std::uint32_t seeds = by_fcl ? 1 : 2;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const auto path = solve(problem, *checker, parameters, seed);
    ASSERT_TRUE(path) << path.reason();
    expectEnds(problem, *path);
    expectFree(problem, *path);
    for (std::size_t i = 1; i < path->size(); ++i) {
      const Pose& from = (*path)[i - 1];
      const Pose& to = (*path)[i];
      ASSERT_LE(distanceBetween(from, to) + angleBetween(from, to), parameters.step + 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllMazes, PathPlannerMazeTest,
    testing::Combine(testing::Values(PlannerAlgorithm::kRrt, PlannerAlgorithm::kRrtConnect),
                     testing::Values(Motion::kPlanar, Motion::kSpatial), testing::Bool()));

TEST(PathPlannerTest, fixedStepsKeepThePromiseToo) {
  const Problem problem = planarProblem();
  const GridCollisionChecker checker(problem.object, problem.world);
  PathPlannerParameters parameters;
  parameters.algorithm = PlannerAlgorithm::kRrtConnect;
  PathPlanner planner(problem.space, parameters, 1);
  // A tenth of a voxel, half of it by the turn.
  const CheckResolution resolution{0.045 * kVoxelSize, 0.045 * kVoxelSize / checker.objectRadius()};
  const auto path = planner.plan(
      problem.start, problem.goal, [&](const Pose& pose) { return !checker.inCollision(pose); },
      resolution);
  ASSERT_TRUE(path) << path.reason();
  expectFree(problem, *path);
}

class TiltedPlaneTest : public testing::TestWithParam<Vec3> {};

TEST_P(TiltedPlaneTest, motionStaysInThePlaneAndTheBox) {
  const Pose T_world_plane = makePose(Vec3(0.3, -0.2, 0.5), GetParam());
  MotionSpace space;
  space.T_world_plane = T_world_plane;
  space.workspace = {Vec3(-0.4, -0.9, -0.2), Vec3(1.0, 0.5, 1.2)};
  const Pose goal = T_world_plane * makePose(Vec3(-0.25, 0.2, 0.0), Vec3(0, 0, 2.5));
  const auto valid = [&](const Pose& pose) {
    const Vec3 in_plane = T_world_plane.inverse() * pose.translation();
    return (in_plane - Vec3(-0.12, 0.1, 0.0)).norm() > 0.05;
  };
  for (const auto algorithm : {PlannerAlgorithm::kRrt, PlannerAlgorithm::kRrtConnect}) {
    PathPlannerParameters parameters;
    parameters.algorithm = algorithm;
    PathPlanner planner(space, parameters, 3);
    const auto path = planner.plan(T_world_plane, goal, valid, CheckResolution());
    ASSERT_TRUE(path) << path.reason();
    for (const Pose& pose : *path) EXPECT_TRUE(space.contains(pose));
  }
}

INSTANTIATE_TEST_SUITE_P(Tilts, TiltedPlaneTest,
                         testing::Values(Vec3(0, 0, 0), Vec3(M_PI, 0, 0), Vec3(0.4, 0, 0.7),
                                         Vec3(0, M_PI / 2, 0), Vec3(-0.8, 0.6, 2.0)));

const Bounds kRoom{Vec3(-1, -1, 0), Vec3(1, 1, 0)};

Result<Path> planInRoom(const Pose& start, const Pose& goal, const StateValidity& valid,
                        const PathPlannerParameters& parameters = {}, std::uint32_t seed = 1) {
  MotionSpace space;
  space.workspace = kRoom;
  return PathPlanner(space, parameters, seed).plan(start, goal, valid, CheckResolution());
}

bool everywhere(const Pose&) { return true; }

void expectReason(const Result<Path>& path, const std::string& part) {
  ASSERT_FALSE(path);
  EXPECT_NE(path.reason().find(part), std::string::npos) << path.reason();
}

TEST(PathPlannerTest, saysWhatIsWrongWithTheEnds) {
  const Pose goal = makePose(Vec3(0.5, 0, 0));
  const Pose outside = makePose(Vec3(1.5, 0, 0));
  expectReason(planInRoom(outside, goal, everywhere), "the start (1.5 0 0) is outside");
  expectReason(planInRoom(goal, outside, everywhere), "the goal (1.5 0 0) is outside");
  const auto left = [](const Pose& pose) { return pose.translation().x() < 0.2; };
  expectReason(planInRoom(goal, Pose::Identity(), left), "the start (0.5 0 0) is in collision");
  expectReason(planInRoom(Pose::Identity(), goal, left), "the goal (0.5 0 0) is in collision");
  expectReason(planInRoom(Pose::Identity(), makePose(Vec3::Zero(), Vec3(0.1, 0, 0)), everywhere),
               "beside the plane of motion");
  Pose not_a_pose = goal;
  not_a_pose.translation().x() = std::nan("");
  expectReason(planInRoom(Pose::Identity(), not_a_pose, everywhere), "the goal is not finite");
}

TEST(PathPlannerTest, beginsWhereAnArmStandsBesideThePlane) {
  const Pose beside = makePose(Vec3(0, 0, 0.002), Vec3(0.01, 0, 0));
  const auto path = planInRoom(beside, makePose(Vec3(0.5, 0, 0)), everywhere);
  ASSERT_TRUE(path) << path.reason();
  EXPECT_TRUE(path->front().isApprox(beside));
}

bool besideWall(const Pose& pose) { return std::abs(pose.translation().x() - 0.25) > 0.05; }

TEST(PathPlannerTest, saysThatTheSamplesAreUsedUp) {
  for (const auto algorithm : {PlannerAlgorithm::kRrt, PlannerAlgorithm::kRrtConnect}) {
    PathPlannerParameters parameters;
    parameters.algorithm = algorithm;
    parameters.max_iterations = 300;
    expectReason(planInRoom(Pose::Identity(), makePose(Vec3(0.5, 0, 0)), besideWall, parameters),
                 "no path to the goal after 300 samples");
  }
}

TEST(PathPlannerTest, saysThatTheTimeIsUp) {
  PathPlannerParameters parameters;
  parameters.max_iterations = 1000000000;
  parameters.time_limit_s = 0.02;
  expectReason(planInRoom(Pose::Identity(), makePose(Vec3(0.5, 0, 0)), besideWall, parameters),
               "within the time limit of 0.02 s");
}

TEST(PathPlannerTest, reachesAGoalThatIsTheStart) {
  const Pose here = makePose(Vec3(0.3, 0.2, 0), Vec3(0, 0, 1));
  for (const auto algorithm : {PlannerAlgorithm::kRrt, PlannerAlgorithm::kRrtConnect}) {
    PathPlannerParameters parameters;
    parameters.algorithm = algorithm;
    const auto path = planInRoom(here, here, everywhere, parameters);
    ASSERT_TRUE(path) << path.reason();
    EXPECT_EQ(path->back().matrix(), here.matrix());
    EXPECT_NEAR(pathLength(*path), 0.0, 1e-6);
  }
}

TEST(PathPlannerTest, refusesParametersOutOfRange) {
  PathPlannerParameters parameters;
  parameters.step = 0.0;
  EXPECT_THROW(PathPlanner({}, parameters, 1), std::invalid_argument);
  parameters = {};
  parameters.goal_bias = 1.1;
  EXPECT_THROW(PathPlanner({}, parameters, 1), std::invalid_argument);
  parameters = {};
  parameters.max_iterations = 0;
  EXPECT_THROW(PathPlanner({}, parameters, 1), std::invalid_argument);
}

bool samePath(const Path& a, const Path& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Pose& p, const Pose& q) { return p.matrix() == q.matrix(); });
}

TEST(PathPlannerTest, aSeedGivesOnePathOnAnyNumberOfThreads) {
  const auto wall_with_gap = [](const Pose& pose) {
    return besideWall(pose) || pose.translation().y() > 0.3;
  };
  for (const auto algorithm : {PlannerAlgorithm::kRrt, PlannerAlgorithm::kRrtConnect}) {
    const auto run = [&](std::uint32_t seed) {
      PathPlannerParameters parameters;
      parameters.algorithm = algorithm;
      parameters.max_iterations = 100000;
      const auto path =
          planInRoom(Pose::Identity(), makePose(Vec3(0.5, 0, 0)), wall_with_gap, parameters, seed);
      return path ? *path : Path();
    };
    const Path alone = run(11);
    ASSERT_FALSE(alone.empty());
    std::vector<Path> paths(4);
    std::vector<std::thread> threads;
    for (std::uint32_t i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] { paths[i] = run(i == 3 ? 12 : 11); });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(samePath(alone, paths[i]));
    EXPECT_FALSE(samePath(alone, paths[3]));
  }
}

TEST(PathPlannerTest, writesNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  planInRoom(Pose::Identity(), makePose(Vec3(0.5, 0, 0)), everywhere);
  PathPlannerParameters parameters;
  parameters.max_iterations = 1;
  planInRoom(Pose::Identity(), makePose(Vec3(0.5, 0, 0)), besideWall, parameters);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace smore
