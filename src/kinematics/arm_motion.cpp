// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/arm_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

#include "smore/common/finite_path.h"
#include "smore/kinematics/trajectory_timing.h"

namespace smore {
namespace {

// Between the poses that are resolved. A joint-space step then leaves the straight line by some
// hundredths of a millimetre.
constexpr double kResolution = 0.005;        // [m]
constexpr double kAngularResolution = 0.02;  // [rad]
// A step of these sizes turns a joint by more only where the Jacobian is close to singular, or
// where the solution has jumped to another branch.
constexpr double kLongestJointStep = 0.4;  // [rad]
constexpr double kAtRest = 1e-9;           // [rad]; configurations this near are one
constexpr double kEncoderNoise = 1e-3;     // [rad]; where a joint stands is known no better
// From joint to joint, of the arm whose least singular value is asked in full [m].
constexpr double kLengthOfUr5e = 1.038;

std::string text(const Pose& pose) {
  const Vec3 p = pose.translation();
  std::ostringstream stream;
  stream.precision(3);
  stream << "(" << p.x() << ", " << p.y() << ", " << p.z() << ") m";
  return stream.str();
}

// The cubic over a first step of less than half the next one begins backwards, as the speed after
// it is that of both together; over such a last step it passes the end and comes back. So short a
// step joins its neighbour: where the arm stands is always a little beside where a path begins.
std::vector<JointVector> withoutShortEnds(std::vector<JointVector> path) {
  const auto step = [&path](size_t i) { return (path[i + 1] - path[i]).norm(); };
  while (path.size() > 2 && 2.0 * step(0) < step(1)) path.erase(path.begin() + 1);
  while (path.size() > 2 && 2.0 * step(path.size() - 2) < step(path.size() - 3)) {
    path.erase(path.end() - 2);
  }
  return path;
}

// The way from joint to joint and on to the tool [m].
double lengthOf(const ArmModel& arm) {
  const auto axes = arm.axes(JointVector::Zero());
  double length = 0.0;
  for (size_t i = 0; i + 1 < axes.size(); ++i) {
    length += (axes[i + 1].point - axes[i].point).norm();
  }
  return length + (arm.toolPose(JointVector::Zero()).translation() - axes.back().point).norm();
}

}  // namespace

ArmMotionParameters armMotionParameters(const Scenario& scenario) {
  ArmMotionParameters parameters;
  parameters.T_world_base = scenario.T_world_base;
  parameters.T_grasp_object = scenario.T_gripper_object;
  parameters.linear_speed = scenario.linear_speed;
  parameters.angular_speed = scenario.angular_speed;
  parameters.wanted = {scenario.goal};
  const Vec3 normal = scenario.start.linear().col(2);
  for (int i = 0; i < kCorners; ++i) {
    Vec3 corner = scenario.workspace.corner(i);
    if (scenario.motion == Motion::kPlanar) {
      corner -= normal * normal.dot(corner - scenario.start.translation());
    }
    Pose pose = scenario.start;
    pose.translation() = corner;
    parameters.wanted.push_back(pose);
  }
  return parameters;
}

ArmMotion::ArmMotion(const UrdfModel& urdf, const ArmMotionParameters& parameters)
    : parameters_(parameters),
      arm_(urdf, parameters.frames),
      least_singular_value_(parameters.least_singular_value *
                            std::min(1.0, lengthOf(arm_) / kLengthOfUr5e)),
      inverse_kinematics_(&arm_),
      collision_(urdf, &arm_),
      T_tool_object_(arm_.T_tool_grasp() * parameters.T_grasp_object) {}

Pose ArmMotion::toolPose(const JointVector& q) const {
  return parameters_.T_world_base * arm_.toolPose(q);
}

Pose ArmMotion::objectPose(const JointVector& q) const { return toolPose(q) * T_tool_object_; }

Pose ArmMotion::T_base_tool(const Pose& T_world_object) const {
  return parameters_.T_world_base.inverse() * T_world_object * T_tool_object_.inverse();
}

// How good a configuration is to start from; greater is better.
struct ArmMotion::Score {
  int reachable = 0;  ///< wanted poses
  bool above_mounting_plane = false;
  double margin = 0.0;  ///< least on the ways

