// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/wrench_compensator.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace smore {
namespace {

// How much more than the sensor's noise a sample standard deviation may be.
constexpr double kNoiseMargin = 1.5;

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

WrenchCompensator::WrenchCompensator(const TareParameters& tare, const Payload& payload,
                                     const SensorNoise& noise, const SampleWindow& track_delay)
    : parameters_(tare), payload_(payload), noise_(noise), track_delay_(track_delay) {}

void WrenchCompensator::setPayload(const Payload& payload) {
  payload_ = payload;
  startTare();
}

void WrenchCompensator::startTare() {
  suspend();
  suspended_ = false;
}

void WrenchCompensator::suspend() {
  bias_.reset();
  still_.clear();
  suspended_ = true;
}

std::optional<Wrench> WrenchCompensator::process(const WrenchSample& raw) {
  const Wrench unloaded = raw.wrench - weight(raw.T_world_object);
  if (bias_) return unloaded - bias_->bias();
  if (suspended_) return std::nullopt;
  if (still_.empty()) tare_since_ = raw.time;
  still_.push_back(unloaded);
  if (enoughForTare(raw.time)) finishTare(raw);
  return std::nullopt;
}

void WrenchCompensator::track(const WrenchSample& raw, bool free) {
  if (bias_) bias_->observe(raw.time, raw.wrench - weight(raw.T_world_object), free);
}

void WrenchCompensator::addToBias(double time, const Wrench& residual, double stddev) {
  if (!bias_) return;
  const Wrench bias{bias_->bias().force + residual.force, bias_->bias().torque + residual.torque};
  bias_.emplace(noise_, track_delay_, bias, stddev);
  tared_at_ = time;
}

double WrenchCompensator::unknownWeight(const Pose& T_world_object) const {
  if (!bias_) return 0.0;
  return payload_.unknown_mass * (gravityIn(T_world_object) - gravity_tared_).norm();
}

std::optional<double> WrenchCompensator::biasTime() const {
  if (!bias_) return std::nullopt;
  return std::max(tared_at_, bias_->learntAt());
}

// Over n samples in the time t, white noise leaves s^2 / n in the variance of a mean, and a walk of
// the bias q^2 t / 3 between the mean and the newest value: the sum is least where they are equal.
bool WrenchCompensator::enoughForTare(double now) const {
  const int count = static_cast<int>(still_.size());
  if (count < parameters_.samples) return false;
  if (count >= parameters_.noise_samples) return true;
  const double noise = noise_.force_stddev * noise_.force_stddev / count;
  return noise_.force_drift * noise_.force_drift * (now - tare_since_) / 3.0 >= noise;
}

void WrenchCompensator::finishTare(const WrenchSample& last) {
  const double lever = last.sensor_object.norm();
  const double torque_noise = std::hypot(noise_.torque_stddev, lever * noise_.force_stddev);
  const double max_force_stddev =
      std::max(parameters_.max_force_stddev, kNoiseMargin * noise_.force_stddev);
  const double max_torque_stddev =
      std::max(parameters_.max_torque_stddev, kNoiseMargin * torque_noise);
  const Wrench center = mean(still_);
  const auto [force_stddev, torque_stddev] = spread(still_, center);
  tare_problem_.clear();
  if (force_stddev > max_force_stddev || torque_stddev > max_torque_stddev) {
    std::ostringstream problem;
    problem << "the robot was not still during the tare: standard deviation " << force_stddev
            << " N and " << torque_stddev << " N m, allowed " << max_force_stddev << " N and "
            << max_torque_stddev << " N m; stop the robot, free the object, and tare again";
    tare_problem_ = problem.str();
  } else {
    const double duration = last.time - tare_since_;
    // The mean's noise, and the walk from the samples to the end.
    const double stddev =
        std::hypot(noise_.force_stddev / std::sqrt(static_cast<double>(still_.size())),
                   noise_.force_drift * std::sqrt(duration / 3.0));
    bias_.emplace(noise_, track_delay_, center, stddev);
    tared_at_ = last.time;
    gravity_tared_ = gravityIn(last.T_world_object);
  }
  still_.clear();
}

Wrench WrenchCompensator::weight(const Pose& T_world_object) const {
  Wrench weight;
  weight.force = payload_.mass * gravityIn(T_world_object);
  weight.torque = payload_.moment_object.cross(gravityIn(T_world_object));
  return weight;
}

}  // namespace smore
