// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/contact_sensing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "smore/contact/noise_allowance.h"

namespace smore {
namespace {

// Of each of the two means that have to agree [s]: a gripper has stopped swinging, and the robot
// waits for free space longer than both take.
constexpr double kResidualMean = 0.4;

// A pose changed by more within so long is motion [m + rad], [s]: so slow motions as of a first run
// are, and the noise of an arm's joints at rest is not.
constexpr double kMoved = 5e-4;
constexpr double kRest = 0.5;

// Why no tare begins under a load [N].
std::string pressing(double force, const std::string& remedy) {
  std::ostringstream reason;
  reason << "something presses with " << force
         << " N, and would be taken for nothing from now on: " << remedy;
  return reason.str();
}

// Two unit vectors that make a right-handed frame with `axis`.
std::pair<Vec3, Vec3> perpendiculars(const Vec3& axis) {
  const Vec3 first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

// What of a vector is square to gravity, or to a change of it [m/s^2]; all of it where that is so
// small that no weight of a few kilograms is felt by it.
Vec3 across(const Vec3& gravity, const Vec3& vector) {
  constexpr double kLeast = 0.5;
  if (gravity.norm() < kLeast) return vector;
  return vector - vector.dot(gravity) / gravity.squaredNorm() * gravity;
}

ResidualParameters residualParameters(const ContactSensingParameters& parameters) {
  ResidualParameters result;
  const ContactDetectorParameters& detector = parameters.detector;
  result.max_force = detector.residual_force;
  // Each mean errs as the slow one, by less than the free force.
  result.steady_force = M_SQRT2 * detector.free_force;
  result.mean_window.duration = std::max(kResidualMean, detector.slow_window.duration);
  result.mean_window.samples = detector.slow_window.samples;
  result.slow_window = detector.slow_window;
  return result;
}

// A force less what a weight of any direction may be of it.
Vec3 shortened(const Vec3& force, double weight) {
  const double norm = force.norm();
  return norm > weight ? Vec3(force * (1.0 - weight / norm)) : Vec3::Zero();
}

}  // namespace

ContactSensing::ContactSensing(const ContactSensingParameters& parameters, std::uint64_t seed)
    : parameters_(allowForNoise(parameters)),
      compensator_(parameters_.tare, parameters_.payload, parameters_.noise,
                   parameters_.detector.slow_window),
      detector_(parameters_.detector, parameters_.noise),
      residuals_(residualParameters(parameters_)),
      random_(seed) {}

Result<ContactObservation> ContactSensing::process(const WrenchSample& raw) {
  const bool sensor_is_finite = raw.sensor_object.allFinite() && raw.sensor_axes_object.allFinite();
  if (!std::isfinite(raw.time) || !isFinite(raw.wrench) || !isFinite(raw.T_world_object) ||
      !sensor_is_finite) {
    return Failure{
        "a wrench sample is not finite (time, wrench or pose); the sample is left out; check the "
        "sensor's driver and the robot's joint states"};
  }
  if (last_time_ && raw.time <= *last_time_) {
    return Failure{"a wrench sample at " + std::to_string(raw.time) +
                   " s is not newer than the last one at " + std::to_string(*last_time_) +
                   " s; the sample is left out; check the clock and who else publishes wrenches"};
  }
  if (last_time_ && raw.time - *last_time_ > ContactDetector::kLongestGap) forgetBeforeSilence();
  last_time_ = raw.time;
  watchRest(raw);
  compensated_ = compensator_.process(raw).value_or(Wrench{});
  taken_off_ = raw.wrench.force - compensated_.force;
  return observe(raw);
}

ContactObservation ContactSensing::observe(const WrenchSample& raw) {
  ContactObservation observation;
  observation.time = raw.time;
  observation.T_world_object = raw.T_world_object;
  residual_.reset();
  ended_without_line_ = false;
  observation.contact_id = detector_.contactCount();
  if (!compensator_.tared()) return observation;

  const double unknown = compensator_.unknownWeight(raw.T_world_object);
  observation.state = detector_.process(raw.time, shortened(compensated_.force, unknown),
                                        compensator_.biasStddev());
  observation.contact_id = detector_.contactCount();
  // What the weight hides may touch, and a line of both leads nowhere.
  const bool hidden = unknown >= parameters_.detector.free_force;
  if (hidden && observation.state == ContactState::kFree) observation.state = ContactState::kUnsure;
  observation.line = measureLine(raw, hidden ? ContactState::kUnsure : observation.state);
  compensator_.track(raw, !hidden && detector_.mayBeDrift());
  if (!hidden) takeResidual(raw, observation.state);
  return observation;
}

void ContactSensing::takeResidual(const WrenchSample& raw, ContactState state) {
  const double stddev = meanForceStddev(2 * parameters_.detector.slow_window.samples);
  residual_ = residuals_.observe(raw.time, raw.T_world_object, compensated_, stddev, state);
  if (!residual_) return;
  compensator_.addToBias(raw.time, *residual_, stddev);
  detector_.takeOff(residual_->force);
  average_.reset();  // what it holds of this contact is the residual
}

// The object may have been anywhere meanwhile.
void ContactSensing::forgetBeforeSilence() {
  compensator_.interruptTare();
  if (average_ && !average_->given) average_.reset();
}

void ContactSensing::watchRest(const WrenchSample& raw) {
  if (rest_pose_ && gapBetween(*rest_pose_, raw.T_world_object) <= kMoved) return;
  rest_pose_ = raw.T_world_object;
  at_rest_since_ = raw.time;
}

std::string ContactSensing::motionObjection() const {
  if (!last_time_ || *last_time_ - at_rest_since_ >= kRest) return "";
  return "the robot moves, and would feel nothing meanwhile; wait until it stands";
}

std::string ContactSensing::payloadObjection(const IdentifiedPayload& found) const {
  const Vec3 expected = found.sensor_bias.force +
                        found.payload.mass * gravityIn(rest_pose_.value_or(Pose::Identity()));
  const double force = (detector_.meanForce() + taken_off_ - expected).norm();
  if (force <= parameters_.detector.contact_force) return motionObjection();
  return pressing(force, "it is not the weight; free the object on all sides, and ask again");
}

std::string ContactSensing::graspObjection() const {
  const Vec3 down = gravityIn(rest_pose_.value_or(Pose::Identity()));
  const double press = across(down, detector_.meanForce()).norm();
  if (press <= parameters_.detector.contact_force) return motionObjection();
  return pressing(press,
                  "it is across gravity, and no weight; free the object on all sides, and "
                  "ask again");
}

std::string ContactSensing::tareObjection() const {
  const Vec3 mean = detector_.meanForce();
  const double harmless = parameters_.detector.residual_force;
  const bool zeroed = (mean + taken_off_).norm() <= harmless;
  if (!detector_.inContact() || mean.norm() <= harmless || zeroed) return motionObjection();
  return pressing(mean.norm(),
                  "move the object until nothing touches it; if another one is held "
                  "than before, have the payload forgotten; if only its load has "
                  "changed, zero the sensor at its driver first");
}

// A weight is felt along gravity, and that of which the tare was wrong, where the object has turned
// since, along what gravity has changed by.
std::string ContactSensing::zeroingObjection() const {
  if (tareObjection().empty()) return "";
  const Vec3 down = gravityIn(rest_pose_.value_or(Pose::Identity()));
  const Vec3 turned = across(down, compensator_.gravityAtTare());
  const double press = across(turned, across(down, detector_.meanForce())).norm();
  if (press <= parameters_.detector.residual_force) return motionObjection();
  return pressing(press,
                  "it is no weight; free the object on all sides, or where nothing touches "
                  "it zero the sensor at its driver by hand, and ask again");
}

void ContactSensing::startTare() {
  compensator_.startTare();
  forgetContact();
}

void ContactSensing::suspend() {
  compensator_.suspend();
  forgetContact();
}

void ContactSensing::setPayload(const Payload& payload) {
  compensator_.setPayload(payload);
  forgetContact();
}

void ContactSensing::forgetContact() {
  residuals_.clear();
  detector_.reset();
  average_.reset();
}

double ContactSensing::meanForceStddev(int samples) const {
  return std::hypot(parameters_.noise.force_stddev / std::sqrt(samples), compensator_.biasStddev());
}

std::optional<LineOfAction> ContactSensing::measureLine(const WrenchSample& raw,
                                                        ContactState state) {
  if (state != ContactState::kContact) {
    const bool lost = average_ && !average_->given && average_->wrench.count() > 0;
    auto line = lost ? averagedLine(raw.sensor_object) : std::nullopt;
    ended_without_line_ = average_ && !average_->has_line;
    average_.reset();
    return line;
  }
  const LineParameters& line = parameters_.line;
  if (!average_ || averaged_contact_ != detector_.contactCount()) {
    average_ = LineAverage{raw.time, SteadyMean(line.window, parameters_.noise)};
    averaged_contact_ = detector_.contactCount();
  }
  const double tolerance = 0.5 * parameters_.noise.sample_period;  // of stamps
  const double age = raw.time - average_->confirmed_at;
  if (average_->given || age < line.settle - tolerance) return std::nullopt;
  if (detector_.mayHaveEnded()) return std::nullopt;
  average_->wrench.add(raw.time, compensated_);
  if (!average_->wrench.full()) return std::nullopt;
  const bool late = age >= line.settle + line.patience - tolerance;
  return late || average_->wrench.steady() ? averagedLine(raw.sensor_object) : std::nullopt;
}

std::optional<LineOfAction> ContactSensing::averagedLine(const Vec3& sensor_object) {
  average_->given = true;
  const SteadyMean& average = average_->wrench;
  const Result<LineOfAction> line = lineOfAction(average.mean(), parameters_.line.min_force);
  if (!line) return std::nullopt;
  average_->has_line = true;
  LineOfAction result = *line;
  const SteadyMean::Swing swing = average.swing();
  const double force_stddev = std::hypot(meanForceStddev(average.count()), 0.5 * swing.force);
  const double torque_stddev =
      std::hypot(parameters_.noise.torque_stddev / std::sqrt(average.count()), 0.5 * swing.torque);
  // The force's error e turns the line about its point p nearest to the sensor, and moves this one
  // along itself by -p e / F; the torque's error shifts it across by e / F. Away from p the turn
  // shifts the line too: docs/sensing.md (S2), docs/sensing.md (S3).
  result.direction_stddev = force_stddev / result.force;
  const Vec3 lever = result.point - sensor_object;
  result.offset_stddev =
      std::hypot(torque_stddev / result.force, lever.norm() * result.direction_stddev);
  addErrors(&result);
  return result;
}

void ContactSensing::addErrors(LineOfAction* line) {
  const double turn = parameters_.line.added_direction_stddev;
  const double shift = parameters_.line.added_offset_stddev;
  if (turn <= 0.0 && shift <= 0.0) return;
  const auto [first, second] = perpendiculars(line->direction);
  std::normal_distribution<double> normal;
  std::array<double, 4> drawn{};
  for (double& number : drawn) number = normal(random_);  // not in a sum: its order is free
  line->point += shift * (drawn[0] * first + drawn[1] * second);
  line->direction = (line->direction + turn * (drawn[2] * first + drawn[3] * second)).normalized();
  line->direction_stddev = std::hypot(line->direction_stddev, turn);
  line->offset_stddev = std::hypot(line->offset_stddev, shift);
}

}  // namespace smore
