// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/method_replica.h"

#include "smore/mapping/joint_belief.h"
#include "smore/planning/contact_risk.h"
#include "smore/planning/cspace_memory.h"
#include "smore/planning/grid_collision_checker.h"
#include "smore/planning/occupied_voxels.h"

namespace smore {

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

Result<Plan> MethodReplica::plan(const Pose& start, const Pose& goal, bool relaxed) {
  method_.planner->keepTree(true);
  return relaxed ? method_.planner->planRelaxed(start, goal) : method_.planner->plan(start, goal);
}

PoseAssessment MethodReplica::assess(const Pose& T_world_object, const Pose& known_free) const {
  PoseAssessment assessment;
  if (const auto* belief = dynamic_cast<const JointBelief*>(method_.maps.get())) {
    assessment.risk = ContactRisk(belief->worlds()).atPose(T_world_object);
    assessment.valid = true;
  } else if (const auto* memory = dynamic_cast<const CspaceMemory*>(method_.memory.get())) {
    assessment.valid = memory->isValid(T_world_object, known_free);
    assessment.risk = assessment.valid ? 0.0 : 1.0;
  } else {
    const GridCollisionChecker checker(occupiedVoxels(method_.maps->object()),
                                       occupiedVoxels(method_.maps->world()));
    assessment.valid = !checker.inCollision(T_world_object);
    assessment.risk = assessment.valid ? 0.0 : 1.0;
  }
  assessment.valid = assessment.valid && scenario_.motionSpace().contains(T_world_object);
  return assessment;
}

std::vector<double> MethodReplica::risksAlong(const Path& path) const {
  std::vector<double> risks(path.size(), 0.0);
  const auto* belief = dynamic_cast<const JointBelief*>(method_.maps.get());
  if (belief == nullptr || path.empty()) return risks;
  const ContactRisk risk(belief->worlds());
  HypothesisMask touched = risk.touching(path.front());
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0) touched |= risk.touchingAlong({path[i - 1], path[i]});
    risks[i] = risk.worlds().sampled.shareOf(touched);
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
