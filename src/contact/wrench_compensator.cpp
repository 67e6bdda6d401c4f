// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/wrench_compensator.h"

#include <cmath>
#include <sstream>

namespace smore {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2], standard gravity

Wrench operator-(const Wrench& a, const Wrench& b) {
  return {a.force - b.force, a.torque - b.torque};
}

Wrench mean(const std::vector<Wrench>& wrenches) {
  Wrench sum;
  for (const Wrench& wrench : wrenches) {
    sum.force += wrench.force;
    sum.torque += wrench.torque;
  }
  const double count = static_cast<double>(wrenches.size());
  return {sum.force / count, sum.torque / count};
}

// Largest sample standard deviation of an axis of the force and of the torque.
std::pair<double, double> spread(const std::vector<Wrench>& wrenches, const Wrench& center) {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  for (const Wrench& wrench : wrenches) {
    force += (wrench.force - center.force).cwiseAbs2();
    torque += (wrench.torque - center.torque).cwiseAbs2();
  }
  const double freedom = static_cast<double>(wrenches.size()) - 1.0;
  return {std::sqrt(force.maxCoeff() / freedom), std::sqrt(torque.maxCoeff() / freedom)};
}

}  // namespace

WrenchCompensator::WrenchCompensator(const TareParameters& tare, const Payload& payload)
    : parameters_(tare), payload_(payload) {}

void WrenchCompensator::startTare() {
  bias_.reset();
  still_.clear();
}

std::optional<Wrench> WrenchCompensator::process(const WrenchSample& raw) {
  const Wrench unloaded = raw.wrench - weight(raw.T_world_object);
  if (bias_) return unloaded - *bias_;
  still_.push_back(unloaded);
  if (static_cast<int>(still_.size()) >= parameters_.samples) finishTare();
  return std::nullopt;
}

void WrenchCompensator::finishTare() {
  const Wrench center = mean(still_);
  const auto [force_stddev, torque_stddev] = spread(still_, center);
  tare_problem_.clear();
  if (force_stddev > parameters_.max_force_stddev ||
      torque_stddev > parameters_.max_torque_stddev) {
    std::ostringstream problem;
    problem << "the robot was not still during the tare: standard deviation " << force_stddev
            << " N and " << torque_stddev << " N m, allowed " << parameters_.max_force_stddev
            << " N and " << parameters_.max_torque_stddev
            << " N m; stop the robot, free the object, and tare again";
    tare_problem_ = problem.str();
  } else {
    bias_ = center;
  }
  still_.clear();
}

Wrench WrenchCompensator::weight(const Pose& T_world_object) const {
  const Vec3 gravity_world(0.0, 0.0, -kGravity);
  Wrench weight;
  weight.force = payload_.mass * (T_world_object.linear().transpose() * gravity_world);
  weight.torque = payload_.center_of_mass_object.cross(weight.force);
  return weight;
}

}  // namespace smore
