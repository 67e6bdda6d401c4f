// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/listener_status.h"

#include <cmath>
#include <sstream>

namespace smore {
namespace {

constexpr double kFarRate = 1.5;  // times the period that the parameters say, or its inverse

std::string inWords(const Vec3& vector) {
  const Eigen::IOFormat plain(Eigen::StreamPrecision, Eigen::DontAlignCols);
  std::ostringstream text;
  text << vector.transpose().format(plain);
  return text.str();
}

bool isFarFrom(double period, double told) {
  return period > kFarRate * told || told > kFarRate * period;
}

void addValues(const WrenchReport& now, Status* status) {
  status->add("age [s]", now.silence);
  if (now.period) status->add("rate [Hz]", 1.0 / *now.period);
  status->add("rate by the parameters [Hz]", 1.0 / now.told_period);
  if (now.jitter) status->add("jitter [s]", *now.jitter);
  status->add("oldest that waits for its pose [s]", now.waiting);
  status->add("received", now.received);
  status->add("dropped", now.dropped.total());
  status->add("dropped as not newer than the one before", now.dropped.repeated);
  status->add("dropped for a stamp that leaps", now.dropped.stray);
  status->add("dropped for their frame_id", now.dropped.frameless);
  status->add("dropped for want of a pose", now.dropped.poseless);
  status->add("dropped as not finite", now.dropped.not_finite);
}

void addValues(const SensorReport& now, Status* status) {
  status->add("tared", now.tared);
  status->add("bias of the force [N]", inWords(now.bias.force));
  status->add("bias of the torque [N m]", inWords(now.bias.torque));
  status->add("uncertainty of the force's bias [N]", now.bias_stddev);
  if (now.bias_age) status->add("age of the bias [s]", *now.bias_age);
  status->add("contact force [N]", now.contact_force);
  status->add("free force [N]", now.free_force);
  status->add("payload [kg]", now.payload_mass);
  status->add("saturated samples", now.saturated);
  status->add("contacts without a line", now.lineless);
  if (std::isfinite(now.range.force)) status->add("range of the force [N]", now.range.force);
  if (std::isfinite(now.range.torque)) status->add("range of the torque [N m]", now.range.torque);
}

}  // namespace

void WrenchStatus::compose(const WrenchReport& now, Status* status) {
  const std::uint64_t received = now.received - received_;
  const std::uint64_t dropped = now.dropped.total() - dropped_;
  received_ = now.received;
  dropped_ = now.dropped.total();
  if (now.received == 0) {
    status->summary(Status::STALE, "no wrench has come; is the sensor's driver running?");
  } else if (now.silence > now.silence_timeout) {
    status->summaryf(Status::STALE, "no wrench for %.1f s; is the sensor's driver running?",
                     now.silence);
  } else if (dropped > 0 && dropped >= received) {
    status->summary(Status::ERROR,
                    "wrenches come, and all are dropped; the values and the log "
                    "say why");
  } else if (dropped > 0) {
    status->summaryf(Status::WARN,
                     "%lu wrenches dropped in the last second; the values and the "
                     "log say why",
                     static_cast<unsigned long>(dropped));
  } else if (now.period && isFarFrom(*now.period, now.told_period)) {
    status->summaryf(Status::WARN, "wrenches come at %.0f Hz, noise/sample_period says %.0f Hz",
                     1.0 / *now.period, 1.0 / now.told_period);
  } else {
    status->summary(Status::OK, "wrenches come");
  }
  addValues(now, status);
}

SensorReport reportOf(const ContactSensing& sensing, const ContactDetectorParameters& detector,
                      double now) {
  SensorReport report;
  report.tared = sensing.tared();
  report.tare_problem = sensing.tareProblem();
  report.bias = sensing.bias();
  report.bias_stddev = sensing.biasStddev();
  if (const auto learnt = sensing.biasTime()) report.bias_age = now - *learnt;
  report.free_force = detector.free_force;
  report.contact_force = detector.contact_force;
  report.payload_mass = sensing.payload().mass;
  return report;
}

void SensorStatus::compose(const SensorReport& now, Status* status) {
  const std::uint64_t saturated = now.saturated - saturated_;
  const std::uint64_t lineless = now.lineless - lineless_;
  saturated_ = now.saturated;
  lineless_ = now.lineless;
  if (saturated > 0) {
    status->summaryf(Status::ERROR,
                     "%lu samples at the end of the sensor's range in the last "
                     "second: what they say is too little",
                     static_cast<unsigned long>(saturated));
  } else if (!now.tared && !now.tare_problem.empty()) {
    status->summary(Status::WARN, "not tared: " + now.tare_problem);
  } else if (!now.tared) {
    status->summary(Status::STALE, "not tared yet");
  } else if (now.bias_stddev > now.free_force) {
    status->summaryf(Status::WARN,
                     "the bias is known to %.2f N only, free space is below %.2f N: "
                     "let the object hang free, or tare",
                     now.bias_stddev, now.free_force);
  } else {
    status->summaryf(Status::OK, "tared, the bias known to %.2f N", now.bias_stddev);
  }
  if (lineless > 0) {
    status->mergeSummaryf(Status::WARN,
                          "%lu contacts ended in the last second without a line of "
                          "action; the log says why",
                          static_cast<unsigned long>(lineless));
  }
  addValues(now, status);
}

bool isSaturated(const Wrench& wrench, const WrenchRange& range) {
  return wrench.force.cwiseAbs().maxCoeff() >= range.force ||
         wrench.torque.cwiseAbs().maxCoeff() >= range.torque;
}

}  // namespace smore
