// SPDX-License-Identifier: BSD-3-Clause
#include "motion_state_space.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace smore {
namespace {

namespace ob = ompl::base;

// Rounding of a tilted plane's coordinates; far below any tolerance of a robot [m].
constexpr double kRounding = 1e-9;

/// Uniform numbers that depend on the seed alone, on every platform.
class UniformSource {
 public:
  explicit UniformSource(std::uint64_t seed) : engine_(seed) {}

  double between(double min, double max) {
    constexpr double kScale = 1.0 / 9007199254740992.0;  // 2^-53: a double's precision
    return min + (max - min) * kScale * static_cast<double>(engine_() >> 11);
  }

 private:
  std::mt19937_64 engine_;
};

/// Uniform samples of the bounds and of all rotations. OMPL's samplers each draw their seed from a
/// generator that all threads of the process share, so that runs could not be repeated.
class SeededSampler : public ob::StateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint64_t seed)
      : StateSampler(space), source_(seed) {}

  void sampleUniform(ob::State* state) override {
    if (space_->getType() == ob::STATE_SPACE_SE2) {
      samplePlanar(state->as<ob::SE2StateSpace::StateType>());
    } else {
      sampleSpatial(state->as<ob::SE3StateSpace::StateType>());
    }
  }

  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    sampleUniform(state);
    const double away = space_->distance(near, state);
    if (away > distance) space_->interpolate(near, state, distance / away, state);
  }

  void sampleGaussian(ob::State* state, const ob::State* mean, double stddev) override {
    sampleUniformNear(state, mean, stddev);
  }

 private:
  void samplePlanar(ob::SE2StateSpace::StateType* state) {
    const auto& bounds = space_->as<ob::SE2StateSpace>()->getBounds();
    state->setX(source_.between(bounds.low[0], bounds.high[0]));
    state->setY(source_.between(bounds.low[1], bounds.high[1]));
    state->setYaw(source_.between(-M_PI, M_PI));
  }

  /// Uniform rotations after Shoemake, "Uniform random rotations" (Graphics Gems III, 1992).
  void sampleSpatial(ob::SE3StateSpace::StateType* state) {
    const auto& bounds = space_->as<ob::SE3StateSpace>()->getBounds();
    const double x = source_.between(bounds.low[0], bounds.high[0]);
    const double y = source_.between(bounds.low[1], bounds.high[1]);
    state->setXYZ(x, y, source_.between(bounds.low[2], bounds.high[2]));
    const double share = source_.between(0.0, 1.0);
    const double first = source_.between(0.0, 2.0 * M_PI);
    const double second = source_.between(0.0, 2.0 * M_PI);
    auto& rotation = state->rotation();
    rotation.x = std::sqrt(1.0 - share) * std::sin(first);
    rotation.y = std::sqrt(1.0 - share) * std::cos(first);
    rotation.z = std::sqrt(share) * std::sin(second);
    rotation.w = std::sqrt(share) * std::cos(second);
  }

  UniformSource source_;
};

/// Smallest rectangle, in plane coordinates, around the part of the workspace box in the plane.
Bounds planeBounds(const MotionSpace& space) {
  Bounds bounds{Vec3::Constant(std::numeric_limits<double>::infinity()),
                Vec3::Constant(-std::numeric_limits<double>::infinity())};
  const auto include = [&bounds](const Vec3& point) {
    bounds.min = bounds.min.cwiseMin(point);
    bounds.max = bounds.max.cwiseMax(point);
  };
  const Pose T_plane_world = space.T_world_plane.inverse();
  const auto corner = [&](int index) {
    return Vec3(T_plane_world * space.workspace.corner(index));
  };
  for (int a = 0; a < kCorners; ++a) {
    if (std::abs(corner(a).z()) <= kRounding) include(corner(a));
    for (int bit = 1; bit < 8; bit *= 2) {
      const Vec3 from = corner(a);
      const Vec3 to = corner(a | bit);
      // The plane cuts the edges whose ends lie on different sides.
      if (from.z() * to.z() < 0.0) include(from + from.z() / (from.z() - to.z()) * (to - from));
    }
  }
  return bounds;
}

ob::StateSpacePtr makePlanar(const MotionSpace& space) {
  auto planar = std::make_shared<ob::SE2StateSpace>();
  const Bounds rectangle = planeBounds(space);
  ob::RealVectorBounds bounds(2);
  for (int axis = 0; axis < 2; ++axis) {
    bounds.low[axis] = rectangle.min[axis];
    bounds.high[axis] = rectangle.max[axis];
  }
  planar->setBounds(bounds);
  planar->setSubspaceWeight(1, 1.0);  // OMPL's default for the angle is 0.5
  return planar;
}

ob::StateSpacePtr makeSpatial(const MotionSpace& space) {
  auto spatial = std::make_shared<ob::SE3StateSpace>();
  ob::RealVectorBounds bounds(3);
  for (int axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = space.workspace.min[axis];
    bounds.high[axis] = space.workspace.max[axis];
  }
  spatial->setBounds(bounds);
  spatial->setSubspaceWeight(1, 2.0);  // OMPL's distance of two rotations is half of their angle
  return spatial;
}

}  // namespace

MotionStateSpace::MotionStateSpace(const MotionSpace& space, std::uint64_t seed)
    : space_(space),
      ompl_(space.motion == Motion::kPlanar ? makePlanar(space) : makeSpatial(space)) {
  ompl_->setStateSamplerAllocator([seed](const ob::StateSpace* sampled) {
    return std::make_shared<SeededSampler>(sampled, seed);
  });
}

Pose MotionStateSpace::toPose(const ob::State* state) const {
  Pose pose = Pose::Identity();
  if (isPlanar()) {
    const auto* planar = state->as<ob::SE2StateSpace::StateType>();
    pose.translation() = Vec3(planar->getX(), planar->getY(), 0.0);
    pose.linear() = Eigen::AngleAxisd(planar->getYaw(), Vec3::UnitZ()).toRotationMatrix();
    return space_.T_world_plane * pose;
  }
  const auto* spatial = state->as<ob::SE3StateSpace::StateType>();
  const auto& rotation = spatial->rotation();
  pose.translation() = Vec3(spatial->getX(), spatial->getY(), spatial->getZ());
  pose.linear() =
      Eigen::Quaterniond(rotation.w, rotation.x, rotation.y, rotation.z).toRotationMatrix();
  return pose;
}

void MotionStateSpace::fromPose(const Pose& T_world_object, ob::State* state) const {
  if (isPlanar()) {
    const Pose pose = space_.T_world_plane.inverse() * T_world_object;
    auto* planar = state->as<ob::SE2StateSpace::StateType>();
    planar->setXY(pose.translation().x(), pose.translation().y());
    planar->setYaw(std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)));
    return;
  }
  auto* spatial = state->as<ob::SE3StateSpace::StateType>();
  const Eigen::Quaterniond turn(T_world_object.linear());
  spatial->setXYZ(T_world_object.translation().x(), T_world_object.translation().y(),
                  T_world_object.translation().z());
  spatial->rotation().x = turn.x();
  spatial->rotation().y = turn.y();
  spatial->rotation().z = turn.z();
  spatial->rotation().w = turn.w();
}

}  // namespace smore
