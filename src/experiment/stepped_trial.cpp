// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/stepped_trial.h"

#include <algorithm>
#include <stdexcept>

#include "smore/common/result.h"
#include "smore/mapping/prior_maps.h"
#include "smore/retrieval/retrieval.h"

namespace smore {
namespace {

std::unique_ptr<TwinMap> mapsOf(MethodKind kind, const Scenario& scenario, const Scenario& scene,
                                std::uint64_t seed) {
  if (kind != MethodKind::kPaper && kind != MethodKind::kSmore) {
    throw InputError("the method " + methodName(kind) + " keeps no maps; use paper or smore");
  }
  return makeTwinMap(kind, scenario, seed, {}, makePriors(scene));
}

// Share of the straight way from a point of the box, by `shift`, that stays within it.
double shareWithin(const Bounds& bounds, const Vec3& point, const Vec3& shift) {
  double share = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (shift[axis] == 0.0) continue;
    const double border = shift[axis] > 0.0 ? bounds.max[axis] : bounds.min[axis];
    share = std::min(share, (border - point[axis]) / shift[axis]);
  }
  return std::max(share, 0.0);
}

void checkAction(const Eigen::VectorXd& action, int dimensions) {
  if (action.size() != dimensions) {
    throw InputError(
        "an action of " + std::to_string(action.size()) + " numbers; this scenario takes " +
        (dimensions == 3 ? "3: x, y [m] and yaw [rad]" : "6: x, y, z [m] and a turn [rad]"));
  }
  if (!action.allFinite()) throw InputError("an action with a number that is not finite");
}

}  // namespace

SteppedTrial::SteppedTrial(const Scenario& scenario, std::uint64_t seed,
                           std::optional<MethodKind> maps) {
  requireScene(scenario);
  if (scenario.task != Task::kRetrieve) {
    throw InputError("scenario " + scenario.name +
                     ": task: a trial in steps ends at a goal; give a scenario to retrieve");
  }
  scene_ = perturbScenario(scenario, seed);
  simulated_ = makeSimulatedRobot(scene_, seed);
  if (maps) maps_ = mapsOf(*maps, scenario, scene_, seed);
  robot_ =
      std::make_unique<InProcessRobot>(simulated_.get(), sensingParameters(scene_, *simulated_),
                                       seed, [this](const ContactObservation& observation) {
                                         if (maps_) maps_->observe(observation);
                                       });
}

StepOutcome SteppedTrial::step(const Eigen::VectorXd& action) {
  checkAction(action, dimensions());
  const MotionResult motion = robot_->follow({robot_->pose(), target(action)});
  StepOutcome outcome;
  outcome.end = motion.end;
  outcome.reason = motion.reason;
  outcome.T_world_object = robot_->pose();
  outcome.wrench = robot_->wrench();
  outcome.at_goal = motion.end == MotionEnd::kReached &&
                    isAtGoal(retrievalParameters(scene_), outcome.T_world_object);
  if (motion.end == MotionEnd::kContact) ++collisions_;
  if (motion.end == MotionEnd::kContact || motion.end == MotionEnd::kFault) goBack();
  return outcome;
}

void SteppedTrial::restart() {
  const MotionResult back = robot_->reset(scene_.start);
  if (back.end != MotionEnd::kReached) {
    throw std::runtime_error("could not go back to the start: " + back.reason);
  }
}

Eigen::VectorXd SteppedTrial::difference() const {
  const Eigen::Matrix3d axes = T_world_axes().linear();
  const Pose here = robot_->pose();
  const Vec3 shift = axes.transpose() * (scene_.goal.translation() - here.translation());
  const Eigen::AngleAxisd turn(scene_.goal.linear() * here.linear().transpose());
  const Vec3 turned = axes.transpose() * (turn.angle() * turn.axis());
  Eigen::VectorXd difference(dimensions());
  if (planar()) {
    difference << shift.head<2>(), turned.z();
  } else {
    difference << shift, turned;
  }
  return difference;
}

const TwinMap& SteppedTrial::maps() const {
  if (!maps_) throw InputError("this trial keeps no maps; make it with maps: paper or smore");
  maps_->update();
  return *maps_;
}

Pose SteppedTrial::target(const Eigen::VectorXd& action) const {
  Vec3 shift = Vec3::Zero();
  Vec3 turn = Vec3::Zero();
  if (planar()) {
    shift.head<2>() = action.head<2>();
    turn.z() = action[2];
  } else {
    shift = action.head<3>();
    turn = action.tail<3>();
  }
  const Eigen::Matrix3d axes = T_world_axes().linear();
  shift = axes * shift.cwiseMax(-kLargestShift).cwiseMin(kLargestShift);
  turn = axes * turn.cwiseMax(-kLargestTurn).cwiseMin(kLargestTurn);
  Pose target = robot_->pose();
  target.translation() += shareWithin(scene_.workspace, target.translation(), shift) * shift;
  if (turn.norm() > 0.0) {
    const Eigen::AngleAxisd rotation(turn.norm(), turn.normalized());
    target.linear() = Eigen::Quaterniond(rotation * target.linear()).normalized().matrix();
  }
  return target;
}

void SteppedTrial::goBack() {
  const bool retreats = scene_.on_contact == OnContact::kRetreat;
  // As the loop does where backing off fails or leads nowhere: to the start.
  if (!retreats ||
      robot_->retreat(retrievalParameters(scene_).retreat_distance).end != MotionEnd::kReached) {
    restart();
  }
}

}  // namespace smore
