// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/touch_planner.h"

#include <cmath>

namespace smore {
namespace {

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
  Eigen::Vector4d drawn;
  for (int i = 3; i >= 0; --i) drawn[i] = normal(*random);  // not as arguments: their order is free
  return Eigen::Quaterniond(drawn[0], drawn[1], drawn[2], drawn[3]).normalized();
}

// Of a plane that passes the workspace obliquely many draws lie beside it.
constexpr int kMostDraws = 100000;

}  // namespace

RandomTouches::RandomTouches(const MotionSpace& space, std::uint64_t seed)
    : space_(space), random_(seed) {}

Result<Path> RandomTouches::nextTouch(const Pose& from) {
  for (int i = 0; i < kMostDraws; ++i) {
    const Pose goal = draw();
    if (space_.allowsTurn(from, goal) && space_.inWorkspace(goal)) return Path{from, goal};
  }
  return Failure{"no pose of the plane of motion was found in the workspace; make it wider"};
}

Pose RandomTouches::draw() {
  const Vec3 point = uniformIn(space_.workspace, &random_);
  if (space_.motion == Motion::kSpatial) {
    Pose goal = Pose::Identity();
    goal.linear() = uniformRotation(&random_).toRotationMatrix();
    goal.translation() = point;
    return goal;
  }
  Vec3 in_plane = space_.T_world_plane.inverse() * point;
  in_plane.z() = 0.0;
  std::uniform_real_distribution<double> turn(-M_PI, M_PI);
  return space_.T_world_plane * makePose(in_plane, Vec3(0.0, 0.0, turn(random_)));
}

}  // namespace smore
