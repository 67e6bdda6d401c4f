// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <octomap/OcTree.h>

#include "smore/planning/fcl_collision_checker.h"
#include "smore/planning/grid_collision_checker.h"
#include "smore/planning/path_planner.h"
#include "voxel_oracle.h"

namespace smore {
namespace {

OccupiedVoxels object(double voxel_size) { return oracle::voxelize(oracle::sShape(), voxel_size); }

OccupiedVoxels world(double voxel_size) { return oracle::voxelize(oracle::twoPegs(), voxel_size); }

/// FCL's octree against octree as it comes: trees around their own origins, no contacts.
class PlainFcl {
 public:
  PlainFcl(const OccupiedVoxels& object_voxels, const OccupiedVoxels& world_voxels)
      : object_(makeTree(object_voxels)), world_(makeTree(world_voxels)) {}

  bool inCollision(const Pose& T_world_object) const {
    fcl::CollisionResultd result;
    return fcl::collide(object_.get(), T_world_object, world_.get(), Pose::Identity(),
                        fcl::CollisionRequestd(), result) > 0;
  }

 private:
  static std::shared_ptr<fcl::OcTreed> makeTree(const OccupiedVoxels& voxels) {
    auto tree = std::make_shared<octomap::OcTree>(voxels.voxel_size);
    for (const Vec3& center : centersOf(voxels)) {
      tree->setNodeValue(center.x(), center.y(), center.z(), 1.0F, true);
    }
    tree->updateInnerOccupancy();
    return std::make_shared<fcl::OcTreed>(tree);
  }

  std::shared_ptr<fcl::OcTreed> object_;
  std::shared_ptr<fcl::OcTreed> world_;
};

/// The S-shape at random poses about two pegs. Arguments: voxel size [mm], planar or not.
template <typename Checker>
void checkPose(benchmark::State& state) {
  const double voxel_size = 0.001 * static_cast<double>(state.range(0));
  const Checker checker(object(voxel_size), world(voxel_size));
  oracle::PoseSource source(1, 0.4, state.range(1) != 0);
  std::vector<Pose> poses;
  for (int i = 0; i < 5000; ++i) poses.push_back(source.next());
  std::size_t next = 0;
  std::int64_t collisions = 0;
  for (auto _ : state) {
    collisions += checker.inCollision(poses[next++ % poses.size()]) ? 1 : 0;
  }
  state.counters["share_in_collision"] =
      static_cast<double>(collisions) / static_cast<double>(state.iterations());
}

/// Motions of one planner step from free poses among the pegs. Arguments: as checkPose.
template <typename Checker>
void checkMotion(benchmark::State& state) {
  const double voxel_size = 0.001 * static_cast<double>(state.range(0));
  const Checker checker(object(voxel_size), world(voxel_size));
  oracle::PoseSource source(1, 0.4, state.range(1) != 0);
  std::vector<std::pair<Pose, Pose>> motions;
  while (motions.size() < 2000) {
    const Pose from = source.next();
    if (checker.inCollision(from)) continue;
    const Pose to = source.next();
    const double length = distanceBetween(from, to) + angleBetween(from, to);
    motions.emplace_back(from, interpolate(from, to, 0.03 / length));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [from, to] = motions[next++ % motions.size()];
    benchmark::DoNotOptimize(isMotionFree(checker, from, to, 0.045 * voxel_size));
  }
}

/// The reference scene's way out with all voxels known. Argument: 0 for RRT, 1 for RRT-Connect.
template <typename Checker>
void planPath(benchmark::State& state) {
  constexpr double kVoxelSize = 0.03;
  const Checker checker(object(kVoxelSize), world(kVoxelSize));
  MotionSpace space;
  space.workspace = {Vec3(-1.3, -0.7, -0.01), Vec3(0.4, 0.7, 0.01)};
  PathPlannerParameters parameters;
  parameters.algorithm =
      state.range(0) == 0 ? PlannerAlgorithm::kRrt : PlannerAlgorithm::kRrtConnect;
  std::uint32_t seed = 0;
  int found = 0;
  for (auto _ : state) {
    PathPlanner planner(space, parameters, ++seed);
    const auto path = planner.plan(
        Pose::Identity(), makePose(Vec3(-1.0, 0.0, 0.0)),
        [&](const Pose& pose) { return !checker.inCollision(pose); },
        [&](const Pose& from, const Pose& to) {
          return isMotionFree(checker, from, to, 0.045 * kVoxelSize);
        });
    found += path ? 1 : 0;
  }
  state.counters["share_found"] = static_cast<double>(found) / seed;
}

/// From voxels to a checker. Argument: voxel size [mm].
template <typename Checker>
void build(benchmark::State& state) {
  const double voxel_size = 0.001 * static_cast<double>(state.range(0));
  const OccupiedVoxels object_voxels = object(voxel_size);
  const OccupiedVoxels world_voxels = world(voxel_size);
  for (auto _ : state) {
    const Checker checker(object_voxels, world_voxels);
    benchmark::DoNotOptimize(checker.objectRadius());
  }
  state.counters["voxels"] =
      static_cast<double>(object_voxels.keys.size() + world_voxels.keys.size());
}

void sizesAndMotions(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{10, 30, 50}, {0, 1}});
  benchmark->ArgNames({"voxel_mm", "planar"})->Unit(benchmark::kMicrosecond);
}

void algorithms(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(0)->Arg(1)->ArgName("connect")->Unit(benchmark::kMillisecond);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(10)->Arg(30)->ArgName("voxel_mm")->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(checkPose, PlainFcl)->Apply(sizesAndMotions);
BENCHMARK_TEMPLATE(checkPose, FclCollisionChecker)->Apply(sizesAndMotions);
BENCHMARK_TEMPLATE(checkPose, GridCollisionChecker)->Apply(sizesAndMotions);
BENCHMARK_TEMPLATE(checkMotion, FclCollisionChecker)->Apply(sizesAndMotions);
BENCHMARK_TEMPLATE(checkMotion, GridCollisionChecker)->Apply(sizesAndMotions);
BENCHMARK_TEMPLATE(planPath, FclCollisionChecker)->Apply(algorithms);
BENCHMARK_TEMPLATE(planPath, GridCollisionChecker)->Apply(algorithms);
BENCHMARK_TEMPLATE(build, FclCollisionChecker)->Apply(sizes);
BENCHMARK_TEMPLATE(build, GridCollisionChecker)->Apply(sizes);

}  // namespace
}  // namespace smore
