// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "smore/contact/contact_observation.h"
#include "smore/contact/sample_window.h"

namespace smore {

struct ResidualParameters {
  double max_force = 3.0;          ///< what a gripper may keep; more is something else [N]
  double steady_force = 0.7;       ///< two means that differ by less are the same [N]
  SampleWindow mean_window{0.4};   ///< of each of the two means; longer than a touch swings
  SampleWindow slow_window{0.02};  ///< of the detector: it says free so much too late
};

/// Tells what a gripper keeps after a touch (it slipped or bent, the sensor's hysteresis) from a
/// light touch that goes on.
///
/// What tells them apart is the place: where nothing touched before, nothing touches now. So a
/// force is a residual if it follows a confirmed contact, is small, stays the same over two means
/// in a row, and is felt at poses that had been found free before the touch. How near to a free
/// pose is near enough goes by how far the touch is: a tenth of that way, and a tenth of a
/// millimetre (and milliradian) at least, over which a stiff contact of 10 N/mm changes by 1 N. A
/// pose was free if all of a slow window after it was free too, so that the rise of a touch does
/// not count.
///
/// Assumed is that the environment stands still and that the object has not moved in the gripper by
/// more than that nearness. Where the object never comes back to a free pose nothing is told.
class ResidualWatch {
 public:
  explicit ResidualWatch(const ResidualParameters& parameters) : parameters_(parameters) {}

  /// Takes the compensated wrench `wrench` of a sample, how far a mean of such forces may be off on
  /// each axis [N], and what the detector says of it. The residual, once, where it is found.
  std::optional<Wrench> observe(double time, const Pose& T_world_object, const Wrench& wrench,
                                double mean_stddev, ContactState state);

  /// Forgets touches and free poses.
  void clear();

 private:
  struct FreePose {
    double time = 0.0;  ///< [s]
    Pose pose;
  };

  struct Mean {
    double since = 0.0;  ///< [s]
    Pose first_pose;
    Wrench sum;
    int count = 0;
  };

  void rememberFree(double time, const Pose& pose);
  bool complete(double time) const;
  static Wrench meanOf(const Mean& earlier, const Mean& later);
  bool isSmallAndSteady(const Mean& earlier, const Mean& later, double mean_stddev) const;
  bool wasFree(const Pose& pose) const;

  ResidualParameters parameters_;
  std::deque<FreePose> lately_free_;  ///< within a slow window, everything since has been free
  std::deque<Pose> free_poses_;
  std::optional<Pose> touched_;  ///< where the contact since the last free space was confirmed
  std::optional<Mean> earlier_, mean_;
};

}  // namespace smore