  bool operator<(const Score& other) const {
    return std::tie(reachable, above_mounting_plane, margin) <
           std::tie(other.reachable, other.above_mounting_plane, other.margin);
  }
};

Result<JointVector> ArmMotion::configurationFor(const Pose& T_world_object) const {
  const std::vector<JointVector> branches =
      inverse_kinematics_.branches(T_base_tool(T_world_object));
  std::string reason = "out of the arm's reach";
  std::optional<std::pair<Score, JointVector>> best;
  for (const JointVector& branch : branches) {
    const JointVector q = nearestTurns(branch);
    const Result<bool> valid = checkConfiguration(q);
    if (!valid) {
      reason = valid.reason();
      continue;
    }
    const Score quality = score(q);
    if (!best || best->first < quality) best = {quality, q};
  }
  if (best) return best->second;
  return Failure{"the object at " + text(T_world_object) + ": " + reason};
}

ArmMotion::Score ArmMotion::score(const JointVector& q) const {
  Score score;
  score.margin = margin(q);
  double lowest = collision_.lowestPoint(q);
  for (const Pose& wanted : parameters_.wanted) {
    const auto way = resolve(q, {wanted}, Way::kNew);
    if (!way) continue;
    ++score.reachable;
    for (const JointVector& passed : *way) {
      score.margin = std::min(score.margin, margin(passed));
      lowest = std::min(lowest, collision_.lowestPoint(passed));
    }
  }
  score.above_mounting_plane = lowest > 0.0;
  return score;
}

// The same configuration, each joint by whole turns as near to the middle of its range as can be.
JointVector ArmMotion::nearestTurns(const JointVector& q) const {
  JointVector turned = q;
  for (int i = 0; i < kArmJoints; ++i) {
    const JointLimits& limits = arm_.limits()[static_cast<size_t>(i)];
    const double middle = 0.5 * (limits.min + limits.max);
    turned[i] = middle + wrapped(q[i] - middle);
  }
  return turned;
}

double ArmMotion::margin(const JointVector& q) const {
  double centered = 1.0;
  for (int i = 0; i < kArmJoints; ++i) {
    const JointLimits& limits = arm_.limits()[static_cast<size_t>(i)];
    const double off = (2.0 * q[i] - limits.min - limits.max) / (limits.max - limits.min);
    centered *= 1.0 - off * off;
  }
  return centered * inverse_kinematics_.singularity(q);
}

Result<bool> ArmMotion::checkLimits(const JointVector& q, double margin,
                                    const JointVector* start) const {
  for (int i = 0; i < kArmJoints; ++i) {
    const auto joint = static_cast<size_t>(i);
    const JointLimits& limits = arm_.limits()[joint];
    double least = limits.min + margin;
    double most = limits.max - margin;
    if (start != nullptr) {  // an arm that stands nearer to a limit may move away from it
      least = std::max(limits.min, std::min(least, (*start)[i] - kEncoderNoise));
      most = std::min(limits.max, std::max(most, (*start)[i] + kEncoderNoise));
    }
    if (q[i] < least || q[i] > most) {
      return Failure{arm_.jointNames()[joint] + " would pass its limit (" + std::to_string(q[i]) +
                     " rad; " + std::to_string(limits.min) + " to " + std::to_string(limits.max) +
                     ", from which " + std::to_string(margin) + " are kept)"};
    }
  }
  return true;
}

Result<bool> ArmMotion::checkConfiguration(const JointVector& q, const JointVector* start) const {
  const Result<bool> within = checkLimits(q, parameters_.limit_margin, start);
  if (!within) return Failure{within.reason()};
  if (const double least = inverse_kinematics_.singularity(q); least < least_singular_value_) {
    return Failure{"the arm is near a singularity there (its Jacobian's least singular value is " +
                   std::to_string(least) + ", below " + std::to_string(least_singular_value_) +
                   ")"};
  }
  if (const auto links = collision_.collidingLinks(q)) {
    return Failure{"the links " + links->first + " and " + links->second + " would collide"};
  }
  return true;
}

Result<JointVector> ArmMotion::next(const JointVector& now, const Pose& T_world_object) const {
  const Pose target = T_base_tool(T_world_object);
  const auto q = inverse_kinematics_.solveNear(target, now);
  if (!q && inverse_kinematics_.branches(target).empty()) {
    return Failure{"out of the arm's reach"};
  }
  if (!q || (*q - now).cwiseAbs().maxCoeff() > kLongestJointStep) {
    return Failure{"the arm would have to pass a singularity to get there"};
  }
  return *q;
}

Result<std::vector<JointVector>> ArmMotion::resolve(const JointVector& now, const Path& path,
                                                    Way way, Pose* refused_at) const {
  std::vector<JointVector> configurations{now};
  Pose from = objectPose(now);
  for (size_t i = 0; i < path.size(); ++i) {
    for (const Pose& pose : densify({from, path[i]}, kResolution, kAngularResolution)) {
      const auto q = next(configurations.back(), pose);
      const Result<bool> valid = !q                  ? Failure{q.reason()}
                                 : way == Way::kBack ? checkLimits(*q, 0.0, nullptr)
                                                     : checkConfiguration(*q, &now);
      if (!valid) {
        if (refused_at != nullptr) *refused_at = pose;
        return Failure{"pose " + std::to_string(i + 1) + " of " + std::to_string(path.size()) +
                       ", the object at " + text(pose) + ": " + valid.reason()};
      }
      if ((*q - configurations.back()).cwiseAbs().maxCoeff() > kAtRest) {
        configurations.push_back(*q);
      }
    }
    from = path[i];
  }
  return configurations;
}

Result<JointTrajectory> ArmMotion::trajectory(const JointVector& now, const Path& path, Way way,
                                              Pose* refused_at) const {
  requireFinite(path);
  auto configurations = resolve(now, path, way, refused_at);
  if (!configurations) return Failure{configurations.reason()};
  JointTrajectory trajectory;
  if (configurations->size() > 1) return timed(*configurations);
  trajectory.joint_names = {arm_.jointNames().begin(), arm_.jointNames().end()};
  return trajectory;
}

JointTrajectory ArmMotion::timed(const std::vector<JointVector>& resolved) const {
  std::vector<JointVector> configurations = withoutShortEnds(resolved);
  // A motion has a middle, where it is fastest.
  if (configurations.size() == 2) {
    const JointVector middle = 0.5 * (configurations[0] + configurations[1]);
    configurations.insert(configurations.begin() + 1, middle);
  }
  std::vector<double> durations;
  for (size_t i = 0; i + 1 < configurations.size(); ++i) {
    const Pose from = objectPose(configurations[i]);
    const Pose to = objectPose(configurations[i + 1]);
    durations.push_back(std::max(distanceBetween(from, to) / parameters_.linear_speed,
                                 angleBetween(from, to) / parameters_.angular_speed));
  }
  TimingLimits limits;
  limits.acceleration = JointVector::Constant(parameters_.joint_acceleration);
  for (int i = 0; i < kArmJoints; ++i) {
    limits.velocity[i] = arm_.limits()[static_cast<size_t>(i)].velocity;
  }
  JointTrajectory trajectory;
  trajectory.joint_names = {arm_.jointNames().begin(), arm_.jointNames().end()};
  for (const TimedConfiguration& point : timeAlong(configurations, durations, limits)) {
    trajectory.points.push_back({point.time, toList(point.position), toList(point.velocity)});
  }
  return trajectory;
}

}  // namespace smore
