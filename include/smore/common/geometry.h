// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

namespace smore {

using Vec3 = Eigen::Vector3d;

/// A rigid transform. Named T_a_b where frames matter: it maps coordinates in b to coordinates in a
/// and is the pose of frame b in frame a. Lengths in metres.
using Pose = Eigen::Isometry3d;

/// Poses of the object frame in the world, in the order in which they are visited.
using Path = std::vector<Pose>;

/// Standard gravity in the world, whose z axis points up [m/s^2] (ISO 80000-3).
inline Vec3 gravity() { return {0.0, 0.0, -9.80665}; }

/// Force [N] and torque [N m] about the origin of the frame whose axes they are given in.
struct Wrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

/// Axis-aligned box [m]; a point on its faces is inside.
struct Bounds {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();

  bool contains(const Vec3& point) const;

  /// The same with each face so much farther out [m].
  Bounds widened(double margin) const {
    return {min - Vec3::Constant(margin), max + Vec3::Constant(margin)};
  }

  /// Of its eight corners the one at the upper end of x, y, z where bit 0, 1, 2 of `index` is set.
  Vec3 corner(int index) const {
    return {(index & 1) != 0 ? max.x() : min.x(), (index & 2) != 0 ? max.y() : min.y(),
            (index & 4) != 0 ? max.z() : min.z()};
  }
};

/// A point as "(x y z)", for the user.
std::string describe(const Vec3& point);

constexpr int kCorners = 8;  ///< of a box

/// The pose at `position` [m] turned by roll, pitch and yaw [rad] about the fixed axes x, y and z
/// in this order (the URDF convention).
Pose makePose(const Vec3& position, const Vec3& rpy = Vec3::Zero());

/// Roll, pitch and yaw [rad] that makePose turns by, the pitch within a quarter turn. At a quarter
/// turn, where one of the other two is free, roll is 0.
Vec3 rollPitchYaw(const Pose& pose);

/// The matrix that takes a vector to its cross product with `v`: v x w = crossMatrix(v) w.
Eigen::Matrix3d crossMatrix(const Vec3& v);

/// The same angle in [-pi, pi] [rad].
inline double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

/// The pose in the x-y plane of its frame that is nearest to `pose`: without the height of its
/// origin, turned about z by what is nearest to its rotation (in the Frobenius norm), by nothing
/// where it stands on its head.
Pose projectedToPlane(const Pose& pose);

/// As near as an arm comes to where it shall be, or stay. Our choice: several times what its
/// calibration leaves, a fraction of what is held.
constexpr double kNearDistance = 0.01;  ///< [m]
constexpr double kNearAngle = 0.05;     ///< [rad]

/// Whether a pose lies in the plane z = 0 as nearly as an arm that moves in it does: to
/// kNearDistance and kNearAngle.
bool isNearPlane(const Pose& T_plane_object);

/// Angle of the rotation between two poses [rad], in [0, pi].
double angleBetween(const Pose& a, const Pose& b);

/// Distance of the origins [m].
double distanceBetween(const Pose& a, const Pose& b);

/// Both in one number, as the paper's C-space planner has it [m + rad].
double gapBetween(const Pose& a, const Pose& b);

/// The pose at `fraction` in [0, 1] of the way from a to b: the position moves on a straight line,
/// the rotation about one fixed axis, both at constant rate.
Pose interpolate(const Pose& a, const Pose& b, double fraction);

/// Points on the segments of `path` such that neighbours are at most `max_distance` [m] and
/// `max_angle` [rad] apart (both positive); every pose of `path` is kept. Empty in, empty out.
Path densify(const Path& path, double max_distance, double max_angle);

/// Sum over the segments of the distance of the origins [m].
double pathLength(const Path& path);

/// The same wrench with its torque taken about the origin of frame a and in its axes, from a wrench
/// at the origin and in the axes of frame b.
Wrench transformWrench(const Pose& T_a_b, const Wrench& wrench_b);

bool isFinite(const Wrench& wrench);
bool isFinite(const Pose& pose);

}  // namespace smore
