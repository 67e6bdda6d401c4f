// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/reconstruction.h"

#include <cmath>
#include <string>

namespace smore {
namespace {

constexpr int kMotionsPerTouch = 10;  // allowed on average, before the scene counts as empty

Vec3 uniformIn(const Bounds& bounds, std::mt19937_64* random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    point[i] = bounds.min[i] + unit(*random) * (bounds.max[i] - bounds.min[i]);
  }
  return point;
}

Eigen::Quaterniond uniformRotation(std::mt19937_64* random) {
  std::normal_distribution<double> normal;
  // A normalised Gaussian 4-vector is uniform on the sphere of unit quaternions.
  Eigen::Quaterniond rotation(normal(*random), normal(*random), normal(*random), normal(*random));
  return rotation.normalized();
}

}  // namespace

RandomTouches::RandomTouches(const MotionSpace& space, std::uint64_t seed)
    : space_(space), random_(seed) {}

Path RandomTouches::nextTouch(const Pose& from) {
  Pose goal = Pose::Identity();
  const Vec3 point = uniformIn(space_.workspace, &random_);
  if (space_.motion == Motion::kSpatial) {
    goal.linear() = uniformRotation(&random_).toRotationMatrix();
    goal.translation() = point;
  } else {
    Vec3 in_plane = space_.T_world_plane.inverse() * point;
    in_plane.z() = 0.0;
    std::uniform_real_distribution<double> turn(-M_PI, M_PI);
    goal = space_.T_world_plane * makePose(in_plane, Vec3(0.0, 0.0, turn(random_)));
  }
  return {from, goal};
}

ReconstructionParameters reconstructionParameters(const Scenario& scenario) {
  ReconstructionParameters parameters;
  parameters.start = scenario.start;
  parameters.on_contact = scenario.on_contact;
  parameters.touches = scenario.reconstruct_touches;
  return parameters;
}

RetrievalOutcome reconstruct(const ReconstructionParameters& parameters, Robot* robot,
                             TouchPlanner* touches, const Retrieval::ProgressCallback& on_progress,
                             const std::function<bool()>& should_stop) {
  RetrievalOutcome outcome;
  const auto enter = [&](Phase phase) {
    if (on_progress) on_progress({phase, outcome.collisions, outcome.plans, 0.0});
  };
  const int max_motions = kMotionsPerTouch * parameters.touches;
  while (outcome.collisions < parameters.touches && outcome.plans < max_motions) {
    if (should_stop && should_stop()) {
      outcome.reason = "stopped by the user";
      return outcome;
    }
    enter(Phase::kMoving);
    ++outcome.plans;
    MotionResult motion = robot->follow(touches->nextTouch(robot->pose()));
    outcome.path_length = motion.length;
    if (motion.end == MotionEnd::kContact) {
      ++outcome.collisions;
      const bool reset = parameters.on_contact == OnContact::kReset;
      enter(reset ? Phase::kResetting : Phase::kRetreating);
      motion = reset ? robot->reset(parameters.start) : robot->retreat(parameters.retreat_distance);
    }
    if (motion.end != MotionEnd::kReached) {
      outcome.reason = motion.reason;
      return outcome;
    }
  }
  outcome.success = outcome.collisions >= parameters.touches;
  outcome.reason = outcome.success ? "the budget of touches is used up"
                                   : std::to_string(max_motions) + " motions found too few touches";
  enter(Phase::kFinished);
  return outcome;
}

}  // namespace smore
