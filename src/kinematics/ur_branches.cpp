// SPDX-License-Identifier: BSD-3-Clause
#include "smore/kinematics/ur_branches.h"

#include <algorithm>
#include <cmath>

namespace smore {
namespace {

constexpr double kAxisTolerance = 0.02;  // of the axes' scalar products
constexpr double kSingularSine = 1e-9;   // of joint 5

// Arguments of arc functions this far beyond 1 are at the edge of the reach, not beyond it.
constexpr double kReachTolerance = 1e-9;

// One joint of the table: turn about z, then shift along z and x, then twist about x.
Pose dhTransform(double theta, double a, double d, double alpha) {
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(theta, Vec3::UnitZ()));
  pose.translate(Vec3(a, 0.0, d));
  pose.rotate(Eigen::AngleAxisd(alpha, Vec3::UnitX()));
  return pose;
}

Pose firstJoint(const UrGeometry& arm, double theta) {
  return dhTransform(theta, 0.0, arm.d1, M_PI_2);
}

Pose sixthAtZero(const UrGeometry& arm) {
  return firstJoint(arm, 0.0) * dhTransform(0.0, arm.a2, 0.0, 0.0) *
         dhTransform(0.0, arm.a3, 0.0, 0.0) * dhTransform(0.0, 0.0, arm.d4, M_PI_2) *
         dhTransform(0.0, 0.0, arm.d5, -M_PI_2) * dhTransform(0.0, 0.0, arm.d6, 0.0);
}

std::optional<double> arcCosine(double cosine) {
  if (std::abs(cosine) > 1.0 + kReachTolerance) return std::nullopt;
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

// The three parallel joints: a planar arm of two links (joint 4 gives the direction of its end).
void addPlanarBranches(const UrGeometry& arm, const Pose& T_first_fourth, const JointVector& outer,
                       std::vector<JointVector>* branches) {
  const Vec3 wrist = T_first_fourth * Vec3(0.0, -arm.d4, 0.0);
  const double reach = std::hypot(wrist.x(), wrist.y());
  const auto bend =
      arcCosine((reach * reach - arm.a2 * arm.a2 - arm.a3 * arm.a3) / (2.0 * arm.a2 * arm.a3));
  if (!bend) return;
  for (const double elbow : {*bend, -*bend}) {
    JointVector q = outer;
    q[2] = elbow;
    q[1] = std::atan2(wrist.y(), wrist.x()) -
           std::atan2(arm.a3 * std::sin(elbow), arm.a2 + arm.a3 * std::cos(elbow));
    const Pose T_first_third =
        dhTransform(q[1], arm.a2, 0.0, 0.0) * dhTransform(q[2], arm.a3, 0.0, 0.0);
    const Eigen::Matrix3d turn = T_first_third.linear().transpose() * T_first_fourth.linear();
    q[3] = std::atan2(turn(1, 0), turn(0, 0));
    branches->push_back(q.unaryExpr(&wrapped));
  }
}

bool near(double value, double expected) { return std::abs(value - expected) < kAxisTolerance; }

bool isUrLike(const std::array<ArmModel::Axis, kArmJoints>& axes) {
  const auto dot = [&axes](size_t i, size_t k) { return axes[i].direction.dot(axes[k].direction); };
  return near(dot(0, 1), 0.0) && near(dot(1, 2), 1.0) && near(dot(1, 3), 1.0) &&
         near(dot(4, 0), -1.0) && near(dot(5, 1), 1.0);
}

}  // namespace

std::optional<UrGeometry> urGeometry(const ArmModel& arm) {
  const auto axes = arm.axes(JointVector::Zero());
  if (!isUrLike(axes)) return std::nullopt;
  UrGeometry geometry;
  const Vec3 up = axes[0].direction;
  const Vec3 side = (axes[1].direction - up * up.dot(axes[1].direction)).normalized();
  const Vec3 ahead = up.cross(side);
  geometry.T_base_first.linear() << ahead, -side, up;
  geometry.T_base_first.translation() = axes[0].point - up * up.dot(axes[0].point);
  geometry.d1 = up.dot(axes[1].point);
  geometry.a2 = ahead.dot(axes[2].point - axes[1].point);
  geometry.a3 = ahead.dot(axes[3].point - axes[2].point);
  geometry.d4 = side.dot(axes[4].point - axes[0].point);
  geometry.d5 = -up.dot(axes[5].point - axes[3].point);
  const Pose T_base_tool = arm.toolPose(JointVector::Zero());
  geometry.d6 = side.dot(T_base_tool.translation() - axes[4].point);
  geometry.T_sixth_tool = (geometry.T_base_first * sixthAtZero(geometry)).inverse() * T_base_tool;
  return geometry;
}

// The axes of joints 2, 3 and 4 point along z of frame 1. Along it, the origin of frame 5 is d4
// from joint 1's axis, which gives joint 1; that of frame 6 is d4 + d6 cos(q5) from it, which gives
// joint 5; and the z row of frame 6 in frame 1 is (s5 c6, -s5 s6, c5), which gives joint 6. What is
// left is a planar arm.
std::vector<JointVector> urBranches(const UrGeometry& arm, const Pose& T_base_tool) {
  const Pose T_zeroth_sixth = arm.T_base_first.inverse() * T_base_tool * arm.T_sixth_tool.inverse();
  const Vec3 fifth = T_zeroth_sixth * Vec3(0.0, 0.0, -arm.d6);
  const auto shoulder = arcCosine(arm.d4 / std::hypot(fifth.x(), fifth.y()));
  if (!shoulder) return {};
  std::vector<JointVector> branches;
  for (const double side : {*shoulder, -*shoulder}) {
    JointVector q = JointVector::Zero();
    q[0] = std::atan2(fifth.y(), fifth.x()) + side + M_PI_2;
    const Pose T_first_sixth = firstJoint(arm, q[0]).inverse() * T_zeroth_sixth;
    const auto flip = arcCosine((T_first_sixth.translation().z() - arm.d4) / arm.d6);
    if (!flip) continue;
    for (const double wrist : {*flip, -*flip}) {
      q[4] = wrist;
      const Eigen::Matrix3d& turn = T_first_sixth.linear();
      const double sine = std::sin(wrist);
      q[5] =
          std::abs(sine) < kSingularSine ? 0.0 : std::atan2(-turn(2, 1) / sine, turn(2, 0) / sine);
      const Pose T_fourth_sixth =
          dhTransform(q[4], 0.0, arm.d5, -M_PI_2) * dhTransform(q[5], 0.0, arm.d6, 0.0);
      addPlanarBranches(arm, T_first_sixth * T_fourth_sixth.inverse(), q, &branches);
    }
  }
  return branches;
}

}  // namespace smore
