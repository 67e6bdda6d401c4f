// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "maze.h"
#include "smore/planning/free_pose_voxels.h"
#include "smore/planning/map_planner.h"

namespace smore {
namespace {

constexpr double kVoxelSize = 0.03;

/// Maps that a test writes by hand.
class GivenMap : public TwinMap {
 public:
  const VoxelGrid& world() const override { return world_; }
  const VoxelGrid& object() const override { return object_; }
  std::uint64_t revision() const override { return 0; }
  void observe(const ContactObservation&) override {}

  void addWorld(const OccupiedVoxels& voxels, float probability) {
    for (const VoxelKey& key : voxels.keys) world_.set(key, probability);
  }
  void addObject(const OccupiedVoxels& voxels, float probability) {
    for (const VoxelKey& key : voxels.keys) object_.set(key, probability);
  }

 private:
  VoxelGrid world_{kVoxelSize};
  VoxelGrid object_{kVoxelSize};
};

MotionSpace room() {
  MotionSpace space;
  space.workspace = {Vec3(-0.6, -0.4, -0.01), Vec3(0.6, 0.4, 0.01)};
  return space;
}

const Pose kStart = makePose(Vec3(-0.42, 0.0, 0.0), Vec3(0, 0, M_PI / 2));
const Pose kGoal = makePose(Vec3(0.42, 0.0, 0.0), Vec3(0, 0, M_PI / 2));

MapPlannerParameters generous(CollisionBackend backend) {
  MapPlannerParameters parameters;
  parameters.backend = backend;
  parameters.path.algorithm = PlannerAlgorithm::kRrtConnect;
  parameters.path.max_iterations = 100000;
  return parameters;
}

class MapPlannerTest : public testing::TestWithParam<CollisionBackend> {};

TEST_P(MapPlannerTest, goesStraightWhereNothingIsKnown) {
  const GivenMap map;
  MapPlanner planner(map, room(), generous(GetParam()), 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan) << plan.reason();
  EXPECT_EQ(plan->path.back().matrix(), kGoal.matrix());
  EXPECT_EQ(plan->risk, 0.0);
}

TEST_P(MapPlannerTest, avoidsVoxelsFromOneHalfOn) {
  GivenMap map;
  map.addObject(oracle::voxelize(oracle::bar(), kVoxelSize), 0.5F);
  map.addWorld(oracle::voxelize(oracle::slalom(), kVoxelSize), 0.5F);
  MapPlanner planner(map, room(), generous(GetParam()), 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan) << plan.reason();
  const OccupiedVoxels object = occupiedVoxels(map.object());
  const OccupiedVoxels world = occupiedVoxels(map.world());
  for (const Pose& pose : densify(plan->path, 0.002, 0.01)) {
    ASSERT_LE(oracle::deepestOverlap(object, world, pose), 0.05 * kVoxelSize);
  }
}

TEST_P(MapPlannerTest, passesThroughVoxelsBelowOneHalf) {
  GivenMap map;
  map.addObject(oracle::voxelize(oracle::bar(), kVoxelSize), 0.49F);
  map.addWorld(oracle::voxelize(oracle::slalom(), kVoxelSize), 0.99F);
  MapPlanner planner(map, room(), generous(GetParam()), 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan) << plan.reason();
}

TEST_P(MapPlannerTest, leavesAStartWhoseVoxelsOverlap) {
  GivenMap map;
  map.addObject(oracle::voxelize(oracle::bar(), kVoxelSize), 0.9F);
  map.addWorld(oracle::voxelize({{{-0.45, -0.06, -0.03}, {-0.39, 0.0, 0.03}}}, kVoxelSize), 0.6F);
  const OccupiedVoxels object = occupiedVoxels(map.object());
  const OccupiedVoxels world = occupiedVoxels(map.world());
  ASSERT_GT(oracle::deepestOverlap(object, world, kStart), 0.5 * kVoxelSize);
  MapPlanner planner(map, room(), generous(GetParam()), 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_TRUE(plan) << plan.reason();
}

TEST_P(MapPlannerTest, aStartWithoutOverlapTakesNothingAway) {
  GivenMap map;
  map.addObject(oracle::voxelize(oracle::bar(), kVoxelSize), 0.5F);
  map.addWorld(oracle::voxelize(oracle::slalom(), kVoxelSize), 0.5F);
  const TwinVoxels voxels = voxelsGivenFree(map.object(), map.world(), kStart);
  EXPECT_EQ(voxels.object.keys.size(), map.object().size());
  EXPECT_EQ(voxels.world.keys.size(), map.world().size());
}

TEST_P(MapPlannerTest, saysWhenTheGoalIsOccupied) {
  GivenMap map;
  map.addObject(oracle::voxelize(oracle::bar(), kVoxelSize), 0.9F);
  map.addWorld(oracle::voxelize({{{0.36, -0.06, -0.03}, {0.48, 0.0, 0.03}}}, kVoxelSize), 0.9F);
  MapPlanner planner(map, room(), generous(GetParam()), 1);
  const auto plan = planner.plan(kStart, kGoal);
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.reason().find("goal"), std::string::npos) << plan.reason();
}

TEST_P(MapPlannerTest, refusesAShareOfOverlapOutOfRange) {
  const GivenMap map;
  MapPlannerParameters parameters = generous(GetParam());
  parameters.overlap_share = 0.0;
  EXPECT_THROW(MapPlanner(map, room(), parameters, 1), std::invalid_argument);
}

/// By trying all sets; for a handful of positions.
double lightestByEnumeration(const std::set<PositionPair>& pairs, const std::vector<double>& left,
                             const std::vector<double>& right) {
  double best = std::numeric_limits<double>::infinity();
  const std::size_t count = left.size() + right.size();
  for (std::size_t set = 0; set < (std::size_t{1} << count); ++set) {
    const bool covers = std::all_of(pairs.begin(), pairs.end(), [&](const PositionPair& pair) {
      return ((set >> pair.first) & 1) != 0 || ((set >> (left.size() + pair.second)) & 1) != 0;
    });
    if (!covers) continue;
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (((set >> i) & 1) != 0) weight += i < left.size() ? left[i] : right[i - left.size()];
    }
    best = std::min(best, weight);
  }
  return best;
}

TEST(LightestCoverTest, agreesWithEnumeration) {
  std::mt19937 engine(1);
  std::uniform_int_distribution<int> weight(1, 20);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> left(5);
    std::vector<double> right(6);
    for (double& value : left) value = weight(engine);
    for (double& value : right) value = weight(engine);
    std::set<PositionPair> pairs;
    for (int i = 0; i < 3 + trial % 15; ++i) pairs.insert({engine() % 5, engine() % 6});
    const PairCover cover = lightestCover(pairs, left, right);
    double total = 0.0;
    for (const std::uint32_t position : cover.left) total += left[position];
    for (const std::uint32_t position : cover.right) total += right[position];
    for (const PositionPair& pair : pairs) {
      EXPECT_TRUE(cover.left.count(pair.first) + cover.right.count(pair.second) > 0);
    }
    ASSERT_EQ(total, lightestByEnumeration(pairs, left, right)) << "trial " << trial;
  }
}

TEST(FreePoseVoxelsTest, theLessProbableSideGivesWay) {
  GivenMap map;
  map.addObject({kVoxelSize, {{0, 0, 0}, {9, 0, 0}}}, 0.9F);
  map.addWorld({kVoxelSize, {{0, 0, 0}, {0, 9, 0}}}, 0.6F);
  const TwinVoxels voxels = voxelsGivenFree(map.object(), map.world(), Pose::Identity());
  EXPECT_EQ(voxels.object.keys.size(), 2U);
  EXPECT_EQ(voxels.world.keys, (std::vector<VoxelKey>{{0, 9, 0}}));
}

INSTANTIATE_TEST_SUITE_P(Backends, MapPlannerTest,
                         testing::Values(CollisionBackend::kFcl, CollisionBackend::kGrid));

}  // namespace
}  // namespace smore
