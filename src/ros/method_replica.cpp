// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/method_replica.h"

#include "smore/mapping/joint_belief.h"
#include "smore/planning/contact_risk.h"
#include "smore/planning/cspace_memory.h"
#include "smore/planning/grid_collision_checker.h"
#include "smore/planning/occupied_voxels.h"

namespace smore {
namespace {

/// What is more than unlikely. While little is known, nothing reaches what counts as occupied: the
/// mapping, too, shows voxels from here on by default.
OccupiedVoxels likelyVoxels(const VoxelGrid& grid) {
  constexpr double kLikely = 0.3;
  OccupiedVoxels voxels{grid.voxelSize(), {}};
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    if (voxel.probability >= kLikely) voxels.keys.push_back(voxel.key);
  }
  return voxels;
}

}  // namespace

MethodReplica::MethodReplica(MethodKind kind, const Scenario& scenario, std::uint64_t seed,
                             const MethodParameters& parameters)
    : kind_(kind), scenario_(scenario), seed_(seed), parameters_(parameters) {
  restart(0, {});
}

bool MethodReplica::extend(const EvidencePart& part) {
  if (part.epoch != epoch_) restart(part.epoch, part.priors);
  if (part.first == size_) {
    for (const ContactObservation& observation : part.observations) method_.observe(observation);
    size_ += part.observations.size();
    if (learnsNoMaps() || method_.maps->revision() - first_revision_ == part.changes) return true;
  }
  restart(0, {});
  return false;
}

Result<Plan> MethodReplica::plan(const Pose& start, const Pose& goal, bool relaxed,
                                 std::vector<Pose> refused) {
  const std::string outside = scenario_.motionSpace().whyOutside(goal);
  if (!outside.empty()) return Failure{"goal: " + outside};
  method_.planner->keepTree(true);
  method_.planner->avoid(std::move(refused));
  return relaxed ? method_.planner->planRelaxed(start, goal) : method_.planner->plan(start, goal);
}

PoseKnowledge MethodReplica::knowledge() const {
  const bool certain = dynamic_cast<const JointBelief*>(method_.maps.get()) == nullptr;
  const auto assess = [certain, risk_of = riskOfPoses(),
                       space = scenario_.motionSpace()](const Pose& T_world_object) {
    PoseAssessment assessment;
    assessment.risk = risk_of(T_world_object);
    assessment.problem = space.whyOutside(T_world_object);
    if (assessment.problem.empty() && certain && assessment.risk > 0.0) {
      assessment.problem = "the object would touch what is occupied";
    }
    assessment.valid = assessment.problem.empty();
    return assessment;
  };
  return {likelyVoxels(method_.maps->object()), assess};
}

std::function<double(const Pose&)> MethodReplica::riskOfPoses() const {
  if (const auto* belief = dynamic_cast<const JointBelief*>(method_.maps.get())) {
    return [risk = ContactRisk(belief->worlds())](const Pose& pose) { return risk.atPose(pose); };
  }
  if (const auto* memory = dynamic_cast<const CspaceMemory*>(method_.memory.get())) {
    return [memory = *memory, start = scenario_.start](const Pose& pose) {
      return memory.isValid(pose, start) ? 0.0 : 1.0;
    };
  }
  const auto checker = std::make_shared<const GridCollisionChecker>(
      occupiedVoxels(method_.maps->object()), occupiedVoxels(method_.maps->world()));
  return [checker](const Pose& pose) { return checker->inCollision(pose) ? 1.0 : 0.0; };
}

std::vector<double> MethodReplica::risksAlong(const Path& path) const {
  std::vector<double> risks(path.size(), 0.0);
  const auto* belief = dynamic_cast<const JointBelief*>(method_.maps.get());
  if (belief == nullptr || path.empty()) return risks;
  const ContactRisk risk(belief->worlds());
  HypothesisMask touched = risk.touching(path.front());
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0) touched |= risk.touchingAlong({path[i - 1], path[i]});
    risks[i] = SampledWorlds::shareOf(touched);
  }
  return risks;
}

void MethodReplica::restart(std::uint64_t epoch, const Priors& priors) {
  method_ = makeMethod(kind_, scenario_, seed_, parameters_, priors);
  first_revision_ = method_.maps->revision();
  epoch_ = epoch;
  size_ = 0;
}

}  // namespace smore
