// SPDX-License-Identifier: BSD-3-Clause
#include "arm_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smore/common/finite_path.h"
#include "smore/common/result.h"

namespace smore {
namespace {

constexpr double kStep = 0.001;        // [s]
constexpr int kSubstepsPerSample = 2;  // 500 Hz

// A joint this far from where it should be cannot follow: its effort does not suffice [rad].
constexpr double kGreatestTrackingError = 0.02;

JointVector configurationAt(const ArmMotion& motion, const Pose& T_world_object) {
  const auto q = motion.configurationFor(T_world_object);
  if (!q) throw InputError(q.reason() + "; move the pose or the arm's base (robot_base)");
  return *q;
}

// A joint that moves beside the arm's chain is a part of the multi-body too, and nobody's target.
void requireOnlyArmJoints(const UrdfModel& urdf, const std::vector<std::string>& moving,
                          const ArmModel& model) {
  const auto& own = model.jointNames();
  for (const std::string& name : moving) {
    if (std::find(own.begin(), own.end(), name) != own.end()) continue;
    throw InputError(urdf.source + ": joint " + name + " moves, but does not lie between " +
                     model.frames().base + " and " + model.frames().tool +
                     ": hang the gripper on " + model.frames().tool +
                     ", and make any other joint fixed");
  }
}

}  // namespace

ArmRobot::ArmRobot(const Scenario& scenario, const UrdfModel& urdf, std::uint64_t seed,
                   double sensor_cutoff)
    : motion_(urdf, armMotionParameters(scenario)),
      load_(scenario, urdf, motion_.model().frames(), motion_.T_tool_object(),
            scenario.start * motion_.T_tool_object().inverse(), kStep),
      arm_(scenario, urdf, motion_.model().frames(), load_.body(), kStep),
      joints_(arm_.arm().jointNames(), std::vector<double>(kArmJoints, 0.0)),
      sensor_(scenario.wrench_noise, kSubstepsPerSample * kStep, seed,
              wristSensorRange(scenario.robot), sensor_cutoff) {
  requireOnlyArmJoints(urdf, arm_.arm().jointNames(), motion_.model());
  (void)configurationAt(motion_, scenario.goal);
  place(scenario.start);
}

std::optional<Failure> ArmRobot::go(const Path& path, Way way) {
  Pose refused_at = pose();
  auto trajectory = motion_.trajectory(toJointVector(jointPositions()), path, way, &refused_at);
  refused_at_.reset();
  if (!trajectory) {
    refused_at_ = refused_at;
    return Failure{trajectory.reason()};
  }
  return followJoints(*trajectory);
}

std::optional<Failure> ArmRobot::followJoints(const JointTrajectory& trajectory) {
  if (load_.fingersMove()) return Failure{"the gripper is moving; wait until it has ended"};
  JointMotion next = joints_;
  if (trajectory.points.empty()) {
    next.stop(jointPositions());
  } else {
    next.follow(trajectory);
  }
  if (auto failure = checkLimits(trajectory)) return failure;
  joints_ = std::move(next);
  fault_.reset();
  return std::nullopt;
}

std::optional<GripperState> ArmRobot::gripper() const {
  if (load_.fingerJoint().empty()) return std::nullopt;
  return GripperState{load_.fingerJoint(), load_.fingerPosition(), load_.fingersMove(),
                      load_.holdsObject()};
}

std::optional<Failure> ArmRobot::moveGripper(double position) {
  if (load_.fingerJoint().empty()) return Failure{"the arm has no gripper"};
  if (!std::isfinite(position)) return Failure{"the gripper's position is not finite"};
  if (moving()) return Failure{"the arm is moving; stop it before the gripper moves"};
  load_.moveFingers(position, arm_.arm().lastPose());
  return std::nullopt;
}

std::optional<Failure> ArmRobot::checkLimits(const JointTrajectory& trajectory) const {
  const ArmModel& model = motion_.model();
  for (size_t i = 0; i < trajectory.joint_names.size(); ++i) {
    for (size_t joint = 0; joint < kArmJoints; ++joint) {
      if (model.jointNames()[joint] != trajectory.joint_names[i]) continue;
      const JointLimits& limits = model.limits()[joint];
      for (const JointTrajectoryPoint& point : trajectory.points) {
        if (point.positions[i] >= limits.min && point.positions[i] <= limits.max) continue;
        return Failure{model.jointNames()[joint] + " would pass its limit (" +
                       std::to_string(point.positions[i]) + " rad; " + std::to_string(limits.min) +
                       " to " + std::to_string(limits.max) + ")"};
      }
    }
  }
  return std::nullopt;
}

void ArmRobot::stop() { joints_.stop(jointPositions()); }

void ArmRobot::place(const Pose& T_world_object) {
  requireFinite({T_world_object});
  const std::vector<double> q = toList(configurationAt(motion_, T_world_object));
  arm_.place(q);
  joints_.stop(q);
  load_.place(arm_.arm().lastPose());
  showLoad();
  fault_.reset();
  link_contacts_.clear();
}

WrenchSample ArmRobot::advance() {
  for (int i = 0; i < kSubstepsPerSample; ++i) advanceSubstep();
  reading_ = sensor_.read(load_.environmentWrench(arm_.arm().lastPose()));
  WrenchSample sample;
  sample.time = time();
  const Pose T_object_sensor = T_sensor_object().inverse();
  sample.wrench = transformWrench(T_object_sensor, reading_.wrench);
  sample.sensor_object = T_object_sensor.translation();
  sample.sensor_axes_object = T_object_sensor.linear();
  sample.T_world_object = pose();
  return sample;
}

Payload ArmRobot::payload() const {
  const MassProperties& carried = load_.body().mass;
  return {carried.mass, carried.mass * (T_sensor_object().inverse() * carried.center)};
}

void ArmRobot::advanceSubstep() {
  joints_.advance(kStep);
  arm_.arm().setTarget(joints_.positions(), joints_.velocities());
  const Pose T_world_tool = arm_.arm().lastPose();
  Pose T_world_axes = Pose::Identity();
  T_world_axes.linear() = T_world_tool.linear();
  arm_.step(transformWrench(T_world_axes, load_.environmentWrench(T_world_tool)));
  load_.advance(T_world_tool, arm_.arm().lastPose());
  showLoad();
  watch();
  ++substeps_;
}

void ArmRobot::showLoad() {
  if (load_.version() == load_version_) return;
  load_version_ = load_.version();
  arm_.setCarried(load_.body());
}

// A new contact of a link ends the motion; one that lasts does not hinder the motion away from it.
void ArmRobot::watch() {
  std::set<LinkContact> contacts = arm_.linkContacts();
  for (const LinkContact& contact : contacts) {
    if (link_contacts_.count(contact) != 0) continue;
    stopWith("the link " + contact.link + " touches " + contact.other);
  }
  link_contacts_ = std::move(contacts);
  const std::vector<double> positions = jointPositions();
  for (size_t i = 0; i < positions.size(); ++i) {
    if (std::abs(positions[i] - joints_.positions()[i]) > kGreatestTrackingError) {
      stopWith("the joint " + jointNames()[i] + " does not follow: its effort does not suffice");
    }
  }
}

void ArmRobot::stopWith(const std::string& reason) {
  stop();
  if (!fault_) fault_ = Failure{reason};
}

double ArmRobot::time() const { return static_cast<double>(substeps_) * kStep; }

Pose ArmRobot::pose() const { return motion_.objectPose(toJointVector(jointPositions())); }

}  // namespace smore
