// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "smore/common/geometry.h"
#include "smore/contact/contact_sensing.h"
#include "smore/kinematics/wrist_sensor.h"
#include "smore/ros/status_publisher.h"

namespace smore {

/// Wrenches that could not be used, by the reason why.
struct DroppedWrenches {
  std::uint64_t repeated = 0;    ///< not newer than the one before
  std::uint64_t stray = 0;       ///< of a stamp seconds from those before and after
  std::uint64_t frameless = 0;   ///< of a frame that tf cannot know
  std::uint64_t poseless = 0;    ///< tf did not know the pose at their stamp in time
  std::uint64_t not_finite = 0;  ///< or of a time that did not rise

  std::uint64_t total() const { return repeated + stray + frameless + poseless + not_finite; }
};

/// What the listener knows of the stream of wrenches.
struct WrenchReport {
  std::uint64_t received = 0;            ///< since the beginning, usable or not
  double silence = 0.0;                  ///< since the last one came, or the beginning [s, wall]
  double silence_timeout = 2.0;          ///< for so long it is none [s, wall]
  std::optional<double> period, jitter;  ///< as SampleRate has them [s]
  double told_period = 0.002;            ///< what the parameters say [s]
  double waiting = 0.0;                  ///< how long the oldest has waited for its pose [s]
  DroppedWrenches dropped;               ///< since the beginning
};

/// Composes the listener's status `wrench`: rate, jitter, age, what was dropped. STALE where none
/// comes, ERROR where none of those that come can be used, WARN where some are dropped, or come
/// more than 1.5 times as often or as seldom as told.
class WrenchStatus {
 public:
  void compose(const WrenchReport& now, Status* status);

 private:
  std::uint64_t received_ = 0, dropped_ = 0;  ///< when it was last composed
};

/// What the listener knows of the sensor itself.
struct SensorReport {
  bool tared = false;
  std::string tare_problem;        ///< why the last tare was refused; empty: it was not
  Wrench bias;                     ///< at the origin and in the axes of the object frame
  double bias_stddev = 0.0;        ///< of its force, per axis [N]
  std::optional<double> bias_age;  ///< since it was last learnt from a sample [s]
  double free_force = 0.5;         ///< below: free space [N]
  double contact_force = 5.0;      ///< at or above: contact [N]
  double payload_mass = 0.0;       ///< taken off [kg]
  WrenchRange range;               ///< that it can measure
  std::uint64_t saturated = 0;     ///< samples at the end of it, since the beginning
  std::uint64_t lineless = 0;      ///< contacts that ended without a line, since the beginning
};

/// What there is to say of a sensor after the sample of time `now` [s], but its range and what is
/// counted.
SensorReport reportOf(const ContactSensing& sensing, const ContactDetectorParameters& detector,
                      double now);

/// Composes the listener's status `sensor`: bias, its uncertainty, saturation. STALE before the
/// first tare, WARN where one is refused or the bias is too little known to tell free space, ERROR
/// where samples since the last time were at the end of the sensor's range. Beside that, WARN where
/// contacts since the last time ended without a line of action.
class SensorStatus {
 public:
  void compose(const SensorReport& now, Status* status);

 private:
  std::uint64_t saturated_ = 0, lineless_ = 0;  ///< when it was last composed
};

/// Whether an axis of the wrench is at the end of the range, or beyond: then it may be anything.
bool isSaturated(const Wrench& wrench, const WrenchRange& range);

}  // namespace smore
