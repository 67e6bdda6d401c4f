// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "smore/common/parameters.h"
#include "smore/common/result.h"
#include "smore/contact/contact_detector.h"
#include "smore/contact/contact_observation.h"
#include "smore/contact/payload_identification.h"
#include "smore/contact/residual_watch.h"
#include "smore/contact/steady_mean.h"
#include "smore/contact/wrench_compensator.h"

namespace smore {

/// How the line of action of a contact is measured.
struct LineParameters {
  double settle = 0.03;       ///< from the confirmed contact to the start of the average [s]
  SampleWindow window{0.02};  ///< averaged, once the wrench stands still over it
  double patience = 0.5;      ///< after the settling a wrench is averaged that still swings [s]
  double min_force = 1.0;     ///< a mean force below gives no line [N]
  double added_direction_stddev = 0.0;  ///< artificial error of the direction, for studies [rad]
  double added_offset_stddev = 0.0;     ///< artificial error across the line, for studies [m]
};

struct ContactSensingParameters {
  SensorNoise noise;
  Payload payload;
  TareParameters tare;
  ContactDetectorParameters detector;
  LineParameters line;
};

/// Reads the parameters from a mapping with the keys `noise`, `payload`, `tare`, `detector` and
/// `line` (config/force_torque.yaml explains each). Errors are noted in `reader`.
ContactSensingParameters readContactSensingParameters(ParameterReader* reader);

/// From raw wrench samples to contact observations: tare and weight, detection, line of action.
///
/// The line is measured when robot and object have come to rest: `line.settle` after the contact
/// was confirmed at the earliest, over the first `line.window` in which the wrench stands still
/// (SteadyMean), so that neither inertia nor the impact is in it. A wrench that swings on is
/// averaged after `line.patience`, and half of its swing counts as its error. A line is given once
/// in each contact. A contact that ends earlier gives the line of what there was. Its uncertainty
/// follows from the noise of the averaged samples, from how well the bias is known, and from its
/// lever at the sensor.
///
/// Windows hold more samples where the sensor's noise asks for it (allowForNoise), and the bias
/// follows the sensor's drift in free space. Samples may come at any rate, unevenly, with gaps;
/// what is said of a mean's uncertainty counts the samples that were in it.
class ContactSensing {
 public:
  /// `seed` is used by the artificial line errors only.
  explicit ContactSensing(const ContactSensingParameters& parameters, std::uint64_t seed = 0);

  /// The observation of one sample; unsure while the tare lasts. A failure for values that are not
  /// finite or times that do not rise: the sample is left out and nothing else is lost.
  Result<ContactObservation> process(const WrenchSample& raw);

  /// The compensated wrench of the last processed sample (zero while the tare lasts).
  const Wrench& compensated() const { return compensated_; }

  void startTare();

  /// Forgets the bias: nothing is claimed from now on until a tare, since the sensor is about to be
  /// zeroed.
  void suspend();

  /// Why a tare now would take something that touches for nothing, or leave a robot that moves
  /// without its sense; empty where it would not. A contact of no more than a residual does not
  /// count, nor one that is felt because the driver has just zeroed the sensor: the raw force is
  /// then near zero.
  std::string tareObjection() const;

  /// The same of the tare that comes with a payload that was found just now: what weight and bias
  /// do not explain of the present force presses.
  std::string payloadObjection(const IdentifiedPayload& found) const;

  /// The same of the tare that comes with another grasp, whose weight is not known: only what is
  /// felt across gravity presses for sure.
  std::string graspObjection() const;

  /// The same of a zeroing at the sensor's driver, after which it is tared: a weight that was just
  /// gripped does not count, nor one that the last tare did not know and that has turned since.
  std::string zeroingObjection() const;

  /// What the last processed sample let go into the bias because the gripper keeps it after a
  /// touch; nothing where it did not.
  const std::optional<Wrench>& newResidual() const { return residual_; }

  /// Whether the last processed sample ended a contact that gave no line: its force had not come to
  /// rest by then, or was below `line.min_force`.
  bool endedWithoutLine() const { return ended_without_line_; }

  /// What the wrist carries from now on; a new tare begins.
  void setPayload(const Payload& payload);
  const Payload& payload() const { return compensator_.payload(); }

  /// Of the sensor, at the origin and in the axes of the object frame; zero while not tared.
  Wrench bias() const { return compensator_.bias(); }

  /// How well the force's bias is known, per axis [N]; 0 while not tared.
  double biasStddev() const { return compensator_.biasStddev(); }

  /// When the bias was last learnt from a sample [s]; nothing while not tared.
  std::optional<double> biasTime() const { return compensator_.biasTime(); }

  bool tared() const { return compensator_.tared(); }
  const std::string& tareProblem() const { return compensator_.tareProblem(); }

 private:
  struct LineAverage {
    double confirmed_at;
    SteadyMean wrench;
    bool given = false;     ///< the average is over
    bool has_line = false;  ///< and was no weaker than a line may be
  };

  ContactObservation observe(const WrenchSample& raw);
  void forgetBeforeSilence();
  void watchRest(const WrenchSample& raw);
  /// Why the robot may not be without its sense now; empty where it stands.
  std::string motionObjection() const;
  void takeResidual(const WrenchSample& raw, ContactState state);
  std::optional<LineOfAction> measureLine(const WrenchSample& raw, ContactState state);
  std::optional<LineOfAction> averagedLine(const Vec3& sensor_object);
  /// Error of the mean of so many samples' forces, per axis [N]: noise and bias.
  double meanForceStddev(int samples) const;
  void forgetContact();
  void addErrors(LineOfAction* line);

  ContactSensingParameters parameters_;
  WrenchCompensator compensator_;
  ContactDetector detector_;
  ResidualWatch residuals_;
  std::mt19937_64 random_;
  Wrench compensated_;
  Vec3 taken_off_ = Vec3::Zero();  ///< bias and weight in the last sample's force [N]
  std::optional<Wrench> residual_;
  bool ended_without_line_ = false;
  std::optional<LineAverage> average_;  ///< of the present contact
  int averaged_contact_ = 0;            ///< contact that average_ belongs to
  std::optional<double> last_time_;
  std::optional<Pose> rest_pose_;  ///< where the object is, or was when it last moved
  double at_rest_since_ = 0.0;     ///< [s]
};

}  // namespace smore
