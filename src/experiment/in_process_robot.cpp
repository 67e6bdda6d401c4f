// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/in_process_robot.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "smore/common/elapsed_time.h"
#include "smore/common/result.h"
#include "smore/common/retreat.h"

namespace smore {
namespace {

constexpr double kSettleDeadline = 2.0;  // simulated [s]; a contact settles in a tenth of it
constexpr double kTareDeadline = 60.0;   // simulated [s]
constexpr char kTooNoisy[] = "it takes longer to average so much noise; tell less wrench_noise";

MotionResult fault(const std::string& reason) {
  MotionResult result;
  result.end = MotionEnd::kFault;
  result.reason = reason;
  return result;
}

}  // namespace

ContactSensingParameters sensingParameters(const Scenario& scenario, const SimulatedRobot& robot) {
  ContactSensingParameters parameters;
  parameters.detector.contact_force = scenario.contact_force;
  parameters.detector.free_force = scenario.free_force;
  parameters.detector.release_force = 0.5 * scenario.contact_force;
  parameters.noise.force_stddev = scenario.wrench_noise.force_stddev;
  parameters.noise.torque_stddev = scenario.wrench_noise.torque_stddev;
  parameters.noise.force_drift = scenario.wrench_noise.force_drift;
  parameters.line.added_direction_stddev = scenario.line_noise.direction;
  parameters.line.added_offset_stddev = scenario.line_noise.offset;
  if (tiltsPayload(scenario)) parameters.payload = robot.payload();
  return parameters;
}

void requireNoFaultAtStart(const SimulatedRobot& robot) {
  const auto fault = robot.fault();
  if (!fault) return;
  throw InputError(fault->reason + " at the start; change the scenario or the arm's description");
}

InProcessRobot::InProcessRobot(SimulatedRobot* robot, const ContactSensingParameters& sensing,
                               std::uint64_t seed, ObservationCallback on_observation)
    : robot_(robot), sensing_(sensing, seed), on_observation_(std::move(on_observation)) {
  const double deadline = robot_->time() + kTareDeadline;
  while (!sensing_.tared()) {
    advance(false);
    if (robot_->time() > deadline) {
      const std::string& problem = sensing_.tareProblem();
      throw std::runtime_error("no tare within a minute: " +
                               (problem.empty() ? std::string(kTooNoisy) : problem));
    }
  }
  if (!waitUntilFree()) throw std::runtime_error("the sensor feels a force at the start pose");
  requireNoFaultAtStart(*robot_);
}

MotionResult InProcessRobot::follow(const Path& path) {
  MotionResult result;
  const int known_contacts = advance(true).contact_id;
  if (const auto failure = robot_->follow(path)) {
    result.end = MotionEnd::kUnreachable;
    result.reason = failure->reason;
    result.refused_at = robot_->refusedAt();
    return result;
  }
  while (robot_->moving()) {
    const Pose before = robot_->pose();
    const ContactObservation observation = advance(true);
    result.length += distanceBetween(before, robot_->pose());
    trail_.record(robot_->pose());
    if (observation.contact_id == known_contacts) continue;
    robot_->stop();
    settleInContact(observation);
    result.end = MotionEnd::kContact;
    return result;
  }
  if (const auto stopped = robot_->fault()) {
    result.end = MotionEnd::kFault;
    result.reason = stopped->reason;
  }
  return result;
}

MotionResult InProcessRobot::retreat(double distance) {
  const auto result = retreatInStretches({[&] { return trail_.wayBack(robot_->pose(), distance); },
                                          [this](const Path& back) { return goBack(back); },
                                          [this] { return waitUntilFree(); }});
  return result ? *result : fault(kStillInContact);
}

MotionResult InProcessRobot::goBack(const Path& back) {
  if (const auto failure = robot_->goBack(back)) return fault(failure->reason);
  while (robot_->moving()) {
    advance(true);
    trail_.unwind(robot_->pose());
  }
  if (const auto stopped = robot_->fault()) return fault(stopped->reason);
  return {};
}

MotionResult InProcessRobot::reset(const Pose& start) {
  if (!robot_->canBePlaced()) return retreat(std::numeric_limits<double>::infinity());
  robot_->place(start);
  trail_.clear();
  if (!waitUntilFree()) return fault("the sensor feels a force at the start pose");
  return {};
}

ContactObservation InProcessRobot::advance(bool report) {
  const auto begin = SteadyClock::now();
  const WrenchSample sample = robot_->advance();
  times_.simulation += secondsSince(begin);

  const auto sensed = SteadyClock::now();
  const Result<ContactObservation> observation = sensing_.process(sample);
  if (!observation) throw std::runtime_error(observation.reason());
  if (report) on_observation_(*observation);
  times_.sensing_and_mapping += secondsSince(sensed);
  return *observation;
}

void InProcessRobot::settleInContact(ContactObservation observation) {
  const double deadline = robot_->time() + kSettleDeadline;
  while (!observation.line && observation.state == ContactState::kContact &&
         robot_->time() < deadline) {
    observation = advance(true);
  }
}

bool InProcessRobot::waitUntilFree() {
  const double deadline = robot_->time() + kSettleDeadline;
  while (robot_->time() < deadline) {
    if (advance(true).state == ContactState::kFree) return true;
  }
  return false;
}

}  // namespace smore
