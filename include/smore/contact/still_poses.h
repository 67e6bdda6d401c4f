// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "smore/contact/payload_identification.h"
#include "smore/contact/sample_window.h"

namespace smore {

struct StillPosesParameters {
  double settle = 0.25;          ///< at rest before an average begins [s]
  SampleWindow window{0.5, 20};  ///< averaged; a sensor of 50 Hz gives so many
  double moved = 1e-3;           ///< a change of the pose by more is motion [m + rad]
  double distinct = 0.1;   ///< gravity turned by less in the object's axes: the same pose [rad]
  double max_age = 120.0;  ///< an older average is dropped: the bias has drifted [s]
};

/// Averages the raw wrench wherever the robot stands still, for the identification of its payload.
/// Of averages that look alike to gravity the newest stays: any number of level poses counts once.
class StillPoses {
 public:
  explicit StillPoses(const StillPosesParameters& parameters = {});

  /// Takes the next sample, whose values are finite and whose times rise; true when it completed an
  /// average.
  bool add(const WrenchSample& sample);

  const std::vector<StillWrench>& poses() const { return poses_; }

  /// Begins anew where the robot stands: what came before on this stand does not count.
  void interrupt() { stand_.reset(); }

  void clear();

 private:
  void beginAverage(const WrenchSample& sample, double settle);
  void keep(const StillWrench& still);

  StillPosesParameters parameters_;
  std::vector<StillWrench> poses_;
  std::optional<Pose> stand_;  ///< where the robot stands
  double average_from_ = 0.0;  ///< [s]
  Wrench sum_;
  int count_ = 0;
};

}  // namespace smore
