// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/geometry.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace smore {

bool Bounds::contains(const Vec3& point) const {
  return (point.array() >= min.array()).all() && (point.array() <= max.array()).all();
}

std::string describe(const Vec3& point) {
  std::ostringstream text;
  text << "(" << point.x() << " " << point.y() << " " << point.z() << ")";
  return text.str();
}

Pose makePose(const Vec3& position, const Vec3& rpy) {
  Pose pose = Pose::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
       Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()))
          .toRotationMatrix();
  pose.translation() = position;
  return pose;
}

Vec3 rollPitchYaw(const Pose& pose) {
  // Rz(yaw) Ry(pitch) Rx(roll); where cos(pitch) vanishes only yaw - roll is defined.
  const Eigen::Matrix3d& R = pose.linear();
  const double cos_pitch = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), cos_pitch);
  constexpr double kSingular = 1e-9;
  if (cos_pitch < kSingular) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Matrix3d crossMatrix(const Vec3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

Pose projectedToPlane(const Pose& pose) {
  const Eigen::Matrix3d& turn = pose.linear();
  const double angle = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
  return makePose({pose.translation().x(), pose.translation().y(), 0.0}, {0.0, 0.0, angle});
}

bool isNearPlane(const Pose& T_plane_object) {
  const Vec3 axis = T_plane_object.linear().col(2);
  return std::abs(T_plane_object.translation().z()) <= kNearDistance && axis.z() > 0.0 &&
         axis.head<2>().norm() <= std::sin(kNearAngle);
}

double angleBetween(const Pose& a, const Pose& b) {
  return Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear()));
}

double distanceBetween(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm();
}

double gapBetween(const Pose& a, const Pose& b) {
  return distanceBetween(a, b) + angleBetween(a, b);
}

Pose interpolate(const Pose& a, const Pose& b, double fraction) {
  const Eigen::Quaterniond from(a.linear());
  const Eigen::Quaterniond to(b.linear());
  Pose pose = Pose::Identity();
  pose.linear() = from.slerp(fraction, to).toRotationMatrix();
  pose.translation() = a.translation() + fraction * (b.translation() - a.translation());
  return pose;
}

Path densify(const Path& path, double max_distance, double max_angle) {
  Path dense;
  if (path.empty()) return dense;
  dense.push_back(path.front());
  for (size_t i = 1; i < path.size(); ++i) {
    const double steps = std::max(distanceBetween(path[i - 1], path[i]) / max_distance,
                                  angleBetween(path[i - 1], path[i]) / max_angle);
    const int count = std::max(1, static_cast<int>(std::ceil(steps)));
    for (int k = 1; k < count; ++k) {
      dense.push_back(interpolate(path[i - 1], path[i], static_cast<double>(k) / count));
    }
    dense.push_back(path[i]);
  }
  return dense;
}

double pathLength(const Path& path) {
  double length = 0.0;
  for (size_t i = 1; i < path.size(); ++i) length += distanceBetween(path[i - 1], path[i]);
  return length;
}

Wrench transformWrench(const Pose& T_a_b, const Wrench& wrench_b) {
  Wrench wrench_a;
  wrench_a.force = T_a_b.linear() * wrench_b.force;
  wrench_a.torque = T_a_b.linear() * wrench_b.torque + T_a_b.translation().cross(wrench_a.force);
  return wrench_a;
}

bool isFinite(const Wrench& wrench) {
  return wrench.force.allFinite() && wrench.torque.allFinite();
}

bool isFinite(const Pose& pose) { return pose.matrix().allFinite(); }

}  // namespace smore
